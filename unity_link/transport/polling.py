"""Waits for file descriptors without an event loop; spins before sleeping if answers usually arrive quickly."""

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
"""Seconds of polling before sleeping.

A sleeping processor takes 10 to 50 µs to wake, which is as long as a quick gateway takes to answer. 30 µs would be too
short: some waits of the benchmark take longer.
"""
LONGEST_SLEEP = 1e6
"""Longest timeout of a selector in seconds, because systems count milliseconds in 32 bits."""
REMEMBERED_WAITS = 8
"""Number of consecutive waits longer than `SPIN` after which spinning stops."""


def count_processors() -> int:
    """Return the number of processors on which this process may run."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Spinning:
    """Decides whether to spin: to poll repeatedly instead of sleeping.

    Spinning is useful if one of the last waits was shorter than `SPIN`. The first wait always spins, because a medium
    may be that quick only if neither side sleeps. On a single processor spinning is off: it would keep the other
    program from running.

    Args:
        processors: number of processors; None for the number on which this process may run.
    """

    def __init__(self, processors: int | None = None) -> None:
        self._most = REMEMBERED_WAITS if (processors or count_processors()) > 1 else 0
        self.left = min(1, self._most)
        """Number of further waits that will spin even if none of them is short."""

    def record(self, seconds: float) -> None:
        """Record the duration of a wait."""
        if seconds < SPIN:
            self.left = self._most
        elif self.left:
            self.left -= 1


class Selector(Protocol):
    """Waits for file descriptors."""

    def register(self, descriptor: int, events: int) -> None:
        """Wait for `READABLE`, `WRITABLE` or both of a descriptor from now on, instead of its earlier events."""

    def unregister(self, descriptor: int) -> None:
        """Stop waiting for a descriptor."""

    def select(self, timeout: float | None) -> list[tuple[int, int]]:
        """Wait until descriptors are ready, and return them with their events.

        Args:
            timeout: time limit in seconds; None for no limit.
        """

    def close(self) -> None:
        """Close the selector."""


class PortableSelector:
    """The standard library's best selector for this system."""

    def __init__(self) -> None:
        self._selector = selectors.DefaultSelector()
        self.close = self._selector.close

    def register(self, descriptor: int, events: int) -> None:
        """Wait for `READABLE`, `WRITABLE` or both of a descriptor from now on."""
        try:
            self._selector.modify(descriptor, events)
        except KeyError:
            self._selector.register(descriptor, events)

    def unregister(self, descriptor: int) -> None:
        """Stop waiting for a descriptor."""
        self._selector.unregister(descriptor)

    def select(self, timeout: float | None) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events."""
        return [(key.fd, events) for key, events in self._selector.select(timeout)]


if sys.platform == "linux":

    class EpollSelector:
        """Linux' epoll, used directly: it takes half the time of the standard library's selector.

        ``poll`` would be slower on a terminal: each call makes the kernel deliver pending input first.
        """

        _EVENTS = tuple(
            (READABLE if event & ~select.EPOLLOUT else 0) | (WRITABLE if event & ~select.EPOLLIN else 0)
            for event in range(2 * select.EPOLLHUP)
        )
        """Events of this module for each combination of epoll's; an error makes a descriptor readable and writable."""

        def __init__(self) -> None:
            self._epoll = select.epoll()
            self._poll = self._epoll.poll
            self.close = self._epoll.close

        def register(self, descriptor: int, events: int) -> None:
            """Wait for `READABLE`, `WRITABLE` or both of a descriptor from now on."""
            wanted = (select.EPOLLIN if events & READABLE else 0) | (select.EPOLLOUT if events & WRITABLE else 0)
            try:
                self._epoll.modify(descriptor, wanted)
            except FileNotFoundError:
                self._epoll.register(descriptor, wanted)

        def unregister(self, descriptor: int) -> None:
            """Stop waiting for a descriptor, which may be closed already."""
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
    """Waits for file descriptors, and optionally spins for at most `SPIN` seconds before it sleeps."""

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
        """Wait until descriptors are ready, and return them with their events; an empty list after the time limit.

        Args:
            patience: time limit in seconds. A wait of days may end earlier.
            may_spin: True if the wait may spin.
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
