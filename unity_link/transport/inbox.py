"""The way from other threads, as those of Zenoh and ROS, into the event loop."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections import deque
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

T = TypeVar("T")


class Inbox(Generic[T]):
    """Queue from threads into an event loop: all that has come together at a time.

    Args:
        take: is called in the loop with what has come, in order.
        most: where so many wait, the giving thread blocks.
    """

    def __init__(self, take: Callable[[list[T]], object], most: int = 1 << 16) -> None:
        self._take = take
        self._most = most
        self._loop = asyncio.get_running_loop()
        self._waiting: deque[T] = deque()
        self._called = False
        self._room = threading.Event()
        self._room.set()
        self._open = True
        self._held = False

    def give(self, *items: T) -> None:
        """Put something in, from any thread but that of the loop."""
        self._room.wait()
        if not self._open:
            return
        self._waiting.extend(items)
        if len(self._waiting) >= self._most:
            self._room.clear()
        if not self._called:
            self._called = True
            # The loop may have ended.
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._hand_over)

    def hold(self) -> None:
        """Hand nothing over until `release`."""
        self._held = True

    def release(self) -> None:
        """Hand over again."""
        self._held = False
        self._hand_over()

    def close(self) -> list[T]:
        """Take nothing any more; return what has not been handed over."""
        self._open = False
        items = self._empty()
        self._room.set()
        return items

    def _hand_over(self) -> None:
        # First, so that what is given from here on calls again.
        self._called = False
        if self._held:
            return
        items = self._empty()
        # Also where nothing waits: who gave the last may have seen a full box after it was emptied.
        self._room.set()
        if items:
            self._take(items)

    def _empty(self) -> list[T]:
        return [self._waiting.popleft() for _ in range(len(self._waiting))]
