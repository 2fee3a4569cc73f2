"""Waiting for file descriptors without an event loop, and when it is worth not to sleep meanwhile."""

from __future__ import annotations

import math
import os
import selectors
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

READABLE, WRITABLE = selectors.EVENT_READ, selectors.EVENT_WRITE
SPIN = 100e-6
"""Seconds of looking for what is ready before sleeping.

A processor that has gone to sleep for a wait takes 10 to 50 µs to go on, which is as long as a quick gateway takes to
answer. With 30 µs, waits of the benchmark are now shorter, now longer than that.
"""
REMEMBERED_WAITS = 8
"""Number of longer waits in a row after which a medium counts as slow."""


def count_processors() -> int:
    """Return how many processors this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Spinning:
    """True to spin: to look again and again instead of sleeping.

    It is worth it where one of the last waits was shorter than `SPIN`. The first wait finds out, for a medium may be
    that quick only where nobody sleeps. On a single processor, spinning would keep the other side from running.

    Args:
        processors: how many there are; None: on which this process may run.
    """

    def __init__(self, processors: int | None = None) -> None:
        self._most = REMEMBERED_WAITS if (processors or count_processors()) > 1 else 0
        self.left = min(1, self._most)
        """Number of further waits that spin, if none of them is short."""

    def record(self, seconds: float) -> None:
        """Record how long a wait took."""
        if seconds < SPIN:
            self.left = self._most
        elif self.left:
            self.left -= 1


class Poller:
    """Waits for file descriptors, and may spin first, for at most `SPIN`.

    Of what Linux has, it is epoll that waits: ``poll`` on a terminal has the kernel first deliver what is on its way
    there, which takes the longer the more often it is called.
    """

    def __init__(
        self,
        selector: selectors.BaseSelector | None = None,
        clock: Callable[[], float] = time.monotonic,
        processors: int | None = None,
    ) -> None:
        self._selector = selector or selectors.DefaultSelector()
        self._clock = clock
        self._spinning = Spinning(processors)
        self.unregister = self._selector.unregister
        self.close = self._selector.close

    def register(self, descriptor: int, events: int) -> None:
        """Wait for some of `READABLE` and `WRITABLE` from now on."""
        try:
            self._selector.modify(descriptor, events)
        except KeyError:
            self._selector.register(descriptor, events)

    def wait(self, patience: float, *, may_spin: bool) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events, once there are some or so many seconds are over."""
        begin = self._clock()
        found: list[tuple[selectors.SelectorKey, int]] = []
        if may_spin and self._spinning.left:
            found = self._spin(begin + min(SPIN, patience))
        if not found:
            left = patience - (self._clock() - begin)
            found = self._selector.select(None if left == math.inf else max(0, left))
        if may_spin:
            self._spinning.record(self._clock() - begin if found else math.inf)
        return [(key.fd, events) for key, events in found]

    def _spin(self, end: float) -> list[tuple[selectors.SelectorKey, int]]:
        found = self._selector.select(0)
        while not found and self._clock() < end:
            found = self._selector.select(0)
        return found
