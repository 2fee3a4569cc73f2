"""Served gateways, over real terminals and sockets."""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
import stat
import struct
import tracemalloc
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from unity_link.errors import ConnectError
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.serving import BUSY, serve_pty, serve_tcp, serve_udp, serve_unix

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable
    from pathlib import Path

CHECKED = Framing(Crc()).checked
Stream = tuple[asyncio.StreamReader, asyncio.StreamWriter]


def port_of(url: str) -> int:
    return int(url.rpartition(":")[2])


@contextlib.asynccontextmanager
async def tcp_client(url: str) -> AsyncIterator[Stream]:
    reader, writer = await asyncio.open_connection("127.0.0.1", port_of(url))
    yield reader, writer
    writer.close()
    await writer.wait_closed()


@contextlib.asynccontextmanager
async def unix_client(url: str) -> AsyncIterator[Stream]:
    reader, writer = await asyncio.open_unix_connection(url.removeprefix("unix:"))
    yield reader, writer
    writer.close()
    await writer.wait_closed()


async def ask(stream: Stream, request: bytes) -> bytes:
    stream[1].write(request)
    return await asyncio.wait_for(stream[0].readuntil(b"\n"), 10)


class Port:
    """A client of a serial port."""

    def __init__(self, url: str) -> None:
        self.descriptor = os.open(url.removeprefix("serial:"), os.O_RDWR | os.O_NOCTTY)

    async def ask(self, request: bytes) -> bytes:
        os.write(self.descriptor, request)
        answer = b""
        while not answer.endswith(b"\n"):
            answer += await asyncio.wait_for(asyncio.to_thread(os.read, self.descriptor, 4096), 10)
        return answer

    def close(self) -> None:
        os.close(self.descriptor)


class Datagrams(asyncio.DatagramProtocol):
    """A client of a datagram socket."""

    def __init__(self) -> None:
        self.received: asyncio.Queue[bytes] = asyncio.Queue()

    def connection_made(self, transport: Any) -> None:
        self.transport = transport

    def datagram_received(self, data: bytes, addr: Any) -> None:
        self.received.put_nowait(data)

    async def next(self) -> bytes:
        return await asyncio.wait_for(self.received.get(), 10)


async def datagram_client(url: str) -> Datagrams:
    loop = asyncio.get_running_loop()
    _, client = await loop.create_datagram_endpoint(Datagrams, remote_addr=("127.0.0.1", port_of(url)))
    return client


def split(datagram: bytes) -> tuple[bytes, bytes]:
    """Return the header of a datagram, and the frames after it."""
    end = datagram.index(b"\n") + 1
    return datagram[:end], datagram[end:]


async def opened(client: Datagrams) -> bytes:
    """Open a session; return the beginning of its headers."""
    client.transport.sendto(b"Q\r")
    session = (await client.next())[:9]
    # Each client has a port of its own, from which the number of its session is derived.
    opening = b"K000%04X" % (1 + client.transport.get_extra_info("sockname")[1] % 0x7FFF)
    client.transport.sendto(session + b"00000001\r" + opening + b"\r")
    header, answer = split(await client.next())
    assert header == CHECKED(session + b"00000001")
    assert answer.startswith(opening)
    return session


@pytest.mark.asyncio
async def test_a_gateway_answers_over_tcp_and_keeps_its_memory_between_clients() -> None:
    async with serve_tcp(VirtualGateway()) as url:
        async with tcp_client(url) as stream:
            assert await ask(stream, b"W1007\r") == b"W10\r\n"
        async with tcp_client(url) as stream:
            assert await ask(stream, b"R10\r") == b"R1000000007\r\n"


@pytest.mark.asyncio
async def test_a_second_client_gets_busy_and_the_first_client_goes_on() -> None:
    async with serve_tcp(VirtualGateway()) as url, tcp_client(url) as first:
        assert await ask(first, b"H\r") == b"H\r\n"
        async with tcp_client(url) as second:
            assert await second[0].read() == BUSY
        assert await ask(first, b"H\r") == b"H\r\n"


@pytest.mark.asyncio
async def test_a_second_client_that_resets_its_connection_causes_no_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    errors: list[dict[str, Any]] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: errors.append(context))
    was_told, shutdown = asyncio.Event(), socket.socket.shutdown
    async with serve_tcp(VirtualGateway()) as url, tcp_client(url) as first:
        assert await ask(first, b"H\r") == b"H\r\n"
        second = socket.create_connection(("127.0.0.1", port_of(url)))

        def reset_and_shut_down(served: socket.socket, how: int) -> None:
            second.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            second.close()
            was_told.set()
            shutdown(served, how)

        monkeypatch.setattr(socket.socket, "shutdown", reset_and_shut_down)
        await asyncio.wait_for(was_told.wait(), 10)
        assert await ask(first, b"H\r") == b"H\r\n"
    assert errors == []


@pytest.mark.asyncio
async def test_a_programs_error_quotes_the_reason_of_its_disconnection() -> None:
    async with serve_tcp(VirtualGateway()) as url, unity_link.connect(url):
        with pytest.raises(ConnectError, match=BUSY.decode().strip()):
            async with unity_link.connect(url):
                pass


@pytest.mark.asyncio
async def test_the_end_of_serving_disconnects_clients() -> None:
    async with serve_tcp(VirtualGateway()) as url:
        stream = await asyncio.open_connection("127.0.0.1", port_of(url))
        await ask(stream, b"H\r")
    with contextlib.suppress(ConnectionResetError):
        assert await stream[0].read() == b""
    stream[1].close()
    with pytest.raises(OSError, match=r"refused|Connect call failed"):
        await asyncio.open_connection("127.0.0.1", port_of(url))


@pytest.mark.asyncio
async def test_the_end_of_serving_disconnects_waiting_clients_too() -> None:
    async with serve_tcp(VirtualGateway()) as url, tcp_client(url) as first:
        assert await ask(first, b"H\r") == b"H\r\n"
        waiting = await asyncio.open_connection("127.0.0.1", port_of(url))
    assert await asyncio.wait_for(waiting[0].read(), 10) == b""
    waiting[1].close()


@pytest.mark.asyncio
@pytest.mark.parametrize("turns", range(3, 6))
async def test_the_end_of_serving_disconnects_connecting_clients(turns: int) -> None:
    with socket.socket() as client:
        async with serve_tcp(VirtualGateway()) as url:
            client.connect(("127.0.0.1", port_of(url)))
            client.setblocking(False)
            for _ in range(turns):
                await asyncio.sleep(0)
        with contextlib.suppress(ConnectionResetError):
            assert await asyncio.wait_for(asyncio.get_running_loop().sock_recv(client, 1), 10) == b""


@pytest.mark.slow
@pytest.mark.asyncio
async def test_a_slow_client_gets_all_bytes_without_taking_memory() -> None:
    requests = 12_000
    async with serve_tcp(VirtualGateway()) as url, tcp_client(url) as (reader, writer):
        tracemalloc.start()
        try:
            writer.write(b"RM00FF\r" * requests)
            expected = b"RM00FF" + b"0" * 2040 + b"\r\n"
            for _ in range(requests):
                assert await reader.readexactly(len(expected)) == expected
            # 24 MB were transferred.
            assert tracemalloc.get_traced_memory()[1] < 4_000_000
        finally:
            tracemalloc.stop()


@pytest.mark.asyncio
async def test_an_address_of_another_machine_causes_one_clear_error() -> None:
    with pytest.raises(ConnectError, match=r"of 192\.0\.2\.1 can't be opened .*: choose another port or address"):
        async with serve_tcp(VirtualGateway(), host="192.0.2.1"):
            pass


@pytest.mark.asyncio
@pytest.mark.parametrize("serve", [serve_tcp, serve_udp])
async def test_an_empty_address_is_refused(serve: Callable[..., Any]) -> None:
    with pytest.raises(ConnectError, match=r"port 0 of '' can't be opened \(an address was expected\): choose another"):
        async with serve(VirtualGateway(), host=""):
            pass


@pytest.mark.asyncio
async def test_a_busy_tcp_port_causes_one_clear_error() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(ConnectError, match=rf"TCP port {port} of .* is in use: choose another"):
            async with serve_tcp(VirtualGateway(), port):
                pass


@pytest.mark.asyncio
async def test_an_invalid_port_causes_one_clear_error() -> None:
    for serve in (serve_tcp, serve_udp):
        with pytest.raises(ConnectError, match="port 70000"):
            async with serve(VirtualGateway(), 70000):
                pass


@pytest.mark.asyncio
async def test_a_unix_socket_is_private_to_its_owner_and_removed_at_the_end(tmp_path: Path) -> None:
    place = tmp_path / "gateway"
    async with serve_unix(VirtualGateway(), place) as url:
        assert url == f"unix:{place}"
        assert stat.S_IMODE(place.stat().st_mode) == 0o600
        async with unix_client(url) as stream:
            assert await ask(stream, b"R10\r") == b"R1000000000\r\n"
    assert not place.exists()


@pytest.mark.asyncio
async def test_an_abandoned_socket_is_replaced_and_a_served_one_is_not(tmp_path: Path) -> None:
    place = tmp_path / "gateway"
    with socket.socket(socket.AF_UNIX) as left_behind:
        left_behind.bind(str(place))
    async with serve_unix(VirtualGateway(), place) as url:
        with pytest.raises(ConnectError, match="already served"):
            async with serve_unix(VirtualGateway(), place):
                pass
        async with unix_client(url) as stream:
            assert await ask(stream, b"H\r") == b"H\r\n"


@pytest.mark.asyncio
async def test_a_file_that_is_no_socket_is_not_replaced(tmp_path: Path) -> None:
    place = tmp_path / "notes"
    place.write_text("mine")
    with pytest.raises(ConnectError, match="no socket: remove it"):
        async with serve_unix(VirtualGateway(), place):
            pass
    assert place.read_text() == "mine"
    with pytest.raises(ConnectError, match="choose another path"):
        async with serve_unix(VirtualGateway(), tmp_path / "nowhere" / "socket"):
            pass


@pytest.mark.asyncio
async def test_a_serial_port_may_be_closed_and_opened_again() -> None:
    async with serve_pty(VirtualGateway()) as url:
        for word in (b"00000001", b"00000002"):
            port = Port(url)
            assert await port.ask(b"W10" + word + b"\r") == b"W10\r\n"
            port.close()
        port = Port(url)
        assert await port.ask(b"R10\r") == b"R1000000002\r\n"
        port.close()


@pytest.mark.asyncio
async def test_a_serial_port_is_raw() -> None:
    async with serve_pty(VirtualGateway()) as url:
        port = Port(url)
        gateway_hears = bytes(byte for byte in range(256) if byte not in b"\r\n")
        assert await port.ask(gateway_hears + b"\r") == b"X02\r\n"
        assert await port.ask(CHECKED(b"R0A")) == CHECKED(b"R0A00000000")
        port.close()


@pytest.mark.asyncio
async def test_a_serial_port_survives_a_client_that_left_with_samples_running() -> None:
    gateway = VirtualGateway()
    async with serve_pty(gateway) as url:
        port = Port(url)
        os.write(port.descriptor, b"GS000100010110\rGN00\r")
        now = asyncio.get_running_loop().time
        # A gateway whose output is not read stops, so its next sample becomes overdue.
        while (due := gateway.next_due) is None or due > now() - 0.1:  # noqa: ASYNC110  (no event reports it)
            await asyncio.sleep(0.001)
        port.close()
        port = Port(url)
        os.write(port.descriptor, b"K0000001\rH\r")
        answer = b""
        while not answer.endswith(b"H\r\n"):
            answer = answer[-3:] + await asyncio.wait_for(asyncio.to_thread(os.read, port.descriptor, 65536), 10)
        port.close()


@pytest.mark.asyncio
async def test_a_symbolic_link_to_a_serial_port_is_removed_at_the_end(tmp_path: Path) -> None:
    link = tmp_path / "port"
    async with serve_pty(VirtualGateway(), link) as url:
        assert url == f"serial:{link}"
        port = Port(url)
        assert await port.ask(b"H\r") == b"H\r\n"
        port.close()
    assert not link.is_symlink()


@pytest.mark.asyncio
async def test_a_symbolic_link_replaces_only_a_dangling_one(tmp_path: Path) -> None:
    link = tmp_path / "port"
    link.symlink_to("/dev/pts/gone")
    async with serve_pty(VirtualGateway(), link):
        with pytest.raises(ConnectError, match="remove it, or choose another"):
            async with serve_pty(VirtualGateway(), link):
                pass
        assert link.exists()


@pytest.mark.asyncio
async def test_datagrams_have_whole_frames_after_a_header() -> None:
    async with serve_udp(VirtualGateway()) as url:
        client = await datagram_client(url)
        client.transport.sendto(b"RM00FF\r" + b"H\r" * 1000)
        received = b""
        while received.count(b"\n") < 1001:
            header, datagram = split(await client.next())
            assert header.endswith(b"00000000\r\n")
            assert datagram.endswith(b"\r\n")
            assert len(header + datagram) <= 1400 or datagram.count(b"\n") == 1
            received += datagram
        assert received == b"RM00FF" + b"0" * 2040 + b"\r\n" + b"H\r\n" * 1000
        client.transport.close()


@pytest.mark.asyncio
async def test_datagrams_arrive_over_ipv6_too() -> None:
    try:
        served = await asyncio.get_running_loop().create_datagram_endpoint(Datagrams, local_addr=("::1", 0))
    except OSError:
        pytest.skip("no IPv6 on this machine")
    served[0].close()
    async with serve_udp(VirtualGateway(), host="::1") as url, unity_link.connect(url) as link:
        assert await link.read(0x10) == 0


@pytest.mark.asyncio
async def test_a_cut_datagram_does_not_damage_the_next_one() -> None:
    async with serve_udp(VirtualGateway()) as url:
        client = await datagram_client(url)
        client.transport.sendto(b"W10000")
        assert split(await client.next())[1] == CHECKED(b"X01")
        client.transport.sendto(b"H\r")
        assert split(await client.next())[1] == b"H\r\n"
        client.transport.close()


@pytest.mark.asyncio
async def test_samples_are_sent_to_the_client_that_opened_the_session() -> None:
    gateway = VirtualGateway()
    async with serve_udp(gateway) as url:
        first, second = await datagram_client(url), await datagram_client(url)
        session = await opened(first)
        first.transport.sendto(session + b"00000002\rGS000200010110\rGN00\r")
        assert split(await first.next())[1] == b"GS00\r\nGN00\r\n"
        second.transport.sendto(b"H\r")
        assert split(await second.next())[1] == b"H\r\n"
        gateway.trigger(asyncio.get_running_loop().time())
        header, sample = split(await first.next())
        assert header == CHECKED(session + b"00000003")
        assert sample.startswith(b"P0000")
        assert second.received.empty()
        first.transport.close()
        second.transport.close()


@pytest.mark.asyncio
async def test_a_gateway_that_was_reset_refuses_the_session_that_was_open() -> None:
    gateway = VirtualGateway()
    async with serve_udp(gateway) as url:
        client = await datagram_client(url)
        session = await opened(client)
    gateway.reset()
    async with serve_udp(gateway, port_of(url)):
        client.transport.sendto(session + b"00000002\rw0001000000001\r")
        assert await client.next() == session + b"00000000\r\nX0A\r\n"
        assert gateway.memory[0x10] == 0
        client.transport.close()


@pytest.mark.asyncio
async def test_datagrams_without_space_in_the_gateway_are_lost() -> None:
    gateway = SlowLine(VirtualGateway(), 1000)
    async with serve_udp(gateway) as url:
        client = await datagram_client(url)
        session = await opened(client)
        tracemalloc.start()
        try:
            for count in range(2, 2000):
                client.transport.sendto(session + b"%08X\r" % count + b"RM00FF\r" * 190)
                await asyncio.sleep(0)
            # 2.7 MB of requests were sent, whose answers have 800 MB.
            assert tracemalloc.get_traced_memory()[1] < 2_000_000
        finally:
            tracemalloc.stop()
        client.transport.close()


@pytest.mark.asyncio
async def test_a_busy_udp_port_causes_one_clear_error() -> None:
    async with serve_udp(VirtualGateway()) as url:
        with pytest.raises(ConnectError, match=rf"UDP port {port_of(url)} of .* is in use"):
            async with serve_udp(VirtualGateway(), port_of(url)):
                pass
