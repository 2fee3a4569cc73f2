"""How fast does the gateware run in a process? Cycles and reads per second: `python -m benchmarks.rtl`.

The results depend on the machine's compiler and processor, not on a board: there, pipelined reads keep the transmitter
busy in every cycle.
"""

from __future__ import annotations

import asyncio
import time
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console

import unity_link
from benchmarks.measure import seconds
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual.rtl import RtlGateway

if TYPE_CHECKING:
    from collections.abc import Callable

RUNS = 7
CYCLES = 500_000
READS = 20_000


def quickest(work: Callable[[], object]) -> float:
    """Return the seconds of the quickest of several runs."""
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def cycles_of_reads(gateway: RtlGateway) -> tuple[float, float]:
    """Return the cycles per second while reads are streamed, and the cycles that each read takes."""
    checked = Codec(gateway.info).framing.checked
    requests = b"".join(checked(b"R%02X" % (number % 256)) for number in range(READS))
    before = gateway.cycles
    gateway.receive(requests, 0.0)
    cycles = gateway.cycles - before
    return cycles / quickest(lambda: gateway.receive(requests, 0.0)), cycles / READS


async def link_rate() -> float:
    """Return the reads per second of `read_many` on ``rtl:``."""
    addresses = np.arange(READS) % 256
    async with unity_link.connect("rtl:") as link:
        return READS / min([await seconds(link.read_many(addresses)) for _ in range(RUNS)])


def main() -> None:
    """Measure and print."""
    console = Console()
    gateway = RtlGateway()
    console.print(f"at rest: {CYCLES / quickest(lambda: gateway.run(CYCLES)):,.0f} cycles/s")
    rate, each = cycles_of_reads(gateway)
    console.print(f"streaming reads: {rate:,.0f} cycles/s, {each:.1f} cycles a read: {rate / each:,.0f} reads/s")
    console.print(f"read_many on rtl: {asyncio.run(link_rate()):,.0f} reads/s")


if __name__ == "__main__":
    main()
