"""Timers for runtimes without asyncio."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class PendingCall:
    """A call that is scheduled for an instant."""

    def __init__(self, timers: Timers, when: float, function: Callable[[], object]) -> None:
        self._timers = timers
        self.when = when
        self.function = function

    def cancel(self) -> None:
        """Cancel the call."""
        self._timers.drop(self)


class Timers:
    """The timers of a link, in a list, because a link has few.

    Args:
        time: the clock, in seconds.
        stir: called after a timer was added that is due before all others.
    """

    def __init__(self, time: Callable[[], float], stir: Callable[[], object]) -> None:
        self.due = math.inf
        """Instant of the next call; infinite without one."""
        self._time = time
        self._stir = stir
        self._pending: list[PendingCall] = []

    def call_at(self, when: float, function: Callable[[], object], /) -> PendingCall:
        """Schedule a function for the first call of `run` at or after an instant of the clock."""
        call = PendingCall(self, when, function)
        self._pending.append(call)
        if when < self.due:
            self.due = when
            self._stir()
        return call

    def drop(self, call: PendingCall) -> bool:
        """Cancel a call; return whether it was still scheduled."""
        if call not in self._pending:
            return False
        self._pending.remove(call)
        self.due = min((other.when for other in self._pending), default=math.inf)
        return True

    def run(self) -> None:
        """Make the calls that are due."""
        now = self._time()
        for call in [call for call in self._pending if call.when <= now]:
            if self.drop(call):
                call.function()
