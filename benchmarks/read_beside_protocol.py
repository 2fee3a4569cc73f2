"""How much does a single read add to an `asyncio.Protocol` that transfers the same bytes on a pseudo-terminal?"""

from __future__ import annotations

import asyncio
import statistics
import time
from io import FileIO

import unity_link
from benchmarks.concurrent_reads import REQUEST, RESPONSE
from benchmarks.expected import ADDRESS, WORD, expect
from benchmarks.measure import Row, compare
from benchmarks.responder import responder

READS = 4000
MOST = 1.15


class RoundTrips(asyncio.Protocol):
    """Writes a fixed request and returns a future of its answer: bytes are counted, and not checked."""

    def __init__(self) -> None:
        self._received = b""
        self._answer: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

    async def open(self, path: str) -> None:
        """Open a pseudo-terminal as two asyncio pipes, one to read and one to write."""
        loop = asyncio.get_running_loop()
        self._reader, _ = await loop.connect_read_pipe(lambda: self, FileIO(path, "r"))
        self._writer, _ = await loop.connect_write_pipe(asyncio.BaseProtocol, FileIO(path, "w"))

    def data_received(self, data: bytes) -> None:
        """Set the result of the future when the answer is complete."""
        self._received += data
        if len(self._received) >= len(RESPONSE):
            self._answer.set_result(self._received)
            self._received = b""

    def ask(self) -> asyncio.Future[bytes]:
        """Send the request, and return the future of its answer."""
        self._answer = asyncio.get_running_loop().create_future()
        self._writer.write(REQUEST)
        return self._answer

    def close(self) -> None:
        """Close the pseudo-terminal."""
        self._reader.close()
        self._writer.close()


async def seconds_of_a_read(path: str, count: int) -> float:
    """Return the median of `count` single reads over a link to a pseudo-terminal, in seconds."""
    async with unity_link.connect(f"serial:{path}") as link:
        expect(await link.read(ADDRESS))
        times = []
        for _ in range(count):
            start = time.perf_counter()
            await link.read(ADDRESS)
            times.append(time.perf_counter() - start)
        return statistics.median(times)


async def measure() -> Row:
    """Compare `await link.read(...)` with the protocol, median of the round trips."""
    with responder() as path:

        async def bare() -> float:
            protocol = RoundTrips()
            await protocol.open(path)
            expect(f"{WORD:08X}".encode() in await protocol.ask(), expected=True)
            times = []
            for _ in range(READS):
                start = time.perf_counter()
                await protocol.ask()
                times.append(time.perf_counter() - start)
            protocol.close()
            return statistics.median(times)

        pair = await compare(lambda: seconds_of_a_read(path, READS), bare)
    return Row(
        "A read, one after the other, beside an `asyncio.Protocol`",
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
