"""Loading of specs as classes of robots."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.cores import Verbs, classes_of, robot_verbs_of
from unity_link.data.robot import Component, Robot, class_name
from unity_link.errors import ArgumentError
from unity_link.spec.model import Interface, Spec

if TYPE_CHECKING:
    from pathlib import Path


class LoadedRobot(Robot):
    """A robot whose class was made at run time; type checkers do not know its attributes."""

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...


def load(spec: str | Path | Spec, interface: str | None = None) -> type[LoadedRobot]:
    """Return the class of a public interface; see `unity_link.load`.

    Raises:
        SpecError: with all errors of the spec.
        ArgumentError: if the spec has no such interface, or the Python of a core cannot be imported.
    """
    if not isinstance(spec, Spec):
        if not isinstance(spec, (str, os.PathLike)):
            raise ArgumentError(f"the path of a spec was expected, or a compiled one, not {spec!r:.80}")
        if "{" in str(spec):
            raise ArgumentError(
                "the path of a spec was expected, not its text: `unity_link.spec.compile_text` takes that"
            )
        from unity_link.spec import compile_file

        spec = compile_file(spec)
    described = spec.interface(interface)
    types = {part.type: (*classes_of(part.core, Verbs), Component) for part in described.root.walk() if part.path}
    return type(
        class_name(described.name),
        (*robot_verbs_of(described), LoadedRobot),
        {
            "__doc__": described.doc or f"The interface {described.name}.",
            "interface": described,
            "components": {name: type(class_name(name), types[name], {}) for name in sorted(types)},
            "enumerations": {known.name: known.python_type for known in described.enumerations},
        },
    )


def read_interface(text: str) -> Interface:
    """Decode an interface from the JSON that a generated module contains."""
    return msgspec.json.decode(text, type=Interface)
