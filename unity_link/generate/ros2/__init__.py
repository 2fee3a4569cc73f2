"""ROS 2: a colcon package with a node on rclpy, its launch file and its parameters.

For those who have a ROS installation, and want a node that `ros2 node list` shows; without one, `unity-link ros2`
speaks to the same topics. The node takes names and types from `unity_link.bridges.topics`, as that does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.python import docstring
from unity_link.generate.ros import names, robot_module

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "a package of ROS 2: a node on rclpy, for colcon and ros2 launch"
FILTERS = {"docstring": docstring}


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    seen = names(interface)
    folder, package = seen["package"], seen["package"]
    for name in ("package.xml", "setup.py", "setup.cfg", "README.md"):
        yield GeneratedFile(f"{folder}/{name}", templates.render(name, **seen))
    yield GeneratedFile(f"{folder}/resource/{package}", "")
    yield GeneratedFile(f"{folder}/launch/{seen['module']}.launch.py", templates.render("launch.py", **seen))
    yield GeneratedFile(f"{folder}/config/{seen['module']}.yaml", templates.render("parameters.yaml", **seen))
    yield GeneratedFile(f"{folder}/{package}/__init__.py", "")
    yield GeneratedFile(f"{folder}/{package}/bridge.py", templates.render("bridge.py", **seen))
    module = robot_module(interface, templates)
    yield module._replace(name=f"{folder}/{package}/{module.name}")
