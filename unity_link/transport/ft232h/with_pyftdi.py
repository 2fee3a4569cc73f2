"""``ftdi://ftdi:232h/1``: an FT232H through pyftdi, in FT245 mode with send-immediate, or as a UART.

A port of an FT2232H (``ftdi://ftdi:2232h/1``) is the same to it, with endpoints of its own.

Reading and writing block, so each has a thread: one reads all the time and feeds the event loop, one writes what the
loop gives it. A read can't be interrupted; the latency timer ends it, so nothing here takes longer to end than that.
The other way, one hop to a thread for each transaction, can't hear samples (docs/how-to/ft232h.md has the figures).

Both directions are bounded: a program that writes faster than the chip is asked to pause, and the reading thread pauses
while the loop has not taken what it read, which the chip passes on to the gateway by TXE#.
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
"""Bytes of one read: the most that Linux moves in one piece."""
WRITE_SIZE = 16384
MOST_UNREAD = 1 << 20
"""Bytes that were read and not delivered, at which reading pauses."""
SLICE_MS = 250
"""Milliseconds that a write may block before it is decided whether to go on."""
READ_SLACK_MS = 1000
"""Milliseconds beyond the latency timer that a read may take; the chip answers with status bytes when it ends."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a chip."""
    chip = await open_in_thread(url)
    transport = ThreadedTransport(protocol, chip)
    protocol.connection_made(transport)
    transport.start()
    return transport


class ThreadedTransport(ChipTransport):
    """A chip and its two threads."""

    def __init__(self, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__(protocol, chip)
        self._changed = threading.Condition()
        """Guards what both threads and the loop use: all below, bytes unwritten, and how it ends."""
        self._to_write: deque[bytes] = deque()
        self._unread: deque[bytes] = deque()
        self._unread_size = 0
        self._delivery_planned = False
        self._reader = threading.Thread(target=self._read_all, name="ft232h read", daemon=True)
        self._writer = threading.Thread(target=self._write_all, name="ft232h write", daemon=True)

    def start(self) -> None:
        """Begin to read and write."""
        self._writer.start()
        self._reader.start()

    # asyncio.Transport

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Hand over to the writing thread."""
        if not data or self._closing:
            return
        with self._changed:
            self._to_write.append(bytes(data))
            self._unwritten += len(data)
            self._changed.notify_all()
        self._pause_writing_if_full()

    def resume_reading(self) -> None:
        """Deliver again."""
        self._reading = True
        self._deliver()

    def close(self) -> None:
        """Write what is to be written, and end; the protocol is told within a latency tick of that."""
        self._end(aborted=False)

    def abort(self) -> None:
        """End; the protocol is told within a latency tick."""
        self._end(aborted=True)

    def _end(self, *, aborted: bool) -> None:
        with self._changed:
            self._closing = True
            self._aborted = self._aborted or aborted
            self._changed.notify_all()

    # In the loop

    def _deliver(self) -> None:
        """Pass what was read to the protocol."""
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
        """Call a function in the loop; one that is closed is not called."""
        try:
            self._loop.call_soon_threadsafe(callback)
        except RuntimeError:
            self._end(aborted=True)

    # In the reading thread

    def _read_all(self) -> None:
        """Read until the end, which this thread then makes."""
        try:
            self._read_until_end()
        except Exception as error:  # noqa: BLE001  (whatever it is, the link has to hear of it)
            self._fail(error)
        self._writer.join()
        try:
            self._chip.close(gone=self._error is not None)
        finally:
            self._in_loop(self._lose)

    def _read_until_end(self) -> None:
        device, endpoint, stalls = self._chip.device, self._chip.in_endpoint, 0
        # While a closed transport still writes, what is read has no reader, but the chip must not get stuck on it.
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
        except Exception as error:  # noqa: BLE001  (whatever it is, the link has to hear of it)
            self._fail(error)

    def _next_write(self) -> bytes:
        """Wait for something to write; nothing at the end."""
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
        """End because of an error; the first one counts."""
        with self._changed:
            self._note(error)
            self._closing = self._aborted = True
            self._changed.notify_all()
