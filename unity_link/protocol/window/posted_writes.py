"""Posted writes, which have no answer: an ``h`` behind them tells how many of the session have failed.

They are *unfenced* as long as no ``h`` was sent behind them, and *executed* until the answer to one has told how they
ended. Where it counts more failed ones than errors have come, each that is executed is asked for by itself.
"""

from __future__ import annotations

import math
from typing import Generic

from unity_link.protocol.window.constants import FENCE_DELAY
from unity_link.protocol.window.sequence_space import R


class PostedWrites(Generic[R]):
    """Posted writes that were sent and not told as done."""

    __slots__ = ("before", "due", "executed", "failed", "first", "mark", "start", "unfenced")

    def __init__(self) -> None:
        self.unfenced = False
        """True if some are unfenced."""
        self.start = self.mark = 0
        """IDs of the first unfenced one, and behind the last request that is no posted write since, if there are any.
        """
        self.before = 0
        """Characters of all requests before the first unfenced one."""
        self.due = math.inf
        """Instant at which they are to be confirmed, if there are any."""
        self.executed: list[R | None] = []
        """Runs of the executed ones by ID, from `first` on; None for what else was sent between them."""
        self.first = 0
        """ID of the first of `executed`, if there are any."""
        self.failed = 0
        """Number of those whose errors have come, in this session."""

    def begin(self, run: R, now: float) -> None:
        """Record the first posted writes behind the last ``h``."""
        self.unfenced = True
        self.start = self.mark = run.first
        self.before, self.due = run.before, now + FENCE_DELAY

    def sent_behind(self, run: R, after: int) -> None:
        """Record a run that is sent behind unfenced ones, the IDs of which end before `after`."""
        if run.is_fence:
            self.unfenced, self.due = False, math.inf
        else:
            self.mark = after

    def keep(self, number: int, runs: list[R | None], mask: int) -> None:
        """Record those that were executed, by ID from `number` on; None for what else was."""
        if not self.executed:
            self._hold(number, runs, mask)
            return
        self.executed += [None] * ((number - self.first & mask) - len(self.executed))
        self.executed += runs

    def take_executed(self, before: int, mask: int) -> list[R | None]:
        """Return the executed ones whose IDs are from `first` on and before another, and forget them."""
        count = before - self.first & mask
        if count > mask >> 1:
            return []
        taken, rest = self.executed[:count], self.executed[count:]
        self._hold(before, rest, mask)
        return taken

    def _hold(self, number: int, runs: list[R | None], mask: int) -> None:
        """Let the executed ones be these; what stands before the first of them is left out."""
        other = next((place for place, run in enumerate(runs) if run is not None), len(runs))
        self.first, self.executed = number + other & mask, runs[other:]
