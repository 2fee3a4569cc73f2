"""How many samples a second reach callbacks if the samples of many groups alternate on the line?"""

from __future__ import annotations

import asyncio
import contextlib
import time

import unity_link
from benchmarks.measure import Row, compare, rate_row, seconds
from benchmarks.responder import GATEWAY, BareLoop, exchange, responder
from unity_link.protocol.wire.messages import Codec

GROUPS = 16
SAMPLES = 50_000
LEAST = 100_000
_CODEC = Codec(GATEWAY)
_PUBLISH = len(_CODEC.framing.checked(_CODEC.publish(0, 0, None, [0])))


async def measure() -> Row:
    """Compare callbacks with counting the same bytes; the gateway publishes as fast as the line transfers."""
    with responder() as path:

        async def ours() -> float:
            done: asyncio.Future[None] | None = None
            received = 0

            def take(sample: unity_link.Sample) -> None:
                nonlocal received
                received += 1 + sample.lost
                if done is not None and received >= SAMPLES and not done.done():
                    done.set_result(None)

            async with unity_link.connect(f"serial:{path}") as link, contextlib.AsyncExitStack() as stack:
                for address in range(GROUPS):
                    samples = link.subscribe([address], divisor=1, timestamps=False, callback=take)
                    await stack.enter_async_context(samples)
                # Samples that arrived while the other groups were set up are not counted.
                done = asyncio.get_running_loop().create_future()
                received, start = 0, time.perf_counter()
                await done
                return (time.perf_counter() - start) / SAMPLES

        async def bare() -> float:
            loop = BareLoop(path)
            for group in range(GROUPS):
                loop.send(exchange(GATEWAY, "GS", group, 0, 1, 1, [group])[0] + exchange(GATEWAY, "GN", group)[0])
            taken = await seconds(loop.receive(SAMPLES * _PUBLISH)) / SAMPLES
            loop.send(b"".join(exchange(GATEWAY, "GX", group)[0] for group in range(GROUPS)))
            loop.close()
            return taken

        question = f"Samples of {GROUPS} groups that alternate, to callbacks"
        return rate_row(question, "samples", await compare(ours, bare), LEAST)
