"""The highest rates at which samples are published without loss, for several lengths: in bursts, and sustained."""

from __future__ import annotations

import asyncio
import math
from typing import TYPE_CHECKING, NamedTuple

from benchmarks.paper.build import MODEL, checked
from benchmarks.paper.results import PublishLimit, Sustained

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from benchmarks.paper.stacks import Stack, StackName
    from benchmarks.paper.workbench import Measure, Workbench

HEAD_BYTES = len(checked(b"P0000"))
"""Bytes of the head of a sample without timestamp: letter, group, sequence number, CRC and line end."""
WORD_BYTES = 8
BURST = 50
"""Number of samples of a burst; buffers in the gateway and on the way store some of them."""
_RING_WORDS = 1024
"""Number of words that the gateway buffers before it loses a sample."""
_BUFFER_BYTES = 1024 + 256 + 65536
"""Bytes of the other buffers: in the chip, in the gateway's FIFO, and in transfers that the program has not read."""
_FLOOD = 1.5
"""Requested rate, as a multiple of the rate that the line transfers, to find the rate of received samples."""


class _Stream(NamedTuple):
    """Results of a subscription."""

    asked: float
    """Requested rate in Hz."""
    arrived: float
    """Rate in Hz of received samples in the second half, when all buffers are full."""
    seconds: float
    samples: int
    lost: int


def measure_limits(bench: Workbench, stack: StackName, sizes: Sequence[int], runs: int = 1) -> Iterator[PublishLimit]:
    """Find the limits for samples of several numbers of words; those with the program's time are the best of `runs`."""
    for words in sizes:
        size = HEAD_BYTES + WORD_BYTES * words
        line = bench.timing.fifo_bytes_per_second / size
        modelled = _find_limit(bench, stack, words, line, host_time=False)
        burst = _find_burst(bench, stack, words, modelled, host_time=False)
        total, burst_total = modelled, burst
        if bench.counts_host_time:
            total = max(_find_limit(bench, stack, words, line, host_time=True) for _ in range(runs))
            burst_total = max(_find_burst(bench, stack, words, total, host_time=True) for _ in range(runs))
        yield PublishLimit(
            stack=stack,
            words=words,
            message_bytes=size,
            line=line,
            burst_modelled=burst,
            burst_total=burst_total,
            modelled=modelled,
            total=total,
        )


def measure_sustained(bench: Workbench, rate: float, seconds: float) -> Sustained:
    """Publish one word at a rate for some seconds, with the program's time."""
    measure = _subscribing(1, _divisor(rate), round(rate * seconds))
    found = bench.run("full stack", "adaptive", measure, host_time=True)
    return Sustained(rate=found.asked, seconds=found.seconds, samples=found.samples, lost=found.lost)


async def rate_of_a_flood(stack: Stack, words: int, rate: float, count: int) -> float:
    """Return the samples per second that are received if more are due."""
    return (await _subscribing(words, _divisor(rate), count)(stack)).arrived


def _find_limit(bench: Workbench, stack: StackName, words: int, line: float, *, host_time: bool) -> float:
    """Measure the received rate of a flood; then request that rate, and lower rates until no sample is lost."""
    # Twice the capacity of all buffers: after them, the received rate is the transferred rate.
    count = round(2 * (_RING_WORDS / words + _BUFFER_BYTES / (HEAD_BYTES + WORD_BYTES * words)))

    def found(rate: float) -> _Stream:
        measure = _subscribing(words, _divisor(rate), count)
        return bench.run(stack, "adaptive", measure, host_time=host_time)

    # Samples arrive in transfers, so the received rate may appear slightly higher than the line's.
    rate = min(found(_FLOOD * line).arrived, line)
    while (stream := found(rate)).lost:
        rate = 0.98 * stream.asked
    return stream.asked


def _find_burst(bench: Workbench, stack: StackName, words: int, sustained: float, *, host_time: bool) -> float:
    """Find the highest burst rate by bisection between the sustained rate and the highest of all."""
    good, bad = _divisor(sustained), 0
    while good - bad > 1:
        divisor = (good + bad) // 2
        stream = bench.run(stack, "adaptive", _subscribing(words, divisor, BURST), host_time=host_time)
        good, bad = (good, divisor) if stream.lost else (divisor, bad)
    return MODEL.base_frequency_hz / good


def _divisor(rate: float) -> int:
    return min(max(math.ceil(MODEL.base_frequency_hz / rate), 1), 0xFFFF)


def _subscribing(words: int, divisor: int, count: int) -> Measure[_Stream]:
    async def measure(stack: Stack) -> _Stream:
        loop = asyncio.get_running_loop()
        async with stack.publishing(list(range(words)), divisor, immediate=False) as samples:
            await anext(samples)
            began = half = loop.time()
            for index in range(count):
                if index == count // 2:
                    half = loop.time()
                await anext(samples)
            ended = loop.time()
            lost = samples.lost
        arrived = (count - count // 2) / (ended - half) if ended > half else math.inf
        return _Stream(MODEL.base_frequency_hz / divisor, arrived, ended - began, count + lost, lost)

    return measure
