"""How many published samples a second reach an `async for`?"""

from __future__ import annotations

import time

import unity_link
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import BareLoop, responder

SAMPLES = 100_000
LEAST = 80_000
_PUBLISH = len("P00000A0A0A0A00\n")


async def measure() -> Row:
    """Compare a subscription, whose gateway publishes as fast as the wire takes it, with counting the same bytes."""
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:
                options = {"divisor": 1, "timestamps": False, "overflow": "fail", "buffer": 100_000}
                async with link.subscribe([0x0A], **options) as samples:  # type: ignore[arg-type]
                    start, received = time.perf_counter(), 0
                    async for sample in samples:
                        if sample.lost:
                            raise RuntimeError(f"{sample.lost} samples were lost")
                        received += 1
                        if received == SAMPLES:
                            return (time.perf_counter() - start) / SAMPLES
            raise RuntimeError("the stream of samples ended")

        async def bare() -> float:
            loop = BareLoop(path)
            loop.send(b"gs00000100010" + b"10A00\ngn010000\n")
            taken = await seconds(loop.receive(SAMPLES * _PUBLISH)) / SAMPLES
            loop.send(b"gx020000\n")
            loop.close()
            return taken

        return rate_row("Samples of one word by `async for`", "samples", await compare(ours, bare), LEAST)
