"""Trajectories of ROS 2, from real nodes of rclpy: played by a schedule, or refused as a whole with the reason."""

from __future__ import annotations

import math
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

from bridges.test_rclpy import served
from support.bridge_programs import wait_for, wait_until
from support.rclpy_peers import PYTHONS, Ros
from unity_link import blocking, load
from unity_link.data.blocking import put

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Iterator
    from pathlib import Path

    from support.rclpy_peers import Node

pytestmark = pytest.mark.slow
SPEC = """
group state(RATE=100, TIMESTAMPS, JOINTS(POSITION=position, SET_POSITION=target));
public arm() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT={timeout}) @(0xC0);
  plan: SCHEDULE(DEPTH=8192) @(0xE0);
  j[6]: joint(drive, plan) @(0x10 + 2 * i);
}
joint(lease, plan): @(base) {
  @position = base: signed READ(SCALE=0.001, UNIT="rad", PUBLISH(state));
  @target = base + 1: signed READWRITE(SCALE=0.001, UNIT="rad", MIN=-3, MAX=3, SAFE(0, lease), TIMED(plan));
}
"""
TOPIC = "/arm/joint_trajectory", "trajectory_msgs/JointTrajectory"
NAMES = [f"j_{joint}" for joint in range(6)]


def point(milliseconds: int, positions: list[float], **more: Any) -> dict[str, Any]:
    time = {"sec": milliseconds // 1000, "nanosec": milliseconds % 1000 * 1_000_000}
    return {"positions": positions, "time_from_start": time, **more}


def path(points: int) -> dict[str, Any]:
    """Return a trajectory at 1 kHz, at the end of which the joints have positions from 0.5 rad on."""
    rows = [[0.5 * math.sin(math.pi / 2 * (n + 1) / points) + 0.1 * j for j in range(6)] for n in range(points)]
    return {"joint_names": NAMES, "points": [point(n, row) for n, row in enumerate(rows)]}


class Arm(NamedTuple):
    """A robot with its bridge and a node."""

    ros: Ros
    transport: str
    bridge: subprocess.Popen[str]
    node: Node
    robot: Any

    def is_armed(self, node: Node | None = None) -> bool:
        """Arm from a node if disarmed; return True if armed."""
        node = node or self.node
        if not self.robot.drive.armed_.get() and self.transport == "rclpy":
            node.call(service="/arm/drive/arm", kind="std_srvs/SetBool", request={"data": True})
        elif not self.robot.drive.armed_.get():
            node.publish("/arm/drive/arm", "std_msgs/Bool", [{"data": True}])
        return bool(self.robot.drive.armed_.get())

    def says(self, words: str) -> bool:
        """Return True if the diagnostics of the trajectory contain `words`."""
        last = self.node.last(topic="/diagnostics")
        statuses = [] if last is None else last["status"]
        return any(words in one["message"] for one in statuses if one["name"] == "unity_link_arm: joint_trajectory")


@contextmanager
def arm(transport: str, folder: Path, gateway: str, *words: str, timeout: int = 10) -> Iterator[Arm]:
    spec, ros = folder / "arm.ul", Ros(next(iter(PYTHONS)))
    spec.write_text(SPEC.replace("{timeout}", str(timeout)))
    with (
        served(folder, gateway.format(spec)) as url,
        ros.bridge(transport, str(spec), "--link", url, *words) as bridge,
        ros.node() as node,
        blocking.connect(url) as link,
    ):
        wait_for(bridge, "at /arm")
        node.listen("/diagnostics", "diagnostic_msgs/DiagnosticArray")
        node.publish(*TOPIC, [])
        yield Arm(ros, transport, bridge, node, put(load(str(spec)), link))


@pytest.fixture(params=["dds", "rclpy"])
def transport(request: pytest.FixtureRequest) -> str:
    return str(request.param)


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "no names": ({"joint_names": []}, "it names no joints"),
    "a joint twice": ({"joint_names": [*NAMES[:5], "j_0"]}, "point 0: a joint is named twice"),
    "an unknown joint": ({"joint_names": [*NAMES[:5], "j_7"]}, "point 0: no joint is called 'j_7'"),
    "a time that goes back": ({"points": [point(5, [0.0] * 6), point(4, [0.0] * 6)]}, "does not rise from 0 on"),
    "a time before the start": ({"points": [point(-5000, [0.0] * 6)]}, "does not rise from 0 on"),
    "too few positions": ({"points": [point(0, [0.0] * 5)]}, "point 0: 5 positions were given for 6 joints"),
    "beyond a limit": ({"points": [point(0, [0.0] * 6), point(1, [4.0] * 6)]}, "is outside of its limits, -3 to 3 rad"),
    "no number": ({"points": [point(0, [math.nan] * 6)]}, "point 0: a value is no number"),
    "a start that has passed": ({"header": {"stamp": {"sec": 1, "nanosec": 0}}}, "its start, header.stamp, was"),
    "a start with too many nanoseconds": (
        {"header": {"stamp": {"sec": 1, "nanosec": 2_000_000_000}}},
        "header.stamp has 2000000000 nanoseconds",
    ),
}


def test_ten_kinds_of_wrong_trajectories_are_refused_whole_with_the_reason(transport: str, tmp_path: Path) -> None:
    with arm(transport, tmp_path, "sim:{}", "--allow-arm") as it:
        it.node.publish(*TOPIC, [path(2)])
        assert "nothing on ROS has armed drive" in wait_for(it.bridge, "the trajectory is refused")
        for wrong, words in WRONG.values():
            wait_until(it.is_armed)
            it.node.publish(*TOPIC, [path(2) | wrong])
            wait_for(it.bridge, words)
            wait_until(lambda words=words: it.says(words))  # type: ignore[misc]
        assert it.robot.j[0].target.get() == 0
        assert it.robot.plan.fates.get() == 0


@pytest.mark.parametrize("reason", ["it is empty", "its publisher is gone"])
def test_a_trajectory_without_points_or_publisher_disarms(transport: str, reason: str, tmp_path: Path) -> None:
    with arm(transport, tmp_path, "sim:{}", "--allow-arm") as it:
        wait_until(it.is_armed)
        # The second point is far ahead, and the lease is kicked until then.
        it.node.publish(*TOPIC, [path(2) | {"points": [point(0, [0.1] * 6), point(60_000, [1.0] * 6)]}])
        wait_until(lambda: it.robot.j[0].target.get() == pytest.approx(0.1))
        if reason == "it is empty":
            it.node.publish(*TOPIC, [{}])
            wait_for(it.bridge, "an empty trajectory has stopped the robot")
        else:
            it.node.unpublish(TOPIC[0])
            wait_for(it.bridge, "a topic of its set points has lost its publisher")
        wait_until(lambda: not it.robot.drive.armed_.get())
        assert it.robot.j[0].target.get() == 0
