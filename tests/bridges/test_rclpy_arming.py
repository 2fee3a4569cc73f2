"""A lease that ROS 2 arms, from real nodes of rclpy: which programs may arm it, and the events that keep or end it."""

from __future__ import annotations

import contextlib
import signal
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

from bridges.test_rclpy import served
from support.bridge_programs import PATIENCE, wait_for, wait_until
from support.rclpy_peers import PYTHONS, Ros
from unity_link import NotArmedError, blocking, load
from unity_link.data.blocking import put

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Iterator
    from pathlib import Path

    from support.rclpy_peers import Node

SPEC = """
group state(RATE=100, TIMESTAMPS, JOINTS(POSITION=position, SET_VELOCITY=speed));
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=10) @(0xE0);
  left: wheel(drive) @(0x10);
  right: wheel(drive) @(0x20);
  @lamps = 0x31: unsigned 8 READWRITE(MAX=15);
}
wheel(lease): @(base) {
  @position = base: signed READ(SCALE=0.001, UNIT="rad", PUBLISH(state));
  @speed = base + 1: signed READWRITE(SCALE=0.001, UNIT="rad/s", SAFE(0, lease));
}
"""
ARM, ARMED, LEFT = "/rover/drive/arm", "/rover/drive/armed", "/rover/left/speed"
OFF = "arming from ROS is off: start the bridge with --allow-arm"


class Rover(NamedTuple):
    """A robot with its bridge and a node."""

    transport: str
    bridge: subprocess.Popen[str]
    node: Node
    robot: Any

    def arm(self, node: Node, said: str, *, armed: bool = True, often: bool = True) -> None:
        """Arm or disarm; assert that the answer, or the log of the bridge, has `said`.

        `often=False` publishes once only, which needs matched topics.
        """
        if self.transport == "rclpy":
            answer = node.call(service=ARM, kind="std_srvs/SetBool", request={"data": armed})
            assert said in answer["message"]
        else:
            publish = node.publish_often if often else node.publish
            publish(ARM, "std_msgs/Bool", [{"data": armed}])
            wait_for(self.bridge, said)

    def moves(self, node: Node, speed: float) -> bool:
        """Arm if disarmed, and publish a set point; return True if the register has the set point."""
        node.publish(LEFT, "std_msgs/Float64", [{"data": speed}])
        if not self.robot.drive.armed_.get() and self.transport == "rclpy":
            node.call(service=ARM, kind="std_srvs/SetBool", request={"data": True})
        elif not self.robot.drive.armed_.get():
            node.publish(ARM, "std_msgs/Bool", [{"data": True}])
        return bool(self.robot.left.speed.get() == pytest.approx(speed, abs=5e-4))


@contextlib.contextmanager
def rover(ros: Ros, transport: str, folder: Path, *words: str) -> Iterator[Rover]:
    spec = folder / "rover.ul"
    spec.write_text(SPEC)
    with (
        served(folder, f"sim:{spec}") as url,
        ros.bridge(transport, str(spec), "--link", url, *words) as bridge,
        ros.node() as node,
        blocking.connect(url) as link,
    ):
        # `arm`, `kick` and the other words of the lease are no topics.
        wait_for(bridge, "2 topics published, 5 subscribed to at /rover")
        node.listen(ARMED, "std_msgs/Bool", quality="latched")
        assert node.heard_last(ARMED, values=[False])
        yield Rover(transport, bridge, node, put(load(str(spec)), link))


@pytest.fixture(params=PYTHONS)
def ros(request: pytest.FixtureRequest) -> Ros:
    return Ros(request.param)


@pytest.fixture(params=["dds", "rclpy"])
def transport(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.mark.slow
def test_a_program_arms_moves_and_is_disarmed_by_anybody(ros: Ros, transport: str, tmp_path: Path) -> None:
    with rover(ros, transport, tmp_path, "--allow-arm") as it, ros.node("other") as other:
        it.arm(it.node, "and there are: none")
        # Its answer comes after the answers to the copies of the first message.
        it.arm(it.node, "drive is disarmed", armed=False, often=False)
        it.node.publish_often(LEFT, "std_msgs/Float64", [{"data": 0.5}])
        wait_for(it.bridge, "left.speed is not written, because drive was disarmed")
        assert it.robot.left.speed.get() == 0
        wait_until(lambda: it.moves(it.node, 0.5))
        assert it.node.heard_last(ARMED, values=[True])
        it.arm(other, "drive is disarmed", armed=False)
        assert it.node.heard_last(ARMED, values=[False])
        assert it.robot.left.speed.get() == 0


@pytest.mark.slow
def test_silence_ends_the_lease(ros: Ros, transport: str, tmp_path: Path) -> None:
    with rover(ros, transport, tmp_path, "--allow-arm", "--timeout", "0.5") as it:
        wait_until(lambda: it.moves(it.node, 0.5))
        wait_for(it.bridge, "drive is not armed: no kick came before its end")
        assert it.node.heard_last(ARMED, values=[False])
        assert it.robot.drive.reason.get().name == "silence"
        assert it.robot.left.speed.get() == 0


@pytest.mark.slow
def test_a_second_publisher_of_set_points_disarms(ros: Ros, transport: str, tmp_path: Path) -> None:
    with rover(ros, transport, tmp_path, "--allow-arm") as it, ros.node("second") as second:
        wait_until(lambda: it.moves(it.node, 0.5))
        joints = {"name": ["right"], "velocity": [0.25]}
        second.publish("/rover/joint_commands", "sensor_msgs/JointState", [joints])

        def is_stopped() -> bool:
            it.node.publish(LEFT, "std_msgs/Float64", [{"data": 0.5}])
            return not it.robot.drive.armed_.get()

        wait_until(is_stopped)
        said = wait_for(it.bridge, "drive is disarmed: a topic of its set points is published by")
        assert "[ERROR]" in said or transport == "dds"


@pytest.mark.slow
def test_arming_is_off_unless_it_is_allowed_and_disarming_is_not(ros: Ros, transport: str, tmp_path: Path) -> None:
    with rover(ros, transport, tmp_path) as it:
        it.node.publish(LEFT, "std_msgs/Float64", [{"data": 0.5}])
        it.arm(it.node, OFF)
        with it.robot.drive.armed(), contextlib.suppress(NotArmedError):
            it.arm(it.node, "drive is disarmed", armed=False)
            assert not it.robot.drive.armed_.get()


@pytest.mark.slow
def test_a_bridge_that_ends_disarms(ros: Ros, transport: str, tmp_path: Path) -> None:
    with rover(ros, transport, tmp_path, "--allow-arm") as it:
        wait_until(lambda: it.moves(it.node, 0.5))
        it.bridge.send_signal(signal.SIGINT)
        assert it.bridge.wait(PATIENCE) == 130
        assert not it.robot.drive.armed_.get()


@pytest.mark.slow
def test_a_timeout_beyond_that_of_the_spec_is_refused(ros: Ros, transport: str, tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(SPEC)
    words = "--allow-arm", "--timeout", "20"
    with ros.bridge(transport, str(spec), "--link", f"sim:{spec}", *words) as bridge:
        wait_for(bridge, "error: the time-out of drive is a number of seconds above 0, and 10 s at most")
        assert bridge.wait(PATIENCE) == 2
