"""A schedule: writes that the gateway executes in given clock cycles."""

from __future__ import annotations

import dataclasses
import functools
from collections import deque
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from unity_link.cores import Model, Verbs
from unity_link.cores.batches import FATES, FRAME, TIME, cycles_to, values_of
from unity_link.cores.clock import ticks_after
from unity_link.cores.timeline import ScheduleRegisters, Timeline, feed_of
from unity_link.errors import ArgumentError, shown
from unity_link.modules import caller_on
from unity_link.protocol.wire.numbers import seconds_from
from unity_link.spec.model import STAGE_BITS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike, NDArray

    from unity_link.cores.clock import TickClock
    from unity_link.cores.lease import Lease
    from unity_link.data.proxies import Proxy
    from unity_link.spec.model import ComponentSpec

_NO_SLACK, _LEAST_SLACK = 2**31 - 1, -(2**31)


class ScheduleVerbs(Verbs):
    """Core API of a SCHEDULE."""

    async def clock(self) -> TickClock:
        """Read the gateway's clock, and return its relation to this machine's clock."""
        return await feed_of(ScheduleRegisters.of(self)).clock()

    def timeline(self, *, lead: float = 0.05, lease: Lease | None = None) -> Timeline:
        """Return a timeline of writes at instants, for an ``async with`` block. Earlier scheduled writes are cancelled.

        Args:
            lead: seconds from the beginning of the block to its first instant.
            lease: lease that guards the written signals; it is kicked while the timeline is fed.

        Raises:
            ArgumentError: if the lead is no number of seconds from 0 on, or is half the range of the schedule's
                clock or more: 10995 s at 50 MHz.
        """
        registers = ScheduleRegisters.of(self)
        what, most = f"the lead of {registers.name} is a number of seconds", registers.reach_seconds
        seconds = seconds_from(lead, f"{what} from 0 on", zero=True)
        if seconds >= most:
            raise ArgumentError(f"{what} below {most:.0f}, half the range of its clock, not {shown(lead)}")
        return Timeline(registers, seconds, lease)

    async def play(
        self,
        times: ArrayLike,
        values: Mapping[Any, ArrayLike],
        *,
        then: Literal["hold", "safe"] = "hold",
        lead: float = 0.05,
        lease: Lease | None = None,
    ) -> int:
        """Write a trajectory, each of its rows in the clock cycle nearest to its time.

        Args:
            times: seconds from the beginning, increasing; shape (rows,).
            values: the values of each signal, shape (rows,). All values are checked before the first is sent.
            then: ``"hold"``: the last values stay. ``"safe"``: the lease is disarmed after the last row.
            lead: seconds from now to time 0.
            lease: lease that guards the written signals; it is kicked in the meantime.

        Returns:
            The number of executed rows, which is that of all rows.

        Raises:
            ArgumentError: for times that do not increase, values that signals cannot have, or arrays of other shapes.
            LateError: if a row was not executed. Later rows are cancelled.
            NotArmedError: if a row was not executed because the lease is not armed.
        """
        registers = ScheduleRegisters.of(self)
        if then not in {"hold", "safe"}:
            raise ArgumentError(f"then={then!r:.40}: 'hold' or 'safe' was expected")
        if then == "safe" and registers.lease is None:
            raise ArgumentError(f"no lease guards the signals of {registers.name}, so then='safe' has no effect")
        instants = _rising(times)
        # Check the last instant before anything is sent: it is the largest, and must be in the range of a clock.
        ticks_after(TIME, instants[-1], registers.link.gateway.clock_hz)
        columns: dict[int, NDArray[np.uint64]] = {}
        for proxy, column in values.items():
            columns |= _columns(registers, proxy, column, len(instants))
        async with self.timeline(lead=lead, lease=lease) as line:
            start, poster = line.instant, caller_on(registers.link)
            for row, seconds in enumerate(instants):
                words, at = {place: int(column[row]) for place, column in columns.items()}, start.after(seconds)
                await line.approach(at)
                await line.put(words, at, poster)
            acted = await line.flush()
        if then == "safe":
            await registers.robot[f"{registers.lease}.disarm"].set(1)
        return acted


def _rising(times: ArrayLike) -> list[float]:
    """Return times as a list of numbers.

    Raises:
        ArgumentError: for times that do not increase, begin before 0, or are no numbers in one dimension.
    """
    try:
        given = np.asarray(times)
        seconds = given.astype(np.float64) if given.dtype.kind in "iufO" else np.empty(0)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"times are numbers of seconds, not {shown(times)}") from None
    rises = seconds.ndim == 1 and len(seconds) and np.isfinite(seconds).all() and seconds[0] >= 0
    if not rises or not (np.diff(seconds) > 0).all():
        raise ArgumentError(f"times are numbers of seconds from 0 on that rise, in one dimension, not {shown(times)}")
    numbers: list[float] = seconds.tolist()
    return numbers


def _columns(
    registers: ScheduleRegisters, proxy: Proxy[Any], values: ArrayLike, rows: int
) -> dict[int, NDArray[np.uint64]]:
    """Return the words that a column of values puts on the stage, by their places; each of shape (rows,)."""
    signal = registers.timed(proxy)
    given = signal.kind.array(values)
    if given.shape != (rows,):
        raise ArgumentError(f"{signal.path} has values of shape {given.shape}, and there are {rows} times")
    if given.dtype.kind in "iuf" and len(beyond := given[~((signal.limits[0] <= given) & (given <= signal.limits[1]))]):
        raise signal.beyond_limits(beyond[0].item())
    raws = signal.kind.encode_array(values)
    return {
        place: raws >> np.uint64(part * STAGE_BITS) & np.uint64((1 << STAGE_BITS) - 1)
        for part, place in enumerate(registers.places[signal.path])
    }


@dataclasses.dataclass
class _Batch:
    """A batch that has been received, or is being received."""

    header: int
    is_good: bool
    """False for a batch that is refused."""
    rest: list[int] = dataclasses.field(default_factory=list)
    came: int = 0
    """Clock cycle in which its last word arrived."""

    @property
    def words(self) -> int:
        """Number of words of its runs, from the header."""
        return self.header >> 24

    @property
    def queued(self) -> int:
        """Number of words that it occupies in the queue; 0 if it is refused."""
        return self.words + FRAME if self.is_good else 0

    @functools.cached_property
    def values(self) -> dict[int, int] | None:
        """Words by their places on the stage, after the batch is complete; None if it is malformed."""
        return values_of(self.rest[1:])

    @property
    def instant(self) -> int:
        """Clock cycle in which the batch is executed, modulo `TIME`."""
        return (self.header & 0xFF) << 32 | self.rest[0]


class ScheduleModel(Model):
    """A cycle-accurate schedule on `sim:`, except for one cycle of bus latency."""

    def __init__(self, component: ComponentSpec, part: Any, around: Any) -> None:
        super().__init__(component, part, around)
        self._depth = int(self.generics.get("depth", 1024))
        self._begin()

    def _begin(self) -> None:
        self._coming: _Batch | None = None
        self._ended: deque[_Batch] = deque()
        """Batches that have been received and are not finished."""
        self._free = 0
        """Clock cycle from which the next batch is read from the queue."""
        self._finished = self._failed = self._late = self._refused = 0
        self._slack = _NO_SLACK
        self._words = 0
        """Number of words in the queue of the batches that are not refused."""
        self._show()

    def reset(self) -> None:
        """Empty the queue."""
        self._begin()

    @property
    def due(self) -> int | None:
        """Clock cycle after the end of the next batch; for a batch that is executed, this is its instant."""
        return self._end_of(self._ended[0])[0] + 1 if self._ended else None

    def step(self, dt: float) -> None:
        """Finish the batches whose last cycle has passed."""
        while self._ended:
            cycle, how, values = self._end_of(self._ended[0])
            if cycle >= self.around.now:
                break
            self._words -= self._ended.popleft().queued
            self._free = cycle + 1
            self._finished = (self._finished + 1) % (1 << 16)
            self._failed = (self._failed << 1 | (how != "acts")) % (1 << FATES)
            self._late += how == "late"
            self._refused += how == "refused"
            if how == "acts":
                self.around.commit(values)
        self._show()

    def _begins(self, batch: _Batch) -> int:
        """Return the clock cycle from which a batch is read from the queue, if it is the next one."""
        return max(self._free, batch.came + 1)

    def _end_of(self, batch: _Batch) -> tuple[int, str, dict[int, int]]:
        """Return the last clock cycle of a batch if it is the next one, its outcome, and its values."""
        begins = self._begins(batch)
        if not batch.is_good:
            return begins + 1, "refused", {}
        values = batch.values
        waits = begins + batch.words + FRAME + 2
        if values is None:
            return waits - 1, "refused", {}
        left = cycles_to(batch.instant, waits)
        return (waits + left - 1, "acts", values) if left >= FRAME else (waits + 1, "late", {})

    @property
    def is_empty(self) -> bool:
        """True if the queue has no batch that is still to be executed."""
        return not any(batch.is_good for batch in self._ended)

    def written(self, name: str) -> None:
        """Accept a word of a batch, or cancel all batches."""
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
        """Refuse all batches that have not been executed."""
        if self._coming is not None:
            self._coming.is_good = False
        self._void()

    def _void(self) -> None:
        if self._ended and self._ended[0].is_good and self._begins(self._ended[0]) < self.around.now:
            self._free = self.around.now + 1
        for batch in self._ended:
            batch.is_good = False
        self._words = 0

    def _take(self, word: int) -> None:
        batch, now = self._coming, self.around.now
        if batch is None:
            words = word >> 24
            fits = words + FRAME <= self._depth - self._unread()
            is_good = fits and words > 0 and not word >> 8 & 0xFFFF and self.around.is_armed
            self._coming = _Batch(word, is_good and not self.around.is_finishing)
            return
        batch.rest.append(word)
        if len(batch.rest) <= batch.words:
            return
        batch.came, self._coming = now, None
        batch.is_good = batch.is_good and not self.around.is_finishing
        self._ended.append(batch)
        self._words += batch.queued
        if batch.is_good:
            self._slack = min(self._slack, max(cycles_to(batch.instant, now), _LEAST_SLACK))
        self._show()

    def _unread(self) -> int:
        """Return the number of words in the queue that the core has not read."""
        unread = self._words
        if self._ended and self._ended[0].is_good:
            first = self._ended[0]
            read = self.around.now - self._begins(first) - 1
            unread -= min(max(read, 0), first.words + 1)
        return unread

    def _show(self) -> None:
        self.show(
            clock=self.around.now,
            fates=self._failed << 16 | self._finished,
            late=self._late % (1 << 32),
            refused=self._refused % (1 << 32),
            slack=self._slack,
            room=self._depth - self._unread(),
        )
