"""ROS 1: a package with a node and its launch file, over the bridge `unity_link.bridges.ros1`.

The node is `scripts/bridge`, the robot beside it the module of the target `python`; the rest is what catkin wants.
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

DOC = "a package of ROS 1: a node for catkin and roslaunch"
FILTERS = {"docstring": docstring}


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    seen = names(interface)
    folder = seen["package"]
    yield GeneratedFile(f"{folder}/package.xml", templates.render("package.xml", **seen))
    yield GeneratedFile(f"{folder}/CMakeLists.txt", templates.render("CMakeLists.txt", **seen))
    yield GeneratedFile(f"{folder}/launch/{seen['module']}.launch", templates.render("bridge.launch", **seen))
    yield GeneratedFile(f"{folder}/scripts/bridge", templates.render("bridge.py", **seen), executable=True)
    module = robot_module(interface, templates)
    yield module._replace(name=f"{folder}/scripts/{module.name}")
    yield GeneratedFile(f"{folder}/README.md", templates.render("README.md", **seen))
