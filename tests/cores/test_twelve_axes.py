"""The twelve axes of the examples as a whole: all cores, the schedule and the lease, on `sim:` and on the gateware."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import NotArmedError
from unity_link.spec import compile_text
from unity_link.virtual.build import Wanted, simulated
from unity_link.virtual.simulated import SimulatedRobot

EXAMPLE = Path(__file__).parents[2] / "examples" / "twelve_axes.ul"
SPEC = compile_text(EXAMPLE.read_text().replace("MAXVEL=200", "MAXVEL=5"))
"""The example with slow slides, which the compiled gateware supports at its lowest clock."""
AXES, PINS = range(12), range(8)
DRIVEN, HIGH = PINS[::2], frozenset({1, 5})
"""Pins that a program drives, and those of the others that the plant sets to 1."""
INPUTS, OUTPUTS = 0x8040_2011, 0x80_1003
PERIOD = 16
"""Cycles of a period of the PWM, at the lowest clock."""

ON = pytest.mark.parametrize(
    "rtl", [False, pytest.param(True, marks=[pytest.mark.rtl, pytest.mark.campaign])], ids=["sim", "rtl"]
)
Robot = unity_link.load(SPEC)


class Machine(SimulatedRobot):
    """Motors with a speed in proportion to their voltage, each by its own factor, and pins."""

    axes: Any
    pins: Any
    drive: Any
    outputs: Any

    def start(self) -> None:
        """Stop all wheels."""
        self.angles = [0.0 for _ in AXES]
        self.is_stopped = False

    def step(self, dt: float) -> None:
        """Turn the wheels and set the inputs."""
        self.drive.estop = int(not self.is_stopped)
        for index, axis in enumerate(self.axes):
            self.angles[index] += (index + 1) / 24 * axis.motor.value * dt
            axis.wheel.position = self.angles[index]
        for index in HIGH:
            self.pins[index].pin = 1
        self.inputs = INPUTS


def volts(index: int) -> float:
    """Return a voltage for each motor, of both signs."""
    return 4.0 * (index - 5.5)


def place(index: int) -> float:
    """Return a position in mm for each slide, of both signs, and 0 for one."""
    return (index - 3) * 5 / 200


async def run(robot: Any) -> None:
    """Set the voltage of each motor and the target of each slide, and drive the pins."""
    for index, axis in enumerate(robot.axes):
        await axis.motor.value.set(volts(index))
        await axis.slide.position_cmd.set(place(index))
    await robot.outputs.set(OUTPUTS)
    for index in DRIVEN:
        await robot.pins[index].output.set(index % 4 == 0)
        await robot.pins[index].drive.set(True)


@ON
@on_simulated_time
async def test_twelve_axes_and_64_pins_follow_their_registers(rtl: bool) -> None:
    gateway = simulated(SPEC.interface(), Machine, Wanted(rtl=rtl))
    machine: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        steps = [gateway.ports[f"axes_{index}_slide_step"] for index in AXES] if rtl else []
        for port in steps:
            port.take_counts()
        if rtl:
            gateway.ports["inputs"].drive(INPUTS)
        await asyncio.sleep(0.01)
        async with robot.drive.armed(timeout=0.09) as lease:
            await run(robot)
            for _ in range(4):
                await asyncio.sleep(0.05)
                await lease.kick()
            for index, axis in enumerate(robot.axes):
                assert machine.axes[index].motor.value == pytest.approx(volts(index), abs=0.8 if rtl else 0.01)
                assert await axis.wheel.velocity.get() == pytest.approx((index + 1) / 24 * volts(index), abs=0.6)
                assert await axis.wheel.position.get() == pytest.approx(machine.angles[index], abs=0.01)
                assert await axis.wheel.errors.get() == 0
                assert await axis.slide.in_position.get()
                assert await axis.slide.position.get() == pytest.approx(place(index))
            await lease.kick()
            levels = [index in HIGH or (index in DRIVEN and index % 4 == 0) for index in PINS]
            assert [machine.pins[index].level for index in PINS] == levels
            for index in PINS[1::2]:
                assert await robot.pins[index].level.get() == await robot.pins[index].edges.get() == levels[index]
            shown = gateway.ports["outputs"].value if rtl else machine.outputs
            assert (await robot.inputs.get(), shown) == (INPUTS, OUTPUTS)
        if rtl:
            assert [port.take_counts()[0].edges for port in steps] == [10 * abs(index - 3) for index in AXES]


@ON
@on_simulated_time
async def test_set_points_of_all_axes_act_in_their_cycles(rtl: bool) -> None:
    gateway = simulated(SPEC.interface(), Machine, Wanted(rtl=rtl))
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        clock = await robot.plan.clock()
        async with robot.drive.armed(timeout=0.09) as lease:
            together = clock.now().after(0.03)
            # Each instant is in another cycle of a PWM period.
            instants = [together.after(place * (PERIOD + 1) / clock.clock_hz) for place in range(1, 2 * len(AXES) + 1)]
            async with robot.plan.timeline(lease=lease) as line:
                set_points = (signal for axis in robot.axes for signal in (axis.motor.value, axis.slide.position_cmd))
                await line.set(dict.fromkeys(set_points, 1), at=together)
                for index, at in enumerate(instants):
                    axis = robot.axes[index % len(AXES)]
                    await line.set(
                        {axis.motor.value: -24 if index < len(AXES) else 24, robot.outputs: index + 1}, at=at
                    )
                await robot.plan.room.get()
                if rtl:
                    see_turns(gateway, [at.ticks for at in instants])
                assert await line.flush() == 1 + len(instants)
            assert [await axis.motor.value.get() for axis in robot.axes] == [24] * len(AXES)
            assert [await axis.slide.position_cmd.get() for axis in robot.axes] == [1] * len(AXES)
            assert (await robot.plan.late.get(), await robot.plan.refused.get()) == (0, 0)


def see_turns(gateway: Any, instants: list[int]) -> None:
    """Assert that outputs change in their cycles, and motors at the next start of a period, two cycles later."""
    bare: Any = gateway._gateway
    ports = [gateway.ports[f"axes_{index}_motor_dir"] for index in AXES]
    before, turns, shown = [0] * len(AXES), [], dict[int, int]()
    while bare.cycles < instants[-1] + 2 * PERIOD:
        bare.run(1)
        shown.setdefault(gateway.ports["outputs"].value, bare.cycles)
        now = [port.value for port in ports]
        turns += [(index, bare.cycles) for index in AXES if now[index] != before[index]]
        before = now
    assert [shown[number] for number in range(1, len(instants) + 1)] == instants
    assert [index for index, _ in turns] == [*AXES, *AXES]
    # A write that acted one cycle early or late would be outside of this range.
    assert {cycle - at for (_, cycle), at in zip(turns, instants, strict=True)} == set(range(2, 2 + PERIOD))


@ON
@on_simulated_time
async def test_a_fault_of_the_lease_makes_everything_safe(rtl: bool) -> None:
    gateway = simulated(SPEC.interface(), Machine, Wanted(rtl=rtl))
    machine: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        for signal in (robot.axes[3].motor.value, robot.axes[4].slide.position_cmd, robot.pins[5].drive):
            with pytest.raises(NotArmedError):
                await signal.set(1)

        async def move() -> None:
            async with robot.drive.armed(timeout=0.09) as lease, robot.plan.timeline(lead=0.06, lease=lease) as line:
                await run(robot)
                for axis in robot.axes:
                    await axis.slide.position_cmd.set(50)
                await line.set({axis.motor.value: 24 for axis in robot.axes})
                await asyncio.sleep(0.03)
                assert all(axis.motor.value for axis in machine.axes)
                machine.is_stopped = True
                await line.flush()

        with pytest.raises(NotArmedError, match="its e-stop was opened"):
            await move()
        if rtl:
            off = [port for name, port in gateway.ports.items() if name.endswith(("_enable", "_pwm", "_pin_oe"))]
            assert [port.value for port in off] == [0] * (1 + 12 + 8)
        await asyncio.sleep(0.1)
        assert (gateway.ports["outputs"].value if rtl else machine.outputs) == 0
        assert [axis.motor.value for axis in machine.axes] == [0] * 12
        assert [await axis.motor.value.get() for axis in robot.axes] == [0] * 12
        assert [await axis.slide.velocity.get() for axis in robot.axes] == [0] * 12
        assert all([await axis.slide.holding.get() for axis in robot.axes])
        assert [await pin.level.get() for pin in robot.pins] == [index in HIGH for index in PINS]
        assert await robot.drive.reason.get() == "estop"
        assert await robot.plan.refused.get() == 1
