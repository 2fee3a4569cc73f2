"""Base class of the transports of both drivers, which differ in how they transfer bytes.

``get_extra_info`` has ``send_immediate``, a coroutine function that sets the chip's latency timer for a mode, and
``line_errors``, the number of packets in which the chip reported lost bytes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.errors import ConnectError, LinkLostError, Outcome
from unity_link.transport.buffered import BufferedTransport
from unity_link.transport.ft232h.chip import ERROR_BITS, PACKET_SIZE, STATUS_SIZE, OpenChip, SendImmediate, explain, log

if TYPE_CHECKING:
    import asyncio

MOST_STALLS = 3
"""Number of consecutive stalls without a transferred byte after which the connection fails."""


class ChipTransport(BufferedTransport):
    """The transport of a chip.

    Args:
        protocol: receives the bytes.
        chip: the chip; the transport closes it.
    """

    def __init__(self, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__(protocol)
        self._chip = chip
        self._status = StatusStripper()
        self._unwritten = 0
        self._aborted = False
        self._error: ConnectError | None = None

    def get_extra_info(self, name: str, default: object = None) -> Any:
        """Return information that only these drivers have."""
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
        """Return the number of unwritten bytes."""
        return self._unwritten

    def _note(self, error: Exception) -> None:
        """Store the first error, as the reason for the loss of the chip, unless the transport is already closing."""
        if self._error is None and not self._closing:
            self._error = ConnectError(explain(error))
            self._error.__context__ = error


class StatusStripper:
    """Removes the status bytes from received data, and checks them.

    Each packet of 512 bytes, or a shorter last one, begins with two status bytes.
    """

    def __init__(self) -> None:
        self.errors = 0
        """Number of packets whose status reported a line error."""

    def strip(self, data: bytes) -> bytes:
        """Return the bytes that the gateway sent, from the data of one read."""
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
