"""Writes at instants on the compiled gateware, where each is at a port in the cycle that was asked for."""

from __future__ import annotations

import asyncio
import random
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import LateError, NotArmedError
from unity_link.virtual.build import simulate

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.virtual.rtl.ports import Port

JOINTS = 18
SPEC = f"""\
public robot() {{
  drive: LEASE(TIMEOUT=0.1) @(0xC0, enable=none, estop=none);
  plan: SCHEDULE(DEPTH=2048) @(0xE0);
  joints[{JOINTS}]: joint(drive, plan) @(0x10 + i);
  @lamp = 0x40: unsigned 8 READWRITE(PIN="led", TIMED(plan));
  @wide = 0x50: signed 40 READWRITE(TIMED(plan));
}}
joint(LEASE, SCHEDULE): @(at) {{
  @pos = at: signed 32 READWRITE(SCALE=0.001, SAFE(0, LEASE), TIMED(SCHEDULE));
}}
"""


class Robot:
    """The compiled robot, and its ports in each cycle."""

    def __init__(self, path: Path) -> None:
        spec = path / "robot.ul"
        spec.write_text(SPEC)
        self.gateway = simulate(spec, rtl=True, clock_hz=500_000)
        self.spec = unity_link.load(spec)
        self.bare: Any = self.gateway._gateway

    @property
    def ports(self) -> dict[str, Port]:
        return dict(self.gateway.ports)

    def changes(self, names: list[str], cycles: int) -> list[tuple[int, tuple[int, ...]]]:
        """Run so many cycles, and return those in which ports have changed, with what they are then."""
        found, before = [], tuple(self.ports[name].value for name in names)
        ports = [self.ports[name] for name in names]
        for _ in range(cycles):
            self.bare.run(1)
            now = tuple(port.value for port in ports)
            if now != before:
                found.append((self.bare.cycles, now))
            before = now
        return found


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    return Robot(tmp_path)


@pytest.mark.rtl
@on_simulated_time
async def test_all_words_of_an_instant_are_there_in_its_cycle(robot: Robot) -> None:
    async with unity_link.connect(robot.gateway) as link:
        machine: Any = robot.spec(link)
        async with machine.drive.armed():
            clock = await machine.plan.clock()
            first = clock.now().after(0.02)
            instants = [first, first.after(40 / clock.clock_hz), first.after(61 / clock.clock_hz)]
            async with machine.plan.timeline() as line:
                for number, instant in enumerate(instants, 1):
                    values = {machine.lamp: number, machine.wide: number << 33 | number, machine.joints[3].pos: number}
                    await line.set(values, at=instant)
                await machine.lamp.get()
                seen = robot.changes(["lamp", "wide", "joints_3_pos"], round(0.03 * clock.clock_hz))
            await asyncio.sleep(0.03)
            late = await machine.lamp.set(99, at=clock.now().after(-0.01))
            with pytest.raises(LateError):
                await late
            assert await machine.lamp.get() == 3
    assert seen == [
        (instant.ticks, (number, number << 33 | number, 1000 * number)) for number, instant in enumerate(instants, 1)
    ]


@pytest.mark.rtl
@on_simulated_time
async def test_what_waits_when_the_lease_ends_does_not_act(robot: Robot) -> None:
    async with unity_link.connect(robot.gateway) as link:
        machine: Any = robot.spec(link)

        async def feed() -> None:
            async with machine.drive.armed(timeout=0.05), machine.plan.timeline(lead=0.02) as line:
                for row in range(1, 80):
                    await line.set({machine.joints[0].pos: row, machine.lamp: row})
                    line.delay(0.001)

        with pytest.raises(NotArmedError, match="no kick came before its end"):
            await feed()
        assert await machine.joints[0].pos.get() == 0
        assert 15 < await machine.lamp.get() < 50


@pytest.mark.rtl
@on_simulated_time
async def test_eighteen_joints_at_a_kilohertz_from_a_program_that_sleeps_are_never_late(robot: Robot) -> None:
    chance, rows = random.Random(2), 500
    async with unity_link.connect(robot.gateway) as link:
        machine: Any = robot.spec(link)
        ports = [robot.ports[f"joints_{index}_pos_written"] for index in range(JOINTS)]
        async with machine.drive.armed() as lease, machine.plan.timeline(lead=0.05, lease=lease) as line:
            for port in ports:
                port.take_counts()
            for row in range(rows):
                await line.set({joint.pos: (row + index) / 1000 for index, joint in enumerate(machine.joints)})
                line.delay(0.001)
                if chance.random() < 0.03:
                    await asyncio.sleep(chance.uniform(0, 0.05))
            assert await line.flush() == rows
            assert [port.take_counts()[0].high for port in ports] == [rows] * JOINTS
            assert [await joint.pos.get() for joint in machine.joints[::5]] == [0.499, 0.504, 0.509, 0.514]
        assert (await machine.plan.late.get(), await machine.plan.refused.get()) == (0, 0)
