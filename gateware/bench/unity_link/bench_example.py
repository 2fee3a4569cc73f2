"""Bench: the example design of docs/gateware.md works as described, at its pins."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from gateware.bench.streams import start
from gateware.bench.uart.bench_uart import Line
from gateware.bench.unity_link.gateway import checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def its_register_is_written_and_read_over_the_uart(dut: SimHandleBase) -> None:
    clock_hz, baud = SimpleNamespace(value=50_000_000), SimpleNamespace(value=3_000_000)
    line = Line(SimpleNamespace(rxd=dut.uart_rxd, txd=dut.uart_txd, clock_hz=clock_hz, baud=baud))
    line.drive(level=1)
    await start(dut.clk, dut.rst)
    cocotb.start_soon(line.listen())
    # A receiver must see an idle line before it accepts a start bit.
    await ClockCycles(dut.clk, 200)
    for request, answer, leds in (
        (checked(b"W0000C0FFEE"), checked(b"W00"), 0x00C0FFEE),
        (checked(b"RA5"), checked(b"RA500C0FFEE"), 0x00C0FFEE),
        (b"W01FF\r", b"W01\r\n", 0xFF),
    ):
        del line.received[:]
        await line.send(request)
        while len(line.received) < len(answer):
            await RisingEdge(dut.clk)
        assert bytes(line.received) == answer
        assert int(dut.leds.value) == leds
