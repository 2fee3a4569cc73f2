"""A program's lease ends when its link, or the link of the server, opens another session."""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any

import pytest
import trio
from anyio.from_thread import start_blocking_portal

import unity_link
from support.sharing import PipedLink, until
from support.simulated_time import on_simulated_time
from support.valve import Valve, cut
from unity_link import (
    BusError,
    BusTimeoutError,
    GatewayResetError,
    LinkLostError,
    NotArmedError,
    Outcome,
    Reconnect,
    blocking,
)
from unity_link.bridges.serve import serve
from unity_link.bridges.serve.shared import SharedLink
from unity_link.data import Group
from unity_link.data.blocking import put
from unity_link.spec import compile_text
from unity_link.virtual.build import Wanted, simulated
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
    from pathlib import Path

    from unity_link import Link
    from unity_link.spec import Spec

TEXT = """
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20, FINISH=20) @(0xE0);
  plan: SCHEDULE(DEPTH=64) @(0x100);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @half = 0x11[15:0]: signed 16 READWRITE(SAFE(0, drive));
  @rest = 0x11[31:16]: signed 16 READWRITE(SAFE(0, drive));
  @duty = 0x12: signed READWRITE(SAFE(0, drive), TIMED(plan));
  @lamp = 0x20: READWRITE();
  free: SCHEDULE(DEPTH=64) @(0x140);
  @signal = 0x21: unsigned 8 READWRITE(TIMED(free));
}
"""
KNOWN = compile_text(TEXT)
# A signal at the top leaves no space for a description of the spec, so the server cannot find the lease.
UNKNOWN = compile_text(TEXT.replace("  @lamp", "  @top = 0xFFF: READ();\n  @lamp"))
SPECS = pytest.mark.parametrize("spec", [KNOWN, UNKNOWN], ids=["the server knows the lease", "the server does not"])


class World:
    """A rover behind a server, and the present values of its registers."""

    def __init__(self, spec: Spec) -> None:
        self.spec = spec
        # A window of 128 requests, so that more requests have to wait.
        self.gateway: Any = simulated(spec.interface(), None, Wanted(configuration={"id_digits": 2}))
        self.valve = Valve(self.gateway)
        self.shared = SharedLink(self.valve, lambda _: None)
        self.links: contextlib.AsyncExitStack

    async def another(self, reconnect: Reconnect | None = None) -> Any:
        """Connect another program; return its rover."""
        link = await self.links.enter_async_context(PipedLink(self.shared, reconnect=reconnect))
        return unity_link.load(self.spec)(link)

    async def interrupt(self) -> None:
        """End the server's session with the gateway, which is not reset."""
        self.valve.go_away(self.shared)
        await asyncio.sleep(0.01)
        self.valve.come_back()
        await until(lambda: self.shared.connected)

    def seen(self, path: str) -> Any:
        """Return the present value of a signal, without a request."""
        self.gateway.robot.pass_time(asyncio.get_running_loop().time())
        return self.gateway.robot.cells[path].value

    @property
    def is_armed(self) -> bool:
        return bool(self.seen("drive.armed"))


@contextlib.asynccontextmanager
async def world_of(spec: Spec) -> AsyncIterator[World]:
    world = World(spec)
    world.shared.open_when_there()
    await until(lambda: not world.shared.away)
    async with contextlib.AsyncExitStack() as world.links:
        yield world
    await world.shared.finish()


MET = (GatewayResetError, BusTimeoutError)
"""Errors of the first requests after a reset: the server cannot decide if the request in flight was executed."""


async def kicked(lease: Any, times: int) -> None:
    """Kick a lease several times, 0.01 s apart."""
    for _ in range(times):
        await lease.kick()
        await asyncio.sleep(0.01)


async def met(robot: Any) -> None:
    """Make requests until the program has noticed the reset; works once in a test."""
    while not robot.link.resets:
        with contextlib.suppress(*MET):
            await robot.lamp.get()


# A reset


@SPECS
@on_simulated_time
async def test_a_lease_from_before_a_reset_is_not_the_lease_of_the_next_program(spec: Spec) -> None:
    async with world_of(spec) as world:
        first, second = await world.another(), await world.another()
        async with first.armed() as lease:
            await first.speed.set(1)
            world.gateway.reset()
            await met(second)
            async with second.armed() as other:
                await second.speed.set(2)
                # Both leases are the first since a reset.
                assert world.seen("drive.arms") == 1
                await met(first)
                says = "drive has ended: the link has begun another session since it was armed"
                for call in (lease.kick, lambda: first.speed.set(3), lambda: first.speed.post(3)):
                    with pytest.raises(NotArmedError, match=says) as ended:
                        await call()
                    assert ended.value.reason == "reset"
                await lease.__aexit__(None, None, None)
                assert world.is_armed
                await other.kick()
                assert world.seen("speed") == 2


@SPECS
@pytest.mark.parametrize("error", [ValueError, asyncio.CancelledError, None])
@on_simulated_time
async def test_the_end_of_a_block_leaves_the_lease_of_the_next_program(
    spec: Spec, error: type[BaseException] | None
) -> None:
    async with world_of(spec) as world:
        first, second = await world.another(), await world.another()
        lease = first.armed()
        await lease.__aenter__()
        world.gateway.reset()
        await met(second)
        async with second.armed():
            # The block ends once before and once after its program has noticed the reset.
            for _ in range(2):
                with contextlib.suppress(LinkLostError):
                    await lease.__aexit__(error, error and error(), None)
                assert world.is_armed


WRITES: dict[str, Callable[[Any], Coroutine[Any, Any, object]]] = {
    "a word": lambda robot: robot.link.write(0x10, 7),
    "a posted word": lambda robot: robot.link.post(0x10, 7),
    "a masked word": lambda robot: robot.link.write_masked(0x10, 7, 0xFF),
    "a block": lambda robot: robot.link.write_block(0x0F, [1, 7]),
    "a queue": lambda robot: robot.link.write_queue(0x10, [7]),
    "many words": lambda robot: robot.link.write_many([0x20, 0x10], [7, 7]),
    "many posted words": lambda robot: robot.link.post_many([0x20, 0x10], [7, 7]),
    "a signal": lambda robot: robot.speed.set(7),
    "a field": lambda robot: robot.half.set(7),
    "a group": lambda robot: Group(robot.lamp, robot.speed).set([7, 7]),
    "a posted group": lambda robot: Group(robot.lamp, robot.speed).post([7, 7]),
    "a schedule": lambda robot: robot.link.write_queue(0x100, [7]),
    "a timeline": lambda robot: robot.plan.timeline().__aenter__(),
}


@pytest.mark.parametrize("write", WRITES.values(), ids=WRITES)
@on_simulated_time
async def test_every_kind_of_write_is_refused_after_the_lease_has_ended(
    write: Callable[[Any], Coroutine[Any, Any, Any]],
) -> None:
    async with world_of(UNKNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed():
            world.gateway.reset()
            await met(second)
            async with second.armed():
                await met(first)
                with pytest.raises(NotArmedError, match="drive has ended"):
                    await write(first)
                assert [world.seen(path) for path in ("speed", "half", "duty")] == [0, 0, 0]
                await first.lamp.set(5)
                assert world.seen("lamp") == 5


@pytest.mark.parametrize("way", ["post_many", "posts", "writes", "blocks"])
@on_simulated_time
async def test_writes_that_wait_during_a_reset_are_never_sent(way: str) -> None:
    async with world_of(UNKNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed():
            link: Link = first.link
            asking: list[asyncio.Future[Any]] = []
            if way == "post_many":
                asking.append(asyncio.ensure_future(link.post_many([0x10] * 1000, range(1, 1001))))
            for value in range(1, 400):
                if way == "posts":
                    asking.append(asyncio.ensure_future(link.post(0x10, value)))
                elif way == "writes":
                    asking.append(asyncio.ensure_future(link.write(0x10, value)))
                elif way == "blocks":
                    asking.append(asyncio.ensure_future(link.write_block(0x0F, [value] * 2)))
            await asyncio.sleep(0)
            world.gateway.reset()
            told = await asyncio.gather(*asking, return_exceptions=True)
            assert any(isinstance(error, LinkLostError) for error in told)
            assert all(
                error.outcome in {Outcome.NOT_EXECUTED, Outcome.UNKNOWN}
                for error in told
                if isinstance(error, LinkLostError)
            )
            await met(second)
            async with second.armed():
                await second.speed.set(-1)
                with contextlib.suppress(LinkLostError):
                    await link.fence()
                await asyncio.sleep(1)
                assert world.seen("speed") == -1


@on_simulated_time
async def test_unguarded_writes_are_sent_in_the_next_session() -> None:
    gateway = simulated(KNOWN.interface())
    valve = Valve(gateway)
    async with unity_link.connect(valve, reconnect=True) as link:
        robot: Any = unity_link.load(KNOWN)(link)
        async with robot.armed():
            valve.go_away(link)
            await asyncio.sleep(0.01)
            writing = asyncio.create_task(robot.lamp.set(7))
            with pytest.raises(NotArmedError, match=r"drive has ended: .* \(the other side closed the connection\)"):
                await robot.speed.set(7)
            valve.come_back()
            await writing
            assert await robot.lamp.get() == 7


# Another session without a reset


@on_simulated_time
async def test_a_reconnection_ends_the_lease_for_its_program() -> None:
    gateway: Any = simulated(KNOWN.interface())
    valve = Valve(gateway)

    async def move(link: Link, robot: Any) -> None:
        async with robot.armed(timeout=3) as lease:
            await robot.speed.set(5)
            cut(link)
            await asyncio.sleep(1)
            assert link.connected
            await lease.kick()

    async with unity_link.connect(valve, reconnect=True) as link:
        robot: Any = unity_link.load(KNOWN)(link)
        with pytest.raises(NotArmedError, match="drive has ended: the link has begun another session") as ended:
            await move(link, robot)
        assert (ended.value.reason, ended.value.instant) == ("reset", None)
        assert "it runs out by itself, 3 s after the last kick" in ended.value.__notes__[0]
        assert await robot.drive.armed_.get()
        await asyncio.sleep(2.5)
        assert not await robot.drive.armed_.get()
        assert (await robot.drive.reason.get(), await robot.speed.get()) == ("silence", 0)


@on_simulated_time
async def test_another_session_of_the_server_ends_the_leases_of_its_clients() -> None:
    async with world_of(KNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed() as lease:
            await first.speed.set(5)
            await world.interrupt()
            with pytest.raises(NotArmedError, match="drive is not armed: it was disarmed"):
                await first.speed.set(6)
            assert (world.is_armed, world.seen("speed")) == (False, 0)
            async with second.armed():
                await second.speed.set(2)
                with pytest.raises(NotArmedError):
                    await kicked(lease, 3)
                with pytest.raises(BusError):
                    await first.speed.set(6)
                await lease.__aexit__(None, None, None)
                assert (world.is_armed, world.seen("speed")) == (True, 2)
        async with first.armed():
            await first.speed.set(3)


@on_simulated_time
async def test_scheduled_writes_run_out_in_another_session_of_the_server() -> None:
    async with world_of(KNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed(timeout=1, on_silence="finish") as lease:
            clock = await first.plan.clock()
            for step in range(1, 6):
                await first.duty.set(step, at=clock.now().after(0.5 * step))
            await first.link.fence()
            await world.interrupt()
            with pytest.raises(NotArmedError, match="drive has ended: a server has refused its kick") as ended:
                await kicked(lease, 3)
            assert ended.value.reason == "reset"
            for robot in (first, second):
                with pytest.raises(BusError):
                    await robot.speed.set(6)
                with pytest.raises(NotArmedError, match="drive cannot be armed"):
                    async with robot.armed():
                        pytest.fail("the block began")
            await asyncio.sleep(1.5)
            assert (world.seen("drive.finishing"), world.seen("duty")) == (True, 3)
            await asyncio.sleep(1)
            assert (world.is_armed, world.seen("duty")) == (False, 0)
        async with second.armed():
            await second.speed.set(3)


@pytest.mark.parametrize("way", ["reset", "interrupted"])
@on_simulated_time
async def test_an_arm_that_waits_in_the_server_is_of_the_session_that_sends_it(way: str) -> None:
    async with world_of(KNOWN) as world:
        first, *others = [await world.another() for _ in range(4)]
        # The arm waits until the writes of the other clients are sent, which fill more than the window.
        world.valve.requests_pass = False
        writing = [asyncio.create_task(other.link.write_many([0x20] * 400, range(400))) for other in others]
        await asyncio.sleep(0.001)
        word = 0x1234 << 40 | 500_000_000
        arming = asyncio.create_task(first.drive.arm.set(word))
        await asyncio.sleep(0.001)
        world.valve.go_away(world.shared)
        await asyncio.sleep(0.01)
        if way == "reset":
            world.gateway.reset()
        world.valve.come_back()
        await asyncio.gather(arming, *writing, return_exceptions=True)
        await asyncio.sleep(1)
        lease = world.shared.leases._leases[0] if world.shared.leases is not None else None
        assert lease is not None
        assert world.seen("drive.arms") == (way == "interrupted")
        assert isinstance(arming.exception(), GatewayResetError) == (way == "reset")
        assert (lease.owner is first.link.client) == (way == "interrupted")


# Arming


@on_simulated_time
async def test_a_cancelled_arm_disarms_only_its_own_lease() -> None:
    for taken in (False, True):
        for turns in range(0, 30, 3):
            async with world_of(UNKNOWN) as world:
                first, second = await world.another(), await world.another()
                async with contextlib.AsyncExitStack() as stack:
                    if taken:
                        await stack.enter_async_context(second.armed())
                    arming = asyncio.create_task(first.armed().__aenter__())
                    for _ in range(turns):
                        await asyncio.sleep(0)
                    was_done = arming.done()
                    arming.cancel()
                    await asyncio.wait([arming])
                    await asyncio.sleep(0.01)
                    assert world.is_armed == (taken or was_done), turns


@on_simulated_time
async def test_a_cancelled_arm_leaves_a_lease_that_others_armed_since() -> None:
    for turns in range(30):
        async with world_of(UNKNOWN) as world:
            first = await world.another()
            robot = world.gateway.robot
            arming = asyncio.create_task(first.armed().__aenter__())
            for _ in range(turns):
                await asyncio.sleep(0)
            now = asyncio.get_running_loop().time()
            before = world.seen("drive.arms")
            for _ in range(2):
                robot.write(0xF2, 1, now)
                for offset, word in ((0xE0, int(now * 50e6) + 500_000_000), (0xE1, 0x77 << 8)):
                    robot.write(offset, word, now)
            assert world.seen("drive.arms") == before + 2
            arming.cancel()
            await asyncio.wait([arming])
            assert world.is_armed, turns


@on_simulated_time
async def test_a_program_whose_arm_was_repeated_reads_the_owner_of_the_lease() -> None:
    async with world_of(KNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed() as lease:
            own = "drive cannot be armed: this program has armed it already, in another block"
            for robot, says in ((first, own), (second, "drive cannot be armed: another program has armed it")):
                with pytest.raises(NotArmedError, match=says) as refused:
                    async with robot.armed():
                        pytest.fail("the block began")
                assert refused.value.reason == "taken"
            await lease.kick()
            await first.speed.set(1)


# Schedules


@on_simulated_time
async def test_other_clients_can_neither_write_nor_cancel_a_leased_schedule() -> None:
    async with world_of(KNOWN) as world:
        first, second = await world.another(), await world.another()
        async with first.armed():
            clock = await first.plan.clock()
            done = await first.duty.set(5, at=clock.now().after(0.1))
            instant = (await second.plan.clock()).now().after(0.05)
            says = "another program has armed drive, and it alone may move what that guards"
            calls: list[tuple[Callable[[], Any], str]] = [
                (lambda: second.duty.set(7, at=instant), says),
                (lambda: second.plan.play([0, 0.1], {second.duty: [7, 8]}), says),
                (lambda: second.plan.cancel.set(1), "write of plan.cancel at 0x101: the bus refused the access"),
                (lambda: second.link.write_queue(0x100, [7]), "queue write of plan.entry at 0x100: the bus refused"),
            ]
            for call, message in calls:
                with pytest.raises(BusError, match=message):
                    await call()
            assert await done == done.instant
            assert world.seen("duty") == 5


@pytest.mark.parametrize("name", ["plan", "free"])
@on_simulated_time
async def test_a_timeline_from_before_a_reset_cancels_no_later_writes(name: str) -> None:
    signal = {"plan": "duty", "free": "signal"}[name]
    async with world_of(UNKNOWN) as world:
        first, second = await world.another(), await world.another()

        async def feed() -> None:
            schedule: Any = getattr(first, name)
            async with first.armed(), schedule.timeline(lead=0.2) as line:
                await line.set({first[signal]: 1})
                world.gateway.reset()
                await met(second)
                await stack.enter_async_context(second.armed())
                clock = await getattr(second, name).clock()
                later.append(await getattr(second, signal).set(2, at=clock.now().after(1)))
                await met(first)
                raise ValueError("of the block")

        later: list[Any] = []
        async with contextlib.AsyncExitStack() as stack:
            with pytest.raises(ValueError, match="of the block"):
                await feed()
            (done,) = later
            assert await done == done.instant
            assert world.seen(signal) == 2


@on_simulated_time
async def test_a_cancel_that_waits_during_a_reset_is_never_sent() -> None:
    gateway: Any = simulated(KNOWN.interface())
    valve = Valve(gateway)
    written: list[int] = []
    write = gateway.robot.write

    def note(offset: int, value: int, now: float) -> None:
        written.append(offset)
        write(offset, value, now)

    vars(gateway.robot)["write"] = note

    async def feed(link: Link, robot: Any) -> None:
        async with robot.free.timeline(lead=1) as line:
            await line.set({robot.signal: 1})
            await link.fence()
            valve.go_away(link)
            await asyncio.sleep(0.01)
            asyncio.get_running_loop().call_later(1, come_back)
            raise ValueError("of the block")

    def come_back() -> None:
        gateway.reset()
        written.clear()
        valve.come_back()

    async with unity_link.connect(valve, reconnect=True) as link:
        robot: Any = unity_link.load(KNOWN)(link)
        with pytest.raises(ValueError, match="of the block"):
            await feed(link, robot)
        await robot.lamp.set(1)
        assert written == [0x20]


@on_simulated_time
async def test_a_late_answer_of_the_clock_in_a_new_session_shows_no_reset() -> None:
    gateway: Any = simulated(KNOWN.interface())
    async with unity_link.connect(SlowLine(gateway, bytes_per_second=100_000), reconnect=True) as link:
        robot: Any = unity_link.load(KNOWN)(link)
        clock = await robot.free.clock()
        done = await robot.signal.set(1, at=clock.now().after(5))
        await link.fence()
        cut(link)
        await until(lambda: link.connected)
        # The reading of the clock is answered after all of these reads.
        reading = [asyncio.create_task(link.read_queue(0x20, 200)) for _ in range(40)]
        await asyncio.sleep(0)
        await robot.free.clock()
        assert done.acted is None
        await asyncio.gather(*reading)
        assert await done == done.instant


# Programs of each API


async def story(connect: Callable[[str], Any], url: str, spec: Spec, reset: Callable[[], Any]) -> None:
    """Have a reset end a lease, and let another program arm."""
    async with connect(url) as one, connect(url) as other:
        first: Any = unity_link.load(spec)(one)
        second: Any = unity_link.load(spec)(other)
        async with first.armed() as lease:
            await first.speed.set(1)
            await reset()
            with pytest.raises(MET):
                await second.speed.set(2)
            with contextlib.suppress(GatewayResetError):
                await second.lamp.get()
            async with second.armed():
                await second.speed.set(2)
                with pytest.raises((GatewayResetError, NotArmedError)):
                    await first.speed.set(3)
                with pytest.raises(NotArmedError, match="drive has ended"):
                    await first.speed.set(3)
                with pytest.raises(NotArmedError, match="drive has ended"):
                    await lease.kick()
                await lease.__aexit__(None, None, None)
                assert await second.speed.get() == 2
                assert await second.drive.armed_.get()


def blocking_story(url: str, spec: Spec, reset: Callable[[], None]) -> None:
    """Do the same with blocking programs."""
    kind = unity_link.load(spec)
    with blocking.connect(url) as one, blocking.connect(url) as other:
        first, second = put(kind, one), put(kind, other)
        with first.armed() as lease:
            first.speed.set(1)
            reset()
            with pytest.raises(MET):
                second.speed.set(2)
            with contextlib.suppress(GatewayResetError):
                second.lamp.get()
            with second.armed():
                second.speed.set(2)
                with pytest.raises((GatewayResetError, NotArmedError)):
                    first.speed.set(3)
                with pytest.raises(NotArmedError, match="drive has ended"):
                    first.speed.set(3)
                with pytest.raises(NotArmedError, match="drive has ended"):
                    lease.kick()
                lease.__exit__(None, None, None)
                assert second.speed.get() == 2
                assert second.drive.armed_.get()


@contextlib.contextmanager
def served(spec: Spec, folder: Path) -> Iterator[tuple[str, Callable[[], None]]]:
    """Serve a rover in a thread of its own; yield its URL and a function that resets it."""
    with start_blocking_portal() as portal:
        gateway = simulated(spec.interface())
        with portal.wrap_async_context_manager(serve(gateway, unix=folder / "socket")) as server:
            yield server.urls[0], lambda: portal.call(gateway.reset)


@SPECS
@pytest.mark.parametrize("face", ["asyncio", "trio", "blocking"])
def test_programs_of_each_api_get_an_error_after_a_reset_ended_their_lease(
    face: str, spec: Spec, tmp_path: Path
) -> None:
    with served(spec, tmp_path) as (url, reset):

        async def reset_in_thread() -> None:
            await (asyncio.to_thread(reset) if face == "asyncio" else trio.to_thread.run_sync(reset))

        async def program() -> None:
            await story(unity_link.connect, url, spec, reset_in_thread)

        if face == "blocking":
            blocking_story(url, spec, reset)
        elif face == "trio":
            trio.run(program)
        else:
            asyncio.run(program())
