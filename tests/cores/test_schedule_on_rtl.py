"""Writes at instants on the compiled gateware: each is at its port in the requested cycle."""

from __future__ import annotations

import asyncio
import contextlib
import random
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import LateError, NotArmedError
from unity_link.virtual.build import simulate
from unity_link.virtual.ft232h.bus import LoopClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.ft232h.rtl_board import RtlBoard

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
  @other = 0x60: unsigned 32 READWRITE();
}}
joint(LEASE, SCHEDULE): @(at) {{
  @pos = at: signed 32 READWRITE(SCALE=0.001, SAFE(0, LEASE), TIMED(SCHEDULE));
}}
"""


class Robot:
    """The compiled robot, and its ports in each cycle."""

    def __init__(self, path: Path, clock_hz: int = 500_000) -> None:
        spec = path / "robot.ul"
        spec.write_text(SPEC)
        self.gateway = simulate(spec, rtl=True, clock_hz=clock_hz)
        self.spec = unity_link.load(spec)
        self.bare: Any = self.gateway._gateway

    @property
    def ports(self) -> dict[str, Port]:
        return dict(self.gateway.ports)

    def changes(self, names: list[str], cycles: int) -> list[tuple[int, tuple[int, ...]]]:
        """Run a number of cycles; return the cycles in which ports have changed, with the new values."""
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
async def test_all_words_of_an_instant_act_in_its_cycle(robot: Robot) -> None:
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
async def test_scheduled_writes_do_not_act_after_the_lease_has_ended(robot: Robot) -> None:
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
@pytest.mark.parametrize(
    "rows", [500, *(pytest.param(rows, marks=pytest.mark.campaign) for rows in (60_000, 3_600_000))]
)
@on_simulated_time
async def test_18_joints_at_1_khz_from_a_program_that_sleeps_are_never_late(robot: Robot, rows: int) -> None:
    chance, next_sleep = random.Random(2), 0
    async with unity_link.connect(robot.gateway) as link:
        machine: Any = robot.spec(link)
        ports = [robot.ports[f"joints_{index}_pos_written"] for index in range(JOINTS)]
        async with machine.drive.armed() as lease, machine.plan.timeline(lead=0.05, lease=lease) as line:
            for port in ports:
                port.take_counts()
            for row in range(rows):
                await line.set({joint.pos: (row + index) / 1000 for index, joint in enumerate(machine.joints)})
                line.delay(0.001)
                if row >= next_sleep:
                    await asyncio.sleep(chance.uniform(0, 0.05))
                    # The queue holds 97 rows, which last for one sleep but not for three in a row.
                    next_sleep = row + chance.randint(100, 200)
            assert await line.flush() == rows
            assert [port.take_counts()[0].high for port in ports] == [rows] * JOINTS
            assert [await joint.pos.get() for joint in machine.joints[::5]] == [
                pytest.approx((rows - 1 + index) / 1000) for index in (0, 5, 10, 15)
            ]
        assert (await machine.plan.late.get(), await machine.plan.refused.get()) == (0, 0)


class Joints:
    """Joints of a compiled robot, and their values in each cycle in which they are written."""

    def __init__(self, robot: Robot) -> None:
        self.seen: list[tuple[int, tuple[int, ...]]] = []
        self._cycles = robot.bare
        self._places = [robot.ports[f"joints_{index}_pos"] for index in range(JOINTS)]
        self._written = [robot.ports[f"joints_{index}_pos_written"] for index in range(JOINTS)]
        self.pulses()
        robot.bare.watch(self._note, self._written[0])

    def _note(self) -> None:
        self.seen.append((self._cycles.cycles, tuple(place.value for place in self._places)))

    def pulses(self) -> list[int]:
        """Return the number of cycles in which each joint was written, since the last call."""
        return [port.take_counts()[0].high for port in self._written]


async def ask_on(link: unity_link.Link, machine: Any) -> None:
    """Keep the bus busy."""
    while True:
        await asyncio.gather(link.read_block(0x10, JOINTS), machine.other.post(1), machine.other.get())


async def feed(machine: Any, rows: int, seconds: float, chance: random.Random) -> tuple[dict[int, int], int]:
    """Write rows of all joints some 20 ms before their instants, from a program that at times sleeps too long.

    Returns:
        the number of each row by its instant, and the number of times that a late row ended the timeline.
    """
    asked: dict[int, int] = {}
    times_late = number = 0
    clock = await machine.plan.clock()
    while number < rows:
        with contextlib.suppress(LateError):
            times_late += 1
            async with machine.drive.armed() as lease, machine.plan.timeline(lead=0.02, lease=lease) as line:
                while number < rows:
                    number += 1
                    asked[line.instant.ticks] = number
                    await line.set({joint.pos: (number + index) / 1000 for index, joint in enumerate(machine.joints)})
                    line.delay(seconds * chance.choice([1, 1, 1, 2]))
                    ahead = (line.instant.ticks - clock.now().ticks) / clock.clock_hz
                    await asyncio.sleep(max(0, ahead - 0.02))
                    if chance.random() < 0.01:
                        await asyncio.sleep(chance.choice([0.003, 0.01, 0.03]))
                await line.flush()
            times_late -= 1
    return asked, times_late


@pytest.mark.rtl
@pytest.mark.parametrize(
    ("bytes_per_second", "clock_hz", "writes_per_second", "rows"),
    [
        (250_000, 500_000, 15_000, 500),
        pytest.param(1_000_000, 2_000_000, 50_000, 1_000_000 // JOINTS, marks=pytest.mark.campaign),
        # As on a line of 3 Mbaud.
        pytest.param(300_000, 500_000, 9_000, 100_000 // JOINTS, marks=pytest.mark.campaign),
    ],
)
@on_simulated_time
async def test_each_write_on_a_busy_bus_acts_in_its_cycle_or_is_counted_late(
    bytes_per_second: float, clock_hz: int, writes_per_second: float, rows: int, tmp_path: Path
) -> None:
    robot = Robot(tmp_path, clock_hz)
    device = VirtualFt232h(RtlBoard(robot.bare, bytes_per_second), clock=LoopClock())
    with installed(VirtualBus(device)):
        async with unity_link.connect("ftdi-async://ftdi:232h/1", timeout=60) as link:
            machine: Any = robot.spec(link)
            joints = Joints(robot)
            busy = asyncio.ensure_future(ask_on(link, machine))
            asked, times_late = await feed(machine, rows, JOINTS / writes_per_second, random.Random(rows))
            busy.cancel()
            await asyncio.wait([busy])
            late, refused = await machine.plan.late.get(), await machine.plan.refused.get()
    seen = joints.seen
    assert joints.pulses() == [len(seen)] * JOINTS
    assert seen == [(cycle, tuple(range(asked[cycle], asked[cycle] + JOINTS))) for cycle, _ in seen]
    assert all(before < after for (before, _), (after, _) in pairwise(seen))
    assert len(seen) > 0.7 * rows
    assert times_late > 0
    assert late > 0
    # The row whose timeline has already ended may not have been sent.
    assert 0 <= len(asked) - len(seen) - late - refused <= times_late
