"""Bench: text is converted to the same bytes as by the host."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.compact.cases import form_of, frames
from gateware.bench.streams import Sink, Source, start
from unity_link.protocol.wire.compact import Unpacker

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _pass(dut: SimHandleBase, text: bytes, *, compact: bool, pause: float) -> bytes:
    dut.in_mark.value = 0
    dut.compact.value = int(compact)
    await start(dut.clk, dut.rst)
    source = Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, dut.out_data, dut.out_valid, dut.out_ready, pause=pause)
    await source.send([*text])
    await sink.wait_for(1)
    while dut.busy.value == 1:
        await cocotb.triggers.RisingEdge(dut.clk)
    return bytes(entry for entry in sink.received if isinstance(entry, int))


@cocotb.test
async def what_leaves_has_the_text_that_came_and_is_shorter(dut: SimHandleBase) -> None:
    form = form_of(dut, from_gateway=True)
    for pause in (0.0, 0.4):
        # Without plain frames, because they have no compact form.
        text = frames(form, random.Random(1), 300).replace(b"\r", b"")
        packed = await _pass(dut, text, compact=True, pause=pause)
        assert Unpacker(form).unpack(packed) == text
        assert len(packed) < 0.8 * len(text)


@cocotb.test
async def text_passes_where_the_session_has_asked_for_nothing_else(dut: SimHandleBase) -> None:
    form = form_of(dut, from_gateway=True)
    text = frames(form, random.Random(2), 100)
    assert await _pass(dut, text, compact=False, pause=0.2) == text
