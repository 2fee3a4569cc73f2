"""How many published samples a second reach an `async for`?"""

from __future__ import annotations

import time

import unity_link
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import GATEWAY, BareLoop, exchange, responder
from unity_link.protocol.wire.messages import Codec

SAMPLES = 100_000
LEAST = 80_000
_CODEC = Codec(GATEWAY)
_PUBLISH = len(_CODEC.framing.checked(_CODEC.publish(0, 0, None, [0])))


async def measure() -> Row:
    """Compare a subscription with counting the same bytes; the gateway publishes as fast as the line transfers."""
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
            loop.send(exchange(GATEWAY, "GS", 0, 0, 1, 1, [0x0A])[0] + exchange(GATEWAY, "GN", 0)[0])
            taken = await seconds(loop.receive(SAMPLES * _PUBLISH)) / SAMPLES
            loop.send(exchange(GATEWAY, "GX", 0)[0])
            loop.close()
            return taken

        return rate_row("Samples of one word by `async for`", "samples", await compare(ours, bare), LEAST)
