"""A schedule: writes that happen in the clock cycles that a program gives them."""

from __future__ import annotations

import dataclasses
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.cores import Model

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from unity_link.spec.model import ComponentSpec

TIME = 1 << 40
"""Instants are modulo this."""
FRAME = 2
"""Words of a batch beside its runs: a header, and the lower part of the instant."""
MOST_WORDS = 255
"""Words that the runs of a batch can have."""
FATES = 48
"""Batches whose end can be read."""
_NO_SLACK, _LEAST_SLACK = 2**31 - 1, -(2**31)


def batch_of(instant: int, words: Mapping[int, int]) -> list[int]:
    """Return the words of a batch.

    Args:
        instant: cycle of the clock in which the values stand in their registers.
        words: 32 bits for each place on the stage.
    """
    runs: list[int] = []
    head = previous = -1
    for place in sorted(words):
        if place != previous + 1 or head < 0:
            head = len(runs)
            runs.append(place)
        runs[head] += 1 << 16
        runs.append(words[place])
        previous = place
    instant %= TIME
    return [len(runs) << 24 | instant >> 32, instant & 0xFFFF_FFFF, *runs]


def _values_of(runs: Sequence[int]) -> dict[int, int] | None:
    """Return the words of runs by their places on the stage; None where they are malformed."""
    values: dict[int, int] = {}
    rest = list(runs)
    while rest:
        count, first = rest[0] >> 16, rest[0] & 0xFFFF
        if not 0 < count < len(rest):
            return None
        values |= {(first + index) % (1 << 16): word for index, word in enumerate(rest[1 : count + 1])}
        rest = rest[count + 1 :]
    return values


def _left(instant: int, now: int) -> int:
    """Return the cycles to an instant, negative for one that has passed."""
    return (instant - now + TIME // 2) % TIME - TIME // 2


@dataclasses.dataclass
class _Batch:
    """A batch that has come, or is coming."""

    header: int
    is_good: bool
    """False for one that is refused."""
    rest: list[int] = dataclasses.field(default_factory=list)
    came: int = 0
    """Cycle of its last word."""

    @property
    def words(self) -> int:
        """Words of its runs, as the header counts them."""
        return self.header >> 24

    @property
    def size(self) -> int:
        """Words that it takes in the queue."""
        return self.words + FRAME

    @property
    def instant(self) -> int:
        """Cycle in which it acts, modulo `TIME`."""
        return (self.header & 0xFF) << 32 | self.rest[0]


class ScheduleModel(Model):
    """A schedule on `sim:`, to the cycle as the entity has it, but for the cycle that a word takes from the bus."""

    def __init__(self, component: ComponentSpec, part: Any, around: Any) -> None:
        super().__init__(component, part, around)
        self._depth = int(self.generics.get("depth", 1024))
        self._begin()

    def _begin(self) -> None:
        self._coming: _Batch | None = None
        self._ended: deque[_Batch] = deque()
        """Batches that have come and are not finished."""
        self._free = 0
        """Cycle from which the next one is taken."""
        self._finished = self._failed = self._late = self._refused = 0
        self._slack = _NO_SLACK
        self._show()

    def reset(self) -> None:
        """Void the queue."""
        self._begin()

    @property
    def due(self) -> int | None:
        """Return the cycle behind the end of the next batch: its instant, for one that acts."""
        return self._end_of(self._ended[0])[0] + 1 if self._ended else None

    def step(self, dt: float) -> None:  # noqa: ARG002  (the clock says more)
        """End the batches whose cycles have passed."""
        while self._ended:
            cycle, how, values = self._end_of(self._ended[0])
            if cycle >= self.around.now:
                break
            self._ended.popleft()
            self._free = cycle + 1
            self._finished = (self._finished + 1) % (1 << 16)
            self._failed = (self._failed << 1 | (how != "acts")) % (1 << FATES)
            self._late += how == "late"
            self._refused += how == "refused"
            if how == "acts":
                self.around.commit(values)
        self._show()

    def _end_of(self, batch: _Batch) -> tuple[int, str, dict[int, int]]:
        """Return the cycle in which a batch ends if it is the next one, how it ends, and its values."""
        begins = max(self._free, batch.came + 1)
        if not batch.is_good:
            return begins, "refused", {}
        values = _values_of(batch.rest[1:])
        waits = begins + batch.size
        if values is None:
            return waits, "refused", {}
        left = _left(batch.instant, waits)
        return (waits + left - 1, "acts", values) if left >= FRAME else (waits + 1, "late", {})

    def written(self, name: str) -> None:
        """Take a word, or cancel."""
        if name == "entry":
            self._take(self.part.entry)
        elif name == "cancel":
            if self._coming is not None:
                self._coming.is_good, self._coming.came = False, self.around.now
                self._ended.append(self._coming)
                self._coming = None
            self._slack = _NO_SLACK
            self._void()
        self._show()

    def disarmed(self) -> None:
        """Refuse all that has not acted."""
        if self._coming is not None:
            self._coming.is_good = False
        self._void()

    def _void(self) -> None:
        for batch in self._ended:
            if batch.is_good:
                batch.is_good, batch.came = False, self.around.now

    def _take(self, word: int) -> None:
        batch, now = self._coming, self.around.now
        if batch is None:
            words = word >> 24
            fits = words + FRAME <= self._depth - self._unread()
            is_good = fits and words > 0 and not word >> 8 & 0xFFFF and self.around.is_armed
            self._coming = _Batch(word, is_good)
            return
        batch.rest.append(word)
        if len(batch.rest) <= batch.words:
            return
        batch.came, self._coming = now, None
        self._ended.append(batch)
        if batch.is_good:
            self._slack = min(self._slack, max(_left(batch.instant, now), _LEAST_SLACK))

    def _unread(self) -> int:
        """Return the words in the queue."""
        unread = sum(batch.size for batch in self._ended if batch.is_good)
        if self._ended and self._ended[0].is_good:
            first = self._ended[0]
            read = self.around.now - max(self._free, first.came + 1)
            unread -= min(max(read, 0), first.words + 1)
        return unread

    def _show(self) -> None:
        part = self.part
        part.clock = self.around.now
        part.fates = self._failed << 16 | self._finished
        part.late, part.refused, part.slack = self._late % (1 << 32), self._refused % (1 << 32), self._slack
        part.room = self._depth - self._unread()
