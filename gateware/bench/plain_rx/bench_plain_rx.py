"""Bench: every line is a frame, whichever line end it has, and a lost byte is reported at its end."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles

from gateware.bench.streams import Joined, Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

LOST, OVERFLOW = 1 << 8, 9


async def _frames(dut: SimHandleBase, data: bytes, lost: frozenset[int] = frozenset(), pause: float = 0.0) -> list:
    """Send characters; return body and error of each frame."""
    dut.in_data.value = dut.in_lost.value = dut.out_ready.value = 0
    dut.in_valid.value = 0
    await start(dut.clk, dut.rst)
    source = Source(dut.clk, Joined((dut.in_data, 8), (dut.in_lost, 1)), dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, (dut.out_last, dut.out_data, dut.out_error), dut.out_valid, dut.out_ready, pause=pause)
    await source.send(byte | (LOST if index in lost else 0) for index, byte in enumerate(data))
    sink.pause = 0.0
    await ClockCycles(dut.clk, 20)
    sink.stop()
    frames, body = [], bytearray()
    for last, character, error in sink.received:
        if last:
            frames.append((bytes(body), error))
            body.clear()
        else:
            assert error == 0
            body.append(character)
    assert dut.busy.value == bool(body)
    return frames


@cocotb.test
async def cr_and_lf_both_end_a_frame_and_empty_lines_are_none(dut: SimHandleBase) -> None:
    assert await _frames(dut, b"R0A\rH\nQ\r\n\n\r\r\nW0A1\r") == [(b"R0A", 0), (b"H", 0), (b"Q", 0), (b"W0A1", 0)]


@cocotb.test
async def a_frame_is_not_ended_by_anything_else(dut: SimHandleBase) -> None:
    body = bytes(code for code in range(256) if code not in b"\r\n") * 10
    assert await _frames(dut, body + b"\r") == [(body, 0)]
    assert await _frames(dut, b"R0A") == []


@cocotb.test
async def a_lost_byte_is_told_at_the_end_of_its_frame_alone(dut: SimHandleBase) -> None:
    for index in range(4):
        bodies = [(b"R0A", OVERFLOW), (b"H", 0)]
        assert await _frames(dut, b"R0A\rH\r", frozenset({index})) == bodies, index
    # All bytes of the line except its end were lost.
    assert await _frames(dut, b"\r\rH\r", frozenset({1})) == [(b"", OVERFLOW), (b"H", 0)]


@cocotb.test
async def random_lines_pass_under_back_pressure(dut: SimHandleBase) -> None:
    rng = random.Random(2)
    data, expected, lost = b"", [], set()
    for _ in range(150):
        body = bytes(rng.choice(b"RW0123456789\x00\xff") for _ in range(rng.randrange(12)))
        hit = rng.random() < 0.1
        if hit:
            lost.add(len(data) + rng.randrange(len(body) + 1))
        if body or hit:
            expected.append((body, OVERFLOW if hit else 0))
        data += body + rng.choice((b"\r", b"\n"))
    assert await _frames(dut, data, frozenset(lost), pause=0.4) == expected
