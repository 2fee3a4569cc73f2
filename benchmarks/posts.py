"""How many writes a second does a program post, one after the other?"""

from __future__ import annotations

from typing import TYPE_CHECKING

import unity_link
from benchmarks.concurrent_reads import IN_FLIGHT, REQUEST, RESPONSE, transfer
from benchmarks.expected import ADDRESS, expect
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import responder

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from unity_link import Link

POSTS = 50_000
LEAST = 300_000


async def measure() -> Row:
    """Compare posted writes and their `fence` with as many reads through a bare loop, 128 of them in flight."""

    async def post(link: Link) -> None:
        for value in range(POSTS):
            await link.post(ADDRESS, value)

    return await measure_posts("post", POSTS, LEAST, post)


async def measure_posts(method: str, count: int, least: float, post: Callable[[Link], Awaitable[None]]) -> Row:
    """Compare posted writes and their `fence` with as many reads through a bare loop.

    Args:
        method: of the link, for the row.
        count: number of writes; the last one writes this number less one.
        least: minimum number of writes per second.
        post: posts the writes.
    """
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:

                async def work() -> None:
                    await post(link)
                    await link.fence()

                taken = await seconds(work()) / count
                expect(await link.read(ADDRESS), count - 1)
                return taken

        async def bare() -> float:
            return await seconds(transfer(path, REQUEST, RESPONSE, IN_FLIGHT, count)) / count

        return rate_row(f"Writes by `{method}`, beside reads", "writes", await compare(ours, bare), least)
