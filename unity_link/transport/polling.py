"""Waiting for file descriptors without an event loop, and when it is worth not to sleep meanwhile."""

from __future__ import annotations

import contextlib
import math
import os
import select
import selectors
import sys
import time
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

READABLE, WRITABLE = selectors.EVENT_READ, selectors.EVENT_WRITE
SPIN = 100e-6
"""Seconds of looking for what is ready before sleeping.

A processor that has gone to sleep for a wait takes 10 to 50 µs to go on, which is as long as a quick gateway takes to
answer. With 30 µs, waits of the benchmark are now shorter, now longer than that.
"""
LONGEST_SLEEP = 1e6
"""Seconds that a selector can be given, at most: systems count milliseconds in 32 bits."""
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


class Selector(Protocol):
    """Waits for file descriptors."""

    def register(self, descriptor: int, events: int) -> None:
        """Wait for some of `READABLE` and `WRITABLE` from now on, in place of others of the same descriptor."""

    def unregister(self, descriptor: int) -> None:
        """Wait for a descriptor no more."""

    def select(self, timeout: float | None) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events, once there are some; None: without a limit."""

    def close(self) -> None:
        """End it."""


class PortableSelector:
    """The best selector of the system."""

    def __init__(self) -> None:
        self._selector = selectors.DefaultSelector()
        self.close = self._selector.close

    def register(self, descriptor: int, events: int) -> None:
        """Wait for some of `READABLE` and `WRITABLE` from now on."""
        try:
            self._selector.modify(descriptor, events)
        except KeyError:
            self._selector.register(descriptor, events)

    def unregister(self, descriptor: int) -> None:
        """Wait for a descriptor no more."""
        self._selector.unregister(descriptor)

    def select(self, timeout: float | None) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events."""
        return [(key.fd, events) for key, events in self._selector.select(timeout)]


if sys.platform == "linux":

    class EpollSelector:
        """epoll of Linux, in half the time of the standard library's selector.

        ``poll`` on a terminal has the kernel first deliver what is on its way there, which takes the longer the more
        often it is called.
        """

        _EVENTS = tuple(
            (READABLE if event & ~select.EPOLLOUT else 0) | (WRITABLE if event & ~select.EPOLLIN else 0)
            for event in range(2 * select.EPOLLHUP)
        )
        """Events of this module by those of epoll, in which an error makes a descriptor ready for both."""

        def __init__(self) -> None:
            self._epoll = select.epoll()
            self._poll = self._epoll.poll
            self.close = self._epoll.close

        def register(self, descriptor: int, events: int) -> None:
            """Wait for some of `READABLE` and `WRITABLE` from now on."""
            wanted = (select.EPOLLIN if events & READABLE else 0) | (select.EPOLLOUT if events & WRITABLE else 0)
            try:
                self._epoll.modify(descriptor, wanted)
            except FileNotFoundError:
                self._epoll.register(descriptor, wanted)

        def unregister(self, descriptor: int) -> None:
            """Wait for a descriptor no more, also if it is closed."""
            with contextlib.suppress(OSError):
                self._epoll.unregister(descriptor)

        def select(self, timeout: float | None) -> list[tuple[int, int]]:
            """Return the descriptors that are ready, with their events."""
            found = self._poll(timeout)
            return [(descriptor, self._EVENTS[event]) for descriptor, event in found] if found else found

    default_selector: Callable[[], Selector] = EpollSelector
else:
    default_selector = PortableSelector


class Poller:
    """Waits for file descriptors, and may spin first, for at most `SPIN`."""

    def __init__(
        self,
        selector: Selector | None = None,
        clock: Callable[[], float] = time.monotonic,
        processors: int | None = None,
    ) -> None:
        self._selector = selector or default_selector()
        self._clock = clock
        self._spinning = Spinning(processors)
        self._select = self._selector.select
        self.register = self._selector.register
        self.unregister = self._selector.unregister
        self.close = self._selector.close

    def wait(self, patience: float, *, may_spin: bool) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events, once there are some or so many seconds are over.

        A wait of days may end earlier.
        """
        clock, select, spinning = self._clock, self._select, self._spinning
        begin = clock()
        found: list[tuple[int, int]] = []
        if may_spin and spinning.left:
            end = begin + min(SPIN, patience)
            found = select(0)
            while not found and clock() < end:
                found = select(0)
        if not found:
            left = patience - (clock() - begin)
            found = select(None if left == math.inf else min(max(0.0, left), LONGEST_SLEEP))
        if may_spin:
            spinning.record(clock() - begin if found else math.inf)
        return found
