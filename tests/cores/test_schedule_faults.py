"""Writes at instants that are not awaited, lost in a reset, or sent in part before the connection is lost."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest
import trio

import unity_link
from support.simulated_time import on_simulated_time
from support.valve import Valve, cut
from unity_link import GatewayResetError, LateError, LinkLostError, NotArmedError, Outcome, blocking
from unity_link.data.blocking import put
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Value

SPEC = compile_text("""
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=0.1) @(0xC0);
  plan: SCHEDULE(DEPTH=64) @(0xE0);
  free: SCHEDULE(DEPTH=64) @(0x100);
  @lamp = 0x40: unsigned 8 READWRITE(TIMED(free));
  @duty = 0x41: unsigned 8 READWRITE(SAFE(0, drive), TIMED(plan));
}
""")
Robot = unity_link.load(SPEC)


class Plant(SimulatedRobot):
    """Records the written values, in order."""

    def start(self) -> None:
        self.seen: list[tuple[str, Value]] = []

    def written(self, path: str, value: Value) -> None:
        self.seen.append((path, value))

    def of(self, path: str) -> list[Value]:
        return [value for name, value in self.seen if name == path]


def gateway_of() -> Any:
    return simulated(SPEC.interface(), Plant)


# Fences


@on_simulated_time
async def test_a_fence_raises_once_for_a_late_write_that_is_not_awaited() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        late = await robot.lamp.set(30, at=clock.now().after(-0.001))
        with pytest.raises(LateError, match=r"free has not made the write at .*: it came too late") as raised:
            await link.fence()
        assert raised.value.ticks == late.instant.ticks
        await link.fence()
        assert await (await robot.lamp.set(31, at=clock.now().after(0.01)))
        assert await robot.lamp.get() == 31


@on_simulated_time
async def test_a_fence_does_not_wait_for_instants_and_raises_after_them() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        begun = asyncio.get_running_loop().time()
        first = clock.now().after(10)
        await robot.lamp.set(1, at=first)
        # The words of the second write arrive after the first instant, because the queue keeps their order.
        await robot.lamp.set(2, at=first.after(1e-7))
        await link.fence()
        assert asyncio.get_running_loop().time() - begun < 1
        await asyncio.sleep(11)
        with pytest.raises(LateError) as raised:
            await link.fence()
        assert raised.value.ticks == first.after(1e-7).ticks
        assert gateway.robot.of("lamp") == [1]


@on_simulated_time
async def test_the_error_of_a_fence_names_the_write_without_a_lease() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        clock = await robot.plan.clock()
        await robot.duty.set(1, at=clock.now().after(0.01))
        await asyncio.sleep(0.001)
        with pytest.raises(
            NotArmedError, match=r"plan has not made the write at .*: drive is not armed: nobody has armed"
        ):
            await link.fence()
        await link.fence()


@on_simulated_time
async def test_many_late_writes_cause_one_error() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        first = clock.now().after(0.01)
        for number in range(12):
            await robot.lamp.set(number, at=first.after(number * 1e-7))
        await asyncio.sleep(0.1)
        with pytest.raises(LateError, match=r", and \d+ more up to"):
            await link.fence()


@on_simulated_time
async def test_each_task_gets_the_errors_of_its_own_late_writes() -> None:
    written, heard = asyncio.Event(), asyncio.Event()

    async def write_and_stay(robot: Any) -> None:
        clock = await robot.free.clock()
        for number in range(2):
            await robot.lamp.set(30, at=clock.now().after(0.001 * number - 0.002))
            written.set()
            await heard.wait()
            if not number:
                with pytest.raises(LateError):
                    await robot.link.fence()
                await asyncio.sleep(1)

    async with unity_link.connect(gateway_of()) as link:
        task = asyncio.ensure_future(write_and_stay(Robot(link)))
        await written.wait()
        await link.fence()
        heard.set()
        await task
        with pytest.raises(LateError):
            await link.fence()
        await link.fence()


@pytest.mark.parametrize("by", ["fence", "set"])
@on_simulated_time
async def test_a_write_at_an_instant_belongs_to_the_task_that_calls_set(by: str) -> None:
    written, fenced = asyncio.Event(), asyncio.Event()

    async def fence(robot: Any) -> None:
        await written.wait()
        await robot.link.fence()
        fenced.set()

    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        other = asyncio.create_task(fence(robot))
        clock = await robot.free.clock()
        # The write runs in a task of its own, which has ended when the other task calls `fence`.
        await asyncio.gather(robot.lamp.set(30, at=clock.now().after(-0.001)))
        await asyncio.sleep(0.001)
        written.set()
        await fenced.wait()
        asks = link.fence() if by == "fence" else robot.lamp.set(31, at=clock.now().after(0.1))
        if by == "set":
            # A `set` raises only known errors; the fence of the other task reads the registers first.
            await asyncio.sleep(0)
        with pytest.raises(LateError):
            await asyncio.wait_for(asks, 10)
        await other


@on_simulated_time
async def test_a_set_of_a_timeline_raises_the_errors_of_the_task_that_calls_it() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)

        async def feed() -> None:
            async with robot.free.timeline(lead=0.01) as line:
                line.delay(-1)
                await asyncio.wait_for(line.set({robot.lamp: 1}), 10)
                line.delay(2)
                # While it waits for space it reads the outcome of the first write.
                for _ in range(40):
                    line.delay(0.1)
                    await asyncio.wait_for(line.set({robot.lamp: 2}), 60)
                pytest.fail("the late write was not raised by a later set")

        with pytest.raises(LateError):
            await feed()


@on_simulated_time
async def test_a_fence_does_not_raise_for_awaited_writes_or_timelines() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        late = await robot.lamp.set(30, at=clock.now().after(-0.001))
        task = asyncio.ensure_future(late.wait())
        await asyncio.sleep(0)
        await link.fence()
        with pytest.raises(LateError):
            await task

        async def feed() -> None:
            async with robot.free.timeline(lead=0.01) as line:
                line.delay(-1)
                await line.set({robot.lamp: 1})
                await link.fence()
                await line.flush()

        with pytest.raises(LateError):
            await feed()
        await link.fence()


@on_simulated_time
async def test_the_fence_raises_for_a_write_whose_wait_was_cancelled() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot = Robot(link)
        clock = await robot.plan.clock()
        refused = await robot.duty.set(1, at=clock.now().after(1))
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.5):
                await refused
        with pytest.raises(NotArmedError):
            await link.fence()


@on_simulated_time
async def test_the_end_of_the_links_block_raises_for_late_writes() -> None:
    async def leave(*, away: bool, ahead: float) -> None:
        valve = Valve(gateway_of())
        async with unity_link.connect(valve, reconnect=True) as link:
            robot = Robot(link)
            clock = await robot.free.clock()
            await robot.lamp.set(30, at=clock.now().after(ahead))
            if away:
                valve.go_away(link)
                await asyncio.sleep(0.01)

    await leave(away=False, ahead=1)
    with pytest.raises(LateError):
        await leave(away=False, ahead=-0.001)
    with pytest.raises(LinkLostError, match=r"the connection was lost, and free has forgotten the write at"):
        await leave(away=True, ahead=-0.001)


@on_simulated_time
async def test_the_end_of_the_links_block_raises_the_first_error_with_notes() -> None:
    async def leave() -> None:
        async with unity_link.connect(gateway_of()) as link:
            robot = Robot(link)
            for registers, signal in ((robot.free, robot.lamp), (robot.plan, robot.duty)):
                clock = await registers.clock()
                await signal.set(30, at=clock.now().after(-0.001))
            await link.post(0x7FF, 1)

    with pytest.raises(unity_link.BusError) as raised:
        await leave()
    unarmed, late = sorted(raised.value.__notes__)[::-1]
    assert unarmed.startswith("plan has not made the write at ")
    assert late.startswith("free has not made the write at ")


@on_simulated_time
async def test_a_fence_sends_no_reads_without_writes_at_instants() -> None:
    async with unity_link.connect(gateway_of()) as link:
        Robot(link)
        before = link.statistics.requests
        await link.fence()
        assert link.statistics.requests == before + 1


# Resets


@on_simulated_time
async def test_a_reset_voids_the_queue_and_each_call_reports_it() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        await asyncio.sleep(5)
        passed = await robot.lamp.set(1, at=clock.now().after(0.1))
        ahead = await robot.lamp.set(2, at=clock.now().after(1))
        await robot.lamp.set(3, at=clock.now().after(2))
        await asyncio.sleep(0.5)
        assert await robot.lamp.get() == 1
        gateway.reset()
        with pytest.raises(GatewayResetError):
            await robot.lamp.get()
        with pytest.raises(GatewayResetError, match="the gateway was reset") as gone:
            await ahead
        with pytest.raises(GatewayResetError) as unknown:
            await passed
        assert gone.value.outcome is Outcome.NOT_EXECUTED
        assert unknown.value.outcome is Outcome.UNKNOWN
        assert gateway.robot.of("lamp") == [1]
        with pytest.raises(GatewayResetError, match="the gateway was reset, and free has forgotten the write at 7"):
            await link.fence()
        await link.fence()
        assert clock.now().ticks < 2 * clock.clock_hz
        done = await robot.lamp.set(4, at=clock.now().after(0.1))
        assert await done == done.instant
        assert gateway.robot.of("lamp") == [1, 4]


@pytest.mark.parametrize("awaits", [True, False])
@on_simulated_time
async def test_instants_from_before_a_reset_are_refused(*, awaits: bool) -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        await asyncio.sleep(5)
        done = await robot.lamp.set(1, at=clock.now().after(0.1))
        if awaits:
            await done
        gateway.reset()
        with pytest.raises(GatewayResetError):
            await robot.lamp.get()
        if not awaits:
            with pytest.raises(GatewayResetError, match="free has forgotten the write"):
                await robot.lamp.set(2, at=clock.now().after(0.1))
            return
        with pytest.raises(GatewayResetError, match=r"and its clock with it: .* is an instant of before"):
            await robot.lamp.set(2, at=clock.now().after(0.1))
        done = await robot.lamp.set(3, at=clock.now().after(0.1))
        await done
        assert gateway.robot.of("lamp") == [1, 3]


@pytest.mark.parametrize("seen_by", ["set", "flush", "another's request"])
@on_simulated_time
async def test_a_reset_ends_a_timeline(seen_by: str) -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot = Robot(link)

        async def feed() -> None:
            async with robot.free.timeline(lead=0.2) as line:
                for number in range(40):
                    if number == 10:
                        gateway.reset()
                        if seen_by == "another's request":
                            with pytest.raises(GatewayResetError):
                                await robot.duty.get()
                        if seen_by == "flush":
                            await line.flush()
                    await line.set({robot.lamp: number})
                    line.delay(0.01)

        await asyncio.sleep(5)
        with pytest.raises(GatewayResetError, match="the gateway was reset"):
            await feed()
        await asyncio.sleep(2)
        assert gateway.robot.of("lamp") == []
        async with robot.free.timeline() as line:
            await line.set({robot.lamp: 99})
            assert await line.flush() == 1


@on_simulated_time
async def test_a_cancelled_timeline_accepts_no_more_writes() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot = Robot(link)
        await asyncio.sleep(1)
        async with robot.free.timeline(lead=0.2) as line:
            await line.set({robot.lamp: 1})
            gateway.reset()
            with pytest.raises(GatewayResetError, match="free has forgotten the write"):
                await line.flush()
            line.delay(0.1)
            with pytest.raises(LateError, match="free was cancelled before the write at"):
                await line.set({robot.lamp: 2})
        await asyncio.sleep(2)
        assert gateway.robot.of("lamp") == []


# Connections


@on_simulated_time
async def test_queued_writes_act_after_a_reconnection() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway, reconnect=True) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        done = await robot.lamp.set(1, at=clock.now().after(5))
        await link.fence()
        cut(link)
        await asyncio.sleep(1)
        assert link.statistics.reconnections == 1
        later = await robot.lamp.set(2, at=done.instant.after(0.1))
        assert (await done, await later) == (done.instant, later.instant)
        assert gateway.robot.of("lamp") == [1, 2]


@on_simulated_time
async def test_an_incomplete_batch_after_a_lost_connection_cancels_the_queue() -> None:
    valve = Valve(gateway := gateway_of())
    async with unity_link.connect(valve, reconnect=True) as link:
        robot = Robot(link)
        clock = await robot.free.clock()
        done = await robot.lamp.set(1, at=clock.now().after(5))
        await link.fence()
        valve.requests_pass = False
        await robot.lamp.set(2, at=clock.now().after(6))
        await asyncio.sleep(0)
        cut(link)
        valve.requests_pass = True
        await asyncio.sleep(1)
        with pytest.raises(LinkLostError, match="words were lost on the way, and free has forgotten") as raised:
            await link.fence()
        assert raised.value.outcome is Outcome.NOT_EXECUTED
        with pytest.raises(LinkLostError, match="words were lost"):
            await done
        await asyncio.sleep(0.001)
        later = await robot.lamp.set(3, at=clock.now().after(1))
        await later
        await asyncio.sleep(10)
        assert gateway.robot.of("lamp") == [3]


# Programs of other APIs than asyncio


def test_fences_of_blocking_programs_raise_for_late_writes() -> None:
    with blocking.connect(gateway_of()) as link:
        robot = put(Robot, link)
        # A second late: on a busy machine the clock is known only to milliseconds.
        robot.lamp.set(30, at=robot.free.clock().now().after(-1))
        with pytest.raises(LateError):
            link.fence()
        link.fence()


def test_fences_under_trio_raise_for_late_writes_and_tasks_wait_together() -> None:
    gateway = gateway_of()

    async def wait_for(done: Any, instants: list[int]) -> None:
        instants.append((await done).ticks)

    async def program() -> None:
        with trio.fail_after(60):
            async with unity_link.connect(gateway) as link:
                robot: Any = Robot(link)
                clock = await robot.free.clock()
                await robot.lamp.set(30, at=clock.now().after(-1))
                with pytest.raises(LateError):
                    await link.fence()
                await link.fence()
                first, instants = clock.now().after(0.5), list[int]()
                async with trio.open_nursery() as nursery:
                    for number in range(8):
                        done = await robot.lamp.set(number, at=first.after(number * 1e-3))
                        nursery.start_soon(wait_for, done, instants)
                assert sorted(instants) == [first.after(number * 1e-3).ticks for number in range(8)]
                done = await robot.lamp.set(1, at=first.after(0.1))
                gateway.reset()
                with pytest.raises(GatewayResetError, match="free has forgotten the write"):
                    await done
                done = await robot.lamp.set(50, at=clock.now().after(0.1))
                assert await done == done.instant

    trio.run(program)
