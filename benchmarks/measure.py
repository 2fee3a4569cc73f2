"""What all benchmarks share: a question, runs that alternate with the bare loop, and a row of the results.

This machine is shared and noisy. So each run of ours is followed by one of the bare loop with the same bytes, and what
counts is the median of their ratios; the rates beside it are medians of the same runs.
"""

from __future__ import annotations

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
    met: bool


class Pair(msgspec.Struct, frozen=True):
    """Medians over all runs: seconds for one unit of work, and the ratio of ours to the bare loop's."""

    ours: float
    bare: float
    ratio: float


async def compare(ours: Callable[[], Awaitable[float]], bare: Callable[[], Awaitable[float]]) -> Pair:
    """Run both in turn; each gives its seconds for one unit of work."""
    await ours(), await bare()
    pairs = [(await ours(), await bare()) for _ in range(RUNS)]
    mine, other = zip(*pairs, strict=True)
    ratio = statistics.median(a / b for a, b in pairs)
    return Pair(statistics.median(mine), statistics.median(other), ratio)


async def seconds(work: Awaitable[object]) -> float:
    """Return how long something takes."""
    start = time.perf_counter()
    await work
    return time.perf_counter() - start


def rate_row(question: str, unit: str, pair: Pair, least: float) -> Row:
    """Return the row of a rate that has a least value, in units a second."""
    return Row(
        question,
        f"{1 / pair.ours:,.0f} {unit}/s",
        f"{1 / pair.bare:,.0f} {unit}/s",
        f"{pair.ratio:.2f}",
        f"at least {least:,.0f} {unit}/s",
        1 / pair.ours >= least,
    )
