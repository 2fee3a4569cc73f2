"""Bench: bodies become requests with their fields, or with the errors that the protocol defines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

UNKNOWN, MALFORMED = 2, 3
COMMANDS = ("R", "RM", "RQ", "WK", "W", "WM", "WQ", "WS", "GS", "GN", "GX", "GP", "I", "H", "Q", "K")
"""In the order of their codes."""


class _Decoder:
    """Passes bodies to the decoder, and reads requests and stored words from it."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.dut = dut
        self.stored: dict[int, int] = {}
        cocotb.start_soon(self._watch())

    async def _watch(self) -> None:
        while True:
            await RisingEdge(self.dut.clk)
            if self.dut.store.value == 1:
                self.stored[int(self.dut.store_index.value)] = int(self.dut.store_word.value)

    async def shift(self) -> None:
        """Shift the number by a digit."""
        self.dut.number_shift.value = 1
        await RisingEdge(self.dut.clk)
        self.dut.number_shift.value = 0
        await RisingEdge(self.dut.clk)

    async def give(self, data: int, *, last: bool = False, plain: bool = False, error: int = 0, most: int = 20) -> bool:
        """Send one character or end, and return whether it was accepted."""
        dut = self.dut
        dut.in_data.value, dut.in_last.value, dut.in_plain.value, dut.in_error.value = data, last, plain, error
        dut.in_valid.value = 1
        for _ in range(most):
            await ReadOnly()
            taken = dut.in_ready.value == 1
            await RisingEdge(dut.clk)
            if taken:
                break
        dut.in_valid.value = 0
        return taken

    async def body(self, body: bytes, *, plain: bool = False, error: int = 0) -> None:
        """Send a whole body and its end, and wait for the request."""
        self.stored.clear()
        for byte in body:
            assert await self.give(byte)
        assert await self.give(0, last=True, plain=plain, error=error)
        await ReadOnly()
        assert self.dut.request_valid.value == 1
        await RisingEdge(self.dut.clk)

    async def accept(self) -> None:
        """Accept the request."""
        self.dut.request_accept.value = 1
        await RisingEdge(self.dut.clk)
        self.dut.request_accept.value = 0
        await RisingEdge(self.dut.clk)

    def field(self, name: str) -> int:
        """Return a field of the request."""
        return int(getattr(self.dut, f"request_{name}").value)

    async def error_of(self, body: bytes, *, plain: bool = False) -> int:
        """Return the error of a body."""
        await self.body(body, plain=plain)
        error = self.field("error")
        await self.accept()
        return error


async def _begin(dut: SimHandleBase) -> _Decoder:
    for name in ("in_data", "in_valid", "in_last", "in_plain", "in_error", "in_silent", "request_accept", "hold"):
        getattr(dut, name).value = 0
    for name in ("hold_letters", "in_residue", "in_session", "for_program", "number_shift"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    return _Decoder(dut)


@cocotb.test
async def each_command_gives_its_fields(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for body, command, fields in (
        (b"R0A", "R", {"address": 0x0A, "count": 1}),
        (b"rm1230A10", "RM", {"address": 0x0A, "count": 0x10, "id": 0x123}),
        (b"RQ0bfF", "RQ", {"address": 0x0B, "count": 0xFF}),
        (b"W0A00000012", "W", {"address": 0x0A, "count": 1, "word": 0x12}),
        (b"wm0000A1111111122222222", "WM", {"count": 2, "word": 0x22222222}),
        (b"WK0AFFFF000012345678", "WK", {"count": 1, "word": 0x12345678}),
        (b"gs00703000102030102", "GS", {}),
        (b"GS03180102020A0B", "GS", {"group": 3, "flags": 0x18, "number": 0x0102, "count": 2}),
        (b"GN0F", "GN", {"group": 0x0F}),
        (b"I02", "I", {"group": 2}),
        (b"h7FE", "H", {"id": 0x7FE}),
        (b"Q", "Q", {}),
        (b"KA5C1234", "K", {"id": 0xA5C, "number": 0x1234, "asks": 0}),
        (b"K", "K", {"asks": 1}),
    ):
        await decoder.body(body)
        if body.startswith(b"gs"):
            # The count is three addresses, but there are two.
            assert decoder.field("error") == MALFORMED
        else:
            assert decoder.field("error") == 0, body
            assert decoder.field("out_of_range") == 0, body
            assert COMMANDS[decoder.field("command")] == command
            assert decoder.field("has_id") == body[:1].islower()
            assert {name: decoder.field(name) for name in fields} == fields
        await decoder.accept()


@cocotb.test
async def words_are_stored_in_order(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    words = [index * 0x01020304 for index in range(50)]
    await decoder.body(b"WM10" + b"".join(b"%08X" % word for word in words))
    await decoder.accept()
    assert decoder.stored == dict(enumerate(words))
    await decoder.body(b"GS0000000103102030")
    await decoder.accept()
    assert decoder.stored == {0: 0x10, 1: 0x20, 2: 0x30}


@cocotb.test
async def a_plain_write_may_have_fewer_digits(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for digits in range(1, 9):
        body = b"W0A" + b"1" * digits
        assert await decoder.error_of(body) == (0 if digits == 8 else MALFORMED)
        await decoder.body(b"WM10FFFFFFFF")
        await decoder.accept()
        await decoder.body(body, plain=True)
        assert decoder.field("error") == 0
        assert decoder.field("word") == int(b"1" * digits, 16)
        await decoder.accept()
    for body in (b"W0A", b"WM0A1", b"WK0A1", b"W0A123456789"):
        assert await decoder.error_of(body, plain=True) == MALFORMED


@cocotb.test
async def what_is_no_command_is_unknown(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for body in (
        b"0A",
        b"",
        b"Y",
        b"Rm0A01",
        b"rM0A01",
        b"RMM0A01",
        b"q",
        b"k000",
        b"G00",
        b"GZ00",
        b"WX",
        b"\xd20A",
        b" R0A",
    ):
        assert await decoder.error_of(body, plain=not body) == UNKNOWN, body


@cocotb.test
async def fields_of_the_wrong_width_or_not_hex_are_malformed(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for body in (
        *(
            b"R",
            b"R0",
            b"R0AB",
            b"R0G",
            b"r00",
            b"r0000",
            b"RM0A0",
            b"RM0A011",
            b"H0",
            b"h00",
            b"h0000",
            b"Q0",
            b"K00",
            b"K000",
            b"K000123",
            b"K00012345",
        ),
        *(
            b"WM10",
            b"WM101111111",
            b"WM10" + b"0" * 8 * 256,
            b"WK0A" + b"0" * 24,
            b"GS000000010210",
            b"GN0",
            b"I2",
            b"R 0A",
        ),
    ):
        assert await decoder.error_of(body) == MALFORMED, body


@cocotb.test
async def values_that_the_gateway_does_not_have_are_out_of_range(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for body, outside in (
        *((b"RM0A00", 1), (b"RM0AFF", 0), (b"GN0F", 0), (b"GN10", 1), (b"I02", 0), (b"I03", 1)),
        *((b"GS0000000100", 1), (b"GS000000000110", 1), (b"GS008000010110", 1), (b"GS004000010110", 1)),
        *((b"GS00000001" + b"21" + b"10" * 33, 1), (b"GS00000001" + b"20" + b"10" * 32, 0), (b"GS100000010110", 1)),
        *((b"K0000000", 1), (b"K0000001", 0), (b"K0007FFF", 0), (b"K0008000", 1), (b"K", 0), (b"K0001000", 0)),
    ):
        await decoder.body(body)
        assert decoder.field("error") == 0, body
        assert decoder.field("out_of_range") == outside, body
        await decoder.accept()


@cocotb.test
async def plain_samples_are_out_of_range_in_a_programs_session(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for for_program in (0, 1):
        dut.for_program.value = for_program
        for flags, outside in ((0x20, for_program), (0x10, 0)):
            await decoder.body(b"GS00%02X00010110" % flags)
            assert (decoder.field("error"), decoder.field("out_of_range")) == (0, outside)
            await decoder.accept()


@cocotb.test
async def without_a_session_the_number_is_what_the_check_of_a_request_with_an_id_left(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    dut.in_residue.value = 0xA5C3
    for in_session, body, plain, number in (
        *((0, b"h123", False, 0xA5C3), (0, b"h123", True, 0), (0, b"gs12300000FFF0110", False, 0xA5C3)),
        *((1, b"gs12300000FFF0110", False, 0x0FFF), (0, b"GS00000FFF0110", False, 0x0FFF)),
    ):
        dut.in_session.value = in_session
        await decoder.body(body, plain=plain)
        assert (decoder.field("error"), decoder.field("number")) == (0, number), body
        await decoder.accept()


@cocotb.test
async def the_digits_of_a_number_go_round_and_nothing_else_is_taken_behind_a_k(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    await decoder.body(b"K0001234")
    dut.hold.value = dut.hold_letters.value = 1
    await decoder.accept()
    assert not await decoder.give(ord("r"))
    for number in (0x2341, 0x3412, 0x4123, 0x1234):
        await decoder.shift()
        assert decoder.field("number") == number
    dut.hold_letters.value = 0
    assert await decoder.give(ord("r"))


@cocotb.test
async def a_group_publishes_by_itself_unless_the_medium_is_half_duplex(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for flags in range(4):
        await decoder.body(b"GS00%02X00010110" % flags)
        assert decoder.field("error") == 0
        assert decoder.field("out_of_range") == (flags != 0 and int(dut.half_duplex.value)), flags
        await decoder.accept()


@cocotb.test
async def the_error_of_the_frame_goes_before_all_else(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    for error in (1, 7, 9):
        await decoder.body(b"Y!", error=error)
        assert decoder.field("error") == error
        await decoder.accept()
    assert await decoder.error_of(b"H") == 0


@cocotb.test
async def fields_stand_still_while_held_and_letters_and_id_go_on(dut: SimHandleBase) -> None:
    decoder = await _begin(dut)
    await decoder.body(b"R0A")
    dut.hold.value = 1
    await decoder.accept()
    for byte in b"w123":
        assert await decoder.give(byte)
    assert not await decoder.give(ord("F"))
    assert decoder.field("address") == 0x0A
    dut.hold.value = 0
    for byte in b"FF00000001":
        assert await decoder.give(byte)
    assert await decoder.give(0, last=True)
    await ReadOnly()
    assert (decoder.field("address"), decoder.field("id"), decoder.field("word")) == (0xFF, 0x123, 1)
