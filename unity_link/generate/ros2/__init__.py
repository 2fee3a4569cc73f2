"""ROS 2: a colcon package with a node on rclpy, its launch file and its parameters, for Python from 3.8.

For those who have a ROS installation, and want a node that `ros2 node list` shows; without one, `unity-link ros2`
speaks to the same topics. The modules beside the node are those of `unity_link.generate.ros`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile
from unity_link.generate.ros import Options, names, runtime

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

__all__ = ["DOC", "Options", "files"]

DOC = "a package of ROS 2: a node on rclpy, for colcon and ros2 launch"


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
    yield GeneratedFile(f"{folder}/{module_folder}/node.py", templates.render("node.py", **seen))
    for module in runtime(interface, templates, dot="."):
        yield module._replace(name=f"{folder}/{module_folder}/{module.name}")
