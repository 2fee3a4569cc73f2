"""How many reads a second does a program with 64 links reach, each to a gateway of its own?"""

from __future__ import annotations

import asyncio
import time
from contextlib import AsyncExitStack

import unity_link
from benchmarks.concurrent_reads import REQUEST, RESPONSE
from benchmarks.expected import ADDRESS, expect
from benchmarks.measure import Row, compare
from benchmarks.responder import BareLoop, responders

LINKS = 64
READS = 6400
"""Total number of reads."""
LEAST = 0.6


async def over_links(paths: list[str]) -> float:
    """Read from each pseudo-terminal over a link of its own, in tasks; return the seconds of a read."""
    reads = READS // len(paths)
    async with AsyncExitStack() as stack:
        links = [await stack.enter_async_context(unity_link.connect(f"serial:{path}", timeout=60)) for path in paths]
        for link in links:
            expect(await link.read(ADDRESS))

        async def task(link: unity_link.Link) -> None:
            for _ in range(reads):
                await link.read(ADDRESS)

        start = time.perf_counter()
        await asyncio.gather(*map(task, links))
        return (time.perf_counter() - start) / (len(paths) * reads)


async def over_loops(paths: list[str]) -> float:
    """Transfer the same bytes over each pseudo-terminal, in bare tasks; return the seconds of a read."""
    reads = READS // len(paths)
    loops = [BareLoop(path) for path in paths]

    async def task(loop: BareLoop) -> None:
        for _ in range(reads):
            loop.send(REQUEST)
            await loop.receive(len(RESPONSE))

    start = time.perf_counter()
    await asyncio.gather(*map(task, loops))
    taken = (time.perf_counter() - start) / (len(paths) * reads)
    for loop in loops:
        loop.close()
    return taken


async def measure() -> Row:
    """Compare 64 links, with a reading task on each, with bare loops; and both with their results for one."""
    with responders(LINKS) as paths:
        pair = await compare(lambda: over_links(paths), lambda: over_loops(paths))
        one = await compare(lambda: over_links(paths[:1]), lambda: over_loops(paths[:1]))
    return Row(
        f"Reads over {LINKS} links at once, a task on each",
        f"{1 / pair.ours:,.0f} reads/s, {one.ours / pair.ours:.0%} of one's",
        f"{1 / pair.bare:,.0f} reads/s, {one.bare / pair.bare:.0%} of one's",
        f"{pair.ratio:.2f}",
        f"at least {LEAST:.0%} of the bare loop's",
        1 / pair.ratio >= LEAST,
        pair.processor,
    )
