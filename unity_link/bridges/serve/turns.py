"""The order of requests: the requests of all clients take turns on the way into the one link's window.

Deficit round robin (Shreedhar and Varghese, 1995) over bytes: at its turn a client may send for a quantum of bytes of
requests and answers, and what it overdraws is taken off its next turns. So one that moves blocks and one that reads
words get the same share of the line, and one that has little to ask waits for one turn of each of the others at most.

What is under way can't be overtaken any more. So while several clients are at it, no more is sent than the line was
seen to carry in `LONGEST_WAIT`, answers included; a quantum is half of that. Long turns are what a quick line needs,
for many requests of one client cost little more than one; short ones are what a slow line needs, so that no client
waits long.

One thing goes before fairness. A client whose connection was cut may be back by a new one while the server still holds
writes that came by the old one. So a new session begins behind all writes that were received before it.
"""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING

from unity_link.protocol.host.requests import REPEATABLE

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from unity_link.bridges.serve.requests import Relayed, RelayedRows
    from unity_link.errors import UnityLinkError
    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.requests import Message, Source

LONGEST_WAIT = 0.005
"""Seconds that a request waits behind those that are under way."""
LEAST_AHEAD = 4096
"""Bytes that may be under way on any line, however slow."""
_SPAN = 0.005
"""Seconds over which the line is watched."""


class ClientQueue:
    """Requests of one client that are not sent yet."""

    __slots__ = ("ahead", "balance", "followers", "in_line", "requests", "sent", "under_way")

    def __init__(self) -> None:
        self.ahead = 0
        """Other queues that hold writes which go before all that is in this one."""
        self.followers: list[tuple[int, Callable[[], None]]] = []
        """Count of `sent` at which each of what waits may go on, and what has it do so."""
        self.sent = 0
        """Number of requests that have left this queue."""
        self.under_way = 0
        """Bytes of requests that were sent and of their answers."""
        self.requests: deque[Relayed | RelayedRows] = deque()
        self.balance = LEAST_AHEAD // 2
        self.in_line = False

    def last_write(self) -> int:
        """Return what `sent` will be when no request is left here that changes anything; `sent` where none is."""
        place = self.sent + len(self.requests)
        for request in reversed(self.requests):
            if request.command not in REPEATABLE:
                return place
            place -= 1
        return place


def _call_when_written(queues: Iterable[ClientQueue], then: Callable[[], None]) -> int:
    """Call a function for each queue that holds writes, when these have been sent; return how many do."""
    count = 0
    for queue in queues:
        place = queue.last_write()
        if place > queue.sent:
            queue.followers.append((place, then))
            count += 1
    return count


class Pace:
    """Bytes that may be under way on a line.

    Where too little is, the line carries less than it could, but carries it quicker than `LONGEST_WAIT`: so more is
    allowed, and so on until it is as quick as it gets.
    """

    def __init__(self) -> None:
        self.most_ahead = LEAST_AHEAD
        """Bytes."""
        self._carried = 0
        self._since = 0.0

    def carried(self, size: int, now: float) -> None:
        """Record so many bytes that have come through."""
        self._carried += size
        elapsed = now - self._since
        if elapsed >= _SPAN:
            self.most_ahead = max(LEAST_AHEAD, int(self._carried / elapsed * LONGEST_WAIT))
            self._carried, self._since = 0, now


class Turns:
    """All queues, as one source of requests.

    Args:
        submit: has the link's session send what a source has.
    """

    def __init__(self, submit: Callable[[Source], None]) -> None:
        self._send = submit
        self._pace = Pace()
        self._now = asyncio.get_running_loop().time
        self._line: deque[ClientQueue] = deque()
        self._under_way = 0
        self._held = False
        self._submitted = False

    def join(self, queue: ClientQueue) -> None:
        """Record that a queue has requests."""
        if queue.requests and not queue.in_line and not queue.ahead:
            queue.in_line = True
            self._line.append(queue)
        self._submit()

    def follow(self, queue: ClientQueue, others: Iterable[ClientQueue]) -> None:
        """Hold a queue back until the writes that are in others now have been sent."""

        def go_on() -> None:
            queue.ahead -= 1
            self.join(queue)

        queue.ahead += _call_when_written(others, go_on)

    async def written(self, queues: Iterable[ClientQueue]) -> None:
        """Wait until the writes that are in queues now have been sent."""
        sent = asyncio.Semaphore(0)
        for _ in range(_call_when_written(queues, sent.release)):
            await sent.acquire()

    def leave(self, queue: ClientQueue) -> list[Relayed | RelayedRows]:
        """Empty a queue, and return what was in it."""
        dropped = list(queue.requests)
        queue.requests.clear()
        if queue.in_line:
            queue.in_line = False
            self._line.remove(queue)
        self._sent(queue, len(dropped))
        return dropped

    def _sent(self, queue: ClientQueue, count: int) -> None:
        """Record requests that have left a queue, and let those join that have waited for them."""
        queue.sent += count
        while queue.followers and queue.followers[0][0] <= queue.sent:
            _, go_on = queue.followers.pop(0)
            go_on()

    def arrived(self, queue: ClientQueue, cost: int) -> None:
        """Record answers."""
        queue.under_way -= cost
        self._under_way -= cost
        self._pace.carried(cost, self._now())
        self._submit()

    def forget(self, queue: ClientQueue) -> None:
        """Record that the client of a queue has left, and hears no answers."""
        self.arrived(queue, queue.under_way)

    def hold(self) -> None:
        """Send nothing until `release`."""
        self._held = True

    def release(self) -> None:
        """Send again."""
        self._held = False
        self._submit()

    def _submit(self) -> None:
        if not self._submitted and self._ready():
            self._submitted = True
            self._send(self)

    def _ready(self) -> bool:
        """Return whether something is to be sent now, and not only when more of what is under way has been answered."""
        if not self._line or self._held:
            return False
        others = len(self._line) > 1 or self._under_way > self._first().under_way
        return not others or self._under_way < self._pace.most_ahead

    @property
    def _quantum(self) -> int:
        return self._pace.most_ahead // 2

    def _first(self) -> ClientQueue:
        line = self._line
        queue = line[0]
        while queue.balance <= 0:
            queue.balance += self._quantum
            line.rotate(-1)
            queue = line[0]
        return queue

    # A source, asked by the session

    of_session = False

    @property
    def size(self) -> int:
        """Characters of the next request."""
        return self._first().requests[0].size

    @property
    def reply_size(self) -> int:
        """Characters of the answer to the next request."""
        return self._first().requests[0].reply_size

    @property
    def posted(self) -> bool:
        """Return whether the next request is a posted write."""
        return self._first().requests[0].posted

    @property
    def places(self) -> int:
        """Words of the next request that the gateway keeps."""
        return self._first().requests[0].places

    @property
    def least(self) -> int:
        """Number of requests for which room is wanted before the next turn."""
        return self._first().requests[0].least

    def take(self, room: int, events: Events) -> Message:
        """Return what the next client may send in one go."""
        queue, alone = self._first(), len(self._line) == 1
        request = queue.requests[0]
        cost = request.cost
        run = request.take(room if alone else min(room, -(-queue.balance // cost)), events)
        queue.balance -= cost * run.count
        if not request.posted:
            queue.under_way += cost * run.count
            self._under_way += cost * run.count
        if alone:
            queue.balance = max(queue.balance, -self._quantum)
        if request.exhausted():
            queue.requests.popleft()
            if not queue.requests:
                queue.in_line = False
                self._line.popleft()
            self._sent(queue, 1)
        return run

    @property
    def outlives_session(self) -> bool:
        """Return True: the next session may send what waits, and the server ends what its clients' sessions end."""
        return True

    def exhausted(self) -> bool:
        """Return whether there is nothing to send now; the session forgets this source then."""
        self._submitted = self._ready()
        return not self._submitted

    def unwanted(self) -> bool:
        """Return the same before a turn."""
        return self.exhausted()

    def fail(self, error: UnityLinkError, events: Events) -> None:  # noqa: ARG002  (the clients are hung up on)
        """Drop all requests: the link has ended."""
        # What followed a queue joins when that is empty: it is not submitted to what has ended, but dropped as well.
        self._submitted = True
        while self._line:
            self.leave(self._line[0])
        self._submitted = False
