"""Shared by all benchmarks: a question, runs that alternate with the bare loop, and a row of the results.

The machine is shared and noisy. So each run of ours is followed by one of the bare loop with the same bytes, and the
result is the median of their ratios; the rates shown with it are medians of the same runs.
"""

from __future__ import annotations

import resource
import statistics
import time
from typing import TYPE_CHECKING

import msgspec

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

RUNS = 7


class Row(msgspec.Struct, frozen=True):
    """One line of RESULTS.md."""

    question: str
    ours: str
    bare: str
    ratio: str
    target: str
    met: bool | None
    """None if the benchmark was not measured."""
    processor: str = ""
    """Processor shares of ours and of the bare loop, without the responder; empty if they were not measured."""


class Pair(msgspec.Struct, frozen=True):
    """Medians over all runs: seconds for one unit of work, the ratio of ours to the bare loop's, and their loads."""

    ours: float
    bare: float
    ratio: float
    ours_load: float
    """Share of a processor that ours used while it ran."""
    bare_load: float

    @property
    def processor(self) -> str:
        """Both loads, for a row."""
        return f"{self.ours_load:.0%}, {self.bare_load:.0%}"


async def compare(ours: Callable[[], Awaitable[float]], bare: Callable[[], Awaitable[float]]) -> Pair:
    """Run both in turn; each returns its seconds for one unit of work."""
    await ours(), await bare()
    pairs = [(await _loaded(ours), await _loaded(bare)) for _ in range(RUNS)]
    times, loads = zip(*(zip(*pair, strict=True) for pair in pairs), strict=True)
    mine, other = zip(*times, strict=True)
    ratio = statistics.median(a / b for a, b in times)
    return Pair(
        statistics.median(mine), statistics.median(other), ratio, *map(statistics.median, zip(*loads, strict=True))
    )


async def _loaded(work: Callable[[], Awaitable[float]]) -> tuple[float, float]:
    """Return the result of a function, and the share of a processor that it used."""
    began, used = time.perf_counter(), processor_seconds()
    given = await work()
    return given, (processor_seconds() - used) / (time.perf_counter() - began)


def processor_seconds() -> float:
    """Return the processor seconds of this process, and of the child processes for which it has waited."""
    usages = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


async def seconds(work: Awaitable[object]) -> float:
    """Return the seconds that an awaitable takes."""
    start = time.perf_counter()
    await work
    return time.perf_counter() - start


def rate_row(question: str, unit: str, pair: Pair, least: float) -> Row:
    """Return the row of a rate with a minimum, in units per second."""
    return Row(
        question,
        f"{1 / pair.ours:,.0f} {unit}/s",
        f"{1 / pair.bare:,.0f} {unit}/s",
        f"{pair.ratio:.2f}",
        f"at least {least:,.0f} {unit}/s",
        1 / pair.ours >= least,
        pair.processor,
    )
