"""The USB/IP server, used over a socket by a client of this file, byte by byte as in the kernel's documentation."""

from __future__ import annotations

import asyncio
import errno
import struct
from contextlib import AbstractContextManager, asynccontextmanager, nullcontext
from typing import TYPE_CHECKING

import pytest

from unity_link.errors import ConnectError
from unity_link.transport.ft232h.kinds import FT2232H
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard, Unconnected
from unity_link.virtual.ft232h.bus import VirtualFt232h
from unity_link.virtual.ft232h.usbip import MOST_TRANSFERS, serve_usbip

if TYPE_CHECKING:
    import threading
    from collections.abc import AsyncIterator

pytestmark = [pytest.mark.asyncio]
READ, ANSWER = b"R0A6DDE\n", b"R0A000000004E83\n"
DEVICE_SIZE = 312


class Client:
    """Uses USB/IP as a kernel does."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader = reader
        self._writer = writer
        self._number = 0

    async def read(self, size: int) -> bytes:
        return await asyncio.wait_for(self._reader.readexactly(size), 10)

    def send(self, data: bytes) -> None:
        self._writer.write(data)

    async def ask_import(self, bus_id: str = "1-1") -> int:
        self.send(bytes.fromhex("0111 8003 00000000") + bus_id.encode().ljust(32, b"\0"))
        version, code, status = struct.unpack(">HHI", await self.read(8))
        assert (version, code) == (0x0111, 0x0003)
        if not status:
            self.description = await self.read(DEVICE_SIZE)
        return int(status)

    def submit(self, endpoint: int, *, size: int = 0, data: bytes = b"", setup: bytes = bytes(8)) -> int:
        self._number += 1
        direction = 0 if data or not size else 1
        self.send(struct.pack(">IIIII", 1, self._number, 0x70002, direction, endpoint))
        self.send(struct.pack(">Iiiii", 0, size or len(data), 0, 0, 0) + setup + data)
        return self._number

    def unlink(self, number: int) -> None:
        self._number += 1
        self.send(struct.pack(">IIIIII24x", 2, self._number, 0x70002, 0, 0, number))

    async def reply(self, *reads: int) -> tuple[int, int, int, bytes]:
        """Return command, number, status and data of the next reply; `reads` are the numbers of transfers with data."""
        command, number, device, direction, endpoint = struct.unpack(">IIIII", await self.read(20))
        assert (device, direction, endpoint) == (0, 0, 0)
        status, length = struct.unpack(">ii20x", await self.read(28))
        return command, number, status, await self.read(length) if number in reads else b""

    async def control(self, kind: int, request: int, value: int, index: int, size: int = 0) -> tuple[int, bytes]:
        number = self.submit(0, size=size, setup=struct.pack("<BBHHH", kind, request, value, index, size))
        command, answered, status, data = await (self.reply(number) if kind & 0x80 else self.reply())
        assert (command, answered) == (3, number)
        return status, data

    async def ask(self, request: bytes, size: int, in_endpoint: int, out_endpoint: int) -> bytes:
        """Send a request and return `size` bytes of the answer; some reads end without data."""
        reading = self.submit(in_endpoint, size=16384)
        writing = self.submit(out_endpoint, data=request)
        received = b""
        while len(received) < size:
            command, number, status, data = await self.reply(reading)
            assert (command, status) == (3, 0)
            if number == reading:
                received += data[2:]
                reading = self.submit(in_endpoint, size=16384)
            else:
                assert number == writing
        return received

    async def close(self) -> None:
        self._writer.close()
        await self._writer.wait_closed()


@asynccontextmanager
async def served(device: VirtualFt232h | None = None) -> AsyncIterator[tuple[VirtualFt232h, int]]:
    device = device or VirtualFt232h(GatewayBoard(VirtualGateway()))
    async with serve_usbip(device, port=0) as hint:
        yield device, int(hint.split()[2])


@asynccontextmanager
async def connected(port: int) -> AsyncIterator[Client]:
    client = Client(*await asyncio.open_connection("127.0.0.1", port))
    try:
        yield client
    finally:
        await client.close()


async def test_the_device_is_listed_with_its_interface() -> None:
    async with served() as (_, port), connected(port) as client:
        client.send(bytes.fromhex("0111 8005 00000000"))
        assert await client.read(12) == bytes.fromhex("0111 0005 00000000 00000001")
        description = await client.read(DEVICE_SIZE)
        assert description[256:288].rstrip(b"\0") == b"1-1"
        assert struct.unpack(">IIIHHHBBBBBB", description[288:]) == (7, 2, 3, 0x0403, 0x6014, 0x0900, 0, 0, 0, 0, 1, 1)
        assert await client.read(4) == b"\xff\xff\xff\0"


async def test_an_ft2232h_is_listed_with_two_interfaces_and_moves_bytes_at_port_b() -> None:
    chip = VirtualFt232h(Unconnected(), GatewayBoard(VirtualGateway()), kind=FT2232H)
    async with served(chip) as (_, port):
        async with connected(port) as client:
            client.send(bytes.fromhex("0111 8005 00000000"))
            await client.read(12)
            description = await client.read(DEVICE_SIZE)
            assert struct.unpack(">HHH", description[300:306]) == (0x0403, 0x6010, 0x0700)
            assert description[-1] == 2
            assert await client.read(8) == b"\xff\xff\xff\0" * 2
        async with connected(port) as client:
            await client.ask_import()
            assert len((await client.control(0x80, 0x06, 0x0200, 0, 255))[1]) == 55
            assert await client.ask(READ, len(ANSWER), 3, 4) == ANSWER


async def test_an_unplugged_device_is_not_listed() -> None:
    async with served() as (device, port), connected(port) as client:
        device.unplug()
        client.send(bytes.fromhex("0111 8005 00000000"))
        assert await client.read(12) == bytes.fromhex("0111 0005 00000000 00000000")


async def test_a_kernel_finds_a_high_speed_ft232h() -> None:
    async with served() as (_, port), connected(port) as client:
        assert await client.ask_import() == 0
        status, device = await client.control(0x80, 0x06, 0x0100, 0, 18)
        assert (status, device[8:14].hex()) == (0, "030414600009")
        status, configuration = await client.control(0x80, 0x06, 0x0200, 0, 255)
        assert (status, len(configuration)) == (0, 32)
        assert (await client.control(0x80, 0x06, 0x0200, 0, 9))[1] == configuration[:9]
        assert await client.control(0x00, 0x09, 1, 0) == (0, b"")
        assert await client.control(0x80, 0x08, 0, 0, 1) == (0, b"\x01")
        serial = (await client.control(0x80, 0x06, 0x0303, 0x0409, 255))[1]
        assert serial[2:].decode("utf-16-le") == "UL000001"
        assert (await client.control(0xC0, 0x90, 0, 0, 2))[1][0] == 1
        assert await client.control(0xC0, 0x77, 0, 0, 2) == (-errno.EPIPE, b"")


async def test_an_unknown_configuration_is_refused_and_the_device_stays_usable() -> None:
    async with served() as (_, port):
        async with connected(port) as client:
            await client.ask_import()
            assert await client.control(0x00, 0x09, 300, 0) == (-errno.EPIPE, b"")
            assert await client.control(0x80, 0x08, 0, 0, 1) == (0, b"\0")
        async with connected(port) as client:
            client.send(bytes.fromhex("0111 8005 00000000"))
            assert await client.read(12) == bytes.fromhex("0111 0005 00000000 00000001")


async def test_a_request_is_answered_by_transfers() -> None:
    async with served() as (_, port), connected(port) as client:
        await client.ask_import()
        assert await client.ask(READ, len(ANSWER), 1, 2) == ANSWER


async def test_an_unlinked_transfer_has_only_the_reply_to_the_unlink() -> None:
    async with served() as (_, port), connected(port) as client:
        await client.ask_import()
        await client.control(0x40, 0x09, 255, 1)
        first, second = client.submit(1, size=512), client.submit(1, size=512)
        client.unlink(first)
        assert (await client.reply())[:3] == (4, second + 1, -errno.ECONNRESET)
        client.unlink(first)
        assert (await client.reply())[:3] == (4, second + 2, 0)


class ClockOfTest:
    """A clock that the test sets."""

    def __init__(self) -> None:
        self.time = 0.0

    def now(self) -> float:
        return self.time

    def wait(self, changed: threading.Condition, until: float) -> None:
        changed.wait()

    def standing_still(self) -> AbstractContextManager[None]:
        return nullcontext()


async def test_a_transfer_that_ends_before_its_unlink_has_a_reply_with_data() -> None:
    clock = ClockOfTest()
    chip = VirtualFt232h(GatewayBoard(VirtualGateway()), clock=clock)
    async with served(chip) as (_, port), connected(port) as client:
        await client.ask_import()
        writing = client.submit(2, data=READ)
        await client.control(0xC0, 0x0A, 0, 1, 1)
        clock.time = 0.001
        with chip.changed:
            chip.changed.notify_all()
        assert (await client.reply())[:3] == (3, writing, 0)
        reading = client.submit(1, size=16384)
        await client.control(0xC0, 0x0A, 0, 1, 1)
        # The answer has been ready for long, and the unlink request reveals it.
        clock.time = 1.0
        client.unlink(reading)
        command, number, status, data = await client.reply(reading)
        assert (command, number, status, data[2:]) == (3, reading, 0, ANSWER)
        assert (await client.reply())[0::2] == (4, 0)


@pytest.mark.slow
async def test_a_client_with_too_many_transfers_is_disconnected() -> None:
    async with served() as (device, port):
        async with connected(port) as client:
            await client.ask_import()
            await client.control(0x40, 0x09, 255, 1)
            for _ in range(MOST_TRANSFERS + 1):
                client.submit(1, size=512)
            with pytest.raises((asyncio.IncompleteReadError, ConnectionError)):
                await client.read(48 * MOST_TRANSFERS)
        while device.claims:  # noqa: ASYNC110  (there is no event for it)
            await asyncio.sleep(0.001)
        async with connected(port) as client:
            assert await client.ask_import() == 0


@pytest.mark.parametrize("port", [0, -1, 65536], ids=["taken", "below", "above"])
async def test_an_unavailable_port_causes_one_clear_error(port: int) -> None:
    async with served() as (_, taken):
        with pytest.raises(ConnectError, match=r"^USB/IP port -?\d+ of 127.0.0.1 (is in use|can't be opened)"):
            async with serve_usbip(VirtualFt232h(Unconnected()), port=port or taken):
                pass


async def test_an_invalid_host_name_causes_one_clear_error() -> None:
    with pytest.raises(ConnectError, match=r"USB/IP port 3240 of a\.\.b can't be opened"):
        async with serve_usbip(VirtualFt232h(Unconnected()), host="a..b"):
            pass


async def test_an_empty_host_is_refused() -> None:
    with pytest.raises(ConnectError, match="USB/IP port 0 of '' can't be opened"):
        async with serve_usbip(VirtualFt232h(Unconnected()), port=0, host=""):
            pass


async def test_a_stalled_endpoint_is_reported_and_cleared() -> None:
    async with served() as (device, port), connected(port) as client:
        await client.ask_import()
        device.halt(0x02)
        client.submit(2, data=READ)
        assert (await client.reply())[2] == -errno.EPIPE
        assert (await client.control(0x02, 0x01, 0, 0x02))[0] == 0
        client.submit(2, data=READ)
        assert (await client.reply())[2] == 0


async def test_unplugging_ends_the_transfers_and_the_connection() -> None:
    async with served() as (device, port), connected(port) as client:
        await client.ask_import()
        await client.control(0x40, 0x09, 255, 1)
        number = client.submit(1, size=512)
        await client.control(0xC0, 0x0A, 0, 1, 1)
        device.unplug()
        assert (await client.reply())[:3] == (3, number, -errno.ESHUTDOWN)
        with pytest.raises(asyncio.IncompleteReadError):
            await client.read(1)


async def test_the_device_is_used_by_one_client_at_a_time() -> None:
    async with served() as (device, port):
        async with connected(port) as first, connected(port) as second:
            assert await first.ask_import() == 0
            assert await second.ask_import() == 1
        while device.claims:  # noqa: ASYNC110  (there is no event for it)
            await asyncio.sleep(0.001)
        async with connected(port) as third:
            assert await third.ask_import() == 0


@pytest.mark.parametrize(
    "nonsense",
    [
        b"GET / HTTP/1.1\r\n",
        bytes.fromhex("0111 1234 00000000"),
        bytes.fromhex("0111 8003 00000000") + b"9-9".ljust(32, b"\0"),
    ],
)
async def test_invalid_data_ends_only_the_connection(nonsense: bytes) -> None:
    async with served() as (_, port):
        async with connected(port) as client:
            client.send(nonsense)
            with pytest.raises((asyncio.IncompleteReadError, ConnectionError)):
                await client.read(1000)
        async with connected(port) as client:
            assert await client.ask_import() == 0
            client.send(struct.pack(">IIIII", 1, 1, 0, 1, 1) + struct.pack(">Iiiii8x", 0, 1 << 30, 0, 0, 0))
            with pytest.raises((asyncio.IncompleteReadError, ConnectionError)):
                await client.read(1)
