"""ROS 2 on compiled gateware: outputs are safe when their program is killed; trajectories keep their clock cycles."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

from bridges.test_rclpy_trajectories import TOPIC, arm, path
from support.bridge_programs import PATIENCE, wait_for, wait_until

if TYPE_CHECKING:
    from pathlib import Path

    from support.rclpy_peers import Node

GATEWAY = "rtl:{}?clock_hz=1000000"
SET_POINT = "/arm/j_0/target", "std_msgs/Float64"
LEAD = 5.0
"""Seconds from a trajectory to its start: enough to queue all points while other programs run."""
FAST_DDS = """<dds xmlns="http://www.eprosima.com"><profiles>
  <participant profile_name="mover" is_default_profile="true"><rtps><builtin><discovery_config>
    <leaseDuration><sec>2</sec></leaseDuration><leaseAnnouncement><nanosec>500000000</nanosec></leaseAnnouncement>
  </discovery_config></builtin></rtps></participant>
</profiles></dds>"""
"""Killed programs stay in the graph for 2 s instead of the 20 s of Fast DDS; no other program can arm until then."""
pytestmark = [pytest.mark.rtl, pytest.mark.slow]


@pytest.fixture(params=["dds", "rclpy"])
def transport(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.mark.parametrize("kills", [10, pytest.param(100, marks=pytest.mark.campaign)])
def test_a_killed_program_leaves_the_compiled_robot_safe_in_time(transport: str, kills: int, tmp_path: Path) -> None:
    profiles = tmp_path / "fast_dds.xml"
    profiles.write_text(FAST_DDS)
    # The first name is for Jazzy, the second for Kilted.
    of_movers = dict.fromkeys(("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"), str(profiles))
    with arm(transport, tmp_path, GATEWAY, "--allow-arm", timeout=1) as it:
        robot = it.robot
        it.node.unpublish(TOPIC[0])
        for number in range(kills):
            with it.ros.node(f"mover_{number}", **of_movers) as node:

                def is_moved(node: Node = node) -> bool:
                    node.publish(*SET_POINT, [{"data": 0.5}])
                    if not it.is_armed(node):
                        return False
                    # The last set point: no other one is on its way after it.
                    node.publish(*SET_POINT, [{"data": 1.0}])
                    wait_until(lambda: robot.j[0].target.get() == 1 or not robot.drive.armed_.get())
                    return bool(robot.j[0].target.get() == 1)

                wait_until(is_moved)
                node.process.kill()
                node.process.wait(PATIENCE)
                killed = robot.drive.clock.get()
            wait_until(lambda: not robot.drive.armed_.get())
            assert robot.j[0].target.get() == 0
            # With another reason, the bridge has detected that the publisher was gone.
            if robot.drive.reason.get().name == "silence":
                # A set point may have been on its way when its program was killed.
                assert robot.drive.fault_time.get() <= killed + 1.1 * robot.link.gateway.clock_hz


def test_five_hundred_points_of_six_joints_act_at_1_khz_on_compiled_gateware(transport: str, tmp_path: Path) -> None:
    with arm(transport, tmp_path, GATEWAY, "--allow-arm") as it:
        wait_until(it.is_armed)
        seconds, nanoseconds = divmod(round((time.time() + LEAD) * 1e9), 1_000_000_000)
        start = {"stamp": {"sec": seconds, "nanosec": nanoseconds}}
        it.node.publish(*TOPIC, [{"header": start} | path(500)])
        assert "500 points are played" in wait_for(it.bridge, "joint_trajectory:")
        assert "500 points have acted" in wait_for(it.bridge, "joint_trajectory:")
        wait_until(lambda: it.says("500 points have acted"))
        # The schedule counts a point that acts in another clock cycle than its own as late or refused.
        assert [it.robot.plan.late.get(), it.robot.plan.refused.get()] == [0, 0]
        assert it.robot.plan.fates.get() == 500
        it.node.publish(*TOPIC, [{}])
        wait_until(lambda: not it.robot.drive.armed_.get())
