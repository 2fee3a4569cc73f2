"""Passes items from other threads, such as those of Zenoh and ROS, into the event loop."""

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
    """A queue from threads into an event loop.

    Args:
        take: is called in the loop with all queued items, in order.
        most: number of queued items at which the threads that add items are blocked.
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
        """Add items, from any thread except that of the loop; block while the queue is full."""
        self._room.wait()
        if not self._open:
            return
        self._waiting.extend(items)
        if len(self._waiting) >= self._most:
            self._room.clear()
        if not self._called:
            self._called = True
            # The loop may be closed.
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._hand_over)

    def hold(self) -> None:
        """Keep items in the queue until `release`."""
        self._held = True

    def release(self) -> None:
        """Pass on the queued items, and later ones as they arrive."""
        self._held = False
        self._hand_over()

    def close(self) -> list[T]:
        """Ignore further items; return the items that are still queued."""
        self._open = False
        items = self._empty()
        self._room.set()
        return items

    def _hand_over(self) -> None:
        # Clear the flag first, so that items added from now on schedule another call.
        self._called = False
        if self._held:
            return
        items = self._empty()
        # Set the event even if the queue was empty: a thread may have found it full after it was emptied.
        self._room.set()
        if items:
            self._take(items)

    def _empty(self) -> list[T]:
        return [self._waiting.popleft() for _ in range(len(self._waiting))]
