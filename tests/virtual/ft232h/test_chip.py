"""When the chip sends a packet, and what is in it."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.transport.ft232h.eeprom_image import BLANK, build_eeprom, channel_type, is_valid, strings
from unity_link.virtual.ft232h.chip import FIFO_SIZE, OVERRUN, PAYLOAD, Chip, Mode, StallError
from unity_link.virtual.ft232h.timing import Timing

LATENCY = 0.016


def new_chip(image: bytes = build_eeprom("FIFO", "S1"), timing: Timing = Timing()) -> Chip:  # noqa: B008  (frozen)
    return Chip(image, timing)


def test_a_lone_byte_waits_for_the_latency_timer() -> None:
    chip = new_chip()
    chip.write(b"a")
    assert chip.ready_at(0.001) == pytest.approx(LATENCY)
    assert chip.give(LATENCY)[2:] == b"a"


def test_the_latency_timer_starts_again_with_each_packet() -> None:
    chip = new_chip()
    chip.give(0.010)
    assert chip.ready_at(0.010) == pytest.approx(0.010 + LATENCY)


def test_an_empty_chip_sends_its_status_when_the_latency_timer_ends() -> None:
    assert len(new_chip().give(LATENCY)) == 2


def test_the_latency_timer_is_set_by_a_request() -> None:
    chip = new_chip()
    chip.control_out(0x40, 0x09, 3, 1, 0.0)
    assert chip.control_in(0xC0, 0x0A, 0, 1) == b"\x03"
    assert chip.ready_at(0.0) == pytest.approx(0.003)


def test_a_full_packet_goes_at_once() -> None:
    chip = new_chip()
    chip.write(bytes(PAYLOAD - 1))
    assert chip.ready_at(0.0) > 0
    chip.write(b"x")
    assert chip.ready_at(0.0) == 0.0
    assert len(chip.give(0.0)) == 512


def test_siwu_sends_what_is_there_and_what_came_since() -> None:
    chip = new_chip()
    chip.write(b"response")
    chip.send_immediate()
    chip.write(b"+")
    assert chip.ready_at(0.0) == 0.0
    assert chip.give(0.0)[2:] == b"response+"
    assert chip.ready_at(0.0) > 0


def test_siwu_with_more_than_a_packet_sends_all_of_it() -> None:
    chip = new_chip()
    chip.write(bytes(PAYLOAD + 7))
    chip.send_immediate()
    assert [len(chip.give(0.0)), chip.ready_at(0.0), len(chip.give(0.0))] == [512, 0.0, 9]


@pytest.mark.parametrize(("short_packet", "ready"), [(False, LATENCY), (True, 0.0)])
def test_a_flush_of_exactly_a_packet_is_followed_by_a_short_one_only_if_so_chosen(
    short_packet: bool, ready: float
) -> None:
    chip = new_chip(timing=Timing(short_packet_after_full=short_packet))
    chip.write(bytes(PAYLOAD))
    chip.send_immediate()
    assert len(chip.give(0.0)) == 512
    assert chip.ready_at(0.0) == pytest.approx(ready)
    assert len(chip.give(ready)) == 2


def test_siwu_with_an_empty_fifo_does_nothing() -> None:
    chip = new_chip()
    chip.send_immediate()
    assert chip.ready_at(0.0) > 0


def test_the_event_character_sends_what_is_there_and_stays_in_the_data() -> None:
    chip = new_chip()
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    chip.write(b"R0A")
    assert chip.ready_at(0.0) > 0
    chip.write(b"0\n")
    assert chip.ready_at(0.0) == 0.0
    assert chip.give(0.0)[2:] == b"R0A0\n"


def test_the_event_character_does_not_count_as_the_first_byte() -> None:
    chip = new_chip()
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    chip.write(b"\n")
    assert chip.ready_at(0.0) > 0


def test_the_event_character_can_be_switched_off() -> None:
    chip = new_chip()
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    chip.control_out(0x40, 0x06, 0, 1, 0.0)
    chip.write(b"a\n")
    assert chip.ready_at(0.0) > 0


def test_bytes_beyond_the_fifo_are_lost_and_reported_once() -> None:
    chip = new_chip()
    chip.write(bytes(FIFO_SIZE + 1))
    assert chip.room == 0
    assert [chip.give(0.0)[1] & OVERRUN, chip.give(0.0)[1] & OVERRUN] == [OVERRUN, 0]


def test_a_purge_drops_one_direction() -> None:
    chip = new_chip()
    chip.write(b"in")
    chip.take(b"out")
    chip.control_out(0x40, 0x00, 2, 1, 0.0)
    assert (chip.room, chip.readable) == (FIFO_SIZE, 3)
    chip.control_out(0x40, 0x00, 1, 1, 0.0)
    assert chip.readable == 0


@given(st.lists(st.binary(max_size=300)), st.randoms())
def test_packets_hold_every_byte_once_and_in_order(pieces: list[bytes], random: object) -> None:
    chip, received, sent = new_chip(), bytearray(), bytearray()
    clock = itertools.count()
    for piece in pieces:
        written = piece[: chip.room]
        chip.write(written)
        sent += written
        if getattr(random, "random")() < 0.5:  # noqa: B009  (hypothesis types it as an object)
            chip.send_immediate()
        if chip.ready_at(next(clock)) == 0:
            received += chip.give(0.0)[2:]
    while len(packet := chip.give(0.0)) > 2:
        received += packet[2:]
    assert received == sent


# EEPROM and pins


def test_the_eeprom_chooses_the_pins_and_the_bit_mode_the_clock() -> None:
    chip = new_chip()
    modes = [chip.mode]
    chip.control_out(0x40, 0x0B, 0x40FF, 1, 0.0)
    modes.append(chip.mode)
    assert modes == [Mode.FIFO, Mode.SYNC_FIFO]
    assert new_chip(build_eeprom("UART")).mode is Mode.UART


@pytest.mark.parametrize("image", [BLANK, bytes(256), build_eeprom("FIFO")[:-1] + b"\x00"])
def test_a_chip_without_a_sound_eeprom_is_a_uart_without_a_serial_number(image: bytes) -> None:
    chip = new_chip(image)
    assert (chip.mode, chip.strings[2], chip.device_descriptor.iSerialNumber) == (Mode.UART, "", 0)


def test_what_is_written_to_the_eeprom_counts_after_the_next_power_up() -> None:
    chip = new_chip(BLANK)
    image = build_eeprom("FIFO", "NEW")
    for index in range(128):
        chip.control_out(0x40, 0x91, int.from_bytes(image[2 * index : 2 * index + 2], "little"), index, 0.0)
    assert chip.mode is Mode.UART
    chip.power_up(1.0)
    assert str(chip.mode) == str(Mode.FIFO)
    assert chip.strings[2] == "NEW"


@given(st.sampled_from(["UART", "FIFO"]), st.text(st.characters(codec="ascii", min_codepoint=33), max_size=10))
def test_an_eeprom_says_what_it_was_built_with(kind: str, serial: str) -> None:
    image = build_eeprom("FIFO" if kind == "FIFO" else "UART", serial)
    assert is_valid(image)
    assert channel_type(image) == kind
    assert strings(image)[2] == serial


@pytest.mark.parametrize(
    ("value", "index", "baud"),
    [(0, 0x0201, 12e6), (1, 0x0201, 8e6), (2, 0x0201, 6e6), (0x4138, 0x0001, 9600), (0xC068, 0x0201, 115_200)],
)
def test_the_divisor_gives_the_baud_rate(value: int, index: int, baud: float) -> None:
    chip = new_chip()
    chip.control_out(0x40, 0x03, value, index, 0.0)
    assert chip.baud == pytest.approx(baud, rel=2e-3)


@pytest.mark.parametrize(("kind", "number"), [(0x40, 0x55), (0x21, 0x01)])
def test_an_unknown_request_is_refused(kind: int, number: int) -> None:
    with pytest.raises(StallError):
        new_chip().control_out(kind, number, 0, 1, 0.0)


@pytest.mark.parametrize(("kind", "number"), [(0xC0, 0x55), (0xA1, 0x01), (0x80, 0x55)])
def test_an_unknown_question_is_refused(kind: int, number: int) -> None:
    with pytest.raises(StallError):
        new_chip().control_in(kind, number, 0, 1)
