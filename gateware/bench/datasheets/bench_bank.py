"""Bench for the pictures of a generated register bank: its bus and the hardware's side."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge

from gateware.bench.datasheets.window import Picture
from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

BATTERY, HITS, LOG, LEFT_DUTY = 0x30, 0x32, 0x33, 0x12
NOWHERE = 0xE8


async def _begin(dut: SimHandleBase) -> None:
    for name in ("wb_cyc", "wb_stb", "wb_we", "wb_adr", "wb_dat_i", "sample_access", "hits", "log", "log_valid"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    await ClockCycles(dut.clk, 2)


async def _transaction(dut: SimHandleBase, *accesses: tuple[int, int | None]) -> list[int | None]:
    """Make accesses (writes if they have a word) as a pipelined master; return the words read, and None for errors."""
    answers: list[int | None] = []
    waiting = list(accesses)
    dut.wb_cyc.value = 1
    while len(answers) < len(accesses):
        dut.wb_stb.value = bool(waiting)
        if waiting:
            address, word = waiting[0]
            dut.wb_we.value, dut.wb_adr.value, dut.wb_dat_i.value = word is not None, address, word or 0
        await ReadOnly()
        if dut.wb_ack.value == 1:
            answers.append(int(dut.wb_dat_o.value))
        elif dut.wb_err.value == 1:
            answers.append(None)
        if waiting and dut.wb_stall.value == 0:
            waiting.pop(0)
        await RisingEdge(dut.clk)
    dut.wb_cyc.value = dut.wb_stb.value = dut.wb_we.value = 0
    return answers


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def bank_accesses(dut: SimHandleBase) -> None:
    await _begin(dut)
    with Picture("bank_accesses", before=20, behind=20):
        answers = await _transaction(dut, (LEFT_DUTY, 0x400), (LEFT_DUTY, None), (BATTERY, None), (NOWHERE, None))
        await ClockCycles(dut.clk, 1)
    assert answers[1:] == [0x400, 0xC80, None]
    assert int(dut.left_duty.value) == 0x400


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def bank_fifo(dut: SimHandleBase) -> None:
    await _begin(dut)

    async def hardware() -> None:
        """Offer a byte three cycles later, until it is accepted."""
        await ClockCycles(dut.clk, 3)
        dut.log.value, dut.log_valid.value = 0x2A, 1
        taken = False
        while not taken:
            await ReadOnly()
            taken = dut.log_ready.value == 1
            await RisingEdge(dut.clk)
        dut.log.value = dut.log_valid.value = 0

    with Picture("bank_fifo", before=20, behind=20):
        cocotb.start_soon(hardware())
        assert await _transaction(dut, (LOG, None), (BATTERY, None)) == [0x2A, 0xC80]
        await ClockCycles(dut.clk, 1)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def bank_sample(dut: SimHandleBase) -> None:
    await _begin(dut)
    dut.hits.value = 7
    await ClockCycles(dut.clk, 2)
    with Picture("bank_sample", before=20, behind=20):
        dut.sample_access.value = 1
        await RisingEdge(dut.clk)
        dut.hits.value = 8
        await ClockCycles(dut.clk, 1)
        assert await _transaction(dut, (HITS, None)) == [7]
        dut.sample_access.value = 0
        await ClockCycles(dut.clk, 2)
        assert await _transaction(dut, (HITS, None)) == [8]
        await ClockCycles(dut.clk, 1)
