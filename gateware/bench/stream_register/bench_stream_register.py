"""Bench: a stream register neither loses nor duplicates an entry, and keeps the full throughput."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.utils import get_sim_time

from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _pass(dut: SimHandleBase, pause: float, count: int) -> float:
    dut.in_valid.value = 0
    dut.in_data.value = 0
    dut.out_ready.value = 0
    await start(dut.clk, dut.rst)
    source = Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, dut.out_data, dut.out_valid, dut.out_ready, pause=pause)
    rng = random.Random(5)
    entries = [rng.randrange(256) for _ in range(count)]
    began = get_sim_time("ns")
    await source.send(entries)
    await sink.wait_for(count)
    assert sink.received == entries
    return (get_sim_time("ns") - began) / 20


@cocotb.test
async def entries_pass_in_order_under_back_pressure(dut: SimHandleBase) -> None:
    await _pass(dut, 0.4, 500)


@cocotb.test
async def one_entry_passes_each_cycle(dut: SimHandleBase) -> None:
    assert await _pass(dut, 0.0, 200) <= 203
