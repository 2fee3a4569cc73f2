"""Text and compact frames compared through the full stack: rates of bursts and samples on a line."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import msgspec

from benchmarks.paper.media import ASYNCHRONOUS, FORMED, SHARED
from benchmarks.paper.publishing import HEAD_BYTES, WORD_BYTES, rate_of_a_flood
from benchmarks.paper.results import FormFigures
from benchmarks.paper.stacks import FullStack
from benchmarks.paper.throughput import measuring_rate
from benchmarks.paper.workbench import Workbench

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.paper.media import Medium
    from benchmarks.paper.stacks import Access, Stack
    from benchmarks.paper.workbench import Measure

_WORDS = 255
_FLOOD = 3.0
"""Samples that are due, as a multiple of the rate that the line transfers as text."""


def measure_forms(bench: Workbench, count: int, runs: int) -> Iterator[FormFigures]:
    """Measure both forms on the gateware of a bench; on other media, on models and without the program's time.

    Args:
        bench: with the asynchronous FIFO.
        count: accesses of the shorter burst; there are ten times as many samples, and a tenth as many blocks.
        runs: number of runs with the program's time, of which the best counts.
    """
    for medium in FORMED:
        for chosen in (medium, medium.with_compact_frames()):
            of_medium = msgspec.structs.replace(bench, medium=chosen)
            if medium is not ASYNCHRONOUS:
                timing = bench.timing
                if medium is SHARED:
                    timing = msgspec.structs.replace(timing, synchronous_bytes_per_second=medium.bytes_per_second)
                of_medium = Workbench("model", timing, counts_host_time=False, medium=chosen)
            rates = [
                of_medium.best("full stack", [("adaptive", measure)], runs, lambda rate: -rate)[0]
                for measure in _measures(medium, count)
            ]
            for kind, found in enumerate(zip(*rates, strict=True)):
                if kind and not of_medium.counts_host_time:
                    break
                reads, posts, words, samples = found
                yield FormFigures(
                    medium=chosen.name,
                    gateway=of_medium.gateway,
                    compact=chosen.compact,
                    measured=kind > 0,
                    reads=reads,
                    posts=posts,
                    block_words=words,
                    samples=samples,
                )


def _measures(medium: Medium, count: int) -> list[Measure[float]]:
    def burst(access: Access) -> Measure[float]:
        async def measure(stack: Stack) -> float:
            return (await measuring_rate(access, count)(stack))[0]

        return measure

    async def words(stack: Stack) -> float:
        short, long = [await _time_of_blocks(stack, factor * count // 10) for factor in (1, 3)]
        return round(2 * (count // 10) * _WORDS / (long - short), 3)

    async def samples(stack: Stack) -> float:
        due = min(1e6, _FLOOD * medium.bytes_per_second / (HEAD_BYTES + WORD_BYTES))
        return round(await rate_of_a_flood(stack, 1, due, 10 * count), 1)

    return [burst("read"), burst("post"), words, samples]


async def _time_of_blocks(stack: Stack, count: int) -> float:
    assert isinstance(stack, FullStack)
    loop = asyncio.get_running_loop()
    began = loop.time()
    await asyncio.gather(*(stack.link.read_block(0, _WORDS) for _ in range(count)))
    return loop.time() - began
