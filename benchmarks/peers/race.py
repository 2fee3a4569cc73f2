"""Shared by all races: contenders on one medium that do the same work in turn, and their results.

The machine is shared and noisy, so the results are ratios within one round, in which every contender runs once; the
figures shown with them are medians over the rounds.
"""

from __future__ import annotations

import statistics
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from benchmarks.measure import processor_seconds

if TYPE_CHECKING:
    from collections.abc import Callable

RESPONDERS = Path(__file__).with_name("responders.c")
"""Source of the peers' responders."""
BLOCK = 65_536


class Size(msgspec.Struct, frozen=True):
    """Amount of work in a round."""

    lone: int = 3000
    together: int = 25_600
    queue: int = 100_000
    blocks: int = 8
    """Number of blocks of `BLOCK` words."""


QUICK = Size(lone=100, together=512, queue=2000, blocks=1)


class Contender(msgspec.Struct, frozen=True):
    """One way to do the work of a race."""

    name: str
    run: Callable[[], float]
    """Does the work, and returns its seconds for one unit."""
    beside: str = ""
    """For a peer: name of the contender of ours that does the same in the same kind of program."""
    wire: float = 0.0
    """Bytes of answers on the wire per unit; 0 if they are not shown."""


class Race(msgspec.Struct, frozen=True):
    """The same work by ours and by peers."""

    question: str
    medium: str
    unit: str
    """Unit of a rate; empty if a time is shown."""
    contenders: list[Contender]


class Finish(msgspec.Struct, frozen=True):
    """Result of a contender."""

    question: str
    medium: str
    contender: str
    figure: str
    beside: str
    ratio: float | None
    """Ratio of its speed to ours, median over the rounds; None for ours."""
    load: float
    """Share of a processor that it used, without the responder."""
    wire: float | None = None
    """Ratio of its wire bytes per second to ours, if both are known."""


class Timed(NamedTuple):
    """One run of a contender."""

    seconds: float
    """Seconds for one unit."""
    load: float


def run_race(race: Race, rounds: int) -> list[Finish]:
    """Run all contenders in turn, after one run of each to warm up."""
    for contender in race.contenders:
        contender.run()
    seen = [{contender.name: _timed(contender) for contender in race.contenders} for _ in range(rounds)]
    return [_finish(race, contender, seen) for contender in race.contenders]


def _timed(contender: Contender) -> Timed:
    began, used = time.perf_counter(), processor_seconds()
    seconds = contender.run()
    return Timed(seconds, (processor_seconds() - used) / (time.perf_counter() - began))


def _finish(race: Race, contender: Contender, seen: list[dict[str, Timed]]) -> Finish:
    seconds = statistics.median(runs[contender.name].seconds for runs in seen)
    load = statistics.median(runs[contender.name].load for runs in seen)
    ratio = wire = None
    if contender.beside:
        ratio = statistics.median(runs[contender.beside].seconds / runs[contender.name].seconds for runs in seen)
        ours = next((other.wire for other in race.contenders if other.name == contender.beside), 0.0)
        wire = ratio * contender.wire / ours if ours and contender.wire else None
    figure = _figure(race, contender, seconds)
    return Finish(race.question, race.medium, contender.name, figure, contender.beside, ratio, load, wire)


def _figure(race: Race, contender: Contender, seconds: float) -> str:
    if not race.unit:
        return f"{seconds * 1e6:.1f} µs"
    wire = f", {contender.wire / seconds / 1e6:.0f} MB/s of the wire" if contender.wire else ""
    return f"{1 / seconds:,.0f} {race.unit}/s{wire}"


def median_of(call: Callable[[], object], count: int) -> float:
    """Return the median of the seconds that a call takes."""
    times = []
    for _ in range(count):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def seconds_of(call: Callable[[], object]) -> float:
    """Return the seconds that a call takes."""
    start = time.perf_counter()
    call()
    return time.perf_counter() - start
