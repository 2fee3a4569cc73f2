"""Bench: bodies become frames without gaps, with their mark beside the last character."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import Joined, Sink, Source, start
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import in_session

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

POLYNOMIAL = 0x1021
"""The default polynomial; a CRC uses as many of its low bits as it has."""


def _joined(dut: SimHandleBase) -> Joined:
    return Joined((dut.in_data, 8), (dut.in_last, 1), (dut.in_plain, 1), (dut.in_mark, 2))


def _entries(body: bytes, plain: int, mark: int) -> list[int]:
    return [byte | int(index == len(body) - 1) << 8 | plain << 9 | mark << 10 for index, byte in enumerate(body)]


async def _send(
    dut: SimHandleBase, bodies: list[tuple[bytes, int, int]], pause: float, session: int = 0
) -> list[tuple[int, ...]]:
    dut.in_valid.value = 0
    dut.out_ready.value = 0
    dut.session.value, dut.in_session.value = session, session != 0
    _joined(dut).value = 0
    await start(dut.clk, dut.rst)
    source = Source(dut.clk, _joined(dut), dut.in_valid, dut.in_ready, pause=pause)
    sink = Sink(dut.clk, (dut.out_data, dut.out_mark), dut.out_valid, dut.out_ready, pause=pause)
    await source.send(entry for body in bodies for entry in _entries(*body))
    for _ in range(60):
        await RisingEdge(dut.clk)
    assert dut.busy.value == 0
    return sink.received


def _frames(dut: SimHandleBase, bodies: list[tuple[bytes, int, int]], session: int = 0) -> list[tuple[int, ...]]:
    bits, node = int(dut.crc_bits.value), int(dut.node.value)
    crc = Crc(bits, POLYNOMIAL % 2**bits)
    # cocotb returns a negative generic as a large number.
    prefix = b"" if node > 254 else b"Z%02X" % node
    expected = []
    for body, plain, mark in bodies:
        covered = prefix + body
        seed = seed_of(session, from_gateway=True) if in_session(body[0]) else 0
        check = crc.text(body, crc.of(prefix) ^ seed)
        frame = covered + (b"\r\n" if plain else check + b"\n")
        expected += [(byte, mark if index == len(frame) - 1 else 0) for index, byte in enumerate(frame)]
    return expected


@cocotb.test
async def bodies_become_frames(dut: SimHandleBase) -> None:
    bodies = [(b"R0A00000012", 0, 1), (b"R0A00000012", 1, 2), (b"H", 0, 0), (b"X01", 0, 2)]
    assert await _send(dut, bodies, 0.0) == _frames(dut, bodies)


@cocotb.test
async def the_session_is_in_the_check_of_samples_and_of_what_begins_with_a_small_letter(dut: SimHandleBase) -> None:
    letters = (b"R", b"W", b"G", b"I", b"H", b"Q", b"K", b"X", b"P", b"r", b"w", b"g", b"i", b"h", b"x", b"n")
    bodies = [(letter + b"01", 0, 0) for letter in letters]
    for session in (0, 1, 0x5A, 0x7F):
        assert await _send(dut, bodies, 0.0, session) == _frames(dut, bodies, session)


@cocotb.test
async def frames_survive_back_pressure(dut: SimHandleBase) -> None:
    rng = random.Random(9)
    bodies = [
        (
            rng.choice((b"R", b"x", b"P")) + bytes(rng.choice(b"0123456789ABCDEF") for _ in range(rng.randrange(20))),
            rng.randrange(2),
            rng.randrange(3),
        )
        for _ in range(150)
    ]
    assert await _send(dut, bodies, 0.4, 0x5A) == _frames(dut, bodies, 0x5A)


@cocotb.test
async def a_frame_follows_the_next_without_a_gap(dut: SimHandleBase) -> None:
    dut.out_ready.value = 1
    gaps = 0

    async def watch() -> None:
        nonlocal gaps
        begun = False
        while True:
            await RisingEdge(dut.clk)
            begun = begun or dut.out_valid.value == 1
            gaps += begun and dut.out_valid.value == 0 and dut.in_valid.value == 1

    bodies = [(b"R0A00000012", 0, 0)] * 20
    task = None
    dut.in_valid.value = 0
    _joined(dut).value = 0
    dut.session.value = dut.in_session.value = 0
    await start(dut.clk, dut.rst)
    task = cocotb.start_soon(watch())
    source = Source(dut.clk, _joined(dut), dut.in_valid, dut.in_ready)
    await source.send(entry for body in bodies for entry in _entries(*body))
    task.cancel()
    assert gaps == 0
