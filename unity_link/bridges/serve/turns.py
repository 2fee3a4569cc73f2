"""The order of requests: all clients take turns to send into the window of the shared link.

The method is deficit round robin (Shreedhar and Varghese, 1995) over bytes: at its turn a client may send a quantum of
bytes of requests and answers, and bytes beyond that are deducted from its next turns. So a client that moves blocks and
one that reads words get the same share of the line, and a client with few requests waits for at most one turn of each
other client.

Requests in flight cannot be overtaken. So while several clients send, the bytes in flight are limited to those that the
line has carried in `LONGEST_WAIT`, answers included; a quantum is half of that. A fast line needs long turns, because
many requests of one client cost little more than one. A slow line needs short turns, so that no client waits long.

One rule precedes fairness. A client whose connection was cut may have opened a new one while the server still has
writes of the old one. So the requests of a new session follow all writes that the server has received before.
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
"""Seconds that a request waits for those in flight."""
LEAST_AHEAD = 4096
"""Bytes that may be in flight on any line, however slow."""
_SPAN = 0.005
"""Seconds over which the rate of the line is measured."""


class ClientQueue:
    """Requests of one client that were not sent yet."""

    __slots__ = ("ahead", "balance", "followers", "in_line", "requests", "sent", "under_way")

    def __init__(self) -> None:
        self.ahead = 0
        """Number of other queues with writes that must be sent before the requests of this queue."""
        self.followers: list[tuple[int, Callable[[], None]]] = []
        """For each waiting function: the value of `sent` at which it is called, and the function."""
        self.sent = 0
        """Number of requests that have left the queue."""
        self.under_way = 0
        """Bytes of the requests in flight, and of their answers."""
        self.requests: deque[Relayed | RelayedRows] = deque()
        self.balance = LEAST_AHEAD // 2
        self.in_line = False

    def last_write(self) -> int:
        """Return the value of `sent` after the last write in the queue; the present one if there is no write."""
        place = self.sent + len(self.requests)
        for request in reversed(self.requests):
            if request.command not in REPEATABLE:
                return place
            place -= 1
        return place


def _call_when_written(queues: Iterable[ClientQueue], then: Callable[[], None]) -> int:
    """For each queue with writes, call a function when these have been sent; return the number of such queues."""
    count = 0
    for queue in queues:
        place = queue.last_write()
        if place > queue.sent:
            queue.followers.append((place, then))
            count += 1
    return count


class Pace:
    """Limit on the bytes in flight on a line.

    If the limit is too low, the line carries fewer bytes than it could, but each of them in less than `LONGEST_WAIT`.
    The rate that is measured then gives a higher limit, until the rate of the line is reached.
    """

    def __init__(self) -> None:
        self.most_ahead = LEAST_AHEAD
        """The limit, in bytes."""
        self._carried = 0
        self._since = 0.0

    def carried(self, size: int, now: float) -> None:
        """Record the bytes of an answer and its request."""
        self._carried += size
        elapsed = now - self._since
        if elapsed >= _SPAN:
            self.most_ahead = max(LEAST_AHEAD, int(self._carried / elapsed * LONGEST_WAIT))
            self._carried, self._since = 0, now


class Turns:
    """All queues, as one source of requests.

    Args:
        submit: lets the link's session send the requests of a source.
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
        """Add a queue to the line if it has requests."""
        if queue.requests and not queue.in_line and not queue.ahead:
            queue.in_line = True
            self._line.append(queue)
        self._submit()

    def follow(self, queue: ClientQueue, others: Iterable[ClientQueue]) -> None:
        """Hold a queue back until the present writes in other queues have been sent."""

        def go_on() -> None:
            queue.ahead -= 1
            self.join(queue)

        queue.ahead += _call_when_written(others, go_on)

    async def written(self, queues: Iterable[ClientQueue]) -> None:
        """Wait until the present writes in queues have been sent."""
        sent = asyncio.Semaphore(0)
        for _ in range(_call_when_written(queues, sent.release)):
            await sent.acquire()

    def leave(self, queue: ClientQueue) -> list[Relayed | RelayedRows]:
        """Empty a queue, and return its requests."""
        dropped = list(queue.requests)
        queue.requests.clear()
        if queue.in_line:
            queue.in_line = False
            self._line.remove(queue)
        self._sent(queue, len(dropped))
        return dropped

    def _sent(self, queue: ClientQueue, count: int) -> None:
        """Record requests that have left a queue, and call the functions that have waited for them."""
        queue.sent += count
        while queue.followers and queue.followers[0][0] <= queue.sent:
            _, go_on = queue.followers.pop(0)
            go_on()

    def arrived(self, queue: ClientQueue, cost: int) -> None:
        """Record the arrival of answers."""
        queue.under_way -= cost
        self._under_way -= cost
        self._pace.carried(cost, self._now())
        self._submit()

    def forget(self, queue: ClientQueue) -> None:
        """Record that the client of a queue has left, and receives no answers."""
        self.arrived(queue, queue.under_way)

    def hold(self) -> None:
        """Stop sending until `release`."""
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
        """Return whether a request may be sent now, without waiting for answers to those in flight."""
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

    # The interface of a source, for the session

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
        """Number of requests for which the window should have room before the next turn."""
        return self._first().requests[0].least

    def take(self, room: int, events: Events) -> Message:
        """Return the messages that the next client may send at once."""
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
        """Return True: the next session may send waiting requests. The server ends those that need the old one."""
        return True

    def exhausted(self) -> bool:
        """Return whether no request can be sent now; the session then forgets this source."""
        self._submitted = self._ready()
        return not self._submitted

    def unwanted(self) -> bool:
        """Return whether no request can be sent now, before a turn."""
        return self.exhausted()

    def fail(self, error: UnityLinkError, events: Events) -> None:  # noqa: ARG002  (the clients are disconnected)
        """Drop all requests: the link has ended."""
        # Queues that follow an emptied one join the line: mark it as submitted, so that they are dropped here, too.
        self._submitted = True
        while self._line:
            self.leave(self._line[0])
        self._submitted = False
