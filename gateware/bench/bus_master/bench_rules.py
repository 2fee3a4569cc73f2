"""Bench: clients that break the rules of the bus master; each ends the simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from gateware.bench.bus_master.bench_bus_master import _begin

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _first_of_a_block(dut: SimHandleBase, client: str) -> None:
    """Begin a block of two words, and return when its first access is on the bus."""
    await _begin(dut, waits=5)
    getattr(dut, client).value = 1
    getattr(dut, f"{client}_more").value = 1
    await RisingEdge(dut.bus_request)


async def _behind_the_last(dut: SimHandleBase, client: str) -> None:
    await _first_of_a_block(dut, client)
    getattr(dut, f"{client}_more").value = 0
    # The bus accepts the first access, so that the second and last one is granted before the answer.
    dut.bus_next.value = 1
    await RisingEdge(dut.clk)
    dut.bus_next.value = 0
    await ClockCycles(dut.clk, 100)


@cocotb.test
async def a_request_behind_the_last_access(dut: SimHandleBase) -> None:
    await _behind_the_last(dut, "request")


@cocotb.test
async def a_sample_behind_the_last_access(dut: SimHandleBase) -> None:
    await _behind_the_last(dut, "sample")


@cocotb.test
async def a_write_in_a_block_that_is_read(dut: SimHandleBase) -> None:
    await _first_of_a_block(dut, "request")
    dut.request_write.value = 1
    dut.request_exclusive.value = 1
    await ClockCycles(dut.clk, 100)


@cocotb.test
async def writes_that_are_not_exclusive(dut: SimHandleBase) -> None:
    await _begin(dut)
    dut.request_write.value = 1
    dut.request_more.value = 1
    dut.request.value = 1
    await ClockCycles(dut.clk, 100)
