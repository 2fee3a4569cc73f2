"""How much does decoding cost for samples of a whole robot, as in bridges and recorders?"""

from __future__ import annotations

import time
from pathlib import Path

import unity_link
from benchmarks.measure import Row, compare
from benchmarks.responder import responder

WALKER = Path(__file__).parents[1] / "examples" / "walker.ul"
SAMPLES = 30_000
MOST = 2
_OPTIONS = {"divisor": 1, "timestamps": False, "overflow": "fail", "buffer": 100_000}


async def measure() -> Row:
    """Compare batches with a column for each of 36 values with batches of words, as fast as the line transfers them."""
    walker = unity_link.load(WALKER)
    with responder() as path:

        async def ours() -> float:
            async with unity_link.connect(f"serial:{path}") as link:
                group = walker(link).groups["state"]
                async with group.subscribe(**_OPTIONS) as samples:  # type: ignore[arg-type]
                    start, received = time.process_time(), 0
                    while received < SAMPLES:
                        batch = await samples.take()
                        received += len(next(iter(batch.columns.values())))
                    return (time.process_time() - start) / received

        async def bare() -> float:
            async with unity_link.connect(f"serial:{path}") as link:
                addresses = walker.interface.groups[0].addresses
                async with link.subscribe(addresses, **_OPTIONS) as samples:  # type: ignore[arg-type]
                    start, received = time.process_time(), 0
                    while received < SAMPLES:
                        received += len(await samples.take())
                    return (time.process_time() - start) / received

        pair = await compare(ours, bare)
    return Row(
        "Samples of 36 values in columns, beside their words alone (time of this process)",
        f"{1 / pair.ours:,.0f} samples/s",
        f"{1 / pair.bare:,.0f} samples/s",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
