"""The balancer of the examples balances while its program runs; its motors are off after the program died."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

import unity_link
from support.by_path import imported
from support.simulated_time import on_simulated_time
from unity_link.virtual.build import simulate

FOLDER = Path(__file__).parents[2] / "examples" / "balancer"
ON = pytest.mark.parametrize("rtl", [False, pytest.param(True, marks=pytest.mark.rtl)], ids=["sim", "rtl"])


@pytest.mark.slow
@ON
@on_simulated_time
async def test_the_balancer_balances_and_returns_to_its_place(rtl: bool) -> None:
    program, plant = imported(FOLDER / "balance.py"), imported(FOLDER / "plant.py")
    gateway = simulate(FOLDER / "balancer.ul", plant.Balancer, rtl=rtl)
    running = asyncio.ensure_future(program.balance(gateway))
    robot: Any = gateway.robot
    # A PWM with only 16 widths makes it sway.
    rest, way = (0.08, 1.0) if rtl else (0.02, 0.5)
    await asyncio.sleep(1)
    assert robot.drive.armed
    assert abs(robot.lean) < rest
    robot.pushed = True
    await asyncio.sleep(0.1)
    robot.pushed = False
    assert abs(robot.lean) > 0.02
    await asyncio.sleep(1.4 if rtl else 4)
    assert abs(robot.lean) < rest
    assert abs(robot.angle) < way
    running.cancel()
    with pytest.raises(asyncio.CancelledError):
        await running
    assert not robot.drive.enable
    # The robot's time advances only while a link is open.
    async with unity_link.connect(gateway):
        await asyncio.sleep(0.01)
    assert (robot.left.value, robot.right.value, robot.drive.enable) == (0, 0, 0)


@pytest.mark.slow
@ON
@on_simulated_time
async def test_the_motors_are_off_when_the_control_loop_has_stopped(rtl: bool) -> None:
    program, plant = imported(FOLDER / "balance.py"), imported(FOLDER / "plant.py")
    gateway = simulate(FOLDER / "balancer.ul", plant.Balancer, rtl=rtl)
    robot: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        own = program.Robot(link)
        async with own.drive.armed(timeout=0.15) as lease:
            async for _ in lease.each(own.groups["state"]):
                await own.left.value.set(6)
                break
            if rtl:
                # A pulse is measured over a step of the plant, so let one pass.
                await asyncio.sleep(0.01)
            assert robot.left.value == pytest.approx(6, abs=0.01 if not rtl else 0.4)
            await asyncio.sleep(0.2)
            assert (robot.left.value, robot.drive.enable) == (0, 0)
            await asyncio.sleep(2)
            assert abs(robot.lean) == plant.LYING
            with pytest.raises(unity_link.NotArmedError):
                await own.left.value.set(6)
