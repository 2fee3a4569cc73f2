"""Bench for the pictures of `ul_ft245_sync`, with the chip model of its own bench."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, RisingEdge

from gateware.bench.datasheets.window import Picture
from gateware.bench.ft245_sync.chip import SyncChip
from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _begin(dut: SimHandleBase) -> tuple[SyncChip, Sink, Source]:
    dut.flush.value = 0
    dut.rxf_n.value = dut.txe_n.value = 1
    chip = SyncChip(dut)
    sink = Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready)
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    await start(dut.clk, dut.rst)
    await ClockCycles(dut.clk, 40)
    return chip, sink, source


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def ft245_sync_read(dut: SimHandleBase) -> None:
    chip, sink, _ = await _begin(dut)
    await RisingEdge(dut.clkout)
    with Picture("ft245_sync_read", before=20):
        chip.to_gateware.extend(b"R10\n")
        await sink.wait_for(4)
        await ClockCycles(dut.clk, 2)
    chip.stop()


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def ft245_sync_write(dut: SimHandleBase) -> None:
    chip, _, source = await _begin(dut)
    await RisingEdge(dut.clk)
    with Picture("ft245_sync_write", before=20):
        await source.send(b"R10\n")
        dut.flush.value = 1
        await RisingEdge(dut.clk)
        dut.flush.value = 0
        await FallingEdge(dut.siwu_n)
        await ClockCycles(dut.clkout, 4)
    assert bytes(chip.from_gateware) == b"R10\n"
    chip.stop()
