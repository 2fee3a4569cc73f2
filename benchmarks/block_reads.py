"""How many words a second does `read_block` reach?"""

from __future__ import annotations

import msgspec

import unity_link
from benchmarks.concurrent_reads import transfer
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import GATEWAY, exchange, responder

WORDS = 65_280
BLOCK = 255
REPEATS = 8
LEAST = 3_000_000


async def measure() -> Row:
    """Compare long blocks with the same bytes through a bare loop."""
    info = msgspec.structs.replace(GATEWAY, address_bits=16)
    request, response = exchange(info, "RM", 0, BLOCK, reads=[0] * BLOCK)
    total = REPEATS * WORDS
    with responder(info) as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:

                async def work() -> None:
                    for _ in range(REPEATS):
                        await link.read_block(0, WORDS)

                return await seconds(work()) / total

        async def bare() -> float:
            return await seconds(transfer(path, request, response, 16, total // BLOCK)) / total

        return rate_row("Words by `read_block`", "words", await compare(ours, bare), LEAST)
