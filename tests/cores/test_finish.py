"""Leases whose owner lets scheduled writes run out after silence, on `sim:` and on compiled gateware."""

from __future__ import annotations

import asyncio
import re
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.bridge_programs import PROGRAM, line_of, seen_until_disarmed
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, NotArmedError, blocking
from unity_link.data.blocking import put
from unity_link.spec import compile_text
from unity_link.virtual.build import simulate, simulated

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.cores.clock import Instant

HZ = 500_000
SPEC = """\
public robot() {
  drive: LEASE(TIMEOUT=0.1, FINISH=0.3) @(0x80, enable="gp8", estop="gp9");
  plan: SCHEDULE(DEPTH=512) @(0xA0);
  @duty = 0x10: signed 16 READWRITE(SAFE(-1, drive), TIMED(plan));
  @lamp = 0x11: signed 16 READWRITE(SAFE(-1, drive));
  @free = 0x12: signed 16 READWRITE();
}
"""
on_both = pytest.mark.parametrize("rtl", [False, pytest.param(True, marks=pytest.mark.rtl)], ids=["sim", "rtl"])


class World:
    """A robot and its gateway."""

    def __init__(self, path: Path, *, rtl: bool) -> None:
        spec = path / "robot.ul"
        spec.write_text(SPEC)
        self.gateway = simulate(spec, rtl=rtl, clock_hz=HZ)
        self.load = unity_link.load(spec)
        self.is_rtl = rtl

    def open_estop(self) -> None:
        if self.is_rtl:
            self.gateway.ports["drive_estop"].drive(0)
        else:
            self.gateway.robot.drive.estop = 0

    def close_estop(self) -> None:
        if self.is_rtl:
            self.gateway.ports["drive_estop"].drive(1)


@pytest.fixture
def world(rtl: bool, tmp_path: Path) -> World:
    made = World(tmp_path, rtl=rtl)
    made.close_estop()
    return made


async def schedule(robot: Any, rows: int, every: float) -> Instant:
    """Schedule rows 1, 2, ... from 10 ms ahead; return the instant of the last row."""
    clock = await robot.plan.clock()
    first = clock.now().after(0.01)
    instants: list[Instant] = [first.after(row * every) for row in range(rows)]
    for row, instant in enumerate(instants, 1):
        await robot.duty.set(row, at=instant)
    return instants[-1]


async def state(robot: Any) -> tuple[str, str]:
    return (await robot.drive.state.get()).name, (await robot.drive.reason.get()).name


async def seen_until_safe(robot: Any, seconds: float = 1.0) -> list[int]:
    """Return the successive values of the output, up to the first safe one."""
    seen: list[int] = []
    for _ in range(round(seconds / 0.001)):
        value = await robot.duty.get()
        seen += [value] if value not in seen[-1:] else []
        if value == -1:
            return seen
        await asyncio.sleep(0.001)
    pytest.fail(f"the output is never safe: {seen}")


@pytest.mark.slow
@on_both
@on_simulated_time
async def test_scheduled_writes_run_out_and_outputs_are_safe_after_the_last_one(world: World) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)
        async with robot.armed(timeout=0.05, on_silence="finish"):
            await robot.lamp.set(7)
            if world.is_rtl:
                world.gateway.ports["duty_written"].take_counts()
            last = await schedule(robot, rows=20, every=0.01)
            await asyncio.sleep(0.08)
            assert await state(robot) == ("finishing", "none_yet")
            assert (await robot.drive.armed_.get(), await robot.lamp.get()) == (True, 7)
            seen = await seen_until_safe(robot)
            # The last value acts for two cycles.
            assert seen[:-1] == [*range(seen[0], len(seen) - 1 + seen[0])]
            assert seen[0] < 11
            assert seen[-2] in {19, 20}
            if world.is_rtl:
                assert world.gateway.ports["duty_written"].take_counts()[0].high == 20
            assert await robot.drive.fault_time.get() == last.ticks
            assert await state(robot) == ("fault", "silence")
            assert (await robot.lamp.get(), await robot.plan.refused.get(), await robot.plan.late.get()) == (-1, 0, 0)


@pytest.mark.slow
@on_both
@on_simulated_time
async def test_scheduled_writes_run_out_for_at_most_finish_seconds(world: World) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)
        lease = robot.armed(timeout=0.05, on_silence="finish")
        async with lease:
            await schedule(robot, rows=60, every=0.01)
            await asyncio.sleep(0.03)
            assert len(await seen_until_safe(robot)) > 25
            assert await robot.drive.fault_time.get() + 1 == lease._end + round(0.3 * HZ)
            await asyncio.sleep(0.5)
            assert await robot.duty.get() == -1
            assert await robot.plan.refused.get() > 20
        with pytest.raises(NotArmedError):
            await link.fence()


@on_both
@on_simulated_time
async def test_new_requests_are_refused_while_scheduled_writes_run_out(world: World) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)
        async with robot.armed(timeout=0.05, on_silence="finish") as lease:
            last = await schedule(robot, rows=20, every=0.01)
            await asyncio.sleep(0.08)
            for write in (robot.lamp.set(3), robot.duty.set(3), robot.duty.set(100, at=last.after(0.01))):
                with pytest.raises(NotArmedError, match=r"no kick came within 0\.05 s, and writes that") as refused:
                    await write
                assert refused.value.reason == "silence"
            await robot.free.set(3)
            with pytest.raises(NotArmedError, match=r"this program has armed it already, .* are being executed"):
                async with robot.armed():
                    pytest.fail("the block began")
            with pytest.raises(NotArmedError, match="drive is finishing"):
                await lease.kick()
            assert max(await seen_until_safe(robot)) in {19, 20}
        async with robot.armed(timeout=0.05, on_silence="finish"):
            assert await state(robot) == ("armed", "silence")
            assert (await robot.duty.get(), await robot.lamp.get()) == (-1, -1)


@on_both
@pytest.mark.parametrize("way", ["e-stop", "disarm", "cancel"])
@on_simulated_time
async def test_an_e_stop_a_disarm_or_a_cancel_ends_the_finish_at_once(world: World, way: str) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)
        async with robot.armed(timeout=0.05, on_silence="finish"):
            last = await schedule(robot, rows=30, every=0.01)
            await asyncio.sleep(0.08)
            assert (await state(robot))[0] == "finishing"
            if way == "e-stop":
                world.open_estop()
            else:
                await (robot.drive.stop() if way == "disarm" else robot.plan.cancel.set(1))
            await asyncio.sleep(0.001)
            assert await robot.duty.get() == -1
            reasons = {"e-stop": ("fault", "estop"), "disarm": ("disarmed", "disarmed"), "cancel": ("fault", "silence")}
            assert await state(robot) == reasons[way]
            assert await robot.drive.clock.get() < last.ticks
            await asyncio.sleep(0.4)
        with pytest.raises(NotArmedError):
            await link.fence()


@on_both
@pytest.mark.parametrize("on_silence", ["finish", "safe"])
@on_simulated_time
async def test_a_lease_without_scheduled_writes_ends_at_its_time_out(world: World, on_silence: str) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)
        lease = robot.armed(timeout=0.05, on_silence=on_silence)
        async with lease:
            if on_silence == "safe":
                await schedule(robot, rows=20, every=0.01)
            await asyncio.sleep(0.06)
            assert await state(robot) == ("fault", "silence")
            assert await robot.drive.fault_time.get() + 1 == lease._end
        if on_silence == "safe":
            with pytest.raises(NotArmedError):
                await link.fence()


@on_both
@on_simulated_time
async def test_leaving_the_block_during_the_finish_disarms(world: World) -> None:
    async with unity_link.connect(world.gateway) as link:
        robot: Any = world.load(link)

        async def fail() -> None:
            async with robot.armed(timeout=0.05, on_silence="finish"):
                await schedule(robot, rows=30, every=0.01)
                await asyncio.sleep(0.08)
                raise ArithmeticError

        with pytest.raises(ArithmeticError):
            await fail()
        assert await state(robot) == ("disarmed", "disarmed")
        assert await robot.duty.get() == -1
        await asyncio.sleep(0.4)
        with pytest.raises(NotArmedError):
            await link.fence()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("FINISH=0.3", "FINISH=0"), "drive does not finish scheduled writes: its spec has no FINISH"),
        ((", TIMED(plan)", ""), "drive has nothing to finish: no signal that it guards is TIMED"),
        (None, "on_silence='finnish': 'safe' or 'finish' was expected"),
    ],
)
@on_simulated_time
async def test_an_impossible_on_silence_is_refused_before_a_request_is_sent(change: Any, says: str) -> None:
    spec = compile_text(SPEC.replace(*change) if change else SPEC)
    async with unity_link.connect(simulated(spec.interface())) as link:
        robot: Any = unity_link.load(spec)(link)
        before = link.statistics.requests
        with pytest.raises(ArgumentError, match=re.escape(says)):
            robot.armed(on_silence="finish" if change else "finnish")
        assert link.statistics.requests == before


@on_simulated_time
async def test_an_arm_word_with_finish_is_refused_if_the_spec_has_no_finish(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(SPEC.replace(", FINISH=0.3", ""))
    async with unity_link.connect(simulate(spec, clock_hz=HZ)) as link:
        robot: Any = unity_link.load(spec)(link)
        for choice, armed in ((1, False), (0, True)):
            now = await robot.drive.clock.get()
            await robot.drive.arm.set(choice << 63 | 5 << 40 | now + HZ // 20)
            assert await robot.drive.armed_.get() is armed


PLAY = """
import sys
import unity_link
from unity_link import blocking
from unity_link.data.blocking import put

url, spec = sys.argv[1:]
with blocking.connect(url) as link:
    robot = put(unity_link.load(spec), link)
    with robot.armed(on_silence="finish") as lease:
        start = robot.plan.clock().now()
        for row in range(1, 21):
            robot.duty.set(row, at=start.after(0.3 + row / 10))
        lease.kick()
        # A call that waits for its answer sends all that was put in before: 4 words each, one is being read.
        assert robot.plan.room.get() <= 512 - 19 * 4
        print("moving", flush=True)
        input()
"""


@pytest.mark.slow
@pytest.mark.parametrize("way", ["kill", "hang"])
def test_scheduled_writes_of_a_program_killed_behind_a_server_run_out(way: str, tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(SPEC.replace("TIMEOUT=0.1, FINISH=0.3", "TIMEOUT=1, FINISH=20"))
    command = [PROGRAM, "serve", f"sim:{spec}", "--unix", str(tmp_path / "gateway")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        try:
            url = line_of(server)
            program = subprocess.Popen(
                [sys.executable, "-c", PLAY, url, str(spec)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
            with blocking.connect(url) as link, program:
                robot = put(unity_link.load(spec), link)
                assert line_of(program) == "moving"
                if way == "kill":
                    program.kill()
                seen = seen_until_disarmed(robot)
                assert max(seen) in {19, 20}
                assert robot.duty.get() == -1
                assert robot.drive.reason.get().name == "silence"
                assert robot.plan.refused.get() == robot.plan.late.get() == 0
                program.kill()
        finally:
            server.kill()
