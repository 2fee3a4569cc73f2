"""Bench for the pictures of `ul_ft245_async`, with the chip model of its own bench."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, RisingEdge

from gateware.bench.datasheets.window import Picture
from gateware.bench.ft245_async.chip import AsyncChip
from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _begin(dut: SimHandleBase) -> tuple[AsyncChip, Sink, Source]:
    dut.flush.value = 0
    dut.rxf_n.value = dut.txe_n.value = 1
    sink = Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready)
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    await start(dut.clk, dut.rst, 1e9 / int(dut.clock_hz.value))
    chip = AsyncChip(dut)
    await ClockCycles(dut.clk, 10)
    return chip, sink, source


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def ft245_async_read(dut: SimHandleBase) -> None:
    chip, sink, _ = await _begin(dut)
    with Picture("ft245_async_read", before=10):
        chip.send(b"R")
        await sink.wait_for(1)
        await ClockCycles(dut.clk, 3)
    chip.stop()


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def ft245_async_write(dut: SimHandleBase) -> None:
    chip, _, source = await _begin(dut)
    with Picture("ft245_async_write", before=10):
        await source.send(b"R")
        dut.flush.value = 1
        await RisingEdge(dut.clk)
        dut.flush.value = 0
        await FallingEdge(dut.siwu_n)
        await RisingEdge(dut.siwu_n)
        await ClockCycles(dut.clk, 2)
    assert chip.from_gateware == [ord("R")]
    chip.stop()
