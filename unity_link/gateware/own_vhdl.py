"""Reads a user's VHDL by GHDL, and converts it to Verilog together with the gateware.

Messages contain the paths of the files as the user wrote them.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ArgumentError
from unity_link.gateware.cache import LIBRARY, vhdl_sources
from unity_link.gateware.convert import cleaned
from unity_link.gateware.design import ConversionError, GhdlDesign, OwnFile
from unity_link.gateware.entity import SyntaxTree
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.own_circuits import OwnInstance, Sources, Top, compare_own
from unity_link.gateware.refused import INTEGER_MINUS_SIGNED, refusals

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from unity_link.gateware.entity import Entity
    from unity_link.spec import Interface

_UNIT = re.compile(r"^(entity|package) (?!body )(\w+)", re.MULTILINE)
_PORT = re.compile(r"^ *\(? *(input|output|inout) +(?:\[(\d+):0\] *)?(\\\S+ |\w+)[,)]", re.MULTILINE)

# An extended identifier: GHDL writes no space after it, which Verilog needs to find its end.
_EXTENDED = re.compile(r"\\([^\\\n]+)\\(?=[\s,;:)\]}])")


class Own(NamedTuple):
    """A user's VHDL: a top and the files that it needs, or entities that a generated top instantiates."""

    top: str | None
    """Name of the user's top in small letters; None if the top is generated."""
    files: tuple[OwnFile, ...]
    """Files in compile order; the file of a top is the last one."""
    units: dict[str, Path]
    """File of each entity and package, by name in small letters."""
    unchecked: bool = False
    """True if the Verilog of the entities is not compared with GHDL's simulation."""


class Port(NamedTuple):
    """A port of a converted entity."""

    name: str
    """Name in small letters."""
    spelled: str
    """Name as the user wrote it."""
    way: str
    """Direction: input, output or inout."""
    width: int
    """Width of the vector in Verilog; 0 for one bit."""
    indexes: tuple[int, ...] | None
    """Indexes in VHDL, rightmost element first; None if the port is not a vector."""


class Converted(NamedTuple):
    """A user's top in Verilog."""

    verilog: str
    module: str
    generics: dict[str, int | str]
    """Values of the entity's generics, as far as the caller gave any."""
    ports: tuple[Port, ...]
    remarks: tuple[str, ...]
    """Warnings about the user's files."""
    compared: tuple[str, ...] = ()
    """Entities that were compared with GHDL's simulation, with the number of cycles of each."""


def read_own(top: Path | None, others: Sequence[Path] = ()) -> Own:
    """Read a user's files.

    Args:
        top: file of the top, which must contain an entity of the file's name; None if the top is generated.
        others: further files, in compile order.

    Raises:
        ArgumentError: if a file cannot be read, the top has no entity of its file's name, or two files have units of
            the same name.
        ConversionError: if GHDL refuses a file.
        ToolMissingError: if there is no GHDL that can be used.
    """
    return own_of(top, [_read(path) for path in (*others, *([] if top is None else [top]))])


def own_of(top: Path | None, files: Sequence[OwnFile]) -> Own:
    """Return a user's VHDL from files in compile order, as `read_own` does.

    Raises:
        ArgumentError: as `read_own`.
        ConversionError: as `read_own`.
        ToolMissingError: as `read_own`.
    """
    units: dict[str, Path] = {}
    found: list[tuple[str, str]] = []
    with temporary_folder() as scratch:
        design = GhdlDesign(scratch, own=files)
        for file, copy in design.copies.items():
            found = _UNIT.findall(design.run("-f", str(copy)))
            for kind, name in found:
                if name.lower() in units:
                    raise ArgumentError(f"{file.path} has the {kind} {name}, and so has {units[name.lower()]}")
                units[name.lower()] = file.path
    if top is None:
        return Own(None, tuple(files), units)
    entities = [name for kind, name in found if kind == "entity"]
    if top.stem.lower() not in entities:
        kind = "entities" if len(entities) > 1 else "entity"
        has = f"{top} has the {kind} {', '.join(entities)}" if entities else f"{top} has no entity"
        raise ArgumentError(f"{has}, and the top is the entity of its file's name: {top.stem} was expected")
    return Own(top.stem.lower(), tuple(files), units)


def check_entities(interface: Interface, own: Own | None) -> None:
    """Check that the entity of each component is in the gateware or in a user's file.

    Raises:
        ArgumentError: if no file has an entity; the message names the first one.
    """
    units = {} if own is None else own.units
    for part in interface.cores:
        core = part.core
        if core is None or core.library == LIBRARY or core.entity in units:
            continue
        if core.word:
            raise ArgumentError(
                f"{part.path} is a {core.word}, and no .vhd in the folder of that core has its entity {core.entity}"
            )
        raise ArgumentError(
            f"{part.path} has the entity {core.entity}, which no file has: name its file by --vhdl FILE.vhd"
        )


def convert_own(
    own: Own,
    generics: Mapping[str, int | str],
    generated: Sequence[Path] = (),
    pads: str | None = None,
    generated_top: str = "",
    instances: Sequence[OwnInstance] | None = None,
) -> Converted:
    """Convert a top, a user's or a generated one, together with the user's files and the gateware.

    Args:
        own: the user's files.
        generics: values of generics; those that the top does not have are ignored.
        generated: generated VHDL files of the library `work`.
        pads: vendor of the registers at the pins, as in `vhdl_sources`.
        generated_top: name of the generated top, if the user has none.
        instances: instances of the user's entities in the generated files, to be compared with GHDL's simulation, as is
            the user's top. None compares nothing; use it only if the Verilog is not used.

    Raises:
        ArgumentError: if a user's unit has the name of a generated one or of one in the gateware, or a generic has no
            value.
        ConversionError: if GHDL refuses the sources, or the Verilog is another circuit or cannot be compared.
        ToolMissingError: if there is no GHDL that can be used.
    """
    gateware = vhdl_sources(pads)
    for kind, paths in (("made from the spec or comes with it", generated), ("one of the gateware", gateware)):
        for name in own.units.keys() & {path.stem for path in paths}:
            raise ArgumentError(f"{own.units[name]} has {name}, which is {kind}: leave it out, or give it another name")
    with temporary_folder() as scratch:
        design = GhdlDesign(scratch, gateware, generated, own.files)
        top = own.top or generated_top
        design.make(top)
        of_top = [] if own.top else [next(path for path in generated if path.stem == top)]
        tree = SyntaxTree(design.description(*design.copies.values(), *of_top))
        entities = tree.entities()
        described = entities[top]
        given = {name: value for name, value in generics.items() if name in described.generics}
        for name, generic in described.generics.items():
            # Without a value GHDL would use the lowest value of the type.
            if not generic.has_default and name not in given:
                raise ArgumentError(
                    f"{top} has a generic {name} without a default; {' and '.join(generics)} get values"
                )
        verilog = design.verilog(top, given)
        if extended := _EXTENDED.search(verilog):
            raise ConversionError(
                f"{top} has the extended identifier \\{extended[1]}\\, which does not go through GHDL into Verilog: "
                "a name of letters, digits and '_' was expected"
            )
        module, ports = _ports(verilog, top, described)
        compared: list[str] = []
        if instances is not None:
            turned = tree.operators(INTEGER_MINUS_SIGNED)
            faults = refusals(verilog, design, lambda: design.netlist(top, given), turned)
            if faults:
                raise ConversionError(f"{faults[0]}{f' (and {len(faults) - 1} more)' if faults[1:] else ''}")
            if not own.unchecked:
                sources = Sources(gateware, generated, own.files, own.units)
                of_user = Top(top, module, given) if own.top else None
                users = {name: entity for name, entity in entities.items() if name in own.units}
                compared = compare_own(sources, design, verilog, users, instances, of_user)
    remarks = dict.fromkeys(str(message) for message in design.messages if message.is_own)
    return Converted(cleaned(verilog), module, given, ports, tuple(remarks), tuple(compared))


def _read(path: Path) -> OwnFile:
    try:
        return OwnFile(path, path.read_bytes())
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror or error}") from None


def _ports(verilog: str, entity: str, described: Entity) -> tuple[str, tuple[Port, ...]]:
    """Return the name and the ports of an entity's module."""
    module = re.search(rf"^module ({re.escape(entity)})\b(.*?);$", verilog, re.MULTILINE | re.DOTALL | re.IGNORECASE)
    assert module is not None  # GHDL was asked for it.
    ports = []
    for way, left, spelled in _PORT.findall(module[2]):
        plain = spelled.strip().removeprefix("\\")
        width = int(left) + 1 if left else 0
        # A record becomes several ports in Verilog, which are not declared in the VHDL.
        declared = described.ports.get(plain.lower())
        indexes = None if declared is None else declared.indexes(max(width, 1))
        ports.append(Port(plain.lower(), plain, way, width, indexes))
    return module[1], tuple(ports)
