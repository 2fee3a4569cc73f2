"""The Verilog has the crossings of the VHDL: their attributes, and the names by which constraints find them."""

from __future__ import annotations

import functools
import itertools
import re
import tkinter as tk
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, NamedTuple

import pytest

from gateware.bench.runner import GATEWARE
from gateware.bench.verilog.hierarchy import Place, registers
from gateware.tools.verilog import RELEASES
from unity_link.gateware.cache import core_folders, vhdl_sources
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.registers import with_names

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

pytestmark = [pytest.mark.slow, pytest.mark.rtl]
ATTRIBUTES = ["async_reg", "shreg_extract", "keep", "syn_keep", "syn_preserve", "syn_srlstyle", "altera_attribute"]
CONSTRAINTS = GATEWARE / "constraints"
_COMMANDS = ("set_false_path", "set_max_delay")
_FINDERS = ("get_cells", "get_regs", "get_registers", "get_pins")
_OTHERS = (
    *("create_clock", "create_generated_clock", "get_ports", "get_clocks", "get_property", "set_input_delay"),
    *("set_output_delay", "set_bus_skew", "set_net_delay", "set_max_skew", "set_property"),
)


@functools.cache
def released(name: str) -> str:
    return RELEASES[name].text(name)


@functools.cache
def placed(name: str) -> list[Place]:
    return registers(released(name), name)


class Tool(NamedTuple):
    """Names that a tool gives to a register, and to its asynchronous reset."""

    files: str
    name: Callable[[Place], str]
    reset: str = ""


def slashes(place: Place) -> str:
    return "/".join((*place.labels, f"{place.name}[0]"))


def _vivado(place: Place) -> str:
    return "/".join((*place.labels, f"{place.name}_reg[0]"))


def _quartus(place: Place) -> str:
    parts = (f"{entity}:{label}" for entity, label in zip(place.entities[1:], place.labels, strict=True))
    return "|".join((*parts, f"{place.name}[0]"))


TOOLS = {
    "vivado": Tool("vivado/ul_*.xdc", _vivado, "/PRE"),
    "quartus": Tool("quartus/*.sdc", _quartus, "|clrn"),
    "gowin": Tool("gowin/*.sdc", slashes),
    "diamond": Tool("lattice/*.lpf", slashes),
    "radiant": Tool("lattice/*.pdc", slashes),
    "efinity": Tool("efinity/*.sdc", slashes),
}


class _Rule(NamedTuple):
    """Constraint on the paths between registers; patterns of their names, empty for any."""

    command: str
    origin: str
    end: str
    scope: str
    """In Vivado, the entity for which it is read; empty for a whole design."""


def _exceptions(tool: str) -> Iterator[_Rule]:
    for path in sorted(CONSTRAINTS.glob(TOOLS[tool].files)):
        scope = path.stem if tool == "vivado" else ""
        yield from _of_lpf(path) if path.suffix == ".lpf" else _of_tcl(path, scope)


def _of_lpf(path: Path) -> Iterator[_Rule]:
    text = path.read_text()
    for origin, end in re.findall(r'^MAXDELAY FROM CELL "(.*)" TO CELL "(.*)" \d+ NS;$', text, re.MULTILINE):
        yield _Rule("set_max_delay", origin, end, "")
    for end in re.findall(r'^BLOCK PATH TO CELL "(.*)";$', text, re.MULTILINE):
        yield _Rule("set_false_path", "", end, "")


def _of_tcl(path: Path, scope: str) -> list[_Rule]:
    """Read a file with Tcl, and return its constraints."""
    tcl, found = tk.Tcl(), list[_Rule]()

    def note(command: str, *words: str) -> str:
        given = dict(itertools.pairwise(words))
        if "-hold" not in words:
            found.append(_Rule(command, given.get("-from", ""), given.get("-to", ""), scope))
        return ""

    for command in _COMMANDS:
        tcl.createcommand(command, functools.partial(note, command))
    for command in _FINDERS:
        # The last word is a pattern, or a filter with a pattern.
        tcl.createcommand(command, lambda *words: words[-1].rpartition("=~ ")[2])
    for command in _OTHERS:
        tcl.createcommand(command, lambda *_: "")
    tcl.createcommand("get_collection_size", lambda *_: 1)
    tcl.eval(re.sub(r"^//.*$", "", path.read_text(), flags=re.MULTILINE))
    return found


def _finds(tool: str, pattern: str, place: Place, scope: str) -> bool:
    if scope:
        if scope not in place.entities:
            return False
        depth = place.entities.index(scope)
        place = Place(place.entities[depth:], place.labels[depth:], place.name)
    name = TOOLS[tool].name(place)
    # Brackets are part of the names of bits here, not a choice of characters.
    wanted = pattern.replace("[*]", "*")
    return any(fnmatchcase(name.replace("[0]", end), wanted) for end in ("0", TOOLS[tool].reset))


def _label(place: Place) -> str:
    return place.labels[-1] if place.labels else ""


def _crosses(place: Place) -> bool:
    """Return whether a register samples a bit, or a reset, from another clock or from no clock."""
    if place.name == "meta":
        is_pointer = "ul_fifo_async" in place.entities
        return (_label(place).endswith("_crossing") and not is_pointer) or place.entities[-1] == "ul_reset_synchroniser"
    return "ul_ft245_async" in place.entities and _label(place) in ("receive_flag", "transmit_flag")


@pytest.mark.parametrize("name", RELEASES)
def test_each_register_of_a_crossing_has_its_attributes(name: str) -> None:
    lines = released(name).splitlines()
    found = [place for place, line in enumerate(lines) if re.match(r"  reg (\[\d+:0\] )?(meta|settled_\d)\b", line)]
    assert len(found) >= 2
    for place in found:
        for attribute in ATTRIBUTES:
            assert f"{attribute} = " in lines[place - 1], f"{attribute} before {lines[place]}"
        assert "/* synthesis syn_keep=1 syn_preserve=1" in lines[place]


@pytest.mark.parametrize("name", RELEASES)
def test_every_register_has_a_name_of_the_vhdl(name: str) -> None:
    assert [place for place in placed(name) if re.fullmatch(r"n\d+_(q|data)", place.name)] == []


@pytest.mark.parametrize("tool", TOOLS)
@pytest.mark.parametrize("name", RELEASES)
def test_constraints_of_each_tool_cover_every_crossing(name: str, tool: str) -> None:
    exceptions = list(_exceptions(tool))
    for place in placed(name):
        told = {one.command for one in exceptions if _finds(tool, one.end, place, one.scope)}
        wanted = {"set_false_path"} if _crosses(place) else set()
        if "ul_fifo_async" in place.entities and place.name in {"meta", "out_data"}:
            wanted = {"set_max_delay"}
        assert told == wanted, place


@functools.cache
def of_core(entity: str) -> tuple[Place, ...]:
    """Return the registers of the entity of a core, which no release contains.

    GHDL appends the values of generics to the names of entities, and removes the name of the top from their beginning.
    """
    sources = vhdl_sources()
    known = sorted((source.stem for source in sources), key=len, reverse=True)

    def named(written: str) -> str:
        return next((name for name in known if written.startswith(name) or f"{entity}_{written}".startswith(name)), "")

    verilog = with_names(to_verilog(entity).read_text(), sources)
    return tuple(place._replace(entities=tuple(map(named, place.entities))) for place in registers(verilog, entity))


@pytest.mark.parametrize("tool", TOOLS)
def test_every_constraint_matches_a_crossing(tool: str) -> None:
    everything = [place for name in RELEASES for place in placed(name)]
    everything += [place for core in core_folders() for place in of_core(f"ul_{core.name}")]
    for one in _exceptions(tool):
        for pattern in filter(None, (one.origin, one.end)):
            assert any(_finds(tool, pattern, place, one.scope) for place in everything), pattern
