"""Bench for the pictures of the bus wrappers; it drives the core's side."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge

from gateware.bench.axi4_lite_master.bench_axi4_lite_master import FROM_SLAVE, Slave
from gateware.bench.datasheets.window import Picture
from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _access(dut: SimHandleBase, address: int, word: int | None = None) -> int:
    """Make an access as the core does, and return the word read."""
    dut.bus_request.value = 1
    dut.bus_write.value = word is not None
    dut.bus_address.value = address
    dut.bus_write_data.value = word or 0
    while True:
        await ReadOnly()
        done, read = dut.bus_done.value == 1, dut.bus_read_data.value
        await RisingEdge(dut.clk)
        if done:
            dut.bus_request.value = 0
            return int(read) if word is None else 0


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def wishbone_classic(dut: SimHandleBase) -> None:
    answers = ["", "ack", "rty", "ack"]
    for name in ("bus_request", "bus_write", "bus_lock", "bus_ahead", "ack", "err", "rty", "stall"):
        getattr(dut, name).value = 0
    dut.bus_address.value = dut.bus_write_data.value = dut.dat_i.value = 0

    async def slave() -> None:
        """Answer each strobe with the next entry of `answers`, one cycle later."""
        while True:
            await RisingEdge(dut.clk)
            asked = dut.stb.value == 1 and dut.ack.value == 0 and dut.rty.value == 0
            answer = answers.pop(0) if asked else ""
            dut.ack.value, dut.rty.value = answer == "ack", answer == "rty"
            dut.dat_i.value = 0x2A if answer == "ack" else 0

    await start(dut.clk, dut.rst)
    cocotb.start_soon(slave())
    await RisingEdge(dut.clk)
    with Picture("wishbone_classic", before=20):
        assert await _access(dut, 0x10) == 0x2A
        await ClockCycles(dut.clk, 2)
        await _access(dut, 0x11, 0x2B)
        await ClockCycles(dut.clk, 2)
    assert answers == []


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def axi4_lite(dut: SimHandleBase) -> None:
    for name in ("bus_request", "bus_write", "bus_address", "bus_write_data", *FROM_SLAVE):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    Slave(dut, 0.0)
    await ClockCycles(dut.clk, 2)
    with Picture("axi4_lite", before=20):
        await _access(dut, 0x10, 0x2A)
        await ClockCycles(dut.clk, 2)
        assert await _access(dut, 0x10) == 0x2A
        await ClockCycles(dut.clk, 2)
