"""Bench for the pictures of `ul_uart`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles

from gateware.bench.datasheets.window import Picture
from gateware.bench.streams import Sink, Source, start
from gateware.bench.uart.bench_half_duplex import Pair
from gateware.bench.uart.bench_uart import Line

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _begin(dut: SimHandleBase) -> tuple[Sink, Source]:
    dut.rxd.value = 1
    dut.cts_n.value = dut.flush.value = 0
    sink = Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready)
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    await start(dut.clk, dut.rst, 1e9 / int(dut.clock_hz.value))
    await ClockCycles(dut.clk, 20)
    return sink, source


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def uart_in(dut: SimHandleBase) -> None:
    sink, _ = await _begin(dut)
    line = Line(dut)
    with Picture("uart_in", before=40):
        await line.send(b"R")
        await ClockCycles(dut.clk, 8)
    assert sink.received == [(ord("R"), 0)]


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def uart_out(dut: SimHandleBase) -> None:
    _, source = await _begin(dut)
    line = Line(dut)
    cocotb.start_soon(line.listen())
    with Picture("uart_out", before=40):
        await source.send(b"R")
        await ClockCycles(dut.clk, 63)
    assert line.received == [ord("R")]


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def rs485(dut: SimHandleBase) -> None:
    _, source = await _begin(dut)
    pair = Pair(dut)
    await pair.begin()
    with Picture("rs485", before=200):
        far_end = cocotb.start_soon(pair.far_end(b"\n"))
        await pair.bits(2)
        cocotb.start_soon(source.send(b"ok"))
        await far_end
        await pair.bits(26)
    assert pair.line.received == [*b"ok"]
