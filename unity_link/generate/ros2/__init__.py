"""ROS 2: a colcon package that starts `unity-link ros2`, with its launch file, its parameters and the spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.ros import Options, package_files, package_name

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

__all__ = ["DOC", "Options", "files"]

DOC = "a package of ROS 2 that starts unity-link ros2: for colcon and ros2 launch"


def files(interface: Interface, templates: Templates, options: Options) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    name = package_name(interface)
    own = {"setup.py": "setup.py", "setup.cfg": "setup.cfg"}
    own |= {"launch/{module}.launch.py": "launch.py", "config/{module}.yaml": "parameters.yaml"}
    yield from package_files(interface, templates, options, "ros2", f"{name}/bridge.py", own)
    yield from (GeneratedFile(f"{name}/{empty}", "") for empty in (f"resource/{name}", f"{name}/__init__.py"))
