"""Bench: the gateware answers a file of vectors (tests/vectors) byte for byte."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import cocotb

from gateware.bench.unity_link.gateway import Gateway
from unity_link.protocol.wire.compact import cut, is_sample

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


def _records() -> list[dict[str, Any]]:
    return [json.loads(line) for line in Path(os.environ["VECTORS"]).read_text().splitlines()]


@cocotb.test
async def it_answers_the_vectors(dut: SimHandleBase) -> None:
    header, *steps = _records()
    prefix = b"" if header["node"] is None else b"Z%02X" % header["node"]
    pause = float(os.environ["PAUSE"])
    gateway = Gateway(dut, pause_in=pause, pause_out=pause)
    await gateway.begin()
    for step in steps:
        gateway.send(step["send"].encode("latin-1"))
    await gateway.quiet(1000)
    frames = cut(gateway.take())
    is_publish = [is_sample(frame, prefix) for frame in frames]
    answers = [frame for frame, publish in zip(frames, is_publish, strict=True) if not publish]
    publishes = [frame for frame, publish in zip(frames, is_publish, strict=True) if publish]
    for step in steps:
        for name, got in (("answers", answers), ("publishes", publishes)):
            expected = cut(step.get(name, "").encode("latin-1"))
            assert got[: len(expected)] == expected, f"{step}: {got[: len(expected) + 1]}"
            del got[: len(expected)]
    assert not answers
    assert not publishes
