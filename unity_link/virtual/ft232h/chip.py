"""The FT232H: two FIFOs of 1 KiB, the rules by which bytes become packets, and the requests of its driver.

It has no clock: who calls says what time it is. Towards the USB it gives and takes packets and answers requests,
towards the FPGA it has the FIFO's pins: RXF# is low while there is something to `read`, TXE# while there is `room`,
`write` and `send_immediate` are WR# and SIWU#. Sources: FT232H datasheet (DS_FT232H), AN232B-04 (latency and flow),
AN232B-05 (baud rates), pyftdi's constants for the requests.

Bytes wait in the chip until a packet is sent: when it is full, when the latency timer ends, when the event character
came, or after SIWU#. A packet takes along all that is there.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING

from unity_link.transport.ft232h import eeprom_image
from unity_link.virtual.ft232h import descriptors

if TYPE_CHECKING:
    from unity_link.virtual.ft232h.timing import Timing

FIFO_SIZE = 1024
"""Bytes of each FIFO."""
PAYLOAD = descriptors.PACKET_SIZE - 2
"""Most bytes in one packet to the host, behind the two status bytes."""
LONGEST_LATENCY = 255
_HIGH_SPEED_PACKETS = 0x02
"""Always set in the first status byte of a chip on a high-speed bus."""
_CTS_AND_DSR = 0x30
_TRANSMITTER_EMPTY = 0x60
OVERRUN = 0x02
"""In the second status byte: bytes came while the FIFO was full, and are lost."""
_VENDOR_OUT, _VENDOR_IN = 0x40, 0xC0
_STANDARD_IN, _STANDARD_OUT = (0x80, 0x81, 0x82), (0x00, 0x01, 0x02)
_FRACTIONS = (0, 4, 2, 1, 3, 5, 6, 7)
"""Eighths of the baud rate's divisor, by their code."""
_FAST_CLOCK, _SLOW_CLOCK = 12e6, 3e6
_ENDPOINT_HALT = 0


class StallError(Exception):
    """The chip refuses a request, or an endpoint is halted."""


class Mode(enum.Enum):
    """What the pins are."""

    UART = "uart"
    FIFO = "ft245"
    SYNC_FIFO = "ft245-sync"
    OTHER = "other"
    """Bit-bang, MPSSE and so on: no bytes pass here."""


class BitMode(enum.IntEnum):
    """Values of the bit mode request that are known here."""

    RESET = 0x00
    SYNC_FIFO = 0x40


class ControlRequest(enum.IntEnum):
    """Vendor requests."""

    RESET = 0x00
    MODEM_CONTROL = 0x01
    FLOW_CONTROL = 0x02
    BAUD_RATE = 0x03
    DATA = 0x04
    MODEM_STATUS = 0x05
    EVENT_CHARACTER = 0x06
    ERROR_CHARACTER = 0x07
    SET_LATENCY = 0x09
    GET_LATENCY = 0x0A
    BIT_MODE = 0x0B
    PINS = 0x0C
    READ_EEPROM = 0x90
    WRITE_EEPROM = 0x91
    ERASE_EEPROM = 0x92


class Chip:
    """One FT232H.

    Args:
        image: content of its EEPROM, 256 bytes.
        timing: the numbers of the model.
    """

    def __init__(self, image: bytes, timing: Timing) -> None:
        self.eeprom = bytearray(image)
        self.timing = timing
        self.halted: set[int] = set()
        """Endpoints that answer STALL."""
        self.power_up(0.0)

    def power_up(self, now: float) -> None:
        """Begin anew, as after being plugged in: only now is the EEPROM looked at."""
        self.channel_type = eeprom_image.channel_type(self.eeprom)
        self.strings = eeprom_image.strings(self.eeprom)
        self.configuration = 0
        self.to_fpga = bytearray()
        self.to_host = bytearray()
        self.halted.clear()
        self.baud = 9600.0
        self._reset(now)

    def _reset(self, now: float) -> None:
        self.latency = self.timing.default_latency
        self.event_character: int | None = None
        self.bit_mode = 0
        self._errors = 0
        self._purge_to_host(now)
        self.to_fpga.clear()

    def _purge_to_host(self, now: float) -> None:
        self.to_host.clear()
        self._wanted = 0
        """How many of the bytes to the host are to be sent at once."""
        self._empty_packet_due = False
        self._timer_began = now

    @property
    def mode(self) -> Mode:
        """What the pins are, by EEPROM and bit mode."""
        if self.channel_type == "UART":
            return Mode.UART if self.bit_mode == BitMode.RESET else Mode.OTHER
        if self.bit_mode == BitMode.SYNC_FIFO:
            return Mode.SYNC_FIFO
        return Mode.FIFO if self.bit_mode == BitMode.RESET else Mode.OTHER

    # The FPGA's side

    @property
    def readable(self) -> int:
        """Bytes that the FPGA can read; RXF# is high where there are none."""
        return len(self.to_fpga)

    @property
    def room(self) -> int:
        """Bytes that the FPGA can write; TXE# is high where there is no room."""
        return FIFO_SIZE - len(self.to_host)

    def read(self, count: int) -> bytes:
        """Return bytes to the FPGA."""
        data = bytes(self.to_fpga[:count])
        del self.to_fpga[:count]
        return data

    def write(self, data: bytes | bytearray) -> None:
        """Take bytes of the FPGA. What has no room is lost, and the next packet says so."""
        room = self.room
        if len(data) > room:
            data = data[:room]
            self._errors |= OVERRUN
        before = len(self.to_host)
        self.to_host += data
        if self.event_character is not None:
            place = before + data.rfind(self.event_character)
            # It does not count as the first byte of the buffer.
            if place >= max(before, 1):
                self._wanted = place + 1

    def send_immediate(self) -> None:
        """Take a pulse of SIWU#: all that is there is to be sent. Nothing is known of one with an empty FIFO."""
        self._wanted = len(self.to_host)

    def report_error(self, bits: int) -> None:
        """Set error bits in the second status byte of the next packet."""
        self._errors |= bits

    # The USB's side: bulk

    @property
    def can_take(self) -> int:
        """Bytes that a packet from the host may have now."""
        return FIFO_SIZE - len(self.to_fpga)

    def take(self, packet: bytes) -> None:
        """Take a packet from the host."""
        self.to_fpga += packet

    def ready_at(self, now: float) -> float:
        """Return when the chip answers a request for a packet; before that it refuses (NAK)."""
        if len(self.to_host) >= PAYLOAD or self._wanted or self._empty_packet_due:
            return now
        return max(now, self._timer_began + self.latency / 1000)

    def give(self, now: float) -> bytes:
        """Return the next packet to the host, status bytes first."""
        payload = bytes(self.to_host[:PAYLOAD])
        del self.to_host[:PAYLOAD]
        flushed = 0 < self._wanted == len(payload)
        self._wanted = max(0, self._wanted - len(payload))
        self._empty_packet_due = flushed and len(payload) == PAYLOAD and self.timing.short_packet_after_full
        self._timer_began = now
        packet = self._status() + payload
        self._errors = 0
        return packet

    def _status(self) -> bytes:
        modem = _HIGH_SPEED_PACKETS | (_CTS_AND_DSR if self.mode is Mode.UART else 0)
        return bytes([modem, self._errors | (0 if self.to_fpga else _TRANSMITTER_EMPTY)])

    # The USB's side: control

    def control_out(self, kind: int, request: int, value: int, index: int, now: float) -> None:
        """Do a request that asks for nothing.

        Raises:
            StallError: for one that the chip does not know.
        """
        if kind == _VENDOR_OUT:
            self._vendor_out(request, value, index, now)
        elif kind in _STANDARD_OUT and request == 0x09:
            self.configuration = value
        elif kind == 0x02 and request == 0x01 and value == _ENDPOINT_HALT:
            self.halted.discard(index & 0xFF)
        elif kind not in _STANDARD_OUT or request not in (0x01, 0x03, 0x05, 0x0B):
            raise StallError

    def _vendor_out(self, request: int, value: int, index: int, now: float) -> None:
        match request:
            case ControlRequest.RESET:
                self._reset_or_purge(value, now)
            case ControlRequest.SET_LATENCY:
                self.latency = min(max(value & 0xFF, 1), LONGEST_LATENCY)
            case ControlRequest.EVENT_CHARACTER:
                self.event_character = value & 0xFF if value & 0x100 else None
            case ControlRequest.BIT_MODE:
                self.bit_mode = value >> 8
            case ControlRequest.BAUD_RATE:
                self.baud = _baud(value, index)
            case ControlRequest.WRITE_EEPROM:
                place = 2 * index % eeprom_image.SIZE
                self.eeprom[place : place + 2] = value.to_bytes(2, "little")
            case ControlRequest.ERASE_EEPROM:
                self.eeprom[:] = eeprom_image.BLANK
            case (
                ControlRequest.MODEM_CONTROL
                | ControlRequest.FLOW_CONTROL
                | ControlRequest.DATA
                | ControlRequest.ERROR_CHARACTER
            ):
                pass
            case _:
                raise StallError

    def _reset_or_purge(self, value: int, now: float) -> None:
        if value == 0:
            self._reset(now)
        elif value == 1:
            self.to_fpga.clear()
        else:
            self._purge_to_host(now)

    def control_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Answer a request; the host cuts the answer where it wants less.

        Raises:
            StallError: for one that the chip does not know.
        """
        if kind == _VENDOR_IN:
            return self._vendor_in(request, index)
        if kind in _STANDARD_IN:
            return self._standard_in(kind, request, value, index)
        raise StallError

    def _vendor_in(self, request: int, index: int) -> bytes:
        match request:
            case ControlRequest.MODEM_STATUS:
                return self._status()
            case ControlRequest.GET_LATENCY:
                return bytes([self.latency])
            case ControlRequest.PINS:
                return b"\x00"
            case ControlRequest.READ_EEPROM:
                place = 2 * index % eeprom_image.SIZE
                return bytes(self.eeprom[place : place + 2])
            case _:
                raise StallError

    def _standard_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Answer what every device does (USB 2.0, section 9.4)."""
        match request:
            case 0x00:
                return b"\x01\x00" if kind == 0x82 and index & 0xFF in self.halted else b"\x00\x00"
            case 0x06:
                return self._descriptor(value >> 8, value & 0xFF)
            case 0x08:
                return bytes([self.configuration])
            case 0x0A:
                return b"\x00"
            case _:
                raise StallError

    def _descriptor(self, kind: int, number: int) -> bytes:
        if kind == descriptors.DEVICE:
            return self.device_descriptor.encode()
        if kind == descriptors.CONFIGURATION and number == 0:
            return descriptors.encode_configuration()
        if kind == descriptors.QUALIFIER:
            return descriptors.encode_qualifier()
        if kind == descriptors.STRING and number == 0:
            return descriptors.encode_languages()
        if kind == descriptors.STRING and number <= len(self.strings) and self.strings[number - 1]:
            return descriptors.encode_string(self.strings[number - 1])
        raise StallError

    @property
    def device_descriptor(self) -> descriptors.DeviceDescriptor:
        """What the chip tells of itself; without a serial number it names none."""
        return descriptors.DeviceDescriptor(iSerialNumber=3 if self.strings[2] else 0)


def _baud(value: int, index: int) -> float:
    """Return the rate that a divisor stands for, bits a second (AN232B-05, with the clock of the H series)."""
    divisor = value | index >> 8 << 16
    clock = _FAST_CLOCK if divisor & 0x20000 else _SLOW_CLOCK
    divisor &= 0x1FFFF
    if divisor in (0, 1):
        return clock / (1 + divisor / 2)
    return clock / ((divisor & 0x3FFF) + _FRACTIONS[divisor >> 14] / 8)
