"""Bench: frames are separated and checked, for any input, under random back pressure."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.streams import Joined, Sink, Source, start
from unity_link.protocol.wire.crc import Crc, seed_of

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

CRC, TOO_LONG, OVERFLOW = 1, 7, 9
POLYNOMIAL = 0x1021
"""The default polynomial; a CRC uses as many of its low bits as it has."""
LOST = 1 << 8


class _Bench:
    """The entity between a source of characters (with a bit for lost bytes) and a sink of bodies."""

    def __init__(self, dut: SimHandleBase, pause: float) -> None:
        self.dut = dut
        self.digits = int(dut.crc_bits.value) // 4
        self.crc = Crc(4 * self.digits, POLYNOMIAL % 16**self.digits)
        self.longest = int(dut.longest.value)
        # cocotb returns a negative generic as a large number.
        self.node = int(dut.node.value) if int(dut.node.value) < 255 else -1
        self.prefix = b"" if self.node < 0 else b"Z%02X" % self.node
        self._source = Source(
            dut.clk, Joined((dut.in_data, 8), (dut.in_lost, 1)), dut.in_valid, dut.in_ready, pause=pause
        )
        signals = (dut.out_last, dut.out_data, dut.out_plain, dut.out_error, dut.out_silent)
        self._sink = Sink(dut.clk, signals, dut.out_valid, dut.out_ready, pause=pause)

    async def frames(self, data: bytes, lost: frozenset[int] = frozenset()) -> list[tuple[bytes, int, int, int]]:
        """Send characters; return body, plain, error and silent of each frame."""
        await self._source.send(byte | (LOST if index in lost else 0) for index, byte in enumerate(data))
        for _ in range(30 * self.digits):
            await cocotb.triggers.RisingEdge(self.dut.clk)
        received, body = [], bytearray()
        for last, character, plain, error, silent in self._sink.received:
            if last:
                received.append((bytes(body), plain, error, silent))
                body.clear()
            else:
                body.append(character)
        assert not body
        self._sink.received.clear()
        return received

    def checked(self, body: bytes, session: int = 0) -> bytes:
        begun = self.crc.of(self.prefix) ^ (seed_of(session, from_gateway=False) if body[:1].islower() else 0)
        return self.prefix + body + self.crc.text(body, begun) + b"\n"

    def begin(self, session: int) -> None:
        self.dut.session.value, self.dut.in_session.value = session, session != 0


async def _bench(dut: SimHandleBase, pause: float = 0.0) -> _Bench:
    dut.in_valid.value = 0
    dut.in_data.value = 0
    dut.in_lost.value = 0
    dut.out_ready.value = 0
    dut.session.value = dut.in_session.value = 0
    await start(dut.clk, dut.rst)
    return _Bench(dut, pause)


@cocotb.test
async def a_checked_frame_gives_its_body_without_the_check(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    for body in (b"R0A", b"H", b"W0A00000012"):
        assert await bench.frames(bench.checked(body)) == [(body, 0, 0, 0)]
    if not bench.prefix and bench.digits == 4:
        assert await bench.frames(b"R0A6DDE\n") == [(b"R0A", 0, 0, 0)]


@cocotb.test
async def the_check_may_be_in_lower_case(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    frame = bench.checked(b"R0A")
    check = frame[-1 - bench.digits :].lower()
    assert await bench.frames(frame[: -len(check)] + check) == [(b"R0A", 0, 0, 0)]


@cocotb.test
async def a_plain_frame_gives_all_characters_however_few(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    for body in (b"Q", b"R0", b"R0A", bytes(range(0x20, 0x60))[: bench.longest]):
        assert await bench.frames(bench.prefix + body + b"\r") == [(body, 1, 0, 0)]


@cocotb.test
async def every_wrong_character_of_a_checked_frame_is_found(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    good = bench.checked(b"R0A")
    for index in range(len(bench.prefix), len(good) - 1):
        damaged = bytearray(good)
        damaged[index] ^= 0x01
        ((_, plain, error, _),) = await bench.frames(bytes(damaged))
        assert (plain, error) == (0, CRC), index
    for short in range(1, bench.digits):
        ((_, plain, error, _),) = await bench.frames(bench.prefix + b"0" * short + b"\n")
        assert (plain, error) == (0, CRC)


@cocotb.test
async def the_session_is_in_the_check_of_what_begins_with_a_small_letter(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    for body in (b"r0120A", b"h012", b"R0A", b"K0121234", b"P0", b"qqq", b"abc", b"{00"):
        seeded = body[:1].islower()
        for session in (0x5A, 0x7F, 1):
            bench.begin(session)
            assert await bench.frames(bench.checked(body, session)) == [(body, 0, 0, 0)]
            for other in (0, session ^ 2):
                ((_, _, error, _),) = await bench.frames(bench.checked(body, other))
                assert error == (CRC if seeded else 0), (body, session, other)


@cocotb.test
async def without_a_session_a_small_letter_is_never_damaged_but_its_check_must_be_digits(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    for session in (0, 0x5A):
        assert await bench.frames(bench.checked(b"h012", session)) == [(b"h012", 0, 0, 0)]
    for body, told in ((b"h012", 0), (b"H012", CRC)):
        assert await bench.frames(bench.prefix + body + b"1" * bench.digits + b"\n") == [(body, 0, told, 0)]
        ((_, _, error, _),) = await bench.frames(bench.prefix + body + b"1" * (bench.digits - 1) + b"g\n")
        assert error == CRC
    ((_, _, error, _),) = await bench.frames(bench.prefix + b"h" + b"1" * (bench.digits - 2) + b"\n")
    assert error == CRC


@cocotb.test
async def empty_frames_are_nothing(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    assert await bench.frames(b"\n\r\r\n\n") == []
    assert await bench.frames(bench.prefix + b"\n" + bench.prefix + b"\r") == []


@cocotb.test
async def a_frame_may_be_as_long_as_the_longest_and_no_longer(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    body = b"0" * (bench.longest - bench.digits)
    assert await bench.frames(bench.checked(body)) == [(body, 0, 0, 0)]
    ((_, plain, error, _),) = await bench.frames(bench.checked(body + b"0"))
    assert (plain, error) == (0, TOO_LONG)
    ((_, plain, error, _),) = await bench.frames(bench.prefix + b"0" * (bench.longest + 1) + b"\r")
    assert (plain, error) == (1, TOO_LONG)
    assert await bench.frames(bench.checked(b"H")) == [(b"H", 0, 0, 0)]


@cocotb.test
async def a_lost_byte_is_told_at_the_end_of_its_frame_before_all_else(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    good = bench.checked(b"R0A")
    for index in range(len(bench.prefix), len(good)):
        frames = await bench.frames(good + good, frozenset({index}))
        assert [frame[2] for frame in frames] == [OVERFLOW, 0]
    assert [frame[2] for frame in await bench.frames(bench.prefix + b"\r", frozenset({len(bench.prefix)}))] == [
        OVERFLOW
    ]


@cocotb.test
async def frames_of_other_nodes_are_not_seen_and_those_to_all_are_silent(dut: SimHandleBase) -> None:
    bench = await _bench(dut)
    if bench.node < 0:
        return
    other = b"Z%02X" % (bench.node ^ 0x10)
    for prefix in (other, b"", b"Z", b"Z0", b"z%02X" % bench.node, b"ZGG"):
        body = prefix + b"R0A"
        assert await bench.frames(body + bench.crc.text(body) + b"\n" + body + b"\r") == []
    bench.begin(0x5A)
    body = b"ZFFW0A1"
    assert await bench.frames(body + bench.crc.text(body) + b"\n") == [(b"W0A1", 0, 0, 1)]
    assert await bench.frames((b"Z%02X" % bench.node).lower().replace(b"z", b"Z") + b"H\r") == [(b"H", 1, 0, 0)]


@cocotb.test
async def random_frames_pass_under_back_pressure(dut: SimHandleBase) -> None:
    bench = await _bench(dut, pause=0.4)
    rng = random.Random(7)
    bench.begin(0x33)
    data, expected = b"", []
    for _ in range(200):
        body = bytes(rng.choice(b"RrW0123456789ABCDEFabcdef\x00\xff") for _ in range(rng.randrange(1, 30)))
        plain = rng.random() < 0.4
        wrong = not plain and rng.random() < 0.3
        frame = bench.prefix + body + b"\r" if plain else bench.checked(body, 0x33)
        if wrong:
            frame = frame[:-2] + (b"0\n" if frame[-2:-1] != b"0" else b"1\n")
        data += frame
        expected.append((body, int(plain), CRC if wrong else 0, 0))
    assert await bench.frames(data) == expected
