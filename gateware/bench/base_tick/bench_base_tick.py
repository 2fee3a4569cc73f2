"""Bench: the base tick has the right number of ticks for its frequency, evenly spaced."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def ticks_are_even_and_exact_on_average(dut: SimHandleBase) -> None:
    await start(dut.clk, dut.rst)
    period = int(dut.clock_hz.value) * 1000 / int(dut.base_frequency_millihertz.value)
    ticks, cycle = [], 0
    while len(ticks) < 200:
        await RisingEdge(dut.clk)
        cycle += 1
        if dut.tick.value == 1:
            ticks.append(cycle)
    assert all(abs(tick - ticks[0] - index * period) < 1 for index, tick in enumerate(ticks))
