"""Throughput of bursts: long bursts give the rate, and short ones show how it is reached."""

from __future__ import annotations

import asyncio
import statistics
from itertools import pairwise
from typing import TYPE_CHECKING

from benchmarks.paper.results import Burst, Stamps, Throughput
from benchmarks.paper.stacks import ACCESSES, MODES

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from benchmarks.paper.stacks import Access, Mode, Stack, StackName
    from benchmarks.paper.workbench import Measure, Workbench

_LONG = 3
"""Length of the longer burst, as a multiple of the shorter one."""
_BLOCKS = 150
"""Minimum number of blocks; with fewer, the last latency timer has too much influence."""
_PAUSE = 2.0
"""A gap of this multiple of the usual distance of two answers is a pause."""


def measure_throughputs(bench: Workbench, stack: StackName, count: int, runs: int) -> Iterator[Throughput]:
    """Measure all rates of one stack.

    Reads and writes: the time by which a long burst exceeds a short one, so that the wait for the very last answer is
    not included. Posts: the time of a long burst, because they wait only for its confirmation.

    Args:
        bench: runs the measurements.
        stack: the stack to measure.
        count: accesses of the shorter burst; a tenth of it for blocks, which are long.
        runs: number of runs with the program's time, of which the best counts.
    """
    for access in ACCESSES:
        measures = [
            (mode, measuring_rate(access, max(_BLOCKS, count // 10) if access == "block" else count)) for mode in MODES
        ]
        found = bench.best(stack, measures, runs, lambda pair: -pair[0])
        for mode, ((modelled, sizes), (total, _)) in zip(MODES, found, strict=True):
            yield Throughput(
                stack=stack,
                access=access,
                send_immediate=mode,
                request_bytes=sizes[0],
                answer_bytes=sizes[1],
                modelled=modelled,
                total=total,
            )


def measure_bursts(bench: Workbench, stack: StackName, counts: Sequence[int], runs: int) -> Iterator[Burst]:
    """Measure bursts of reads of several lengths, each `runs` times, of which the best counts."""
    for mode in MODES:
        modelled = bench.run(stack, mode, _measuring_bursts(counts, 1), host_time=False)
        total = modelled
        if bench.counts_host_time:
            total = bench.run(stack, mode, _measuring_bursts(counts, runs), host_time=True)
        for count, (without, size), (with_program, _) in zip(counts, modelled, total, strict=True):
            yield Burst(
                stack=stack,
                send_immediate=mode,
                count=count,
                answer_bytes=size,
                modelled=without,
                total=with_program,
            )


def measure_stamps(bench: Workbench, counts: Sequence[int]) -> Iterator[Stamps]:
    """Measure bursts of reads by the gateway's clock, low-level."""
    for mode in MODES:
        for count in counts:
            yield bench.run("low-level", mode, _measuring_stamps(mode, count), host_time=False)


def measuring_rate(access: Access, count: int) -> Measure[tuple[float, tuple[int, int]]]:
    """Return a function that measures the accesses per second of a long burst, and the bytes of one access."""

    async def measure(stack: Stack) -> tuple[float, tuple[int, int]]:
        # Work that is done only once is not part of any rate.
        await stack.burst(access, max(1, count // 10))
        long = await _time(stack, access, _LONG * count)
        if access == "post":
            rate = _LONG * count / long
        else:
            rate = (_LONG - 1) * count / (long - await _time(stack, access, count))
        return round(rate, 3), stack.sizes[access]

    return measure


def _measuring_bursts(counts: Sequence[int], runs: int) -> Measure[list[tuple[float, int]]]:
    async def measure(stack: Stack) -> list[tuple[float, int]]:
        await stack.burst("read", counts[-1])
        found = []
        for count in counts:
            times = []
            for run in range(runs):
                await asyncio.sleep(run * 1e-6 * 125 / runs)
                times.append(await _time(stack, "read", count))
            found.append((round(min(times) * 1e6, 3), stack.sizes["read"][1]))
        return found

    return measure


def _measuring_stamps(mode: Mode, count: int) -> Measure[Stamps]:
    async def measure(stack: Stack) -> Stamps:
        await stack.clocks(count)
        # Not at the beginning of a microframe.
        await asyncio.sleep(40e-6)
        times = [stack.probe.time_of(word) for word in await stack.clocks(count)]
        gaps = [1e6 * (later - earlier) for earlier, later in pairwise(times)]
        usual = statistics.median(gaps)
        places = [place for place, gap in enumerate(gaps) if gap > _PAUSE * usual]
        bits = 8 * stack.sizes["read"][1]
        within = [gap for gap in gaps if gap <= _PAUSE * usual]
        return Stamps(
            send_immediate=mode,
            count=count,
            mean_megabits=round(bits * len(gaps) / sum(gaps), 3),
            run_megabits=round(bits * len(within) / sum(within), 3),
            run_length=round(count / (len(places) + 1), 3),
            pauses=len(places),
            pause_microseconds=(
                round(1e6 * (times[places[-1] + 1] - times[places[0] + 1]) / (len(places) - 1), 3)
                if len(places) > 1
                else 0.0
            ),
        )

    return measure


async def _time(stack: Stack, access: Access, count: int) -> float:
    loop = asyncio.get_running_loop()
    began = loop.time()
    await (stack.one(access) if count == 1 else stack.burst(access, count))
    return loop.time() - began
