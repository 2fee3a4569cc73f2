"""How fast is a single read compared with the quickest possible: a loop that polls for the answer and never sleeps?"""

from __future__ import annotations

import contextlib
import os
import statistics
import time

from benchmarks.concurrent_reads import REQUEST, RESPONSE
from benchmarks.measure import Row, compare
from benchmarks.read_beside_protocol import seconds_of_a_read
from benchmarks.responder import responder

READS = 4000
MOST = 1.5


async def measure() -> Row:
    """Compare `await link.read(...)`, which polls as well, with the same bytes, median of the round trips."""
    with responder() as path:

        async def bare() -> float:
            port = os.open(path, os.O_RDWR | os.O_NONBLOCK | os.O_NOCTTY)
            times = []
            for _ in range(READS):
                start = time.perf_counter()
                os.write(port, REQUEST)
                missing = len(RESPONSE)
                while missing > 0:
                    with contextlib.suppress(BlockingIOError):
                        missing -= len(os.read(port, missing))
                times.append(time.perf_counter() - start)
            os.close(port)
            return statistics.median(times)

        pair = await compare(lambda: seconds_of_a_read(path, READS), bare)
    return Row(
        "A read, one after the other, beside a bare loop that spins, as ours does",
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
