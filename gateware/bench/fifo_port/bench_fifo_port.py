"""Bench: the FIFO port passes bytes, the mark of lost bytes, and the flush after the bytes."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _prepare(dut: SimHandleBase) -> None:
    for name in ("in_data", "in_lost", "in_valid", "out_ready", "rx_ready", "tx_data", "tx_valid", "flush"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)


@cocotb.test
async def bytes_pass_in_both_directions(dut: SimHandleBase) -> None:
    await _prepare(dut)
    inward = Sink(dut.clk, dut.rx_data, dut.rx_valid, dut.rx_ready, pause=0.4)
    outward = Sink(dut.clk, dut.out_data, dut.out_valid, dut.out_ready, pause=0.4, rng=random.Random(9))
    data = random.Random(8).randbytes(200)
    sender = cocotb.start_soon(Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready, pause=0.3).send(data))
    await Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready, pause=0.3).send(data[::-1])
    await sender
    assert await inward.wait_for(len(data)) == list(data)
    assert await outward.wait_for(len(data)) == list(data[::-1])


@cocotb.test
async def the_mark_of_a_loss_stands_at_its_byte(dut: SimHandleBase) -> None:
    await _prepare(dut)
    dut.in_valid.value = 1
    dut.in_lost.value = 1
    await ReadOnly()
    assert (dut.rx_valid.value, dut.rx_lost.value) == (1, 1)


@cocotb.test
async def a_flush_comes_after_the_byte_that_left_with_it(dut: SimHandleBase) -> None:
    await _prepare(dut)
    dut.tx_valid.value = 1
    dut.out_ready.value = 1
    dut.flush.value = 1
    await ReadOnly()
    assert (dut.out_valid.value, dut.out_flush.value) == (1, 0)
    await RisingEdge(dut.clk)
    dut.tx_valid.value = 0
    dut.flush.value = 0
    await ReadOnly()
    assert (dut.out_valid.value, dut.out_flush.value) == (0, 1)
    await RisingEdge(dut.clk)
    await ReadOnly()
    assert dut.out_flush.value == 0
