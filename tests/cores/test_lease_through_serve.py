"""Leases of programs that share a link, and the resulting accesses on the gateway's bus."""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.sharing import SEED, PipedLink, call, settle, until
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import BusError, ConnectError, LinkLostError, NotArmedError, UnityLinkError
from unity_link.bridges.serve import serve
from unity_link.bridges.serve.shared import SharedLink
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Awaitable, Callable
    from pathlib import Path

    from unity_link import Link
    from unity_link.spec import Interface, Spec
    from unity_link.virtual.gateway import Gateway

TEXT = """
public rover() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=16);
  drive: LEASE(TIMEOUT=20) @(0xE0);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @lamp = 0x11: READWRITE();
}
"""
SPEC = compile_text(TEXT)
INTERFACE = SPEC.interface()
Rover = unity_link.load(SPEC)
STRANGE = 0xDEAD
DISARM = 0xF2


class Watched:
    """A rover, and the words written to it in the order of the bus."""

    def __init__(self, spec: Spec = SPEC) -> None:
        self.gateway = simulated(spec.interface())
        self.written: list[tuple[int, int]] = []
        robot = self.gateway.robot
        write = robot.write

        def note(offset: int, value: int, now: float) -> None:
            self.written.append((offset, value))
            write(offset, value, now)

        vars(robot)["write"] = note


@contextlib.asynccontextmanager
async def shared(gateway: Any, folder: Path, count: int = 2, spec: Spec = SPEC) -> AsyncIterator[list[Any]]:
    """Serve a gateway and connect several links to it; yield their rovers."""
    async with contextlib.AsyncExitStack() as stack:
        server = await stack.enter_async_context(serve(gateway, unix=folder / "gateway"))
        links = [await stack.enter_async_context(unity_link.connect(server.urls[0])) for _ in range(count)]
        yield [unity_link.load(spec)(link) for link in links]


@pytest.mark.asyncio
async def test_words_of_another_program_never_split_a_kick_or_an_arm(tmp_path: Path) -> None:
    # This spec has no description in the gateway, so the server cannot find the lease.
    spec = compile_text(TEXT.replace("  @lamp", "  @last = 0xFFF: READ();\n  @lamp"))
    watched = Watched(spec)
    # Both programs always have waiting requests, so their turns end at arbitrary words.
    line = SlowLine(watched.gateway, bytes_per_second=100_000)
    async with shared(line, tmp_path, spec=spec) as (program, stranger):
        registers = [program.drive.arm.signal.addresses, program.drive.kick.signal.addresses]

        async def disturb() -> None:
            while True:
                for addresses in registers:
                    # All addresses but the last one, whose write makes the core take the value.
                    await stranger.drive.arm.link.post_many(addresses[:-1], [STRANGE] * (len(addresses) - 1))

        disturbing = asyncio.create_task(disturb())
        for _ in range(3):
            async with program.armed() as lease:
                for number in range(60):
                    await lease.kick()
                    for _ in range(number % 5):
                        await program.lamp.post(number)
        disturbing.cancel()
    strange, taken = 0, 0
    for addresses in registers:
        words = [word for word in watched.written if word[0] in addresses]
        strange += sum(value == STRANGE for _, value in words)
        ends = [index for index, (address, _) in enumerate(words) if address == addresses[-1]]
        taken += len(ends)
        for end in ends:
            assert [address for address, _ in words[end + 1 - len(addresses) : end + 1]] == list(addresses)
            assert STRANGE not in [value for _, value in words[end + 1 - len(addresses) : end + 1]]
    assert taken > 150
    assert strange > 100


# Ownership of a lease, if the server has the spec or the gateway has its description


@contextlib.asynccontextmanager
async def leased(
    gateway: Gateway | None = None, interface: Interface | None = INTERFACE
) -> AsyncIterator[tuple[SharedLink, Any]]:
    """Share a rover by its spec; yield the shared link, and a function that connects a further client's rover."""
    shared = SharedLink(gateway or simulated(INTERFACE), lambda _: None, interface)
    shared.open_when_there()
    await until(lambda: not shared.away)
    async with contextlib.AsyncExitStack() as stack:

        async def another() -> Any:
            return Rover(await stack.enter_async_context(PipedLink(shared)))

        yield shared, another
    await shared.finish()


def vanish(robot: Any) -> None:
    """Break the connection of a program."""
    client = robot.drive.arm.link.client
    assert client._transport is not None
    client._transport.abort()


@pytest.mark.parametrize("interface", [INTERFACE, None], ids=["given", "carried by the gateway"])
@on_simulated_time
async def test_only_the_client_that_has_armed_moves_guarded_signals(interface: Interface | None) -> None:
    async with leased(interface=interface) as (_, another):
        owner, other = await another(), await another()
        async with owner.armed() as lease:
            says = "write of speed at 0x010: the bus refused the access: another program has armed drive, and it alone"
            for _ in range(2):
                with pytest.raises(BusError, match=says):
                    await other.speed.set(7)
                await owner.speed.set(5)
                await lease.kick()
            await other.lamp.set(3)
            assert (await other.speed.get(), await owner.lamp.get()) == (5, 3)
            assert await other.drive.stop()
            assert await owner.speed.get() == 0
            # The lease has no owner now, so the server leaves the refusal to the gateway.
            with pytest.raises(NotArmedError, match="drive is not armed: it was disarmed"):
                await other.speed.set(7)
        async with other.armed():
            await other.speed.set(7)
            with pytest.raises(BusError, match="another program has armed drive"):
                await owner.speed.set(5)


WRITES: dict[str, Callable[[Link], Awaitable[object]]] = {
    "a word": lambda link: link.write(0x10, 7),
    "a posted word": lambda link: link.post(0x10, 7),
    "a masked word": lambda link: link.write_masked(0x10, 7, 0xFF),
    "a block": lambda link: link.write_block(0x0F, [1, 7, 7]),
    "a queue": lambda link: link.write_queue(0x10, [7]),
    "many words": lambda link: link.write_many([0x20] * 20 + [0x10] * 20, range(40)),
    "many posted words": lambda link: link.post_many([0x10] * 20, range(20)),
    "a kick": lambda link: link.write_block(0xE4, [0, 0, 0, 0]),
    "a word of a kick": lambda link: link.write(0xE4, 0),
    "a word of an arm": lambda link: link.write(0xE0, 0),
    "an arm": lambda link: link.write_block(0xE0, [0, 0, 0, 0]),
    "the last word of an arm": lambda link: link.post(0xE3, 0),
}


async def fenced(link: Link, call: Awaitable[object]) -> None:
    await call
    await link.fence()


@pytest.mark.parametrize("write", WRITES.values(), ids=WRITES)
@on_simulated_time
async def test_every_kind_of_write_under_another_clients_lease_is_refused(
    write: Callable[[Link], Awaitable[object]],
) -> None:
    watched = Watched()
    async with leased(watched.gateway) as (_, another):
        owner, other = await another(), await another()
        link = other.drive.arm.link
        async with owner.armed():
            watched.written.clear()
            with pytest.raises(BusError, match="the bus refused the access"):
                await fenced(link, write(link))
            assert [written for written in watched.written if written[0] != 0x20] == []


@on_simulated_time
async def test_a_damaged_first_write_of_a_burst_keeps_its_client() -> None:
    failures: list[Any] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: failures.append(context))
    async with leased() as (shared, _):
        client, codec = call(shared), shared._session.codec
        client.transport.write(b"K0000001\r")
        await settle(shared)
        client.take()
        writes = b"".join(codec.request("W", number, b"011%04X" % number, SEED) for number in range(16))
        client.transport.write(writes.replace(b"0110000", b"0110008", 1))
        await settle(shared)
        assert failures == []
        client.transport.write(writes)
        await settle(shared)
        assert client.take().count(b"w") == 16


@on_simulated_time
async def test_a_gateway_with_an_unreadable_description_is_served_and_logged() -> None:
    told: list[str] = []
    gateway: Any = simulated(SPEC.interface())
    gateway.robot._registers._description = [1] * 32
    shared = SharedLink(gateway, told.append)
    shared.open_when_there()
    await until(lambda: not shared.away)
    assert shared.leases is None
    assert [text for text in told if "leases are not those of clients, since" in text]
    await shared.finish()


@on_simulated_time
async def test_a_disconnected_client_is_disarmed_and_its_requests_dropped() -> None:
    watched = Watched()
    async with leased(SlowLine(watched.gateway, bytes_per_second=20_000)) as (_, another):
        owner, other = await another(), await another()
        await owner.armed().__aenter__()
        await owner.drive.arm.link.post_many([0x10] * 2000, range(2000))
        await until(lambda: sum(address == 0x10 for address, _ in watched.written) > 50)
        vanish(owner)
        await until(lambda: (DISARM, 1) in watched.written)
        with pytest.raises(LinkLostError):
            await owner.drive.arm.link.fence()
        moved = sum(address == 0x10 for address, _ in watched.written)
        assert moved < 1000
        assert not await other.drive.armed_.get()
        assert await other.drive.reason.get() == "disarmed"
        async with other.armed():
            await other.speed.set(7)
            await asyncio.sleep(0.5)
            assert await other.speed.get() == 7
        assert sum(address == 0x10 for address, _ in watched.written) == moved + 1


@on_simulated_time
async def test_a_client_that_disconnects_while_it_arms_leaves_no_lease_armed() -> None:
    for moment in range(40):
        watched = Watched()
        async with leased(SlowLine(watched.gateway, bytes_per_second=20_000)) as (_, another):
            owner, other = await another(), await another()
            word = await owner.drive.clock.get() + 10 * 50_000_000
            arming = asyncio.create_task(owner.drive.arm.set(word))
            await asyncio.sleep(moment * 0.0005)
            vanish(owner)
            # Even if the program has ended in order, the loss is reported to its next call.
            with pytest.raises(LinkLostError):
                await fenced(owner.drive.arm.link, arming)
            await asyncio.sleep(0.1)
            assert not await other.drive.armed_.get(), moment
            async with other.armed():
                await other.speed.set(1)


@on_simulated_time
async def test_waiting_writes_of_an_ended_lease_never_act_under_the_next_one() -> None:
    watched = Watched()
    async with leased(SlowLine(watched.gateway, bytes_per_second=20_000)) as (_, another):
        first, second, third = await another(), await another(), await another()
        link = first.drive.arm.link
        async with first.armed(timeout=0.05):
            pass
        # Many writes of the former owner wait in the server, each after a long answer; other clients also wait.
        reading = [asyncio.create_task(third.lamp.link.read_queue(0x11, 200)) for _ in range(60)]
        requests = [request for _ in range(30) for request in (link.read_queue(0x11, 200), link.write(0x10, 9))]
        writing = [asyncio.create_task(request) for request in requests]
        await asyncio.sleep(0.1)
        watched.written.clear()
        async with second.armed():
            armed_at = watched.written.index((0xE3, watched.gateway.robot.drive.arm >> 48))
            await second.speed.set(7)
            results = await asyncio.gather(*writing, return_exceptions=True)
            await asyncio.gather(*reading)
            assert all(isinstance(result, BusError) for result in results[1::2])
            assert await second.speed.get() == 7
        assert [value for address, value in watched.written[armed_at:] if address == 0x10] == [7]


@on_simulated_time
async def test_one_of_several_clients_that_arm_at_once_gets_the_lease() -> None:
    async with leased() as (_, another):
        robots = [await another() for _ in range(5)]
        had: list[Any] = []

        async def use(robot: Any) -> None:
            with contextlib.suppress(NotArmedError):
                async with robot.armed():
                    await robot.speed.set(len(had) + 1)
                    had.append(robot)
                    await asyncio.sleep(0.1)
                    assert await robot.speed.get() == had.index(robot) + 1

        await asyncio.gather(*map(use, robots))
        assert len(had) == 1
        await asyncio.gather(*map(use, robots[::-1]))
        assert len(had) == 2


@on_simulated_time
async def test_a_client_lost_with_the_gateway_is_disarmed_after_reconnection() -> None:
    watched = Watched()
    valve = Valve(watched.gateway)
    async with leased(valve) as (shared, another):
        owner, other = await another(), await another()
        await owner.armed().__aenter__()
        await owner.speed.set(5)
        valve.go_away(shared)
        vanish(owner)
        await asyncio.sleep(5)
        assert (DISARM, 1) not in watched.written
        valve.come_back()
        await until(lambda: not shared.away)
        assert not await other.drive.armed_.get()
        assert await other.speed.get() == 0


@on_simulated_time
async def test_a_reset_of_the_gateway_clears_the_owner_of_the_lease() -> None:
    watched = Watched()
    async with leased(watched.gateway) as (shared, another):
        owner, other = await another(), await another()
        await owner.armed().__aenter__()
        sessions = shared._session.epoch
        watched.gateway.reset()
        with contextlib.suppress(UnityLinkError):
            await other.lamp.get()
        await until(lambda: shared._session.epoch > sessions and shared.connected and not shared.away)
        third = await another()
        async with third.armed():
            await third.speed.set(3)


@on_simulated_time
async def test_a_gateway_of_another_map_than_the_spec_is_refused() -> None:
    other = compile_text(TEXT.replace("0x11", "0x12")).interface()
    shared = SharedLink(simulated(SPEC.interface()), lambda _: None, other)
    shared.open_when_there()
    with pytest.raises(ConnectError, match=r"the gateway was built for the map .* and the spec of rover describes"):
        await shared.ended
    await shared.finish()
