"""The gantry of the examples follows its path in each cycle, and stops when its e-stop is pressed."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import unity_link
from support.by_path import imported
from support.simulated_time import on_simulated_time
from unity_link.virtual.build import simulate

FOLDER = Path(__file__).parents[2] / "examples" / "gantry"
ON = pytest.mark.parametrize("rtl", [False, pytest.param(True, marks=pytest.mark.rtl)], ids=["sim", "rtl"])


LOOK = 0.005
"""Seconds between two observations."""
STEPS = np.array([1 / 40, 1 / 40, 1 / 100])
"""A step of each axis, in mm."""


def positions_of(robot: Any) -> list[float]:
    """Return the positions of x, y and z in mm, computed from the steps that their drivers have received."""
    return [axis.position for axis in (robot.x, robot.y, robot.z)]


def rests_of(positions: np.ndarray[Any, Any]) -> list[np.ndarray[Any, Any]]:
    """Return the positions at which all axes rested for more than 0.1 s, each as at the end of the rest."""
    stands = np.convolve((np.diff(positions, axis=0) == 0).all(axis=1), np.ones(20), "valid") == 20
    ends = np.flatnonzero(stands[:-1] & ~stands[1:])
    return [positions[end + 20] for end in ends]


@pytest.mark.slow
@ON
@on_simulated_time
async def test_the_gantry_draws_its_path_and_an_e_stop_ends_its_program(
    rtl: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    program, plant = imported(FOLDER / "gantry.py"), imported(FOLDER / "plant.py")
    gateway = simulate(FOLDER / "gantry.ul", plant.Gantry, rtl=rtl)
    robot: Any = gateway.robot
    running = asyncio.ensure_future(program.draw(gateway))
    steps: list[list[float]] = []
    drawn: list[tuple[list[float], list[float]]] = []
    while robot.flowers < 2:
        await asyncio.sleep(LOOK)
        steps.append(positions_of(robot))
        if robot.drawn and robot.flowers == 1:
            drawn.append((steps[-1], [motor.place for motor in robot.motors]))
    path = program.flower()
    assert capsys.readouterr().out == f"a flower of {path.shape[1]} places, each in its clock cycle\n"
    # The path ends at its beginning: the home position.
    home, *_, back = rests_of(np.array(steps))
    assert (np.abs(back - home) <= STEPS).all()
    drawing = path[:2, path[2] == path[2].max()]
    for places, begin, most in zip(np.array(drawn).swapaxes(0, 1), (home, np.zeros(3)), (0.08, 0.3), strict=True):
        far = [np.hypot(*(drawing - place[:2, None])).min() for place in places - begin]
        assert len(far) > 1 / LOOK / 2
        assert max(far) < most
    assert np.abs(np.ptp(np.array(drawn)[:, 0, :2], axis=0) - np.ptp(drawing, axis=1)) == pytest.approx(0, abs=STEPS[0])
    await asyncio.sleep(0.6)
    assert robot.drive.armed
    before = positions_of(robot)
    robot.pressed = True
    with pytest.raises(unity_link.NotArmedError, match="drive is not armed: its e-stop was opened") as caught:
        await running
    assert caught.value.reason == "estop"
    assert (robot.drive.enable, robot.drive.armed) == (0, False)
    rest = positions_of(robot), [motor.place for motor in robot.motors]
    await asyncio.sleep(0.2)
    assert (positions_of(robot), [motor.place for motor in robot.motors]) == rest
    # It brakes from 80 mm/s by 4000 mm/s2.
    assert 0 < np.hypot(*(np.array(rest[0]) - before)[:2]) < 2


@ON
@on_simulated_time
async def test_a_motor_that_is_accelerated_too_fast_loses_steps(rtl: bool) -> None:
    program, plant = imported(FOLDER / "gantry.py"), imported(FOLDER / "plant.py")
    gateway = simulate(FOLDER / "gantry.ul", plant.Gantry, rtl=rtl)
    robot: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        own = program.Gantry(link)
        async with own.drive.armed(timeout=0.8) as lease:
            await own.x.move_to(10)
            await asyncio.sleep(0.2)
            assert robot.motors[0].place - robot.x.position == pytest.approx(plant.STARTS[0], abs=0.02)
            await lease.kick()
            await own.x.maxaccel.set(0)
            await own.x.move_to(0)
            await lease.kick()
            # The motor oscillates for more than 0.2 s after it has lost its steps.
            await asyncio.sleep(0.4)
            lost = (robot.motors[0].place - robot.x.position - plant.STARTS[0]) / plant.PITCH
            assert round(lost) != 0
            assert lost == pytest.approx(round(lost), abs=0.05)


def test_the_program_of_the_gantry_is_short() -> None:
    assert len((FOLDER / "gantry.ul").read_text().splitlines()) <= 40
    assert len((FOLDER / "gantry.py").read_text().splitlines()) <= 60
