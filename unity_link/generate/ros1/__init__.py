"""ROS 1: a catkin package that starts `unity-link ros1`, with its launch file and the spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.ros import Options, common, names

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

__all__ = ["DOC", "Options", "files"]

DOC = "a package of ROS 1 that starts unity-link ros1: for catkin and roslaunch"


def files(interface: Interface, templates: Templates, package: Options) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    seen = names(interface, package)
    folder = seen["package"]
    for name in ("package.xml", "CMakeLists.txt", "README.md"):
        yield GeneratedFile(f"{folder}/{name}", templates.render(name, **seen))
    yield GeneratedFile(f"{folder}/launch/{seen['module']}.launch", templates.render("bridge.launch", **seen))
    yield from common(interface, templates, "ros1", "scripts", "bridge", seen)
