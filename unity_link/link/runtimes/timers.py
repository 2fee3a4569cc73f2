"""Timers where there is no event loop."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class PendingCall:
    """Call that is due at a time."""

    def __init__(self, timers: Timers, when: float, function: Callable[[], object]) -> None:
        self._timers = timers
        self.when = when
        self.function = function

    def cancel(self) -> None:
        """Cancel the call."""
        self._timers.drop(self)


class Timers:
    """The timers of a link, of which there are few.

    Args:
        time: the clock, in seconds.
        stir: is called when one is due earlier than all others.
    """

    def __init__(self, time: Callable[[], float], stir: Callable[[], object]) -> None:
        self.due = math.inf
        """Instant at which the first is to be called."""
        self._time = time
        self._stir = stir
        self._pending: list[PendingCall] = []

    def call_at(self, when: float, function: Callable[[], object], /) -> PendingCall:
        """Call a function at a time of the clock, or when `run` is called next."""
        call = PendingCall(self, when, function)
        self._pending.append(call)
        if when < self.due:
            self.due = when
            self._stir()
        return call

    def drop(self, call: PendingCall) -> bool:
        """Forget a call, and return whether it was still to be made."""
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
