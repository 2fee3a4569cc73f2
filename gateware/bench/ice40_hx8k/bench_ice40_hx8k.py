"""Bench: the iCE40 board at its pins, from power-up on, without an external reset."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotb.utils import get_sim_time

from gateware.bench.uart.bench_uart import Line
from gateware.bench.unity_link.gateway import checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

RESET_CYCLES = 20


@cocotb.test
async def its_leds_memory_and_counter_are_reached_over_the_uart(dut: SimHandleBase) -> None:
    clock_hz, baud = SimpleNamespace(value=12_000_000), SimpleNamespace(value=3_000_000)
    line = Line(SimpleNamespace(rxd=dut.uart_rxd, txd=dut.uart_txd, clock_hz=clock_hz, baud=baud))
    line.drive(level=1)
    cocotb.start_soon(Clock(dut.clk_12mhz, 83_333, unit="ps", period_high=41_666).start())
    await ClockCycles(dut.clk_12mhz, RESET_CYCLES)
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    cocotb.start_soon(line.listen())
    await ClockCycles(dut.clk_12mhz, 60)

    async def answer(request: bytes, length: int) -> bytes:
        del line.received[:]
        await line.send(request)
        while len(line.received) < length:
            await RisingEdge(dut.clk_12mhz)
        return bytes(line.received)

    # The example in the header of its file.
    assert await answer(b"W000000005A\r", len(b"W00\r\n")) == b"W00\r\n"
    assert int(dut.leds.value) == 0x5A
    for request, expected in (
        (b"R00", b"R000000005A"),
        (b"WM80" + b"0000000100000002", b"WM8002"),
        (b"RM8002", b"RM80020000000100000002"),
        (b"R10", b"X04"),
    ):
        assert await answer(checked(request), len(checked(expected))) == checked(expected)
    length = len(checked(b"R0100000000"))
    before, after = [int((await answer(checked(b"R01"), length))[3:11], 16) for _ in range(2)]
    assert before < after < before + 2000
