"""What both drivers of the FT232H are to the event loop; they differ in how they move bytes.

``get_extra_info`` has ``send_immediate``, a coroutine function that takes a mode and chooses the driver's part of it,
and ``line_errors``, the number of packets with which the chip reported lost bytes.
"""

from __future__ import annotations

import asyncio
from typing import Any

from unity_link.errors import ConnectError
from unity_link.transport.ft232h.chip import ERROR_BITS, PACKET_SIZE, STATUS_SIZE, OpenChip, SendImmediate, explain, log

HIGH_WATER, LOW_WATER = 65536, 16384
"""Bytes to be written at which the protocol is asked to pause, and may go on."""
MOST_STALLS = 3
"""Stalls without a byte in between that are cleared before the chip counts as broken."""


class ChipTransport(asyncio.Transport):
    """A chip that a protocol reads from and writes to.

    Args:
        loop: the protocol's.
        protocol: who reads and writes.
        chip: is closed at the end.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__()
        self._loop = loop
        self._protocol = protocol
        self._chip = chip
        self._status = StatusStripper()
        self._unwritten = 0
        self._writing_paused = self._reading_paused = False
        self._closing = self._aborted = False
        self._error: ConnectError | None = None

    def get_extra_info(self, name: str, default: Any = None) -> Any:
        """Give what only these drivers have."""
        if name == "send_immediate":
            return self._send_immediate
        if name == "line_errors":
            return self._status.errors
        return default

    async def _send_immediate(self, mode: SendImmediate) -> None:
        await self._loop.run_in_executor(None, self._chip.tune, mode)

    def get_write_buffer_size(self) -> int:
        """Give how many bytes are not written."""
        return self._unwritten

    def get_write_buffer_limits(self) -> tuple[int, int]:
        """Give the levels at which the protocol may write again, and must pause."""
        return LOW_WATER, HIGH_WATER

    def can_write_eof(self) -> bool:
        """Say that a gateway knows no end of a stream."""
        return False

    def is_reading(self) -> bool:
        """Say whether what arrives is delivered."""
        return not self._reading_paused and not self._closing

    def is_closing(self) -> bool:
        """Say whether the end was asked for, or has come."""
        return self._closing

    # For the drivers

    def _pause_writing_if_full(self) -> None:
        if self._unwritten > HIGH_WATER and not self._writing_paused:
            self._writing_paused = True
            self._protocol.pause_writing()

    def _resume_writing_if_calm(self) -> None:
        if self._writing_paused and self._unwritten <= LOW_WATER:
            self._writing_paused = False
            self._protocol.resume_writing()

    def _note(self, error: Exception) -> None:
        """Keep why the chip is lost; the first error counts, and none of an end that was asked for."""
        if self._error is None and not self._closing:
            self._error = ConnectError(explain(error))
            self._error.__context__ = error


class StatusStripper:
    """Takes the status bytes out of what the chip sends, and looks at them.

    Every packet begins with two of them, and a read is cut into packets of 512 bytes.
    """

    def __init__(self) -> None:
        self.errors = 0
        """Packets whose status reported an error of the line."""

    def strip(self, data: bytes) -> bytes:
        """Give the bytes of the gateway in a read."""
        for start in range(1, len(data), PACKET_SIZE):
            if data[start] & ERROR_BITS:
                self._report(data[start])
        if len(data) <= PACKET_SIZE:
            return data[STATUS_SIZE:]
        starts = range(STATUS_SIZE, len(data), PACKET_SIZE)
        return b"".join([data[start : start + PACKET_SIZE - STATUS_SIZE] for start in starts])

    def _report(self, status: int) -> None:
        self.errors += 1
        if self.errors == 1:
            log.warning("the FT232H reports lost bytes (line status %02X): the gateway wrote more than it took", status)
