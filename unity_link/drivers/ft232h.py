"""``ftdi://ftdi:232h/1``: an FT232H through pyftdi, in FT245 mode with send-immediate, or as a UART.

Reading and writing block, so each has a thread: one reads all the time and feeds the event loop, one writes what the
loop gives it. A read can't be interrupted; the latency timer ends it, so nothing here takes longer to end than that.
The other way, one hop to a thread for each transaction, can't hear samples (docs/how-to/ft232h.md has the figures).

Both directions are bounded: a program that writes faster than the chip is asked to pause, and the reading thread pauses
while the loop has not taken what it read, which the chip passes on to the gateway by TXE#.
"""

from __future__ import annotations

import asyncio
import errno
import threading
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.drivers import ft232h_chip
from unity_link.drivers.ft232h_chip import (
    ERROR_BITS,
    IN_ENDPOINT,
    OPTIONS,
    OUT_ENDPOINT,
    PACKET_SIZE,
    STATUS_SIZE,
    OpenChip,
    SendImmediate,
    explain,
    find_errno,
    log,
    open_in_thread,
    stuck,
)
from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from unity_link.drivers import DriverUrl

__all__ = ["OPTIONS", "connect"]

READ_SIZE = 16384
"""Bytes of one read: the most that Linux moves in one piece."""
WRITE_SIZE = 16384
HIGH_WATER, LOW_WATER = 65536, 16384
"""Bytes to be written at which the protocol is asked to pause, and may go on."""
MOST_UNREAD = 1 << 20
"""Bytes that were read and not delivered, at which reading pauses."""
SLICE_MS = 250
"""How long a write may block before it is looked whether to go on."""
READ_SLACK_MS = 1000
"""How much longer than the latency timer a read may take; the chip answers with status bytes when it ends."""
MOST_STALLS = 3
"""Stalls without a byte in between that are cleared before the chip counts as broken."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a chip."""
    loop = asyncio.get_running_loop()
    chip = await open_in_thread(url)
    transport = ChipTransport(loop, protocol, chip)
    protocol.connection_made(transport)
    transport.start()
    return transport


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


class ChipTransport(asyncio.Transport):
    """A chip and its two threads.

    ``get_extra_info`` has ``send_immediate``, a coroutine function that takes a mode and chooses the driver's part of
    it, and ``line_errors``, the number of packets with which the chip reported lost bytes.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop, protocol: asyncio.Protocol, chip: OpenChip) -> None:
        super().__init__()
        self._loop = loop
        self._protocol = protocol
        self._chip = chip
        self._status = StatusStripper()
        self._changed = threading.Condition()
        """Guards all that both threads and the loop use, from here on."""
        self._to_write: deque[bytes] = deque()
        self._unwritten = 0
        self._unread: deque[bytes] = deque()
        self._unread_size = 0
        self._delivery_planned = False
        self._reading_paused = False
        self._closing = False
        self._aborted = False
        self._error: ConnectError | None = None
        # The loop's alone.
        self._writing_paused = False
        self._reader = threading.Thread(target=self._read_all, name="ft232h read", daemon=True)
        self._writer = threading.Thread(target=self._write_all, name="ft232h write", daemon=True)

    def start(self) -> None:
        """Begin to read and write."""
        self._writer.start()
        self._reader.start()

    # asyncio.Transport

    def get_extra_info(self, name: str, default: Any = None) -> Any:
        """Give what only this driver has."""
        if name == "send_immediate":
            return self._send_immediate
        if name == "line_errors":
            return self._status.errors
        return default

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Hand over to the writing thread."""
        if not data or self._closing:
            return
        with self._changed:
            self._to_write.append(bytes(data))
            self._unwritten += len(data)
            self._changed.notify_all()
        if self._unwritten > HIGH_WATER and not self._writing_paused:
            self._writing_paused = True
            self._protocol.pause_writing()

    def get_write_buffer_size(self) -> int:
        """Give how many bytes are not written."""
        return self._unwritten

    def get_write_buffer_limits(self) -> tuple[int, int]:
        """Give the levels at which the protocol may write again, and must pause."""
        return LOW_WATER, HIGH_WATER

    def can_write_eof(self) -> bool:
        """Say that a gateway knows no end of a stream."""
        return False

    def pause_reading(self) -> None:
        """Deliver nothing until `resume_reading`."""
        self._reading_paused = True

    def resume_reading(self) -> None:
        """Deliver again."""
        self._reading_paused = False
        self._deliver()

    def is_reading(self) -> bool:
        """Say whether what arrives is delivered."""
        return not self._reading_paused and not self._closing

    def is_closing(self) -> bool:
        """Say whether the end was asked for, or has come."""
        return self._closing

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

    async def _send_immediate(self, mode: SendImmediate) -> None:
        await self._loop.run_in_executor(None, self._chip.tune, mode)

    # In the loop

    def _deliver(self) -> None:
        """Give the protocol what was read."""
        with self._changed:
            self._delivery_planned = False
            if self._closing or self._reading_paused or not self._unread:
                return
            data = b"".join(self._unread)
            self._unread.clear()
            self._unread_size = 0
            self._changed.notify_all()
        self._protocol.data_received(data)

    def _go_on(self) -> None:
        if self._writing_paused and self._unwritten <= LOW_WATER:
            self._writing_paused = False
            self._protocol.resume_writing()

    def _lose(self) -> None:
        self._protocol.connection_lost(self._error)

    def _in_loop(self, callback: Any) -> None:
        """Have the loop call; one that is closed has nobody left to tell."""
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
        device, stalls = self._chip.device, 0
        # While a closed transport still writes, what is read has no reader, but the chip must not get stuck on it.
        while not self._closing or self._writer.is_alive():
            try:
                data = device.read(IN_ENDPOINT, READ_SIZE, self._chip.latency + READ_SLACK_MS).tobytes()
            except OSError as error:
                number = find_errno(error)
                if number == errno.EPIPE and stalls < MOST_STALLS:
                    stalls += 1
                    device.clear_halt(IN_ENDPOINT)
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
                    self._in_loop(self._go_on)
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
        device, stalls = self._chip.device, 0
        patience = time.monotonic() + ft232h_chip.WRITE_PATIENCE
        while data and not self._aborted:
            try:
                sent = device.write(OUT_ENDPOINT, data[:WRITE_SIZE], SLICE_MS)
            except OSError as error:
                number = find_errno(error)
                if number == errno.EPIPE and stalls < MOST_STALLS:
                    stalls += 1
                    device.clear_halt(OUT_ENDPOINT)
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
            if self._error is None and not self._closing:
                self._error = ConnectError(explain(error))
                self._error.__context__ = error
            self._closing = self._aborted = True
            self._changed.notify_all()
