"""The gateway model follows the protocol where single vectors do not suffice: sequences, damage, memory limits."""

from __future__ import annotations

import asyncio
import tracemalloc
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.errors import ArgumentError, BusError, UnsupportedError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.messages import LOOKING, Codec, ErrorCode
from unity_link.virtual import AccessError, VirtualGateway
from unity_link.virtual.faults import Failing

CODEC = Codec(GatewayInfo())
RING = CODEC.id_count
SESSION = 0x1234


def frame(command: str, number: int, *fields: Any, session: int = SESSION) -> bytes:
    seed = seed_of(session, from_gateway=False)
    return CODEC.request(command, number % RING, CODEC.fields(command, *fields), seed)


def reply(body: bytes, session: int = SESSION) -> bytes:
    """Return a checked frame of a gateway in a session."""
    return CODEC.framing.checked(body, seed_of(session, from_gateway=True))


def in_session(gateway: VirtualGateway, first: int = 0, session: int = SESSION) -> VirtualGateway:
    """Open a program's session with a gateway."""
    answer = gateway.receive(CODEC.framing.checked(CODEC.opening(first, session)), 0.0)
    assert answer.startswith(CODEC.opening(first, session))
    return gateway


class Counting:
    """A device that counts its accesses."""

    def __init__(self) -> None:
        self.reads = 0
        self.writes: list[int] = []

    def read(self, offset: int, now: float) -> int:
        self.reads += 1
        return self.reads

    def write(self, offset: int, value: int, now: float) -> None:
        self.writes.append(value)


@given(
    steps=st.lists(
        st.tuples(st.sampled_from(["w", "ws", "wq", "again", "ahead", "behind"]), st.integers(1, RING // 2 - 1))
    ),
    first=st.integers(0, RING - 1),
)
def test_writes_are_executed_once_each_and_in_order(steps: list[tuple[str, int]], first: int) -> None:
    gateway, device = in_session(VirtualGateway(), first), Counting()
    gateway.attach(device, [0x10])
    expected, value, told = first, 0, False
    for kind, distance in steps:
        if kind in ("w", "ws", "wq"):
            value += 1
            word: Any = [value] if kind == "wq" else value
            answer = gateway.receive(frame(kind.upper(), expected, 0x10, word), 0.0)
            assert answer == (b"" if kind == "ws" else reply(b"%b%03X" % (kind.encode(), expected)))
            expected, told = (expected + 1) % RING, False
        elif kind == "ahead":
            answer = gateway.receive(frame("W", expected + distance, 0x10, 0xBAD), 0.0)
            assert answer == (b"" if told else reply(b"n%03X" % expected))
            told = True
        else:
            number = (expected - (1 if kind == "again" else distance)) % RING
            assert gateway.receive(frame("W", number, 0x10, 0xBAD), 0.0) == reply(b"w%03X" % number)
    assert device.writes == list(range(1, value + 1))


@given(data=st.binary(max_size=300), cuts=st.lists(st.integers(0, 300), max_size=5))
def test_arbitrary_bytes_do_no_harm_however_they_are_cut(data: bytes, cuts: list[int]) -> None:
    whole, pieces = VirtualGateway(), VirtualGateway()
    expected = whole.receive(data, 0.0)
    places = [0, *sorted(cuts), len(data)]
    assert b"".join(pieces.receive(data[a:b], 0.0) for a, b in pairwise(places)) == expected
    assert whole.receive(b"\nH\r", 0.0).endswith(b"H\r\n")


@given(
    requests=st.lists(
        st.tuples(
            st.sampled_from(["R", "W", "WS", "H", "K", "reset"]),
            st.integers(-2, 2),
            st.integers(0, 0x3FF),
            st.integers(0, 0x7FFF),
            st.sampled_from([bytes, bytes.lower, bytes.swapcase, lambda text: text[:-2] + b"0\n"]),
        )
    )
)
def test_the_short_path_for_single_words_has_the_answers_of_the_long_one(requests: list[tuple[Any, ...]]) -> None:
    info = GatewayInfo(address_bits=9, data_bits=14)
    codec = Codec(info)
    quick, slow = VirtualGateway(info), VirtualGateway(info)
    for gateway in (quick, slow):
        gateway.attach(Failing(), [7])
    slow._quick_sizes = (-1, -1, -1)
    for command, offset, address, word, spelling in requests:
        number = (quick.expected + offset) % RING
        if command == "reset":
            quick.reset()
            slow.reset()
            continue
        if command == "K":
            form = codec.framing.plain_request if word & 1 else codec.framing.checked
            data = form(codec.opening(number, word))
        else:
            values = {"R": (address,), "W": (address, word), "WS": (address, word), "H": ()}[command]
            seed = seed_of(quick.session + (word == 5), from_gateway=False)
            data = spelling(codec.request(command, number, codec.fields(command, *values), seed))
        assert quick.receive(data, 0.0) == slow.receive(data, 0.0)
        assert (quick.session, quick.expected, quick.memory) == (slow.session, slow.expected, slow.memory)
        assert quick._sequence.gap_reported == slow._sequence.gap_reported
        assert quick._sequence.outcomes == slow._sequence.outcomes


def test_a_repeated_read_is_executed_again_unless_it_is_destructive() -> None:
    gateway, device = in_session(VirtualGateway()), Counting()
    gateway.attach(device, [0x10])
    assert gateway.receive(frame("R", 0, 0x10), 0.0) == reply(b"r00000000001")
    assert gateway.receive(frame("R", 0, 0x10), 0.0) == reply(b"r00000000002")
    for _ in range(2):
        assert gateway.receive(frame("RQ", 1, 0x10, 2), 0.0) == reply(b"rq0010000000300000004")
    # The second word of the queue read has the same storage place, and the first word is still stored.
    for _ in range(2):
        assert gateway.receive(frame("WK", 2, 0x10, 0xFF, 0x77), 0.0) == reply(b"wk00200000005")
    assert gateway.receive(frame("RQ", 1, 0x10, 1), 0.0) == reply(b"rq00100000003")
    assert device.reads == 5
    assert device.writes == [0x77]


@pytest.mark.parametrize("code", [ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT])
def test_a_repetition_of_a_failed_request_is_answered_by_its_error(code: ErrorCode) -> None:
    gateway = in_session(VirtualGateway())
    gateway.attach(Failing(code), [0x10])
    requests: list[tuple[Any, ...]] = [
        ("W", 0x10, 1),
        ("R", 0x10),
        ("WS", 0x10, 1),
        ("RQ", 0x10, 2),
        ("WM", 0x0F, [1, 2]),
    ]
    refused = [reply(b"x%03X%02X" % (number, code)) for number in range(len(requests))]
    for number, (command, *values) in enumerate(requests):
        assert gateway.receive(frame(command, number, *values), 0.0) == refused[number]
    gateway.detach([0x10])
    for number, (command, *values) in enumerate(requests):
        assert gateway.receive(frame(command, number, *values), 0.0) == refused[number]
        assert gateway.receive(frame("H", number), 0.0) == refused[number]


def test_an_h_returns_the_count_of_failed_posted_writes_of_the_session() -> None:
    gateway = in_session(VirtualGateway())
    gateway.attach(Failing(), [0x10])
    number = 0
    for address in (0x10, 0x11, 0x10):
        gateway.receive(frame("WS", number, address, 1), 0.0)
        number += 1
    gateway.receive(frame("W", number, 0x10, 1), 0.0)
    assert gateway.receive(frame("H", number + 1), 0.0) == reply(b"h004002")
    in_session(gateway, 9, SESSION + 1)
    assert gateway.receive(frame("H", 9, session=SESSION + 1), 0.0) == reply(b"h009000", SESSION + 1)


def test_frames_of_another_session_or_direction_count_as_damaged() -> None:
    gateway, device = in_session(VirtualGateway()), Counting()
    gateway.attach(device, [0x10])
    for session in (SESSION + 1, 0):
        assert gateway.receive(frame("W", 0, 0x10, 1, session=session), 0.0) == CODEC.framing.checked(b"X01")
    assert gateway.receive(reply(b"w0001000000001"), 0.0) == CODEC.framing.checked(b"X01")
    assert device.writes == []


@pytest.mark.parametrize("command", sorted(set(CODEC.commands) - LOOKING))
def test_requests_that_change_state_need_an_id_in_a_programs_session(command: str) -> None:
    values: dict[str, tuple[Any, ...]] = {
        "W": (0x10, 1),
        "WS": (0x10, 1),
        "WM": (0x10, [1]),
        "WQ": (0x10, [1]),
        "WK": (0x10, 1, 1),
        "RQ": (0x10, 1),
        "GS": (0, 0, 1, 1, [0x10]),
        "I": (0,),
    }
    gateway, device = in_session(VirtualGateway()), Counting()
    gateway.attach(device, [0x10])
    fields = CODEC.fields(command, *values.get(command, (0,)))
    body = command.encode() + fields
    numbered = command.lower().encode() + CODEC.id_text[0] + fields
    assert gateway.receive(CODEC.framing.checked(body), 0.0) == CODEC.framing.checked(b"X0B")
    assert gateway.receive(CODEC.framing.plain_request(body), 0.0) == b"X0B\r\n"
    assert gateway.receive(CODEC.framing.plain_request(numbered), 0.0) == b"x0000B\r\n"
    assert (device.reads, device.writes, gateway.expected) == (0, [], 0)


def test_a_session_opens_once_and_the_answer_names_the_one_it_ends() -> None:
    gateway = in_session(VirtualGateway())
    for form in (CODEC.framing.checked, CODEC.framing.plain_request):
        assert gateway.receive(form(CODEC.opening(5, SESSION)), 0.0).startswith(b"X0B")
    assert gateway.receive(CODEC.framing.checked(b"K"), 0.0) == CODEC.framing.checked(b"K1234")
    opening = CODEC.opening(5, 0x4321)
    assert gateway.receive(CODEC.framing.checked(opening), 0.0) == CODEC.framing.checked(opening + b"1234")
    gateway.reset()
    assert gateway.receive(b"K\r", 0.0) == b"K0000\r\n"


def test_a_block_write_stops_at_its_failed_word_and_keeps_earlier_words() -> None:
    gateway = in_session(VirtualGateway())
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [0x12])
    assert gateway.receive(frame("WM", 0, 0x10, [1, 2, 3, 4]), 0.0) == reply(b"x00004")
    assert [gateway.memory[address] for address in range(0x10, 0x14)] == [1, 2, 0, 0]


def test_a_block_is_written_and_read_word_for_word_and_wraps() -> None:
    gateway = in_session(VirtualGateway())
    assert gateway.receive(frame("WM", 0, 0xFE, [1, 2, 3]), 0.0) == reply(b"wm000")
    assert [gateway.memory[address] for address in (0xFE, 0xFF, 0x00)] == [1, 2, 3]
    answer = b"rm001000000010000000200000003"
    assert gateway.receive(frame("RM", 1, 0xFE, 3), 0.0) == reply(answer)


def test_a_masked_write_whose_read_fails_does_not_write() -> None:
    class Unreadable(Counting):
        def read(self, offset: int, now: float) -> int:
            raise AccessError(ErrorCode.BUS_TIMEOUT)

    gateway, device = in_session(VirtualGateway()), Unreadable()
    gateway.attach(device, [0x10])
    assert gateway.receive(frame("WK", 0, 0x10, 1, 1), 0.0) == reply(b"x00005")
    assert device.writes == []


def test_a_frame_with_lost_bytes_causes_an_overflow_error_in_its_form() -> None:
    gateway = VirtualGateway()
    gateway.receive(b"R0", 0.0)
    gateway.overflow()
    answers = gateway.receive(b"6DDE\n" + CODEC.framing.checked(b"R0A"), 0.0)
    assert answers == CODEC.framing.checked(b"X09") + CODEC.framing.checked(b"R0A00000000")
    gateway.overflow()
    assert gateway.receive(b"\r", 0.0) == b"X09\r\n"


def test_words_of_64_bits_are_exact() -> None:
    gateway = VirtualGateway(GatewayInfo(data_bits=64))
    gateway.memory[0x10] = 1
    gateway.memory[0x11] = 0xFFFF_FFFF_FFFF_FFFD
    assert gateway.receive(b"RM1002\r", 0.0) == b"RM10020000000000000001FFFFFFFFFFFFFFFD\r\n"


def test_endless_noise_without_an_end_takes_no_memory() -> None:
    gateway = VirtualGateway()
    noise = bytes(range(0x20, 0x7F)) * 100
    gateway.receive(noise, 0.0)
    tracemalloc.start()
    try:
        for _ in range(200):
            gateway.receive(noise, 0.0)
        assert tracemalloc.get_traced_memory()[0] < 20_000
    finally:
        tracemalloc.stop()
    assert gateway.receive(b"\n", 0.0) == CODEC.framing.checked(b"X07")


def test_a_device_may_return_negative_words() -> None:
    class Negative(Counting):
        def read(self, offset: int, now: float) -> int:
            return -2 if offset == 0 else np.int32(-3)  # type: ignore[return-value]

    gateway = VirtualGateway()
    gateway.attach(Negative(), range(0x10, 0x12))
    assert gateway.receive(b"RM1002\r", 0.0) == b"RM1002FFFFFFFEFFFFFFFD\r\n"
    gateway.detach([0x10])
    assert gateway.receive(b"R10\r", 0.0) == b"R1000000000\r\n"


def test_a_reset_clears_session_groups_and_half_a_frame_but_not_memory() -> None:
    gateway = VirtualGateway()
    gateway.receive(b"K0551234\rW1077\rGS000100010110\rGN00\rI01\rR1", 0.0)
    assert (gateway.expected, gateway.send_immediate) == (0x55, 1)
    gateway.reset()
    assert (gateway.expected, gateway.next_due, gateway.send_immediate) == (-1, None, 2)
    assert gateway.receive(b"R10\rGP00\r", 0.0) == b"R1000000077\r\nX06\r\n"


@given(numbers=st.lists(st.integers(0, RING - 1), min_size=1), plain=st.booleans())
def test_no_request_with_an_id_is_executed_after_a_reset(numbers: list[int], plain: bool) -> None:
    gateway, device = in_session(VirtualGateway()), Counting()
    gateway.attach(device, [0x10])
    gateway.reset()
    seed = seed_of(SESSION, from_gateway=False)
    for number in numbers:
        for command in ("W", "WS", "R"):
            values = (0x10,) if command == "R" else (0x10, 1)
            body = command.lower().encode() + CODEC.id_text[number] + CODEC.fields(command, *values)
            refused = b"x%b0A" % CODEC.id_text[number]
            if plain:
                assert gateway.receive(CODEC.framing.plain_request(body), 0.0) == refused + b"0000\r\n"
            else:
                # The CRC residue shows that the frame arrived undamaged: it depends only on the session's number.
                residue = CODEC.framing.crc.of(body, seed) ^ CODEC.framing.crc.of(body)
                answer = gateway.receive(CODEC.framing.checked(body, seed), 0.0)
                assert answer == CODEC.framing.checked(b"%b%04X" % (refused, residue))
    assert (device.reads, device.writes) == (0, [])
    assert gateway.receive(b"W1005\r", 0.0) == b"W10\r\n"
    in_session(gateway, numbers[0])
    assert gateway.receive(frame("W", numbers[0], 0x10, 7), 0.0) == reply(b"w%03X" % numbers[0])
    assert device.writes == [5, 7]


def test_a_gap_is_reported_again_in_a_new_session() -> None:
    gateway = in_session(VirtualGateway(), 5)
    assert gateway.receive(frame("H", 7), 0.0) == reply(b"n005")
    assert gateway.receive(frame("H", 8), 0.0) == b""
    assert gateway.receive(frame("H", 7), 0.0) == b""
    in_session(gateway, 5, SESSION + 1)
    assert gateway.receive(frame("H", 7, session=SESSION + 1), 0.0) == reply(b"n005", SESSION + 1)


def test_the_send_immediate_mode_is_kept_until_the_next_session() -> None:
    gateway = VirtualGateway()
    gateway.receive(b"I01\r", 0.0)
    assert gateway.send_immediate == 1
    gateway.receive(b"K0000001\r", 0.0)
    assert gateway.send_immediate == 2


def test_impossible_gateways_are_refused() -> None:
    with pytest.raises(ArgumentError, match="node 255"):
        VirtualGateway(node=255)
    with pytest.raises(UnsupportedError, match="data_bits = 4"):
        VirtualGateway(GatewayInfo(data_bits=4))
    assert Feature.ADDRESSED not in VirtualGateway(GatewayInfo(features=Feature(0xFF))).info.features


@pytest.mark.parametrize(("address", "word"), [(0x100, 0), (-1, 0), (0, 1 << 32), (0, -1)])
def test_memory_accepts_only_valid_addresses_and_words(address: int, word: int) -> None:
    with pytest.raises(ArgumentError, match="does not fit"):
        VirtualGateway().memory[address] = word


def test_a_device_is_attached_only_to_existing_addresses() -> None:
    with pytest.raises(ArgumentError, match="0x100 does not fit in 8 bits"):
        VirtualGateway().attach(Counting(), [0xFF, 0x100])


def test_a_device_is_not_attached_to_addresses_of_another_one() -> None:
    gateway = VirtualGateway()
    gateway.attach(Counting(), [0x20, 0x21])
    with pytest.raises(ArgumentError, match=r"address 0x21 has a device, <.*Counting.*>: detach that first"):
        gateway.attach(Failing(), [0x22, 0x21])
    assert gateway.receive(b"R22\r", 0.0) == b"R2200000000\r\n", "a device has all of its addresses or none"
    gateway.detach([0x21])
    gateway.attach(Failing(), [0x22, 0x21])


def test_an_object_without_read_or_write_is_refused_as_a_device() -> None:
    class ReadOnly:
        def read(self, offset: int, now: float) -> int:
            return 0

    with pytest.raises(ArgumentError, match="has no method 'write': a device with read and write was expected"):
        VirtualGateway().attach(ReadOnly(), [0x20])  # type: ignore[arg-type]


@pytest.mark.parametrize("word", [None, 1.5, "1", ZeroDivisionError("in the device"), asyncio.CancelledError()])
def test_a_bug_in_a_device_is_a_bus_error_for_the_client_and_logged(
    word: Any, caplog: pytest.LogCaptureFixture
) -> None:
    class Buggy(Counting):
        def read(self, offset: int, now: float) -> Any:
            if isinstance(word, BaseException):
                raise word
            return word

        def write(self, offset: int, value: int, now: float) -> None:
            raise IndexError("list index out of range")

    @on_simulated_time
    async def ask() -> None:
        gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000))
        gateway.attach(Buggy(), [0x20])
        async with unity_link.connect(gateway) as link:
            for _ in range(3):
                with pytest.raises(BusError, match="read at 0x20"):
                    await link.read(0x20)
                with pytest.raises(BusError, match="write at 0x20"):
                    await link.write(0x20, 1)
            assert await link.read(0x21) == 0
            async with link.subscribe([0x20], rate_hz=100):
                await asyncio.sleep(1)
            assert link.statistics.repetitions == 0

    ask()
    records = [(record.name, record.exc_info and record.exc_info[0]) for record in caplog.records]
    kind = type(word) if isinstance(word, BaseException) else TypeError
    assert records == [("unity_link.virtual", kind), ("unity_link.virtual", IndexError)]
    assert "failed in a read at 0x20, which is a bus error (told once)" in caplog.messages[0]
