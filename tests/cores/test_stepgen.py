"""Step generators used by a program: on `sim:`, and on the compiled gateware of a whole design."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import NotArmedError, UnityLinkError
from unity_link.spec import compile_file
from unity_link.virtual.build import simulate

if TYPE_CHECKING:
    from pathlib import Path

SPEC = """\
public gantry() {
  drive: LEASE(TIMEOUT=1) @(0xC0);
  x: STEPGEN(STEPS=100, UNIT="mm", MAXVEL=40, MAXACCEL=20000, LEASE=drive) @(0x10, step="gp4", dir="gp5");
  y: STEPGEN(STEPS=50, UNIT="mm", MAXVEL=80, MAXACCEL=40000, LEASE=drive) @(0x20, step="gp6", dir="gp7");
}
"""


@pytest.fixture(params=["sim", pytest.param("rtl", marks=pytest.mark.rtl)])
def gantry(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Any, Any]:
    """Return the class of the robot, and its gateway."""
    path = tmp_path / "gantry.ul"
    path.write_text(SPEC)
    return unity_link.load(compile_file(path)), simulate(path, rtl=request.param == "rtl")


@on_simulated_time
async def test_axes_move_to_positions_while_the_program_waits(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        counter = gateway.ports.get("x_step")
        if counter is not None:
            # Start the count here.
            counter.take_counts()
        with pytest.raises(NotArmedError):
            await robot.x.move_to(1)
        assert await robot.x.maxvel.get() == pytest.approx(40)
        async with robot.armed(timeout=0.9):
            await robot.x.move_to(3)
            assert await robot.x.position.get() == 3
            assert await robot.x.in_position.get() is True
            await robot.x.move_to(-1.5)
            assert await robot.x.position.get() == -1.5
            assert await robot.y.position.get() == 0
            await robot.y.move_to(0.5)
            assert await robot.y.position.get() == 0.5
        if counter is not None:
            (count,) = counter.take_counts()
            assert count.edges == 2 * (300 + 450)


@on_simulated_time
async def test_a_velocity_is_reached_and_stopped(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        async with robot.armed(timeout=0.9):
            await robot.x.velocity_cmd.set(-20)
            await robot.x.mode.set("velocity")
            await asyncio.sleep(0.005)
            begun, begin = await robot.drive.clock.get(), await robot.x.position.get()
            await asyncio.sleep(0.05)
            ended, end = await robot.drive.clock.get(), await robot.x.position.get()
            assert await robot.x.velocity.get() == pytest.approx(-20)
            assert end - begin == pytest.approx(-20 * (ended - begun) / link.gateway.clock_hz, rel=0.02)
            await robot.x.stop()
            await asyncio.sleep(0.005)
            assert await robot.x.velocity.get() == 0


@on_simulated_time
async def test_an_axis_whose_lease_ends_slows_down_and_keeps_its_position(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        with pytest.raises(NotArmedError, match="no kick came before its end"):
            async with robot.armed(timeout=0.03):
                await robot.y.move_to(1000)
        await asyncio.sleep(0.02)
        stands_at = await robot.y.position.get()
        # 30 ms at 80 mm/s, less half a ramp of 2 ms, plus half a ramp.
        assert 1.5 < stands_at < 3
        assert await robot.y.velocity.get() == 0
        assert await robot.y.holding.get() is True
        async with robot.armed(timeout=0.5):
            await asyncio.sleep(0.01)
            assert await robot.y.position.get() == stands_at
            await robot.y.move_to(stands_at + 1)
            assert await robot.y.position.get() == pytest.approx(stands_at + 1)


@on_simulated_time
async def test_move_to_kicks_the_given_lease(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        async with robot.armed(timeout=0.03) as lease:
            await robot.y.move_to(10, lease=lease)
            assert await robot.y.position.get() == 10
            await lease.kick()


@on_simulated_time
async def test_move_to_ends_when_the_lease_that_it_kicks_is_disarmed(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        async with robot.armed(timeout=0.5) as lease:
            way = asyncio.create_task(robot.y.move_to(10, lease=lease))
            await asyncio.sleep(0.03)
            await robot.drive.stop()
            with pytest.raises(NotArmedError, match="it was disarmed"):
                await way


@on_simulated_time
async def test_a_move_whose_target_is_changed_ends_with_an_error(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        async with robot.armed(timeout=0.9):
            way = asyncio.create_task(robot.x.move_to(20))
            await asyncio.sleep(0.03)
            await robot.x.stop()
            with pytest.raises(UnityLinkError, match=r"x does not go to 20: it was given another command"):
                await way


@on_simulated_time
async def test_a_lower_maxaccel_in_motion_acts_from_the_next_standstill(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        robot = robot_class(link)
        x = robot.x
        async with robot.armed(timeout=0.9) as lease:

            async def pass_time(seconds: float) -> float:
                """Let time pass; return the distance that the axis has moved."""
                begin = await x.position.get()
                await asyncio.sleep(seconds)
                await lease.kick()
                way: float = await x.position.get() - begin
                return way

            await x.maxaccel.set(200)
            await x.position_cmd.set(20)
            # The axis needs 4 mm to stop, and 40 mm with the new acceleration.
            assert await pass_time(0.35) == pytest.approx(10, abs=0.6)
            await x.maxaccel.set(20)
            assert await x.maxaccel.get() == pytest.approx(20)
            ways = [await pass_time(0.05) for _ in range(12)]
            assert min(ways) >= 0
            assert await x.position.get() == 20
            assert await x.in_position.get()
            # From standstill the new acceleration acts: the distance is half of it times the square of the time.
            await x.position_cmd.set(0)
            assert await pass_time(0.2) == pytest.approx(-0.4, abs=0.1)


@on_simulated_time
async def test_an_axis_whose_lease_ends_brakes_with_the_acceleration_of_the_spec(gantry: tuple[Any, Any]) -> None:
    robot_class, gateway = gantry
    async with unity_link.connect(gateway) as link:
        x = robot_class(link).x
        async with robot_class(link).armed(timeout=0.9):
            await x.maxaccel.set(200)
            await x.position_cmd.set(1000)
            await asyncio.sleep(0.4)
            begin = await x.position.get()
        await asyncio.sleep(0.02)
        # At most 40 mm in 20 ms, and 4 mm more to stop by 200 mm/s2.
        assert await x.velocity.get() == 0
        assert await x.position.get() - begin < 0.8
