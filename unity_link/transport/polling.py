"""Waiting for file descriptors without an event loop: ``select.poll``, or as much of it as Windows has."""

from __future__ import annotations

import select

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


def new_poll() -> select.poll | SelectPoll:
    """Return what waits on this system."""
    return select.poll() if hasattr(select, "poll") else SelectPoll()
