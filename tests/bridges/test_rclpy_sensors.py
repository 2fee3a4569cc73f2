"""Sensors of a spec, as real nodes of rclpy receive them: values in SI units, and stamps by the gateway's clock."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from bridges.test_rclpy import served
from bridges.test_sensor_topics import EXPECTED, SPEC, TOPICS, WORDS
from support.bridge_programs import wait_for
from support.rclpy_peers import PYTHONS, Ros
from unity_link import blocking

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.slow
@pytest.mark.parametrize("transport", ["dds", "rclpy"])
@pytest.mark.parametrize("distribution", PYTHONS)
def test_nodes_of_ros_2_hear_sensors_with_stamps_of_the_gateway(
    distribution: str, transport: str, tmp_path: Path
) -> None:
    ros = Ros(distribution)
    spec = tmp_path / "rover.ul"
    spec.write_text(SPEC)
    with (
        served(tmp_path, f"sim:{spec}") as url,
        ros.bridge(transport, str(spec), "--link", url) as bridge,
        ros.node() as node,
        blocking.connect(url) as link,
    ):
        for address, words in WORDS:
            link.write_block(address, words)
        wait_for(bridge, "at /rover")
        for name, kind in TOPICS.items():
            topic = f"/rover/{name}"
            node.listen(topic, f"sensor_msgs/{kind}")
            *_, before, last = node.heard(topic, count=50)
            stamps = [
                one["header"]["stamp"]["sec"] * 10**9 + one["header"]["stamp"]["nanosec"] for one in (before, last)
            ]
            # The gateway takes a hundred samples a second by its own clock.
            assert stamps[1] - stamps[0] == pytest.approx(1e7, abs=1e5)
            for field, value in EXPECTED[kind].items():
                assert last[field] == pytest.approx(value, rel=1e-6, nan_ok=True), field
