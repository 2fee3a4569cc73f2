"""Posted writes, which have no answer: an ``h`` behind them tells how many of the session have failed.

They are *unfenced* as long as no ``h`` was sent behind them, and *executed* until the answer to one has told how they
ended. Where it counts more failed ones than errors have come, each that is executed is asked for by itself.
"""

from __future__ import annotations

import math
from typing import Generic

from unity_link.protocol.constants import FENCE_DELAY
from unity_link.protocol.ring import Part, R, Ring


class Posts(Generic[R]):
    """Posted writes that were sent and not told as done."""

    __slots__ = ("_bytes", "due", "executed", "failed", "mark", "unfenced")

    def __init__(self) -> None:
        self.unfenced = 0
        self._bytes = 0
        self.due = math.inf
        """Instant at which they are to be confirmed, if there are any."""
        self.mark = 0
        """ID behind the last request that is no posted write, while there are unfenced ones."""
        self.executed: list[Part[R]] = []
        """Parts of runs, in their order."""
        self.failed = 0
        """Number of those whose errors have come, in this session."""

    def sent(self, run: R, now: float) -> None:
        """Record a run of posted writes that is sent."""
        if not self.unfenced:
            self.due, self.mark = now + FENCE_DELAY, run.first
        self.unfenced += run.count
        self._bytes += run.size * run.count

    def sent_behind(self, run: R, after: int) -> None:
        """Record a run that is sent behind unfenced ones, the IDs of which end before `after`."""
        if run.is_fence:
            self.unfenced = self._bytes = 0
            self.due = math.inf
        else:
            self.mark = after

    def need_fence(self, now: float, allowed: int, byte_limit: int | None) -> bool:
        """Return whether they have waited long enough, or are many enough, to be confirmed by an ``h``."""
        many = byte_limit is not None and 4 * self._bytes >= byte_limit
        return self.unfenced > 0 and (many or 4 * self.unfenced >= allowed or now >= self.due)

    def take_executed(self, before: int, ring: Ring[R]) -> list[Part[R]]:
        """Return the executed ones whose IDs are before another, and forget them."""
        mask, half = ring.mask, ring.mask >> 1
        count = sum((before - part.number & mask) <= half for part in self.executed)
        taken, self.executed = self.executed[:count], self.executed[count:]
        return taken
