"""What bursts move: long ones, for the rate, and short ones, for how it is reached."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from benchmarks.paper.results import ACCESSES, MODES, Burst, SendImmediate, Throughput

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator, Sequence

    from benchmarks.paper.stacks import Access, Stack, StackName
    from benchmarks.paper.workbench import Workbench

_LONG = 3
"""The longer burst is so many times the shorter one."""


def measure_throughputs(bench: Workbench, stack: StackName, count: int, runs: int) -> Iterator[Throughput]:
    """Measure all of one stack.

    Reads and writes: by how much longer a long burst takes than a short one, so that the wait for the very last answer
    does not count. Posts: how long a long burst takes, for the wait for its confirmation is their only one.

    Args:
        bench: where.
        stack: through what.
        count: accesses of the shorter burst.
        runs: how often with the program's time, of which the best counts.
    """
    for access in ACCESSES:
        measures = [_measuring_rate(access, mode, count) for mode in MODES]
        for mode, (modelled, total) in zip(MODES, bench.best(stack, measures, runs, max), strict=True):
            yield Throughput(stack=stack, access=access, send_immediate=mode, modelled=modelled, total=total)


def measure_bursts(bench: Workbench, stack: StackName, counts: Sequence[int], runs: int) -> Iterator[Burst]:
    """Measure bursts of reads of several lengths, each `runs` times, of which the best counts."""
    for mode in MODES:
        measure, size = _measuring_bursts(mode, counts, runs), 0
        for count, (seconds, size) in zip(counts, bench.run(stack, measure, host_time=True), strict=True):
            yield Burst(
                stack=stack,
                send_immediate=mode,
                count=count,
                microseconds=seconds * 1e6,
                megabits=8 * size * count / seconds / 1e6,
            )


def _measuring_rate(access: Access, mode: SendImmediate, count: int) -> Callable[[Stack], Coroutine[None, None, float]]:
    async def measure(stack: Stack) -> float:
        await stack.send_immediate(mode)
        # What is done once, at the first time, is not part of any rate.
        await stack.burst(access, count // 10)
        size = 8 * stack.line_bytes[access] * count / 1e6
        long = await _time(stack, access, _LONG * count)
        if access == "post":
            return _LONG * size / long
        return (_LONG - 1) * size / (long - await _time(stack, access, count))

    return measure


def _measuring_bursts(
    mode: SendImmediate, counts: Sequence[int], runs: int
) -> Callable[[Stack], Coroutine[None, None, list[tuple[float, int]]]]:
    async def measure(stack: Stack) -> list[tuple[float, int]]:
        await stack.send_immediate(mode)
        await stack.burst("read", counts[-1])
        found = []
        for count in counts:
            times = []
            for run in range(runs):
                await asyncio.sleep(run * 1e-6 * 125 / runs)
                times.append(await _time(stack, "read", count))
            found.append((min(times), stack.line_bytes["read"]))
        return found

    return measure


async def _time(stack: Stack, access: Access, count: int) -> float:
    loop = asyncio.get_running_loop()
    began = loop.time()
    await (stack.one(access) if count == 1 else stack.burst(access, count))
    return loop.time() - began
