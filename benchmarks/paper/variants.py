"""Other media, and other FIFOs in the gateway: modelled, on the gateway's Python model."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import msgspec

from benchmarks.paper.media import FIFO_SIZES, MEDIA
from benchmarks.paper.publishing import HEAD_BYTES, WORD_BYTES, rate_of_a_flood
from benchmarks.paper.results import MediumFigures, Spread
from benchmarks.paper.stacks import FullStack
from benchmarks.paper.throughput import measuring_rate
from benchmarks.paper.workbench import Workbench

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.paper.media import Medium
    from benchmarks.paper.stacks import Access, Stack
    from benchmarks.paper.workbench import Measure

_STEP, _STEPS = 37, 125
_FLOOD = 1.5


def measure_media(times: int, count: int) -> Iterator[MediumFigures]:
    """Measure each medium with each size of FIFOs, without the program's time.

    Args:
        times: number of single accesses.
        count: accesses of a burst; there are twenty times as many samples.
    """
    for medium in MEDIA:
        for size in FIFO_SIZES:
            chosen = msgspec.structs.replace(medium, fifo_bytes=size)
            bench = Workbench("model", counts_host_time=False, medium=chosen)
            yield bench.run("full stack", "adaptive", _measuring(chosen, times, count), host_time=False)


def _measuring(medium: Medium, times: int, count: int) -> Measure[MediumFigures]:
    async def measure(stack: Stack) -> MediumFigures:
        assert isinstance(stack, FullStack)
        read, write = [await _one(stack, access, times) for access in ("read", "write")]
        answers, sizes = await measuring_rate("read", count)(stack)
        posts, post_sizes = await measuring_rate("post", count)(stack)
        rate = min(1e6, _FLOOD * medium.bytes_per_second / (HEAD_BYTES + WORD_BYTES))
        return MediumFigures(
            medium=medium.name,
            fifo_bytes=medium.fifo_bytes,
            line_megabits=round(8e-6 * medium.bytes_per_second, 4),
            read=read,
            write=write,
            answers_megabits=round(8e-6 * answers * sizes[1], 4),
            posts_megabits=round(8e-6 * posts * post_sizes[0], 4),
            samples=round(await rate_of_a_flood(stack, 1, rate, 20 * count), 1),
            repeated=stack.link.statistics.repetitions,
        )

    return measure


async def _one(stack: Stack, access: Access, times: int) -> Spread:
    """Measure single accesses, at any time."""
    loop, taken = asyncio.get_running_loop(), []
    for index in range(2 + times):
        await asyncio.sleep(index * _STEP % _STEPS * 1e-6)
        began = loop.time()
        await stack.one(access)
        taken.append((loop.time() - began) * 1e6)
    return Spread.of(taken[2:])
