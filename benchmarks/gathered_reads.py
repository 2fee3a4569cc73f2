"""How much does a read by `gather` of new coroutines cost, compared with the least possible?"""

from __future__ import annotations

import asyncio

import unity_link
from benchmarks.expected import ADDRESS, WORD, expect
from benchmarks.measure import Row, compare, seconds
from benchmarks.responder import responder

AT_ONCE = 256
ROUNDS = 100
MOST = 1.2


async def measure() -> Row:
    """Compare it with the same `gather` of coroutines that await a finished future, plus a read by a running task.

    The time in which asyncio creates and ends a task is included in both.
    """
    total = AT_ONCE * ROUNDS
    with responder() as path:

        async def gathered() -> float:
            async with unity_link.connect(f"serial:{path}") as link:

                async def work() -> None:
                    for _ in range(ROUNDS):
                        await asyncio.gather(*[link.read(ADDRESS) for _ in range(AT_ONCE)])

                expect(await asyncio.gather(*[link.read(ADDRESS) for _ in range(AT_ONCE)]), AT_ONCE * [WORD])

                return await seconds(work()) / total

        async def least() -> float:
            async with unity_link.connect(f"serial:{path}") as link:

                async def task() -> None:
                    for _ in range(ROUNDS):
                        await link.read(ADDRESS)

                reading = await seconds(asyncio.gather(*[task() for _ in range(AT_ONCE)])) / total
            return reading + await seconds(_gather_what_is_done()) / total

        pair = await compare(gathered, least)
    return Row(
        f"A read by `gather` of {AT_ONCE}, beside a task's read and a `gather` of finished futures",
        f"{pair.ours * 1e6:.2f} us",
        f"{pair.bare * 1e6:.2f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )


async def _gather_what_is_done() -> None:
    done: asyncio.Future[int] = asyncio.get_running_loop().create_future()
    done.set_result(WORD)

    async def read() -> int:
        return await done

    for _ in range(ROUNDS):
        await asyncio.gather(*[read() for _ in range(AT_ONCE)])
