"""Waiting for file descriptors without an event loop: ``select.poll``, or as much of it as Windows has."""

from __future__ import annotations

import math
import os
import select
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

POLLIN, POLLOUT = getattr(select, "POLLIN", 1), getattr(select, "POLLOUT", 4)


class SelectPoll:
    """What is used of ``select.poll``, for systems that have ``select.select`` alone."""

    def __init__(self) -> None:
        self._events: dict[int, int] = {}

    def register(self, descriptor: int, events: int) -> None:
        """Wait for some of `POLLIN` and `POLLOUT` from now on."""
        self._events[descriptor] = events

    def unregister(self, descriptor: int) -> None:
        """Wait for a descriptor no more."""
        del self._events[descriptor]

    def poll(self, patience_ms: float | None) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events, once there are some or the time is over."""
        readable = [descriptor for descriptor, events in self._events.items() if events & POLLIN]
        writable = [descriptor for descriptor, events in self._events.items() if events & POLLOUT]
        seconds = None if patience_ms is None else patience_ms / 1000
        ready_in, ready_out, failed = select.select(readable, writable, writable, seconds)
        found = dict.fromkeys(ready_in, POLLIN)
        # A connection that is refused is told as an exception there.
        for descriptor in {*ready_out, *failed}:
            found[descriptor] = found.get(descriptor, 0) | POLLOUT
        return list(found.items())


SPIN = 100e-6
"""How long to look for what is ready before sleeping, in seconds.

A processor that has gone to sleep for a wait takes 10 to 50 µs to go on, which is as long as a quick gateway takes to
answer. With 30 µs, waits of the benchmark are now shorter, now longer than that.
"""


def new_poll() -> select.poll | SelectPoll:
    """Return what waits on this system."""
    return select.poll() if hasattr(select, "poll") else SelectPoll()


def count_processors() -> int:
    """Return how many processors this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Poller:
    """Waits for file descriptors, and may spin first: look again and again instead of sleeping.

    It spins for at most `SPIN`, and only where the last wait was shorter: for a slow medium it sleeps at once.
    On a single processor, spinning would keep the other side from running.
    """

    def __init__(
        self,
        poll: select.poll | SelectPoll | None = None,
        clock: Callable[[], float] = time.monotonic,
        processors: int | None = None,
    ) -> None:
        self._poll = poll or new_poll()
        self._clock = clock
        self._can_spin = (processors or count_processors()) > 1
        self._last_was_short = False
        self.register, self.unregister = self._poll.register, self._poll.unregister

    def wait(self, patience: float, *, may_spin: bool) -> list[tuple[int, int]]:
        """Return the descriptors that are ready, with their events, once there are some or so many seconds are over."""
        begin = self._clock()
        found: list[tuple[int, int]] = []
        if may_spin and self._last_was_short:
            found = self._spin(begin + min(SPIN, patience))
        if not found:
            left = patience - (self._clock() - begin)
            found = self._poll.poll(None if left == math.inf else max(0, left) * 1000)
        self._last_was_short = self._can_spin and bool(found) and self._clock() - begin < SPIN
        return found

    def _spin(self, end: float) -> list[tuple[int, int]]:
        found = self._poll.poll(0)
        while not found and self._clock() < end:
            found = self._poll.poll(0)
        return found
