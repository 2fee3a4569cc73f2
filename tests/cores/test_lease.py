"""Leases: a program moves guarded outputs as long as it kicks, and no longer; on simulated time."""

from __future__ import annotations

import asyncio
import functools
import pickle
import re
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.bridge_programs import PROGRAM
from support.searching import examples
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, LinkLostError, NotArmedError
from unity_link.cores.clock import READ_AGAIN, TickBounds
from unity_link.cores.lease import MOST_KICKS, TIME_BITS, LeaseRegisters
from unity_link.data import Group, read_interface
from unity_link.generate.python.model import model_text
from unity_link.link.asked import Asked
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.bus import AccessError
from unity_link.virtual.line import SlowLine
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Spec

TEXT = """
group state(RATE=500, TIMESTAMPS);
group bare(RATE=500);
motor(LEASE): @(at) {
  @value = at: signed 32 READWRITE(SCALE=0.01, UNIT="V", MIN=-12, MAX=12, SAFE(0, LEASE));
  @on = at + 1[0]: bool READWRITE(SAFE(0, LEASE));
  @rest = at + 1[7:1]: unsigned READWRITE(SAFE(5, LEASE));
}
public rover() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=32);
  drive: LEASE(TIMEOUT=0.1) @(0xE0);
  left: motor(drive) @(0x10);
  @lamp = 0x18: READWRITE();
  @position = 0x20: READ(PUBLISH(state));
}
"""
WIDE = TEXT.replace("DATA_BITS=32", "DATA_BITS=64")
TWO = TEXT.replace("  left:", "  arm: LEASE() @(0x100);\n  left:")
HZ = 50_000_000


@functools.cache
def compiled(text: str = TEXT) -> Spec:
    return compile_text(text)


@functools.cache
def loaded(text: str) -> Any:
    return unity_link.load(compiled(text))


class World:
    """A rover behind a gateway, a program's link to it, and a view of the rover that needs no request."""

    def __init__(self, text: str = TEXT) -> None:
        spec = compiled(text)
        self.kind = loaded(text)
        self.gateway = simulated(spec.interface())

    @property
    def ticks(self) -> int:
        return self.gateway.ticks_at(asyncio.get_running_loop().time())

    def seen(self, path: str) -> Any:
        """Return the present value of a signal, without a request."""
        robot = self.gateway.robot
        robot.pass_time(asyncio.get_running_loop().time())
        part: Any = robot
        for name in path.split("."):
            part = getattr(part, name)
        return part


@pytest.mark.parametrize("text", [TEXT, WIDE])
@on_simulated_time
async def test_a_loop_over_samples_keeps_the_lease_until_the_end_of_the_block(text: str) -> None:
    world = World(text)
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.drive.armed(timeout=0.02) as lease:
            count = 0
            async for sample in lease.each(robot.groups["state"]):
                assert sample[robot.position] == 0
                await robot.left.value.set(count / 100)
                count += 1
                if count == 100:
                    break
            assert world.seen("drive.armed")
            assert world.seen("left.value") == pytest.approx(0.99)
        assert not world.seen("drive.armed")
        assert world.seen("left.value") == 0
        assert (world.seen("drive.state"), world.seen("drive.reason")) == (0, 1)


@on_simulated_time
async def test_kicks_from_samples_last_one_time_out_from_their_timestamps() -> None:
    world = World()
    async with unity_link.connect(SlowLine(world.gateway, bytes_per_second=20_000)) as link:
        robot = world.kind(link)
        async with robot.armed(timeout=0.05) as lease:
            last = 0.0
            async for sample in lease.each(robot.groups["state"]):
                assert sample.time is not None
                last = sample.time
                if sample.sequence == 50:
                    break
            await asyncio.sleep(0.2)
            assert world.seen("drive.fault_time") + 1 == round(last * HZ) + round(0.05 * HZ)


@on_simulated_time
async def test_each_signal_is_safe_after_the_lease_until_it_is_written_again() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.armed(timeout=0.02) as lease:
            await robot.left.value.set(3)
            await robot.left.on.set(True)
            await robot.left.rest.set(9)
            armed_at = asyncio.get_running_loop().time()
            await asyncio.sleep(0.0199)
            assert world.seen("left.value") == 3
            await asyncio.sleep(0.0002)
            assert (world.seen("left.value"), world.seen("left.on"), world.seen("left.rest")) == (0, False, 5)
            with pytest.raises(NotArmedError, match="no kick came before its end") as ended:
                await lease.kick()
            assert ended.value.reason == "silence"
            assert ended.value.instant == pytest.approx(armed_at + 0.02, abs=1e-4)
        async with robot.armed():
            assert world.seen("drive.armed")
            assert (world.seen("left.value"), world.seen("left.rest")) == (0, 5)
            await robot.left.rest.set(7)
            assert (world.seen("left.value"), world.seen("left.rest")) == (0, 7)


@on_simulated_time
async def test_half_a_value_written_under_an_earlier_lease_is_discarded() -> None:
    world = World(TEXT.replace("  @lamp", "  @far = 0x30: unsigned 64 READWRITE(SAFE(3, drive));\n  @lamp"))
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.armed():
            await link.write(0x30, 0xFFFF)
        async with robot.armed():
            await link.write(0x31, 1)
            assert world.seen("far") == 1 << 32


async def set_one(robot: Any) -> None:
    await robot.left.value.set(3)


async def set_field(robot: Any) -> None:
    await robot.left.on.set(True)


async def set_group(robot: Any) -> None:
    await Group(robot.lamp, robot.left.value).set([1, 3])


async def set_by_group(robot: Any) -> None:
    await Group(robot.left.on, robot.left.rest).set([True, 3])


@pytest.mark.parametrize("write", [set_one, set_field, set_group, set_by_group])
@on_simulated_time
async def test_a_write_without_an_armed_lease_is_refused_and_not_stored(write: Any) -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        with pytest.raises(BusError, match="drive is not armed: nobody has armed it since the reset") as refused:
            await write(robot)
        assert isinstance(refused.value, NotArmedError)
        assert (refused.value.reason, refused.value.instant, refused.value.code) == ("none_yet", None, 4)
        assert "left." in str(refused.value)
        assert (world.seen("left.value"), world.seen("left.on"), world.seen("left.rest")) == (0, False, 5)
        async with robot.armed():
            assert world.seen("left.value") == 0


@on_simulated_time
async def test_a_bus_error_of_an_armed_signal_is_reported_as_a_bus_error() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        world.gateway.robot.set_fault("left.value")
        async with robot.armed():
            with pytest.raises(BusError) as refused:
                await robot.left.value.set(1)
            assert not isinstance(refused.value, NotArmedError)


@on_simulated_time
async def test_an_open_e_stop_ends_the_block_and_prevents_arming() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)

        async def move() -> None:
            async with robot.armed(timeout=0.02) as lease:
                await robot.left.value.set(3)
                async for sample in lease.each(robot.groups["state"]):
                    if sample.sequence == 2:
                        world.gateway.robot.drive.estop = 0
                        assert world.seen("left.value") == 0
                        assert world.seen("drive.enable") == 0
                    assert sample.sequence < 4

        with pytest.raises(NotArmedError, match=r"its e-stop was opened, at 0\.00") as ended:
            await move()
        assert ended.value.reason == "estop"
        with pytest.raises(NotArmedError, match="cannot be armed: its e-stop is open") as refused:
            async with robot.armed():
                pytest.fail("the block began")
        assert refused.value.reason == "estop"
        world.gateway.robot.drive.estop = 1
        assert world.seen("drive.state") == 2
        async with robot.armed():
            assert (world.seen("drive.state"), world.seen("drive.enable")) == (1, 1)


@on_simulated_time
async def test_any_program_can_disarm_which_ends_the_loop_of_the_owner() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)

        async def move() -> None:
            async with robot.armed(timeout=0.02) as lease:
                async for sample in lease.each(robot.groups["state"]):
                    if sample.sequence == 5:
                        await robot.drive.stop()
                        assert not world.seen("drive.armed")
                    assert sample.sequence < 7

        with pytest.raises(NotArmedError, match="it was disarmed") as ended:
            await move()
        assert (ended.value.reason, ended.value.instant) == ("disarmed", None)
        await robot.drive.stop()


@on_simulated_time
async def test_a_second_block_neither_takes_over_nor_disarms_the_lease() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.armed(timeout=0.05) as lease:
            says = "drive cannot be armed: this program has armed it already, in another block"
            with pytest.raises(NotArmedError, match=says) as refused:
                async with robot.armed():
                    pytest.fail("the block began")
            assert refused.value.reason == "taken"
            assert world.seen("drive.armed")
            await lease.kick()
            await asyncio.sleep(0.045)
            await robot.left.value.set(1)


@on_simulated_time
async def test_an_ended_lease_does_not_affect_the_lease_of_the_next_program() -> None:
    world = World()

    async def stand_still(robot: Any) -> None:
        async with robot.armed(timeout=0.01) as lease:
            await asyncio.sleep(0.03)
            await lease.kick()

    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        standing = asyncio.create_task(stand_still(robot))
        await asyncio.sleep(0.02)
        async with robot.armed(timeout=0.1):
            with pytest.raises(NotArmedError, match="has run out, and another program has armed it since"):
                await standing
            await robot.left.value.set(1)
            assert world.seen("drive.armed")


@on_simulated_time
async def test_write_after_the_time_out_does_not_act_under_another_lease() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.armed(timeout=0.02) as lease:
            await robot.left.value.set(1)
            await asyncio.sleep(0.03)
            other = LeaseRegisters(robot, "drive").arm.signal
            word = 5 << TIME_BITS | (world.ticks + HZ // 10)
            await Asked(link, other.address, write=other.encode(word)).words()
            assert world.seen("drive.armed")
            for write in (robot.left.value.set, robot.left.value.post):
                with pytest.raises(NotArmedError, match=r"drive has ended: no kick came within 0\.02 s") as refused:
                    await write(2)
                assert refused.value.reason == "silence"
            assert world.seen("left.value") == 0
            with pytest.raises(NotArmedError, match="has run out, and another program has armed it since"):
                await lease.kick()
        assert world.seen("drive.armed")


@on_simulated_time
async def test_kick_is_sent_however_late_because_the_gateway_decides() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        async with robot.armed(timeout=0.02) as lease:
            # As if the estimate of the gateway's clock were ahead by the time-out.
            lease._end = 0
            with pytest.raises(NotArmedError, match="no kick came within"):
                await robot.left.value.set(1)
            kick = LeaseRegisters(robot, "drive").kick.signal
            word = lease._token << TIME_BITS | (world.ticks + HZ // 100)
            await Asked(link, kick.address, write=kick.encode(word)).words()
            await lease.kick()
            await robot.left.value.set(1)
            assert world.seen("left.value") == 1


@on_simulated_time
async def test_the_error_of_a_lease_says_that_another_program_has_armed() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)

        async def move() -> None:
            async with robot.armed(timeout=0.1) as lease:
                while True:
                    await lease.kick()
                    await asyncio.sleep(0.01)

        moving = asyncio.create_task(move())
        await asyncio.sleep(0.025)
        assert await robot.drive.stop()
        async with robot.armed(timeout=0.1):
            says = "drive was disarmed, and another program has armed it since"
            with pytest.raises(NotArmedError, match=says) as ended:
                await moving
            assert ended.value.reason == "disarmed"
            assert world.seen("drive.armed")
            assert world.seen("drive.arms") == 2


@pytest.mark.parametrize("latest", [False, True])
@on_simulated_time
async def test_a_loop_slower_than_its_samples_keeps_the_lease_with_latest(latest: bool) -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)

        async def move() -> int:
            last, count = -1, 0
            async with robot.armed(timeout=0.05) as lease:
                async for sample in lease.each(robot.groups["state"], latest=latest):
                    count += 1
                    assert sample.sequence > last
                    last = sample.sequence
                    await asyncio.sleep(0.005)
                    if count == 200:
                        break
            return last

        if latest:
            assert await move() > 400
        else:
            with pytest.raises(NotArmedError, match="no kick came before its end"):
                await move()


@on_simulated_time
async def test_a_gateway_clock_slower_than_stated_ends_no_lease_early() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        lease = robot.armed(timeout=0.05)
        lease._clock = TickBounds(HZ * 10 // 9)
        async with lease:
            async for sample in lease.each(robot.groups["state"]):
                if sample.sequence == 1000:
                    break
            assert world.seen("drive.armed")


def test_an_estimate_of_the_clock_is_corrected_by_a_later_reading() -> None:
    clock = TickBounds(1000)
    clock.read(0, 0.0, 0.0)
    assert clock.least(10.0) > 9900
    clock.read(9000, 9.9, 10.0)
    assert 9000 <= clock.least(10.0) <= clock.most(10.0) <= 9102


@on_simulated_time
async def test_kicks_without_a_pause_wait_for_the_line_and_do_not_queue_up() -> None:
    world = World()
    async with unity_link.connect(SlowLine(world.gateway, bytes_per_second=20_000)) as link:
        robot = world.kind(link)
        async with robot.armed() as lease:
            for _ in range(200):
                await lease.kick()
                assert link.statistics.in_flight <= MOST_KICKS + 1


@pytest.mark.parametrize("seconds", [0, -1, 0.1000001, float("nan"), float("inf"), "soon", None.__class__])
@on_simulated_time
async def test_a_wrong_time_out_is_refused_before_a_request_is_sent(seconds: Any) -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        before = link.statistics.requests
        with pytest.raises(ArgumentError, match=re.escape("above 0, and 0.1 s at most as its spec says")):
            robot.armed(timeout=seconds)
        assert link.statistics.requests == before


@on_simulated_time
async def test_a_robot_with_several_leases_requires_the_name_of_one() -> None:
    world = World(TWO)
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        says = "has 2 leases: call drive.armed() or arm.armed()"
        with pytest.raises(ArgumentError, match=re.escape(says)):
            robot.armed()
        async with robot.arm.armed(), robot.drive.armed():
            assert world.seen("arm.armed")
            assert world.seen("drive.armed")


@on_simulated_time
async def test_a_group_without_timestamps_or_of_another_gateway_is_refused() -> None:
    world, other = World(), World()
    async with unity_link.connect(world.gateway) as link, unity_link.connect(other.gateway) as second:
        robot = world.kind(link)
        async with robot.armed() as lease:
            polled = Group(robot.position, rate_hz=100)
            polled._plan = type(polled._plan)(rate_hz=100, timestamps=False)
            with pytest.raises(ArgumentError, match="a group has no timestamps, which kicks need"):
                await anext(lease.each(polled))
            with pytest.raises(ArgumentError, match="state has signals of another gateway than that of drive"):
                await anext(lease.each(other.kind(second).groups["state"]))


@on_simulated_time
async def test_a_lease_is_used_in_its_block_and_once() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        lease = robot.armed()
        with pytest.raises(ArgumentError, match="a lease is kicked in its block"):
            await lease.kick()
        with pytest.raises(ArgumentError, match="write `async with` before this lease"):
            lease.__enter__()
        assert repr(lease) == "<lease of drive, not begun: 0.098 s>"
        async with lease:
            assert "in its block" in repr(lease)
            with pytest.raises(ArgumentError, match="pickled"):
                pickle.dumps(lease)
        with pytest.raises(ArgumentError, match="was used before"):
            await lease.__aenter__()
        with pytest.raises(ArgumentError, match="in its block"):
            await anext(lease.each(robot.groups["state"]))


@on_simulated_time
async def test_a_signal_with_the_name_of_a_core_method_has_an_underscore() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        assert robot.drive.armed_ is robot["drive.armed"]
        armed: Any = robot.drive.armed_
        assert await armed.get() is False


@on_simulated_time
async def test_an_error_in_the_block_and_a_cancellation_disarm_at_once() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)

        async def move() -> None:
            async with robot.armed():
                await robot.left.value.set(3)
                await asyncio.sleep(10)

        async def fail() -> None:
            async with robot.armed():
                await robot.left.value.set(3)
                _ = 1 / 0

        with pytest.raises(ZeroDivisionError):
            await fail()
        assert (world.seen("drive.armed"), world.seen("drive.reason")) == (False, 1)
        task = asyncio.create_task(move())
        await asyncio.sleep(0.01)
        assert world.seen("left.value") == 3
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert (world.seen("drive.armed"), world.seen("drive.reason")) == (False, 1)


@on_simulated_time
async def test_a_second_cancellation_leaves_a_lease_armed_until_its_time_out() -> None:
    world = World()
    async with unity_link.connect(SlowLine(world.gateway, bytes_per_second=20_000)) as link:
        robot = world.kind(link)

        async def move(others: asyncio.TaskGroup) -> None:
            async with robot.armed():
                await robot.left.value.set(3)
                for _ in range(100):
                    others.create_task(robot.lamp.set(1))
                moving.set()
                await asyncio.sleep(10)

        moving = asyncio.Event()
        async with asyncio.TaskGroup() as others:
            task = asyncio.create_task(move(others))
            await moving.wait()
            task.cancel()
            # The write that disarms waits after the other requests.
            await asyncio.sleep(0)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task
            assert world.seen("drive.armed")
            await asyncio.sleep(0.1)
            assert (world.seen("drive.armed"), world.seen("left.value")) == (False, 0)


@on_simulated_time
async def test_the_first_error_is_raised_if_the_link_is_lost_under_a_lease() -> None:
    world = World()

    async def move() -> None:
        async with unity_link.connect(world.gateway) as link:
            robot = world.kind(link)
            async with robot.armed(timeout=0.05):
                await robot.left.value.set(3)
                await link.aclose()
                await robot.left.value.set(4)

    with pytest.raises(LinkLostError) as lost:
        await move()
    assert "it runs out by itself, 0.05 s after the last kick" in lost.value.__notes__[0]
    assert world.seen("left.value") == 3
    await asyncio.sleep(0.051)
    assert (world.seen("left.value"), world.seen("drive.reason")) == (0, 2)


@on_simulated_time
async def test_the_fence_raises_for_posted_writes_without_a_lease() -> None:
    world = World()
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        await robot.left.value.post(3)
        never = "posted write of left.value at 0x010: the bus refused the access: drive is not armed: nobody has"
        with pytest.raises(NotArmedError, match=re.escape(never)) as refused:
            async with robot.armed():
                pytest.fail("the block began before the error of the posted write was raised")
        assert refused.value.reason == "none_yet"
        assert not world.seen("drive.armed")
        await link.post(0x10, 3)
        await robot.left.value.post(4)
        await robot.left.value.post(5)
        with pytest.raises(NotArmedError, match=re.escape(never)) as refused:
            await link.fence()
        assert refused.value.__notes__ == ["2 more posted writes failed as well"]


@on_simulated_time
async def test_a_reset_disarms_and_ends_the_block() -> None:
    world = World()

    async def move() -> None:
        async with unity_link.connect(world.gateway) as link:
            robot = world.kind(link)
            async with robot.armed() as lease:
                await robot.left.value.set(3)
                world.gateway.reset()
                assert (world.seen("left.value"), world.seen("drive.state"), world.seen("drive.reason")) == (0, 0, 0)
                for _ in range(5):
                    await asyncio.sleep(0.05)
                    await lease.kick()

    says = r"drive has ended: the link has begun another session since it was armed \(the gateway was reset\)"
    with pytest.raises(NotArmedError, match=says) as ended:
        await move()
    assert ended.value.reason == "reset"


@on_simulated_time
async def test_kicks_continue_after_the_clock_is_read_again() -> None:
    world = World()
    async with unity_link.connect(SlowLine(world.gateway, bytes_per_second=100_000)) as link:
        robot = world.kind(link)
        async with robot.armed() as lease:
            for _ in range(int(3 * READ_AGAIN / 0.05)):
                await lease.kick()
                await asyncio.sleep(0.05)
            assert world.seen("drive.armed")


# Random sequences of events

END = st.integers(-5, 8_000_000)
STEPS = st.one_of(
    st.tuples(st.just("arm"), st.integers(0, 2), END),
    st.tuples(st.just("kick"), st.integers(0, 2), END),
    st.tuples(st.just("wait"), st.integers(0, 6_000_000), st.none()),
    st.tuples(st.just("disarm"), st.none(), st.none()),
    st.tuples(st.just("estop"), st.booleans(), st.none()),
    st.tuples(st.just("write"), st.integers(-100, 100), st.none()),
    st.tuples(st.just("reset"), st.none(), st.none()),
)


class Contract:
    """The rules of a lease: its owner, the end of its time, and the resulting value of the output."""

    def __init__(self) -> None:
        self.owner: int | None = None
        self.arms = 0
        self.end = 0
        self.output = 0
        self.closed = True

    def pass_to(self, now: int) -> None:
        if self.owner is not None and now >= self.end:
            self.fall()

    def fall(self) -> None:
        self.owner, self.output = None, 0

    def word(self, now: int, token: int, end: int, *, is_arm: bool) -> None:
        # Writing a word takes two cycles, in which the lease may end.
        if self.owner is not None and now + 1 >= self.end:
            self.fall()
        may = token == self.owner or (is_arm and self.owner is None)
        if may and self.closed and 3 <= end - now <= 5_000_000 and (self.owner is None or end > self.end):
            self.arms += self.owner is None
            self.owner, self.end = token, end


class Story:
    """A rover and the rules of its lease; both process the same events."""

    def __init__(self) -> None:
        self.world, self.contract = World(), Contract()
        self.robot: Any = self.world.gateway.robot
        self.world.gateway.advance(asyncio.get_running_loop().time())

    async def happen(self, what: str, first: Any, end: Any) -> None:
        now, contract = self.world.ticks, self.contract
        contract.pass_to(now)
        if what in {"arm", "kick"}:
            self._write(f"drive.{what}", first << 40 | (now + end) % (1 << 40))
            contract.word(now, first, now + end, is_arm=what == "arm")
        elif what == "wait":
            await asyncio.sleep(first / HZ)
        elif what == "write":
            assert self._stores(first) == (contract.owner is not None)
            contract.output = first if contract.owner is not None else 0
        else:
            self._break_off(what, first)
        contract.pass_to(self.world.ticks)

    def _break_off(self, what: str, closed: Any) -> None:
        if what == "disarm":
            self._write("drive.disarm", 1)
        elif what == "estop":
            self.robot.drive.estop = int(closed)
            self.contract.closed = closed
        else:
            self.world.gateway.reset()
            self.world.gateway.advance(asyncio.get_running_loop().time())
            self.contract.arms = 0
        if not (what == "estop" and closed):
            self.contract.fall()

    def _stores(self, value: int) -> bool:
        try:
            self._write("left.value", value & 0xFFFFFFFF)
        except AccessError:
            return False
        return True

    def _write(self, path: str, value: int) -> None:
        signal = self.robot.interface.signals[path]
        for part, address in enumerate(signal.addresses):
            self.robot.write(address, value >> 32 * part & 0xFFFFFFFF, asyncio.get_running_loop().time())


@given(st.lists(STEPS, max_size=40))
@settings(max_examples=examples(100))
@on_simulated_time
async def test_no_sequence_of_events_extends_a_lease_beyond_its_last_valid_kick(
    steps: list[tuple[str, Any, Any]],
) -> None:
    story = Story()
    for step in steps:
        await story.happen(*step)
        assert story.world.seen("drive.armed") == (story.contract.owner is not None)
        assert round(story.world.seen("left.value") * 100) == story.contract.output
        assert story.world.seen("drive.arms") == story.contract.arms


@given(
    st.lists(st.floats(0.0001, 0.09), min_size=1, max_size=30),
    st.sampled_from([0.01, 0.05, 0.1]),
    st.sampled_from([None, 20_000.0, 300_000.0]),
)
@settings(max_examples=examples(60))
@on_simulated_time
async def test_a_stopped_program_is_never_armed_beyond_its_time_out(
    pauses: list[float], seconds: float, pace: float | None
) -> None:
    world = World()
    loop = asyncio.get_running_loop()
    gateway = world.gateway if pace is None else SlowLine(world.gateway, bytes_per_second=pace)
    made = 0.0

    async def move(robot: Any) -> None:
        nonlocal made
        async with robot.armed(timeout=seconds) as lease:
            for pause in pauses:
                made = loop.time()
                await lease.kick()
                await asyncio.sleep(pause)
                # No kick that was made then lasts longer, however late it arrived.
                assert not world.seen("drive.armed") or loop.time() < made + seconds
                await robot.left.value.set(1)

    async with unity_link.connect(gateway) as link:
        reasons = {"none"}
        try:
            await move(world.kind(link))
        except NotArmedError as error:
            reasons = {error.reason, world.seen("drive.reason")}
        # Short pauses on a quick line never end the lease.
        assert reasons <= {"none", "silence", "late", 0, 2}
        assert "none" in reasons or max(pauses) > seconds / 4 or pace == 20_000
        assert world.seen("left.value") == 0


class Plant(SimulatedRobot):
    """Moves a position by the motor's value."""

    def start(self) -> None:
        self.moved = 0.0

    def step(self, dt: float) -> None:
        self.moved += self.left.value * dt
        self.position = int(self.moved * 1000)


@on_simulated_time
async def test_a_plant_reads_safe_values_from_the_step_of_the_end_on() -> None:
    spec = compiled()
    gateway = simulated(spec.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(spec)(link)
        async with robot.armed(timeout=0.1):
            await robot.left.value.set(10)
            began = asyncio.get_running_loop().time()
            await asyncio.sleep(1)
            assert gateway.robot.moved == pytest.approx(10 * (began + 0.1 - began), abs=0.03)


@pytest.mark.slow
def test_a_generated_module_with_a_lease_passes_the_type_checker(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(
        "group state(RATE=100, TIMESTAMPS);\n"
        "public rover() { GATEWAY(ADDRESS_BITS=12); drive: LEASE() @(0xE0);\n"
        "  @speed = 0x10: READWRITE(SAFE(0, drive)); @position = 0x20: READ(PUBLISH(state)); }\n"
    )
    subprocess.run([PROGRAM, "generate", "python", str(spec), "-o", str(tmp_path)], check=True)
    (tmp_path / "main.py").write_text("""
from unity_link import Link
from rover import Rover

async def main(link: Link) -> None:
    robot = Rover(link)
    async with robot.drive.armed(timeout=0.02) as lease, robot.armed() as other:
        await other.kick()
        async for sample in lease.each(robot.groups["state"]):
            await robot.speed.set(sample[robot.position])
    was_armed: bool = await robot.drive.stop()
    print(was_armed, await robot.drive.armed_.get())
""")
    options = ["--strict", "--config-file=", f"--cache-dir={Path(__file__).parents[2] / '.mypy_cache'}"]
    command = [sys.executable, "-m", "mypy", *options, "main.py"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_a_generated_module_has_the_core_information_of_the_spec() -> None:
    interface = compiled().interface()
    read = read_interface(model_text(interface))
    assert [component.core for component in read.cores] == [component.core for component in interface.cores]


@on_simulated_time
async def test_an_observing_program_receives_each_change_of_a_lease_with_its_time() -> None:
    text = TEXT.replace("LEASE(TIMEOUT=0.1)", "LEASE(TIMEOUT=0.1, GROUP=safety)").replace(
        "group bare", "group safety(RATE=200, ON_CHANGE, TIMESTAMPS);\ngroup bare"
    )
    world = World(text)
    async with unity_link.connect(world.gateway) as link:
        robot = world.kind(link)
        drive, seen = robot.drive, []
        async with robot.groups["safety"].subscribe() as samples:
            async with robot.armed(timeout=0.02):
                await asyncio.sleep(0.01)
            await asyncio.sleep(0.01)
            async with robot.armed(timeout=0.02):
                await asyncio.sleep(0.05)
            async for sample in samples:
                seen.append((sample[drive.state].name, sample[drive.reason].name))
                if seen[-1][0] == "fault":
                    break
        assert seen[-4:] == [
            ("armed", "none_yet"),
            ("disarmed", "disarmed"),
            ("armed", "disarmed"),
            ("fault", "silence"),
        ]
        assert sample[drive.fault_time] == await drive.fault_time.get() > 0
        assert sample.time is not None
        assert sample.time == pytest.approx(sample[drive.fault_time] / HZ, abs=0.01)
