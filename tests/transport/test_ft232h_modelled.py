"""The chip's trade-off between latency and throughput, seen by the whole host in simulated time.

The link, the overlapped driver and the virtual chip run on one simulated clock. The tests assert USB times, which are
exact and equal in every run; on a real machine the host's own processing time is added.
"""

from __future__ import annotations

import asyncio
import statistics
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time, run_simulated
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import LoopClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link import Link

URL = "ftdi-async://ftdi:232h/1"
MICROFRAME = 125e-6
ANSWER_BYTES = len("riiiDDDDDDDDcccc\n")
"""Bytes of the answer to a read."""
FIFO_RATE = 8e6
READS = 20_000


@asynccontextmanager
async def linked() -> AsyncIterator[Link]:
    device = VirtualFt232h(GatewayBoard(VirtualGateway()), clock=LoopClock())
    with installed(VirtualBus(device)):
        async with unity_link.connect(URL, timeout=60) as link:
            yield link


async def read_time(mode: Any) -> float:
    """Return the median time of a single read, in seconds."""
    loop = asyncio.get_running_loop()
    async with linked() as link:
        await link.send_immediate(mode)
        times = []
        for index in range(200):
            # Start each read at another offset from the microframes.
            await asyncio.sleep((index * 37 % 125) * 1e-6)
            start = loop.time()
            await link.read(index % 256)
            times.append(loop.time() - start)
        return statistics.median(times)


async def read_rate(mode: Any) -> float:
    """Return the rate of answers in a batch of reads, in bytes per second."""
    loop = asyncio.get_running_loop()
    async with linked() as link:
        await link.send_immediate(mode)
        start = loop.time()
        await link.read_many([index % 256 for index in range(READS)])
        return READS * ANSWER_BYTES / (loop.time() - start)


@pytest.mark.parametrize("mode", ["always", "adaptive"])
def test_a_single_read_takes_at_most_two_microframes(mode: str) -> None:
    assert run_simulated(read_time(mode)) <= 2 * MICROFRAME + 1e-9


def test_a_single_read_without_send_immediate_waits_for_the_latency_timer() -> None:
    assert 0.010 < run_simulated(read_time("off")) <= 0.016 + 3 * MICROFRAME


@pytest.mark.slow
def test_adaptive_has_the_latency_of_always_and_the_throughput_of_off() -> None:
    times = {mode: run_simulated(read_time(mode)) for mode in ("always", "adaptive")}
    rates = {mode: run_simulated(read_rate(mode)) for mode in ("off", "adaptive")}
    assert times["adaptive"] <= 1.05 * times["always"]
    assert rates["adaptive"] >= 0.95 * rates["off"]


def test_a_batch_of_reads_fills_nine_tenths_of_the_link() -> None:
    assert run_simulated(read_rate("adaptive")) >= 0.9 * FIFO_RATE


@on_simulated_time
async def test_posted_writes_fill_the_link() -> None:
    loop = asyncio.get_running_loop()
    async with linked() as link:
        start = loop.time()
        for index in range(READS):
            await link.post(index % 256, index)
        await link.fence()
        # `ws`, ID, address, word, CRC and line end.
        assert READS * len("wsiiiAADDDDDDDDcccc\n") / (loop.time() - start) >= 0.95 * FIFO_RATE


@pytest.mark.slow
@on_simulated_time
async def test_samples_of_one_word_arrive_at_30_khz_and_none_is_lost() -> None:
    async with linked() as link, link.subscribe(5, rate_hz=30_000, timestamps=False, buffer=100_000) as samples:
        count = 0
        async for _ in samples:
            count += 1
            if count == 30_000:
                break
        assert link.statistics.samples_lost == 0
