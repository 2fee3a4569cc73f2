"""What packages of ROS 1 and ROS 2 have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.generate import GeneratedFile, python
from unity_link.generate.python.classes import describe, module_name

if TYPE_CHECKING:
    from unity_link.generate import Templates
    from unity_link.spec import Interface


_ARGUMENTS = frozenset({"link", "namespace"})
"""Of the launch files, beside the parameters of the interface."""


def package_name(interface: Interface) -> str:
    """Return the name of the package; ROS wants small letters (REP 144)."""
    return f"{interface.name.lower().strip('_')}_unity_link"


def robot_module(interface: Interface, templates: Templates) -> GeneratedFile:
    """Make the module of the robot, which the package's program opens."""
    (module,) = python.files(interface, templates.of("python", python.FILTERS))
    return module


def names(interface: Interface) -> dict[str, Any]:
    """Return what every template sees."""
    module = module_name(interface)
    return {
        "package": package_name(interface),
        "interface": interface.name,
        "parameters": {name: f"{name}_" if name in _ARGUMENTS else name for name in interface.open_parameters},
        "module": module,
        "robot": describe(interface).robot.name,
        "description": next(iter(interface.doc.splitlines()), "") or f"The robot {interface.name} behind Unity-Link.",
    }
