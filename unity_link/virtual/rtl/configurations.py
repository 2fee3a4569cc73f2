"""The builds of the gateware that an installation has, and which of them a user means.

The index of their archive says of each what its gateware answers to `Q`, so nothing is unpacked or compiled to choose
one.
"""

from __future__ import annotations

import functools
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError
from unity_link.gateware.own_circuits import OwnInstance  # noqa: TC001  (msgspec reads the annotations)
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual.rtl import archive

if TYPE_CHECKING:
    from collections.abc import Mapping

DEFAULT = "default"


class Design(msgspec.Struct, frozen=True):
    """A whole design around a gateway, with a register bank."""

    sources: tuple[tuple[str, str], ...]
    """Names and texts of its VHDL; the last file has its top, which is called as the file is."""
    masters: tuple[tuple[str, int], ...]
    """Its Wishbone masters: what the names of their ports begin with, and where their addresses begin."""
    own: tuple[tuple[str, str], ...] = ()
    """A user's files of VHDL: their names for the user, and their texts."""
    instances: tuple[OwnInstance, ...] = ()
    """Instances of entities of these files."""
    unchecked: bool = False
    """True if the Verilog of these entities is not compared with GHDL's simulation."""

    @property
    def top(self) -> str:
        """Name of its top."""
        return self.sources[-1][0].removesuffix(".vhd")


class Configuration(msgspec.Struct, frozen=True):
    """One build of the gateware."""

    name: str
    info: GatewayInfo
    digest: str
    """Names its C++."""
    node: int | None
    """Its number on a medium that several share."""
    generics: str = ""
    """Generics of a configuration that an installation does not have, as JSON: it is made of these."""
    path: str = ""
    """Path of its C++ then."""
    design: Design | None = None
    """The design around the gateway; None where it is the gateway alone."""

    def made(self, path: Path) -> Configuration:
        """Return the configuration with its C++, which is in a file."""
        return msgspec.structs.replace(self, path=str(path), digest=path.stem.rpartition("-")[2])

    def text(self) -> bytes:
        """Return its C++.

        Raises:
            ArgumentError: where this installation does not have it.
        """
        if self.path:
            return Path(self.path).read_bytes()
        return archive.text_of(self.name, self.digest)

    def has(self, fields: Mapping[str, int], node: int | None) -> bool:
        """Return whether it is what a user describes."""
        return node == self.node and all(getattr(self.info, name) == value for name, value in fields.items())

    def distance(self, other: Configuration) -> int:
        """Return the number of fields in which it differs from another one."""
        return sum(getattr(self.info, name) != getattr(other.info, name) for name in GatewayInfo.__struct_fields__)


@functools.cache
def configurations() -> dict[str, Configuration]:
    """Return what is part of this installation, by name.

    Raises:
        ArgumentError: for an index that does not say what there is.
    """
    return {
        name: Configuration(name, GatewayInfo.from_hex(entry.answers.encode()), entry.digest, entry.node)
        for name, entry in sorted(archive.read_index(archive.GENERATED).items())
    }


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
