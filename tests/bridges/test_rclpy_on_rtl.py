"""ROS 2 on compiled gateware: safe when its program is killed, and each point of a trajectory in its clock cycle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import pytest

from bridges.test_rclpy_arming import rover
from bridges.test_rclpy_trajectories import TOPIC, arm, path
from support.bridge_programs import PATIENCE, wait_for, wait_until
from support.rclpy_peers import PYTHONS, Ros

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = [pytest.mark.rtl, pytest.mark.slow]


@pytest.fixture(params=["dds", "rclpy"])
def transport(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.mark.parametrize("kills", [10, pytest.param(100, marks=pytest.mark.campaign)])
def test_a_killed_program_leaves_the_compiled_robot_safe_in_time(transport: str, kills: int, tmp_path: Path) -> None:
    ros = Ros(next(iter(PYTHONS)))
    with rover(ros, transport, tmp_path, "--allow-arm", gateway="rtl:{}?clock_hz=1000000") as it:
        for number in range(kills):
            speed = math.copysign(0.1 + 0.001 * number, number % 2 - 0.5)
            with ros.node(f"mover_{number}") as node:
                wait_until(lambda node=node, speed=speed: it.moves(node, speed))  # type: ignore[misc]
                node.process.kill()
                node.process.wait(PATIENCE)
                killed = it.robot.drive.clock.get()
            wait_until(lambda: not it.robot.drive.armed_.get())
            assert it.robot.left.speed.get() == 0
            # Otherwise the bridge has seen that the publisher was gone.
            if it.robot.drive.reason.get().name == "silence":
                # A set point may have been on its way when its program was killed.
                assert it.robot.drive.fault_time.get() <= killed + 1.1 * it.robot.link.gateway.clock_hz


def test_five_hundred_points_of_six_joints_act_at_1_khz_on_compiled_gateware(transport: str, tmp_path: Path) -> None:
    with arm(transport, tmp_path, "rtl:{}?clock_hz=1000000", "--allow-arm") as it:
        wait_until(it.is_armed)
        it.node.publish(*TOPIC, [path(500)])
        assert "500 points are played" in wait_for(it.bridge, "joint_trajectory:")
        assert "500 points have acted" in wait_for(it.bridge, "joint_trajectory:")
        wait_until(lambda: it.says("500 points have acted"))
        # The schedule counts a point that acts in another cycle than its own as late, or as refused.
        assert [it.robot.plan.late.get(), it.robot.plan.refused.get()] == [0, 0]
        assert it.robot.plan.fates.get() == 500
        it.node.publish(*TOPIC, [{}])
        wait_until(lambda: not it.robot.drive.armed_.get())
