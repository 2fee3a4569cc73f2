"""``ftdi-async://ftdi:232h/1``: an FT232H with several transfers always submitted, without threads.

``ftdi-async://ftdi:2232h/1`` opens a port of an FT2232H in the same way.

While the program processes one transfer, the next one is already being filled, so that the chip's FIFO (1 KiB; 4 KiB in
an FT2232H) does not overflow if the computer is busy. The event loop polls libusb's descriptors and runs its callbacks.
The chip is found, checked and configured by pyftdi, as for ``ftdi://``; pyftdi keeps it open for the requests that set
its timer. Transfers use python-libusb1.

usbfs reports a finished transfer by making its descriptor *writable*; therefore `add_writer` is used.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import select
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.errors import ConnectError
from unity_link.transport.ft232h import chip as ft232h_chip
from unity_link.transport.ft232h.chip import (
    OPTIONS,
    OpenChip,
    explain,
    open_in_thread,
    options_of,
    stuck,
)
from unity_link.transport.ft232h.transport import MOST_STALLS, ChipTransport

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

__all__ = ["OPTIONS", "connect", "options_of"]

READ_SIZE = 8192
"""Size of one transfer in bytes.

A large transfer does not delay a single answer, because a short packet ends the transfer. With transfers of twice this
size, a stream of short answers would fill the link's window before the transfer, and wait for the latency timer. With
half of this size, the program needs more processor time for each byte (docs/paper.md).
"""
POSTED_READS = 8
MOST_WRITES = 4
"""Largest number of transfers to the chip at the same time."""
WRITE_SIZE = 16384
_ERRNO_OF_STATUS = {1: errno.EIO, 2: errno.ETIMEDOUT, 4: errno.EPIPE, 5: errno.ENODEV, 6: errno.EOVERFLOW}
"""Operating system's error for each status of a transfer in libusb."""
_COMPLETED, _CANCELLED, _STALLED = 0, 3, 4


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a chip."""
    loop = asyncio.get_running_loop()
    chip = await open_in_thread(url)
    try:
        transport = OverlappedTransport(protocol, chip, _open_usb(chip))
    except BaseException:
        await loop.run_in_executor(None, chip.close)
        raise
    protocol.connection_made(transport)
    transport.start()
    return transport


def _open_usb(chip: OpenChip) -> tuple[Any, Any]:
    """Return libusb's context and handle of the chip, or their replacements from the backend of a simulated chip."""
    from usb.util import release_interface

    device = chip.device
    open_for_transfers = getattr(device.backend, "open_for_transfers", _open_real)
    try:
        release_interface(device, chip.interface)
        context, handle = open_for_transfers(device.bus, device.address, chip.interface)
    except OSError as error:
        # The chip was unplugged after it was found.
        raise ConnectError(explain(error)) from error
    return context, handle


def _open_real(bus: int, address: int, interface: int) -> tuple[Any, Any]:
    try:
        import usb1
    except ImportError as error:
        raise ConnectError(
            "ftdi-async: needs libusb1, which is not installed: pip install 'unity-link[usb]'"
        ) from error
    try:
        context = usb1.USBContext().open()
    except OSError as error:
        raise ConnectError("libusb is not installed (Debian, Ubuntu: apt install libusb-1.0-0)") from error
    try:
        for device in context.getDeviceIterator(skip_on_error=True):
            if (device.getBusNumber(), device.getDeviceAddress()) == (bus, address):
                handle = device.open()
                handle.claimInterface(interface)
                return context, handle
    except usb1.USBError as error:
        context.close()
        raise ConnectError(explain(_os_error(error))) from error
    context.close()
    raise ConnectError(explain(OSError(errno.ENODEV, "not found")))


_ERRNO_OF_LIBUSB = {
    -1: errno.EIO,
    -3: errno.EACCES,
    -4: errno.ENODEV,
    -6: errno.EBUSY,
    -7: errno.ETIMEDOUT,
    -9: errno.EPIPE,
}


def _os_error(error: Exception) -> Exception:
    """Return the operating system's error for an error of libusb."""
    number = _ERRNO_OF_LIBUSB.get(getattr(error, "value", 0))
    return error if number is None else OSError(number, str(error))


class OverlappedTransport(ChipTransport):
    """The transport of a chip with overlapped transfers; all of its code runs in the event loop."""

    def __init__(self, protocol: asyncio.Protocol, chip: OpenChip, usb: tuple[Any, Any]) -> None:
        super().__init__(protocol, chip)
        self._context, self._handle = usb
        self._received: list[bytes] = []
        self._to_write: deque[bytes] = deque()
        self._idle_writes = [self._handle.getTransfer() for _ in range(MOST_WRITES)]
        self._reads = [self._handle.getTransfer() for _ in range(POSTED_READS)]
        self._idle_reads = list(self._reads)
        self._again: list[bytes] = []
        """Bytes that a stalled endpoint did not accept, in order."""
        self._data: dict[Any, bytes] = {}
        """Data of each submitted write."""
        self._under_way = 0
        self._in, self._out = chip.in_endpoint, chip.out_endpoint
        self._stalls = {self._in: 0, self._out: 0}
        self._clearing: set[int] = set()
        self._patience: asyncio.TimerHandle | None = None
        """Timer that runs while writes are submitted; each finished write restarts it."""
        settings = chip.settings
        # On a slow line, limit the size of a write, so that each write takes at most about a second.
        self._write_size = WRITE_SIZE if settings.mode != "uart" else min(WRITE_SIZE, max(settings.baud // 10, 64))
        self._watched: list[int] = []
        self._released = False

    def start(self) -> None:
        """Watch libusb's descriptors, and submit the reads."""
        for descriptor, events in self._context.getPollFDList():
            self._watch(descriptor, events)
        self._context.setPollFDNotifiers(
            lambda descriptor, events, _: self._watch(descriptor, events),
            lambda descriptor, _: self._unwatch(descriptor),
        )
        self._post_reads()

    # Events

    def _watch(self, descriptor: int, events: int) -> None:
        if events & select.POLLIN:
            self._loop.add_reader(descriptor, self._handle_events)
        if events & select.POLLOUT:
            self._loop.add_writer(descriptor, self._handle_events)
        self._watched.append(descriptor)

    def _unwatch(self, descriptor: int) -> None:
        self._loop.remove_reader(descriptor)
        self._loop.remove_writer(descriptor)
        self._watched.remove(descriptor)

    def _handle_events(self) -> None:
        self._context.handleEventsTimeout(0)
        self._post_reads()
        self._post_writes()
        self._deliver()
        self._release()

    # asyncio.Transport

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Submit bytes at once if a transfer is free, otherwise when one becomes free."""
        if not data or self._closing:
            return
        self._to_write.append(bytes(data))
        self._unwritten += len(data)
        self._post_writes()
        self._pause_writing_if_full()

    def resume_reading(self) -> None:
        """Submit reads again."""
        self._reading = True
        self._post_reads()
        self._loop.call_soon(self._deliver)

    def close(self) -> None:
        """Write the buffered bytes, then close the chip."""
        self._closing = True
        self._loop.call_soon(self._release)

    def abort(self) -> None:
        """Close the chip at once, and drop unwritten bytes."""
        self._closing = self._aborted = True
        self._to_write.clear()
        self._again.clear()
        self._unwritten = 0
        self._loop.call_soon(self._release)

    # Reading

    def _post_reads(self) -> None:
        # Continue reading while a closing transport writes: otherwise full FIFOs could block the writes.
        wanted = self._reading and not self._aborted and (not self._closing or self._unwritten)
        while self._idle_reads and wanted and self._in not in self._clearing:
            transfer = self._idle_reads.pop(0)
            transfer.setBulk(self._in, READ_SIZE, callback=self._end_read)
            wanted = self._submit(transfer, self._idle_reads)

    def _end_read(self, transfer: Any) -> None:
        self._under_way -= 1
        self._idle_reads.append(transfer)
        status = transfer.getStatus()
        if status in (_COMPLETED, _CANCELLED):
            payload = self._status.strip(bytes(transfer.getBuffer()[: transfer.getActualLength()]))
            if payload:
                self._stalls[self._in] = 0
                self._received.append(payload)
        else:
            self._take_failure(self._in, status)

    def _deliver(self) -> None:
        if self._received and self._reading and not self._closing:
            data = b"".join(self._received)
            self._received.clear()
            self._protocol.data_received(data)

    # Writing

    def _post_writes(self) -> None:
        while self._to_write and self._idle_writes and self._out not in self._clearing:
            data = self._to_write.popleft()
            most = self._write_size
            while self._to_write and len(data) + len(self._to_write[0]) <= most:
                data += self._to_write.popleft()
            if len(data) > most:
                self._to_write.appendleft(data[most:])
                data = data[:most]
            transfer = self._idle_writes.pop(0)
            transfer.setBulk(self._out, data, callback=self._end_write)
            self._data[transfer] = data
            if not self._submit(transfer, self._idle_writes):
                return
            if self._patience is None:
                self._wait_for_progress()

    def _wait_for_progress(self) -> None:
        if self._patience is not None:
            self._patience.cancel()
            self._patience = None
        if self._data:
            self._patience = self._loop.call_later(ft232h_chip.WRITE_PATIENCE, self._fail, stuck())

    def _end_write(self, transfer: Any) -> None:
        self._under_way -= 1
        self._idle_writes.append(transfer)
        data, sent = self._data.pop(transfer), transfer.getActualLength()
        status = transfer.getStatus()
        if status == _COMPLETED:
            self._stalls[self._out] = 0
            self._unwritten -= len(data)
        elif status != _CANCELLED:
            self._unwritten -= sent
            self._again.append(data[sent:])
            self._take_failure(self._out, status)
        self._wait_for_progress()
        if self._writing_paused:
            # Not in a callback of libusb, because the protocol may write at once.
            self._loop.call_soon(self._resume_writing_if_calm)

    # Failures and the end

    def _submit(self, transfer: Any, idle: list[Any]) -> bool:
        try:
            transfer.submit()
        except Exception as error:  # noqa: BLE001  (each error of libusb has its own class)
            idle.append(transfer)
            self._data.pop(transfer, None)
            self._fail(_os_error(error))
            return False
        self._under_way += 1
        return True

    def _take_failure(self, endpoint: int, status: int) -> None:
        """Clear a stalled endpoint; close the chip after other failures."""
        if status == _STALLED and self._stalls[endpoint] < MOST_STALLS:
            if endpoint not in self._clearing:
                self._stalls[endpoint] += 1
                self._clearing.add(endpoint)
                clearing = self._loop.run_in_executor(None, self._handle.clearHalt, endpoint)
                clearing.add_done_callback(lambda done: self._end_clearing(endpoint, done.exception()))
            return
        self._fail(OSError(_ERRNO_OF_STATUS.get(status, errno.EIO), f"libusb's status {status}"))

    def _end_clearing(self, endpoint: int, error: BaseException | None) -> None:
        self._clearing.discard(endpoint)
        if isinstance(error, Exception):
            self._fail(_os_error(error))
        if endpoint == self._out:
            self._to_write.extendleft(reversed(self._again))
            self._again.clear()
        self._post_reads()
        self._post_writes()
        self._release()

    def _fail(self, error: Exception) -> None:
        """Close the chip because of an error; the first error is reported."""
        self._note(error)
        self.abort()

    def _release(self) -> None:
        """Once closing and without bytes to write, cancel the submitted transfers, and close the chip after them."""
        if not self._closing or self._released or (self._unwritten and not self._aborted):
            return
        if self._under_way or self._clearing:
            for transfer in (*self._data, *self._posted_reads()):
                _cancel(transfer)
            return
        self._released = True
        # The chip is closed in a thread, whose calls must not reach the event loop: remove the notifiers first.
        self._context.setPollFDNotifiers()
        if self._patience is not None:
            self._patience.cancel()
        for descriptor in list(self._watched):
            self._unwatch(descriptor)
        closing = self._loop.run_in_executor(None, self._close_chip)
        closing.add_done_callback(self._lose)

    def _posted_reads(self) -> list[Any]:
        return [transfer for transfer in self._reads if transfer not in self._idle_reads]

    def _close_chip(self) -> None:
        self._handle.close()
        self._context.close()
        self._chip.close(gone=self._error is not None)

    def _lose(self, closing: asyncio.Future[None]) -> None:
        error = closing.exception()
        if error is not None and self._error is None:
            self._error = ConnectError(explain(error))
        self._protocol.connection_lost(self._error)


def _cancel(transfer: Any) -> None:
    """Cancel a transfer if it is submitted; its callback still follows."""
    if transfer.isSubmitted():
        # The transfer may have finished already, although its callback has not run yet.
        with contextlib.suppress(Exception):
            transfer.cancel()
