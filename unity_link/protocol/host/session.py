"""The host's whole side of the protocol, without I/O.

What programs ask for, bytes and the time go in; bytes to send, events and a deadline come out. A `Session` goes on from
one connection to the next, and from one life of the gateway to the next. Each time it begins with the handshake, and of
everything that was under way at an end it says what is known of it:

    =========  =====================================  ==================================================
    state      begins with                            ends with
    =========  =====================================  ==================================================
    away       the end of a connection                `connect`
    opening    `connect`, or the news of a reset      the answer to `K`: `Opened`; or `disconnect`
    open       the answer to `K`                      the news of a reset: `Interrupted`; or `disconnect`
    =========  =====================================  ==================================================

Requests may be made at any time. What must wait, for a session or for room in its window, waits in one line; a source
with more to send goes to the end of the line after its turn, so that a batch of thousands does not hold up the others.
A request that is alone goes by a way of its own, the shortest, and so does an answer that comes alone. All else that
arrives is read by `ResponseReceiver`.

Every call in which something can happen returns its events. The session calls no program and looks at no clock: `now`
is a time in seconds that never goes back.
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
"""Bytes of a question of the handshake and its answer, at most; gateways of later versions say more of themselves."""
_MOST_WAITING = 64
"""Least number of requests that wait for a session before those given up are removed."""
_NO_RING = 2
"""IDs of the window while there is no session: as few as a ring can have."""
_UNKNOWN_PATIENCE = 0.25
"""Seconds that an answer to the handshake can be on its way where nothing is known of the line."""
_MOST_ECHOES = 8192
"""Lines that may come back, at most."""
COMPACT_HINT = " (if the line changes bytes of compact frames, compact=0 in the URL keeps them text)"
SILENT = "the gateway does not answer any more: is it powered and connected, or does another program read its answers?"
RESET = "the gateway was reset"
FLOODED = (
    "the line is full of what is no answer ({lines} lines since the last one): is an echo on, as behind `stty sane`, "
    "has the speed of the port changed, or does another program use it?"
)


class Session:
    """The host's side of one link.

    Args:
        node: number of the gateway on a medium that several share, None for a medium of its own.
        choose: returns any number from 0 on, by which the number of a session and its first ID are chosen.
        resumes: whether requests that change nothing are sent again in a new session; otherwise they end with the old.
        compact: whether frames are in the compact form where the gateway has it.
        echo: whether an adapter is known to give back what is sent; it is found out else.
    """

    _path: Path | None = None
    """The network of the connection; None if frames are not in datagrams."""
    _mtu = LONGEST_MTU
    """Bytes of an IP packet that the networks of earlier connections carried, as far as their ends show."""
    on_retransmission: Callable[[int], object] | None = None
    """Called after requests are queued for retransmission, with their number, for a log."""
    _opened_at = 0.0
    """Instant of the begin of the session."""

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
        """Why there will be no session any more."""
        self.epoch = -1
        """Number of the session, counted from 0; -1 before the first."""
        self._node = node
        self._numbers = SessionNumbers(choose)
        self._resumes = resumes
        self._now = 0.0
        self._rest = b""
        self._wants_compact, self._knows_echo = compact, echo
        self._packer: Packer | None = None
        self._unpacker: Unpacker | None = None
        """The two directions of the compact form, from the first session on that asked for it."""
        self._echo: Counter[bytes] | None = None
        """Lines that were sent, and may come back; None where none do."""
        self.output: list[bytes] = []
        """Bytes to be sent; `take_output` returns them."""
        self._waiting: deque[Source] = deque()
        self._most_waiting = _MOST_WAITING
        """Number of requests that wait for a session at which those given up are looked for."""
        self.codec: HostCodec
        """The messages of the gateway, once it has said for the first time what it is."""
        self.groups: GroupTable
        """The groups of the gateway; as `codec`."""
        self._handshake: Handshake | None = None
        self._give_up_at: float | None = None
        """Instant by which a gateway that was reset must have answered."""
        self._shortest_timeout = 0.0
        self._blocked = False
        """True if the medium takes no bytes: what was sent is still held back, so a repetition would be behind it."""
        self._takes_turns = False
        """True if a turn is waited for before each frame: `take_turn` gives it."""
        self._may_send = self._may_begin = False
        """True if frames, and new requests among them, may be sent now: the session is open and, where turns are taken,
        has its turn. New requests wait for a pending proof, too.
        """
        self._proofs = 0
        """Number of the pending proof that the session under way is this one, counted from 1; 0 without one."""
        self._is_half_duplex = self._asked_alone = False
        """True if both sides share a pair of wires: each frame waits for the answer to the one before, or for its time.
        And if `K` was the last frame there.
        """
        self._byte_time: float | None = None
        self._longest_try = math.inf
        self._is_transparent = False
        """True if the line is known to carry the compact form."""
        self._before_flood = 0.0, -1, 0, 0
        """Instant of the last answer, and the counts then: answers, lines that are none, and what was sent."""
        self._receiver: ResponseReceiver | None = None
        """Reader of what arrives while the session is open."""
        self.window: Window[Message] = Window(_NO_RING)
        """The window over the IDs of the session; while there is no session, one in which nothing is in flight."""

    # State

    @property
    def is_open(self) -> bool:
        """Return whether requests are sent now."""
        return self._receiver is not None

    @property
    def is_full(self) -> bool:
        """Return whether what is asked for has to wait: for room, or for a session."""
        return bool(self._waiting)

    @property
    def is_behind(self) -> bool:
        """True if frames have arrived that were not looked at yet."""
        return LF in self._rest

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called; None while there is nothing to wait for."""
        if self._takes_turns and self.wants_turn:
            # Then the time begins.
            return self._give_up_at
        if self._receiver is not None:
            deadline = self.window.deadline
            return self._keep_alive_due if deadline is None else deadline
        return None if self._handshake is None else self._handshake.deadline

    @property
    def _keep_alive_due(self) -> float | None:
        """Instant at which the gateway is to be asked whether it still hears its host; None while that does not matter.

        Samples say neither that it does nor that it was not reset since.
        """
        if not self.window.is_idle() or not self.groups.begun:
            return None
        return self.window.since + KEEP_ALIVE

    @property
    def echoes(self) -> bool:
        """True if an adapter gives back what is sent."""
        return self._echo is not None

    # Turns, where nodes share a medium

    @property
    def wants_turn(self) -> bool:
        """Return whether a turn is waited for, to send something."""
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
        """Return whether an answer can be on its way."""
        if self._receiver is not None:
            return self._awaits_session or (self.window.in_flight > 0 and not self.window.retransmission.is_due())
        return self._handshake is not None and not self._handshake.asks

    def take_turn(self, now: float) -> Events:
        """Send one frame."""
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
        # What came between two turns is no part of an answer.
        self._drop_rest()
        return events

    @property
    def _awaits_session(self) -> bool:
        """Return whether the answer to a `K` that was sent alone can be on its way."""
        return self._asked_alone and bool(self.window.retransmission.questions)

    def _asks_alone(self) -> bool:
        """Return whether the question whose the session is goes alone: before the second repetition in a row."""
        if self._awaits_session:
            return True
        signs, repetition = self.window.loss, self.window.retransmission
        asks = not self._asked_alone and signs.gone_back > 1 and signs.place == repetition.sent
        self._asked_alone = asks
        if asks:
            self._ask_whose()
        return asks

    @property
    def longest_turn(self) -> float:
        """Seconds after which no answer can come any more to what was just sent."""
        if self._receiver is not None:
            return self.window.longest_answer
        if self._byte_time is None:
            return _UNKNOWN_PATIENCE
        return ANSWER_PATIENCE + self._byte_time * _FIRST_TURN

    def take_output(self) -> bytes:
        """Return the bytes to send, which are forgotten here."""
        out = self.output
        if out and self.window.send_limit.loses:
            # Nothing may follow it for long.
            self.output.append(self.codec.burst_end)
        data = b"".join(out)
        out.clear()
        if self._echo is not None:
            self._expect_echoes(self._echo, data)
        return data if self._packer is None else self._packer.pack(data)

    def _expect_echoes(self, echo: Counter[bytes], data: bytes) -> None:
        """Record the lines of what is sent now, for they may come back."""
        if echo.total() > _MOST_ECHOES:
            # They were damaged on the way.
            echo.clear()
        echo.update(line for line in data.split(LF) if line)

    def describe_silence(self) -> str:
        """Return what was heard of a gateway that has not answered, for an error."""
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
        """Begin on a new connection.

        Args:
            now: the time.
            shortest_timeout: seconds that the medium may hold an answer back, and some more.
            takes_turns: whether other nodes share the medium, so that a turn is waited for before each frame.
            byte_time: seconds that a byte needs on the wire, None where that is not known.
            longest_try: seconds after which a question of the handshake is asked again, at most, where the medium needs
                less than others.
            is_transparent: whether the medium is known to carry every byte as it is, so that the compact form needs no
                trial.
            path: has the length of the longest datagram; None if frames are not in datagrams.
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
        """End what the connection carried: it is closed, or about to be.

        Returns:
            The events of what has ended; what can be sent again in a new session waits for it.
        """
        events: Events = []
        self._end_session(LinkLostError(reason), events)
        return events

    def connection_error(self, reason: Exception | None) -> ConnectError:
        """Return what can be known of the end of a connection before the gateway has answered."""
        if self._handshake is None:
            return ConnectError("the connection ended when the gateway had just answered")
        return ConnectError(self._handshake.describe_end(reason))

    def close(self, error: LinkLostError) -> Events:
        """End for good: everything that waits ends."""
        events: Events = []
        self.closed, self._resumes = error, False
        self._end_session(error, events)
        while self._waiting:
            self._waiting.popleft().fail(error.about(Outcome.NOT_EXECUTED), events)
        return events

    def _end_session(self, error: LinkLostError, events: Events) -> None:
        """End a session or its handshake, keeping what may be sent again for the next one."""
        self._handshake = self._give_up_at = None
        if self._receiver is None:
            return
        window, refused = self.window, self._receiver.refused
        self._receiver, self.window = None, Window(_NO_RING)
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
                # What is sent again stands before it now.
                fence.follow(islice(self._waiting, place))

    def _fail_unproven(self, error: LinkLostError, events: Events) -> None:
        """End the requests that a proof has held back: their callers meant the session that is over.

        If this session resumes, requests that may be sent in the next session wait for it, as those in flight do.
        """
        held_back = list(self._waiting)
        self._waiting.clear()
        for source in held_back:
            if self._resumes and source.outlives_session:
                self._waiting.append(source)
            elif not source.unwanted():
                source.fail(error.about(Outcome.NOT_EXECUTED), events)

    def _drop_of_session(self, error: LinkLostError, events: Events) -> None:
        for source in [source for source in self._waiting if source.of_session]:
            self._waiting.remove(source)
            source.fail(error.about(Outcome.NOT_EXECUTED), events)

    # Requests

    def submit(self, source: Source, now: float) -> Events:
        """Send what `source` has as soon as there is room.

        Raises:
            LinkLostError: where there will be no session any more.
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
        # Else what is first has no room: it would have been sent by what made some.
        return events

    def _drop_unwanted(self) -> None:
        """Forget what was given up: where a gateway is away for days, time limits of calls do not fill the memory."""
        wanted = [source for source in self._waiting if not source.unwanted()]
        self._waiting.clear()
        self._waiting.extend(wanted)
        self._most_waiting = max(_MOST_WAITING, 2 * len(wanted))

    def submit_alone(self, request: Request, now: float) -> bytes:
        """Return the frame of a request that has an answer, where nothing else is under way.

        Returns:
            The frame, to be sent at once; nothing where other things are under way: then `submit` it.
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
        """Let sources into the window, in turn, as far as there is room."""
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
            # A window that is small because the line loses is not waited for to grow.
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
        """Ask whether the session under way is this one and not another program's of the same number, if that is due.

        `K` asks for the number. An ``h`` far ahead of the next ID asks for that ID: the gateway answers it by `n`. The
        ``h`` with the next ID is a request like any other: `n` has come before its answer, or was lost.
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
            self._ask_whose()
            self.output.append(ahead)
        self._number(confirmation, now)
        if self._is_half_duplex:
            # One frame at a time: `n` is a sign of loss, after which the ``h`` with the next ID is sent.
            self.output[-1] = ahead

    def _end_proof(self, events: Events) -> None:
        """Take the result of a proof; without one, the next proof follows."""
        assert self._receiver is not None
        if self._receiver.end_proof():
            self._proofs = 0
            self._may_begin = self._may_send
        elif self._proofs > MOST_TRIES:
            self._leave_to_another(events)

    def _overlaps(self, source: Source) -> bool:
        """Return whether the words of a destructive read would take the place of some that are not answered."""
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
        """Confirm posted writes by an ``h`` where it is time; return whether it was.

        Then the place that was kept for it may be room for what waits.
        """
        needed = self.window.needs_fence(now)
        if needed:
            self._number(Confirmation(self.codec), now)
        return needed

    def _go_on(self, now: float, events: Events) -> None:
        """Send what answers have made room for, or shown to be lost."""
        if self.window.retransmission.is_due():
            self._repeat()
        if self.window.retransmission.must_ask and not self._blocked and not self._is_half_duplex:
            self._ask_whose()
        if self._proofs and self.window.is_idle():
            self._end_proof(events)
        if self._waiting or self._proofs or self.window.posted_writes.unfenced:
            self._admit(now, events)

    def _ask_whose(self) -> None:
        """Ask which session is under way: the answer says how far the line has come, too."""
        self.window.retransmission.ask()
        self.output.append(self.codec.framing.checked(b"K"))

    def _repeat(self) -> None:
        """Send unanswered requests again; an ``h`` in place of those that are not wanted any more."""
        if self._blocked or not self._may_send or (self._is_half_duplex and self._asks_alone()):
            return
        repeated, window = 0, self.window
        if window.loss.place == window.retransmission.sent and not self._is_half_duplex:
            # Ahead of all.
            self._ask_whose()
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
        """Set up a group that is held; while the session is not open, the next one does."""
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

    # What arrives, and time

    def receive_alone(self, data: bytes, now: float) -> Request | None:
        """Take the answer to the oldest request, where that is all that has come and nothing waits for it.

        Returns:
            The request; None where something else has come, or more: then `receive` it.
        """
        if self._unpacker is not None:
            data = self._unpacker.unpack_whole(data)
        window = self.window
        if self._rest or self._waiting or window.posted_writes.unfenced or not window.is_quiet():
            return None
        request = window.find(window.oldest)
        if type(request) is not Request or not request.take_frame(0, data, []):
            return None
        window.loss.heard = True
        self.counters.responses += 1
        window.answered_quietly(1, now)
        return request

    def receive(self, data: bytes, now: float) -> Events:
        """Take bytes of the connection, cut anywhere; where much is to be done for them, a part of them.

        While `is_behind`, it is to be called again, with what has arrived meanwhile or nothing.
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
                # What is left waits for its turn, or is the beginning of a frame. Noise without a line end is none, and
                # must not grow.
                endless = len(data) > LONGEST_FRAME and LF not in data
                self._rest = b"" if endless else data
                if endless:
                    self.counters.unasked += FEWEST_OF_A_FLOOD
                break
        if self._receiver is not None:
            self._go_on(now, events)
        return events

    def _receive_first(self, data: bytes, now: float, events: Events) -> int:
        """Hand bytes to the handshake, if there is one; return how many were taken."""
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
        """Send nothing again: the medium takes no bytes, so what was sent before is still held back."""
        self._blocked = True

    def resume_writing(self, now: float) -> Events:
        """Send what has waited for a medium that takes bytes again."""
        events: Events = []
        self._now = now
        self._blocked = False
        if self._receiver is not None:
            self._go_on(now, events)
        return events

    def expire(self, now: float) -> Events:
        """Let time pass, if `deadline` has come."""
        events: Events = []
        self._now = now
        if self.wants_turn:
            # Not before it was sent can an answer to it be late.
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
        """Send again what was not answered in time, and confirm what was posted."""
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
        """Another possible cause of an end, for its message; empty if frames are text and not in datagrams."""
        if self._path is not None:
            return self._path.advice
        return "" if self._packer is None else COMPACT_HINT

    def _suspect_path(self, now: float) -> None:
        """Take a shorter length for the next connection if the session ends soon and a long frame was under way.

        The opening of the session shows that the path to the gateway carries the length, but not the path back.
        """
        path, run = self._path, self.window.slots[self.window.oldest]
        is_new = now - self._opened_at < 2 * LONGEST_SILENCE
        if path is not None and run is not None and is_new and max(run.size, run.reply_size) > path.shortest_frame:
            path.shorten()
            self._mtu = path.mtu

    def _bound_answers(self) -> None:
        """Bound the answers under way where the path does not carry each datagram of a gateway."""
        if self._path is not None and self._path.is_short and self._receiver is not None:
            self.window.bound_answers(self._room_of_answers)

    def _room_of_answers(self) -> int:
        """Return how many bytes of answers may be under way: a gateway puts them into one datagram, with samples."""
        assert self._path is not None
        return self._path.longest_frame - RESERVE - self.groups.sample_bytes

    def _find_flood(self, now: float) -> int:
        """Return how many lines have come in place of answers, where what is sent cannot be the cause of so many."""
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
        if receiver.refused is None and receiver.under_way != NO_SESSION:
            self._leave_to_another(events)
        else:
            self._gateway_was_reset(now, events)

    def _leave_to_another(self, events: Events) -> None:
        """End the session: the one under way is another program's."""
        events.append(Taken(LinkLostError(TAKEN)))
        self._end_session(LinkLostError(TAKEN), events)

    def _gateway_was_reset(self, now: float, events: Events) -> None:
        error = GatewayResetError(RESET)
        self._end_session(error, events)
        self._interrupted(error, events)
        self._give_up_at = now + LONGEST_SILENCE
        self._begin(now, again=False)

    def _interrupted(self, error: GatewayResetError, events: Events) -> None:
        """Report a reset, after which the gateway knows no group.

        It may be found when the connection is opened again: requests that belong to the former session end here, too.
        """
        self._drop_of_session(error, events)
        events.append(Interrupted(error))

    # The handshake

    def _advance_handshake(self, now: float, events: Events) -> None:
        """Send what the handshake has to ask, and open the session when it is complete."""
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
        # A node that is not half-duplex has its line alone.
        self._takes_turns = self._takes_turns and self._is_half_duplex
        self._may_send = self._may_begin = not self._takes_turns
        self._asked_alone, self._before_flood = False, (0.0, -1, 0, 0)
        self._echo = Counter() if handshake.has_echo else None
        self._receiver = ResponseReceiver(
            self.codec, self.window, self.groups, self.counters, self._echo, half_duplex=self._is_half_duplex
        )
        self._bound_answers()
        events.append(Opened(info))
        self._admit(now, events)
        self.groups.start(self.codec, events)

    def _drop_rest(self) -> None:
        """Forget the beginning of a frame."""
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
