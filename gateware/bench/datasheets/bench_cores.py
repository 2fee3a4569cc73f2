"""Bench for the pictures of FIFOs, synchronisers and the chain of shift registers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge, Timer
from cocotb.utils import get_sim_time

from gateware.bench.datasheets.window import Picture
from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

ENTRIES = (0xA0, 0xA1, 0xA2)


async def _pass_entries(dut: SimHandleBase, name: str, clk: str, waits: int) -> None:
    """Pass three entries in and out; the first one waits in the entity."""
    source = Source(
        getattr(dut, f"in_{clk}" if hasattr(dut, "in_clk") else clk), dut.in_data, dut.in_valid, dut.in_ready
    )
    out_clk = getattr(dut, "out_clk" if hasattr(dut, "out_clk") else clk)
    with Picture(name, before=20):
        sending = cocotb.start_soon(source.send(ENTRIES))
        await ClockCycles(out_clk, waits)
        sink = Sink(out_clk, dut.out_data, dut.out_valid, dut.out_ready)
        assert await sink.wait_for(len(ENTRIES)) == list(ENTRIES)
        await sending
        await ClockCycles(out_clk, 2)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def fifo_sync(dut: SimHandleBase) -> None:
    dut.in_valid.value = dut.in_data.value = dut.out_ready.value = 0
    await start(dut.clk, dut.rst)
    await _pass_entries(dut, "fifo_sync", "clk", 5)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def stream_register(dut: SimHandleBase) -> None:
    dut.in_valid.value = dut.in_data.value = dut.out_ready.value = 0
    await start(dut.clk, dut.rst)
    await _pass_entries(dut, "stream_register", "clk", 3)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def fifo_async(dut: SimHandleBase) -> None:
    dut.in_valid.value = dut.in_data.value = dut.out_ready.value = 0
    dut.in_rst.value = dut.out_rst.value = 1
    cocotb.start_soon(Clock(dut.in_clk, 20, unit="ns").start())
    cocotb.start_soon(Clock(dut.out_clk, 14, unit="ns").start())
    await ClockCycles(dut.in_clk, 5)
    dut.in_rst.value = 0
    await RisingEdge(dut.out_clk)
    dut.out_rst.value = 0
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    await ClockCycles(dut.in_clk, 4)
    await _pass_entries(dut, "fifo_async", "clk", 8)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def crossing(dut: SimHandleBase) -> None:
    dut.d.value = 0
    await start(dut.clk, dut.rst)
    await ClockCycles(dut.clk, 2)
    with Picture("crossing", before=20):
        for delay_ns in (27, 44, 30):
            await Timer(delay_ns, unit="ns")
            dut.d.value = 1 - int(dut.d.value)
        await ClockCycles(dut.clk, 5)
    assert dut.q.value == 1


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def reset_synchroniser(dut: SimHandleBase) -> None:
    dut.cause.value = 0
    cocotb.start_soon(Clock(dut.clk, 20, unit="ns").start())
    await ClockCycles(dut.clk, 6)
    with Picture("reset_synchroniser", before=20):
        await Timer(33, unit="ns")
        dut.cause.value = 1
        await Timer(1, unit="ns")
        assert dut.rst.value == 1
        await Timer(40, unit="ns")
        dut.cause.value = 0
        await ClockCycles(dut.clk, 6)
    assert dut.rst.value == 0


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def shift_chain(dut: SimHandleBase) -> None:
    dut.to_chain.value, dut.chain_in.value = 0b1010, 1
    await start(dut.clk, dut.rst)
    await RisingEdge(dut.chain_load_n)
    await RisingEdge(dut.chain_load_n)
    with Picture("shift_chain", before=60):
        await RisingEdge(dut.chain_load_n)
        await ClockCycles(dut.clk, 3)
    assert dut.from_chain.value == 0b111


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def one_bit(dut: SimHandleBase) -> None:
    """A chain of one bit with a wire from its end to its beginning: the output at the end does not flicker."""

    async def wire() -> None:
        while True:
            dut.chain_in.value = dut.chain_out.value
            await dut.chain_out.value_change

    dut.to_chain.value = 0
    await start(dut.clk, dut.rst)
    cocotb.start_soon(wire())
    await RisingEdge(dut.chain_load_n)
    await ClockCycles(dut.clk, 3)
    with Picture("one_bit", before=20):
        dut.to_chain.value = 1
        await RisingEdge(dut.chain_out)
        for _ in range(20):
            await RisingEdge(dut.clk)
            assert dut.chain_out.value == 1
    assert dut.from_chain.value == 1
