"""How many reads a second do 256 tasks on one link reach?"""

from __future__ import annotations

import asyncio

import unity_link
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import GATEWAY, BareLoop, exchange, responder

TASKS = 256
READS_A_TASK = 100
REQUEST, RESPONSE = exchange(GATEWAY, "R", 0x0A, reads=0)
IN_FLIGHT = 128
LEAST = 150_000


async def measure() -> Row:
    """Compare 256 tasks, each reading in a loop, with the same bytes through a bare loop, 128 reads in flight."""
    total = TASKS * READS_A_TASK
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:

                async def task() -> None:
                    for _ in range(READS_A_TASK):
                        await link.read(0x0A)

                return await seconds(asyncio.gather(*[task() for _ in range(TASKS)])) / total

        async def bare() -> float:
            return await seconds(transfer(path, REQUEST, RESPONSE, IN_FLIGHT, total)) / total

        return rate_row("Reads by 256 tasks at once", "reads", await compare(ours, bare), LEAST)


async def transfer(path: str, request: bytes, response: bytes, in_flight: int, total: int) -> None:
    """Transfer requests and responses through a bare loop, with a number of requests in flight."""
    loop = BareLoop(path)
    half = in_flight // 2
    loop.send(request * half)
    for _ in range(total // half - 1):
        loop.send(request * half)
        await loop.receive(len(response) * half)
    await loop.receive(len(response) * half)
    loop.close()
