"""Inside the simulator: the watchdog of docs/safety.md, by its UART and the pins of its motor."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, RisingEdge
from cocotb.utils import get_sim_time

from docs.walkthrough import files_of
from generate.bench_boards import BIT_CYCLES, PERIOD_NS, ByUart
from unity_link.spec import compile_text

PAGE = Path(__file__).parents[2] / "docs" / "safety.md"
LISTINGS = files_of(PAGE)
MOTOR = compile_text(LISTINGS["motor.ul"])
PATIENCE = 20 * 10 * BIT_CYCLES
"""Clock cycles until the watchdog acts: more than a write of 14 characters and its answer take."""


def level(dut: Any) -> tuple[int, int]:
    """Return the inputs of the motor: enable and duty."""
    return int(dut.enable.value), int(dut.duty.value.to_signed())


@cocotb.test
async def a_motor_outlives_its_last_write_by_its_patience_and_no_more(dut: Any) -> None:
    motor = ByUart(dut, MOTOR.interface())
    dut.rst.value = 1
    await motor.begin()
    dut.rst.value = 0
    await ClockCycles(dut.clk, 2 * PATIENCE)
    assert level(dut) == (0, 0)

    # Further writes, also of the same value, keep the motor moving.
    for _ in range(5):
        await motor.set("duty", 0.5)
        assert level(dut) == (1, 1024)
        assert await motor.get("alive") is True

    # Reads do not: the motor stops as soon as the time since the last write has passed.
    await ClockCycles(dut.clk, PATIENCE)
    assert level(dut) == (0, 0)
    assert await motor.get("duty") == 1024 / 2047
    assert await motor.get("alive") is False
    assert level(dut) == (0, 0)

    await motor.set("duty", -1)
    assert level(dut) == (1, -2047)
    # Exact to the cycle, counted from the first cycle of the value at the pins.
    await ClockCycles(dut.clk, PATIENCE)
    written = cocotb.start_soon(motor.set("duty", 1))
    await RisingEdge(dut.enable)
    began = get_sim_time("ns")
    await FallingEdge(dut.enable)
    assert get_sim_time("ns") - began == PATIENCE * PERIOD_NS
    await written


@cocotb.test
async def a_reset_stops_the_motor_at_once(dut: Any) -> None:
    motor = ByUart(dut, MOTOR.interface())
    dut.rst.value = 1
    await motor.begin()
    dut.rst.value = 0
    # A UART must first see an idle line.
    await ClockCycles(dut.clk, PATIENCE)
    await motor.set("duty", 1)
    assert level(dut) == (1, 2047)
    dut.rst.value = 1
    await ClockCycles(dut.clk, 2)
    assert level(dut) == (0, 0)
