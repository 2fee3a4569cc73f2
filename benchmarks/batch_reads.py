"""How many reads a second does one `read_many` reach?"""

from __future__ import annotations

import numpy as np

import unity_link
from benchmarks.concurrent_reads import IN_FLIGHT, REQUEST, RESPONSE, transfer
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import responder

READS = 200_000
LEAST = 400_000


async def measure() -> Row:
    """Compare one batch with the same bytes through a bare loop, 128 reads in flight."""
    addresses = np.arange(READS) % 256
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:
                return await seconds(link.read_many(addresses)) / READS

        async def bare() -> float:
            return await seconds(transfer(path, REQUEST, RESPONSE, IN_FLIGHT, READS)) / READS

        return rate_row("Reads by `read_many`", "reads", await compare(ours, bare), LEAST)
