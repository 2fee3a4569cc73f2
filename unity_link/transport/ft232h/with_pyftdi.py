"""``ftdi://ftdi:232h/1``: an FT232H through pyftdi, in FT245 mode with send-immediate, or as a UART.

``ftdi://ftdi:2232h/1`` opens a port of an FT2232H in the same way.

Reading and writing block, so each has a thread: one reads all the time and passes the bytes to the event loop, the
other writes the bytes that it gets from the loop. A read cannot be interrupted, but the latency timer ends it, so
closing takes no longer than one latency period. A single thread for all transfers could not receive unsolicited samples
(docs/how-to/ft232h.md has the figures).

Both directions have flow control. A program that writes faster than the chip is paused. The reading thread pauses while
too many bytes wait for the event loop; the chip then stops the gateway by TXE#.
"""

from __future__ import annotations

import errno
import threading
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.transport.buffered import LOW_WATER
from unity_link.transport.ft232h import chip as ft232h_chip
from unity_link.transport.ft232h.chip import (
    OPTIONS,
    OpenChip,
    find_errno,
    open_in_thread,
    options_of,
    stuck,
)
from unity_link.transport.ft232h.transport import MOST_STALLS, ChipTransport

if TYPE_CHECKING:
    import asyncio

    from unity_link.transport import DriverUrl

__all__ = ["OPTIONS", "connect", "options_of"]

READ_SIZE = 16384
"""Size of one read in bytes: the largest one that Linux transfers as a whole."""
WRITE_SIZE = 16384
MOST_UNREAD = 1 << 20
"""Number of undelivered bytes above which reading pauses."""
SLICE_MS = 250
"""Longest time in milliseconds that a write may block before it checks whether the transport was aborted."""
READ_SLACK_MS = 1000
"""Time limit of a read in milliseconds after the latency timer, at whose end the chip sends at least status bytes."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a chip."""
    chip = await open_in_thread(url)
    transport = ThreadedTransport(protocol, chip)
    protocol.connection_made(transport)
    transport.start()
    return transport


class ThreadedTransport(ChipTransport):
    """The transport of a chip, with a thread for each direction."""

    def __init__(self, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__(protocol, chip)
        self._changed = threading.Condition()
        """Guards the data that the threads and the loop share: all attributes below, `_unwritten` and `_error`."""
        self._to_write: deque[bytes] = deque()
        self._unread: deque[bytes] = deque()
        self._unread_size = 0
        self._delivery_planned = False
        self._reader = threading.Thread(target=self._read_all, name="ft232h read", daemon=True)
        self._writer = threading.Thread(target=self._write_all, name="ft232h write", daemon=True)

    def start(self) -> None:
        """Start the threads."""
        self._writer.start()
        self._reader.start()

    # asyncio.Transport

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Pass bytes to the writing thread."""
        if not data or self._closing:
            return
        with self._changed:
            self._to_write.append(bytes(data))
            self._unwritten += len(data)
            self._changed.notify_all()
        self._pause_writing_if_full()

    def resume_reading(self) -> None:
        """Deliver received bytes again."""
        self._reading = True
        self._deliver()

    def close(self) -> None:
        """Write the buffered bytes, then close the chip; `connection_lost` follows within one latency period."""
        self._end(aborted=False)

    def abort(self) -> None:
        """Close the chip, and drop unwritten bytes; `connection_lost` follows within one latency period."""
        self._end(aborted=True)

    def _end(self, *, aborted: bool) -> None:
        with self._changed:
            self._closing = True
            self._aborted = self._aborted or aborted
            self._changed.notify_all()

    # In the loop

    def _deliver(self) -> None:
        """Pass the received bytes to the protocol."""
        with self._changed:
            self._delivery_planned = False
            if self._closing or not self._reading or not self._unread:
                return
            data = b"".join(self._unread)
            self._unread.clear()
            self._unread_size = 0
            self._changed.notify_all()
        self._protocol.data_received(data)

    def _lose(self) -> None:
        self._protocol.connection_lost(self._error)

    def _in_loop(self, callback: Any) -> None:
        """Call a function in the event loop; if the loop is closed, abort the transport."""
        try:
            self._loop.call_soon_threadsafe(callback)
        except RuntimeError:
            self._end(aborted=True)

    # In the reading thread

    def _read_all(self) -> None:
        """Read until the transport closes, then close the chip."""
        try:
            self._read_until_end()
        except Exception as error:  # noqa: BLE001  (the link must get any error)
            self._fail(error)
        self._writer.join()
        try:
            self._chip.close(gone=self._error is not None)
        finally:
            self._in_loop(self._lose)

    def _read_until_end(self) -> None:
        device, endpoint, stalls = self._chip.device, self._chip.in_endpoint, 0
        # Continue reading while a closing transport writes: otherwise full FIFOs could block the writes.
        while not self._closing or self._writer.is_alive():
            try:
                data = device.read(endpoint, READ_SIZE, self._chip.latency + READ_SLACK_MS).tobytes()
            except OSError as error:
                number = find_errno(error)
                if number == errno.EPIPE and stalls < MOST_STALLS:
                    stalls += 1
                    device.clear_halt(endpoint)
                elif number != errno.ETIMEDOUT:
                    raise
                continue
            if payload := self._status.strip(data):
                stalls = 0
                self._keep(payload)

    def _keep(self, data: bytes) -> None:
        with self._changed:
            while self._unread_size > MOST_UNREAD and not self._closing:
                self._changed.wait()
            self._unread.append(data)
            self._unread_size += len(data)
            planned, self._delivery_planned = self._delivery_planned, True
        if not planned:
            self._in_loop(self._deliver)

    # In the writing thread

    def _write_all(self) -> None:
        try:
            while data := self._next_write():
                self._write(data)
                with self._changed:
                    self._unwritten -= len(data)
                    calm = self._unwritten <= LOW_WATER
                if calm and self._writing_paused:
                    self._in_loop(self._resume_writing_if_calm)
        except Exception as error:  # noqa: BLE001  (the link must get any error)
            self._fail(error)

    def _next_write(self) -> bytes:
        """Wait for bytes to write, and return them; an empty result ends the thread."""
        with self._changed:
            while not self._to_write and not self._closing:
                self._changed.wait()
            if self._aborted or not self._to_write:
                return b""
            data = self._to_write.popleft()
            while self._to_write and len(data) + len(self._to_write[0]) <= WRITE_SIZE:
                data += self._to_write.popleft()
            return data

    def _write(self, data: bytes) -> None:
        device, endpoint, stalls = self._chip.device, self._chip.out_endpoint, 0
        patience = time.monotonic() + ft232h_chip.WRITE_PATIENCE
        while data and not self._aborted:
            try:
                sent = device.write(endpoint, data[:WRITE_SIZE], SLICE_MS)
            except OSError as error:
                number = find_errno(error)
                if number == errno.EPIPE and stalls < MOST_STALLS:
                    stalls += 1
                    device.clear_halt(endpoint)
                elif number != errno.ETIMEDOUT:
                    raise
                sent = 0
            if sent:
                patience = time.monotonic() + ft232h_chip.WRITE_PATIENCE
                data = data[sent:]
            elif time.monotonic() > patience:
                raise stuck()

    # In both

    def _fail(self, error: Exception) -> None:
        """Close the chip because of an error; the first error is reported."""
        with self._changed:
            self._note(error)
            self._closing = self._aborted = True
            self._changed.notify_all()
