"""The datasheets match the sources: tables, pictures and examples; and each public entity has one."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from gateware.bench.datasheets.stories import PICTURES, SIMULATIONS
from gateware.bench.test_documentation import ghdl
from gateware.tools import generated
from gateware.tools.datasheets import PAGES, entity, filled, sheets
from gateware.tools.entity import Declaration, Group, read_entity
from unity_link.gateware.cache import LIBRARY, board_sources, core_sources, library_of, vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path

    from gateware.bench.datasheets.stories import Simulation

SHEETS = sheets()
ENTITIES = sorted(name for name, page in SHEETS.items() if page.parent == PAGES)
_EXAMPLE = re.compile(r"^```vhdl\n(\w+ : entity .*?)^```$", re.MULTILINE | re.DOTALL)
_INTERNAL = {
    *("unity_link_fifo", "ul_fifo_port", "ul_ft245_pads", "ul_bus_master", "ul_word_memory", "ul_word_ring"),
    *("ul_mac_rx", "ul_mac_tx", "ul_network_rx", "ul_datagram_reader", "ul_datagram_writer"),
    *("ul_answer_ring", "ul_record_ring", "ul_byte_ring", "ul_w5500"),
}
_MOST_BYTES = 60_000


@pytest.mark.parametrize("name", SHEETS)
def test_datasheets_in_the_tree_are_up_to_date(name: str) -> None:
    assert SHEETS[name].read_text() == filled(name), "run make datasheets"


def test_every_entity_has_a_page_or_is_internal() -> None:
    inside = {source.stem for source in vhdl_sources() if source.parent.name in ("application", "datalink")}
    packages = {source.stem for source in vhdl_sources() if source.stem.endswith("_pkg")}
    known = {source.stem for source in [*vhdl_sources(), *board_sources()]}
    known -= {source.stem for source in core_sources()}
    assert set(ENTITIES) == (known - inside - packages - _INTERNAL) | set(generated.ENTITIES)
    listed = re.findall(r"^\| \[(\w+)\]\(\1\.md\)", (PAGES / "index.md").read_text(), re.MULTILINE)
    assert sorted(listed) == ENTITIES


@pytest.mark.parametrize("name", SHEETS)
def test_a_clock_is_a_port_of_the_entity_and_a_number_has_a_range(name: str) -> None:
    described = entity(name)
    ports = {port.name for group in described.ports for port in group.declarations}
    assert {group.clock for group in described.ports} - {""} <= ports
    for group in described.generics:
        assert group.meaning, group
        assert group.range, group


def test_port_without_a_comment_is_refused() -> None:
    text = "entity tried is port (clk : in bit); end entity;"
    with pytest.raises(ValueError, match="clk of tried has no comment that describes it"):
        read_entity(text, "tried", entity)
    with pytest.raises(ValueError, match="the file has no entity other"):
        read_entity(text, "other", entity)


def test_comment_as_of_another_entity_is_copied_from_its_port_there() -> None:
    text = """entity tried is
      generic (
        -- As of ul_fifo_sync; the default is small.
        depth : positive := 4
      );
      port (
        -- As of ul_fifo_sync.
        clk : in std_logic;
        rst : in std_logic;
        {}
      );
    end entity;"""
    there, tried = entity("ul_fifo_sync"), read_entity(text.format("in_valid : in std_logic"), "tried", entity)
    (depth,) = tried.generics
    assert depth.range == "A power of two, at least 2"
    assert depth.meaning.endswith(" The default is small.")
    assert [group.comment for group in tried.ports] == [there.comments[name] for name in ("clk", "rst", "in_valid")]
    with pytest.raises(ValueError, match="gone of tried refers to ul_fifo_sync, which has no gone"):
        read_entity(text.format("gone : in std_logic"), "tried", entity)


@pytest.mark.parametrize("simulation", SIMULATIONS, ids=lambda simulation: "_".join(simulation.pictures))
def test_the_pictures_are_those_of_the_simulation(simulation: Simulation) -> None:
    drawn = dict(simulation.draw())
    assert set(drawn) == set(simulation.pictures)
    for name, text in drawn.items():
        assert len(text) < _MOST_BYTES
        assert (PICTURES / f"{name}.svg").read_text() == text, "run make datasheets"


def test_every_picture_is_on_a_page() -> None:
    shown = {
        name for path in PAGES.glob("*.md") for name in re.findall(r"images/gateware/(\w+)\.svg", path.read_text())
    }
    assert shown == {name for simulation in SIMULATIONS for name in simulation.pictures}
    assert shown == {path.stem for path in PICTURES.glob("*.svg")}


def test_the_examples_elaborate(tmp_path: Path) -> None:
    ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, vhdl_sources()))
    files = [
        *board_sources(),
        *generated.sources(tmp_path / "generated"),
        *(_design(tmp_path, name) for name in ENTITIES),
    ]
    ghdl(tmp_path, "-i", *map(str, files))
    for name in ENTITIES:
        ghdl(tmp_path, "-m", f"try_{name}")


def _design(folder: Path, name: str) -> Path:
    """Write the example of a page into a design that declares its signals, with the types of the entity's ports."""
    (example,) = _EXAMPLE.findall((PAGES / f"{name}.md").read_text())
    assert f" : entity {library_of(name)}.{name}\n" in example
    described = entity(name)
    given = dict(re.findall(r"(\w+) +=> (.+?),?$", example, re.MULTILINE))
    ports = {port.name: port for group in described.ports for port in group.declarations}
    constants = [
        f"  constant {generic.name} : {generic.type} := {given.get(generic.name, generic.default)};"
        for generic in _flat(described.generics)
        if given.get(generic.name, generic.default)
    ]
    signals = {
        given[port]: ports[port].type
        for port in ports
        if re.fullmatch(r"[a-z]\w*", given.get(port, "")) and given[port] != "open"
    }
    lines = [
        "library ieee;",
        "  use ieee.std_logic_1164.all;",
        "  use ieee.numeric_std.all;",
        f"library {LIBRARY};",
        f"  use {LIBRARY}.ul_math_pkg.all;",
        *([f"use work.{generated.PACKAGE}.all;"] if name in generated.ENTITIES else []),
        f"entity try_{name} is",
        "end entity;",
        f"architecture tried of try_{name} is",
        *constants,
        *(f"  signal {signal} : {kind};" for signal, kind in signals.items()),
        "begin",
        example,
        "end architecture;",
    ]
    path = folder / f"try_{name}.vhd"
    path.write_text("\n".join(lines))
    return path


def _flat(groups: tuple[Group, ...]) -> list[Declaration]:
    return [declaration for group in groups for declaration in group.declarations]
