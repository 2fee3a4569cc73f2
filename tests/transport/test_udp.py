"""Links over datagrams that are lost, duplicated and late, by real sockets: no request has an effect twice."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import random
import socket
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from support.recorded_bus import WRITTEN, gateway_of_short_laps
from unity_link import ArgumentError, ConnectError, LinkLostError, blocking
from unity_link.errors import Outcome, UnsupportedError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import LARGEST_DATAGRAM, Framing
from unity_link.transport import open_medium, parse_url
from unity_link.transport.stream import Stream
from unity_link.transport.udp import LARGE, MOST_TOGETHER, RECEIVE_BUFFER, DatagramAdapter
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying
from unity_link.virtual.serving import serve_udp
from unity_link.virtual.udp_relay import MOST_CLIENTS, relay_udp

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

SYSTEM_LIMIT = int(Path("/proc/sys/net/core/rmem_max").read_text())
"""Bytes that the system lets wait at a socket."""


class Recording(Straying[Any]):
    """Delivers each datagram at once, and delivers all of them again after `replay`."""

    def __init__(self) -> None:
        super().__init__()
        self.passed: list[Any] = []
        """Datagrams, each with its client."""
        self._again: list[Any] = []

    def carry(self, datagram: Any) -> list[Any]:
        arriving, self._again = [datagram, *self._again], []
        self.passed.append(datagram)
        return arriving

    def replay(self) -> None:
        """Deliver all datagrams so far once more, after the next datagram."""
        self._again = list(self.passed)


def has_ipv6() -> bool:
    with socket.socket(socket.AF_INET6) as tried:
        try:
            tried.bind(("::1", 0))
        except OSError:
            return False
    return True


def port_of(url: str) -> int:
    return int(url.rpartition(":")[2])


@contextlib.asynccontextmanager
async def recorded(gateway: VirtualGateway) -> AsyncIterator[tuple[str, Recording, Recording]]:
    """Serve a gateway behind a network that can replay datagrams; yield its URL and the network of each direction."""
    towards, back = Recording(), Recording()
    async with serve_udp(gateway) as url, relay_udp(url, towards, back) as relayed:
        yield relayed, towards, back


@pytest.mark.asyncio
@pytest.mark.parametrize("seed", range(3))
async def test_requests_over_a_bad_network_are_executed_once_and_in_order(seed: int) -> None:
    gateway, bus = gateway_of_short_laps()
    chances = {"loss": 0.02, "late": 0.03, "double": 0.1}
    towards: Straying[Any] = Straying(2 * seed, latest=600, **chances)
    back: Straying[Any] = Straying(2 * seed + 1, latest=600, **chances)
    numbers = itertools.count()
    async with (
        serve_udp(gateway) as url,
        relay_udp(url, towards, back) as relayed,
        unity_link.connect(relayed, timeout=60) as link,
    ):
        for start in range(300):
            writes = [link.write(WRITTEN, next(numbers)) for _ in range(2)]
            reads = [link.read((start + place) % 256) for place in range(4)]
            answers = await asyncio.gather(*writes, *reads)
            assert answers[2:] == [(start + place) % 256 for place in range(4)]
        assert link.statistics.repetitions
    assert bus.writes == [(WRITTEN, number) for number in range(600)]


@pytest.mark.asyncio
@pytest.mark.skipif(not Path("/dev/fd").is_dir(), reason="this system does not tell what is open")
async def test_a_bad_network_closes_the_ports_of_former_clients() -> None:
    def count_open() -> int:
        return len(list(Path("/dev/fd").iterdir()))

    async with serve_udp(VirtualGateway()) as url, relay_udp(url, Straying(), Straying()) as relayed:
        before = count_open()
        for _ in range(3 * MOST_CLIENTS):
            async with unity_link.connect(relayed) as link:
                assert await link.read(0x10) == 0
        assert count_open() - before <= MOST_CLIENTS


@pytest.mark.asyncio
async def test_a_bad_network_leads_to_a_gateway_on_ipv6_too() -> None:
    if not has_ipv6():
        pytest.skip("no IPv6 on this machine")
    async with (
        serve_udp(VirtualGateway(), host="::1") as url,
        relay_udp(url, Straying(), Straying()) as relayed,
        unity_link.connect(relayed) as link,
    ):
        assert await link.read(0x10) == 0


@pytest.mark.asyncio
async def test_a_bad_network_to_an_unknown_name_causes_one_clear_error() -> None:
    with pytest.raises(ConnectError, match=r"^no socket for port 7001 of nosuch.invalid \(.*\); is the name right\?$"):
        async with relay_udp("udp://nosuch.invalid:7001", Straying(), Straying()):
            pass


def test_a_socket_that_cannot_be_connected_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[socket.socket] = []

    class Kept(socket.socket):
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            made.append(self)

    monkeypatch.setattr(socket, "socket", Kept)
    # The system refuses broadcasts from sockets without SO_BROADCAST.
    with pytest.raises(ConnectError, match=r"no socket for port 7001 of 255\.255\.255\.255 \("):
        blocking.connect("udp://255.255.255.255:7001")
    assert {opened.fileno() for opened in made} == {-1}


@pytest.mark.asyncio
async def test_replayed_requests_of_an_earlier_lap_are_not_executed() -> None:
    gateway, bus = gateway_of_short_laps()
    async with recorded(gateway) as (url, towards, _), unity_link.connect(url) as link:
        for number in range(300):
            await link.write_queue(WRITTEN, [number])
            if number % 50 == 17:
                towards.replay()
        assert await link.read(0x77) == 0x77
    assert bus.writes == [(WRITTEN, number) for number in range(300)]


@pytest.mark.asyncio
async def test_replayed_answers_of_an_earlier_lap_match_no_request() -> None:
    async with recorded(gateway_of_short_laps()[0]) as (url, _, back), unity_link.connect(url) as link:
        for number in range(600):
            address = number * 7 % 256
            if number % 50 == 17:
                back.replay()
            addresses = [address, address ^ 1, address ^ 2]
            assert await asyncio.gather(*map(link.read, addresses)) == addresses


@pytest.mark.asyncio
async def test_replayed_datagrams_of_an_earlier_session_are_dropped() -> None:
    gateway, bus = gateway_of_short_laps()
    async with recorded(gateway) as (url, towards, back):
        for session in range(3):
            async with unity_link.connect(url) as link:
                for number in range(20):
                    await link.write_queue(WRITTEN, [20 * session + number])
                    if number % 5 == 0:
                        towards.replay()
                        back.replay()
                    assert await link.read(number) == number
    assert bus.writes == [(WRITTEN, number) for number in range(60)]


async def read_all(samples: unity_link.Subscription) -> None:
    async for _ in samples:
        pass


@pytest.mark.asyncio
async def test_a_second_host_takes_the_gateway_and_the_first_link_ends() -> None:
    async with (
        serve_udp(VirtualGateway()) as url,
        unity_link.connect(url) as first,
        first.subscribe([0], rate_hz=10) as samples,
    ):
        await anext(samples)
        async with unity_link.connect(url) as second:
            # The first link is informed at once, without sending a request.
            with pytest.raises(LinkLostError, match="another program has opened a session with it"):
                await read_all(samples)
            with pytest.raises(LinkLostError):
                await first.write(1, 7)
            assert await second.read(1) == 0


@pytest.mark.asyncio
async def test_a_first_host_that_reconnects_takes_the_gateway_again() -> None:
    async with serve_udp(VirtualGateway()) as url, unity_link.connect(url, reconnect=True) as first:
        await first.write(1, 7)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as second:
            second.connect(("127.0.0.1", port_of(url)))
            second.send(b"Q\r")
            offer = await asyncio.to_thread(second.recv, 2000)
            second.send(offer[:9] + b"00000001\rK000\r")
            await asyncio.to_thread(second.recv, 2000)
        with contextlib.suppress(LinkLostError):
            await first.read(1)
        assert await first.read(1) == 7
        assert first.statistics.reconnections == 1


@pytest.mark.asyncio
async def test_a_reset_during_a_session_ends_the_link_without_a_second_execution() -> None:
    gateway, bus = gateway_of_short_laps()
    async with serve_udp(gateway) as url:
        link = await unity_link.connect(url)
        for number in range(10):
            await link.write_queue(WRITTEN, [number])
    gateway.reset()
    writing = asyncio.ensure_future(link.write_queue(WRITTEN, [10]))
    await asyncio.sleep(0)
    async with serve_udp(gateway, port_of(url)):
        with pytest.raises(LinkLostError, match="the gateway was reset") as caught:
            await writing
        assert caught.value.outcome is Outcome.UNKNOWN
        await link.aclose()
        async with unity_link.connect(url) as again:
            await again.write_queue(WRITTEN, [11])
    assert bus.writes == [(WRITTEN, number) for number in [*range(10), 11]]


@pytest.mark.asyncio
async def test_a_node_is_reached_by_its_number() -> None:
    async with (
        serve_udp(VirtualGateway(node=5), node=5) as url,
        unity_link.connect(f"{url}?node=5") as link,
    ):
        await link.write(1, 7)
        assert await link.read(1) == 7


@pytest.mark.asyncio
async def test_a_flood_of_invalid_datagrams_disturbs_no_link() -> None:
    generator = random.Random(1)
    async with serve_udp(VirtualGateway()) as url, unity_link.connect(url) as link:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            stranger.connect(("127.0.0.1", port_of(url)))
            for number in range(300):
                noise = generator.randbytes(generator.randrange(60))
                stranger.send(generator.choice([noise, b"U" + noise, b"U0000000100000001\r" + noise]))
                await link.write(1, number)
                assert await link.read(1) == number


# Gateways of other implementations


class Scripted(asyncio.DatagramProtocol):
    """Answers each datagram that a script contains, and ignores all others."""

    def __init__(self, script: dict[bytes, bytes]) -> None:
        self._script = script

    def connection_made(self, transport: Any) -> None:
        self._transport = transport

    def datagram_received(self, data: bytes, addr: Any) -> None:
        answer = next((answer for question, answer in self._script.items() if question in data), None)
        if answer is not None:
            self._transport.sendto(answer, addr)


@contextlib.asynccontextmanager
async def scripted(script: dict[bytes, bytes]) -> AsyncIterator[str]:
    loop = asyncio.get_running_loop()
    transport, _ = await loop.create_datagram_endpoint(lambda: Scripted(script), local_addr=("127.0.0.1", 0))
    yield f"udp://127.0.0.1:{transport.get_extra_info('sockname')[1]}"
    transport.close()
    await asyncio.sleep(0)


@pytest.mark.asyncio
async def test_a_session_that_another_host_opened_first_causes_one_clear_error() -> None:
    checked = Framing(Crc()).checked
    body = b"Q" + GatewayInfo().to_hex()
    script = {
        b"Q\r": b"U0000000700000000\r\n" + body + b"\r\n",
        checked(b"Q"): checked(b"U0000000700000000") + checked(body),
        checked(b"U0000000700000001"): checked(b"U0000000700000000") + checked(b"X0A"),
    }
    async with scripted(script) as url:
        with pytest.raises(ConnectError, match="another program has opened a session with it"):
            await unity_link.connect(url)


@pytest.mark.asyncio
async def test_a_gateway_of_a_version_without_headers_is_refused_by_its_version() -> None:
    async with scripted({b"Q\r": b"Q012008020800000007FF0100FF0005F5E10002FAF0800100010000FF00000000\r\n"}) as url:
        with pytest.raises(UnsupportedError, match="the gateway speaks version 01 of the protocol"):
            await unity_link.connect(url)


@pytest.mark.asyncio
async def test_the_socket_buffers_answers_to_long_blocks_as_the_system_allows() -> None:
    url = parse_url("udp://127.0.0.1:7001")
    transport = await open_medium(url, Stream())
    assert isinstance(transport, DatagramAdapter)
    assert transport._socket is not None
    # Linux doubles the size, to store its own records beside the bytes.
    room = transport._socket.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF)
    assert room == 2 * min(RECEIVE_BUFFER, SYSTEM_LIMIT)
    transport.abort()
    await asyncio.sleep(0)


@pytest.mark.asyncio
async def test_blocks_are_split_so_that_no_datagram_is_fragmented() -> None:
    gateway = VirtualGateway()
    async with recorded(gateway) as (url, towards, back), unity_link.connect(url) as link:
        assert link.gateway.block_words == 255
        await link.write_block(0, range(256))
        assert (await link.read_block(0, 256)).tolist() == [*range(256)]
        await link.write_queue(0, range(400))
    for passed in (towards, back):
        longest = max(len(datagram) for datagram, _ in passed.passed)
        assert LARGEST_DATAGRAM - 50 < longest <= LARGEST_DATAGRAM


@pytest.mark.parametrize("options", ["interface=lo", "ttl=1", "interface=lo&ttl=255"])
def test_interface_and_ttl_may_be_chosen(options: str) -> None:
    with start_blocking_portal() as portal:
        serving = portal.wrap_async_context_manager(serve_udp(VirtualGateway()))
        with serving as url, blocking.connect(f"{url}?{options}") as link:
            link.write(1, 7)
            assert link.read(1) == 7


@pytest.mark.asyncio
async def test_the_socket_has_the_interface_and_the_ttl_of_the_url() -> None:
    transport = await open_medium(parse_url("udp://127.0.0.1:7001?interface=lo&ttl=3"), Stream())
    assert isinstance(transport, DatagramAdapter)
    assert transport._socket is not None
    assert transport._socket.getsockopt(socket.IPPROTO_IP, socket.IP_TTL) == 3
    assert transport._socket.getsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, 16).rstrip(b"\0") == b"lo"
    transport.abort()
    await asyncio.sleep(0)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ("interface=eth77", ConnectError, r"there is no network interface eth77; there are .*\blo\b"),
        ("interface=", ArgumentError, "names no network interface"),
        ("ttl=0", ArgumentError, "ttl=0 in .* is not from 1 to 255"),
        ("ttl=256", ArgumentError, "ttl=256 in .* is not from 1 to 255"),
        ("ttl=far", ArgumentError, "ttl=far in .* is not a whole number"),
    ],
)
def test_an_impossible_interface_or_ttl_causes_one_clear_error(
    options: str, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        blocking.connect(f"udp://127.0.0.1:7001?{options}")


@pytest.mark.asyncio
async def test_the_error_on_a_system_without_a_choice_of_interfaces_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(socket, "SO_BINDTODEVICE")
    with pytest.raises(ConnectError, match="interface=lo works on Linux only"):
        await unity_link.connect("udp://127.0.0.1:7001?interface=lo")


class Passing:
    """Takes each datagram as frames of the session, without a header."""

    def take(self, datagram: bytes) -> bytes:
        return datagram


class Receiving(asyncio.Protocol):
    """Collects the pieces that it receives, until `size` bytes have arrived."""

    def __init__(self, size: int) -> None:
        self.pieces: list[bytes] = []
        self.whole = asyncio.Event()
        self._size = size

    def data_received(self, data: bytes) -> None:
        self.pieces.append(data)
        if sum(map(len, self.pieces)) >= self._size:
            self.whole.set()


@pytest.mark.asyncio
@pytest.mark.parametrize("size", [10, LARGE])
async def test_large_datagrams_that_arrived_are_passed_on_together_in_order(size: int) -> None:
    datagrams = [b"%0*d\n" % (size - 1, number) for number in range(3 * MOST_TOGETHER)]
    receiving = Receiving(size * len(datagrams))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as gateway:
        gateway.bind(("127.0.0.1", 0))
        transport = await open_medium(parse_url(f"udp://127.0.0.1:{gateway.getsockname()[1]}"), receiving)
        assert isinstance(transport, DatagramAdapter)
        assert transport._socket is not None
        transport._datagrams = Passing()  # type: ignore[assignment]
        for datagram in datagrams:
            gateway.sendto(datagram, transport._socket.getsockname())
        await receiving.whole.wait()
    assert b"".join(receiving.pieces) == b"".join(datagrams)
    turns = 3 if size == LARGE else len(datagrams)
    assert len(receiving.pieces) == turns
    transport.abort()
    await asyncio.sleep(0)
