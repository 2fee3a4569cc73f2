"""Values that come from other threads, as those of ROS and Zenoh do, on their way to the robot: in order, each once."""

from __future__ import annotations

import asyncio
import threading
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.errors import ArgumentError, GatewayError, LinkLostError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.data import Writable

MOST_WAITING = 4096
"""Values that wait for the link, beyond which who gives them waits, and so does who sent them."""


class Commands:
    """Writes values to signals, as posted writes.

    Args:
        report: is told in a sentence of a value that cannot be written, once for each signal and kind of fault.
    """

    def __init__(self, report: Callable[[str], None]) -> None:
        self.written = 0
        """Values that were posted."""
        self._report = report
        self._loop = asyncio.get_running_loop()
        self._waiting: deque[tuple[Writable[Any], Any]] = deque()
        self._woken = asyncio.Event()
        self._room = threading.Event()
        self._room.set()
        self._told: set[tuple[str, str]] = set()
        self._ended = False

    def give(self, proxy: Writable[Any], value: Any) -> None:
        """Have a value written; to be called from another thread, which waits while too many do."""
        self._room.wait()
        if self._ended:
            return
        self._waiting.append((proxy, value))
        if len(self._waiting) >= MOST_WAITING:
            self._room.clear()
        if len(self._waiting) == 1:
            self._loop.call_soon_threadsafe(self._woken.set)

    async def run(self) -> None:
        """Write what is given, until it is cancelled.

        Raises:
            LinkLostError: where the link ends.
        """
        waiting = self._waiting
        try:
            while True:
                self._woken.clear()
                while waiting:
                    await self._write(*waiting[0])
                    waiting.popleft()
                    if len(waiting) < MOST_WAITING // 2:
                        self._room.set()
                await self._woken.wait()
        finally:
            self._ended = True
            self._room.set()

    async def _write(self, proxy: Writable[Any], value: Any) -> None:
        try:
            await proxy.post(value)
            self.written += 1
        except LinkLostError:
            raise
        except (ArgumentError, GatewayError) as error:
            key = (proxy.path, type(error).__name__)
            if key not in self._told:
                self._told.add(key)
                self._report(f"{error} (told once)")
