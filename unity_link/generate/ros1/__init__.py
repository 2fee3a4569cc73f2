"""ROS 1: a catkin package that starts `unity-link ros1`, with its launch file and the spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate.ros import Options, package_files

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import GeneratedFile, Templates
    from unity_link.spec import Interface

__all__ = ["DOC", "Options", "files"]

DOC = "a package of ROS 1 that starts unity-link ros1: for catkin and roslaunch"


def files(interface: Interface, templates: Templates, options: Options) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    own = {"CMakeLists.txt": "CMakeLists.txt", "launch/{module}.launch": "bridge.launch"}
    return package_files(interface, templates, options, "ros1", "scripts/bridge", own)
