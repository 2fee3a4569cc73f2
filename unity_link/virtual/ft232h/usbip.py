"""A USB/IP server, by which a machine gets the simulated chip as a USB device.

A Linux machine with vhci-hcd attaches the chip (``usbip attach -r HOST -b 1-1``). Its drivers, libusb and all programs
then see a high-speed FT232H or FT2232H. The protocol is that of the kernel's ``Documentation/usb/usbip_protocol.rst``,
version 1.1.1. One client at a time can use the device; others can list it.

A thread advances the chip in real time (`libusb1.ThreadHost`), because timers of event loops are too coarse for
microframes. The event loop sends the replies for ended transfers.
"""

from __future__ import annotations

import asyncio
import errno
import struct
from typing import TYPE_CHECKING

from unity_link.transport.listening import checked_host, port_error, serving
from unity_link.virtual.ft232h import descriptors
from unity_link.virtual.ft232h.bus import BUS_NUMBER, VirtualFt232h
from unity_link.virtual.ft232h.chip import StallError
from unity_link.virtual.ft232h.host import Transfer, TransferStatus
from unity_link.virtual.ft232h.libusb1 import ThreadHost

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

PORT = 3240
"""Default port of the protocol."""
BUS_ID = "1-1"
VERSION = 0x0111
REQUEST_LIST, REPLY_LIST = 0x8005, 0x0005
REQUEST_IMPORT, REPLY_IMPORT = 0x8003, 0x0003
SUBMIT, UNLINK, SUBMITTED, UNLINKED = 1, 2, 3, 4
OPERATION = struct.Struct(">HHI")
"""Fields: version, code, status."""
DEVICE = struct.Struct(">256s32sIIIHHHBBBBBB")
INTERFACE = struct.Struct(">BBBx")
HEADER = struct.Struct(">IIIII")
"""Fields: command, sequence number, device, direction, endpoint."""
SUBMISSION = struct.Struct(">Iiiii8s")
"""Fields: flags, length, start frame, number of packets, interval, setup packet."""
UNLINKING = struct.Struct(">I24x")
SUBMISSION_REPLY = struct.Struct(">iiiii8x")
"""Fields: status, length, start frame, number of packets, errors."""
UNLINKING_REPLY = struct.Struct(">i24x")
SETUP = struct.Struct("<BBHHH")
_IN = 1
_DIRECTION_IN = 0x80
_FAILED = 1
MOST_BYTES = 1 << 20
"""Largest transfer in bytes: more than kernels submit, and little enough memory."""
MOST_TRANSFERS = 1024
"""Largest number of pending transfers on a connection; a further one ends the connection."""
_ERRORS = {
    TransferStatus.DONE: 0,
    TransferStatus.STALLED: -errno.EPIPE,
    TransferStatus.OVERFLOW: -errno.EOVERFLOW,
    TransferStatus.CANCELLED: -errno.ECONNRESET,
    TransferStatus.GONE: -errno.ESHUTDOWN,
}


@serving("an FTDI chip")
async def serve_usbip(device: VirtualFt232h, port: int = PORT, host: str = "127.0.0.1") -> AsyncIterator[str]:
    """Serve a chip, and yield the command by which a Linux machine attaches it.

    Raises:
        ConnectError: if the port cannot be opened.
    """
    device.address = device.address or 2
    server = UsbipServer(device)
    try:
        listener = await asyncio.start_server(server.serve, checked_host(host), port)
    except (OSError, OverflowError, UnicodeError) as error:
        raise port_error("USB/IP", host, port, error) from error
    try:
        address, number = listener.sockets[0].getsockname()[:2]
        yield f"usbip --tcp-port {number} attach -r {address} -b {BUS_ID}"
    finally:
        listener.close()
        await server.close()


class UsbipServer:
    """The server of one chip, with all connections."""

    def __init__(self, device: VirtualFt232h) -> None:
        self._device = device
        self._tasks: set[asyncio.Task[None]] = set()

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Serve one connection until it ends."""
        task = asyncio.current_task()
        assert task is not None
        self._tasks.add(task)
        try:
            if await self._negotiate(reader, writer):
                await UsbipImport(self._device, reader, writer).run()
        except (asyncio.IncompleteReadError, ConnectionError, asyncio.CancelledError, ProtocolError):
            pass
        finally:
            self._tasks.discard(task)
            writer.close()

    async def close(self) -> None:
        """Close all connections."""
        tasks = list(self._tasks)
        for task in tasks:
            task.cancel()
        if tasks:
            await asyncio.wait(tasks)

    async def _negotiate(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> bool:
        """Answer the first request; return True if the client has the device from now on."""
        version, code, _ = OPERATION.unpack(await reader.readexactly(OPERATION.size))
        if version != VERSION:
            raise ProtocolError(f"version {version:#x} was asked for, and {VERSION:#x} is spoken")
        if code == REQUEST_LIST:
            writer.write(OPERATION.pack(VERSION, REPLY_LIST, 0) + self._list())
            await writer.drain()
            return False
        if code != REQUEST_IMPORT:
            raise ProtocolError(f"operation {code:#x} is not known")
        wanted = (await reader.readexactly(32)).rstrip(b"\0").decode("ascii", "replace")
        free = wanted == BUS_ID and self._device.host.plugged and not self._device.claims
        writer.write(OPERATION.pack(VERSION, REPLY_IMPORT, 0 if free else _FAILED))
        if free:
            writer.write(self._describe())
        await writer.drain()
        return free

    def _list(self) -> bytes:
        if not self._device.host.plugged:
            return struct.pack(">I", 0)
        interfaces = [
            INTERFACE.pack(interface.bInterfaceClass, interface.bInterfaceSubClass, interface.bInterfaceProtocol)
            for interface in descriptors.interfaces(self._device.chip.kind)
        ]
        return struct.pack(">I", 1) + self._describe() + b"".join(interfaces)

    def _describe(self) -> bytes:
        device = self._device.chip.device_descriptor
        return DEVICE.pack(
            f"/sys/devices/virtual/unity-link/{BUS_ID}".encode(),
            BUS_ID.encode(),
            BUS_NUMBER,
            self._device.address,
            descriptors.HIGH_SPEED,
            device.idVendor,
            device.idProduct,
            device.bcdDevice,
            device.bDeviceClass,
            device.bDeviceSubClass,
            device.bDeviceProtocol,
            self._device.chip.configuration,
            device.bNumConfigurations,
            self._device.chip.kind.ports,
        )


class ProtocolError(Exception):
    """The input is not of the protocol; the connection ends."""


class UsbipImport:
    """The connection of the client that has the device."""

    def __init__(self, device: VirtualFt232h, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._device = device
        self._reader = reader
        self._writer = writer
        self._loop = asyncio.get_running_loop()
        self._under_way: dict[int, Transfer] = {}
        self._kernel = ThreadHost(device)
        self._endpoints = {endpoint for port in device.chip.ports for endpoint in (port.in_endpoint, port.out_endpoint)}

    async def run(self) -> None:
        """Serve until the client disconnects, or the device is unplugged."""
        for port in self._device.chip.ports:
            self._device.claim(port.number - 1, self)
        try:
            while True:
                command, number, _, direction, endpoint = HEADER.unpack(await self._reader.readexactly(HEADER.size))
                if command == SUBMIT:
                    await self._submit(number, direction, endpoint)
                elif command == UNLINK:
                    self._unlink(number, *UNLINKING.unpack(await self._reader.readexactly(UNLINKING.size)))
                else:
                    raise ProtocolError(f"command {command} is not known")
                await self._writer.drain()
        finally:
            for transfer in list(self._under_way.values()):
                self._cancel(transfer)
            # This joins the thread, which ends at the latest after one step of the model.
            self._kernel.close()
            for port in self._device.chip.ports:
                self._device.release(port.number - 1, self)

    async def _submit(self, number: int, direction: int, endpoint: int) -> None:
        _, length, _, _, _, setup = SUBMISSION.unpack(await self._reader.readexactly(SUBMISSION.size))
        if not 0 <= length <= MOST_BYTES:
            raise ProtocolError(f"a transfer of {length} bytes was asked for, and 0 to {MOST_BYTES} are allowed")
        data = b"" if direction == _IN else await self._reader.readexactly(length)
        if endpoint == 0:
            self._control(number, setup)
            return
        address = endpoint | (_DIRECTION_IN if direction == _IN else 0)
        if address not in self._endpoints:
            self._reply(number, -errno.EPIPE, 0, b"")
            return

        def end(ended: Transfer) -> None:
            self._loop.call_soon_threadsafe(self._end, number, ended)

        if len(self._under_way) >= MOST_TRANSFERS:
            raise ProtocolError(f"more than {MOST_TRANSFERS} transfers were asked for at a time")
        transfer = Transfer(address, size=length, data=data, on_end=end)
        self._under_way[number] = transfer
        try:
            with self._device.changed:
                self._device.host.submit(transfer, self._device.now())
        except ConnectionError:
            del self._under_way[number]
            self._reply(number, -errno.ESHUTDOWN, 0, b"")
            return
        self._kernel.wake()

    def _end(self, number: int, transfer: Transfer) -> None:
        """Reply to a transfer that has ended, unless it was unlinked before."""
        if self._under_way.pop(number, None) is None or self._writer.is_closing():
            return
        assert transfer.status is not None
        is_in = transfer.endpoint & _DIRECTION_IN
        self._reply(number, _ERRORS[transfer.status], transfer.moved, bytes(transfer.data) if is_in else b"")
        if transfer.status is TransferStatus.GONE:
            self._writer.close()

    def _unlink(self, number: int, unlinked: int) -> None:
        """Cancel a transfer; if it has ended already, its reply is sent now, or was sent before."""
        cancelled = False
        if (transfer := self._under_way.get(unlinked)) is not None:
            self._cancel(transfer)
            cancelled = transfer.status is TransferStatus.CANCELLED
            if cancelled:
                del self._under_way[unlinked]
            else:
                self._end(unlinked, transfer)
        self._writer.write(HEADER.pack(UNLINKED, number, 0, 0, 0))
        self._writer.write(UNLINKING_REPLY.pack(-errno.ECONNRESET if cancelled else 0))

    def _cancel(self, transfer: Transfer) -> None:
        with self._device.changed:
            self._device.host.cancel(transfer, self._device.now())

    def _control(self, number: int, setup: bytes) -> None:
        """Execute a control request, and reply at once, without the duration of a few microframes."""
        kind, request, value, index, length = SETUP.unpack(setup)
        device, answer = self._device, b""
        try:
            with device.changed:
                if kind & _DIRECTION_IN:
                    answer = device.host.control_in(kind, request, value, index, device.now())[0][:length]
                else:
                    device.host.control_out(kind, request, value, index, device.now())
        except StallError:
            self._reply(number, -errno.EPIPE, 0, b"")
        except ConnectionError:
            self._reply(number, -errno.ESHUTDOWN, 0, b"")
        else:
            self._reply(number, 0, len(answer), answer)
            self._kernel.wake()

    def _reply(self, number: int, status: int, moved: int, data: bytes) -> None:
        self._writer.write(
            HEADER.pack(SUBMITTED, number, 0, 0, 0) + SUBMISSION_REPLY.pack(status, moved, 0, 0, 0) + data
        )
