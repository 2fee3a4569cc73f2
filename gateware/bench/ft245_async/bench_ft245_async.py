"""Bench: the asynchronous FT245 layer with a chip model that checks each interval of the datasheet."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge, Timer

from gateware.bench.ft245_async.chip import AsyncChip
from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_PAUSES_NS = (0, 100, 1000)
"""Maximum pauses of a flag of the chip, in ns."""


def _count(most_pause_ns: int) -> int:
    """Return a number of bytes for pauses of this length, because pauses determine the run time."""
    return 60 if most_pause_ns >= 1000 else 200


async def _prepare(dut: SimHandleBase, most_pause_ns: int = 0) -> AsyncChip:
    dut.rx_ready.value = 0
    dut.tx_valid.value = 0
    dut.tx_data.value = 0
    dut.flush.value = 0
    dut.rxf_n.value = 1
    dut.txe_n.value = 1
    await start(dut.clk, dut.rst, 1e9 / int(dut.clock_hz.value))
    return AsyncChip(dut, most_pause_ns=most_pause_ns)


def _sink(dut: SimHandleBase, pause: float = 0.0) -> Sink:
    return Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready, pause=pause)


def _source(dut: SimHandleBase, pause: float = 0.0) -> Source:
    return Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready, pause=pause)


def _data(count: int, seed: int = 11) -> bytes:
    return random.Random(seed).randbytes(count)


async def _flush(dut: SimHandleBase) -> None:
    dut.flush.value = 1
    await RisingEdge(dut.clk)
    dut.flush.value = 0


@cocotb.test
async def bytes_arrive_each_once_and_in_order(dut: SimHandleBase) -> None:
    for most_pause in _PAUSES_NS:
        for core_pause in (0.0, 0.5, 0.9):
            chip = await _prepare(dut, most_pause)
            sink = _sink(dut, core_pause)
            data = _data(_count(most_pause))
            chip.send(data)
            assert await sink.wait_for(len(data)) == [(byte, 0) for byte in data]
            chip.stop()
            sink.stop()


@cocotb.test
async def bytes_leave_each_once_and_in_order(dut: SimHandleBase) -> None:
    for most_pause in _PAUSES_NS:
        for core_pause in (0.0, 0.5, 0.9):
            chip = await _prepare(dut, most_pause)
            data = _data(_count(most_pause))
            await _source(dut, core_pause).send(data)
            await Timer(2 + most_pause / 1000, unit="us")
            assert bytes(chip.from_gateware) == data
            chip.stop()


@cocotb.test
async def both_directions_share_the_bus(dut: SimHandleBase) -> None:
    for most_pause in _PAUSES_NS:
        for core_pause in (0.0, 0.7):
            chip = await _prepare(dut, most_pause)
            sink = _sink(dut, core_pause)
            count = _count(most_pause)
            down, up = _data(count), _data(count, 12)
            chip.send(down)
            await _source(dut, core_pause).send(up)
            # Neither direction may have waited for the end of the other.
            assert len(sink.received) > count // 3
            assert await sink.wait_for(len(down)) == [(byte, 0) for byte in down]
            await Timer(2 + most_pause / 1000, unit="us")
            assert bytes(chip.from_gateware) == up
            chip.stop()
            sink.stop()


@cocotb.test
async def a_full_chip_does_not_keep_bytes_from_arriving(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    chip.most_pause_ns = 1_000_000
    source = cocotb.start_soon(_source(dut).send(_data(4)))
    await Timer(2, unit="us")
    sink = _sink(dut)
    dut.txe_n.value = 1
    chip.stop()
    chip = AsyncChip(dut)
    dut.txe_n.value = 1
    chip.send(_data(20))
    assert await sink.wait_for(20, most_us=100)
    source.cancel()
    chip.stop()


@cocotb.test
async def nobody_drives_the_bus_of_a_chip_that_takes_nothing(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    chip.most_pause_ns = 1_000_000
    source = cocotb.start_soon(_source(dut).send(_data(4)))
    await Timer(4, unit="us")
    written = len(chip.from_gateware)
    assert written < 4
    assert int(dut.data_oe.value) == 0
    # The waiting bytes are sent when the chip accepts them again, and the bus is released after them.
    chip.stop()
    chip = AsyncChip(dut)
    await source
    await Timer(2, unit="us")
    assert bytes(chip.from_gateware) == _data(4)[written:]
    assert int(dut.data_oe.value) == 0
    chip.stop()


@cocotb.test
async def from_50_mhz_on_it_writes_as_fast_as_the_chip_takes_bytes(dut: SimHandleBase) -> None:
    if int(dut.clock_hz.value) < 50_000_000:
        return
    chip = await _prepare(dut)
    data = _data(200)
    await _source(dut).send(data)
    await Timer(2, unit="us")
    mean_ns = (chip.write_times[-1] - chip.write_times[0]) / (len(data) - 1)
    cocotb.log.info("one byte in %.1f ns", mean_ns)
    assert mean_ns <= 125, "the chip takes 8 MB/s"
    chip.stop()


async def _note_flushes(dut: SimHandleBase, flushes: list[int]) -> None:
    """Record the number of accepted bytes at each flush."""
    accepted = 0
    while True:
        await RisingEdge(dut.clk)
        accepted += int(dut.tx_valid.value == 1 and dut.tx_ready.value == 1)
        if dut.flush.value == 1:
            flushes.append(accepted)


@cocotb.test
async def siwu_follows_the_last_byte_before_the_flush(dut: SimHandleBase) -> None:
    for most_pause in _PAUSES_NS:
        chip = await _prepare(dut, most_pause)
        rng = random.Random(13)
        flushes: list[int] = []
        counter = cocotb.start_soon(_note_flushes(dut, flushes))
        source = cocotb.start_soon(_source(dut, 0.3).send(_data(150)))
        while not source.done():
            await ClockCycles(dut.clk, rng.choice((1, 2, 5, 20, 100)))
            await _flush(dut)
        await Timer(3 + most_pause / 1000, unit="us")
        # A flush during a pending one, and a flush without a new byte, are merged with the pending or previous one.
        assert set(chip.flushed_after) <= set(flushes)
        assert chip.flushed_after == sorted(set(chip.flushed_after))
        assert chip.flushed_after[-1] == 150
        assert len(chip.flushed_after) > 5
        assert bytes(chip.from_gateware) == _data(150)
        counter.cancel()
        chip.stop()


@cocotb.test
async def a_flush_without_a_new_byte_does_nothing(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    await _flush(dut)
    await Timer(2, unit="us")
    await RisingEdge(dut.clk)
    assert chip.flushed_after == []
    await _source(dut).send(b"A")
    await _flush(dut)
    await Timer(3, unit="us")
    await _flush(dut)
    await Timer(3, unit="us")
    assert chip.flushed_after == [1]
    chip.stop()


@cocotb.test
async def reset_in_any_state_recovers(dut: SimHandleBase) -> None:
    rng = random.Random(14)
    for _ in range(25):
        chip = await _prepare(dut, 50)
        chip.send(_data(20))
        source = cocotb.start_soon(_source(dut).send(_data(20)))
        sink = _sink(dut)
        await ClockCycles(dut.clk, rng.randrange(40))
        source.cancel()
        sink.stop()
        chip.stop()
        dut.rst.value = 1
        dut.tx_valid.value = 0
        await ClockCycles(dut.clk, 2)
        await ReadOnly()
        assert (dut.rd_n.value, dut.wr_n.value, dut.siwu_n.value, dut.data_oe.value) == (1, 1, 1, 0)
        await RisingEdge(dut.clk)
        chip = await _prepare(dut)
        chip.send(b"AB")
        sink = _sink(dut)
        await _source(dut).send(b"CD")
        assert await sink.wait_for(2) == [(ord("A"), 0), (ord("B"), 0)]
        await Timer(2, unit="us")
        assert bytes(chip.from_gateware) == b"CD"
        chip.stop()
        sink.stop()
