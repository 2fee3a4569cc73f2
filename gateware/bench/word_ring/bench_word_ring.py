"""Bench: the ring returns committed words in order, and discards those that were rolled back."""

from __future__ import annotations

import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _begin(dut: SimHandleBase) -> None:
    for name in ("write", "write_data", "commit", "rollback", "pop"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)


@cocotb.test
async def its_room_is_its_depth_and_comes_back(dut: SimHandleBase) -> None:
    await _begin(dut)
    depth = int(dut.depth.value)
    dut.write.value = 1
    for number in range(depth):
        dut.write_data.value = number % 2 ** len(dut.write_data)
        await RisingEdge(dut.clk)
    dut.write.value = 0
    await RisingEdge(dut.clk)
    await ReadOnly()
    assert int(dut.room.value) == 0
    assert dut.available.value == 0
    await RisingEdge(dut.clk)
    dut.rollback.value = 1
    await RisingEdge(dut.clk)
    dut.rollback.value = 0
    await RisingEdge(dut.clk)
    await ReadOnly()
    assert int(dut.room.value) == depth


@cocotb.test
async def words_come_out_as_committed(dut: SimHandleBase) -> None:
    await _begin(dut)
    rng = random.Random(3)
    depth, width = int(dut.depth.value), len(dut.write_data)
    committed: deque[int] = deque()
    trial: list[int] = []
    taken = since_pop = 0
    for _ in range(4000):
        dut.write.value = dut.commit.value = dut.rollback.value = dut.pop.value = 0
        action = rng.random()
        if action < 0.5 and len(trial) + len(committed) < depth:
            word = rng.getrandbits(width)
            dut.write.value, dut.write_data.value = 1, word
            trial.append(word)
        if action < 0.15:
            dut.commit.value = 1
            committed += trial
            trial = []
        elif action > 0.97:
            dut.rollback.value = 1
            trial = []
        elif action > 0.6 and since_pop >= 2:
            await ReadOnly()
            if dut.available.value == 1 and committed:
                assert int(dut.read_data.value) == committed.popleft()
                taken += 1
                await RisingEdge(dut.clk)
                # No word was written in that cycle: the word is popped in the next one, in which it is still valid.
                dut.pop.value = 1
                since_pop = -1
        await RisingEdge(dut.clk)
        since_pop += 1
    assert taken > 300
