"""The transport of both drivers of the chips for the event loop; they differ in how they move bytes.

``get_extra_info`` has ``send_immediate``, a coroutine function that takes a mode and chooses the driver's part of it,
and ``line_errors``, the number of packets with which the chip reported lost bytes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.errors import ConnectError, LinkLostError, Outcome
from unity_link.transport.buffered import BufferedTransport
from unity_link.transport.ft232h.chip import ERROR_BITS, PACKET_SIZE, STATUS_SIZE, OpenChip, SendImmediate, explain, log

if TYPE_CHECKING:
    import asyncio

MOST_STALLS = 3
"""Stalls without a byte in between that are cleared before the chip counts as broken."""


class ChipTransport(BufferedTransport):
    """A chip that a protocol reads from and writes to.

    Args:
        protocol: reads and writes.
        chip: is closed at the end.
    """

    def __init__(self, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__(protocol)
        self._chip = chip
        self._status = StatusStripper()
        self._unwritten = 0
        self._aborted = False
        self._error: ConnectError | None = None

    def get_extra_info(self, name: str, default: object = None) -> Any:
        """Return what only these drivers have."""
        if name == "send_immediate":
            return self._send_immediate
        if name == "line_errors":
            return self._status.errors
        return default

    async def _send_immediate(self, mode: SendImmediate) -> None:
        try:
            await self._loop.run_in_executor(None, self._chip.tune, mode)
        except OSError as error:
            self._note(error)
            self.abort()
            raise LinkLostError(explain(error), Outcome.EXECUTED) from error

    def get_write_buffer_size(self) -> int:
        """Return how many bytes are not written."""
        return self._unwritten

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
        """Return the bytes of the gateway in a read."""
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
            log.warning(
                "the FTDI chip reports lost bytes (line status %02X): the gateway wrote more than it took", status
            )
