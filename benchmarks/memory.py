"""Does a link need more memory after a million requests than before?"""

from __future__ import annotations

import asyncio
import gc
import tracemalloc

import numpy as np

import unity_link
from benchmarks.measure import Row
from benchmarks.responder import responder

REQUESTS = 1_000_000
MOST_GROWTH = 64 * 1024


async def measure() -> Row:
    """Compare the memory allocated by Python after a tenth of the requests with that after all of them."""
    with responder() as path:
        async with unity_link.connect(f"serial:{path}") as link:
            await _work(link, REQUESTS // 10)
            tracemalloc.start()
            await _work(link, REQUESTS // 100)
            gc.collect()
            before, _ = tracemalloc.get_traced_memory()
            await _work(link, REQUESTS)
            gc.collect()
            after, _ = tracemalloc.get_traced_memory()
            tracemalloc.stop()
    growth = after - before
    return Row(
        "Growth of memory over 10^6 requests",
        f"{growth / 1024:+.1f} KiB",
        "",
        "",
        f"at most {MOST_GROWTH // 1024} KiB",
        growth <= MOST_GROWTH,
    )


async def _work(link: unity_link.Link, requests: int) -> None:
    """Make requests of all frequent kinds; one third each in batches, in tasks, and posted."""
    addresses = np.arange(requests // 3) % 256
    await link.read_many(addresses)

    async def read() -> None:
        for _ in range(requests // 3 // 64):
            await link.read(0x0A)

    await asyncio.gather(*[read() for _ in range(64)])
    for value in range(requests // 3):
        await link.post(0x0A, value)
    await link.fence()
