"""Bench: a flush is pulsed when the marks request it, and only then."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

NONE, WHEN_IDLE, NOW = 0, 1, 2


async def _flushes(dut: SimHandleBase, steps: list[tuple[int, int, int]]) -> list[int]:
    """Return the steps (left, mark, active), one per cycle, after which a flush came; end with ten idle ones."""
    dut.left.value = dut.mark.value = dut.active.value = 0
    await start(dut.clk, dut.rst)
    flushed = []
    for index, (left, mark, active) in enumerate([*steps, *[(0, 0, 0)] * 10]):
        dut.left.value, dut.mark.value, dut.active.value = left, mark, active
        await RisingEdge(dut.clk)
        if dut.flush.value == 1:
            flushed.append(index)
    return flushed


@cocotb.test
async def bytes_without_a_mark_are_not_flushed(dut: SimHandleBase) -> None:
    assert await _flushes(dut, [(1, NONE, 1)] * 20) == []


@cocotb.test
async def a_mark_counts_only_as_its_byte_leaves(dut: SimHandleBase) -> None:
    assert await _flushes(dut, [(0, NOW, 1)] * 20) == []
    assert await _flushes(dut, [(0, WHEN_IDLE, 1)] * 20) == []


@cocotb.test
async def now_flushes_behind_the_byte(dut: SimHandleBase) -> None:
    assert await _flushes(dut, [(1, NONE, 1), (1, NOW, 1), (1, NONE, 1), (1, NOW, 1), (1, NONE, 1)]) == [3, 5]


@cocotb.test
async def when_idle_waits_until_nothing_is_on_its_way(dut: SimHandleBase) -> None:
    busy = [(1, NONE, 1)] * 4
    (flushed,) = await _flushes(dut, [(1, WHEN_IDLE, 1), *busy, (1, WHEN_IDLE, 1), *busy])
    assert flushed >= 10
    assert len(await _flushes(dut, [(1, WHEN_IDLE, 1), (0, NONE, 0), (0, NONE, 0)])) == 1


@cocotb.test
async def a_flush_now_serves_what_waits_as_well(dut: SimHandleBase) -> None:
    assert len(await _flushes(dut, [(1, WHEN_IDLE, 1), (1, NONE, 1), (1, NOW, 1), (0, NONE, 1)])) == 1
