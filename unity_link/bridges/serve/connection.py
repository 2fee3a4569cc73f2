"""The connection of one client, and the order of its requests and their answers.

Answers are sent in the order of the requests, even if those of the gateway arrive in another order.

Memory is bounded. If the requests and answers of a client take more than `MOST_UNDER_WAY` bytes, or the client does not
read, its requests are not read until that has changed; samples that it does not read are dropped. A frame that never
reaches the gateway counts as `COST_HERE` bytes until its answer has been sent. A request that is passed on alone counts
as at least `COST_ALONE` bytes until the gateway has executed it. So a client that floods the server leaves the other
clients their time in the event loop, and few of its requests are ahead of theirs.
"""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING, cast

from unity_link.bridges.serve.requests import LocalAnswer, Relayed, RelayedRows
from unity_link.bridges.serve.turns import ClientQueue
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.bridges.serve.groups import ClientGroup
    from unity_link.bridges.serve.shared import SharedLink
    from unity_link.protocol.gateway.session import SessionState

MOST_UNDER_WAY = 65_536
"""Most bytes of requests and answers in flight for one client; with more, its requests are not read."""
COST_HERE = 4096
"""Bytes that a frame counts as if the server answers it: a client gets 16 of them in one turn of the event loop."""
COST_ALONE = 512
"""Least number of bytes that a single request counts as: a client has 128 of them in flight."""
MOST_POSTED = MOST_UNDER_WAY * 3 // 4
"""Bytes of posted writes in flight, by their costs, after which the next one is sent as a write with an answer."""
MOST_UNSENT = 65_536
"""Bytes that wait for the client to read them; with more, the client counts as slow."""


class ClientConnection(asyncio.Protocol):
    """One connection, without the interpretation of its bytes.

    Args:
        shared: the link that the clients share.
    """

    def __init__(self, shared: SharedLink) -> None:
        self.queue = ClientQueue()
        self.groups: dict[int, ClientGroup] = {}
        """Groups that the client has set up, by the client's own numbers."""
        self.mode: int | None = None
        """Send-immediate mode of the client; None before its first frame."""
        self.listening = True
        """True if there is room for more requests of the client, so that its data is read."""
        self.samples_dropped = 0
        """Number of samples that were dropped because the client did not read in time."""
        self._shared = shared
        self._transport: asyncio.Transport | None = None
        self._pending: deque[Relayed | RelayedRows | LocalAnswer] = deque()
        self._asked = 0
        """Number of requests of the client so far."""
        self._last_posted = 0
        """Number, in the order of the client's requests, of the last posted write."""
        self._last_answered = 0
        """Number of the last answered request: all earlier ones were executed, including posted writes."""
        self._last_sent = 0
        """Number of the last request whose answer was sent to the client."""
        self._under_way = 0
        self._spent_here = 0
        """Bytes of `_under_way` for frames that the server has answered since the last flush."""
        self._posted = 0
        """Bytes of `_under_way` for posted writes after the last request with an answer of its own."""
        self._out: list[bytes] = []
        self._flushing = False
        self._slow = False
        self._held = False
        self._at_eof = False

    # Called by the transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Add the client to those of the link."""
        # Do not check the class: transports of uvloop are no subclasses of asyncio's.
        self._transport = cast("asyncio.Transport", transport)
        self._transport.set_write_buffer_limits(high=MOST_UNSENT)
        self._shared.join(self)

    def pause_writing(self) -> None:
        """Note that the client does not read."""
        self._slow = True
        self._listen()

    def resume_writing(self) -> None:
        """Note that the client reads again."""
        self._slow = False
        self._listen()

    def eof_received(self) -> bool:
        """Note that the client sends no more, as at the end of a pipe into it. Its requests are still answered."""
        self._at_eof = True
        self._wake()
        return True

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (the reason changes nothing)
        """Remove the client: none of its requests is sent any more, and its groups and leases end."""
        self._transport = None
        dropped = self._shared.turns.leave(self.queue)
        for entry in self._pending:
            if isinstance(entry, Relayed):
                entry.sent = False
                # A request that names a group is still waited for: its slot must not get another holder before that.
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
        """Resume or pause reading from the client, by free queue space."""
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
        """Process data that arrived while there was no room for its requests."""

    # Called by the client protocol

    @property
    def room(self) -> int:
        """Number of bytes of requests and answers that may still be in flight."""
        return MOST_UNDER_WAY - self._under_way

    @property
    def posts_unconfirmed(self) -> bool:
        """Return whether posted writes are not known to be executed yet."""
        return self._last_posted > self._last_answered

    @property
    def must_confirm(self) -> bool:
        """Return whether so many posted writes are in flight that the next one must have an answer."""
        return self._posted >= MOST_POSTED

    @property
    def gone(self) -> bool:
        """Return whether the connection has ended."""
        return self._transport is None

    def hold(self) -> None:
        """Process no further requests of the client until `go_on`."""
        self._held = True
        self._listen()

    def go_on(self) -> None:
        """Process the client's requests again."""
        self._held = False
        self._listen()

    def follow_others(self) -> None:
        """Order all requests of this client after the writes of other clients that are already here.

        Such a write may be this client's own, from an earlier connection whose loss was not noticed yet.
        """
        self._shared.turns.follow(self.queue, (other.queue for other in self._shared.clients if other is not self))

    def hand_on(self, relayed: Relayed, state: SessionState) -> None:
        """Queue a request of a session. The ID, if any, is marked as awaited until the answer is sent."""
        relayed.state = state
        room = max(relayed.cost, COST_ALONE)
        self._under_way += room
        self._asked = relayed.order = self._asked + 1
        if relayed.posted:
            self._last_posted = relayed.order
            self._posted += room
        else:
            # The answer confirms that the posted writes before it were executed.
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
        """Queue many requests of a session."""
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
        """Count the cost of a frame that does not reach the gateway."""
        self._under_way += COST_HERE
        self._spent_here += COST_HERE
        self._wake()
        if self.room <= 0:
            self._listen()

    def say(self, frame: bytes) -> None:
        """Send an answer of the server's own, after the answers to earlier requests."""
        if self._pending:
            self._asked += 1
            self._pending.append(LocalAnswer(frame, self._asked))
            self._under_way += len(frame)
        else:
            self.write(frame)

    def sample(self, frame: bytes) -> None:
        """Send a sample, unless the client is slow."""
        if self._slow:
            self.samples_dropped += 1
        else:
            self.write(frame)

    def refuse_all(self) -> None:
        """Answer all waiting requests with an error, because the gateway is away. None of them is executed later."""
        self._refuse([*self._pending, *self._shared.turns.leave(self.queue)], ErrorCode.BUS_TIMEOUT)

    def lose_session(self) -> None:
        """Report a reset of the gateway: all waiting requests end, except those that need no session."""
        dropped = self._shared.turns.leave(self.queue)
        self._refuse([entry for entry in (*self._pending, *dropped) if not entry.of_no_session], ErrorCode.NO_SESSION)
        self.queue.requests.extend(entry for entry in dropped if entry.of_no_session)
        self._shared.turns.join(self.queue)

    def _refuse(self, entries: Iterable[Relayed | RelayedRows | LocalAnswer], unsent: ErrorCode) -> None:
        """End requests. Those with an ID that were not sent end with the error `unsent`."""
        # Posted writes are only in the queue; their errors must be reported before those of later requests.
        for entry in sorted(entries, key=lambda entry: entry.order):
            if isinstance(entry, RelayedRows) or (isinstance(entry, Relayed) and entry.reply is None):
                entry.refuse(unsent)

    # Answers

    def answer(self, request: Relayed, body: bytes) -> None:
        """Process the gateway's answer to a request that was passed on."""
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
        """Send the error of a posted write after the answers to earlier requests, and before those to later ones.

        If an answer to a later request was sent already, the error is not sent: the count in the answer to an ``h``
        includes it.
        """
        if not frame or order < self._last_sent:
            return
        place = sum(entry.order < order for entry in self._pending)
        if not place:
            self.write(frame)
            self._last_sent = order
        else:
            self._pending.insert(place, LocalAnswer(frame, order))
            self._under_way += len(frame)

    def answer_rows(self, rows: RelayedRows) -> None:
        """Process answers to many requests."""
        self._last_answered = max(self._last_answered, rows.order)
        if self._pending and self._pending[0] is rows:
            self._answer_on()

    def _answer_on(self) -> None:
        """Send the answers that are next in the order, as far as they have arrived."""
        pending = self._pending
        while pending:
            entry = pending[0]
            if isinstance(entry, RelayedRows):
                self._write_rows(entry)
                self._last_sent = entry.order if entry.answered else self._last_sent
                if entry.answered < entry.count:
                    return
            elif entry.reply is None:
                return
            else:
                if isinstance(entry, LocalAnswer):
                    self._under_way -= len(entry.reply)
                elif entry.state is not None and entry.number is not None:
                    entry.state.awaited[entry.number] = 0
                self.write(entry.reply)
            self._last_sent = entry.order
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

    def posted(self, request: Relayed) -> None:  # noqa: ARG002  (its bytes are freed with the next answer)
        """Note that a posted write was sent. The gateway only answers it if it fails."""
        self._wake()

    def _over(self, request: Relayed) -> None:
        """Free the bytes of a request that was answered or dropped, and call its `after`."""
        self._under_way -= request.room
        if request.sent and not request.posted:
            self._shared.turns.arrived(self.queue, request.cost)
        if request.after is not None:
            after, request.after = request.after, None
            after(request.executed)

    def write(self, frame: bytes) -> None:
        """Send a frame together with all others of this turn of the event loop."""
        self._out.append(frame)
        self._wake()

    def _wake(self) -> None:
        if not self._flushing:
            self._flushing = True
            self._shared.loop.call_soon(self._flush)

    def _flush(self) -> None:
        """Send all frames, and read from the client again if there is room now."""
        self._flushing = False
        data = b"".join(self._out)
        self._out.clear()
        self._under_way -= self._spent_here
        self._spent_here = 0
        if self._transport is not None:
            self._transport.write(data)
            self._listen()
            if self._at_eof and not self._pending and not self.queue.requests:
                self._transport.close()


def _seed(request: Relayed, body: bytes) -> int:
    """Return the CRC seed of an answer: that of the session, if the answer has an ID; otherwise 0."""
    return 0 if request.state is None or not body[:1].islower() else request.state.seeds[1]


def _mark(first: int, count: int, awaited: bytearray, value: int) -> None:
    """Mark consecutive IDs as awaited (1) or not (0), with wrap-around."""
    before_wrap = min(count, len(awaited) - first)
    awaited[first : first + before_wrap] = bytes([value]) * before_wrap
    awaited[: count - before_wrap] = bytes([value]) * (count - before_wrap)
