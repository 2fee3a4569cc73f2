"""The connection of one client, and the order of its requests and of their answers.

Answers leave in the order of the requests, also where those of the gateway
arrive in another.

Nothing grows. A client whose requests and their answers would take more than `MOST_UNDER_WAY` bytes, or that does not
read, is not listened to until that has changed; samples that it does not read are lost to it. A frame that never
reaches the gateway counts as `COST_HERE` bytes until its answer has been sent, and one that is handed on by itself as
`COST_ALONE` at least until the gateway has executed it. So a client that floods the server leaves the others their
turns of the event loop, and few of its requests are before theirs.
"""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING, cast

from unity_link.bridges.serve.requests import Relayed, RelayedRows, Said
from unity_link.bridges.serve.turns import ClientQueue
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.bridges.serve.groups import ClientGroup
    from unity_link.bridges.serve.shared import SharedLink
    from unity_link.protocol.gateway.session import SessionState

MOST_UNDER_WAY = 65_536
"""Bytes of requests and answers under way for one client, beyond which it is not listened to."""
COST_HERE = 4096
"""Bytes that a frame counts as that is dealt with here: a client has 16 of them in one turn of the event loop."""
COST_ALONE = 512
"""Bytes that a request counts as that is not one of many side by side, at least: a client has 128 of them under way."""
MOST_POSTED = MOST_UNDER_WAY * 3 // 4
"""Bytes that posted writes count as behind which the next one is relayed as a write that is answered."""
MOST_UNSENT = 65_536
"""Bytes that wait for the client to read them, beyond which it is slow."""


class ClientConnection(asyncio.Protocol):
    """One connection, without the meaning of what comes over it.

    Args:
        shared: the link that it shares with others.
    """

    def __init__(self, shared: SharedLink) -> None:
        self.queue = ClientQueue()
        self.groups: dict[int, ClientGroup] = {}
        """Groups that it has set up, by its own numbers."""
        self.mode: int | None = None
        """The send-immediate mode that it asks for; None before it has said anything that could be understood."""
        self.listening = True
        """True if there is room for more requests of the client."""
        self.samples_dropped = 0
        """Samples that it did not read in time."""
        self._shared = shared
        self._transport: asyncio.Transport | None = None
        self._pending: deque[Relayed | RelayedRows | Said] = deque()
        self._asked = 0
        """Number of requests of the client so far."""
        self._last_posted = 0
        """Place of the last posted write among all that the client has asked for."""
        self._last_answered = 0
        """Place of the last request that was answered: all before it was executed, posted writes too."""
        self._last_told = 0
        """Place of the last request of which the client was sent an answer."""
        self._under_way = 0
        self._spent_here = 0
        """Bytes of `_under_way` for frames that were dealt with here since the last flush."""
        self._posted = 0
        """Bytes of `_under_way` for posted writes behind which nothing was handed on that is answered by itself."""
        self._out: list[bytes] = []
        self._flushing = False
        self._slow = False
        self._held = False
        self._said_all = False

    # Called by the transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Join those who share the link."""
        # No check by class: the transports of uvloop are of none of asyncio's.
        self._transport = cast("asyncio.Transport", transport)
        self._transport.set_write_buffer_limits(high=MOST_UNSENT)
        self._shared.join(self)

    def pause_writing(self) -> None:
        """Record that the client does not read."""
        self._slow = True
        self._listen()

    def resume_writing(self) -> None:
        """Record that it does again."""
        self._slow = False
        self._listen()

    def eof_received(self) -> bool:
        """Record that the client has said all, as a pipe into a socket does: what it asked is still answered."""
        self._said_all = True
        self._wake()
        return True

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (why it has gone changes nothing)
        """Leave: nothing of it is sent any more, and what it has set up ends."""
        self._transport = None
        dropped = self._shared.turns.leave(self.queue)
        for entry in self._pending:
            if isinstance(entry, Relayed):
                entry.sent = False
                # A request that names a group is waited for: the group must not change hands before it is over.
                entry.given_up = entry.after is None
            elif isinstance(entry, RelayedRows):
                entry.given_up = True
        self._shared.turns.forget(self.queue)
        self._pending.clear()
        self._shared.leave(self)
        for request in dropped:
            if isinstance(request, Relayed):
                self._over(request)

    def hang_up(self) -> None:
        """End the connection."""
        if self._transport is not None:
            self._transport.abort()

    def _listen(self) -> None:
        """Listen to the client, or not, as far as there is room for what it will say."""
        listening = not self._slow and not self._held and self.room > 0
        if listening == self.listening or self._transport is None:
            return
        self.listening = listening
        if listening:
            self._transport.resume_reading()
            self._read()
        else:
            self._transport.pause_reading()

    def _read(self) -> None:
        """Take what has come while there was no room for it."""

    # Called by the conversation

    @property
    def room(self) -> int:
        """Bytes of requests and answers that may still be under way."""
        return MOST_UNDER_WAY - self._under_way

    @property
    def posts_unconfirmed(self) -> bool:
        """Return whether posted writes are not yet known to be executed."""
        return self._last_posted > self._last_answered

    @property
    def must_confirm(self) -> bool:
        """Return whether so many posted writes are under way that the next one is to be answered."""
        return self._posted >= MOST_POSTED

    @property
    def gone(self) -> bool:
        """Return whether the connection has ended."""
        return self._transport is None

    def hold(self) -> None:
        """Look at none of its further requests until `go_on`."""
        self._held = True
        self._listen()

    def go_on(self) -> None:
        """Look at its requests again."""
        self._held = False
        self._listen()

    def follow_others(self) -> None:
        """Order all that this client asks for behind the writes that are here, which may be its own.

        Its former connection may be cut without anything having told so yet.
        """
        self._shared.turns.follow(self.queue, (other.queue for other in self._shared.clients if other is not self))

    def hand_on(self, relayed: Relayed, state: SessionState) -> None:
        """Put a request of a session into the line; where it has an ID, it is awaited there until it is answered."""
        relayed.state = state
        room = max(relayed.cost, COST_ALONE)
        self._under_way += room
        self._asked = relayed.order = self._asked + 1
        if relayed.posted:
            self._last_posted = relayed.order
            self._posted += room
        else:
            # Its answer says that those before it were executed.
            relayed.room = room + self._posted
            self._posted = 0
            if relayed.number is not None:
                state.awaited[relayed.number] = 1
            self._pending.append(relayed)
        if self._shared.away:
            relayed.refuse(ErrorCode.BUS_TIMEOUT)
            return
        self.queue.requests.append(relayed)
        if self.room <= 0:
            self._listen()

    def hand_on_rows(self, rows: RelayedRows, state: SessionState) -> None:
        """Put many requests of a session into the line."""
        self._under_way += rows.cost * rows.count
        rows.room, self._posted = self._posted, 0
        self._asked = rows.order = self._asked + 1
        _mark(rows.number, rows.count, state.awaited, 1)
        rows.state = state
        self._pending.append(rows)
        self.queue.requests.append(rows)
        if self.room <= 0:
            self._listen()

    def spend_here(self) -> None:
        """Count a frame that does not reach the gateway."""
        self._under_way += COST_HERE
        self._spent_here += COST_HERE
        self._wake()
        if self.room <= 0:
            self._listen()

    def say(self, frame: bytes) -> None:
        """Answer without the gateway, behind what is under way."""
        if self._pending:
            self._asked += 1
            self._pending.append(Said(frame, self._asked))
            self._under_way += len(frame)
        else:
            self.write(frame)

    def sample(self, frame: bytes) -> None:
        """Send a sample, if the client reads."""
        if self._slow:
            self.samples_dropped += 1
        else:
            self.write(frame)

    def refuse_all(self) -> None:
        """Answer every waiting request with an error, since the gateway is away; none will be executed any more."""
        self._refuse([*self._pending, *self._shared.turns.leave(self.queue)], ErrorCode.BUS_TIMEOUT)

    def lose_session(self) -> None:
        """Answer for a reset of the gateway; all waiting requests end but those that need no session."""
        dropped = self._shared.turns.leave(self.queue)
        self._refuse([entry for entry in (*self._pending, *dropped) if not entry.of_no_session], ErrorCode.NO_SESSION)
        self.queue.requests.extend(entry for entry in dropped if entry.of_no_session)
        self._shared.turns.join(self.queue)

    def _refuse(self, entries: Iterable[Relayed | RelayedRows | Said], unsent: ErrorCode) -> None:
        """End requests; those with an ID that were not sent by an error of their own."""
        # Posted writes are in the queue alone, and have their errors told before what was asked behind them.
        for entry in sorted(entries, key=lambda entry: entry.order):
            if isinstance(entry, RelayedRows) or (isinstance(entry, Relayed) and entry.reply is None):
                entry.refuse(unsent)

    # Answers

    def answer(self, request: Relayed, body: bytes) -> None:
        """Take the answer to a request that was handed on."""
        if request.reply is not None:
            return
        assert self._shared.codec is not None
        framing = self._shared.codec.framing
        if not body or request.silent:
            request.reply = b""
        else:
            request.reply = framing.plain_reply(body) if request.plain else framing.checked(body, _seed(request, body))
        self._over(request)
        if request.posted:
            self._answer_posted(request.reply, request.order)
            return
        self._last_answered = max(self._last_answered, request.order)
        if self._pending and self._pending[0] is request:
            self._answer_on()

    def _answer_posted(self, frame: bytes, order: int) -> None:
        """Send the error of a posted write behind the answers to what was asked before it, and before all others.

        Where one of those was sent before, the error comes too late: the count in the answer to an ``h`` tells of it.
        """
        if not frame or order < self._last_told:
            return
        place = sum(entry.order < order for entry in self._pending)
        if not place:
            self.write(frame)
            self._last_told = order
        else:
            self._pending.insert(place, Said(frame, order))
            self._under_way += len(frame)

    def answer_rows(self, rows: RelayedRows) -> None:
        """Record answers to many requests."""
        self._last_answered = max(self._last_answered, rows.order)
        if self._pending and self._pending[0] is rows:
            self._answer_on()

    def _answer_on(self) -> None:
        """Send what is the next in the order, as far as it is there."""
        pending = self._pending
        while pending:
            entry = pending[0]
            if isinstance(entry, RelayedRows):
                self._write_rows(entry)
                self._last_told = entry.order if entry.answered else self._last_told
                if entry.answered < entry.count:
                    return
            elif entry.reply is None:
                return
            else:
                if isinstance(entry, Said):
                    self._under_way -= len(entry.reply)
                elif entry.state is not None and entry.number is not None:
                    entry.state.awaited[entry.number] = 0
                self.write(entry.reply)
            self._last_told = entry.order
            pending.popleft()

    def _write_rows(self, rows: RelayedRows) -> None:
        awaited = rows.state.awaited
        first = rows.number + rows.answered & len(awaited) - 1
        count, sent, frames = rows.ready()
        if count:
            self._under_way -= count * rows.cost + rows.room
            rows.room = 0
            self._shared.turns.arrived(self.queue, sent * rows.cost)
            _mark(first, count, awaited, 0)
            self.write(frames)

    def posted(self, request: Relayed) -> None:  # noqa: ARG002  (its room is that of what is answered behind it)
        """Record that a posted write is on its way: unless it fails, nothing more is heard of it."""
        self._wake()

    def _over(self, request: Relayed) -> None:
        """Forget a request that is answered or dropped."""
        self._under_way -= request.room
        if request.sent and not request.posted:
            self._shared.turns.arrived(self.queue, request.cost)
        if request.after is not None:
            after, request.after = request.after, None
            after(request.executed)

    def write(self, frame: bytes) -> None:
        """Send together with all else that is sent in this turn of the event loop."""
        self._out.append(frame)
        self._wake()

    def _wake(self) -> None:
        if not self._flushing:
            self._flushing = True
            self._shared.loop.call_soon(self._flush)

    def _flush(self) -> None:
        """Send, and listen again where that has made room."""
        self._flushing = False
        data = b"".join(self._out)
        self._out.clear()
        self._under_way -= self._spent_here
        self._spent_here = 0
        if self._transport is not None:
            self._transport.write(data)
            self._listen()
            if self._said_all and not self._pending and not self.queue.requests:
                self._transport.close()


def _seed(request: Relayed, body: bytes) -> int:
    """Return the seed of the answer to a request, which has that of its session if it has an ID."""
    return 0 if request.state is None or not body[:1].islower() else request.state.seeds[1]


def _mark(first: int, count: int, awaited: bytearray, value: int) -> None:
    """Note of consecutive IDs whether they are under way."""
    before_wrap = min(count, len(awaited) - first)
    awaited[first : first + before_wrap] = bytes([value]) * before_wrap
    awaited[: count - before_wrap] = bytes([value]) * (count - before_wrap)
