"""Which way between an FT232H and the event loop is quickest? `python -m benchmarks.ft232h_ways` uses a virtual chip.

Three ways transfer the same 8 bytes to the chip and 16 back: a call in a thread for each transaction, which writes and
reads; the reading and writing threads of ``ftdi://``; the posted transfers of ``ftdi-async://``. Their runs alternate.
The chip without delays (microframes of 1 us) shows the cost of the way itself, the chip with USB's microframes the time
that a user sees. A stream of answers then compares the throughput of both drivers. A batch of reads on a UART of 12
Mbaud without flow control shows how often they are too late for it.
"""

from __future__ import annotations

import asyncio
import logging
import statistics
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import unity_link
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.transport import parse_url
from unity_link.transport.ft232h import with_libusb, with_pyftdi
from unity_link.transport.ft232h.chip import open_chip
from unity_link.transport.ft232h.transport import StatusStripper
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.ft232h.timing import Timing

if TYPE_CHECKING:
    from collections.abc import Iterator

FRAMING = Codec(GatewayInfo()).framing
REQUEST, ANSWER = FRAMING.checked(b"R0A"), len(FRAMING.checked(b"R0A00000000"))
ROUND_TRIPS = 500
RUNS = 7
BATCHES = 10
URL = parse_url("ftdi://ftdi:232h/1")


class Waiting(asyncio.Protocol):
    """Lets a coroutine wait for a number of bytes."""

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._missing = 0
        self._waiter: asyncio.Future[None] = self._loop.create_future()
        self.ended: asyncio.Future[None] = self._loop.create_future()

    def expect(self, size: int) -> asyncio.Future[None]:
        """Return a future that ends after the next `size` bytes."""
        self._missing = size
        self._waiter = self._loop.create_future()
        return self._waiter

    def data_received(self, data: bytes) -> None:
        """Count the bytes."""
        self._missing -= len(data)
        if self._missing <= 0 and not self._waiter.done():
            self._waiter.set_result(None)

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (none is expected)
        """End the connection."""
        self.ended.set_result(None)


@contextmanager
def chip(microframe: float) -> Iterator[None]:
    """Connect a virtual chip for the duration of the context."""
    device = VirtualFt232h(GatewayBoard(VirtualGateway()), timing=Timing(microframe=microframe))
    with installed(VirtualBus(device)):
        yield


async def hop() -> float:
    """Measure a call in a thread for each transaction; return the seconds of a round trip."""
    loop = asyncio.get_running_loop()
    opened = open_chip(URL)
    strip = StatusStripper().strip

    def transact() -> bytes:
        opened.device.write(opened.out_endpoint, REQUEST, 1000)
        answer = b""
        while len(answer) < ANSWER:
            answer += strip(opened.device.read(opened.in_endpoint, 16384, 1000).tobytes())
        return answer

    times = []
    for _ in range(ROUND_TRIPS):
        start = time.perf_counter()
        await loop.run_in_executor(None, transact)
        times.append(time.perf_counter() - start)
    opened.close()
    return statistics.median(times)


async def driver(module: Any) -> float:
    """Measure a driver; return the seconds of a round trip."""
    protocol = Waiting()
    transport = await module.connect(URL, protocol)
    times = []
    for _ in range(ROUND_TRIPS):
        start = time.perf_counter()
        answered = protocol.expect(ANSWER)
        transport.write(REQUEST)
        await answered
        times.append(time.perf_counter() - start)
    transport.close()
    await protocol.ended
    return statistics.median(times)


async def stream(module: Any) -> float:
    """Measure the throughput of blocks of 255 words; return bytes per second."""
    protocol = Waiting()
    transport = await module.connect(URL, protocol)
    requests, size = b"RM00FF\r" * 50, 50 * (6 + 255 * 8 + 2)
    rates = []
    for _ in range(10):
        start = time.perf_counter()
        answered = protocol.expect(size)
        transport.write(requests)
        await answered
        rates.append(size / (time.perf_counter() - start))
    transport.close()
    await protocol.ended
    return statistics.median(rates)


async def overruns(scheme: str) -> int:
    """Read a batch on a UART; return 1 if bytes were lost, so that the link had to retransmit."""
    logging.getLogger("unity_link.ft232h").setLevel(logging.ERROR)
    url = f"{scheme}://virtual?mode=uart&baud=12000000&receive_fifo_bytes=4096"
    async with unity_link.connect(url) as link:
        await link.read_many([0] * 5000)
        return int(link.statistics.repetitions > 0)


WAYS: dict[str, Any] = {
    "a hop for each transaction": hop,
    "ftdi:// (two threads)": lambda: driver(with_pyftdi),
    "ftdi-async:// (posted transfers)": lambda: driver(with_libusb),
}
STREAMS: dict[str, Any] = {
    "ftdi:// (two threads)": lambda: stream(with_pyftdi),
    "ftdi-async:// (posted transfers)": lambda: stream(with_libusb),
}


def main() -> None:
    """Print the medians of all runs."""
    for microframe in (1e-6, 125e-6):
        results: dict[str, list[float]] = {name: [] for name in WAYS}
        rates: dict[str, list[float]] = {name: [] for name in STREAMS}
        for _ in range(RUNS):
            for name, way in WAYS.items():
                with chip(microframe):
                    results[name].append(asyncio.run(way()))
            for name, way in STREAMS.items():
                with chip(microframe):
                    rates[name].append(asyncio.run(way()))
        print(f"microframes of {microframe * 1e6:g} us")
        for name, times in results.items():
            print(f"  {name:<34}{statistics.median(times) * 1e6:7.0f} us a round trip")
        for name, values in rates.items():
            print(f"  {name:<34}{statistics.median(values) / 1e6:7.2f} MB/s")
    print("a UART of 12 Mbaud")
    for scheme in ("ftdi", "ftdi-async"):
        spoilt = sum(asyncio.run(overruns(scheme)) for _ in range(BATCHES))
        print(f"  {scheme + '://':<34}{spoilt:7} of {BATCHES} batches lost bytes")


if __name__ == "__main__":
    main()
