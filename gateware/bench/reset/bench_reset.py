"""Bench: no output of an entity is undefined after the end of its reset."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_CLOCKS = ("clk", "in_clk", "out_clk", "clkout", "ft_clkout", "phy_rx_clk", "phy_tx_clk")
_RESETS = ("rst", "in_rst", "out_rst")
_CYCLES = 30
_CROSSING = 4
"""Cycles that a pin takes to pass the synchronising registers, which have no reset."""


@cocotb.test
async def no_output_is_undefined_after_one_cycle_of_reset(dut: SimHandleBase) -> None:
    inputs, outputs, excused = json.loads(os.environ["PORTS"])
    for name in inputs:
        if name in _CLOCKS:
            cocotb.start_soon(Clock(getattr(dut, name), 20, unit="ns").start())
        else:
            getattr(dut, name).value = name.endswith("_n") or name in ("rxd", "uart_rxd")
    clocks = [getattr(dut, name) for name in inputs if name in _CLOCKS]
    resets = [getattr(dut, name) for name in inputs if name in _RESETS]
    await ClockCycles(clocks[0], _CROSSING)
    for reset in resets:
        reset.value = 1
    # One cycle is enough with one clock; a reset that crosses to another clock takes more.
    await ClockCycles(clocks[0], 1 if len(clocks) == 1 else 8)
    for reset in resets:
        reset.value = 0
    await RisingEdge(clocks[0])
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    for _ in range(_CYCLES):
        await ReadOnly()
        undefined = [name for name in outputs if name not in excused and not getattr(dut, name).value.is_resolvable]
        assert undefined == []
        await RisingEdge(clocks[0])
