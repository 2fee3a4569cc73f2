"""Several clients on one link: the guarantees that each client has, whatever other clients and lines do."""

from __future__ import annotations

import asyncio
import contextlib
import random
from itertools import pairwise
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from support.recorded_bus import RecordedBus
from support.searching import examples, seeds
from support.shared_pair import PAIR, SharedPair
from support.sharing import SEED, SEED_BACK, PipedLink, call, clients_of, open_directly, settle, sharing, until
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve, cut
from unity_link import (
    BusError,
    BusTimeoutError,
    GatewayResetError,
    LinkLostError,
    OutOfRangeError,
    Reconnect,
)
from unity_link.bridges.serve.connection import COST_ALONE, MOST_POSTED, MOST_UNDER_WAY, MOST_UNSENT
from unity_link.bridges.serve.shared import PATIENCE, SharedLink
from unity_link.protocol.window import posted_writes
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.gateway import Gateway
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link import Link
    from unity_link.protocol.wire.arrays import Words
    from unity_link.transport.stream import Stream

KILOHERTZ = 1_000_000
"""A base frequency with few ticks, so that simulated time passes quickly."""
OF_A_SESSION = [
    Codec(GatewayInfo()).request("R", 0, b"0A", SEED),
    Codec(GatewayInfo()).request("W", 0, b"0A00000001", SEED),
]
FAILING = 0x44
"""An address at which every access ends in a bus error."""


# Exactly once, in order


class Program:
    """A random program of one client, and the writes that the bus must see; the upper byte of a word is its number."""

    def __init__(self, link: Link, number: int, seed: int) -> None:
        self._link, self._number = link, number
        self._random = random.Random(seed)
        self._count = 0
        self.expected: list[tuple[int, int]] = []

    def _unique(self, address: int) -> int:
        self._count += 1
        word = self._number << 24 | self._count
        self.expected.append((address, word))
        return word

    async def run(self) -> None:
        for _ in range(12):
            calls = [self._call(self._random.randrange(6)) for _ in range(self._random.randint(1, 4))]
            await asyncio.gather(*calls)
        await self._link.fence()

    async def _call(self, kind: int) -> None:
        link, address = self._link, self._random.randrange(16)
        if kind == 0:
            await link.write(address, self._unique(address))
        elif kind == 1:
            await link.post(address, self._unique(address))
        elif kind == 2:
            await link.write_block(address, [self._unique(address + index) for index in range(5)])
        elif kind == 3:
            await link.write_masked(address, self._unique(address), 0xFFFFFFFF)
        elif kind == 4:
            await link.read_block(address, 5)
        else:
            # The requests of this batch precede those of other calls of the client.
            await link.read_many(range(40))


async def run_programs(seed: int, chances: dict[str, float], *, slow: bool) -> None:
    features = GatewayInfo().features & ~Feature.FLOW_CONTROL
    gateway = VirtualGateway(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7, features=features))
    bus = RecordedBus(gateway)
    line = SlowLine(gateway, 300_000) if slow else gateway
    noisy = NoisyLine(line, Noise(seed, **chances), Noise(seed + 1, **chances))
    async with sharing(noisy) as shared:
        links = [
            PipedLink(shared, (Noise(seed + 10 * k, **chances), Noise(seed + 11 * k, **chances))) for k in (1, 2, 3)
        ]
        async with links[0], links[1], links[2]:
            programs = [Program(link, number, seed + number) for number, link in enumerate(links, 1)]
            await asyncio.gather(*[program.run() for program in programs])
    for number, program in enumerate(programs, 1):
        assert [write for write in bus.writes if write[1] >> 24 == number] == program.expected


@pytest.mark.slow
@pytest.mark.parametrize("seed", seeds(6, 20))
@pytest.mark.parametrize("slow", [False, True], ids=["at once", "slow line"])
def test_writes_are_executed_once_and_in_order_over_bad_lines_on_both_sides(seed: int, slow: bool) -> None:
    run_simulated(run_programs(seed, {"loss": 0.002, "flip": 0.002, "double": 0.002}, slow=slow))


# Groups


@on_simulated_time
async def test_clients_that_use_one_group_number_have_separate_groups() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ))
    gateway.memory.update({1: 0x11, 2: 0x22})
    async with (
        sharing(gateway) as shared,
        PipedLink(shared) as one,
        PipedLink(shared) as two,
        one.subscribe([1], rate_hz=100) as ones,
        two.subscribe([2], rate_hz=50) as twos,
    ):
        first = [await anext(ones) for _ in range(20)]
        second = [await anext(twos) for _ in range(20)]
    assert {int(sample.values[0]) for sample in first} == {0x11}
    assert {int(sample.values[0]) for sample in second} == {0x22}
    assert [sample.sequence for sample in first] == [sample.sequence for sample in second] == list(range(20))


@on_simulated_time
async def test_groups_of_all_clients_must_fit_into_the_gateway_only_while_they_run() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=2))
    async with sharing(gateway) as shared, PipedLink(shared) as one, PipedLink(shared) as two:
        async with one.subscribe([1], rate_hz=100), one.subscribe([2], rate_hz=100):
            refused = two.subscribe([3], rate_hz=100)
            with pytest.raises(OutOfRangeError):
                await refused.__aenter__()
        async with refused as samples, two.subscribe([4], rate_hz=100):
            assert (await anext(samples)).lost == 0


@on_simulated_time
async def test_a_client_that_leaves_frees_its_groups() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=1))
    async with sharing(gateway) as shared, PipedLink(shared) as two:
        for _ in range(3):
            one = PipedLink(shared)
            async with one, one.subscribe([1], rate_hz=100) as samples:
                await anext(samples)
                cut(one)
            await settle(shared)
            assert gateway.next_due is None
            async with two.subscribe([2], rate_hz=100) as samples:
                await anext(samples)


@on_simulated_time
async def test_sequence_of_a_group_continues_after_another_client_used_its_slot() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=1))
    async with sharing(gateway) as shared:
        one, two = call(shared), call(shared)
        one.transport.write(b"GS00000001010A\rGP00\rGP00\r")
        await settle(shared)
        two.transport.write(b"GS0000000101FB\rGP00\r")
        await settle(shared)
        one.transport.write(b"GP00\r")
        await settle(shared)
        assert [frame[:5] for frame in one.take().splitlines() if frame.startswith(b"P")] == [
            b"P0000",
            b"P0001",
            b"P0002",
        ]
        assert [frame[:5] for frame in two.take().splitlines() if frame.startswith(b"P")] == [b"P0000"]


@on_simulated_time
async def test_a_new_session_of_one_client_stops_its_groups_and_no_others() -> None:
    async with (
        sharing(VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ))) as shared,
        PipedLink(shared) as link,
    ):
        terminal = call(shared)
        terminal.transport.write(b"GS00010001010A\rGN00\r")
        async with link.subscribe([1], rate_hz=1000) as samples:
            await until(lambda: terminal.heard.count(b"P00") > 10)
            terminal.transport.write(b"K0000001\r")
            await until(lambda: terminal.heard.endswith(b"K00000010000\r\n"))
            terminal.take()
            for _ in range(50):
                assert (await anext(samples)).lost == 0
            assert terminal.take() == b""


@on_simulated_time
async def test_samples_come_in_the_form_that_their_client_asked_for() -> None:
    async with sharing(VirtualGateway()) as shared:
        terminal = call(shared)
        terminal.transport.write(b"GS0920000101FF\rGP09\r")
        await settle(shared)
        assert terminal.take() == b"GS09\r\nP090000000000\r\nGP09\r\n"


# Turns


@on_simulated_time
async def test_single_read_waits_for_one_turn_of_other_clients_only() -> None:
    line = SlowLine(VirtualGateway(), 100_000)
    async with sharing(line) as shared:
        links = [PipedLink(shared) for _ in range(4)]
        async with links[0] as patient, links[1] as a, links[2] as b, links[3] as c:
            greedy = [asyncio.create_task(link.read_block(0, 255)) for link in (a, b, c) for _ in range(20)]
            await asyncio.sleep(0.1)
            loop = asyncio.get_running_loop()
            began = loop.time()
            for _ in range(5):
                await patient.read(0)
            each = (loop.time() - began) / 5
            left = sum(not task.done() for task in greedy)
            for task in greedy:
                task.cancel()
    # 60 blocks of 2 KB take 1.2 s; one turn of each of the three other clients, and the bytes ahead of them, about 10
    # KB.
    assert left > 20
    assert each < 0.12


class InOneRead(Valve):
    """Answers all requests of ten milliseconds together."""

    def __init__(self, gateway: VirtualGateway) -> None:
        super().__init__(gateway)
        self._kept = b""
        self._due: float | None = None

    @property
    def next_due(self) -> float | None:
        return self._due

    def receive(self, data: bytes, now: float) -> bytes:
        self._kept += super().receive(data, now)
        if self._due is None:
            self._due = now + 0.01
        return b""

    def advance(self, now: float, room: int | None = None) -> bytes:
        if self._due is None or now < self._due:
            return b""
        kept, self._kept, self._due = self._kept, b"", None
        return kept


@on_simulated_time
async def test_error_of_a_posted_write_precedes_the_answers_to_later_requests() -> None:
    gateway = VirtualGateway()
    RecordedBus(gateway, failing=frozenset({0x44}))
    codec = Codec(gateway.info)
    requests = [codec.request("R", 0, b"01", SEED), codec.request("WS", 1, b"4400000001", SEED)]
    requests += [codec.request("R", number, b"01", SEED) for number in range(2, 40)]
    async with sharing(InOneRead(gateway)) as shared:
        client = call(shared)
        client.transport.write(codec.framing.checked(b"K0000001"))
        await settle(shared)
        client.take()
        # Send them in two parts: the server does not take reads after a posted write as one row if all arrive together.
        client.transport.write(b"".join(requests[:2]))
        await asyncio.sleep(0.001)
        client.transport.write(b"".join(requests[2:]))
        await until(lambda: client.heard.count(b"\n") == len(requests))
        bodies = [codec.framing.open(frame, SEED_BACK) for frame in client.take().splitlines()]
    assert [body[:6] for body in bodies[:3]] == [b"r00000", b"x00104", b"r00200"]
    assert len(bodies) == 40


@contextlib.asynccontextmanager
async def busy_with_writes() -> AsyncIterator[
    tuple[RecordedBus, SharedLink, PipedLink, asyncio.Task[None], asyncio.Task[Words]]
]:
    """Share a line between a client with many writes, and a client with more reads."""
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with sharing(SlowLine(gateway, 100_000)) as shared, PipedLink(shared) as writer, PipedLink(shared) as reader:
        reads = asyncio.create_task(reader.read_many([2] * 4000))
        writes = asyncio.create_task(writer.write_many([1] * 400, range(400)))
        await asyncio.sleep(0.01)
        yield bus, shared, writer, writes, reads


@on_simulated_time
async def test_new_session_begins_after_the_writes_that_a_dead_connection_left() -> None:
    async with busy_with_writes() as (bus, shared, _, writes, reads):
        # The same program on another connection; the server has not noticed yet that the first connection is cut.
        async with PipedLink(shared) as after:
            await after.write(1, 400)
            # The session does not wait for the reads, which change nothing.
            assert not reads.done()
        await asyncio.gather(writes, reads)
    assert bus.writes == [(1, value) for value in range(401)]


@on_simulated_time
async def test_a_new_session_does_not_wait_for_a_client_that_has_left() -> None:
    async with busy_with_writes() as (bus, shared, before, writes, reads):
        async with PipedLink(shared) as after:
            last = asyncio.create_task(after.write(1, 400))
            await asyncio.sleep(0.01)
            before.client.hang_up()
            await last
        await asyncio.gather(writes, reads, return_exceptions=True)
    assert bus.writes[-1] == (1, 400)
    assert 0 < len(bus.writes) < 400


@pytest.mark.slow
@on_simulated_time
async def test_clients_with_blocks_and_clients_with_words_share_the_line_equally() -> None:
    moved = {"blocks": 0, "words": 0}

    async def move(name: str, link: Link) -> None:
        while True:
            if name == "blocks":
                await link.read_block(0, 255)
                moved[name] += 255 * 8
            else:
                await link.read_many([0] * 100)
                moved[name] += 100 * 28

    line = SlowLine(VirtualGateway(), 100_000)
    async with sharing(line) as shared, PipedLink(shared) as blocks, PipedLink(shared) as words:
        tasks = [asyncio.create_task(move("blocks", blocks)) for _ in range(8)]
        tasks += [asyncio.create_task(move("words", words)) for _ in range(8)]
        await asyncio.sleep(5)
        for task in tasks:
            task.cancel()
    # By their requests in flight, 128 words and 8 blocks, their shares would be 1 to 6.
    assert 0.4 < moved["blocks"] / moved["words"] < 2.5


# Clients that do not do as they should


@pytest.mark.slow
@on_simulated_time
async def test_client_that_does_not_read_delays_no_other_and_loses_only_samples() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=10_000_000))
    async with sharing(gateway) as shared, PipedLink(shared) as other:
        deaf = call(shared)
        deaf.transport.write(b"GS00010001010A\rGN00\r")
        await until(lambda: deaf.heard.count(b"P00") > 3)
        deaf.transport.pause_reading()
        deaf.transport.write(b"RM00FF\r" * 1000)
        async with other.subscribe([1], rate_hz=1000) as samples:
            for _ in range(3000):
                assert (await anext(samples)).lost == 0
            assert await other.read(0) == 0
        (client,) = (client for client in clients_of(shared) if client.samples_dropped)
        assert client._under_way < MOST_UNDER_WAY + 4096
        deaf.transport.resume_reading()
        await until(lambda: deaf.heard.count(b"RM00FF") == 1000)
        numbers = [int(frame[3:5], 16) for frame in deaf.take().splitlines() if frame.startswith(b"P00")]
        gaps = {(after - before) & 0xFF for before, after in pairwise(numbers)}
        assert gaps - {1}
        assert client.samples_dropped > 0


@on_simulated_time
async def test_output_queue_of_a_client_that_does_not_read_is_bounded() -> None:
    async with sharing(VirtualGateway()) as shared:
        deaf = call(shared)
        deaf.transport.pause_reading()
        for _ in range(200):
            deaf.transport.write(b"RM00FF\r" * 100)
            await asyncio.sleep(0.01)
        (client,) = clients_of(shared)
        assert client._transport is not None
        assert client._transport.get_write_buffer_size() < 2 * MOST_UNSENT + MOST_UNDER_WAY
        assert client._under_way < MOST_UNDER_WAY + 4096


@pytest.mark.parametrize("flood", [b"Q\r", b"\n", b"\x00\n", b"R0A0000\n", b"GS00000101\r", b"I00\r", b"K0000001\r"])
@on_simulated_time
async def test_a_client_that_floods_the_server_leaves_the_others_their_turns(flood: bytes) -> None:
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as other:
        noisy = call(shared)
        (client,) = clients_of(shared) - {other.client}
        noisy.transport.write(flood * 20_000)
        for _ in range(10):
            await other.read(0)
        assert len(client._rest) > len(flood) * 10_000
        await until(lambda: not client._rest)
        assert await other.read(0) == 0


@pytest.mark.parametrize("flood", [b"W0A00000001", b"WS0A00000001"])
@on_simulated_time
async def test_request_waits_for_few_requests_of_a_flooding_client(flood: bytes) -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with sharing(gateway) as shared, PipedLink(shared) as other:
        noisy = call(shared)
        noisy.transport.write(Codec(gateway.info).framing.checked(flood) * 5_000)
        for _ in range(5):
            before = len(bus.writes)
            await other.write(0xF0, 0)
            assert 0 < len(bus.writes) - before <= 3 * MOST_UNDER_WAY // COST_ALONE
        await until(lambda: len(bus.writes) == 5_005)


@on_simulated_time
async def test_posted_writes_free_their_space_when_later_reads_are_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(posted_writes, "FENCE_DELAY", 1.0)
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as link:
        for _ in range(MOST_POSTED // COST_ALONE):
            await link.post(0x0A, 1)
        await until(lambda: link.client._under_way == MOST_POSTED)
        assert (await link.read_many([0x0A] * 64)).tolist() == [1] * 64
        await settle(shared)
        assert link.client._under_way == 0


@on_simulated_time
async def test_output_to_a_client_that_does_not_read_is_bounded() -> None:
    async with sharing(VirtualGateway()) as shared:
        deaf = call(shared)
        (client,) = clients_of(shared)
        assert client._transport is not None
        deaf.transport.pause_reading()
        deaf.transport.write(b"Q\r" * 20_000)
        await asyncio.sleep(1)
        assert MOST_UNSENT < client._transport.get_write_buffer_size() < 2 * MOST_UNSENT
        deaf.transport.resume_reading()
        await until(lambda: deaf.heard.count(b"Q") == 20_000)


@settings(max_examples=examples(60))
@given(
    st.lists(
        st.one_of(
            st.binary(max_size=40),
            st.from_regex(rb"[A-Za-z]{0,2}[0-9A-Fa-f]{0,16}[\r\n]{1,2}", fullmatch=True),
            st.sampled_from([b"GS000100010101\r", b"GN00\r", b"GX00\r", b"GP00\r", b"K0000001\r", b"I01\r", b"Q\r"]),
            st.sampled_from([OF_A_SESSION[0] * 20, OF_A_SESSION[1], b"R0A\r" * 30]),
            st.sampled_from([b"RM00FF\r" * 9, b"WK00FF01\r"]),
        ),
        max_size=30,
    ),
    st.booleans(),
)
def test_any_bytes_of_a_client_leave_others_served(said: list[bytes], leaves: bool) -> None:
    @on_simulated_time
    async def speak() -> None:
        gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=2))
        async with sharing(gateway) as shared, PipedLink(shared) as other:
            wild = call(shared)
            wild.transport.write(b"K0000001\r")
            for text in said:
                wild.transport.write(text)
                await other.write(0xF0, 7)
            if leaves:
                wild.transport.abort()
            assert await other.read(0xF0) <= 0xFFFFFFFF
            assert len(await other.read_many([1] * 200)) == 200
            await settle(shared)
            assert not other.statistics.repetitions
            assert leaves or not wild.gone
            wild.transport.abort()
            await settle(shared)
            async with other.subscribe([1], rate_hz=10), other.subscribe([1], rate_hz=10):
                pass
            assert gateway.next_due is None

    speak()


@on_simulated_time
async def test_lost_requests_of_a_client_that_has_left_are_not_retransmitted() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    valve = Valve(gateway)
    async with sharing(valve) as shared, PipedLink(shared) as other:
        valve.requests_pass = False
        async with PipedLink(shared) as one:
            tasks = [asyncio.create_task(one.write(address, 1)) for address in range(3)]
            tasks.append(asyncio.create_task(one.write_many(range(200), range(1, 201))))
            await asyncio.sleep(0.005)
            cut(one)
            assert all(
                isinstance(result, LinkLostError) for result in await asyncio.gather(*tasks, return_exceptions=True)
            )
        valve.requests_pass = True
        await other.write(0xFF, 1)
    assert bus.writes == [(0xFF, 1)]


@on_simulated_time
async def test_retransmission_is_acknowledged_only_after_the_request_was_executed() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared:
        client = call(shared)
        client.transport.write(b"K0000001\r")
        await settle(shared)
        client.take()
        valve.requests_pass = False
        framing = Codec(GatewayInfo()).framing
        write, done = framing.checked(b"w0000A00000001", SEED), framing.checked(b"w000", SEED_BACK)
        client.transport.write(write)
        await asyncio.sleep(0.005)
        for _ in range(3):
            client.transport.write(write)
            await asyncio.sleep(0.005)
        # The server has sent only signs of life.
        assert client.take() == b"\n\n\n"
        valve.requests_pass = True
        await settle(shared)
        assert client.take() == done
        client.transport.write(write)
        await settle(shared)
        assert client.take() == done


# The gateway comes and goes


@on_simulated_time
async def test_a_short_absence_of_the_gateway_is_not_seen() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared, PipedLink(shared) as link:
        await link.write(1, 42)
        cut(shared)
        assert await link.read(1) == 42
        assert shared._session.epoch == 1
        assert link.statistics.reconnections == 0


@pytest.mark.parametrize("power", [True, False], ids=["cable", "power"])
def test_long_absence_causes_errors_and_clients_continue_afterwards(power: bool) -> None:
    run_simulated(be_away(power=power))


async def be_away(*, power: bool) -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ))
    bus = RecordedBus(gateway)
    valve = Valve(gateway)
    async with sharing(valve) as shared, PipedLink(shared) as link:
        async with link.subscribe([1], rate_hz=100) as samples:
            await anext(samples)
            valve.requests_pass = valve.answers_pass = False
            cut(shared)
            with pytest.raises(BusTimeoutError):
                await link.write(5, 1)
            with pytest.raises(BusTimeoutError):
                await link.read_many(range(64))
            assert shared.away
            await asyncio.sleep(10 * PATIENCE)
            with pytest.raises(BusTimeoutError):
                await link.write(5, 2)
            if not power:
                gateway.reset()
            valve.requests_pass = valve.answers_pass = True
            await until(lambda: not shared.away)
            if not power:
                with pytest.raises(GatewayResetError):
                    await link.write(5, 4)
            await link.write(5, 3)
            async with asyncio.timeout(60):
                sample = await anext(samples)
                while not (sample.lost if power else sample.epoch):
                    sample = await anext(samples)
            if power:
                # The group was due 100 times a second; the gateway's clock kept running, so that the client can count
                # the losses.
                assert sample.lost > 1000 * PATIENCE
            assert (await anext(samples)).lost == 0
        assert [word for address, word in bus.writes if address == 5] == [3]


@on_simulated_time
async def test_write_with_unknown_outcome_is_not_retransmitted() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    valve = Valve(gateway)
    async with sharing(valve) as shared, PipedLink(shared) as link:
        valve.answers_pass = False
        tasks = [asyncio.create_task(link.write(address, 9)) for address in range(5)]
        tasks += [asyncio.create_task(link.write_many(range(10, 30), range(10, 30)))]
        await asyncio.sleep(0.003)
        cut(shared)
        valve.answers_pass = True
        results = await asyncio.gather(*tasks, return_exceptions=True)
        assert {type(result) for result in results} == {BusTimeoutError}
        await link.write(0xF0, 1)
    assert len(bus.writes) == len(set(bus.writes))


@on_simulated_time
async def test_a_link_that_is_opened_while_the_gateway_is_away_waits_for_it() -> None:
    valve = Valve(VirtualGateway())
    valve.requests_pass = False
    shared = SharedLink(valve, lambda _: None)
    shared.open_when_there()
    link = PipedLink(shared, reconnect=Reconnect())
    opening = asyncio.create_task(link.open(3600))
    await asyncio.sleep(30)
    assert not opening.done()
    valve.requests_pass = True
    await opening
    assert await link.read(0) == 0
    await link.aclose()
    await shared.finish()


@on_simulated_time
async def test_a_server_can_be_ended_at_the_moment_at_which_the_gateway_goes(monkeypatch: pytest.MonkeyPatch) -> None:
    valve = Valve(VirtualGateway())
    valve.answers_pass = False
    streams: list[Stream] = []

    async def connecting(gateway: Valve, stream: Stream) -> asyncio.Transport:
        streams.append(stream)
        return await open_directly(gateway, stream)

    monkeypatch.setattr(Gateway, "open", connecting)
    shared = SharedLink(valve, lambda _: None)
    shared.open_when_there()
    await asyncio.sleep(0.05)
    streams[0].connection_lost(ConnectionResetError())
    await asyncio.wait_for(shared.finish(), 60)


@on_simulated_time
async def test_group_is_restored_before_requests_made_in_a_short_absence() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ))
    async with sharing(gateway) as shared:
        client = call(shared)
        client.transport.write(b"GS00010001010A\rGN00\r")
        await settle(shared)
        cut(shared)
        client.take()
        client.transport.write(b"GX00\rGN00\r")
        await until(lambda: client.heard.count(b"P00") > 10)
        answers = [frame for frame in client.take().splitlines() if not frame.startswith(b"P")]
        assert answers == [b"GX00", b"GN00"]


@on_simulated_time
async def test_an_answer_of_the_server_itself_waits_for_posted_writes_before_it() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared:
        client = call(shared)
        valve.requests_pass = False
        client.transport.write(b"K0000001\rws0000A00000001\rgs00103000001010B\rgx00203\rh005\r")
        await asyncio.sleep(0.01)
        # Any further answer would confirm the posted write.
        assert client.take() == b"K00000010000\r\n"
        valve.requests_pass = True
        await settle(shared)
        assert client.take() == b"gs001\r\ngx002\r\nn003\r\n"
        assert valve.memory[0x0A] == 1


@on_simulated_time
async def test_posted_writes_are_refused_in_order_while_the_gateway_is_away() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared:
        client = call(shared)
        client.transport.write(b"K0000001\rH\r")
        await settle(shared)
        client.take()
        valve.requests_pass = False
        cut(shared)
        await asyncio.sleep(0.01)
        client.transport.write(b"w0000A00000001\rws0010A00000002\rh002\rws0030A00000003\rr0040A\r")
        await asyncio.sleep(PATIENCE + 1)
        assert client.take() == b"x00005\r\nx00105\r\nx00205\r\nx00305\r\nx00405\r\n"


@on_simulated_time
async def test_lost_posted_write_is_reported_before_the_answers_to_later_requests() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared:
        client = call(shared)
        client.transport.write(b"K0000001\rH\r")
        await settle(shared)
        client.take()
        valve.answers_pass = False
        client.transport.write(b"r0000A\rws0010A00000002\rh002\r")
        await asyncio.sleep(0.001)
        cut(shared)
        valve.answers_pass = True
        await until(lambda: client.heard.count(b"\n") == 3)
        assert client.take() == b"r00000000002\r\nx00105\r\nh002001\r\n"


# A shared pair of wires


@on_simulated_time
async def test_half_duplex_server_sends_no_request_before_the_pending_answer() -> None:
    gateway = VirtualGateway(PAIR)
    bus = RecordedBus(gateway, failing=frozenset({FAILING}))
    pair = SharedPair(gateway)
    async with sharing(pair) as shared, PipedLink(shared) as link, PipedLink(shared) as other:
        await asyncio.gather(
            *[link.post(1, value) for value in range(40)],
            link.post_many([2] * 40, range(40)),
            *[other.write(3, value) for value in range(40)],
            *[link.read(1) for _ in range(40)],
        )
        await link.post(FAILING, 1)
        await other.post(4, 1)
        with pytest.raises(BusError):
            await link.fence()
        assert await link.read(4) == 1
        await other.fence()
    assert pair.collisions == []
    for address in (1, 2, 3):
        assert [value for where, value in bus.writes if where == address] == list(range(40))


@on_simulated_time
async def test_typed_posted_write_to_a_half_duplex_gateway_gets_no_answer() -> None:
    gateway = VirtualGateway(PAIR)
    RecordedBus(gateway, failing=frozenset({FAILING}))
    async with sharing(SharedPair(gateway)) as shared:
        terminal = call(shared)
        terminal.transport.write(b"WS0100000007\rR01\rWS4400000007\r")
        await settle(shared)
        assert terminal.take() == b"R0100000007\r\nX04\r\n"
