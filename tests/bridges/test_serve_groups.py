"""Groups of several clients on one gateway: each client gets its own samples, also after the gateway was lost."""

from __future__ import annotations

import asyncio
import logging
import random
import re
from typing import TYPE_CHECKING

import pytest

from support.searching import seeds
from support.sharing import PipedLink, Terminal, call, settle, sharing, until
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve, cut
from unity_link import LinkLostError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

KILOHERTZ = 1_000_000
"""A base frequency with few ticks, so that simulated time passes quickly."""


def gateway_of(groups: int) -> VirtualGateway:
    """Return a gateway on which each word equals its address."""
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=groups))
    gateway.memory.update({address: address for address in range(256)})
    return gateway


def drop(shared: SharedLink) -> None:
    """End the server's connection to the gateway."""
    cut(shared)


async def come_back(shared: SharedLink) -> None:
    """End the server's connection; wait until the next connection is open, on which the server restores the groups."""
    drop(shared)
    await until(lambda: not shared.connected)
    await until(lambda: shared.connected)


class Asker:
    """A client that makes one request after another, and checks each sample against the last answers.

    Args:
        shared: the shared link.
        addresses: the addresses that only this client samples.
    """

    def __init__(self, shared: SharedLink, addresses: range) -> None:
        self.terminal: Terminal = call(shared)
        self.samples = 0
        self._addresses = addresses
        self._set: dict[int, int] = {}
        """The address of each group, as last confirmed."""
        self._asked: dict[int, int] = {}
        """The address of each group, as last requested."""
        self._last: dict[int, int] = {}

    async def ask(self, command: str, group: int, address: int | None = None) -> str:
        """Send a command; return the answer."""
        fields = "" if address is None else f"01000A01{address:02X}"
        if address is not None:
            self._asked[group] = address
        self.terminal.transport.write(f"{command}{group:02X}{fields}\r".encode())
        while True:
            await until(lambda: b"\n" in self.terminal.heard or self.terminal.gone)
            answer = self._take_samples()
            if answer or self.terminal.gone:
                break
        if answer.startswith("GS"):
            self._set[group] = self._asked[group]
            self._last.pop(group, None)
        return answer

    def _take_samples(self) -> str:
        """Check the samples before the next answer; return the answer."""
        while b"\n" in self.terminal.heard:
            line, _, self.terminal.heard = self.terminal.heard.partition(b"\n")
            text = line.decode().rstrip("\r")
            if not text.startswith("P"):
                return text
            group, number, word = int(text[1:3], 16), int(text[3:5], 16), int(text[5:13], 16)
            assert word in {self._set.get(group), self._asked.get(group)}
            assert group not in self._last or 0 < (number - self._last[group]) & 0xFF < 250
            self._last[group] = number
            self.samples += 1
        return ""

    async def wander(self, seed: int, times: int) -> None:
        """Configure, start, stop and publish groups at random."""
        choices = random.Random(seed)
        for _ in range(times):
            group, command = choices.randrange(3), choices.choice(["GS", "GS", "GN", "GN", "GX", "GP"])
            await self.ask(command, group, choices.choice(self._addresses) if command == "GS" else None)
            await asyncio.sleep(choices.choice([0, 0, 0.003, 0.02]))
        await asyncio.sleep(0.05)
        self._take_samples()


async def wander_and_lose(seed: int) -> None:
    choices = random.Random(seed)
    gateway = gateway_of(4)
    async with sharing(SlowLine(gateway, choices.choice([20_000, 200_000]))) as shared:
        for episode in range(4):
            askers = [Asker(shared, range(0x10 * number, 0x10 * number + 8)) for number in range(1, 4)]
            tasks = [asyncio.create_task(asker.wander(seed * 7 + episode, 25)) for asker in askers]
            for _ in range(3):
                await asyncio.sleep(choices.uniform(0, 0.15))
                if shared.connected:
                    drop(shared)
                if choices.random() < 0.5:
                    gateway.reset()
                if choices.random() < 0.3:
                    await asyncio.sleep(choices.uniform(0, 0.2))
                    choices.choice(askers).terminal.transport.abort()
            await asyncio.gather(*tasks)
            for asker in askers:
                asker.terminal.transport.abort()
        assert not shared.ended.done()
        await until(lambda: shared.connected and not shared.away)
        await settle(shared)
        assert not shared.slots.held
        assert gateway.next_due is None


@pytest.mark.slow
@pytest.mark.parametrize("seed", seeds(12, 40))
def test_clients_get_their_own_samples_once_while_gateway_and_clients_vanish(seed: int) -> None:
    run_simulated(wander_and_lose(seed))


@pytest.mark.slow
@pytest.mark.parametrize("when", [step / 1000 for step in range(0, 60, 3)])
@pytest.mark.parametrize("what", ["leaves", "begins a session", "stops one group and sets up another"])
def test_client_requests_during_restoration_of_groups_disturb_no_other(what: str, when: float) -> None:
    @on_simulated_time
    async def act() -> None:
        gateway = gateway_of(8)
        async with sharing(SlowLine(gateway, 10_000)) as shared, PipedLink(shared) as other:
            busy = call(shared)
            busy.transport.write(b"".join(b"GS%02X01000A0120\rGN%02X\r" % (group, group) for group in range(6)))
            async with other.subscribe([0x33], rate_hz=100) as samples:
                await anext(samples)
                await settle(shared)
                await come_back(shared)
                await asyncio.sleep(when)
                if what == "leaves":
                    busy.transport.abort()
                elif what == "begins a session":
                    busy.transport.write(b"K0000001\r")
                else:
                    busy.transport.write(b"GX00\rGX05\rGS0601000A0121\rGN06\r")
                for _ in range(40):
                    assert (await anext(samples)).values.tolist() == [0x33]
                await settle(shared)
                busy.take()
                busy.transport.write(b"GX00\r")
                await asyncio.sleep(0.1)
                words = {frame[:3] + frame[5:13] for frame in busy.take().splitlines() if frame.startswith(b"P")}
                running = {b"P%02X00000020" % group for group in range(1, 5)} | {b"P0600000021"}
                assert words == (running if what.startswith("stops") else set())
            assert not shared.ended.done()

    act()


class HoldingBack(Valve):
    """A gateway that sends samples as late as it may: just before the next answer that no earlier sample may follow."""

    held = b""

    def receive(self, data: bytes, now: float) -> bytes:
        self.held += self.gateway.advance(now)
        answers = b""
        for frame in super().receive(data, now).splitlines(keepends=True):
            if frame.startswith(b"P"):
                self.held += frame
                continue
            if frame.startswith((b"gx", b"gs", b"gn", b"gp", b"K")):
                answers, self.held = answers + self.held, b""
            answers += frame
        return answers

    def advance(self, now: float, room: int | None = None) -> bytes:
        self.held += super().advance(now, room)
        return b""


@on_simulated_time
async def test_late_samples_of_a_reassigned_group_reach_only_their_own_client() -> None:
    async with sharing(HoldingBack(gateway_of(1))) as shared:
        one, two = call(shared), call(shared)
        for _ in range(3):
            one.transport.write(b"GS0001000A0110\rGN00\r")
            await asyncio.sleep(0.1)
            one.transport.write(b"GX00\rGP00\r")
            await settle(shared)
            two.transport.write(b"GS0000000A0120\rGP00\rGX00\r")
            await settle(shared)
        assert {frame[5:13] for frame in one.take().splitlines() if frame.startswith(b"P")} == {b"00000010"}
        assert {frame[5:13] for frame in two.take().splitlines() if frame.startswith(b"P")} == {b"00000020"}


@on_simulated_time
async def test_no_earlier_sample_follows_the_answer_that_begins_a_session() -> None:
    async with sharing(HoldingBack(gateway_of(2))) as shared:
        client, other = call(shared), call(shared)
        client.transport.write(b"GS0000000A0110\rGP00\r")
        await settle(shared)
        client.transport.write(b"K0000001\r")
        other.transport.write(b"GS0000000A0111\rGP00\r")
        await settle(shared)
        assert client.take().endswith(b"K00000010000\r\n")


@on_simulated_time
async def test_group_is_freed_if_its_client_leaves_before_its_requests_are_sent() -> None:
    valve = Valve(gateway_of(1))
    async with sharing(valve) as shared, PipedLink(shared) as other:
        valve.requests_pass = False
        async with PipedLink(shared) as one:
            starting = asyncio.create_task(one.subscribe([0x10], rate_hz=100).__aenter__())
            await asyncio.sleep(0.005)
            cut(one)
            with pytest.raises(LinkLostError):
                await starting
        valve.requests_pass = True
        await settle(shared)
        async with other.subscribe([0x20], rate_hz=100) as samples:
            assert (await anext(samples)).values.tolist() == [0x20]


class LosingAnswers(Valve):
    """Loses the first answer to each of the given commands.

    Args:
        gateway: the gateway at the end of the line.
        commands: in lower case.
    """

    def __init__(self, gateway: VirtualGateway, *commands: bytes) -> None:
        super().__init__(gateway)
        self._commands = {*commands}

    def receive(self, data: bytes, now: float) -> bytes:
        frames = super().receive(data, now).splitlines(keepends=True)
        lost = [frame for frame in frames if frame[:2] in self._commands]
        self._commands -= {frame[:2] for frame in lost}
        return b"".join(frame for frame in frames if frame not in lost)


@pytest.mark.parametrize(
    ("asked", "lost", "runs"),
    [(b"GN00\r", b"gs", True), (b"GN00\rGX00\r", b"gn", False), (b"GN00\rGX00\rGS0001000A0111\rGN00\r", b"gx", True)],
)
@on_simulated_time
async def test_group_runs_as_its_client_last_asked_if_an_earlier_answer_was_lost(
    asked: bytes, lost: bytes, *, runs: bool
) -> None:
    async with sharing(LosingAnswers(gateway_of(1), lost)) as shared:
        client, other = call(shared), call(shared)
        client.transport.write(b"GS0001000A0110\r" + asked)
        await settle(shared)
        other.transport.write(b"GS0001000A0120\rGN00\r")
        await settle(shared)
        assert other.take().split()[1] == (b"X06" if runs else b"GN00")
        client.take()
        await asyncio.sleep(0.1)
        assert (b"P00" in client.take()) == runs
        assert (b"P00" in other.take()) != runs


@on_simulated_time
async def test_group_started_during_a_short_absence_of_the_gateway_begins_once() -> None:
    async with sharing(SlowLine(gateway_of(1), 10_000)) as shared:
        client = call(shared)
        drop(shared)
        client.transport.write(b"GS0001000A0110\rGN00\r")
        await until(lambda: client.heard.count(b"P00") > 10)
        numbers = [int(frame[3:5], 16) for frame in client.take().splitlines() if frame.startswith(b"P")]
        assert numbers == list(range(len(numbers)))


@on_simulated_time
async def test_stopped_group_misses_no_samples_during_an_absence() -> None:
    async with sharing(SlowLine(gateway_of(1), 10_000)) as shared:
        client = call(shared)
        client.transport.write(b"GS0001000A0110\rGP00\r")
        await settle(shared)
        drop(shared)
        client.transport.write(b"GP00\r")
        await until(lambda: client.heard.count(b"GP00") == 2)
        assert [frame[3:5] for frame in client.take().splitlines() if frame.startswith(b"P")] == [b"00", b"01"]


@on_simulated_time
async def test_missed_samples_are_counted_once_if_a_restoration_is_interrupted() -> None:
    async with sharing(SlowLine(gateway_of(8), 10_000)) as shared:
        client = call(shared)
        began = shared.loop.time()
        client.transport.write(b"".join(b"GS%02X01000A0120\rGN%02X\r" % (group, group) for group in range(6)))
        await settle(shared)
        for _ in range(4):
            await come_back(shared)
            await asyncio.sleep(0.02)
        await asyncio.sleep(0.5)
        client.take()
        await until(lambda: b"P00" in client.heard)
        due = (shared.loop.time() - began) * 100
        number = next(int(frame[3:5], 16) for frame in client.take().splitlines() if frame.startswith(b"P00"))
        # Allow a difference, because the pauses between attempts grow; a sequence number has two digits.
        assert (due - number) % 256 < 10


@pytest.mark.slow
@on_simulated_time
async def test_server_survives_a_client_that_leaves_while_its_groups_are_restored(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with sharing(SlowLine(gateway_of(8), 10_000)) as shared:
        other = call(shared)
        for pause in range(60):
            client = call(shared)
            client.transport.write(b"".join(b"GS%02X01000A0120\rGN%02X\r" % (group, group) for group in range(6)))
            await settle(shared)
            drop(shared)
            await asyncio.sleep(pause / 200)
            client.transport.close()
            other.transport.write(b"R10\r")
            await until(lambda: b"R" in other.heard)
            assert re.search(rb"R10[0-9A-F]{8}\r\n$", other.take())
            # Wait, so that the pauses between attempts do not grow.
            await asyncio.sleep(2)
    assert [record.message for record in caplog.records if record.levelno >= logging.ERROR] == []


@on_simulated_time
async def test_send_immediate_mode_of_two_clients_stays_when_the_first_leaves() -> None:
    valve = Valve(VirtualGateway())
    async with sharing(valve) as shared:
        one, two = call(shared), call(shared)
        valve.requests_pass = False
        one.transport.write(b"I01\r")
        two.transport.write(b"I01\r")
        await asyncio.sleep(0.001)
        one.transport.abort()
        await asyncio.sleep(0.001)
        valve.requests_pass, valve.heard = True, b""
        await settle(shared)
        assert re.search(rb"i[0-9A-F]{3}01", valve.heard)
        two.transport.write(b"I02\r")
        await settle(shared)
        assert re.search(rb"i[0-9A-F]{3}02", valve.heard)
