"""Environments with the rclpy of a distribution of ROS 2, from `make ros-venvs`, and nodes that run in them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from support.bridge_programs import PATIENCE, free_domain

if TYPE_CHECKING:
    from collections.abc import Iterator

PYTHONS = {
    file.parent.name.removeprefix("ros-"): str(file.parent / "bin" / "python")
    for file in sorted(Path(__file__).parents[2].glob(".venv/ros-*/.installed"))
}
"""Path of the Python of each distribution."""
PEER = str(Path(__file__).parents[1] / "bridges" / "rclpy_peer.py")


class Node:
    """A node of `rclpy_peer` in another process; its methods are those of `rclpy_peer.Peer`."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process

    def __getattr__(self, name: str) -> Any:
        def do(*arguments: Any, **given: Any) -> Any:
            words = dict(zip(("topic", "kind", "messages"), arguments, strict=False)) | given
            assert self.process.stdin is not None
            self.process.stdin.write(json.dumps({"do": name, **words}) + "\n")
            self.process.stdin.flush()
            return self.answer()

        return do

    def answer(self) -> Any:
        """Return the next answer of the node."""
        assert self.process.stdout is not None
        return json.loads(self.process.stdout.readline())


class Ros:
    """A separate domain of ROS 2, and programs in it."""

    def __init__(self, distribution: str) -> None:
        self.distribution = distribution
        self.domain = free_domain()
        self.environment = {
            **os.environ,
            "ROS_DOMAIN_ID": str(self.domain),
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            "PYTHONUNBUFFERED": "1",
        }

    @contextmanager
    def node(self, name: str = "peer", **more: str) -> Iterator[Node]:
        """Run a node of rclpy; kill it at the end of the block."""
        with subprocess.Popen(
            [PYTHONS[self.distribution], PEER, name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=self.environment | more,
        ) as process:
            try:
                node = Node(process)
                assert node.answer() == "ready"
                yield node
            finally:
                process.kill()

    @contextmanager
    def bridge(self, transport: str, *words: str, **more: str) -> Iterator[subprocess.Popen[str]]:
        """Run `unity-link ros2`, with rclpy or CycloneDDS; kill it at the end of the block."""
        python = PYTHONS[self.distribution] if transport == "rclpy" else sys.executable
        with subprocess.Popen(
            [python, "-m", "unity_link", "ros2", *words], stderr=subprocess.PIPE, text=True, env=self.environment | more
        ) as process:
            try:
                yield process
            finally:
                process.kill()
                process.wait(PATIENCE)
