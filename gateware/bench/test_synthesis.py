"""The gateware fits its budget on both families of FPGAs, and the tools report faulty designs.

Synthesis of a configuration takes half a minute the first time: results are stored in the user's cache under a hash of
the sources, the tools and the options, and shared with `make synth`.
"""

from __future__ import annotations

import dataclasses
import re
from typing import TYPE_CHECKING

import msgspec
import pytest

from gateware.tools import origins
from gateware.tools.cores import cores
from gateware.tools.synth import (
    CONFIGURATIONS,
    DEVICES,
    RESULTS,
    Configuration,
    Result,
    Row,
    budget,
    check,
    origin_of,
    over_budget,
    placed_today,
    rows,
    synthesise,
    table,
    tools_of,
    unchanged,
    verilog_of,
)
from unity_link.gateware.convert import ConversionError, to_verilog

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

LIMITS = budget()
IN_CI = [("default", "ice40"), ("minimal", "ice40"), ("default", "ecp5")]
QUICKEST = "ecp5"
"""The device on which a core is placed in the least time."""
PROMISED = {
    ("default", "ice40", "fmax_mhz"): 60,
    ("default", "ecp5", "fmax_mhz"): 100,
    ("minimal", "ice40", "logic"): 1650,
}


def of_cores() -> Iterator[object]:
    """Yield each configuration of a core on each device: the first one on the ECP5, all others for the campaign."""
    for core in cores():
        for place, (name, size) in enumerate(core.sizes.items()):
            for device in size.limits:
                yield pytest.param(name, device, marks=[pytest.mark.campaign] if place or device != QUICKEST else [])


@pytest.mark.slow
@pytest.mark.parametrize(("name", "device"), [*IN_CI, *of_cores()])
def test_a_configuration_fits_its_budget(name: str, device: str) -> None:
    result = synthesise(name, device)
    assert over_budget(name, device, result, LIMITS) == []


PLACED = [(name, device) for name, configuration in CONFIGURATIONS.items() for device in configuration.devices]


@pytest.mark.parametrize(("name", "device"), PLACED)
def test_figures_are_those_of_the_gateware_of_today(name: str, device: str) -> None:
    assert unchanged(rows()[name, device].origin, name, tools_of(name, device)), "run make synth"


@pytest.mark.slow
@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_figures_name_the_verilog_that_ghdl_makes_today(name: str) -> None:
    named = {rows()[name, device].origin.verilog for device in CONFIGURATIONS[name].devices}
    assert named == {verilog_of(name)}, "run make synth"


def test_the_table_is_that_of_the_figures() -> None:
    assert list(rows()) == sorted(PLACED, key=lambda place: list(DEVICES).index(place[1]))
    assert RESULTS.read_text() == table(rows(), LIMITS)


@pytest.mark.slow
def test_only_changed_designs_are_placed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONFIGURATIONS, "tried", Configuration("ul_synchroniser"))
    tools = tools_of("tried", "ice40")
    origin, made_up = origin_of("tried", tools), Result(123_456, 0, {"clk": 1.0})
    for same in (origin, msgspec.structs.replace(origin, sources="before a remark was changed")):
        assert placed_today("tried", "ice40", Row(same, made_up)) == Row(origin, made_up)
    for other in ({"tools": "others"}, {"sources": "other", "verilog": "other"}):
        row = Row(msgspec.structs.replace(origin, **other), made_up)
        anew = placed_today("tried", "ice40", row)
        assert anew.origin == origin
        assert anew.result.logic < 100
    assert placed_today("tried", "ice40", None) == anew


@pytest.mark.parametrize(
    ("before", "after", "is_changed"),
    [
        ("-- A remark.", "-- Another.", False),
        ("  a <= b;", "a   <=  b;", False),
        ("  a <= b;", "a <= c;", True),
    ],
    ids=["a remark", "spaces", "code"],
)
def test_the_name_of_sources_is_that_of_their_code(
    tmp_path: Path, before: str, after: str, *, is_changed: bool
) -> None:
    top = "entity top is\nend entity;\nlower : entity work.below;\n  use unity_link.of_it.all;\n"
    names = []
    for text in (before, after):
        (tmp_path / "top.vhd").write_text(top)
        (tmp_path / "below.vhd").write_text("entity below is\nend entity;\n" + text)
        (tmp_path / "of_it.vhd").write_text("package of_it is\n" + text)
        # An entity that the top does not contain is not hashed.
        (tmp_path / "other.vhd").write_text(f"entity other is\n-- {len(names)}\nx <= {len(names)};")
        names.append(origins.sources_of("top", {"depth": 3}, sorted(tmp_path.glob("*.vhd"))))
    assert (names[0] != names[1]) == is_changed
    assert origins.sources_of("top", {"depth": 4}, sorted(tmp_path.glob("*.vhd"))) != names[1]


def test_the_name_of_verilog_is_that_of_its_code() -> None:
    name = origins.verilog_of('module a; // one\n  /* two\n lines */ wire b;\n  $write("// no remark");\nendmodule\n')
    assert origins.verilog_of('module a;\nwire b; // three\n\n$write("// no remark");\nendmodule') == name
    assert origins.verilog_of('module a;\nwire b;\n$write("// another");\nendmodule') != name


def test_budget_has_the_limits_that_the_project_guarantees() -> None:
    assert {place: LIMITS[place[1]][place[0]][place[2]] for place in PROMISED} == PROMISED


def test_the_table_has_every_configuration_with_its_limits() -> None:
    for section in RESULTS.read_text().split("\n## ")[1:]:
        (device,) = (name for name, device in DEVICES.items() if section.startswith(device.title))
        rows = re.findall(
            r"^\| (\w+) \| (\d+) \((\d+)\) \| (\d+) \((\d+)\) \| ([\d.]+) \((\d+)\)", section, re.MULTILINE
        )
        assert [row[0] for row in rows] == [name for name, own in CONFIGURATIONS.items() if device in own.devices]
        for name, logic, most_logic, memory, most_memory, mhz, least_mhz in rows:
            limits = {"logic": int(most_logic), "memory": int(most_memory), "fmax_mhz": int(least_mhz)}
            assert limits == LIMITS[device][name]
            assert over_budget(name, device, Result(int(logic), int(memory), {"clk": float(mhz)}), LIMITS) == []


def test_result_beyond_the_budget_is_reported_in_one_sentence() -> None:
    limits = {"ice40": {"default": {"logic": 3000, "memory": 20, "fmax_mhz": 60}}}
    within = Result(3000, 20, {"clk": 60.0, "ft_clkout": 10.0})
    assert over_budget("default", "ice40", within, limits) == []
    for changed, sentence in (
        ({"logic": 3001}, "default on ice40 takes 3001 logic cells, at most 3000"),
        ({"memory": 21}, "default on ice40 takes 21 RAM blocks, at most 20"),
        ({"fmax": {"clk": 59.9}}, "default on ice40 reaches 59.9 MHz, at least 60"),
    ):
        assert over_budget("default", "ice40", dataclasses.replace(within, **changed), limits) == [sentence]
    (fault,) = over_budget("minimal", "ice40", within, limits)
    assert fault == "minimal on ice40 has no budget: add [ice40.minimal] to budget.toml"


FAULTS = {
    "a latch": ("q <= d when e = '1';", "latch"),
    "a signal that nobody drives": ("q <= s;", "assign s = 1'bX"),
    "a signal that is driven twice": ("q <= d; q <= e;", "multiple assignments"),
    "a circle of logic": ("s <= not s; q <= s;", "check -assert"),
}
_ENTITY = """\
library ieee;
  use ieee.std_logic_1164.all;
entity faulty is port (d, e : in std_logic; q : out std_logic); end entity faulty;
architecture rtl of faulty is
  signal s : std_logic;
begin
  {statements}
end architecture rtl;
"""


@pytest.mark.parametrize(("statements", "said"), FAULTS.values(), ids=FAULTS)
def test_the_tools_refuse(statements: str, said: str, tmp_path: Path) -> None:
    source = tmp_path / "faulty.vhd"
    source.write_text(_ENTITY.format(statements=statements))
    with pytest.raises(ConversionError, match=said):
        check("faulty", to_verilog("faulty", extra_sources=[source]))


def test_tools_accept_a_right_design(tmp_path: Path) -> None:
    source = tmp_path / "faulty.vhd"
    source.write_text(_ENTITY.format(statements="s <= not d; q <= s and e;"))
    check("faulty", to_verilog("faulty", extra_sources=[source]))
