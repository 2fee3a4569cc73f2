"""Lists the builds of the gateware in an installation, and selects one by the fields of its configuration.

The index of the archive has the answer of each build to `Q`, so that selecting a build unpacks and compiles nothing.
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
    """Names and texts of the VHDL files; the last file has the top, which has the file's name."""
    masters: tuple[tuple[str, int], ...]
    """Wishbone masters of the design: prefix of the names of their ports, and their first address."""
    own: tuple[tuple[str, str], ...] = ()
    """Paths and texts of a user's VHDL files."""
    instances: tuple[OwnInstance, ...] = ()
    """Instances of the entities in the user's files."""
    unchecked: bool = False
    """True if the Verilog of these entities is not compared with GHDL's simulation."""

    @property
    def top(self) -> str:
        """Name of the top entity."""
        return self.sources[-1][0].removesuffix(".vhd")


class Configuration(msgspec.Struct, frozen=True):
    """One build of the gateware."""

    name: str
    info: GatewayInfo
    digest: str
    """Hash of its C++."""
    node: int | None
    """Node number on a shared medium; None if the medium is not shared."""
    generics: str = ""
    """Generics as JSON, if the C++ must be made from them; empty for a build in the installation."""
    path: str = ""
    """Path of the C++ that was made from the generics."""
    design: Design | None = None
    """The design around the gateway; None for a gateway alone."""

    def made(self, path: Path) -> Configuration:
        """Return the configuration with the path of its C++."""
        return msgspec.structs.replace(self, path=str(path), digest=path.stem.rpartition("-")[2])

    def text(self) -> bytes:
        """Return its C++.

        Raises:
            ArgumentError: if this installation does not have it.
        """
        if self.path:
            return Path(self.path).read_bytes()
        return archive.text_of(self.name, self.digest)

    def has(self, fields: Mapping[str, int], node: int | None) -> bool:
        """Return True if the configuration has these fields of `GatewayInfo` and this node."""
        return node == self.node and all(getattr(self.info, name) == value for name, value in fields.items())

    def distance(self, other: Configuration) -> int:
        """Return the number of fields in which two configurations differ."""
        return sum(getattr(self.info, name) != getattr(other.info, name) for name in GatewayInfo.__struct_fields__)


@functools.cache
def configurations() -> dict[str, Configuration]:
    """Return the builds in this installation, by name.

    Raises:
        ArgumentError: if their index cannot be read.
    """
    return {
        name: Configuration(name, GatewayInfo.from_hex(entry.answers.encode()), entry.digest, entry.node)
        for name, entry in sorted(archive.read_index(archive.GENERATED).items())
    }


def find(name: str) -> Configuration:
    """Return a build by its name.

    Raises:
        ArgumentError: if there is no such build.
    """
    known = configurations()
    if name not in known:
        raise ArgumentError(f"there is no gateware {name!r}: this installation has {', '.join(known) or 'none'}")
    return known[name]


def choose(fields: Mapping[str, int], node: int | None = None) -> Configuration:
    """Return the build with given fields that is otherwise most similar to the default build.

    A build with a faster clock, which a PC does not simulate in real time, is returned only if no other one matches.

    Args:
        fields: required fields of `GatewayInfo`.
        node: required node number on a shared medium; None if the medium is not shared.

    Raises:
        ArgumentError: if no build matches.
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
    """Return the values of a build's fields in the form of URL options."""
    values = {name: int(getattr(candidate.info, name)) for name in fields}
    if node is not None and candidate.node is not None:
        values["node"] = candidate.node
    return "&".join(f"{name}={value}" for name, value in values.items()) or "no node"
