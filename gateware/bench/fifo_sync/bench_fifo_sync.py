"""Bench: the synchronous FIFO keeps order, throughput, capacity and level."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


def _source(dut: SimHandleBase, pause: float = 0.0) -> Source:
    return Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready, pause=pause, rng=random.Random(3))


def _sink(dut: SimHandleBase, pause: float = 0.0) -> Sink:
    return Sink(dut.clk, dut.out_data, dut.out_valid, dut.out_ready, pause=pause, rng=random.Random(4))


def _entries(dut: SimHandleBase, count: int) -> list[int]:
    rng = random.Random(5)
    return [rng.getrandbits(len(dut.in_data)) for _ in range(count)]


async def _prepare(dut: SimHandleBase) -> None:
    dut.in_valid.value = 0
    dut.in_data.value = 0
    dut.out_ready.value = 0
    await start(dut.clk, dut.rst)


@cocotb.test
async def an_entry_leaves_one_cycle_after_it_entered(dut: SimHandleBase) -> None:
    await _prepare(dut)
    dut.in_data.value = 0x5A % 2 ** len(dut.in_data)
    dut.in_valid.value = 1
    await RisingEdge(dut.clk)
    dut.in_valid.value = 0
    await ReadOnly()
    assert dut.out_valid.value == 1
    assert int(dut.out_data.value) == 0x5A % 2 ** len(dut.in_data)


@cocotb.test
async def it_holds_exactly_its_depth(dut: SimHandleBase) -> None:
    await _prepare(dut)
    depth = int(dut.depth.value)
    accepted = 0
    dut.in_valid.value = 1
    for _ in range(depth + 5):
        await ReadOnly()
        assert int(dut.level.value) == accepted
        assert int(dut.in_ready.value) == int(accepted < depth)
        accepted += int(dut.in_ready.value)
        await RisingEdge(dut.clk)
    assert accepted == depth


@cocotb.test
async def a_stream_moves_one_entry_in_every_cycle(dut: SimHandleBase) -> None:
    await _prepare(dut)
    depth = int(dut.depth.value)
    for filled in {0, 1, 2, depth - 1, depth}:
        entries = _entries(dut, filled + 4 * depth)
        await _source(dut).send(entries[:filled])
        sink = _sink(dut)
        source = cocotb.start_soon(_source(dut).send(entries[filled:]))
        # One cycle until the sink is ready, one of latency, and one until a full FIFO accepts an entry again.
        for _ in range(len(entries) + 3):
            await RisingEdge(dut.clk)
        assert sink.received == entries
        await source
        sink.stop()
        dut.out_ready.value = 0
        await RisingEdge(dut.clk)


@cocotb.test
async def nothing_is_lost_doubled_or_reordered_under_random_pauses(dut: SimHandleBase) -> None:
    await _prepare(dut)
    for pauses in ((0.0, 0.5), (0.5, 0.0), (0.5, 0.5), (0.1, 0.1), (0.9, 0.1), (0.1, 0.9)):
        entries = _entries(dut, 500)
        sink = _sink(dut, pauses[1])
        await _source(dut, pauses[0]).send(entries)
        assert await sink.wait_for(len(entries)) == entries
        sink.stop()
        await RisingEdge(dut.clk)


@cocotb.test
async def the_level_follows_every_entry(dut: SimHandleBase) -> None:
    await _prepare(dut)
    rng = random.Random(6)
    inside: list[int] = []
    for _ in range(2000):
        offer, take, entry = rng.random() < 0.5, rng.random() < 0.5, rng.getrandbits(len(dut.in_data))
        dut.in_valid.value, dut.out_ready.value, dut.in_data.value = int(offer), int(take), entry
        await ReadOnly()
        assert int(dut.level.value) == len(inside)
        assert int(dut.out_valid.value) == int(bool(inside))
        if inside:
            assert int(dut.out_data.value) == inside[0]
        accepted = offer and dut.in_ready.value == 1
        if take and inside:
            inside.pop(0)
        if accepted:
            inside.append(entry)
        await RisingEdge(dut.clk)


@cocotb.test
async def reset_empties_it_in_any_state(dut: SimHandleBase) -> None:
    await _prepare(dut)
    for filled in range(int(dut.depth.value) + 1):
        await _source(dut).send(_entries(dut, filled))
        dut.rst.value = 1
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        await ReadOnly()
        assert int(dut.level.value) == 0
        assert dut.out_valid.value == 0
        assert dut.in_ready.value == 1
        await RisingEdge(dut.clk)
        sink = _sink(dut)
        await _source(dut).send([1, 0, 1])
        assert await sink.wait_for(3) == [1, 0, 1]
        sink.stop()
        dut.out_ready.value = 0
        await RisingEdge(dut.clk)
