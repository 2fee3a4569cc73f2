"""An event loop without an operating system: its time is simulated, and its connections lead to a `Network`.

The clock stops while callbacks are ready, and jumps to the next timer if there are none. There is no selector, no
socket and no thread, so a loop is cheap to create, and every run of a program is identical to the byte.
Drivers and servers use it as any loop of asyncio; `create_connection` and related methods use the network.
"""

from __future__ import annotations

import asyncio
from contextvars import Context, copy_context
from heapq import heappop, heappush
from typing import TYPE_CHECKING, Any

from unity_link.virtual.modelled_time import DeadlockError

if TYPE_CHECKING:
    from collections import deque
    from collections.abc import Callable

    from simulation.medium import Network

_RESOLUTION = 1e-9


class _Planned:
    """A planned call: it replaces asyncio's handles at a third of their cost.

    Args:
        callback: function to call.
        args: arguments of the call.
        context: context of the call.
        at: earliest time of the call, in seconds.
    """

    __slots__ = ("args", "at", "callback", "context", "is_cancelled")

    def __init__(
        self, callback: Callable[..., object], args: tuple[Any, ...], context: Context | None, at: float
    ) -> None:
        self.callback = callback
        self.args = args
        self.context = context or copy_context()
        self.at = at
        self.is_cancelled = False

    def cancel(self) -> None:
        """Cancel the call."""
        self.is_cancelled = True
        self.args = ()

    def cancelled(self) -> bool:
        """Return true if the call was cancelled."""
        return self.is_cancelled

    def when(self) -> float:
        """Return the time of a timer."""
        return self.at


MOST_TURNS = 100_000
"""Number of turns of the loop at one instant after which the run is aborted."""


class LivelockError(Exception):
    """Callbacks run without end while no time passes."""


class SimulatedLoop(asyncio.BaseEventLoop):
    """The event loop of one scenario."""

    network: Network
    _ready: deque[_Planned]
    # Declared by asyncio.BaseEventLoop.
    _stopping: bool

    def __init__(self) -> None:
        super().__init__()
        self._now = 0.0
        self._timers: list[tuple[float, int, _Planned]] = []
        """Sorted by time; timers of one instant are sorted in the order in which they were set."""
        self._timers_set = 0
        self._turns = 0
        """Turns at the present instant."""

    def time(self) -> float:
        """Return the simulated time in seconds."""
        return self._now

    # Calls are stored as `_Planned`, which has all members of `Handle` that asyncio uses, and costs less.
    def call_soon(  # type: ignore[override]
        self, callback: Callable[..., object], *args: Any, context: Context | None = None
    ) -> _Planned:
        """Call a function in the next turn."""
        planned = _Planned(callback, args, context, self._now)
        self._ready.append(planned)
        return planned

    def call_soon_threadsafe(  # type: ignore[override]
        self, callback: Callable[..., object], *args: Any, context: Context | None = None
    ) -> _Planned:
        """Call a function in the next turn; there is no other thread."""
        return self.call_soon(callback, *args, context=context)

    def call_at(  # type: ignore[override]
        self, when: float, callback: Callable[..., object], *args: Any, context: Context | None = None
    ) -> _Planned:
        """Call a function at an instant."""
        planned = _Planned(callback, args, context, when)
        self._timers_set += 1
        heappush(self._timers, (when, self._timers_set, planned))
        return planned

    def call_later(  # type: ignore[override]
        self, delay: float, callback: Callable[..., object], *args: Any, context: Context | None = None
    ) -> _Planned:
        """Call a function after some seconds."""
        return self.call_at(self._now + delay, callback, *args, context=context)

    def _run_once(self) -> None:
        """Run the ready callbacks; if there are none, jump to the next timer."""
        self._advance()
        ready, timers = self._ready, self._timers
        due = self._now + _RESOLUTION
        while timers and timers[0][0] < due:
            # A timer never fires early: its callback would set it again at once, so time might never pass.
            self._now = max(self._now, timers[0][0])
            ready.append(heappop(timers)[2])
        for _ in range(len(ready)):
            planned = ready.popleft()
            if planned.is_cancelled:
                continue
            try:
                planned.context.run(planned.callback, *planned.args)
            except (SystemExit, KeyboardInterrupt):
                raise
            except BaseException as error:  # noqa: BLE001  (as asyncio does)
                self.call_exception_handler(
                    {"message": f"Exception in callback {planned.callback}", "exception": error}
                )

    def _advance(self) -> None:
        """Jump to the next timer if no callback is ready."""
        timers = self._timers
        while timers and timers[0][2].is_cancelled:
            heappop(timers)
        if not self._ready and not self._stopping:
            if not timers:
                raise DeadlockError(f"no callback or timer is left at {self._now} s of simulated time")
            if timers[0][0] > self._now:
                self._now, self._turns = timers[0][0], 0
        self._turns += 1
        if self._turns > MOST_TURNS:
            raise LivelockError(f"time does not pass at {self._now} s of simulated time")

    def _process_events(self, event_list: tuple[()]) -> None:
        """Do nothing: the loop has no events but timers."""

    def _write_to_self(self) -> None:
        """Do nothing: no other thread wakes this loop."""

    def run_in_executor(  # type: ignore[override]
        self, executor: Any, func: Callable[..., Any], *args: Any
    ) -> asyncio.Future[Any]:
        """Run the function at once instead of in a thread."""
        future = self.create_future()
        future.set_result(func(*args))
        return future

    async def create_connection(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Connect through the network."""
        return await self.network.connect(protocol_factory, host, port)

    async def create_server(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Listen in the network."""
        return self.network.listen(protocol_factory, host, port)

    async def create_datagram_endpoint(
        self, protocol_factory: Any, local_addr: Any = None, remote_addr: Any = None, **_: Any
    ) -> Any:
        """Open a datagram socket in the network."""
        return self.network.open_port(protocol_factory, local_addr, remote_addr)
