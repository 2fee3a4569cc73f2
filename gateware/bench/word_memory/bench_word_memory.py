"""Bench: a read returns the word last written, one cycle after its index."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ReadOnly, RisingEdge

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def words_are_read_as_they_were_written(dut: SimHandleBase) -> None:
    depth, width = int(dut.depth.value), int(dut.width.value)
    rng = random.Random(1)
    kept = [rng.getrandbits(width) for _ in range(depth)]
    cocotb.start_soon(Clock(dut.clk, 20, unit="ns").start())
    await RisingEdge(dut.clk)
    dut.write.value = 1
    for index, word in enumerate(kept):
        dut.write_index.value, dut.write_data.value = index, word
        dut.read_index.value = index ^ 1
        await RisingEdge(dut.clk)
    cocotb.log.info("reset ended at 0 ps")
    for _ in range(1000):
        at, asked, write, word = rng.randrange(depth), rng.randrange(depth), rng.random() < 0.5, rng.getrandbits(width)
        # The result of a read during a write to the same address is undefined.
        asked ^= asked == at
        dut.write.value, dut.write_index.value, dut.write_data.value = write, at, word
        dut.read_index.value = asked
        await RisingEdge(dut.clk)
        if write:
            kept[at] = word
        await ReadOnly()
        assert int(dut.read_data.value) == kept[asked]
        await RisingEdge(dut.clk)
        dut.write.value = 0
        await ReadOnly()
        assert int(dut.read_data.value) == kept[asked]
        await RisingEdge(dut.clk)
