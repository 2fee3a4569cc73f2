"""Writes at instants, from a program through a link: each acts in its cycle, or an error reports it."""

from __future__ import annotations

import asyncio
import itertools
import random
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, LateError, NotArmedError, blocking
from unity_link.cores.clock import Instant
from unity_link.data.blocking import put
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Value

JOINTS = 18
SPEC = compile_text(f"""
public robot() {{
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=0.1) @(0xC0);
  plan: SCHEDULE(DEPTH=2048) @(0xE0);
  free: SCHEDULE(DEPTH=64) @(0x100);
  joints[{JOINTS}]: joint(drive, plan) @(0x10 + i);
  @lamp = 0x40: unsigned 8 READWRITE(TIMED(free));
  @wide = 0x50: signed 48 READWRITE(SCALE=0.5, MIN=-1000, MAX=1000, TIMED(free));
  @other = 0x60: READWRITE();
}}
joint(LEASE, SCHEDULE): @(at) {{
  @pos = at: signed 32 READWRITE(SCALE=0.001, SAFE(0, LEASE), TIMED(SCHEDULE));
}}
""")
HZ = 50_000_000


class Plant(SimulatedRobot):
    """Records the written values and the cycles in which they act."""

    def start(self) -> None:
        self.seen: list[tuple[int, str, Value]] = []

    def written(self, path: str, value: Value) -> None:
        self.seen.append((self.cores.now, path, value))

    def of(self, path: str) -> list[tuple[int, Value]]:
        return [(cycle, value) for cycle, name, value in self.seen if name == path]


def robot_of(link: Any) -> Any:
    return unity_link.load(SPEC)(link)


@on_simulated_time
async def test_a_signal_is_written_in_the_cycle_of_its_instant() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        clock = await robot.free.clock()
        first = clock.now().after(0.01)
        assert first.ns == round(first.ticks * 1e9 / HZ)
        one = await robot.lamp.set(30, at=first)
        two = await robot.wide.set(-77.5, at=first.after(1e-6))
        assert await robot.lamp.get() == 0
        assert "not known yet" in repr(one)
        assert (await one, await two) == (first, first.after(1e-6))
        assert (await robot.lamp.get(), await robot.wide.get()) == (30, -77.5)
        plant: Any = gateway.robot
        assert plant.of("lamp") == [(first.ticks, 30)]
        assert plant.of("wide") == [(first.ticks + 50, -77.5)]


@on_simulated_time
async def test_a_late_write_does_not_act_and_raises() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        clock = await robot.free.clock()
        late = await robot.lamp.set(30, at=clock.now().after(-0.001))
        with pytest.raises(LateError, match=r"free has not made the write at .* s of the gateway's clock: it came too"):
            await late
        assert await robot.lamp.get() == 0
        # The error of a write that is not awaited is raised by the next write.
        await robot.lamp.set(30, at=clock.now())
        good = await robot.lamp.set(31, at=clock.now().after(0.02))
        assert await good == good.instant
        with pytest.raises(LateError):
            await robot.lamp.set(32, at=clock.now().after(0.02))
        assert await robot.lamp.get() == 31


@on_simulated_time
async def test_wrong_arguments_raise_before_a_request_is_sent() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        now = (await robot.free.clock()).now().after(0.1)
        with pytest.raises(ArgumentError, match="other cannot be written at an instant: its declaration has no TIMED"):
            await robot.other.set(1, at=now)
        with pytest.raises(ArgumentError, match=r"an instant of the gateway's clock was expected, .*, not 0.5"):
            await robot.lamp.set(1, at=0.5)
        with pytest.raises(ArgumentError, match="wide: 2000 is outside of its limits"):
            await robot.wide.set(2000, at=now)
        with pytest.raises(ArgumentError, match="is of another clock: this one has 50000000 Hz"):
            await robot.lamp.set(1, at=Instant(5, 1))
        async with robot.free.timeline() as line:
            with pytest.raises(ArgumentError, match=r"free is fed by another timeline of this link"):
                async with robot.free.timeline():
                    pass
            with pytest.raises(ArgumentError, match="free is fed by a timeline of this link: its `set` takes lamp"):
                await robot.lamp.set(1, at=now)
            with pytest.raises(ArgumentError, match=r"other is not timed by free"):
                await line.set({robot.other: 1})
            with pytest.raises(ArgumentError, match="free was given no values"):
                await line.set({})
            await line.set({robot.lamp: 1})
            with pytest.raises(ArgumentError, match="free writes in the order of the instants"):
                await line.set({robot.lamp: 2})
        with pytest.raises(ArgumentError, match="a timeline is used in its block"):
            await line.set({robot.lamp: 1})
        with pytest.raises(ArgumentError, match="was used before"):
            async with line:
                pass
        plant: Any = gateway.robot
        assert [value for _, value in plant.of("lamp")] == [1]


@on_simulated_time
async def test_a_timeline_waits_for_space_and_counts_the_writes_that_acted() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        async with robot.free.timeline(lead=0.01) as line:
            start = line.instant
            for value in range(200):
                await line.set({robot.lamp: value, robot.wide: value})
                line.delay(1 / 3000)
            assert await line.flush() == 200
            assert await line.flush() == 0
        plant: Any = gateway.robot
        expected = [(start.ticks + round(index * HZ / 3000), index) for index in range(200)]
        assert plant.of("lamp") == plant.of("wide") == expected


@on_simulated_time
async def test_an_error_in_the_block_cancels_the_scheduled_writes() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)

        async def feed() -> None:
            async with robot.free.timeline(lead=0.01) as line:
                for value in range(10):
                    await line.set({robot.lamp: value})
                    line.delay(0.01)
                await asyncio.sleep(0.055)
                raise ZeroDivisionError

        with pytest.raises(ZeroDivisionError):
            await feed()
        await asyncio.sleep(0.2)
        assert [value for _, value in gateway.robot.of("lamp")] == [0, 1, 2, 3, 4]
        # The error does not affect the next timeline.
        async with robot.free.timeline(lead=0.01) as line:
            await line.set({robot.lamp: 99})
            assert await line.flush() == 1


@on_simulated_time
async def test_a_late_write_ends_the_block() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        begun: list[int] = []

        async def feed() -> None:
            async with robot.free.timeline(lead=0.01) as line:
                begun.append(line.instant.ticks)
                for value in range(100):
                    await line.set({robot.lamp: value})
                    line.delay(0.001)
                    await asyncio.sleep(0.03 if value == 20 else 0.001)

        with pytest.raises(LateError) as raised:
            await feed()
        instants = [begun[0] + 50_000 * index for index in range(100)]
        assert raised.value.ticks == instants[21]
        assert [cycle for cycle, _ in gateway.robot.of("lamp")][:21] == instants[:21]
        assert {cycle for cycle, _ in gateway.robot.of("lamp")} <= set(instants)


@pytest.mark.parametrize("seconds", [2, pytest.param(60, marks=pytest.mark.campaign)])
@on_simulated_time
async def test_18_joints_at_1_khz_from_a_program_that_sleeps_are_never_late(seconds: int) -> None:
    gateway = simulated(SPEC.interface(), Plant)
    chance = random.Random(1)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        async with robot.drive.armed() as lease, robot.plan.timeline(lead=0.05, lease=lease) as line:
            start, next_sleep = line.instant, 0
            for row in range(seconds * 1000):
                await line.set({joint.pos: (row + 10 * index) / 1000 for index, joint in enumerate(robot.joints)})
                line.delay(0.001)
                if row >= next_sleep:
                    await asyncio.sleep(chance.uniform(0, 0.05))
                    # The queue holds 97 rows, which last for one sleep but not for three in a row.
                    next_sleep = row + chance.randint(100, 200)
            assert await line.flush() == seconds * 1000
        assert (await robot.plan.late.get(), await robot.plan.refused.get()) == (0, 0)
        assert await robot.plan.slack.get() > 0
    for index in range(JOINTS):
        seen = gateway.robot.of(f"joints[{index}].pos")
        assert [cycle for cycle, _ in seen] == [start.ticks + 50_000 * row for row in range(seconds * 1000)]
        assert [round(float(value) * 1000) for _, value in seen] == [row + 10 * index for row in range(seconds * 1000)]


@on_simulated_time
@pytest.mark.parametrize("then", ["hold", "safe"])
async def test_a_trajectory_is_played_and_then_held_or_made_safe(then: str) -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        times = np.arange(300) / 1000
        paths = {joint.pos: np.sin(times + index) for index, joint in enumerate(robot.joints[:3])}
        async with robot.drive.armed() as lease:
            assert await robot.plan.play(times, paths, then=then, lease=lease) == 300
            assert await robot.drive.armed_.get() is (then == "hold")
            last = round(float(np.sin(times[-1])), 3)
            assert await robot.joints[0].pos.get() == (pytest.approx(last) if then == "hold" else 0)
            if then == "safe":
                await lease.kick()
                await asyncio.sleep(0.01)
                with pytest.raises(NotArmedError, match="it was disarmed"):
                    await lease.kick()
        seen = gateway.robot.of("joints[2].pos")
        assert np.diff([cycle for cycle, _ in seen]).tolist() == [50_000] * 299
        assert [value for _, value in seen] == pytest.approx(np.sin(times + 2), abs=0.0006)


@on_simulated_time
async def test_an_impossible_trajectory_raises_before_a_request_is_sent() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        lamp = {robot.lamp: [1, 2]}
        for times in ([0, 0], [1, 0], [-1, 0], [0, float("nan")], [], [[0, 1]], "soon"):
            with pytest.raises(ArgumentError, match="times are numbers of seconds"):
                await robot.free.play(times, lamp)
        with pytest.raises(ArgumentError, match=r"lamp has values of shape \(2,\), and there are 3 times"):
            await robot.free.play([0, 1, 2], lamp)
        with pytest.raises(ArgumentError, match=r"wide: 1001\.0 is outside of its limits"):
            await robot.free.play([0, 1], {robot.wide: [0, 1001.0]})
        with pytest.raises(ArgumentError, match="then='stop': 'hold' or 'safe' was expected"):
            await robot.free.play([0, 1], lamp, then="stop")
        with pytest.raises(ArgumentError, match="no lease guards the signals of free"):
            await robot.free.play([0, 1], lamp, then="safe")
        assert gateway.robot.of("lamp") == []


@on_simulated_time
async def test_no_scheduled_write_acts_without_its_lease_and_an_error_reports_it() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        clock = await robot.plan.clock()
        done = await robot.joints[0].pos.set(1, at=clock.now().after(0.01))
        with pytest.raises(NotArmedError, match="nobody has armed it since the reset"):
            await done

        # A lease that runs out drops the scheduled writes.
        async def feed() -> None:
            async with robot.drive.armed(timeout=0.05), robot.plan.timeline(lead=0.01) as line:
                for row in range(80):
                    await line.set({robot.joints[0].pos: row})
                    line.delay(0.001)

        with pytest.raises(NotArmedError, match="no kick came before its end"):
            await feed()
        acted = gateway.robot.of("joints[0].pos")
        assert 30 < len(acted) < 60


@on_simulated_time
async def test_writes_of_another_program_to_the_schedule_are_detected() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)

        async def feed() -> None:
            async with robot.free.timeline(lead=0.01) as line:
                for _ in range(2):
                    await link.write(robot["free.entry"].signal.address, 0)
                await line.set({robot.lamp: 1})

        with pytest.raises(ArgumentError, match="another program has written to free"):
            await feed()


@on_simulated_time
async def test_the_clock_is_within_its_stated_bounds() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot = robot_of(link)
        clock = await robot.free.clock()
        assert clock.drift is None
        for _ in range(3):
            await asyncio.sleep(1)
            now = asyncio.get_running_loop().time()
            assert abs(clock.now().ticks - gateway.ticks_at(now)) <= clock.error * HZ + 1
            assert clock.time_of(clock.at(now + 5)) == pytest.approx(now + 5, abs=1e-3)
            clock = await robot.free.clock()
        assert clock.error < 0.001
        assert clock.drift is not None
        drift, unsure = clock.drift
        assert abs(drift) <= unsure + 1e-9
        assert clock.offset == pytest.approx(clock.time_of(Instant(0, HZ)))
        assert "known to" in repr(clock)


SAMPLED = compile_text("""
group state(RATE=100, TIMESTAMPS);
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  free: SCHEDULE(DEPTH=64) @(0x100);
  @lamp = 0x40: unsigned 8 READWRITE(TIMED(free));
  @light = 0x60: READ(PUBLISH(state));
}
""")


@on_simulated_time
async def test_a_write_follows_a_sample_after_an_exact_number_of_cycles() -> None:
    gateway = simulated(SAMPLED.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(SAMPLED)(link)
        clock = await robot.free.clock()
        instants: list[Instant] = []
        async for sample in robot.groups["state"]:
            taken = clock.sampled(sample.time)
            assert abs(clock.now().ticks - taken.ticks) <= HZ // 100
            await robot.lamp.set(len(instants), at=taken.after(0.02))
            instants.append(taken)
            if len(instants) == 100:
                break
        assert {(after.ticks - before.ticks) for before, after in itertools.pairwise(instants)} == {HZ // 100}
        await asyncio.sleep(0.1)
        await link.fence()
        assert [cycle for cycle, _ in gateway.robot.of("lamp")] == [taken.ticks + HZ // 50 for taken in instants]
        with pytest.raises(ArgumentError, match="the time of a sample with a timestamp is a number of seconds"):
            clock.sampled(None)


def test_blocking_programs_write_at_instants() -> None:
    with blocking.connect(simulated(SPEC.interface(), Plant)) as link:
        robot = put(unity_link.load(SPEC), link)
        clock = robot.free.clock()
        done = robot.lamp.set(30, at=clock.now().after(0.05))
        assert done.wait() == done.instant
        with robot.free.timeline(lead=0.05) as line:
            line.set({robot.lamp: 31})
            assert line.flush() == 1
        assert robot.lamp.get() == 31
        assert robot.free.play([0, 0.01], {robot.lamp: [7, 8]}) == 2
