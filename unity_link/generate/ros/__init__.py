"""The common part of packages for ROS 1 and ROS 2, which start `unity-link ros1` and `ros2` with a copy of the spec."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.generate import GeneratedFile
from unity_link.generate.python.classes import module_name
from unity_link.spec.cores import INSTALLED
from unity_link.spec.description import unpack

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface


class Options(NamedTuple):
    """Options of a package that the user chooses."""

    maintainer: str = "Maintainer"
    email: str = "user@example.com"
    licence: str = "BSD-3-Clause"


def package_name(interface: Interface) -> str:
    """Return the name of the package; ROS wants small letters, and one of them first (REP 144)."""
    name = interface.name.lower().strip("_")
    return f"{name if name[:1].isalpha() else f'x{name}'}_unity_link"


def names(interface: Interface, package: Options) -> dict[str, Any]:
    """Return what every template sees."""
    return {
        "package": package_name(interface),
        "interface": interface.name,
        "module": module_name(interface),
        "parameters": {parameter.name: parameter.value for parameter in interface.parameters},
        "leases": bool(interface.leases),
        "description": next(iter(interface.doc.splitlines()), "") or f"The robot {interface.name} behind Unity-Link.",
        "maintainer": package.maintainer,
        "email": package.email,
        "licence": package.licence,
    }


def common(
    interface: Interface, templates: Templates, target: str, folder: str, program: str, seen: dict[str, Any]
) -> Iterator[GeneratedFile]:
    """Make the program, its spec and its test.

    Args:
        interface: whose bridge the program is.
        templates: of the target.
        target: ``"ros1"`` or ``"ros2"``.
        folder: of the program in the package.
        program: its name.
        seen: by every template.
    """
    own = templates.of("ros", {})
    own.origin = templates.origin
    root = seen["package"]
    place = f"{root}/{folder}"
    yield GeneratedFile(f"{place}/{program}", own.render("bridge.py", target=target, **seen), executable=True)
    yield GeneratedFile(f"{root}/test/test_spec.py", own.render("test_spec.py", folder=folder, **seen))
    # The description is the spec as one file, whatever it imports.
    spec, maps = unpack(interface.describe_open())
    yield GeneratedFile(f"{place}/{seen['module']}.ul", own.render("spec.ul", text=spec))
    for name, text in ((word.lower(), text) for word, text in maps.items()):
        if not (INSTALLED / name).is_dir():
            yield GeneratedFile(f"{place}/cores/{name}/{name}.ul", own.render("spec.ul", text=text))
