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

Requests may be made at any time; while the session is not open they wait. Every call in which something can happen
returns events (`events`), in the order in which it happened: what has ended, samples, and what becomes of the session.
The session calls no program and looks at no clock: `now` is a time in seconds that
never goes back.
"""

from __future__ import annotations

import math
from collections import deque
from itertools import islice
from typing import TYPE_CHECKING, Any

from unity_link.errors import (
    ConnectError,
    GatewayResetError,
    LinkLostError,
    Outcome,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.protocol.configuration import Feature
from unity_link.protocol.constants import ANSWER_PATIENCE, FEWEST_OF_A_FLOOD, LONGEST_SILENCE
from unity_link.protocol.crc import NO_SESSION
from unity_link.protocol.events import Interrupted, Opened, Taken, Unusable
from unity_link.protocol.exchange import Counters, Exchange
from unity_link.protocol.frames import LF, LONGEST_FRAME
from unity_link.protocol.group_table import GroupTable, HeldGroup
from unity_link.protocol.handshake import TAKEN, Handshake, SessionNumbers
from unity_link.protocol.requests import Fence, Request, SessionRequest, Source
from unity_link.protocol.window import Window

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from unity_link.protocol.compact import Packer, Unpacker
    from unity_link.protocol.events import Events
    from unity_link.protocol.host_codec import HostCodec
    from unity_link.protocol.messages import GroupFlag

_FIRST_TURN = 256
"""Bytes of a question of the handshake and its answer, at most; gateways of later versions say more of themselves."""
_MOST_WAITING = 64
"""Least number of requests that wait for a session before those given up are removed."""
_NO_RING = 2
"""IDs of the window while there is no session: as few as a ring can have."""
_UNKNOWN_PATIENCE = 0.25
"""Seconds that an answer to the handshake can be on its way where nothing is known of the line."""
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
    """

    def __init__(
        self, node: int | None, choose: Callable[[], int], *, resumes: bool = False, compact: bool = False
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
        self._wants_compact = compact
        self._packer: Packer | None = None
        self._unpacker: Unpacker | None = None
        """The two directions of the compact form, from the first session on that asked for it."""
        self.echoes = False
        """True if an adapter gives back what is sent."""
        self.output: list[bytes] = []
        """Bytes to be sent; `take_output` returns them."""
        self._waiting: deque[Source] = deque()
        self._most_waiting = _MOST_WAITING
        """Number of requests that wait for a session at which those given up are looked for."""
        self._codec: HostCodec | None = None
        self._groups: GroupTable | None = None
        self._handshake: Handshake | None = None
        self._give_up_at: float | None = None
        """Instant by which a gateway that was reset must have answered."""
        self._shortest_timeout = 0.0
        self._blocked = False
        self._takes_turns = False
        """True if a turn is waited for before each frame: `take_turn` gives it."""
        self._byte_time: float | None = None
        self._longest_try = math.inf
        self._exchange: Exchange | None = None
        self.window: Window[Any] = Window(_NO_RING)
        """The window over the IDs of the session; while there is no session, one in which nothing is in flight."""

    # State

    @property
    def is_open(self) -> bool:
        """Return whether requests are sent now."""
        return self._exchange is not None

    @property
    def is_full(self) -> bool:
        """Return whether what is asked for has to wait: for room, or for a session."""
        return bool(self._waiting)

    @property
    def is_behind(self) -> bool:
        """True if frames have arrived that were not looked at yet."""
        return LF in self._rest

    @property
    def codec(self) -> HostCodec:
        """The messages of the gateway; there are none before it has said for the first time what it is."""
        assert self._codec is not None
        return self._codec

    @property
    def groups(self) -> GroupTable:
        """The groups of the gateway; as `codec`."""
        assert self._groups is not None
        return self._groups

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called; None while there is nothing to wait for."""
        if self._takes_turns and self.wants_turn:
            # Then the time begins.
            return self._give_up_at
        if self._exchange is not None:
            return self._exchange.deadline
        return None if self._handshake is None else self._handshake.deadline

    # Turns, where nodes share a medium

    @property
    def wants_turn(self) -> bool:
        """Return whether a turn is waited for, to send something."""
        if not self._takes_turns:
            return False
        if self._exchange is not None:
            return self._exchange.wants_turn
        return self._handshake is not None and self._handshake.asks

    @property
    def is_owed_an_answer(self) -> bool:
        """Return whether an answer can be on its way."""
        if self._exchange is not None:
            return self.window.in_flight > 0 and not self.window.repetition.is_due()
        return self._handshake is not None and not self._handshake.asks

    def take_turn(self, now: float) -> Events:
        """Send one frame."""
        events: Events = []
        self._now = now
        if self._exchange is not None:
            self._exchange.take_turn(now, events)
        elif self._handshake is not None and self._handshake.asks:
            self.output.append(self._handshake.take_turn(now))
        # What came between two turns is no part of an answer.
        self._drop_rest()
        return events

    @property
    def longest_turn(self) -> float:
        """Seconds after which no answer can come any more to what was just sent."""
        if self._exchange is not None:
            return self.window.longest_answer
        if self._byte_time is None:
            return _UNKNOWN_PATIENCE
        return ANSWER_PATIENCE + self._byte_time * _FIRST_TURN

    def take_output(self) -> bytes:
        """Return the bytes to send, which are forgotten here."""
        out = self.output
        if self.window.allowance.loses and out and self._exchange is not None:
            self._exchange.end_output()
        data = b"".join(out if self._packer is None else map(self._packer.pack, out))
        out.clear()
        return data

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
    ) -> None:
        """Begin on a new connection.

        Args:
            now: the time.
            shortest_timeout: seconds that the medium may hold an answer back, and some more.
            takes_turns: whether other nodes share the medium, so that a turn is waited for before each frame.
            byte_time: seconds that a byte needs on the wire, None where that is not known.
            longest_try: seconds after which a question of the handshake is asked again, at most, where the medium needs
                less than others.
        """
        self._shortest_timeout = max(shortest_timeout, ANSWER_PATIENCE) if takes_turns else shortest_timeout
        self._takes_turns, self._byte_time, self._longest_try = takes_turns, byte_time, longest_try
        self._blocked = False
        self._drop_rest()
        self.output.clear()
        self._begin(now, again=self.epoch >= 0)

    def _begin(self, now: float, *, again: bool) -> None:
        wire_time = (self._byte_time or 0.0) * _FIRST_TURN if self._takes_turns else None
        before = self._codec.session if again and self._codec is not None else NO_SESSION
        self._handshake = Handshake(
            self._node,
            self._numbers,
            now,
            before=before,
            wire_time=wire_time,
            longest_try=self._longest_try,
            compact=self._wants_compact,
        )
        if not self._takes_turns:
            self.output.append(self._handshake.take_output())

    def disconnect(self, reason: str) -> Events:
        """End what the connection carried: it is closed, or about to be.

        Returns:
            The events of what has ended; what can be sent again in a new session waits for it.
        """
        events: Events = []
        self._handshake = None
        self._give_up_at = None
        if self._exchange is not None:
            self._end_exchange(LinkLostError(reason), events)
        return events

    def connection_error(self, reason: Exception | None) -> ConnectError:
        """Return what can be known of the end of a connection before the gateway has answered."""
        if self._handshake is None:
            return ConnectError("the connection ended when the gateway had just answered")
        return ConnectError(self._handshake.describe_end(reason))

    def close(self, error: LinkLostError) -> Events:
        """End for good: everything that waits ends."""
        events: Events = []
        self.closed = error
        self._resumes = False
        self._handshake = None
        if self._exchange is not None:
            self._end_exchange(error, events)
        while self._waiting:
            self._waiting.popleft().fail(error.about(Outcome.NOT_EXECUTED), events)
        return events

    def _end_exchange(self, error: LinkLostError, events: Events) -> None:
        """End a session, keeping what may be sent again for the next one."""
        assert self._exchange is not None
        window, refused = self.window, self._exchange.refused
        self._exchange, self.window = None, Window(_NO_RING)
        self.groups.interrupted()
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

    def _drop_of_session(self, error: LinkLostError, events: Events) -> None:
        for request in [source for source in self._waiting if isinstance(source, Request) and source.of_session]:
            self._waiting.remove(request)
            request.fail(error.about(Outcome.NOT_EXECUTED), events)

    # Requests

    def submit(self, source: Source, now: float) -> Events:
        """Send what `source` has as soon as there is room.

        Raises:
            LinkLostError: where there will be no session any more.
        """
        events: Events = []
        self._now = now
        if self._exchange is not None:
            self._exchange.submit(source, now, events)
        elif self.closed is not None:
            raise self.closed.about(Outcome.NOT_EXECUTED)
        else:
            if isinstance(source, Fence):
                source.follow(self._waiting)
            if len(self._waiting) >= self._most_waiting:
                self._drop_unwanted()
            self._waiting.append(source)
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
        exchange = self._exchange
        if exchange is None or self.output:
            return b""
        frame = exchange.submit_alone(request, now)
        return frame if self._packer is None else self._packer.pack(frame)

    # Groups

    def hold(
        self,
        flags: GroupFlag,
        divisor: int,
        addresses: Sequence[int],
        length: int,
        owner: Any,
        number: int | None = None,
    ) -> HeldGroup:
        """Take a free group, to be set up in this session and in each later one; `start` does it the first time.

        Args:
            flags: of the group.
            divisor: of the base publish frequency.
            addresses: what is sampled.
            length: characters of the body of a sample.
            owner: what its samples are told to be for.
            number: of the group, where it must be that one.

        Raises:
            UnsupportedError: where no group is free, or that one is not.
        """
        layout = self.codec.fields("GS", 0, int(flags), divisor, len(addresses), addresses)
        return self.groups.hold(layout[2:], length, owner, number)

    def start(self, group: HeldGroup, now: float) -> Events:
        """Set up a group that is held; while the session is not open, the next one does."""
        events: Events = []
        self._now = now
        if self._exchange is not None:
            self.groups.set_up(self.codec, group, events)
        return events

    def release(self, group: HeldGroup, now: float) -> tuple[Request | None, Events]:
        """Release a group, and stop it.

        Returns:
            The request that stops it, None where nothing is left to stop; and events.
        """
        if not self.groups.release(group) or self._exchange is None:
            return None, []
        request = Request(self.codec, "GX", group.text, 0, of_session=True)
        return request, self.submit(request, now)

    def _submit_step(self, step: SessionRequest, events: Events) -> None:
        if self._exchange is not None:
            self._exchange.submit(step, self._now, events)
        else:
            step.fail(LinkLostError(SILENT, Outcome.NOT_EXECUTED), events)

    # What arrives, and time

    def receive_alone(self, data: bytes, now: float) -> Request | None:
        """Take the answer to the oldest request, where that is all that has come and nothing waits for it.

        Returns:
            The request; None where something else has come, or more: then `receive` it.
        """
        exchange = self._exchange
        if self._unpacker is not None:
            data = self._unpacker.unpack_whole(data)
        return None if exchange is None or self._rest else exchange.receive_alone(data, now)

    def receive(self, data: bytes, now: float) -> Events:
        """Take bytes of the connection, cut anywhere; where much is to be done for them, a part of them.

        While `is_behind`, it is to be called again, with what has arrived meanwhile or nothing.
        """
        events: Events = []
        self._now = now
        if self._unpacker is not None:
            data = self._unpacker.unpack(data)
            self.window.signs.heard |= self._unpacker.begins_answer
        if self._rest:
            data = self._rest + data
            self._rest = b""
        while data:
            exchange = self._exchange
            if exchange is None:
                taken = self._receive_first(data, now, events)
            else:
                taken = exchange.receive(data, now, events)
                if exchange.has_ended:
                    self._session_is_over(exchange, now, events)
            data = data[taken:]
            if exchange is self._exchange:
                # What is left waits for its turn, or is the beginning of a frame. Noise without a line end is none, and
                # must not grow.
                endless = len(data) > LONGEST_FRAME and LF not in data
                self._rest = b"" if endless else data
                if endless:
                    self.counters.unasked += FEWEST_OF_A_FLOOD
                break
        if self._exchange is not None:
            self._exchange.go_on(now, events)
        return events

    def _receive_first(self, data: bytes, now: float, events: Events) -> int:
        """Hand bytes to the handshake, if there is one; return how many were taken."""
        if self._handshake is None:
            return len(data)
        try:
            taken = self._handshake.receive(data, now)
        except LinkLostError as error:
            self._handshake = None
            events.append(Taken(error))
            return len(data)
        except (ConnectError, UnsupportedError) as error:
            self._fail_handshake(error, events)
            return len(data)
        self._advance_handshake(now, events)
        return taken

    def pause_writing(self) -> None:
        """Send nothing again: the medium takes no bytes, so what was sent before is still held back."""
        self._blocked = True
        if self._exchange is not None:
            self._exchange.blocked = True

    def resume_writing(self, now: float) -> Events:
        """Send what has waited for a medium that takes bytes again."""
        events: Events = []
        self._now = now
        self._blocked = False
        if self._exchange is not None:
            self._exchange.blocked = False
            self._exchange.go_on(now, events)
        return events

    def expire(self, now: float) -> Events:
        """Let time pass, if `deadline` has come."""
        events: Events = []
        self._now = now
        exchange = self._exchange
        if self.wants_turn:
            # Not before it was sent can an answer to it be late.
            pass
        elif exchange is not None:
            exchange.expire(now, events)
            if self.window.signs.lost:
                events.append(Unusable(LinkLostError(SILENT)))
            elif exchange.flood:
                events.append(Unusable(LinkLostError(FLOODED.format(lines=exchange.flood))))
        elif self._handshake is not None:
            self._handshake.expire(now)
            self._advance_handshake(now, events)
        if self._give_up_at is not None and now >= self._give_up_at and self._handshake is not None:
            events.append(Unusable(LinkLostError(f"{RESET}, and has not answered since")))
        return events

    def _session_is_over(self, exchange: Exchange, now: float, events: Events) -> None:
        if exchange.refused is None and exchange.under_way != NO_SESSION:
            events.append(Taken(LinkLostError(TAKEN)))
            self._end_exchange(LinkLostError(TAKEN), events)
        else:
            self._gateway_was_reset(now, events)

    def _gateway_was_reset(self, now: float, events: Events) -> None:
        error = GatewayResetError(RESET)
        self._end_exchange(error, events)
        self._interrupted(error, events)
        self._give_up_at = now + LONGEST_SILENCE
        self._begin(now, again=False)

    def _interrupted(self, error: GatewayResetError, events: Events) -> None:
        """Report a reset, after which the gateway knows no group."""
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
        if self._codec is None or self._groups is None:
            self._codec, self._groups = codec, GroupTable(info.groups, self._submit_step)
        elif info != self._codec.info:
            message = f"another gateway answers after the reconnection: {info} instead of {self._codec.info}"
            self._fail_handshake(UnsupportedError(message), events)
            return
        self._codec.begin(handshake.session)
        self._use_form(compact=handshake.compact)
        credit = None if Feature.FLOW_CONTROL in info.features else info.receive_fifo_bytes
        self.window = Window(
            codec.ring,
            handshake.first,
            credit,
            handshake.byte_time,
            handshake.round_trip,
            self._shortest_timeout,
            1 if Feature.HALF_DUPLEX in info.features else None,
        )
        self.epoch += 1
        # A node that is not half-duplex has its line alone.
        self._takes_turns = self._takes_turns and Feature.HALF_DUPLEX in info.features
        self._exchange = Exchange(
            self._codec,
            self.window,
            self._waiting,
            self._groups,
            self.counters,
            self.output,
            blocked=self._blocked,
            takes_turns=self._takes_turns,
        )
        self.echoes = handshake.echoes > 0
        if self.echoes:
            self._exchange.expect_echo()
        events.append(Opened(info))
        self._exchange.admit(now, events)
        self._groups.start(self._codec, events)

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
            from unity_link.protocol.compact import CompactForm, Packer, Unpacker

            forms = [CompactForm.of(self.codec.info, from_gateway=side) for side in (False, True)]
            self._packer, self._unpacker = Packer(forms[0]), Unpacker(forms[1])

    def _fail_handshake(self, error: UnityLinkError, events: Events) -> None:
        self._handshake = None
        events.append(Unusable(error))
