"""A port of the chip: two FIFOs, the rules for packets, and the settings of the driver.

A port has no clock: its callers pass the time. Its USB side sends and receives packets. Its FPGA side has the pins of
the FIFO: RXF# is low while bytes can be `read`, TXE# is low while there is `room`, `write` is WR#, and `send_immediate`
is SIWU#.

Bytes from the FPGA wait in the port until a packet is sent: when a packet is full, after the latency timer, after the
event character, or after a pulse of SIWU#. A packet contains all bytes that it has room for.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING

from unity_link.transport.ft232h.kinds import in_endpoint, out_endpoint
from unity_link.virtual.ft232h import descriptors

if TYPE_CHECKING:
    from unity_link.transport.ft232h.eeprom_image import ChannelType
    from unity_link.virtual.ft232h.timing import Timing

PAYLOAD = descriptors.PACKET_SIZE - 2
"""Largest number of bytes in a packet to the host, after the two status bytes."""
LONGEST_LATENCY = 255
_HIGH_SPEED_PACKETS = 0x02
"""Always set in the first status byte of a chip on a high-speed bus."""
_CTS_AND_DSR = 0x30
_TRANSMITTER_EMPTY = 0x60
OVERRUN = 0x02
"""Bit of the second status byte: bytes were lost because the FIFO was full."""


class Mode(enum.Enum):
    """Mode of the pins."""

    UART = "uart"
    FIFO = "ft245"
    SYNC_FIFO = "ft245-sync"
    OTHER = "other"
    """Bit-bang, MPSSE and so on, or port B while port A uses its resources: no bytes pass the pins."""


class BitMode(enum.IntEnum):
    """Supported values of the bit mode request."""

    RESET = 0x00
    SYNC_FIFO = 0x40


class ChipPort:
    """One port.

    Args:
        number: 1 for port A, 2 for port B.
        fifo_size: size of each FIFO in bytes.
        timing: figures of the model.
        first: port A if this is port B, which does not work while port A is a synchronous FIFO; otherwise None.
    """

    def __init__(self, number: int, fifo_size: int, timing: Timing, first: ChipPort | None = None) -> None:
        self.number = number
        self.in_endpoint, self.out_endpoint = in_endpoint(number), out_endpoint(number)
        self.fifo_size = fifo_size
        self.timing = timing
        self._first = first
        self.power_up("UART", 0.0)

    def power_up(self, channel_type: ChannelType, now: float) -> None:
        """Set the state after plugging in."""
        self.channel_type = channel_type
        self.to_fpga = bytearray()
        self.to_host = bytearray()
        self.baud = 9600.0
        self.reset(now)

    def reset(self, now: float) -> None:
        """Set the state after a reset request."""
        self.latency = self.timing.default_latency
        self.event_character: int | None = None
        self.bit_mode = 0
        self._errors = 0
        self.purge_to_host(now)
        self.to_fpga.clear()

    def purge_to_host(self, now: float) -> None:
        """Drop the bytes that the host has not read."""
        self.to_host.clear()
        self._wanted = 0
        """Number of bytes to the host that must be sent at once."""
        self._empty_packet_due = False
        self._timer_began = now

    @property
    def mode(self) -> Mode:
        """Mode of the pins, by EEPROM and bit mode."""
        if self._first is not None and (self.bit_mode == BitMode.SYNC_FIFO or self._first.mode is Mode.SYNC_FIFO):
            return Mode.OTHER
        if self.channel_type == "UART":
            return Mode.UART if self.bit_mode == BitMode.RESET else Mode.OTHER
        if self.bit_mode == BitMode.SYNC_FIFO:
            return Mode.SYNC_FIFO
        return Mode.FIFO if self.bit_mode == BitMode.RESET else Mode.OTHER

    # The FPGA's side

    @property
    def readable(self) -> int:
        """Number of bytes that the FPGA can read; RXF# is high if it is 0."""
        return len(self.to_fpga)

    @property
    def room(self) -> int:
        """Number of bytes that the FPGA can write; TXE# is high if it is 0."""
        return self.fifo_size - len(self.to_host)

    def read(self, count: int) -> bytes:
        """Return up to `count` bytes to the FPGA."""
        data = bytes(self.to_fpga[:count])
        del self.to_fpga[:count]
        return data

    def write(self, data: bytes | bytearray) -> None:
        """Store bytes of the FPGA; bytes without room are lost, and the next packet reports that."""
        room = self.room
        if len(data) > room:
            data = data[:room]
            self._errors |= OVERRUN
        before = len(self.to_host)
        self.to_host += data
        if self.event_character is not None:
            place = before + data.rfind(self.event_character)
            # The chip ignores an event character that is the first byte in the buffer.
            if place >= max(before, 1):
                self._wanted = place + 1

    def send_immediate(self) -> None:
        """Process a pulse of SIWU#: send all bytes in the FIFO. FTDI does not document a pulse with an empty FIFO."""
        self._wanted = len(self.to_host)

    def report_error(self, bits: int) -> None:
        """Set error bits in the second status byte of the next packet."""
        self._errors |= bits

    # The USB's side

    @property
    def can_take(self) -> int:
        """Number of bytes that the port can receive from the host now."""
        return self.fifo_size - len(self.to_fpga)

    def take(self, packet: bytes) -> None:
        """Store a packet from the host."""
        self.to_fpga += packet

    def ready_at(self, now: float) -> float:
        """Return the time from which on the port answers a request for a packet; before it answers with NAK."""
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
        packet = self.status() + payload
        self._errors = 0
        return packet

    def status(self) -> bytes:
        """Return the two status bytes at the beginning of each packet."""
        modem = _HIGH_SPEED_PACKETS | (_CTS_AND_DSR if self.mode is Mode.UART else 0)
        return bytes([modem, self._errors | (0 if self.to_fpga else _TRANSMITTER_EMPTY)])
