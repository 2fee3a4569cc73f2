"""Bench: groups become due according to their divisors, at a fixed delay after each tick, and losses are counted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _begin(dut: SimHandleBase) -> None:
    for name in ("tick", "running", "number", "set", "divisor", "start", "clear", "lost_number"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)


async def _idle(dut: SimHandleBase) -> None:
    await RisingEdge(dut.clk)
    while dut.busy.value == 1:
        await RisingEdge(dut.clk)


async def _set(dut: SimHandleBase, number: int, divisor: int) -> None:
    await _idle(dut)
    dut.number.value, dut.divisor.value, dut.set.value = number, divisor, 1
    await RisingEdge(dut.clk)
    dut.set.value, dut.start.value = 0, 1
    await RisingEdge(dut.clk)
    dut.start.value = 0


async def _tick(dut: SimHandleBase) -> int:
    """Simulate one base tick; return the groups that are due after it."""
    dut.tick.value = 1
    await RisingEdge(dut.clk)
    dut.tick.value = 0
    await _idle(dut)
    await RisingEdge(dut.clk)
    return int(dut.due.value)


async def _clear(dut: SimHandleBase, groups: int) -> None:
    dut.clear.value = groups
    await RisingEdge(dut.clk)
    dut.clear.value = 0
    await RisingEdge(dut.clk)


@cocotb.test
async def a_group_is_due_at_the_next_tick_and_every_divisor_th_after_it(dut: SimHandleBase) -> None:
    await _begin(dut)
    divisors = {0: 1, 1: 2, int(dut.groups.value) - 1: 5}
    for number, divisor in divisors.items():
        await _set(dut, number, divisor)
    dut.running.value = sum(1 << number for number in divisors)
    for tick in range(21):
        due = await _tick(dut)
        assert due == sum(1 << number for number, divisor in divisors.items() if tick % divisor == 0), tick
        await _clear(dut, due)


@cocotb.test
async def groups_that_do_not_run_or_are_not_periodic_are_never_due(dut: SimHandleBase) -> None:
    await _begin(dut)
    await _set(dut, 0, 1)
    await _set(dut, 1, 0)
    dut.running.value = 2
    for _ in range(5):
        assert await _tick(dut) == 0


@cocotb.test
async def what_is_not_served_is_counted(dut: SimHandleBase) -> None:
    await _begin(dut)
    await _set(dut, 1, 1)
    dut.running.value = 2
    dut.lost_number.value = 1
    for missed in (0, 1, 7):
        for _ in range(missed + 1):
            assert await _tick(dut) == 2
        await RisingEdge(dut.clk)
        await ReadOnly()
        assert int(dut.lost.value) == missed
        await RisingEdge(dut.clk)
        await _clear(dut, 2)
        assert dut.due.value == 0


@cocotb.test
async def the_time_from_tick_to_due_depends_on_the_number_alone(dut: SimHandleBase) -> None:
    await _begin(dut)
    last = int(dut.groups.value) - 1
    for number in range(last + 1):
        await _set(dut, number, 1 + number % 3)
    dut.running.value = 2 ** (last + 1) - 1
    delays = set()
    for _ in range(12):
        due = int(dut.due.value)
        await _clear(dut, due)
        dut.tick.value = 1
        await RisingEdge(dut.clk)
        dut.tick.value = 0
        for cycle in range(last + 8):
            await ReadOnly()
            if int(dut.due.value) >> last & 1:
                delays.add(cycle)
                break
            await RisingEdge(dut.clk)
        await RisingEdge(dut.clk)
        await _idle(dut)
    assert len(delays) == 1
