"""Posted writes (``ws``), which have no response, and the fences (``h``) that confirm them.

1. A posted write is *unfenced* until an ``h`` is sent after it.
2. It is *executed* once a response to a later request arrived, until the answer to an ``h`` reports its outcome.
3. The answer to an ``h`` counts all posted writes of the session that failed. If it counts more than error responses
   have arrived, errors are lost, and the window asks for the outcome of each executed one.
"""

from __future__ import annotations

import math
from typing import Generic

from unity_link.protocol.window.constants import FENCE_DELAY
from unity_link.protocol.window.sequence_space import R


class PostedWrites(Generic[R]):
    """Posted writes that were sent, and whose outcomes are not known yet."""

    __slots__ = ("before", "due", "executed", "failed", "first", "mark", "start", "unfenced")

    def __init__(self) -> None:
        self.unfenced = False
        """True if there are unfenced posted writes."""
        self.start = self.mark = 0
        """ID of the first unfenced posted write, and the ID after the last other request sent since (`start` if none).
        """
        self.before = 0
        """Characters of all requests of the session before the first unfenced posted write."""
        self.due = math.inf
        """Instant at which an ``h`` is due for the unfenced posted writes."""
        self.executed: list[R | None] = []
        """Runs of the executed posted writes, one for each ID from `first` on; None for other requests between them."""
        self.first = 0
        """ID of the first item of `executed`."""
        self.failed = 0
        """Number of error responses to posted writes in this session, modulo the number of IDs."""

    def begin(self, run: R, now: float) -> None:
        """Record the first posted writes after the last ``h``."""
        self.unfenced = True
        self.start = self.mark = run.first
        self.before, self.due = run.before, now + FENCE_DELAY

    def sent_after(self, run: R, after: int) -> None:
        """Record another run that is sent while posted writes are unfenced; its IDs end before `after`."""
        if run.is_fence:
            self.unfenced, self.due = False, math.inf
        else:
            self.mark = after

    def keep(self, number: int, runs: list[R | None], mask: int) -> None:
        """Record executed posted writes: one run for each ID from `number` on, None for other requests."""
        if not self.executed:
            self._hold(number, runs, mask)
            return
        self.executed += [None] * ((number - self.first & mask) - len(self.executed))
        self.executed += runs

    def take_executed(self, before: int, mask: int) -> list[R | None]:
        """Return the executed posted writes with IDs from `first` to before `before`, and remove them."""
        count = before - self.first & mask
        if count > mask >> 1:
            return []
        taken, rest = self.executed[:count], self.executed[count:]
        self._hold(before, rest, mask)
        return taken

    def _hold(self, number: int, runs: list[R | None], mask: int) -> None:
        """Set `executed` and `first`, without other requests before the first posted write."""
        others = next((place for place, run in enumerate(runs) if run is not None), len(runs))
        self.first, self.executed = number + others & mask, runs[others:]
