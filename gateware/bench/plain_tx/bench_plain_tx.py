"""Bench: CR LF follows each body, and the mark is output with the LF."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles

from gateware.bench.streams import Joined, Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _send(dut: SimHandleBase, bodies: list[tuple[bytes, int]], pause: float) -> list[tuple[int, ...]]:
    dut.in_valid.value = 0
    dut.in_data.value = dut.in_last.value = dut.in_mark.value = dut.out_ready.value = 0
    await start(dut.clk, dut.rst)
    joined = Joined((dut.in_data, 8), (dut.in_last, 1), (dut.in_mark, 2))
    source = Source(dut.clk, joined, dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, (dut.out_data, dut.out_mark), dut.out_valid, dut.out_ready, pause=pause)
    for body, mark in bodies:
        await source.send(byte | (index == len(body) - 1) << 8 | mark << 9 for index, byte in enumerate(body))
    await ClockCycles(dut.clk, 20)
    assert dut.busy.value == 0
    sink.stop()
    return sink.received


def _lines(bodies: list[tuple[bytes, int]]) -> list[tuple[int, ...]]:
    return [entry for body, mark in bodies for entry in (*((byte, 0) for byte in body), (13, 0), (10, mark))]


@cocotb.test
async def bodies_become_lines(dut: SimHandleBase) -> None:
    bodies = [(b"R0A00000012", 1), (b"H", 0), (b"X01", 2)]
    assert await _send(dut, bodies, 0.0) == _lines(bodies)


@cocotb.test
async def lines_survive_back_pressure(dut: SimHandleBase) -> None:
    rng = random.Random(9)
    bodies = [(rng.randbytes(rng.randrange(1, 20)), rng.randrange(3)) for _ in range(150)]
    assert await _send(dut, bodies, 0.4) == _lines(bodies)
