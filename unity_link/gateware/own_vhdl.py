"""VHDL of a user's own: its units, its ports, and how it becomes Verilog together with the gateware.

GHDL alone reads it. What it says of these files comes with the names that the user gave them.
"""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING, NamedTuple
from xml.etree import ElementTree as ET

from unity_link.errors import ArgumentError
from unity_link.files import digest_of
from unity_link.gateware.cache import LIBRARY, vhdl_sources
from unity_link.gateware.convert import STD, UNBOUND, ConversionError, as_options, cleaned
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.ghdl import converting_ghdl

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from unity_link.gateware.ghdl import Ghdl
    from unity_link.spec import Interface

_UNIT = re.compile(r"^(entity|package) (?!body )(\w+)", re.MULTILINE)
_SAID = re.compile(r"^(?P<place>(?P<file>.+?):\d+:\d+):(?P<kind>error|warning): *(?P<words>.+)$")
_PORT = re.compile(r"^ *\(? *(input|output|inout) +(?:\[(\d+):0\] *)?(\\\S+ |\w+)[,)]", re.MULTILINE)

# GHDL writes no blank behind an extended identifier, and there Verilog's would end.
_EXTENDED = re.compile(r"\\([^\\\n]+)\\(?=[\s,;:)\]}])")


class OwnFile(NamedTuple):
    """A file of a user's."""

    path: Path
    """As the user named it."""
    data: bytes

    @property
    def digest(self) -> str:
        """SHA-256 in hex."""
        return digest_of(self.data)


class Own(NamedTuple):
    """VHDL of a user's: a top with what it needs, or entities that a generated top needs."""

    top: str | None
    """Name of the entity, in small letters; None for entities that stand in a generated top."""
    files: tuple[OwnFile, ...]
    """In compile order; that of the top is the last one."""
    units: dict[str, Path]
    """Files of the entities and packages, by their names in small letters."""


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
    files = tuple(_read(path) for path in (*others, *([] if top is None else [top])))
    ghdl = converting_ghdl()
    units: dict[str, Path] = {}
    found: list[tuple[str, str]] = []
    with temporary_folder() as scratch:
        for file, copy in _copies(files, scratch).items():
            found = _UNIT.findall(_run(ghdl, scratch, files, "-f", STD, str(copy)))
            for kind, name in found:
                if name.lower() in units:
                    raise ArgumentError(f"{file.path} has the {kind} {name}, and so has {units[name.lower()]}")
                units[name.lower()] = file.path
    if top is None:
        return Own(None, files, units)
    entities = [name for kind, name in found if kind == "entity"]
    if top.stem.lower() not in entities:
        kind = "entities" if len(entities) > 1 else "entity"
        has = f"{top} has the {kind} {', '.join(entities)}" if entities else f"{top} has no entity"
        raise ArgumentError(f"{has}, and the top is the entity of its file's name: {top.stem} was expected")
    return Own(top.stem.lower(), files, units)


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
) -> Converted:
    """Convert a user's top with the gateware and what is generated from a spec.

    Args:
        own: the top and its files.
        generics: values for those of its generics that it has.
        generated: VHDL files of the library `work` that are not the user's.
        pads: whose registers are at the pins, as in `vhdl_sources`.
        generated_top: the entity that is the top where the user has none.

    Raises:
        ArgumentError: where a unit has the name of one that is generated or of the gateware, or a generic has no value.
        ConversionError: where GHDL refuses the sources.
        ToolMissingError: if there is no GHDL that can be used.
    """
    gateware = vhdl_sources(pads)
    for kind, paths in (("made from the spec or comes with it", generated), ("one of the gateware", gateware)):
        for name in own.units.keys() & {path.stem for path in paths}:
            raise ArgumentError(f"{own.units[name]} has {name}, which is {kind}: leave it out, or give it another name")
    ghdl = converting_ghdl()
    with temporary_folder() as scratch:
        copies = [*_copies(own.files, scratch).values()]
        anywhere = [STD, UNBOUND, f"--workdir={scratch}"]

        def run(*arguments: str) -> str:
            return _run(ghdl, scratch, own.files, *arguments, said=said)

        said: list[str] = []
        run("import", *anywhere, f"--work={LIBRARY}", *map(str, gateware))
        run("import", *anywhere, *map(str, (*(path.resolve() for path in generated), *copies)))
        top = own.top or generated_top
        of_top = copies[-1] if own.top else next(path.resolve() for path in generated if path.stem == top)
        run("make", *anywhere, top)
        described = _described(run("--file-to-xml", *anywhere, str(of_top)), top)
        given = {name: value for name, value in generics.items() if name in described.generics}
        for name, has_default in described.generics.items():
            # GHDL would take the least value.
            if not has_default and name not in given:
                raise ArgumentError(
                    f"{top} has a generic {name} without a default; {' and '.join(generics)} get values"
                )
        verilog = run("synth", *anywhere, "--out=verilog", *as_options(given), top)
    of_own = [words for words in said if any(words.startswith(f"{file.path}:") for file in own.files)]
    if extended := _EXTENDED.search(verilog):
        raise ConversionError(
            f"{top} has the extended identifier \\{extended[1]}\\, which does not go through GHDL into Verilog: "
            "a name of letters, digits and '_' was expected"
        )
    module, ports = _ports(verilog, top, described)
    return Converted(cleaned(verilog), module, given, ports, tuple(dict.fromkeys(of_own)))


def _read(path: Path) -> OwnFile:
    try:
        return OwnFile(path, path.read_bytes())
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror or error}") from None


def _copies(files: Sequence[OwnFile], folder: Path) -> dict[OwnFile, Path]:
    """Write the files as GHDL gets them, under names that say nothing to it, and return their paths."""
    copies = {file: folder / f"own-{place}.vhd" for place, file in enumerate(files)}
    for file, copy in copies.items():
        copy.write_bytes(file.data)
    return copies


def _named(words: str, files: Sequence[OwnFile]) -> str:
    """Return what GHDL says of a copy with the name that the user gave it."""
    return re.sub(r"^.*?\bown-(\d+)\.vhd(?=:)", lambda found: str(files[int(found[1])].path), words)


def _run(ghdl: Ghdl, work: Path, files: Sequence[OwnFile], *arguments: str, said: list[str] | None = None) -> str:
    """Run GHDL; return what it prints, and note its warnings.

    Raises:
        ConversionError: where it finds an error; the message is the first one, with the user's name of the file.
    """
    try:
        done = ghdl.run(*arguments, cwd=work)
        stdout, stderr, failed = done.stdout, done.stderr, False
    except subprocess.CalledProcessError as error:
        stdout, stderr, failed = error.stdout, error.stderr, True
    found = [match for line in stderr.splitlines() if (match := _SAID.match(line))]
    errors = [_named(f"{match['place']}: {match['words']}", files) for match in found if match["kind"] == "error"]
    if errors or failed:
        lines = [line.rpartition("error: ")[2] for line in stderr.splitlines() if line.strip(" *")]
        first = errors[0] if errors else f"GHDL failed: {(lines or ['no reason given'])[0]}"
        more = f" (and {len(errors) - 1} more)" if errors[1:] else ""
        raise ConversionError(f"{first}{more}")
    if said is not None:
        said += [_named(f"{match['place']}: {match['words']}", files) for match in found]
    return stdout


class _Described(NamedTuple):
    """An entity as GHDL understands it."""

    generics: dict[str, bool]
    """True for those with a default."""
    ports: dict[str, ET.Element | None]
    """For each port the range of a vector; None for what is no vector."""


def _described(text: str, entity: str) -> _Described:
    tree = ET.fromstring(text)  # noqa: S314  (of GHDL's own writing)
    by_id = {element.get("id"): element for element in tree.iter() if element.get("id")}
    (unit,) = (
        unit
        for unit in tree.iter("library_unit")
        if unit.get("kind") == "entity_declaration" and unit.get("identifier") == entity
    )

    def range_of(port: ET.Element) -> ET.Element | None:
        reference = port.find("type")
        kind = by_id.get(reference.get("ref")) if reference is not None else None
        return kind.find("index_constraint_list/el/range_constraint") if kind is not None else None

    generics = {
        str(one.get("identifier")): one.find("default_value") is not None for one in unit.iterfind("generic_chain/el")
    }
    return _Described(
        generics, {str(port.get("identifier")): range_of(port) for port in unit.iterfind("port_chain/el")}
    )


def _ports(verilog: str, entity: str, described: _Described) -> tuple[str, tuple[Port, ...]]:
    """Return name and ports of the module that an entity has become."""
    module = re.search(rf"^module ({re.escape(entity)})\b(.*?);$", verilog, re.MULTILINE | re.DOTALL | re.IGNORECASE)
    assert module is not None  # GHDL was asked for it.
    ports = []
    for way, left, spelled in _PORT.findall(module[2]):
        plain = spelled.strip().removeprefix("\\")
        width = int(left) + 1 if left else 0
        bounds = described.ports.get(plain.lower())
        ports.append(Port(plain.lower(), plain, way, width, _indexes(bounds, max(width, 1))))
    return module[1], tuple(ports)


def _indexes(bounds: ET.Element | None, count: int) -> tuple[int, ...] | None:
    """Return the indexes of a vector from its rightmost element on."""
    if bounds is None:
        return None
    step = -1 if bounds.get("direction") == "to" else 1
    for end in ("right", "left"):
        limit = bounds.find(f"{end}_limit_expr")
        if limit is not None and limit.get("kind") == "integer_literal":
            right = int(str(limit.get("value"))) - (step * (count - 1) if end == "left" else 0)
            return tuple(right + step * place for place in range(count))
    return None
