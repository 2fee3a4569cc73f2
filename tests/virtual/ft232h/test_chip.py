"""The instants at which the chip sends packets, and the contents of the packets."""

from __future__ import annotations

import contextlib
import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyftdi.eeprom import FtdiEeprom

from unity_link.transport.ft232h.eeprom_image import BLANK, build_eeprom, channel_type, checksum, is_valid, strings
from unity_link.transport.ft232h.kinds import FT232H, FT2232H, ChipKind
from unity_link.virtual.ft232h.board import Unconnected
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.chip import Chip, StallError
from unity_link.virtual.ft232h.port import OVERRUN, PAYLOAD, Mode
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.ft232h.timing import Timing

LATENCY = 0.016


def new_chip(image: bytes = build_eeprom("FIFO", "S1"), timing: Timing = Timing()) -> Chip:  # noqa: B008  (frozen)
    return Chip(image, timing)


def test_a_single_byte_waits_for_the_latency_timer() -> None:
    [port] = new_chip().ports
    port.write(b"a")
    assert port.ready_at(0.001) == pytest.approx(LATENCY)
    assert port.give(LATENCY)[2:] == b"a"


def test_the_latency_timer_starts_again_with_each_packet() -> None:
    [port] = new_chip().ports
    port.give(0.010)
    assert port.ready_at(0.010) == pytest.approx(0.010 + LATENCY)


def test_an_empty_chip_sends_its_status_when_the_latency_timer_ends() -> None:
    assert len(new_chip().ports[0].give(LATENCY)) == 2


def test_the_latency_timer_is_set_by_a_request() -> None:
    chip = new_chip()
    [port] = chip.ports
    chip.control_out(0x40, 0x09, 3, 1, 0.0)
    assert chip.control_in(0xC0, 0x0A, 0, 1) == b"\x03"
    assert port.ready_at(0.0) == pytest.approx(0.003)


def test_a_full_packet_is_sent_at_once() -> None:
    [port] = new_chip().ports
    port.write(bytes(PAYLOAD - 1))
    assert port.ready_at(0.0) > 0
    port.write(b"x")
    assert port.ready_at(0.0) == 0.0
    assert len(port.give(0.0)) == 512


def test_siwu_sends_the_waiting_and_the_later_bytes() -> None:
    [port] = new_chip().ports
    port.write(b"response")
    port.send_immediate()
    port.write(b"+")
    assert port.ready_at(0.0) == 0.0
    assert port.give(0.0)[2:] == b"response+"
    assert port.ready_at(0.0) > 0


def test_siwu_with_more_than_a_packet_sends_all_of_it() -> None:
    [port] = new_chip().ports
    port.write(bytes(PAYLOAD + 7))
    port.send_immediate()
    assert [len(port.give(0.0)), port.ready_at(0.0), len(port.give(0.0))] == [512, 0.0, 9]


@pytest.mark.parametrize(("short_packet", "ready"), [(False, LATENCY), (True, 0.0)])
def test_a_short_packet_follows_a_flush_of_a_full_one_only_as_an_option(short_packet: bool, ready: float) -> None:
    [port] = new_chip(timing=Timing(short_packet_after_full=short_packet)).ports
    port.write(bytes(PAYLOAD))
    port.send_immediate()
    assert len(port.give(0.0)) == 512
    assert port.ready_at(0.0) == pytest.approx(ready)
    assert len(port.give(ready)) == 2


def test_siwu_with_an_empty_fifo_does_nothing() -> None:
    [port] = new_chip().ports
    port.send_immediate()
    assert port.ready_at(0.0) > 0


def test_the_event_character_sends_the_waiting_bytes_and_stays_in_the_data() -> None:
    chip = new_chip()
    [port] = chip.ports
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    port.write(b"R0A")
    assert port.ready_at(0.0) > 0
    port.write(b"0\n")
    assert port.ready_at(0.0) == 0.0
    assert port.give(0.0)[2:] == b"R0A0\n"


def test_the_event_character_does_not_count_as_the_first_byte() -> None:
    chip = new_chip()
    [port] = chip.ports
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    port.write(b"\n")
    assert port.ready_at(0.0) > 0


def test_the_event_character_can_be_switched_off() -> None:
    chip = new_chip()
    [port] = chip.ports
    chip.control_out(0x40, 0x06, 0x100 | 0x0A, 1, 0.0)
    chip.control_out(0x40, 0x06, 0, 1, 0.0)
    port.write(b"a\n")
    assert port.ready_at(0.0) > 0


def test_bytes_beyond_the_fifo_are_lost_and_reported_once() -> None:
    [port] = new_chip().ports
    port.write(bytes(FT232H.fifo_size + 1))
    assert port.room == 0
    assert [port.give(0.0)[1] & OVERRUN, port.give(0.0)[1] & OVERRUN] == [OVERRUN, 0]


def test_a_purge_drops_one_direction() -> None:
    chip = new_chip()
    [port] = chip.ports
    port.write(b"in")
    port.take(b"out")
    chip.control_out(0x40, 0x00, 2, 1, 0.0)
    assert (port.room, port.readable) == (FT232H.fifo_size, 3)
    chip.control_out(0x40, 0x00, 1, 1, 0.0)
    assert port.readable == 0


@given(st.lists(st.binary(max_size=300)), st.randoms())
def test_packets_contain_every_byte_once_and_in_order(pieces: list[bytes], random: object) -> None:
    [port], received, sent = new_chip().ports, bytearray(), bytearray()
    clock = itertools.count()
    for piece in pieces:
        written = piece[: port.room]
        port.write(written)
        sent += written
        if getattr(random, "random")() < 0.5:  # noqa: B009  (hypothesis types it as an object)
            port.send_immediate()
        if port.ready_at(next(clock)) == 0:
            received += port.give(0.0)[2:]
    while len(packet := port.give(0.0)) > 2:
        received += packet[2:]
    assert received == sent


# EEPROM and pins


def test_the_eeprom_selects_the_pins_and_the_bit_mode_the_clock() -> None:
    chip = new_chip()
    [port] = chip.ports
    modes = [port.mode]
    chip.control_out(0x40, 0x0B, 0x40FF, 1, 0.0)
    modes.append(port.mode)
    assert modes == [Mode.FIFO, Mode.SYNC_FIFO]
    assert new_chip(build_eeprom("UART")).ports[0].mode is Mode.UART


@pytest.mark.parametrize("image", [BLANK, bytes(256), build_eeprom("FIFO")[:-1] + b"\x00"])
def test_a_chip_without_a_valid_eeprom_is_a_uart_without_a_serial_number(image: bytes) -> None:
    chip = new_chip(image)
    [port] = chip.ports
    assert (port.mode, chip.strings[2], chip.device_descriptor.iSerialNumber) == (Mode.UART, "", 0)


def test_writes_to_the_eeprom_take_effect_after_the_next_power_up() -> None:
    chip = new_chip(BLANK)
    [port] = chip.ports
    image = build_eeprom("FIFO", "NEW")
    for index in range(128):
        chip.control_out(0x40, 0x91, int.from_bytes(image[2 * index : 2 * index + 2], "little"), index, 0.0)
    assert port.mode is Mode.UART
    chip.power_up(1.0)
    assert str(port.mode) == str(Mode.FIFO)
    assert chip.strings[2] == "NEW"


@given(
    st.sampled_from([(FT232H, 1), (FT2232H, 1), (FT2232H, 2)]),
    st.sampled_from(["UART", "FIFO"]),
    st.text(st.characters(codec="ascii", min_codepoint=33, max_codepoint=126), max_size=10),
)
def test_an_eeprom_has_the_settings_that_it_was_built_with(
    place: tuple[ChipKind, int], wanted: str, serial: str
) -> None:
    kind, port = place
    image = build_eeprom("FIFO" if wanted == "FIFO" else "UART", serial, kind=kind, ports=[port])
    assert is_valid(image)
    assert channel_type(image, kind, port) == wanted
    assert channel_type(image, kind, 3 - port) == "UART"
    assert strings(image, kind) == ("Unity-Link", f"Virtual {kind.name}", serial)


@pytest.mark.parametrize(
    ("kind", "code", "expected"),
    [
        (FT232H, 0x01, "FIFO"),
        (FT232H, 0x11, "FIFO"),
        (FT232H, 0x09, "UART"),
        (FT2232H, 0x01, "FIFO"),
        (FT2232H, 0x09, "FIFO"),
        (FT2232H, 0x81, "FIFO"),
        (FT2232H, 0x08, "UART"),
        (FT2232H, 0x04, "UART"),
    ],
)
def test_the_driver_type_in_an_eeprom_is_ignored(kind: ChipKind, code: int, expected: str) -> None:
    image = bytearray(build_eeprom("UART", "S1", kind=kind))
    image[0] = code
    image[-2:] = checksum(image[:-2]).to_bytes(2, "little")
    assert channel_type(image, kind) == expected


@pytest.mark.parametrize("kind", [FT232H, FT2232H])
def test_pyftdi_reads_the_same_settings_from_an_eeprom(kind: ChipKind) -> None:
    device = VirtualFt232h(
        Unconnected(), kind=kind, image=build_eeprom("FIFO", "S17", kind=kind, ports=range(1, kind.ports + 1))
    )
    with installed(VirtualBus(device)):
        memory = FtdiEeprom()
        memory.open(f"ftdi://ftdi:{kind.url_name}/1")
        properties = {name: getattr(memory, name) for name in sorted(memory.properties) if "channel" in name}
        texts = (memory.manufacturer, memory.product, memory.serial, memory.chip)
        memory.close()
    assert texts == ("Unity-Link", f"Virtual {kind.name}", "S17", 0x56)
    assert properties["channel_a_type"] == {FT232H: 1, FT2232H: "FIFO"}[kind]
    assert properties.get("channel_b_type") == {FT232H: None, FT2232H: "FIFO"}[kind]


@pytest.mark.parametrize(
    ("value", "index", "baud"),
    [(0, 0x0201, 12e6), (1, 0x0201, 8e6), (2, 0x0201, 6e6), (0x4138, 0x0001, 9600), (0xC068, 0x0201, 115_200)],
)
def test_the_divisor_determines_the_baud_rate(value: int, index: int, baud: float) -> None:
    chip = new_chip()
    [port] = chip.ports
    chip.control_out(0x40, 0x03, value, index, 0.0)
    assert port.baud == pytest.approx(baud, rel=2e-3)


@pytest.mark.parametrize(("kind", "number"), [(0x40, 0x55), (0x21, 0x01)])
def test_an_unknown_request_is_refused(kind: int, number: int) -> None:
    with pytest.raises(StallError):
        new_chip().control_out(kind, number, 0, 1, 0.0)


@given(value=st.integers(0, 0xFFFF))
def test_only_an_existing_configuration_number_can_be_set(value: int) -> None:
    chip = new_chip()
    chip.control_out(0x00, 0x09, 1, 0, 0.0)
    is_known = value in (0, 1)
    with contextlib.nullcontext() if is_known else pytest.raises(StallError):
        chip.control_out(0x00, 0x09, value, 0, 0.0)
    assert chip.control_in(0x80, 0x08, 0, 0) == bytes([value if is_known else 1])


@pytest.mark.parametrize(("kind", "number"), [(0xC0, 0x55), (0xA1, 0x01), (0x80, 0x55)])
def test_an_unknown_read_request_is_refused(kind: int, number: int) -> None:
    with pytest.raises(StallError):
        new_chip().control_in(kind, number, 0, 1)


# Two ports


def new_pair(*fifos: int) -> Chip:
    """Return an FT2232H whose given ports are FIFOs."""
    return Chip(build_eeprom("FIFO", "S1", kind=FT2232H, ports=fifos), Timing(), FT2232H)


def test_each_port_has_its_own_pins_and_fifos() -> None:
    chip = new_pair(2)
    first, second = chip.ports
    assert [first.mode, second.mode] == [Mode.UART, Mode.FIFO]
    second.write(bytes(FT2232H.fifo_size))
    assert [first.room, second.room] == [4096, 0]


def test_the_index_of_a_request_names_the_port() -> None:
    chip = new_pair(1, 2)
    for index, latency in ((0, 5), (2, 7)):
        chip.control_out(0x40, 0x09, latency, index, 0.0)
        assert chip.control_in(0xC0, 0x0A, 0, index) == bytes([latency])
    chip.control_out(0x40, 0x06, 0x10A, 2, 0.0)
    chip.control_out(0x40, 0x03, 0, 0x0202, 0.0)
    assert [(port.latency, port.event_character, port.baud) for port in chip.ports] == [(5, None, 9600), (7, 10, 12e6)]
    with pytest.raises(StallError):
        chip.control_out(0x40, 0x09, 1, 3, 0.0)


def test_a_reset_of_one_port_does_not_affect_the_other() -> None:
    chip = new_pair(1, 2)
    for port in chip.ports:
        port.write(b"kept")
    chip.control_out(0x40, 0x00, 0, 2, 0.0)
    assert [port.give(1.0)[2:] for port in chip.ports] == [b"kept", b""]


def test_port_b_is_unusable_with_the_synchronous_fifo_of_port_a() -> None:
    chip = new_pair(1, 2)
    modes = []
    for value, index in ((0x40FF, 2), (0, 2), (0x40FF, 1), (0, 1)):
        chip.control_out(0x40, 0x0B, value, index, 0.0)
        modes.append([port.mode for port in chip.ports])
    fifo, sync, other = Mode.FIFO, Mode.SYNC_FIFO, Mode.OTHER
    assert modes == [[fifo, other], [fifo, fifo], [sync, other], [fifo, fifo]]


def test_the_configuration_lists_an_interface_with_two_endpoints_per_port() -> None:
    answer = new_pair().control_in(0x80, 0x06, 0x0200, 0)
    assert len(answer) == int.from_bytes(answer[2:4], "little") == 9 + 2 * (9 + 7 + 7)
    assert answer[4] == 2
    endpoints = [answer[start + 2] for start in (18, 25, 41, 48)]
    assert endpoints == [0x81, 0x02, 0x83, 0x04]
