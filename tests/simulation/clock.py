"""An event loop without an operating system: its time is simulated, and what it connects to is a `Network`.

The clock stands still while there is work and jumps to the next timer when there is none. There is no selector, no
socket and no thread, so a loop costs nothing to make and every run of the same program is the same to the byte.
Drivers and servers use it as any loop of asyncio: `create_connection` and its sisters are the network's.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from unity_link.virtual.modelled_time import DeadlockError

if TYPE_CHECKING:
    from simulation.medium import Network


class _Clock:
    """The selector's place in the loop: it selects nothing and moves the time."""

    def __init__(self) -> None:
        self.now = 0.0

    def select(self, timeout: float | None) -> tuple[()]:
        """Jump to the next timer."""
        if timeout is None:
            raise DeadlockError(f"nothing is left to happen at {self.now} s of simulated time")
        if timeout > 0:
            self.now += timeout
        return ()


class SimulatedLoop(asyncio.BaseEventLoop):
    """The loop of one world."""

    network: Network

    def __init__(self) -> None:
        super().__init__()
        self._selector = _Clock()
        self._clock_resolution = 1e-9

    def time(self) -> float:
        """Return the simulated time in seconds."""
        return self._selector.now

    def _process_events(self, event_list: tuple[()]) -> None:
        """Do nothing: there are no events but timers."""

    def _write_to_self(self) -> None:
        """Do nothing: no other thread wakes this loop."""

    async def create_connection(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Connect over the network."""
        return await self.network.connect(protocol_factory, host, port)

    async def create_server(self, protocol_factory: Any, host: Any = None, port: Any = None, **_: Any) -> Any:
        """Listen in the network."""
        return self.network.listen(protocol_factory, host, port)
