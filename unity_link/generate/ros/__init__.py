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


def package_files(
    interface: Interface, templates: Templates, options: Options, target: str, program: str, own: dict[str, str]
) -> Iterator[GeneratedFile]:
    """Make a package: its program, its spec, its test, and the files of a target.

    Args:
        interface: the program is its bridge.
        templates: of the target.
        options: that the user has chosen.
        target: ``"ros1"`` or ``"ros2"``.
        program: path of the program in the package; the spec is in the same folder.
        own: templates of the target by the paths of their files, in which ``{module}`` is the name of the robot.
    """
    root, folder = package_name(interface), program.partition("/")[0]
    values: dict[str, Any] = {
        **options._asdict(),
        "target": target,
        "folder": folder,
        "package": root,
        "interface": interface.name,
        "module": module_name(interface),
        "parameters": {parameter.name: parameter.value for parameter in interface.parameters},
        "description": next(iter(interface.doc.splitlines()), "") or f"The robot {interface.name} behind Unity-Link.",
    }
    for name, template in own.items():
        text = templates.render(template, **values)
        yield GeneratedFile(f"{root}/{name.format(module=values['module'])}", text)
    common = templates.of("ros", {})
    common.origin = templates.origin
    for name in ("package.xml", "README.md", "test/test_spec.py"):
        yield GeneratedFile(f"{root}/{name}", common.render(name.rpartition("/")[2], **values))
    yield GeneratedFile(f"{root}/{program}", common.render("bridge.py", **values), executable=True)
    # The description is the spec as one file, whatever it imports.
    spec, maps = unpack(interface.describe_open())
    yield GeneratedFile(f"{root}/{folder}/{values['module']}.ul", common.render("spec.ul", text=spec))
    for name, text in ((word.lower(), text) for word, text in maps.items()):
        if not (INSTALLED / name).is_dir():
            yield GeneratedFile(f"{root}/{folder}/cores/{name}/{name}.ul", common.render("spec.ul", text=text))
