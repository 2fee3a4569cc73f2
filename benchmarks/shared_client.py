"""One of the programs that share a link: ``shared_client.py URL SECONDS WAY``.

Prints a line when it is connected, waits for a line on its standard input, reads for SECONDS, and prints the number of
words per second. WAY is ``tasks`` (64 tasks, each reading in a loop), ``batch`` (`read_many`) or ``lone`` (one read at
a time).
"""

from __future__ import annotations

import asyncio
import sys
import time
from typing import TYPE_CHECKING

import unity_link

if TYPE_CHECKING:
    from unity_link import Link

TASKS = 64
BATCH = 1024


async def read_until(link: Link, end: float, way: str) -> int:
    """Read until `end` on the clock of `time.perf_counter`; return the number of words."""
    count = 0
    while time.perf_counter() < end:
        if way == "batch":
            count += len(await link.read_many([0x0A] * BATCH))
        else:
            await link.read(0x0A)
            count += 1
    return count


async def main(url: str, seconds: float, way: str) -> None:
    """Connect, wait for a line, read, and print the rate."""
    async with unity_link.connect(url, timeout=60) as link:
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.readline)
        start = time.perf_counter()
        tasks = TASKS if way == "tasks" else 1
        counts = await asyncio.gather(*[read_until(link, start + seconds, way) for _ in range(tasks)])
        print(sum(counts) / (time.perf_counter() - start), flush=True)


asyncio.run(main(sys.argv[1], float(sys.argv[2]), sys.argv[3]))
