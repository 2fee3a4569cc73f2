"""Bench: the synchronous FT245 layer with a chip whose flags become inactive in any cycle."""

from __future__ import annotations

import itertools
import os
import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge, Timer

from gateware.bench.ft245_sync.chip import PERIOD_PS, SyncChip
from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_CLK_NS = float(os.environ["CLK_NS"])
_KIND = os.environ["CHIP"]
_SILENCE_NS = 80 * _CLK_NS
"""Time in ns after which the pins are idle if CLKOUT stops: 64 cycles of clk, and the duration of a poll."""
_FLAGS = ((0.0, 0.0), (0.5, 0.5), (0.1, 0.7), (0.8, 0.1), (0.03, 0.03))
_CORE_PAUSES = ((0.0, 150), (0.5, 150), (0.95, 40))
"""Pauses of the core, and numbers of bytes that show their effect, because pauses determine the run time."""


async def _prepare(dut: SimHandleBase, no_rxf: float = 0.0, no_txe: float = 0.0, txe_high: int = 2) -> SyncChip:
    dut.rx_ready.value = 0
    dut.tx_valid.value = 0
    dut.tx_data.value = 0
    dut.flush.value = 0
    dut.rxf_n.value = 1
    dut.txe_n.value = 1
    chip = SyncChip(dut, no_rxf=no_rxf, no_txe=no_txe, txe_high=txe_high, kind=_KIND)
    await start(dut.clk, dut.rst, _CLK_NS)
    await ClockCycles(dut.clk, 10)
    return chip


def _sink(dut: SimHandleBase, pause: float = 0.0) -> Sink:
    return Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready, pause=pause)


def _source(dut: SimHandleBase, pause: float = 0.0) -> Source:
    return Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready, pause=pause)


def _data(count: int, seed: int = 11) -> bytes:
    return random.Random(seed).randbytes(count)


async def _until_written(chip: SyncChip, count: int, most_us: int = 1000) -> None:
    for _ in range(most_us):
        if len(chip.from_gateware) >= count:
            break
        await Timer(1, unit="us")
    await Timer(20 * PERIOD_PS, unit="ps")


async def _flush(dut: SimHandleBase) -> None:
    dut.flush.value = 1
    await RisingEdge(dut.clk)
    dut.flush.value = 0


@cocotb.test
async def bytes_arrive_each_once_and_in_order(dut: SimHandleBase) -> None:
    for no_rxf, no_txe in _FLAGS:
        for core_pause, count in _CORE_PAUSES:
            chip = await _prepare(dut, no_rxf, no_txe)
            sink = _sink(dut, core_pause)
            data = _data(count)
            chip.to_gateware.extend(data)
            assert await sink.wait_for(len(data)) == [(byte, 0) for byte in data]
            chip.stop()
            sink.stop()


@cocotb.test
async def bytes_leave_each_once_and_in_order(dut: SimHandleBase) -> None:
    for no_rxf, no_txe in _FLAGS:
        for core_pause, count in _CORE_PAUSES:
            chip = await _prepare(dut, no_rxf, no_txe)
            data = _data(count)
            await _source(dut, core_pause).send(data)
            await _until_written(chip, len(data))
            assert bytes(chip.from_gateware) == data
            chip.stop()


@cocotb.test
async def both_directions_share_the_bus(dut: SimHandleBase) -> None:
    for no_rxf, no_txe in _FLAGS:
        for core_pause in (0.0, 0.5):
            chip = await _prepare(dut, no_rxf, no_txe)
            sink = _sink(dut, core_pause)
            # More bytes than one turn, if that is quick to simulate.
            count = 300 if no_txe < 0.1 else 120
            down, up = _data(count), _data(count, 12)
            chip.to_gateware.extend(down)
            await _source(dut, core_pause).send(up)
            assert await sink.wait_for(len(down)) == [(byte, 0) for byte in down]
            await _until_written(chip, len(up))
            assert bytes(chip.from_gateware) == up
            chip.stop()
            sink.stop()


@cocotb.test
async def no_direction_waits_for_the_end_of_the_other(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    _sink(dut)
    chip.to_gateware.extend(_data(3000))
    cocotb.start_soon(_source(dut).send(_data(3000)))
    for _ in range(1000):
        await Timer(1, unit="us")
        if len(chip.read_cycles) > 1000 or len(chip.write_cycles) > 1000:
            break
    # Turns of 256 bytes, if the core is fast enough to request them.
    fewest = 500 if _CLK_NS < PERIOD_PS / 1000 else 200
    assert min(len(chip.read_cycles), len(chip.write_cycles)) > fewest
    chip.stop()


@cocotb.test
async def a_burst_moves_one_byte_in_every_cycle_of_clkout(dut: SimHandleBase) -> None:
    if _CLK_NS > PERIOD_PS / 1000:
        return
    chip = await _prepare(dut)
    sink = _sink(dut)
    data = _data(500)
    chip.to_gateware.extend(data)
    await sink.wait_for(len(data))
    assert chip.read_cycles[-1] - chip.read_cycles[0] == len(data) - 1
    await _source(dut).send(data)
    await _until_written(chip, len(data))
    # A byte every 10 ns into a FIFO that outputs one in 16.7 ns: it never runs empty once it contains two.
    assert chip.write_cycles[-1] - chip.write_cycles[0] <= len(data) + 1
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
    for _, no_txe in _FLAGS:
        chip = await _prepare(dut, 0.0, no_txe)
        rng = random.Random(13)
        flushes: list[int] = []
        counter = cocotb.start_soon(_note_flushes(dut, flushes))
        source = cocotb.start_soon(_source(dut, 0.3).send(_data(150)))
        while not source.done():
            await ClockCycles(dut.clk, rng.choice((1, 2, 5, 20, 40)))
            await _flush(dut)
        await RisingEdge(dut.clk)
        await _until_written(chip, 150)
        # The pulse after the last byte may have to wait for the end of another pulse.
        await Timer(1, unit="us")
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
    await Timer(2, unit="us")
    await _flush(dut)
    await Timer(2, unit="us")
    assert chip.flushed_after == [1]
    chip.stop()


@cocotb.test
async def nothing_is_lost_when_clkout_stops_for_a_while(dut: SimHandleBase) -> None:
    rng = random.Random(16)
    for no_rxf, no_txe in ((0.0, 0.0), (0.3, 0.3)):
        chip = await _prepare(dut, no_rxf, no_txe)
        sink = _sink(dut)
        down, up = _data(600), _data(600, 12)
        chip.to_gateware.extend(down)
        source = cocotb.start_soon(_source(dut).send(up))
        for stop_ns in (100, 3000, _SILENCE_NS, 2 * _SILENCE_NS, 9000, _SILENCE_NS, _SILENCE_NS):
            await Timer(rng.randrange(300, 1700), unit="ns")
            chip.running = False
            await Timer(round(stop_ns), unit="ns")
            chip.running = True
        await source
        assert await sink.wait_for(len(down)) == [(byte, 0) for byte in down]
        await _until_written(chip, len(up))
        assert bytes(chip.from_gateware) == up
        chip.stop()
        sink.stop()


@cocotb.test
async def the_pins_rest_while_clkout_stands_whatever_they_did(dut: SimHandleBase) -> None:
    rng = random.Random(17)
    for round_number in range(8):
        chip = await _prepare(dut)
        sink = _sink(dut)
        if round_number % 2:
            chip.to_gateware.extend(_data(2000))
        else:
            source = cocotb.start_soon(_source(dut).send(_data(2000)))
        await Timer(rng.randrange(1000, 3000), unit="ns")
        chip.running = False
        await Timer(2 * PERIOD_PS, unit="ps")
        assert not chip.at_rest, "nothing was going on"
        await Timer(round(_SILENCE_NS), unit="ns")
        assert chip.at_rest
        await RisingEdge(dut.clk)
        if not round_number % 2:
            source.cancel()
        chip.stop()
        sink.stop()


@cocotb.test
async def nobody_drives_an_idle_bus(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    sink = _sink(dut)
    for _ in range(3):
        await RisingEdge(dut.clk)
        await _source(dut).send(b"A")
        await Timer(2, unit="us")
        assert chip.at_rest
        chip.to_gateware.extend(b"B")
        await Timer(2, unit="us")
        assert chip.at_rest
    # Bytes are waiting, and the chip accepts none.
    chip.no_txe = 1.0
    await RisingEdge(dut.clk)
    await _source(dut).send(b"CD")
    await Timer(2, unit="us")
    assert chip.at_rest
    assert (bytes(chip.from_gateware), len(sink.received)) == (b"AAA", 3)
    chip.stop()
    sink.stop()


@cocotb.test
async def it_begins_when_clkout_starts_late(dut: SimHandleBase) -> None:
    chip = await _prepare(dut)
    for wait_us in (1, 20):
        chip.stop()
        chip = SyncChip(dut, kind=_KIND, running=False)
        sink = _sink(dut)
        await RisingEdge(dut.clk)
        dut.rst.value = 1
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        source = cocotb.start_soon(_source(dut).send(b"AB"))
        await Timer(wait_us, unit="us")
        assert chip.at_rest
        assert not sink.received
        chip.running = True
        chip.to_gateware.extend(b"CD")
        await source
        assert await sink.wait_for(2) == [(ord("C"), 0), (ord("D"), 0)]
        await _until_written(chip, 2)
        assert bytes(chip.from_gateware) == b"AB"
        sink.stop()
    chip.stop()


@cocotb.test
async def a_txe_that_is_high_for_one_cycle_costs_one_byte_twice_and_then_half_the_rate(dut: SimHandleBase) -> None:
    if _CLK_NS > PERIOD_PS / 1000:
        return  # no byte is at the pins when one is refused
    chip = await _prepare(dut, 0.0, 0.05, txe_high=1)
    data = _data(600)
    await _source(dut).send(data)
    await _until_written(chip, len(data) + 1)
    first = next(index for index, byte in enumerate(chip.from_gateware) if byte != data[index])
    assert bytes(chip.from_gateware) == data[:first] + data[first + 1 : first + 2] + data[first:]
    behind = chip.write_cycles[first + 3 :]
    assert min(later - sooner for sooner, later in itertools.pairwise(behind)) >= 2
    chip.stop()


@cocotb.test
async def nothing_from_before_a_reset_comes_after_it(dut: SimHandleBase) -> None:
    rng = random.Random(15)
    for clkout_stands in (False, True) * 4:
        chip = await _prepare(dut, 0.2, 0.2)
        chip.to_gateware.extend(b"\xee" * 100)
        source = cocotb.start_soon(_source(dut).send(b"\xee" * 100))
        sink = _sink(dut)
        await Timer(rng.randrange(100, 4000), unit="ns")
        source.cancel()
        sink.stop()
        dut.rx_ready.value = 0
        dut.tx_valid.value = 0
        chip.running = not clkout_stands
        await RisingEdge(dut.clk)
        dut.rst.value = 1
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        sender = cocotb.start_soon(_source(dut).send(b"CD"))
        sink = _sink(dut)
        # The chip starts anew too: earlier bytes from the PC are gone, and earlier bytes from the gateware are ignored.
        chip.to_gateware.clear()
        chip.stop()
        if clkout_stands:
            await Timer(2, unit="us")
            assert not sink.received
        chip = SyncChip(dut, kind=_KIND)
        await sender
        await Timer(1, unit="us")
        chip.to_gateware.extend(b"AB")
        assert await sink.wait_for(2) == [(ord("A"), 0), (ord("B"), 0)]
        await _until_written(chip, 2)
        assert bytes(chip.from_gateware) == b"CD"
        chip.stop()
        sink.stop()
