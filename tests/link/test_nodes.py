"""Several nodes on one line, a link for each: no request is sent while an answer of any node is outstanding."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import random
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from unity_link import BusError, ConnectError, LinkLostError, Reconnect, UnsupportedError
from unity_link.protocol.window.constants import ANSWER_PATIENCE
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import compiled_node
from unity_link.virtual.rtl import RtlGateway, configurations
from unity_link.virtual.shared_line import SharedLine, build_shared_line

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link import Link

NODES = (1, 2, 5, 0xFE)
FAILING = 0x44


def buses(line: SharedLine) -> dict[int, RecordedBus]:
    return {
        node: RecordedBus(gateway, failing=frozenset({FAILING}))
        for node, gateway in line.gateways.items()
        if isinstance(gateway, VirtualGateway | RtlGateway)
    }


async def work(link: Link, values: range = range(12)) -> None:
    """Make calls of every kind concurrently."""
    await asyncio.gather(
        *[link.write(1, value) for value in values],
        *[link.post(2, value) for value in values],
        link.write_many([3] * len(values), values),
        link.write_block(0x10, values),
        link.read_many([1] * 12),
    )
    assert list(await link.read_block(0x10, len(values))) == list(values)
    with pytest.raises(BusError):
        await link.read(FAILING)
    async with link.subscribe([0x10, 0x11]) as samples:
        for number in (7, 8):
            await link.write(0x11, number)
            await samples.publish()
            assert (await anext(samples)).values[1] == number
    await link.fence()


def in_order(bus: RecordedBus, values: range = range(12)) -> bool:
    return all([value for where, value in bus.writes if where == address] == list(values) for address in (1, 2, 3))


def models() -> SharedLine:
    return build_shared_line(NODES, delay=0.002)


def compiled() -> SharedLine:
    return build_shared_line(NODES, delay=0.002, info=configurations()["default"].info, build=compiled_node)


@pytest.mark.parametrize("build", [models, pytest.param(compiled, marks=[pytest.mark.campaign, pytest.mark.rtl])])
@on_simulated_time
async def test_four_links_share_a_line_without_sending_during_an_answer(
    build: Callable[[], SharedLine],
) -> None:
    line = build()
    seen = buses(line)
    async with asyncio.TaskGroup() as tasks:

        async def one(node: int) -> None:
            async with unity_link.connect(line.at(node)) as link:
                await work(link)
                assert (link.statistics.repetitions, link.statistics.stray_frames) == (0, 0)

        for node in NODES:
            tasks.create_task(one(node))
    assert line.collisions == []
    assert all(in_order(bus) for bus in seen.values())


def test_simultaneous_transmissions_are_detected() -> None:
    line = build_shared_line(NODES)
    assert line.receive(b"Z01Q\rZ02Q\r", 0.0) == b""
    assert set(line.advance(1.0)) == {0xFF}
    assert line.collisions == ["node 2 sends while node 1 does"]
    line.receive(b"Z01Q\r", 2.0)
    line.receive(b"\n", 2.002)
    assert line.collisions[1:] == ["the host sends while node 1 does"]


def test_a_host_that_does_not_wait_for_a_slow_answer_is_detected() -> None:
    line = build_shared_line(NODES, delay=0.01)
    line.receive(b"Z01Q\r", 0.0)
    line.advance(0.005)
    line.receive(b"Z02Q\r", 0.005)
    assert line.collisions == ["the host sends while node 1 does"]


@pytest.mark.slow
@on_simulated_time
async def test_a_missing_node_delays_the_others_by_a_bounded_time() -> None:
    line = build_shared_line(NODES, baud=1_000_000)
    clock = asyncio.get_running_loop().time
    async with unity_link.connect(line.at(1)) as gone, unity_link.connect(line.at(2)) as other:
        line.gone.add(1)
        lost = asyncio.ensure_future(gone.read(0))
        waits = []
        while not lost.done():
            began = clock()
            await other.read(0)
            waits.append(clock() - began)
            await asyncio.sleep(0.001)
        with pytest.raises(LinkLostError):
            await lost
        assert max(waits) < ANSWER_PATIENCE + 0.02
        # The busy link spends a try now and then on the missing node; the other link has the line nearly all the time.
        assert sum(wait > 0.01 for wait in waits) <= 8
    assert line.collisions == []


@on_simulated_time
async def test_opening_a_link_to_a_missing_node_does_not_delay_the_others() -> None:
    line = build_shared_line(NODES)
    line.gone.add(5)
    clock = asyncio.get_running_loop().time
    async with unity_link.connect(line.at(1)) as link:
        opening = asyncio.ensure_future(unity_link.connect(line.at(5), timeout=5).__aenter__())
        waits = []
        while not opening.done():
            began = clock()
            await link.read(0)
            waits.append(clock() - began)
        with pytest.raises(ConnectError, match="nothing arrived"):
            await opening
        assert max(waits) < ANSWER_PATIENCE + 256 * 10 / 115_200 + 0.02
        assert len(waits) > 1000
    assert line.collisions == []


@on_simulated_time
async def test_a_turn_ends_with_its_answer() -> None:
    line = build_shared_line(NODES)
    clock = asyncio.get_running_loop().time
    async with unity_link.connect(line.at(1)) as one, unity_link.connect(line.at(2)) as other:
        await asyncio.sleep(1)
        times = [clock()]
        for link in (one, other):
            await link.read(0)
            times.append(clock())
        first, second = (after - before for before, after in itertools.pairwise(times))
        assert second < 1.1 * first


@on_simulated_time
async def test_a_busy_node_does_not_starve_another() -> None:
    line = build_shared_line(NODES)
    async with unity_link.connect(line.at(1)) as busy, unity_link.connect(line.at(2)) as other:
        batch = asyncio.ensure_future(busy.read_many([0] * 500))
        for _ in range(100):
            await other.read(0)
        # The links take turns, with one request each.
        assert 95 <= busy.statistics.responses <= 110
        await batch


@on_simulated_time
async def test_a_reset_of_one_node_does_not_affect_the_others() -> None:
    line = build_shared_line(NODES)
    seen = buses(line)
    async with (
        unity_link.connect(line.at(1), reconnect=True) as reset,
        unity_link.connect(line.at(2)) as other,
        reset.subscribe([0x10]) as samples,
    ):
        working = asyncio.ensure_future(work(other))
        for _ in range(3):
            await asyncio.sleep(0.05)
            gateway = line.gateways[1]
            assert isinstance(gateway, VirtualGateway)
            gateway.reset()
            await reset.read(1)
            await samples.publish()
            await anext(samples)
        await working
        assert other.statistics.repetitions == 0
    assert line.collisions == []
    assert in_order(seen[2])


@on_simulated_time
async def test_a_link_closed_in_its_turn_frees_the_line_when_it_is_quiet() -> None:
    line = build_shared_line(NODES, delay=0.01)
    async with unity_link.connect(line.at(2)) as other:
        for pause in (0.0, 0.001, 0.002, 0.005, 0.011, 0.013):
            async with unity_link.connect(line.at(1)) as link:
                reading = asyncio.ensure_future(link.read(0))
                await asyncio.sleep(pause)
                reading.cancel()
                await other.read(0)
                await link.read(0)
                reading = asyncio.ensure_future(link.read(0))
                await asyncio.sleep(pause)
            await other.read(0)
            assert isinstance((await asyncio.gather(reading, return_exceptions=True))[0], (int, Exception))
    assert line.collisions == []


@on_simulated_time
async def test_a_node_has_one_link() -> None:
    line = build_shared_line(NODES)
    async with unity_link.connect(line.at(1)) as link:
        with pytest.raises(ConnectError, match=r"has a link to node 1 of .* already"):
            await unity_link.connect(line.at(1)).__aenter__()
        await link.read(0)
    async with unity_link.connect(line.at(1)) as link:
        await link.read(0)


@on_simulated_time
async def test_the_only_link_of_a_line_is_opened_again() -> None:
    line = build_shared_line(NODES)
    async with unity_link.connect(line.at(1), reconnect=Reconnect(first_pause=0.1)) as link:
        await link.write(1, 7)
        line.gone.add(1)
        lost = asyncio.ensure_future(link.read(1))
        await asyncio.sleep(30)
        assert not link.connected
        line.gone.discard(1)
        with contextlib.suppress(LinkLostError):
            await lost
        assert await link.read(1) == 7
        assert link.statistics.reconnections == 1


@pytest.mark.parametrize("pause", [0.001, 0.005, 0.011, 0.012])
@on_simulated_time
async def test_a_link_sends_only_when_the_line_of_a_closed_link_is_quiet(pause: float) -> None:
    line = build_shared_line(NODES, delay=0.01)
    async with unity_link.connect(line.at(1)) as link:
        reading = asyncio.ensure_future(link.read(0))
        await asyncio.sleep(pause)
    assert isinstance((await asyncio.gather(reading, return_exceptions=True))[0], int | LinkLostError)
    async with unity_link.connect(line.at(2)) as other:
        await other.read(0)
    assert line.collisions == []


@on_simulated_time
async def test_a_node_that_sends_by_itself_cannot_share_its_line() -> None:
    line = SharedLine({1: build_shared_line([1]).gateways[1], 2: VirtualGateway(node=2)})
    async with unity_link.connect(line.at(1)):
        with pytest.raises(UnsupportedError, match="was not built half-duplex"):
            await unity_link.connect(line.at(2)).__aenter__()
    async with unity_link.connect(line.at(2)) as alone:
        with pytest.raises(ConnectError, match="was not built half-duplex"):
            await unity_link.connect(line.at(1)).__aenter__()
        assert list(await alone.read_many([0] * 100)) == [0] * 100


class _BadLine(SharedLine):
    """Damages characters of both directions, but turns none into a line end, which would make a second frame."""

    def __init__(self, line: SharedLine, chance: float, seed: int) -> None:
        super().__init__(line.gateways)
        self.chance, self.random = 0.0, random.Random(seed)
        self.intended = chance

    def receive(self, data: bytes, now: float) -> bytes:
        return super().receive(self._damage(data), now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        return self._damage(super().advance(now, room))

    def _damage(self, data: bytes) -> bytes:
        return bytes(ord("?") if self.random.random() < self.chance and byte not in b"\r\n" else byte for byte in data)


@pytest.mark.slow
@given(st.integers(0, 2**32), st.sampled_from([0.0005, 0.003]), st.lists(st.sampled_from(NODES), max_size=4))
@on_simulated_time
async def test_requests_on_a_bad_line_are_executed_once_and_in_order(seed: int, chance: float, gone: list[int]) -> None:
    line = _BadLine(build_shared_line(NODES), chance, seed)
    seen = buses(line)
    rng = random.Random(seed)
    async with asyncio.TaskGroup() as tasks:

        async def one(node: int) -> None:
            async with unity_link.connect(line.at(node), reconnect=Reconnect(), timeout=60) as link:
                line.chance = line.intended
                for value in range(12):
                    await asyncio.sleep(rng.random() * 0.01)
                    await asyncio.gather(link.write(1, value), link.post(2, value), link.write_many([3], [value]))
                await link.read_block(0, 20)
                await link.fence()

        async def power(node: int) -> None:
            # The node is away for less than a link waits in silence; a longer absence would end links.
            await asyncio.sleep(rng.random())
            line.gone.add(node)
            await asyncio.sleep(rng.random())
            line.gone.discard(node)

        for node in NODES:
            tasks.create_task(one(node))
        for node in set(gone):
            tasks.create_task(power(node))
    assert line.collisions == []
    assert all(in_order(bus) for bus in seen.values())
