"""How fast samples can be published with none lost, for messages of several lengths."""

from __future__ import annotations

import asyncio
import math
from typing import TYPE_CHECKING, NamedTuple

from benchmarks.paper.build import checked
from benchmarks.paper.results import PublishLimit, Sustained
from benchmarks.paper.stacks import link_of

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator, Sequence

    from benchmarks.paper.stacks import Stack
    from benchmarks.paper.workbench import Workbench

HEAD_BYTES = len(checked(b"P0000"))
"""Of a publish without timestamp: letter, group, sequence, check and line end."""
WORD_BYTES = 8
_RING_WORDS = 1024
"""Samples of so many words wait in the gateway before one is lost."""
_BUFFER_BYTES = 1024 + 256 + 65536
"""What else may wait: in the chip, in the gateway's FIFO, and in transfers that the program has not taken."""
_FLOOD = 1.5
"""So many times what the line carries is asked for, to see what comes."""


class _Stream(NamedTuple):
    """What came of a subscription."""

    asked: float
    """Hz."""
    arrived: float
    """Hz, in the second half, when all that can be full is full."""
    seconds: float
    samples: int
    lost: int


def measure_limits(bench: Workbench, sizes: Sequence[int], runs: int = 1) -> Iterator[PublishLimit]:
    """Find the limit for messages of so many words each; with the program's time the best of `runs`."""
    for words in sizes:
        size = HEAD_BYTES + WORD_BYTES * words
        line = bench.timing.fifo_bytes_per_second / size
        modelled = _find_limit(bench, words, line, host_time=False)
        total = modelled
        if bench.counts_host_time:
            total = max(_find_limit(bench, words, line, host_time=True) for _ in range(runs))
        yield PublishLimit(words=words, message_bytes=size, line=line, modelled=modelled, total=total)


def measure_sustained(bench: Workbench, rate: float, seconds: float) -> Sustained:
    """Publish one word at a rate for a while, with the program's time."""
    found = bench.run("full stack", _subscribing(1, rate, round(rate * seconds)), host_time=True)
    return Sustained(rate=found.asked, seconds=found.seconds, samples=found.samples, lost=found.lost)


def _find_limit(bench: Workbench, words: int, line: float, *, host_time: bool) -> float:
    """Ask for more than can come; then for what came, and for less until nothing is lost."""
    # Twice what may wait on the way: behind that, what comes is what is taken.
    count = round(2 * (_RING_WORDS / words + _BUFFER_BYTES / (HEAD_BYTES + WORD_BYTES * words)))
    flood = bench.run("full stack", _subscribing(words, _FLOOD * line, count), host_time=host_time)
    # Samples arrive by transfers, so what came can look like a little more than fits.
    rate = min(flood.arrived, line)
    while True:
        found = bench.run("full stack", _subscribing(words, rate, count), host_time=host_time)
        if not found.lost:
            return found.asked
        rate = 0.98 * found.asked


def _subscribing(words: int, rate: float, count: int) -> Callable[[Stack], Coroutine[None, None, _Stream]]:
    async def measure(stack: Stack) -> _Stream:
        link, loop = link_of(stack), asyncio.get_running_loop()
        await link.send_immediate("adaptive")
        base = link.gateway.base_frequency_hz
        divisor = min(max(math.ceil(base / rate), 1), 0xFFFF)
        subscription = link.subscribe(range(words), divisor=divisor, timestamps=False, buffer=1 << 20)
        async with subscription as samples:
            await anext(samples)
            began = half = loop.time()
            for index in range(count):
                if index == count // 2:
                    half = loop.time()
                await anext(samples)
            ended = loop.time()
        arrived = (count - count // 2) / (ended - half)
        return _Stream(base / divisor, arrived, ended - began, count + subscription.lost, subscription.lost)

    return measure
