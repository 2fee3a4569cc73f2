"""The chip: its ports, its EEPROM, and the requests of its driver.

Sources: FT232H and FT2232H datasheets (DS_FT232H, DS_FT2232H), AN232B-04 (latency and flow), AN232B-05 (baud rates),
pyftdi's constants for the requests. The low byte of a request's index is the number of a port. In
requests about the EEPROM it is an address.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING

from unity_link.transport.ft232h import eeprom_image
from unity_link.transport.ft232h.kinds import FT232H, PORT_A
from unity_link.virtual.ft232h import descriptors
from unity_link.virtual.ft232h.port import LONGEST_LATENCY, ChipPort

if TYPE_CHECKING:
    from unity_link.transport.ft232h.kinds import ChipKind
    from unity_link.virtual.ft232h.timing import Timing

_VENDOR_OUT, _VENDOR_IN = 0x40, 0xC0
_STANDARD_IN, _STANDARD_OUT = (0x80, 0x81, 0x82), (0x00, 0x01, 0x02)
_FRACTIONS = (0, 4, 2, 1, 3, 5, 6, 7)
"""Eighths of the baud rate's divisor for each code."""
_FAST_CLOCK, _SLOW_CLOCK = 12e6, 3e6
_ENDPOINT_HALT = 0
_CONFIGURATIONS = (0, 1)
"""Numbers of the configurations: 0 for not configured, and 1 for the one in the descriptors."""


class StallError(Exception):
    """The chip refuses a request, or an endpoint is halted."""


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
    """One FT232H or FT2232H.

    Args:
        image: contents of the EEPROM, 256 bytes.
        timing: figures of the model.
        kind: kind of chip.
    """

    def __init__(self, image: bytes, timing: Timing, kind: ChipKind = FT232H) -> None:
        self.kind = kind
        self.eeprom = bytearray(image)
        self.timing = timing
        self.ports: list[ChipPort] = []
        for number in range(PORT_A, PORT_A + kind.ports):
            self.ports.append(ChipPort(number, kind.fifo_size, timing, self.ports[0] if self.ports else None))
        self.halted: set[int] = set()
        """Endpoints that answer STALL."""
        self.power_up(0.0)

    def power_up(self, now: float) -> None:
        """Set the state after plugging in; the EEPROM is read only now."""
        for port in self.ports:
            port.power_up(eeprom_image.channel_type(self.eeprom, self.kind, port.number), now)
        self.strings = eeprom_image.strings(self.eeprom, self.kind)
        self.configuration = 0
        self.halted.clear()

    def _port(self, index: int) -> ChipPort:
        """Return the port of a request's index; port A if the index has no number."""
        number = index & 0xFF or PORT_A
        if number > len(self.ports):
            raise StallError
        return self.ports[number - 1]

    def control_out(self, kind: int, request: int, value: int, index: int, now: float) -> None:
        """Execute a control request without an answer.

        Raises:
            StallError: if the chip does not support the request.
        """
        if kind == _VENDOR_OUT:
            self._vendor_out(request, value, index, now)
        elif kind in _STANDARD_OUT and request == 0x09:
            if value not in _CONFIGURATIONS:
                raise StallError
            self.configuration = value
        elif kind == 0x02 and request == 0x01 and value == _ENDPOINT_HALT:
            self.halted.discard(index & 0xFF)
        elif kind not in _STANDARD_OUT or request not in (0x01, 0x03, 0x05, 0x0B):
            raise StallError

    def _vendor_out(self, request: int, value: int, index: int, now: float) -> None:
        match request:
            case ControlRequest.RESET:
                _reset_or_purge(self._port(index), value, now)
            case ControlRequest.SET_LATENCY:
                self._port(index).latency = min(max(value & 0xFF, 1), LONGEST_LATENCY)
            case ControlRequest.EVENT_CHARACTER:
                self._port(index).event_character = value & 0xFF if value & 0x100 else None
            case ControlRequest.BIT_MODE:
                self._port(index).bit_mode = value >> 8
            case ControlRequest.BAUD_RATE:
                self._port(index).baud = _baud(value, index)
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

    def control_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Return the whole answer to a control request; the host truncates it to the requested length.

        Raises:
            StallError: if the chip does not support the request.
        """
        if kind == _VENDOR_IN:
            return self._vendor_in(request, index)
        if kind in _STANDARD_IN:
            return self._standard_in(kind, request, value, index)
        raise StallError

    def _vendor_in(self, request: int, index: int) -> bytes:
        match request:
            case ControlRequest.MODEM_STATUS:
                return self._port(index).status()
            case ControlRequest.GET_LATENCY:
                return bytes([self._port(index).latency])
            case ControlRequest.PINS:
                return b"\x00"
            case ControlRequest.READ_EEPROM:
                place = 2 * index % eeprom_image.SIZE
                return bytes(self.eeprom[place : place + 2])
            case _:
                raise StallError

    def _standard_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Return the answer to a standard request (USB 2.0, section 9.4)."""
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
            return descriptors.encode_configuration(self.kind)
        if kind == descriptors.QUALIFIER:
            return descriptors.encode_qualifier()
        if kind == descriptors.STRING and number == 0:
            return descriptors.encode_languages()
        if kind == descriptors.STRING and number <= len(self.strings) and self.strings[number - 1]:
            return descriptors.encode_string(self.strings[number - 1])
        raise StallError

    @property
    def device_descriptor(self) -> descriptors.DeviceDescriptor:
        """Device descriptor of the chip, with the index of the serial number if there is one."""
        return descriptors.DeviceDescriptor(
            idProduct=self.kind.product_id, bcdDevice=self.kind.release, iSerialNumber=3 if self.strings[2] else 0
        )


def _reset_or_purge(port: ChipPort, value: int, now: float) -> None:
    if value == 0:
        port.reset(now)
    elif value == 1:
        port.to_fpga.clear()
    else:
        port.purge_to_host(now)


def _baud(value: int, index: int) -> float:
    """Return the baud rate of a divisor (AN232B-05, with the clock of the H series)."""
    divisor = value | index >> 8 << 16
    clock = _FAST_CLOCK if divisor & 0x20000 else _SLOW_CLOCK
    divisor &= 0x1FFFF
    if divisor in (0, 1):
        return clock / (1 + divisor / 2)
    return clock / ((divisor & 0x3FFF) + _FRACTIONS[divisor >> 14] / 8)
