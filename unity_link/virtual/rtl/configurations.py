"""The builds of the gateware that an installation has, and which of them a user means.

The generated file of each says in its head what its gateware answers to `Q`, so nothing is compiled to choose one.
"""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError
from unity_link.protocol.configuration import GatewayInfo

if TYPE_CHECKING:
    from collections.abc import Mapping

GENERATED = Path(__file__).parent / "generated"
DEFAULT = "default"
_HEAD_SIZE = 1024
_HEADING = re.compile(r"^// Answers Q with ([0-9A-F]+)(?:, as node (\d+))?\.$", re.MULTILINE)


class Configuration(msgspec.Struct, frozen=True):
    """One build of the gateware."""

    name: str
    source: Path
    info: GatewayInfo
    node: int | None
    """Its number on a medium that several share."""

    def has(self, fields: Mapping[str, int], node: int | None) -> bool:
        """Return whether it is what a user describes."""
        return node == self.node and all(getattr(self.info, name) == value for name, value in fields.items())

    def distance(self, other: Configuration) -> int:
        """Return the number of fields in which it differs from another one."""
        return sum(getattr(self.info, name) != getattr(other.info, name) for name in GatewayInfo.__struct_fields__)


def heading(info: GatewayInfo, node: int | None) -> str:
    """Return the line that a generated file has in its head."""
    text = f"// Answers Q with {info.to_hex().decode()}"
    return f"{text}." if node is None else f"{text}, as node {node}."


@functools.cache
def configurations() -> dict[str, Configuration]:
    """Return what is part of this installation, by name.

    Raises:
        ArgumentError: for a generated file that does not say what it is.
    """
    found = {}
    for source in sorted(GENERATED.glob("*.cc")):
        with source.open() as file:
            match = _HEADING.search(file.read(_HEAD_SIZE))
        if match is None:
            raise ArgumentError(f"{source} does not say what its gateware is: install unity-link anew, or run make rtl")
        info, node = GatewayInfo.from_hex(match[1].encode()), match[2]
        found[source.stem] = Configuration(source.stem, source, info, None if node is None else int(node))
    return found


def find(name: str) -> Configuration:
    """Return a build by its name.

    Raises:
        ArgumentError: for one that there is not.
    """
    known = configurations()
    if name not in known:
        raise ArgumentError(f"there is no gateware {name!r}: this installation has {', '.join(known) or 'none'}")
    return known[name]


def choose(fields: Mapping[str, int], node: int | None = None) -> Configuration:
    """Return the build that has some fields of `GatewayInfo`, and is otherwise as much as can be like the default one.

    One with a quicker clock, which a PC can't keep pace with, is given only if nothing else fits.

    Args:
        fields: what it must have.
        node: the number that it must have on a medium that several share, None for a medium of its own.

    Raises:
        ArgumentError: where none was compiled.
    """
    default, known = find(DEFAULT), configurations().values()
    matching = [candidate for candidate in known if candidate.has(fields, node)]
    if not matching:
        have = sorted({_describe(candidate, fields, node) for candidate in known}, key=lambda text: (len(text), text))
        wanted = "&".join(f"{name}={value}" for name, value in _fields(fields, node).items())
        raise ArgumentError(f"no gateware was compiled with {wanted}: there are {', '.join(have)}")
    return min(
        matching,
        key=lambda candidate: (
            candidate.info.clock_hz > default.info.clock_hz,
            candidate.distance(default),
            candidate.name,
        ),
    )


def _fields(fields: Mapping[str, int], node: int | None) -> dict[str, int]:
    return dict(fields) if node is None else {**fields, "node": node}


def _describe(candidate: Configuration, fields: Mapping[str, int], node: int | None) -> str:
    """Write what a build has in the fields that were asked for, as in a URL."""
    values = {name: int(getattr(candidate.info, name)) for name in fields}
    if node is not None and candidate.node is not None:
        values["node"] = candidate.node
    return "&".join(f"{name}={value}" for name, value in values.items()) or "no node"
