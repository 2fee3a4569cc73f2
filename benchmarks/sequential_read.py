"""How fast are reads, one after the other?"""

from __future__ import annotations

import statistics
import time

import unity_link
from benchmarks.measure import Row, compare
from benchmarks.responder import GATEWAY, BareLoop, exchange, responder

READS = 4000
MOST = 1.25


async def measure() -> Row:
    """Compare `await link.read(...)` with the same bytes through a bare loop, median of the round trips."""
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:
                times = []
                for _ in range(READS):
                    start = time.perf_counter()
                    await link.read(0x0A)
                    times.append(time.perf_counter() - start)
                return statistics.median(times)

        async def bare() -> float:
            request, response = exchange(GATEWAY, "R", 0x0A, reads=0)
            loop = BareLoop(path)
            times = []
            for _ in range(READS):
                start = time.perf_counter()
                loop.send(request)
                await loop.receive(len(response))
                times.append(time.perf_counter() - start)
            loop.close()
            return statistics.median(times)

        pair = await compare(ours, bare)
    return Row(
        "A read, one after the other",
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
