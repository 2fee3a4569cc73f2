"""The host's end of the protocol, without I/O: requests and received bytes in, bytes to send and events out.

One `Session` object outlives connections and resets of the gateway. Its states:

    =========  =====================================  ==================================================
    state      begins with                            ends with
    =========  =====================================  ==================================================
    away       the end of a connection                `connect`
    opening    `connect`, or a reset of the gateway   the answer to `K i s`: `Opened`; or `disconnect`
    open       the answer to `K i s`                  a reset of the gateway: `Interrupted`; or `disconnect`
    =========  =====================================  ==================================================

1. Requests may be submitted in any state. Those without a session, or without room in the window, form one queue. A
   source with more requests goes to the end of the queue after its turn, so that a long batch does not delay others.
2. At the end of an open session each request in flight is executed, not executed or unknown. With `resumes`, requests
   that change nothing wait for the next session; all others end with an error that contains this outcome.
3. After `KEEP_ALIVE` without an answer, a proof precedes the next request: it shows that the gateway's session is this
   one, and not another program's with the same number (docs/protocol.md, "A number that comes again"). While groups are
   set up, the proof needs no request.
4. A single request in flight and its answer have faster methods, `submit_alone` and `receive_alone`. Other answers go
   to `ResponseReceiver`.
5. Every method that may cause events returns them. A session calls no program and reads no clock: `now` is a time in
   seconds that never goes back.
"""

from __future__ import annotations

import math
from collections import Counter, deque
from itertools import islice
from typing import TYPE_CHECKING

from unity_link.errors import (
    ConnectError,
    GatewayResetError,
    LinkLostError,
    Outcome,
    UnansweredError,
    UnsupportedError,
)
from unity_link.protocol.host.batches import RequestBlock
from unity_link.protocol.host.events import Interrupted, Opened, Taken, Unusable
from unity_link.protocol.host.group_table import GroupTable
from unity_link.protocol.host.handshake import TAKEN, Handshake, SessionNumbers
from unity_link.protocol.host.receiver import Counters, ResponseReceiver
from unity_link.protocol.host.requests import Confirmation, Fence, Request, SessionRequest, Source
from unity_link.protocol.window.constants import (
    ANSWER_PATIENCE,
    FEWEST_OF_A_FLOOD,
    FLOOD_PATIENCE,
    KEEP_ALIVE,
    LONGEST_SILENCE,
    MOST_KEPT_WORDS,
    MOST_TRIES,
)
from unity_link.protocol.window.window import Window
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import NO_SESSION
from unity_link.protocol.wire.frames import LF, LONGEST_FRAME
from unity_link.protocol.wire.path import LONGEST_MTU, RESERVE

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.group_table import HeldGroup
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.host.requests import Message
    from unity_link.protocol.wire.compact import Packer, Unpacker
    from unity_link.protocol.wire.path import Path

_FIRST_TURN = 256
"""Upper limit of the bytes of a request of the handshake and its answer; later versions may add fields to `Q`."""
_MOST_WAITING = 64
"""Queued requests without a session, from which on cancelled ones are removed."""
_NO_IDS = 2
"""IDs of the unused window while there is no session: the fewest possible."""
_UNKNOWN_PATIENCE = 0.25
"""Longest delay in seconds of an answer in the handshake, if the speed of the line is unknown."""
_MOST_ECHOES = 8192
"""Most sent lines that are stored to recognise their echoes."""
COMPACT_HINT = " (if the line changes bytes of compact frames, compact=0 in the URL keeps them text)"
SILENT = "the gateway does not answer any more: is it powered and connected, or does another program read its answers?"
RESET = "the gateway was reset"
FLOODED = (
    "only lines that are no answer arrive ({lines} since the last answer): is an echo on, as after `stty sane`, "
    "has the speed of the port changed, or does another program use it?"
)


class Session:
    """The host's end of one link.

    Args:
        node: number of the gateway on a shared medium, None for a medium with one gateway.
        choose: returns a random number from 0 on, from which session numbers and first IDs are made.
        resumes: send requests that change nothing again in the next session; if False, they end with their session.
        compact: use the compact form if the gateway has it.
        echo: True if an adapter is known to echo sent bytes; otherwise the handshake detects it.
    """

    _path: Path | None = None
    """Longest datagram of the network; None if frames are not in datagrams."""
    _mtu = LONGEST_MTU
    """Bytes of an IP packet that the networks of earlier connections carried, as far as their ends show."""
    on_retransmission: Callable[[int], object] | None = None
    """Called with the number of requests after requests are queued for retransmission, for a log."""
    _opened_at = 0.0
    """Instant at which the session began."""

    def __init__(
        self,
        node: int | None,
        choose: Callable[[], int],
        *,
        resumes: bool = False,
        compact: bool = False,
        echo: bool = False,
    ) -> None:
        self.counters = Counters()
        self.closed: LinkLostError | None = None
        """Reason for the end, after `close`; None before."""
        self.epoch = -1
        """Number of sessions opened so far, minus 1; -1 before the first."""
        self._node = node
        self._numbers = SessionNumbers(choose)
        self._resumes = resumes
        self._now = 0.0
        self._rest = b""
        self._wants_compact, self._knows_echo = compact, echo
        self._packer: Packer | None = None
        self._unpacker: Unpacker | None = None
        """Converters of the two directions, while the compact form is used."""
        self._echo: Counter[bytes] | None = None
        """Sent lines whose echoes may arrive; None if nothing echoes them."""
        self.output: list[bytes] = []
        """Frames to send; `take_output` returns them."""
        self._waiting: deque[Source] = deque()
        """Queue of sources that wait for a session, or for room in the window."""
        self._most_waiting = _MOST_WAITING
        """Length of the queue at which cancelled requests are removed, while there is no session."""
        self.codec: HostCodec
        """Message codec of the gateway; set when the first session opens."""
        self.groups: GroupTable
        """The groups of the gateway; set with `codec`."""
        self._handshake: Handshake | None = None
        self._give_up_at: float | None = None
        """Instant at which the link is lost if a gateway does not answer after its reset; None without a reset."""
        self._shortest_timeout = 0.0
        self._blocked = False
        """True while the medium accepts no bytes: retransmissions would only queue after the frames before them."""
        self._takes_turns = False
        """True on a shared line: each frame waits for `take_turn`, which begins the slot of this link."""
        self._may_send = self._may_begin = False
        """True if frames may be sent now: the session is open, and on a shared line the slot is this link's. The second
        is for new requests, which also wait for a pending proof."""
        self._proofs = 0
        """Number of exchanges of the pending proof, from 1; 0 without a pending proof."""
        self._is_half_duplex = self._queried_alone = False
        """True on a half-duplex line: one frame is sent at a time. The second: that frame is a session query."""
        self._byte_time: float | None = None
        self._longest_try = math.inf
        self._is_transparent = False
        """True if the line is known to carry the bytes of the compact form."""
        self._before_flood = 0.0, -1, 0, 0
        """Instant of the last answer; and the counts of answers, other lines and transmissions at that instant."""
        self._receiver: ResponseReceiver | None = None
        """Receiver of the open session; None in the other states."""
        self.window: Window[Message] = Window(_NO_IDS)
        """Window of the open session; in the other states an idle one."""

    # State

    @property
    def is_open(self) -> bool:
        """True if the session is open, so that requests can be sent."""
        return self._receiver is not None

    @property
    def is_full(self) -> bool:
        """True if requests are queued: for room in the window, or for a session."""
        return bool(self._waiting)

    @property
    def is_behind(self) -> bool:
        """True if received frames wait for the next call of `receive`."""
        return LF in self._rest

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called; None without a timer."""
        if self._takes_turns and self.wants_turn:
            # The timeout begins with the slot.
            return self._give_up_at
        if self._receiver is not None:
            deadline = self.window.deadline
            return self._keep_alive_due if deadline is None else deadline
        return None if self._handshake is None else self._handshake.deadline

    @property
    def _keep_alive_due(self) -> float | None:
        """Instant of the next proof without a request; None if a request is in flight, or no group is set up.

        Samples show neither that the gateway still receives frames nor that it was not reset.
        """
        if not self.window.is_idle() or not self.groups.begun:
            return None
        return self.window.since + KEEP_ALIVE

    @property
    def echoes(self) -> bool:
        """True if an adapter echoes the sent frames."""
        return self._echo is not None

    # Slots of a shared line

    @property
    def wants_turn(self) -> bool:
        """True if this link waits for a slot on the shared line to send a frame."""
        if not self._takes_turns:
            return False
        if self._receiver is None:
            return self._handshake is not None and self._handshake.asks
        while self._waiting and self._waiting[0].unwanted():
            self._waiting.popleft()
        if self.window.retransmission.is_due():
            return not self._blocked and not self._awaits_session
        return bool(self._waiting or self._proofs) and self.window.is_idle()

    @property
    def is_owed_an_answer(self) -> bool:
        """True if an answer may still arrive, so that no other link may send."""
        if self._receiver is not None:
            return self._awaits_session or (self.window.in_flight > 0 and not self.window.retransmission.is_due())
        return self._handshake is not None and not self._handshake.asks

    def take_turn(self, now: float) -> Events:
        """Send one frame, because the slot of this link has begun."""
        events: Events = []
        self._now = now
        if self._receiver is not None:
            self._may_send, self._may_begin = True, not self._proofs
            if not self.window.retransmission.is_due():
                self._admit(now, events)
            else:
                self.window.resume(now)
                self._repeat()
            self._may_send = self._may_begin = False
        elif self._handshake is not None and self._handshake.asks:
            self.output.append(self._handshake.take_turn(now))
        # Bytes that arrived between two slots are not part of an answer to this link.
        self._drop_rest()
        return events

    @property
    def _awaits_session(self) -> bool:
        """True if the answer to a session query that was sent alone may still arrive."""
        return self._queried_alone and bool(self.window.retransmission.queries)

    def _queries_alone(self) -> bool:
        """Send a session query alone if it is due on a half-duplex line; return whether one is pending.

        It is due before the second retransmission in a row.
        """
        if self._awaits_session:
            return True
        loss, retransmission = self.window.loss, self.window.retransmission
        is_due = not self._queried_alone and loss.gone_back > 1 and loss.place == retransmission.sent
        self._queried_alone = is_due
        if is_due:
            self._query_session()
        return is_due

    @property
    def longest_turn(self) -> float:
        """Seconds after which no answer to the frame just sent can arrive any more."""
        if self._receiver is not None:
            return self.window.longest_answer
        if self._byte_time is None:
            return _UNKNOWN_PATIENCE
        return ANSWER_PATIENCE + self._byte_time * _FIRST_TURN

    def take_output(self) -> bytes:
        """Return the bytes to send, and remove them from `output`."""
        out = self.output
        if out and self.window.send_limit.loses:
            # End the burst explicitly: the next frame may be a long time off.
            self.output.append(self.codec.burst_end)
        data = b"".join(out)
        out.clear()
        if self._echo is not None:
            self._expect_echoes(self._echo, data)
        return data if self._packer is None else self._packer.pack(data)

    def _expect_echoes(self, echo: Counter[bytes], data: bytes) -> None:
        """Store the lines that are sent now, to recognise their echoes."""
        if echo.total() > _MOST_ECHOES:
            # The echoes of these lines arrived damaged.
            echo.clear()
        echo.update(line for line in data.split(LF) if line)

    def describe_silence(self) -> str:
        """Return the received bytes of a gateway that did not complete the handshake, in words for an error."""
        return "the connection was not accepted" if self._handshake is None else self._handshake.describe()

    # Connections

    def connect(
        self,
        now: float,
        shortest_timeout: float,
        *,
        takes_turns: bool = False,
        byte_time: float | None = None,
        longest_try: float = math.inf,
        is_transparent: bool = False,
        path: Path | None = None,
    ) -> None:
        """Begin the handshake on a new connection.

        Args:
            now: the time.
            shortest_timeout: lower limit of the timeout in seconds, above the delay that the medium may add to answers.
            takes_turns: True if other nodes share the line, so that each frame waits for a slot.
            byte_time: seconds that a byte takes on the wire, None if unknown.
            longest_try: most seconds until a request of the handshake is sent again.
            is_transparent: True if the medium carries every byte unchanged, so that the compact form needs no test.
            path: longest datagram of the network; None if frames are not in datagrams.
        """
        self._shortest_timeout = max(shortest_timeout, ANSWER_PATIENCE) if takes_turns else shortest_timeout
        self._takes_turns, self._byte_time, self._longest_try = takes_turns, byte_time, longest_try
        self._blocked = False
        self._is_transparent = is_transparent
        self._path = path
        if path is not None:
            path.on_lowered = self._bound_answers
            path.lower(self._mtu)
        self._drop_rest()
        self.output.clear()
        self._begin(now, again=self.epoch >= 0)

    def _begin(self, now: float, *, again: bool) -> None:
        wire_time = (self._byte_time or 0.0) * _FIRST_TURN if self._takes_turns else None
        before = self.codec.session if again else NO_SESSION
        self._use_form(compact=False)
        self._handshake = Handshake(
            self._node,
            self._numbers,
            now,
            before=before,
            wire_time=wire_time,
            longest_try=self._longest_try,
            compact=self._wants_compact,
            echo=self._knows_echo,
            is_transparent=self._is_transparent,
            path=self._path,
        )
        if not self._takes_turns:
            self.output.append(self._handshake.take_output())

    def disconnect(self, reason: str) -> Events:
        """End the session or its handshake, because its connection ended; the next `connect` begins another.

        Args:
            reason: reason for the end, for the errors of requests.
        """
        events: Events = []
        self._end_session(LinkLostError(reason), events)
        return events

    def connection_error(self, reason: Exception | None) -> ConnectError:
        """Return an error for a connection that ended during the handshake."""
        if self._handshake is None:
            return ConnectError("the connection ended when the gateway had just answered")
        return ConnectError(self._handshake.describe_end(reason))

    def close(self, error: LinkLostError) -> Events:
        """End the session finally; all requests end with the error."""
        events: Events = []
        self.closed, self._resumes = error, False
        self._end_session(error, events)
        while self._waiting:
            self._waiting.popleft().fail(error.about(Outcome.NOT_EXECUTED), events)
        return events

    def _end_session(self, error: LinkLostError, events: Events) -> None:
        """End a session or its handshake; keep the requests that may be sent again in the next session."""
        self._handshake = self._give_up_at = None
        if self._receiver is None:
            return
        window, refused = self.window, self._receiver.refused
        self._receiver, self.window = None, Window(_NO_IDS)
        self._may_send = self._may_begin = False
        self.groups.interrupted()
        if self._proofs:
            self._proofs = 0
            self._fail_unproven(error, events)
        again: list[Source] = []
        for run, offset, size, outcome in window.unanswered(refused):
            source = run.again(offset, size) if self._resumes and not run.unwanted() else None
            if source is not None:
                again.append(source)
            else:
                run.fail_part(offset, size, error.about(outcome), events)
        self._waiting.extendleft(reversed(again))
        self._drop_of_session(error, events)
        for place, fence in enumerate(self._waiting):
            if isinstance(fence, Fence):
                # The requests that are sent again precede the fence in the queue.
                fence.follow(islice(self._waiting, place))

    def _fail_unproven(self, error: LinkLostError, events: Events) -> None:
        """End the requests that waited for a proof, because they were submitted for the session that is over.

        With `resumes`, requests that may be sent in the next session stay queued, as those in flight do.
        """
        held_back = list(self._waiting)
        self._waiting.clear()
        for source in held_back:
            if self._resumes and source.outlives_session:
                self._waiting.append(source)
            elif not source.unwanted():
                source.fail(error.about(Outcome.NOT_EXECUTED), events)

    def _drop_of_session(self, error: LinkLostError, events: Events) -> None:
        """End the queued requests that belong to the session that is over."""
        for source in [source for source in self._waiting if source.of_session]:
            self._waiting.remove(source)
            source.fail(error.about(Outcome.NOT_EXECUTED), events)

    # Requests

    def submit(self, source: Source, now: float) -> Events:
        """Send the requests of `source` as soon as there is room in the window.

        Raises:
            LinkLostError: after `close`.
        """
        events: Events = []
        waiting, window = self._waiting, self.window
        if (
            self._may_begin
            and not waiting
            and now < window.since + KEEP_ALIVE
            and isinstance(source, Request)
            and window.has_room(source.size, posted=source.posted, reply_size=source.reply_size)
            and not (source.places and self._overlaps(source))
        ):
            source.sent = True
            self.counters.requests += 1
            window.send(source, now)
            self.output.append(source.encode())
            if window.posted_writes.unfenced and window.needs_fence(now):
                self._fence(now)
            return events
        if self.closed is not None:
            raise self.closed.about(Outcome.NOT_EXECUTED)
        if isinstance(source, Fence):
            source.follow(waiting)
        if self._receiver is None and len(waiting) >= self._most_waiting:
            self._drop_unwanted()
        waiting.append(source)
        if self._receiver is None:
            return events
        if source is waiting[0] or waiting[0].unwanted() or self._fence(now):
            self._admit(now, events)
        # Otherwise the window is full; the request at the head is sent when an acknowledgement frees space.
        return events

    def _drop_unwanted(self) -> None:
        """Remove cancelled requests, so that calls with time limits do not fill the memory while a gateway is away."""
        wanted = [source for source in self._waiting if not source.unwanted()]
        self._waiting.clear()
        self._waiting.extend(wanted)
        self._most_waiting = max(_MOST_WAITING, 2 * len(wanted))

    def submit_alone(self, request: Request, now: float) -> bytes:
        """Assign an ID to a request with an answer if no other request is in flight or queued.

        Returns:
            The bytes to send at once; nothing if the request was not accepted and must be given to `submit`.
        """
        window = self.window
        if self._waiting or self.output or not self._may_begin or self._echo is not None or not window.is_idle():
            return b""
        if now >= window.since + KEEP_ALIVE:
            return b""
        request.sent = True
        self.counters.requests += 1
        window.send(request, now)
        frame = request.encode() + self.codec.burst_end if window.send_limit.loses else request.encode()
        return frame if self._packer is None else self._packer.pack(frame)

    def _number(self, run: Message, now: float) -> None:
        """Assign IDs to a run, and send it."""
        self.counters.requests += run.count
        self.window.send(run, now)
        self.output.append(run.encode())

    def _admit(self, now: float, events: Events) -> None:
        """Send requests of the queued sources, in turn, while there is room in the window."""
        waiting, window = self._waiting, self.window
        room = size = posted = 0
        self._prove(now)
        while waiting and self._may_begin:
            source = waiting[0]
            if source.unwanted() or (window.room_of_answers is not None and self._refuse_too_long(source, events)):
                waiting.popleft()
                continue
            if isinstance(source, Fence) and any(other in waiting for other in source.earlier):
                waiting.rotate(-1)
                continue
            if size != source.size or posted != source.posted or window.room_of_answers is not None:
                size, posted = source.size, source.posted
                room = window.room(size, posted=posted, reply_size=source.reply_size)
            # Wait until numpy is worth it, but not for a send limit to grow that is low after a loss.
            if not room or (room < source.least and room < window.most_room(size, source.reply_size) // 2):
                break
            if source.places and self._overlaps(source):
                break
            waiting.popleft()
            run = source.take(room, events)
            if not source.exhausted():
                waiting.append(source)
            self._number(run, now)
            room -= run.count
            if posted:
                self._fence(now)
                size = 0
        if self._fence(now):
            self._admit(now, events)

    def _refuse_too_long(self, source: Source, events: Events) -> bool:
        """End a block that was made for the path of an earlier session if this path does not carry it."""
        path, longest = self._path, max(source.size, source.reply_size)
        if path is None or longest <= path.longest_frame or not isinstance(source, Request | RequestBlock):
            return False
        source.fail(UnsupportedError(f"a block has frames of {longest} bytes, {path.bound}: ask for it again"), events)
        return True

    def _prove(self, now: float) -> None:
        """Send a proof, if one is due, that the gateway's session is this one and not another of the same number.

        The proof is three frames. `K` asks for the number. An ``h`` half the sequence space ahead of the next ID is out
        of sequence, so the gateway answers it by ``n`` with the next ID. The ``h`` with the next ID is a request like
        any other: if its answer arrives without an ``n`` before it, the ``n`` is lost, and the proof is repeated.
        """
        waiting, window = self._waiting, self.window
        is_due = self._proofs or (waiting and now >= window.since + KEEP_ALIVE)
        if not is_due or not self._may_send or not window.is_idle():
            return
        assert self._receiver is not None
        first = waiting[0] if waiting else None
        if type(first) is Confirmation:
            confirmation: Confirmation = first
            waiting.popleft()
        else:
            confirmation = Confirmation(self.codec, of_session=True)
        self._proofs += 1
        self._may_begin = False
        ahead = self.codec.confirmations(self._receiver.prove(window.next), 1)
        if not self._is_half_duplex:
            self._query_session()
            self.output.append(ahead)
        self._number(confirmation, now)
        if self._is_half_duplex:
            # Send only the ``h`` ahead now. Its ``n`` is a sign of loss, so the other ``h`` is retransmitted after it.
            self.output[-1] = ahead

    def _end_proof(self, events: Events) -> None:
        """Evaluate a proof after its last answer; if it is incomplete, the next exchange follows."""
        assert self._receiver is not None
        if self._receiver.end_proof():
            self._proofs = 0
            self._may_begin = self._may_send
        elif self._proofs > MOST_TRIES:
            self._leave_to_another(events)

    def _overlaps(self, source: Source) -> bool:
        """Return whether the gateway would overwrite stored words of an unanswered destructive read by this one."""
        first, window = self.window.next, self.window
        for other in window.parts(window.oldest, window.next):
            places = other.run.places
            if places and (
                (first - other.number) % MOST_KEPT_WORDS < places
                or (other.number - first) % MOST_KEPT_WORDS < source.places
            ):
                return True
        return False

    def _fence(self, now: float) -> bool:
        """Send an ``h`` if one is due for posted writes; return whether it was sent.

        The place that was reserved for it is then free for queued requests.
        """
        needed = self.window.needs_fence(now)
        if needed:
            self._number(Confirmation(self.codec), now)
        return needed

    def _go_on(self, now: float, events: Events) -> None:
        """Send frames after answers arrived: retransmissions, queries, proofs, and requests for which there is room."""
        if self.window.retransmission.is_due():
            self._repeat()
        if self.window.retransmission.must_query and not self._blocked and not self._is_half_duplex:
            self._query_session()
        if self._proofs and self.window.is_idle():
            self._end_proof(events)
        if self._waiting or self._proofs or self.window.posted_writes.unfenced:
            self._admit(now, events)

    def _query_session(self) -> None:
        """Send a session query; its answer also shows which earlier frames have arrived."""
        self.window.retransmission.query_sent()
        self.output.append(self.codec.framing.checked(b"K"))

    def _repeat(self) -> None:
        """Retransmit the planned requests; an ``h`` replaces cancelled ones."""
        if self._blocked or not self._may_send or (self._is_half_duplex and self._queries_alone()):
            return
        repeated, window = 0, self.window
        if window.loss.place == window.retransmission.sent and not self._is_half_duplex:
            # The window has just gone back: send the query before the retransmissions.
            self._query_session()
        for number, run, offset, count in window.repeat():
            frames = self.codec.confirmations(number, count) if run.unwanted() else run.frames_of(offset, count)
            self.output.append(frames)
            repeated += count
        if not repeated:
            return
        self.counters.repetitions += repeated
        if not window.send_limit.loses:
            self.output.append(self.codec.burst_end)
        if self.on_retransmission is not None:
            self.on_retransmission(repeated)

    # Groups

    def start(self, group: HeldGroup, now: float) -> Events:
        """Set up and start a held group; if the session is not open, the group starts when the next session opens."""
        events: Events = []
        self._now = now
        if self._receiver is not None:
            self.groups.set_up(self.codec, group, events)
        return events

    def _submit_step(self, step: SessionRequest, events: Events) -> None:
        if self._receiver is not None:
            events += self.submit(step, self._now)
        else:
            step.fail(LinkLostError(SILENT, Outcome.NOT_EXECUTED), events)

    # Received bytes, and time

    def receive_alone(self, data: bytes, now: float) -> Request | None:
        """Take the answer to the oldest request, if the bytes are exactly this answer and no request is queued.

        Returns:
            The request; None if the bytes were not accepted and must be given to `receive`.
        """
        if self._unpacker is not None:
            data = self._unpacker.unpack_whole(data)
        window = self.window
        if self._rest or self._waiting or window.posted_writes.unfenced or not window.has_no_loss():
            return None
        request = window.find(window.oldest)
        if type(request) is not Request or not request.take_frame(0, data, []):
            return None
        window.loss.heard = True
        self.counters.responses += 1
        window.acknowledge_in_order(1, now)
        return request

    def receive(self, data: bytes, now: float) -> Events:
        """Take bytes of the connection, cut anywhere.

        Expensive lines are processed in parts: while `is_behind`, call it again with newly received bytes, or none.
        """
        events: Events = []
        self._now = now
        if self._unpacker is not None:
            data = self._unpacker.unpack(data)
            self.window.loss.heard |= self._unpacker.begins_answer
        if self._rest:
            data = self._rest + data
            self._rest = b""
        while data:
            receiver = self._receiver
            if receiver is None:
                taken = self._receive_first(data, now, events)
            else:
                taken = receiver.receive(data, now, events)
                if receiver.has_ended:
                    self._session_is_over(receiver, now, events)
            data = data[taken:]
            if receiver is self._receiver:
                # The rest waits for the next call, or is an incomplete frame. Drop it if it is longer than any frame:
                # noise without a line end must not fill the memory.
                endless = len(data) > LONGEST_FRAME and LF not in data
                self._rest = b"" if endless else data
                if endless:
                    self.counters.unasked += FEWEST_OF_A_FLOOD
                break
        if self._receiver is not None:
            self._go_on(now, events)
        return events

    def _receive_first(self, data: bytes, now: float, events: Events) -> int:
        """Pass bytes to the handshake, if there is one; return how many were processed."""
        if self._handshake is None:
            return len(data)
        try:
            taken = self._handshake.receive(data, now)
        except (ConnectError, LinkLostError, UnsupportedError) as error:
            self._handshake = None
            events.append(Taken(error) if isinstance(error, LinkLostError) else Unusable(error))
            return len(data)
        self._advance_handshake(now, events)
        return taken

    def pause_writing(self) -> None:
        """Stop retransmissions, because the medium accepts no bytes and still holds earlier frames."""
        self._blocked = True

    def resume_writing(self, now: float) -> Events:
        """Send the frames that waited, because the medium accepts bytes again."""
        events: Events = []
        self._now = now
        self._blocked = False
        if self._receiver is not None:
            self._go_on(now, events)
        return events

    def expire(self, now: float) -> Events:
        """Handle timeouts, if `deadline` is reached."""
        events: Events = []
        self._now = now
        if self.wants_turn:
            # The frame waits for its slot, so no answer is late.
            pass
        elif self._receiver is not None:
            self._expire(now, events)
        elif self._handshake is not None:
            self._handshake.expire(now)
            self._advance_handshake(now, events)
        if self._give_up_at is not None and now >= self._give_up_at and self._handshake is not None:
            events.append(Unusable(LinkLostError(f"{RESET}, and has not answered since")))
        return events

    def _expire(self, now: float, events: Events) -> None:
        """Handle the timeouts of an open session: retransmissions, fences, proofs and floods."""
        window, counters = self.window, self.counters
        flood = self._find_flood(now)
        before = counters.repetitions
        run = window.expire(now)
        if run is not None:
            reason = f"every try was damaged on the way{self._hint}"
            run.give_up(window.oldest, UnansweredError, reason, events)
        if window.loss.lost:
            self._suspect_path(now)
            events.append(Unusable(LinkLostError(SILENT + self._hint)))
            return
        if window.retransmission.is_due():
            self._repeat()
            counters.timeouts += window.loss.timed_out and counters.repetitions > before
        if self._fence(now):
            self._admit(now, events)
        keep_alive_due = self._keep_alive_due
        if keep_alive_due is not None and now >= keep_alive_due:
            self._waiting.append(Confirmation(self.codec, of_session=True))
            self._admit(now, events)
        if flood:
            events.append(Unusable(LinkLostError(FLOODED.format(lines=flood) + self._hint)))

    @property
    def _hint(self) -> str:
        """Advice about the medium for the error of a lost link; empty for text frames that are not in datagrams."""
        if self._path is not None:
            return self._path.advice
        return "" if self._packer is None else COMPACT_HINT

    def _suspect_path(self, now: float) -> None:
        """Use a shorter datagram on the next connection if this session ends early with a long frame in flight.

        The opening of the session shows the length that the path to the gateway carries, but not that of the way back.
        """
        path, run = self._path, self.window.slots[self.window.oldest]
        is_new = now - self._opened_at < 2 * LONGEST_SILENCE
        if path is not None and run is not None and is_new and max(run.size, run.reply_size) > path.shortest_frame:
            path.shorten()
            self._mtu = path.mtu

    def _bound_answers(self) -> None:
        """Limit the bytes of answers in flight, if the path may lose the longest datagrams of a gateway."""
        if self._path is not None and self._path.is_short and self._receiver is not None:
            self.window.bound_answers(self._room_of_answers)

    def _room_of_answers(self) -> int:
        """Return the most bytes of answers in flight, which a gateway may send in one datagram with samples."""
        assert self._path is not None
        return self._path.longest_frame - RESERVE - self.groups.sample_bytes

    def _find_flood(self, now: float) -> int:
        """Return the number of lines since the last answer, if they are too many to be damaged answers; otherwise 0."""
        counters = self.counters
        sent = self.window.retransmission.sent
        if self.window.is_idle() or self._before_flood[1] != counters.responses:
            self._before_flood = now, counters.responses, counters.unasked, sent
            return 0
        since, _, unasked, sent_before = self._before_flood
        lines = counters.unasked - unasked
        is_flood = now - since >= FLOOD_PATIENCE and lines >= FEWEST_OF_A_FLOOD + 2 * (sent - sent_before)
        return lines if is_flood else 0

    def _session_is_over(self, receiver: ResponseReceiver, now: float, events: Events) -> None:
        if receiver.refused is None and receiver.current != NO_SESSION:
            self._leave_to_another(events)
        else:
            self._gateway_was_reset(now, events)

    def _leave_to_another(self, events: Events) -> None:
        """End the session, because the gateway's session is another program's."""
        events.append(Taken(LinkLostError(TAKEN)))
        self._end_session(LinkLostError(TAKEN), events)

    def _gateway_was_reset(self, now: float, events: Events) -> None:
        error = GatewayResetError(RESET)
        self._end_session(error, events)
        self._interrupted(error, events)
        self._give_up_at = now + LONGEST_SILENCE
        self._begin(now, again=False)

    def _interrupted(self, error: GatewayResetError, events: Events) -> None:
        """Report a reset of the gateway, which has lost its groups.

        A reset may also be found in the handshake of the next connection, so requests of the old session end here, too.
        """
        self._drop_of_session(error, events)
        events.append(Interrupted(error))

    # The handshake

    def _advance_handshake(self, now: float, events: Events) -> None:
        """Send the next request of the handshake, or open the session if the handshake is complete."""
        handshake = self._handshake
        assert handshake is not None
        if handshake.asks and not self._takes_turns:
            self.output.append(handshake.take_output())
        if handshake.found_reset:
            handshake.found_reset = False
            self._interrupted(GatewayResetError(RESET), events)
        if handshake.complete:
            self._handshake = None
            self._give_up_at = None
            self._open(handshake, now, events)

    def _open(self, handshake: Handshake, now: float, events: Events) -> None:
        """Open the session that the handshake has begun, with a new window."""
        codec = handshake.codec
        info = codec.info
        if self.epoch < 0:
            self.codec, self.groups = codec, GroupTable(info.groups, self._submit_step)
        elif info != self.codec.info:
            message = f"another gateway answers after the reconnection: {info} instead of {self.codec.info}"
            events.append(Unusable(UnsupportedError(message)))
            return
        self.codec.begin(handshake.session)
        self.groups.path = self._path
        self._use_form(compact=handshake.compact)
        self._is_transparent |= handshake.compact
        self._wants_compact &= not handshake.line_changes_bytes
        self._is_half_duplex = Feature.HALF_DUPLEX in info.features
        credit = None if Feature.FLOW_CONTROL in info.features else info.receive_fifo_bytes
        self.window = Window(
            codec.id_count,
            handshake.first,
            credit,
            handshake.byte_time,
            handshake.round_trip,
            self._shortest_timeout,
            1 if self._is_half_duplex else None,
        )
        self.window.since = self._opened_at = now
        self.epoch += 1
        # A gateway that is not half-duplex shares its line with no other, so this link needs no slots.
        self._takes_turns = self._takes_turns and self._is_half_duplex
        self._may_send = self._may_begin = not self._takes_turns
        self._queried_alone, self._before_flood = False, (0.0, -1, 0, 0)
        self._echo = Counter() if handshake.has_echo else None
        self._receiver = ResponseReceiver(
            self.codec, self.window, self.groups, self.counters, self._echo, half_duplex=self._is_half_duplex
        )
        self._bound_answers()
        events.append(Opened(info))
        self._admit(now, events)
        self.groups.start(self.codec, events)

    def _drop_rest(self) -> None:
        """Drop incomplete frames."""
        self._rest = b""
        if self._unpacker is not None:
            self._unpacker.reset()

    def _use_form(self, *, compact: bool) -> None:
        if compact == (self._packer is not None):
            return
        self._packer = self._unpacker = None
        if compact:
            from unity_link.protocol.wire.compact import CompactForm, Packer, Unpacker

            forms = [CompactForm.of(self.codec.info, from_gateway=side) for side in (False, True)]
            self._packer, self._unpacker = Packer(forms[0]), Unpacker(forms[1])
