"""Generics per axis: placements with different values share one instance, which has the values as a list."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from unity_link.generate.vhdl.bank import Bank
from unity_link.spec import SpecError, compile_file

if TYPE_CHECKING:
    from pathlib import Path

MAP = """\
SHIFT(BY=1, STEP=2): @(BASE) {
  ENTITY("shift", by=BY, step=STEP);
  @value = BASE: unsigned 16 READWRITE();
  @moved = BASE + 1: unsigned 16 READ();
}
"""
VHDL = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity shift is
  generic (
    axes : positive := 1; clock_hz : positive := 50_000_000;
    by : integer_vector := (0 => 1); step : natural := 2
  );
  port (
    clk, rst : in std_logic;
    value : in std_logic_vector(axes * 16 - 1 downto 0);
    value_written : in std_logic_vector(axes - 1 downto 0);
    moved : out std_logic_vector(axes * 16 - 1 downto 0)
  );
end entity;

architecture rtl of shift is
begin
  assert by'length = axes report "by has not a value for each axis" severity failure;

  each : for axis in 0 to axes - 1 generate
    moved(axis * 16 + 15 downto axis * 16) <= std_logic_vector(
      unsigned(value(axis * 16 + 15 downto axis * 16)) + by(axis) * step);
  end generate;
end architecture;
"""
ROBOT = """\
public robot() {
  GATEWAY(ADDRESS_BITS=8);
  alone: SHIFT(STEP=3) @(0x40);
  each[3]: SHIFT(BY=10 * i + 1) @(0x10 + 2 * i);
  @lamp = 0x50[0]: bool READWRITE();
}
"""


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    """Return a spec with a core in the folder beside it."""
    folder = tmp_path / "cores" / "shift"
    folder.mkdir(parents=True)
    (folder / "shift.ul").write_text(MAP)
    (folder / "shift.vhd").write_text(VHDL)
    (folder / "core.toml").write_text('per_axis = ["by"]\n')
    (tmp_path / "robot.ul").write_text(ROBOT)
    return tmp_path / "robot.ul"


def test_placements_that_differ_only_in_a_generic_per_axis_share_an_instance(spec: Path) -> None:
    instances = Bank(compile_file(spec).interface()).wiring.instances
    assert [(one.paths, dict(one.generics)["by"], dict(one.generics)["step"]) for one in instances] == [
        ("alone", "(0 => 1)", "3"),
        ("each[0], each[1], each[2]", "(0 => 1, 1 => 11, 2 => 21)", "2"),
    ]


@pytest.mark.rtl
def test_each_axis_has_its_own_value_of_a_generic_per_axis(spec: Path) -> None:
    async def use() -> None:
        robot_type: Any = unity_link.load(spec)
        async with unity_link.connect(f"rtl:{spec}") as link:
            robot = robot_type(link)
            for part, added in zip((robot.alone, *robot.each), (3, 2, 22, 42), strict=True):
                await part.value.set(1000)
                assert await part.moved.get() == 1000 + added

    asyncio.run(use())


@pytest.mark.parametrize(
    ("text", "placed", "message"),
    [
        ('per_axis = ["other"]', "", "core.toml has other per axis, and that is no generic of it"),
        ('per_axis = ["by"]', 'BY="x"', 'core.toml has by per axis, and that is "x", no whole number'),
        ('per_axis = ["by"]', "BY=true", "core.toml has by per axis, and that is true, no whole number"),
        ("per_axis = 3", "", "per_axis is 3, a list of generics was expected"),
        ("per_axis = ", "", "is no TOML"),
        ("a = " + "[" * 100_000, "", r"core\.toml is nested too deeply"),
    ],
)
def test_a_generic_that_cannot_be_a_list_is_reported(text: str, placed: str, message: str, spec: Path) -> None:
    (spec.parent / "cores" / "shift" / "core.toml").write_text(text)
    spec.write_text(f"public robot() {{ x: SHIFT({placed}) @(1); }}")
    with pytest.raises(SpecError, match=message):
        compile_file(spec)
