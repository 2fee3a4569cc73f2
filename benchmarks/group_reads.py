"""How much does a group of a spec cost: 72 values of the walker, compared with a bare `read_many` of their words?"""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING

import unity_link
from benchmarks.measure import Row, compare
from benchmarks.responder import responder
from unity_link.data import Group

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

WALKER = Path(__file__).parents[1] / "examples" / "walker.ul"
READS = 300
MOST = 1.5


async def best(work: Callable[[], Awaitable[object]]) -> float:
    """Return the seconds of the quickest of many runs, to exclude other work of the machine."""
    times = []
    for _ in range(READS):
        start = time.perf_counter()
        await work()
        times.append(time.perf_counter() - start)
    return min(times)


async def measure() -> Row:
    """Read all of the walker as typed values, and the same words as an array, through the same link."""
    walker = unity_link.load(WALKER)
    with responder() as path:
        async with unity_link.connect(f"serial:{path}") as link:
            group = Group(walker(link))
            addresses = [proxy.signal.address for proxy in group.proxies]

            async def ours() -> float:
                return await best(group.get)

            async def bare() -> float:
                return await best(lambda: link.read_many(addresses))

            pair = await compare(ours, bare)
    return Row(
        "72 values of a group, beside `read_many` of their words",
        f"{pair.ours * 1e6:.0f} us",
        f"{pair.bare * 1e6:.0f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
