"""The part of python-libusb1 that the overlapped driver uses, for a simulated chip.

`Context`, `Handle` and `TransferRequest` replace the classes of the `usb1` module that the driver needs, and have the
same methods. As in usbfs, the poll descriptor becomes *writable* when a transfer has ended, and callbacks run inside
`handleEventsTimeout`. A thread advances the chip in real time; an event loop with simulated time does so while it
waits.

The behaviour of libusb and the kernel is not simulated; to test it, attach the chip to a real USB stack by USB/IP
(`usbip`).
"""

from __future__ import annotations

import contextlib
import errno
import os
import select
import socket
import sys
import threading
from typing import TYPE_CHECKING, Any

from unity_link.virtual.ft232h.bus import LoopClock
from unity_link.virtual.ft232h.host import Transfer, TransferStatus

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual.ft232h.bus import VirtualFt232h
    from unity_link.virtual.modelled_time import ModelledTimeLoop

TRANSFER_COMPLETED, TRANSFER_ERROR, TRANSFER_TIMED_OUT, TRANSFER_CANCELLED = 0, 1, 2, 3
TRANSFER_STALL, TRANSFER_NO_DEVICE, TRANSFER_OVERFLOW = 4, 5, 6
_STATUSES = {
    TransferStatus.DONE: TRANSFER_COMPLETED,
    TransferStatus.STALLED: TRANSFER_STALL,
    TransferStatus.OVERFLOW: TRANSFER_OVERFLOW,
    TransferStatus.CANCELLED: TRANSFER_CANCELLED,
    TransferStatus.GONE: TRANSFER_NO_DEVICE,
}


class LoopHost:
    """Advances one chip while an event loop with simulated time waits."""

    def __init__(self, device: VirtualFt232h, loop: ModelledTimeLoop) -> None:
        self._device = device
        self._loop = loop

    def wake(self) -> None:
        """Set the timer for the next end of a transfer."""
        with self._loop.standing_still():
            due = self._device.next_end
            self._loop.call_world_at(self, due or 0.0, None if due is None else self._advance)

    def _advance(self) -> None:
        with self._device.changed:
            self._device.now()
        self.wake()

    def close(self) -> None:
        """Stop advancing the chip."""
        self._loop.call_world_at(self, 0.0, None)


class ThreadHost:
    """Advances one chip in a thread, as a kernel does."""

    def __init__(self, device: VirtualFt232h) -> None:
        self._device = device
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="virtual ft232h", daemon=True)
        self._thread.start()

    def wake(self) -> None:
        """Wake the thread, which determines the next end of a transfer."""
        with self._device.changed:
            self._device.changed.notify_all()

    def _run(self) -> None:
        device = self._device
        with device.changed:
            while not self._closed:
                now = device.now()
                due = device.next_end
                device.clock.wait(device.changed, now + 1.0 if due is None else due)

    def close(self) -> None:
        """Stop advancing the chip, and end the thread."""
        with self._device.changed:
            self._closed = True
            self._device.changed.notify_all()
        self._thread.join()


class _Signal:
    """A file descriptor that is writable while ended transfers are pending: an eventfd on Linux, otherwise a socket."""

    _FULL = 0xFFFF_FFFF_FFFF_FFFE

    def __init__(self) -> None:
        self._sockets: tuple[socket.socket, ...] = ()
        if sys.platform == "linux":
            self.descriptor = os.eventfd(0, os.EFD_NONBLOCK | os.EFD_CLOEXEC)
        else:
            self._sockets = socket.socketpair()
            for end in self._sockets:
                end.settimeout(0)
            # The smallest buffer, because it is filled and emptied for each event.
            self._sockets[0].setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1)
            self.descriptor = self._sockets[0].fileno()
        self.clear()

    def set(self) -> None:
        """Make the descriptor writable."""
        with contextlib.suppress(BlockingIOError):
            if sys.platform == "linux":
                os.eventfd_read(self.descriptor)
            while self._sockets:
                self._sockets[1].recv(65536)

    def clear(self) -> None:
        """Make the descriptor unwritable."""
        with contextlib.suppress(BlockingIOError):
            if sys.platform == "linux":
                os.eventfd_write(self.descriptor, self._FULL)
            while self._sockets:
                self._sockets[0].send(bytes(4096))

    def close(self) -> None:
        """Close the descriptor."""
        if not self._sockets:
            os.close(self.descriptor)
        for end in self._sockets:
            end.close()


class Context:
    """Replacement for `usb1.USBContext`, for a bus with one chip."""

    def __init__(self, device: VirtualFt232h) -> None:
        self._device = device
        self._ended: list[TransferRequest] = []
        self._signal = _Signal()

    def open(self) -> Context:
        """Return the context itself, as `usb1.USBContext.open` does."""
        return self

    def open_chip(self) -> Handle:
        """Open the chip."""
        clock = self._device.clock
        host = LoopHost(self._device, clock.loop) if isinstance(clock, LoopClock) else ThreadHost(self._device)
        return Handle(self, self._device, host)

    def close(self) -> None:
        """Close the poll descriptor."""
        self._signal.close()

    def ended(self, request: TransferRequest) -> None:
        """Record the end of a transfer, and signal it; called in the thread that has advanced the chip."""
        with self._device.changed:
            self._ended.append(request)
            self._signal.set()

    # usb1's names

    def getPollFDList(self) -> list[tuple[int, int]]:
        """Return the file descriptors to poll, with their events."""
        return [(self._signal.descriptor, select.POLLOUT)]

    def setPollFDNotifiers(self, added_cb: Any = None, removed_cb: Any = None) -> None:
        """Do nothing: the descriptor never changes."""

    def handleEventsTimeout(self, tv: float = 0) -> None:
        """Call the callbacks of ended transfers."""
        with self._device.changed:
            ended, self._ended = self._ended, []
            self._signal.clear()
        for request in ended:
            request.call_back()

    def getNextTimeout(self) -> float | None:
        """Return None: there are no timeouts."""
        return None


class Handle:
    """Replacement for `usb1.USBDeviceHandle`."""

    def __init__(self, context: Context, device: VirtualFt232h, host: LoopHost | ThreadHost) -> None:
        self.context = context
        self.device = device
        self._host = host

    def claimInterface(self, interface: int) -> None:
        """Claim an interface."""
        if not self.device.claim(interface, self):
            raise OSError(errno.EBUSY, f"interface {interface} is claimed")

    def releaseInterface(self, interface: int) -> None:
        """Release an interface."""
        self.device.release(interface, self)

    def clearHalt(self, endpoint: int) -> None:
        """Clear the halt of an endpoint."""
        with self.device.changed:
            self.device.host.control_out(0x02, 0x01, 0, endpoint, self.device.now())

    def submit(self, transfer: Transfer) -> None:
        """Submit a transfer.

        Raises:
            OSError: if the device is unplugged.
        """
        with self.device.changed:
            try:
                self.device.host.submit(transfer, self.device.now())
            except ConnectionError as error:
                raise OSError(errno.ENODEV, str(error)) from None
        self._host.wake()

    def cancel(self, transfer: Transfer) -> None:
        """Cancel a transfer."""
        with self.device.changed:
            self.device.host.cancel(transfer, self.device.now())
        self._host.wake()

    def getTransfer(self) -> TransferRequest:
        """Return a new transfer."""
        return TransferRequest(self)

    def close(self) -> None:
        """Release all interfaces, and stop advancing the chip."""
        for interface in list(self.device.claims):
            self.releaseInterface(interface)
        self._host.close()


class TransferRequest:
    """Replacement for `usb1.USBTransfer`."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle
        self._transfer: Transfer | None = None
        self._endpoint = 0
        self._buffer: bytes | int = b""
        self._callback: Callable[[TransferRequest], None] | None = None
        self._submitted = False

    def setBulk(
        self, endpoint: int, buffer_or_len: bytes | int, callback: Callable[[TransferRequest], None] | None = None
    ) -> None:
        """Set endpoint, data and callback of the transfer."""
        self._endpoint, self._buffer, self._callback = endpoint, buffer_or_len, callback

    def submit(self) -> None:
        """Submit the transfer."""
        buffer = self._buffer
        if isinstance(buffer, int):
            transfer = Transfer(self._endpoint, size=buffer, on_end=self._end)
        else:
            transfer = Transfer(self._endpoint, data=buffer, on_end=self._end)
        self._transfer = transfer
        self._submitted = True
        try:
            self._handle.submit(transfer)
        except OSError:
            self._submitted = False
            raise

    def _end(self, transfer: Transfer) -> None:
        self._handle.context.ended(self)

    def call_back(self) -> None:
        """Call the callback of the transfer."""
        self._submitted = False
        if self._callback is not None:
            self._callback(self)

    def cancel(self) -> None:
        """Cancel the transfer; its callback still follows."""
        assert self._transfer is not None
        self._handle.cancel(self._transfer)

    def isSubmitted(self) -> bool:
        """Return True if the transfer is pending."""
        return self._submitted

    def getStatus(self) -> int:
        """Return the result of the transfer."""
        assert self._transfer is not None
        assert self._transfer.status is not None
        return _STATUSES[self._transfer.status]

    def getActualLength(self) -> int:
        """Return the number of bytes received or sent."""
        assert self._transfer is not None
        return self._transfer.moved

    def getBuffer(self) -> bytearray:
        """Return the received bytes."""
        assert self._transfer is not None
        return self._transfer.data

    def close(self) -> None:
        """Do nothing."""
