"""ROS 1: a package with a node and its launch file, for rospy of any distribution with Python from 3.8.

The node is `scripts/bridge`, its modules beside it those of `unity_link.generate.ros`; the rest is what catkin wants.
`unity-link ros1` is the quicker bridge, and needs no package, but a Python from 3.11.
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

DOC = "a package of ROS 1: a node for catkin and roslaunch"


def files(interface: Interface, templates: Templates, package: Options) -> Iterator[GeneratedFile]:
    """Make the files of a package."""
    seen = names(interface, package)
    folder = seen["package"]
    modules = list(runtime(interface, templates, dot=""))
    yield GeneratedFile(f"{folder}/package.xml", templates.render("package.xml", **seen))
    listed = [module.name for module in modules]
    yield GeneratedFile(f"{folder}/CMakeLists.txt", templates.render("CMakeLists.txt", modules=listed, **seen))
    yield GeneratedFile(f"{folder}/launch/{seen['module']}.launch", templates.render("bridge.launch", **seen))
    yield GeneratedFile(f"{folder}/scripts/bridge", templates.render("node.py", **seen), executable=True)
    for module in modules:
        yield module._replace(name=f"{folder}/scripts/{module.name}")
    yield GeneratedFile(f"{folder}/README.md", templates.render("README.md", **seen))
