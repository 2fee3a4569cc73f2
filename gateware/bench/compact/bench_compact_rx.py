"""Bench: frames in compact form, text and noise are converted to the same text as by the host."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.compact.cases import damaged, form_of, frames, text_of
from gateware.bench.streams import Sink, Source, start
from unity_link.protocol.wire.compact import Packer

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


async def _pass(dut: SimHandleBase, data: list[int], text: bytes, pause: float) -> list[int]:
    dut.in_lost.value = 0
    await start(dut.clk, dut.rst)
    source = Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, (dut.out_data, dut.out_lost), dut.out_valid, dut.out_ready, pause=pause)
    await source.send(data)
    await sink.wait_for(len(text))
    entries = [entry for entry in sink.received if isinstance(entry, tuple)]
    found = bytes(character for character, _ in entries)
    at = next((at for at, (one, other) in enumerate(zip(found, text, strict=True)) if one != other), len(text))
    assert (at, found[at - 20 : at + 20]) == (len(text), text[at - 20 : at + 20])
    return [lost for _, lost in entries]


@cocotb.test
async def frames_in_both_forms_become_their_text(dut: SimHandleBase) -> None:
    form, rng = form_of(dut, from_gateway=False), random.Random(1)
    for pause in (0.0, 0.4):
        packed = Packer(form).pack(frames(form, rng, 300))
        assert not any(await _pass(dut, [*packed], text_of(form, packed), pause))


@cocotb.test
async def damaged_bytes_become_what_they_are_to_the_host(dut: SimHandleBase) -> None:
    form, rng = form_of(dut, from_gateway=False), random.Random(2)
    data = damaged(Packer(form).pack(frames(form, rng, 600)), rng) + b"\n"
    await _pass(dut, [*data], text_of(form, data), 0.0)
