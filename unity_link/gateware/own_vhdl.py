"""VHDL of a user's own: its units, its ports, and how it becomes Verilog together with the gateware.

GHDL alone reads it. What it says of these files comes with the names that the user gave them.
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

# GHDL writes no blank behind an extended identifier, and there Verilog's would end.
_EXTENDED = re.compile(r"\\([^\\\n]+)\\(?=[\s,;:)\]}])")


class Own(NamedTuple):
    """VHDL of a user's: a top with what it needs, or entities that a generated top needs."""

    top: str | None
    """Name of the entity, in small letters; None for entities that stand in a generated top."""
    files: tuple[OwnFile, ...]
    """In compile order; that of the top is the last one."""
    units: dict[str, Path]
    """Files of the entities and packages, by their names in small letters."""
    unchecked: bool = False
    """True if the Verilog of the entities is not compared with GHDL's simulation."""


class Port(NamedTuple):
    """A port of a converted entity."""

    name: str
    """In small letters."""
    spelled: str
    """As the user spelled it."""
    way: str
    """Direction: input, output, inout."""
    width: int
    """Width of the vector in Verilog; 0 for one bit."""
    indexes: tuple[int, ...] | None
    """Indexes in VHDL from the rightmost element on; None for what is no vector."""


class Converted(NamedTuple):
    """A user's top in Verilog."""

    verilog: str
    module: str
    generics: dict[str, int | str]
    """Values of the generics that the entity has of those that were offered."""
    ports: tuple[Port, ...]
    remarks: tuple[str, ...]
    """Warnings about the user's files."""
    compared: tuple[str, ...] = ()
    """The entities that were compared with GHDL's simulation, with the numbers of cycles."""


def read_own(top: Path | None, others: Sequence[Path] = ()) -> Own:
    """Read a user's files.

    Args:
        top: the file of the top, an entity of the file's name; None where a generated one is the top.
        others: further files, in compile order.

    Raises:
        ArgumentError: where a file cannot be read, the top has no entity of its name, or two files have a unit alike.
        ConversionError: where GHDL finds one that is no VHDL.
        ToolMissingError: if there is no GHDL that can be used.
    """
    return own_of(top, [_read(path) for path in (*others, *([] if top is None else [top]))])


def own_of(top: Path | None, files: Sequence[OwnFile]) -> Own:
    """Return a user's files, in compile order, as `read_own` does.

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
    """Check that the entities of all components have a file; those of installed cores are of the gateware.

    Raises:
        ArgumentError: for the first one that none has.
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
    """Convert a user's top with the gateware and what is generated from a spec.

    Args:
        own: the top and its files.
        generics: values for those of its generics that it has.
        generated: VHDL files of the library `work` that are not the user's.
        pads: whose registers are at the pins, as in `vhdl_sources`.
        generated_top: the entity that is the top where the user has none.
        instances: instances of the user's entities in the generated files, which are checked with the user's top; None
            if the Verilog is not used.

    Raises:
        ArgumentError: where a unit has the name of one that is generated or of the gateware, or a generic has no value.
        ConversionError: if GHDL refuses the sources, or its Verilog is another circuit, or that cannot be checked.
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
            # GHDL would take the least value.
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
    """Return name and ports of the module that an entity has become."""
    module = re.search(rf"^module ({re.escape(entity)})\b(.*?);$", verilog, re.MULTILINE | re.DOTALL | re.IGNORECASE)
    assert module is not None  # GHDL was asked for it.
    ports = []
    for way, left, spelled in _PORT.findall(module[2]):
        plain = spelled.strip().removeprefix("\\")
        width = int(left) + 1 if left else 0
        # A port of a record is several in Verilog.
        declared = described.ports.get(plain.lower())
        indexes = None if declared is None else declared.indexes(max(width, 1))
        ports.append(Port(plain.lower(), plain, way, width, indexes))
    return module[1], tuple(ports)
