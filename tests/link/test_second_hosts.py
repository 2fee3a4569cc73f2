"""Another host on the same line: the link that loses its session ends, and every outcome that it reported is true."""

from __future__ import annotations

import asyncio

import pytest

import unity_link
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from support.valve import Valve, cut
from unity_link import ConnectError, LinkLostError
from unity_link.protocol.wire.crc import Crc
from unity_link.transport import DriverUrl, register
from unity_link.virtual import VirtualGateway
from unity_link.virtual.shared_line import build_shared_line

PROGRAM = b"K0004321" + Crc().text(b"K0004321") + b"\n"
PERSON = b"K0004321\r"
BOOT = b"U-Boot 2024.01\r\nKernel 5\r\n\x00\xffW0\rready\n"


class Shared(Valve):
    """Another host sends `said` before a request of the link, and the link receives the answer too."""

    said = b""
    requests_before = 0

    def receive(self, data: bytes, now: float) -> bytes:
        answer = b""
        if self.said and b"w" in data:
            place = 0
            for _ in range(self.requests_before):
                place = data.find(b"\n", place) + 1 or len(data)
            answer = super().receive(data[:place], now) + super().receive(self.said, now)
            self.said, data = b"", data[place:]
        return answer + super().receive(data, now)


async def write_all(link: unity_link.Link, first: int, count: int) -> list[int | BaseException]:
    """Write numbers concurrently; return the acknowledged ones, and the errors of the others."""

    async def write(number: int) -> int:
        await link.write(number & 0xFF, number)
        return number

    return await asyncio.gather(*(write(first + place) for place in range(count)), return_exceptions=True)


@pytest.mark.parametrize("requests_before", [0, 1, 7, 30])
@pytest.mark.parametrize("opening", [PROGRAM, PERSON], ids=["program", "person"])
@on_simulated_time
async def test_a_link_that_loses_its_session_reports_only_true_outcomes(opening: bytes, requests_before: int) -> None:
    bus = RecordedBus(gateway := VirtualGateway())
    line = Shared(gateway)
    async with unity_link.connect(line) as link:
        done = await write_all(link, 1, 10)
        line.said, line.requests_before = opening, requests_before
        began = asyncio.get_running_loop().time()
        done += await write_all(link, 11, 30)
        done += await write_all(link, 41, 1)
        assert asyncio.get_running_loop().time() - began < 1
        with pytest.raises(LinkLostError, match="unity-link serve"):
            await link.read(0)
    errors = [error for error in done if isinstance(error, BaseException)]
    assert errors
    assert all("unity-link serve" in str(error) for error in errors)
    executed = [word for _, word in bus.writes]
    assert executed == list(range(1, len(executed) + 1))
    assert {number for number in done if isinstance(number, int)} <= set(executed)


@pytest.mark.parametrize("requests_before", [0, 1, 7])
@on_simulated_time
async def test_output_of_a_boot_loader_costs_at_most_retransmissions(requests_before: int) -> None:
    bus = RecordedBus(gateway := VirtualGateway())
    line = Shared(gateway)
    async with unity_link.connect(line) as link:
        line.said, line.requests_before = BOOT, requests_before
        assert await write_all(link, 1, 30) == list(range(1, 31))
        assert await link.read(5) == 5
    assert [word for _, word in bus.writes] == list(range(1, 31))


@pytest.mark.parametrize("opening", [PROGRAM, PERSON], ids=["program", "person"])
@on_simulated_time
async def test_a_link_that_loses_its_session_on_a_line_of_nodes_reports_it(opening: bytes) -> None:
    line = build_shared_line([1, 2])
    gateway = line.gateways[2]
    assert isinstance(gateway, VirtualGateway)
    bus = RecordedBus(gateway)
    async with unity_link.connect(line.at(1)) as other, unity_link.connect(line.at(2)) as link:
        await write_all(link, 1, 10)
        gateway.receive(of_node_2(opening), asyncio.get_running_loop().time())
        began = asyncio.get_running_loop().time()
        done = await write_all(link, 11, 5)
        assert asyncio.get_running_loop().time() - began < 2
        assert all("unity-link serve" in str(error) for error in done)
        await other.write(0x10, 1)
        assert await other.read(0x10) == 1
    assert [word for _, word in bus.writes] == list(range(1, 11))
    assert line.collisions == []


def of_node_2(frame: bytes) -> bytes:
    if frame.endswith(b"\r"):
        return b"Z02" + frame
    body = b"Z02" + frame[:-5]
    return body + Crc().text(body) + b"\n"


class Taken(Valve):
    """Another program opens a session once, just before a group is set up."""

    begins = False

    def receive(self, data: bytes, now: float) -> bytes:
        if self.begins and b"gs" in data:
            self.begins = False
            return super().receive(PROGRAM, now) + super().receive(data, now)
        return super().receive(data, now)


@on_simulated_time
async def test_a_link_that_loses_its_session_while_reconnecting_stays_closed() -> None:
    line = Taken(VirtualGateway())
    async with unity_link.connect(line, reconnect=True) as link, link.subscribe([0x10], rate_hz=100) as samples:
        await anext(samples)
        line.begins = True
        cut(link)
        with pytest.raises(LinkLostError, match="unity-link serve"):
            async for _ in samples:
                pass
        assert not link.connected
        line.heard = b""
        await asyncio.sleep(30)
        assert line.heard == b""
        with pytest.raises(LinkLostError, match="unity-link serve"):
            await link.read(0)


class Echoing(Valve):
    """An adapter that echoes the bytes that it sends."""

    def receive(self, data: bytes, now: float) -> bytes:
        return data + super().receive(data, now)


@on_simulated_time
async def test_echoes_are_ignored_and_a_read_returns_the_word_of_the_gateway() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(Echoing(gateway)) as link:
        await link.write(0x10, 0x1234)
        assert await link.read(0x10) == 0x1234
        assert (await link.read_many([0x10] * 300)).tolist() == [0x1234] * 300
        await link.post(0x11, 7)
        await link.fence()
        assert gateway.memory[0x11] == 7


class LateBoard(Echoing):
    """An adapter that echoes, with a board that is switched on one second later."""

    def receive(self, data: bytes, now: float) -> bytes:
        return super().receive(data, now) if now > 1 else data


class LateBoardDriver:
    OPTIONS: frozenset[str] = frozenset()

    async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
        return await LateBoard(VirtualGateway()).open(protocol)


@on_simulated_time
async def test_an_echo_named_in_the_url_is_ignored_until_the_gateway_answers() -> None:
    register("late-board", LateBoardDriver())
    with pytest.raises(ConnectError, match="what is sent comes back as it is"):
        await unity_link.connect("late-board:?echo=0")
    async with unity_link.connect("late-board:?echo=1") as link:
        await link.write(0x10, 0x1234)
        assert await link.read(0x10) == 0x1234
