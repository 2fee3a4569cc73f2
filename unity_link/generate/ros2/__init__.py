"""ROS 2: a colcon package that starts `unity-link ros2`, with its launch file, its parameters and the spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.ros import Options, common, names

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

__all__ = ["DOC", "Options", "files"]

DOC = "a package of ROS 2 that starts unity-link ros2: for colcon and ros2 launch"


def files(interface: Interface, templates: Templates, package: Options) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    seen = names(interface, package)
    folder = module_folder = seen["package"]
    for name in ("package.xml", "setup.py", "setup.cfg", "README.md"):
        yield GeneratedFile(f"{folder}/{name}", templates.render(name, **seen))
    yield GeneratedFile(f"{folder}/resource/{module_folder}", "")
    yield GeneratedFile(f"{folder}/launch/{seen['module']}.launch.py", templates.render("launch.py", **seen))
    yield GeneratedFile(f"{folder}/config/{seen['module']}.yaml", templates.render("parameters.yaml", **seen))
    yield GeneratedFile(f"{folder}/{module_folder}/__init__.py", "")
    yield from common(interface, templates, "ros2", module_folder, "bridge.py", seen)
