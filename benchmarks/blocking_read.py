"""How fast are blocking reads, one after the other, compared with a program written with pyserial and a lock?"""

from __future__ import annotations

import asyncio

from benchmarks.expected import ADDRESS, expect
from benchmarks.measure import Row, compare
from benchmarks.peers.by_hand import ByHand
from benchmarks.peers.race import median_of
from benchmarks.responder import responder
from unity_link import blocking

READS = 3000
MOST = 1.1


async def measure() -> Row:
    """Compare `link.read(...)` with the same bytes by pyserial, median of the round trips, as in `bench-peers`."""
    with responder() as path:

        def ours() -> float:
            with blocking.connect(f"serial:{path}") as link:
                expect(link.read(ADDRESS))
                return median_of(lambda: link.read(ADDRESS), READS)

        by_hand = ByHand(path)
        # Blocking code usually runs in a thread without an event loop.
        pair = await compare(
            lambda: asyncio.to_thread(ours), lambda: asyncio.to_thread(by_hand.seconds_of_a_read, READS)
        )
    return Row(
        "A blocking read, one after the other, beside pyserial and a lock",
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
