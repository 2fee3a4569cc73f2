"""An event loop without an operating system: its time is simulated, and what it connects to is a `Network`.

The clock stands still while there is work and jumps to the next timer when there is none. There is no selector, no
socket and no thread, so a loop costs nothing to make and every run of the same program is the same to the byte.
Drivers and servers use it as any loop of asyncio: `create_connection` and its sisters are the network's.
"""

from __future__ import annotations

import asyncio
import heapq
from typing import TYPE_CHECKING, Any

from unity_link.virtual.modelled_time import DeadlockError

if TYPE_CHECKING:
    from collections import deque
    from collections.abc import Callable

    from simulation.medium import Network


class SimulatedLoop(asyncio.BaseEventLoop):
    """The loop of one world."""

    network: Network
    # Of asyncio's own.
    _ready: deque[asyncio.Handle]
    _scheduled: list[Any]
    _timer_cancelled_count: int
    _stopping: bool

    def __init__(self) -> None:
        super().__init__()
        self._now = 0.0
        self._clock_resolution = 1e-9

    def time(self) -> float:
        """Return the simulated time in seconds."""
        return self._now

    def _run_once(self) -> None:
        """Run what is ready; where nothing is, jump to the next timer.

        Asyncio's own does the same, and asks a selector each time.
        """
        ready, scheduled = self._ready, self._scheduled
        while scheduled and scheduled[0]._cancelled:
            heapq.heappop(scheduled)._scheduled = False
            self._timer_cancelled_count -= 1
        if not ready and not self._stopping:
            if not scheduled:
                raise DeadlockError(f"nothing is left to happen at {self._now} s of simulated time")
            self._now = max(self._now, scheduled[0]._when)
        due = self._now + self._clock_resolution
        while scheduled and scheduled[0]._when < due:
            handle = heapq.heappop(scheduled)
            handle._scheduled = False
            ready.append(handle)
        for _ in range(len(ready)):
            handle = ready.popleft()
            if not handle._cancelled:
                handle._run()

    def _process_events(self, event_list: tuple[()]) -> None:
        """Do nothing: there are no events but timers."""

    def _write_to_self(self) -> None:
        """Do nothing: no other thread wakes this loop."""

    def run_in_executor(  # type: ignore[override]
        self, executor: Any, func: Callable[..., Any], *args: Any
    ) -> asyncio.Future[Any]:
        """Run at once what others give to a thread."""
        future = self.create_future()
        future.set_result(func(*args))
        return future

    async def create_connection(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Connect over the network."""
        return await self.network.connect(protocol_factory, host, port)

    async def create_server(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Listen in the network."""
        return self.network.listen(protocol_factory, host, port)
