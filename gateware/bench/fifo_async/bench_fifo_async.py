"""Bench: the dual-clock FIFO keeps order and throughput for any two clocks."""

from __future__ import annotations

import os
import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge, Timer
from cocotb.utils import get_sim_time

from gateware.bench.streams import Sink, Source

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_IN_PERIOD_PS = int(os.environ["IN_PERIOD_PS"])
_OUT_PERIOD_PS = int(os.environ["OUT_PERIOD_PS"])


async def _prepare(dut: SimHandleBase) -> None:
    dut.in_valid.value = 0
    dut.in_data.value = 0
    dut.out_ready.value = 0
    dut.in_rst.value = 1
    dut.out_rst.value = 1
    cocotb.start_soon(Clock(dut.in_clk, _IN_PERIOD_PS, unit="ps").start())
    await Timer(random.randrange(_OUT_PERIOD_PS), unit="ps")
    cocotb.start_soon(Clock(dut.out_clk, _OUT_PERIOD_PS, unit="ps").start())
    await _end_reset(dut)


async def _end_reset(dut: SimHandleBase) -> None:
    await ClockCycles(dut.in_clk, 4)
    await ClockCycles(dut.out_clk, 4)
    dut.out_rst.value = 0
    await RisingEdge(dut.in_clk)
    dut.in_rst.value = 0
    # `runner` searches for this message: undefined signals are no fault before it.
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    await RisingEdge(dut.in_clk)


def _source(dut: SimHandleBase, pause: float = 0.0) -> Source:
    return Source(dut.in_clk, dut.in_data, dut.in_valid, dut.in_ready, pause=pause, rng=random.Random(3))


def _sink(dut: SimHandleBase, pause: float = 0.0) -> Sink:
    return Sink(dut.out_clk, dut.out_data, dut.out_valid, dut.out_ready, pause=pause, rng=random.Random(4))


def _entries(dut: SimHandleBase, count: int) -> list[int]:
    rng = random.Random(5)
    return [rng.getrandbits(len(dut.in_data)) for _ in range(count)]


@cocotb.test
async def nothing_is_lost_doubled_or_reordered_under_random_pauses(dut: SimHandleBase) -> None:
    await _prepare(dut)
    for pauses in ((0.0, 0.0), (0.0, 0.5), (0.5, 0.0), (0.5, 0.5), (0.95, 0.1), (0.1, 0.95)):
        entries = _entries(dut, 300)
        sink = _sink(dut, pauses[1])
        await _source(dut, pauses[0]).send(entries)
        assert await sink.wait_for(len(entries)) == entries
        await ClockCycles(dut.out_clk, 10)
        assert len(sink.received) == len(entries)
        sink.stop()
        dut.out_ready.value = 0


@cocotb.test
async def it_holds_its_depth_and_one_more(dut: SimHandleBase) -> None:
    await _prepare(dut)
    depth = int(dut.depth.value)
    accepted = 0
    dut.in_valid.value = 1
    for _ in range(depth + 10 + 10 * (_OUT_PERIOD_PS // _IN_PERIOD_PS + 1)):
        await ReadOnly()
        accepted += int(dut.in_ready.value)
        await RisingEdge(dut.in_clk)
    assert accepted == depth + 1


@cocotb.test
async def the_slower_side_never_waits(dut: SimHandleBase) -> None:
    await _prepare(dut)
    if int(dut.depth.value) < 16:
        return  # too small: the pointers take longer through both synchronisers
    slower = dut.in_clk if _IN_PERIOD_PS >= _OUT_PERIOD_PS else dut.out_clk
    sink = _sink(dut)
    cocotb.start_soon(_source(dut).send(_entries(dut, 3000)))
    await ClockCycles(slower, 50)
    before = len(sink.received)
    await ClockCycles(slower, 500)
    assert 499 <= len(sink.received) - before <= 501


@cocotb.test
async def reset_of_both_sides_empties_it(dut: SimHandleBase) -> None:
    await _prepare(dut)
    for filled in (1, 3, int(dut.depth.value)):
        await _source(dut).send(_entries(dut, filled))
        dut.in_rst.value = 1
        dut.out_rst.value = 1
        await _end_reset(dut)
        await ClockCycles(dut.out_clk, 4)
        await ReadOnly()
        assert dut.out_valid.value == 0
        assert dut.in_ready.value == 1
        await RisingEdge(dut.in_clk)
        sink = _sink(dut)
        await _source(dut).send([1, 0, 1])
        assert await sink.wait_for(3) == [1, 0, 1]
        sink.stop()
        dut.out_ready.value = 0
