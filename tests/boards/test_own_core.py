"""The core of docs/how-to/own-core.md works as on the page and builds a bitstream; missing parts are reported."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from docs.walkthrough import files_of
from unity_link.boards.build import design_of
from unity_link.boards.loading import load_board
from unity_link.boards.projects import VENDORS, make_project
from unity_link.errors import ArgumentError
from unity_link.gateware.own_vhdl import read_own
from unity_link.spec import compile_file

if TYPE_CHECKING:
    from unity_link.boards.build import Design

PAGE = Path(__file__).parents[2] / "docs/how-to/own-core.md"
BENCH = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity bench is
end entity;

architecture sim of bench is
  signal clk, rst : std_logic := '1';
  signal period : std_logic_vector(31 downto 0) := x"0000_000A";
  signal written : std_logic_vector(1 downto 0) := "00";
  signal flashes : std_logic_vector(63 downto 0);
  signal light : std_logic_vector(1 downto 0);
  signal bright : natural := 0;
begin
  clk <= not clk after 5 ns when now < 3 us;
  rst <= '0' after 20 ns;
  -- Three cycles are a millisecond: ten of these are a period of 30 cycles, of which 15 are bright.
  own : entity work.blink
    generic map (axes => 2, clock_hz => 3000)
    port map (clk => clk, rst => rst, period => period, period_written => written, flashes => flashes, light => light);
  bright <= bright + 1 when rising_edge(clk) and now > 1000 ns and light(0) = '1';
  process is
  begin
    wait until flashes(31 downto 0) = x"0000_0003";
    assert now > 880 ns and now < 960 ns report "the third flash came after " & time'image(now) severity failure;
    wait for 1600 ns;
    assert unsigned(flashes(31 downto 0)) = 8 report "flashes" severity failure;
    assert unsigned(flashes(63 downto 32)) = 0 and light(1) = '0' report "the dark one flashes" severity failure;
    wait for 400 ns;
    assert bright >= 90 and bright <= 106 report "bright for " & natural'image(bright) severity failure;
    wait;
  end process;
end architecture;
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with the files of the page."""
    for name, text in files_of(PAGE).items():
        if name.endswith((".ul", ".vhd")):
            file = tmp_path / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    return tmp_path


def designed(folder: Path, name: str) -> Design:
    """Return the design of the page's spec for a board, as `build` makes it first."""
    spec = compile_file(folder / "lamps.ul")
    own = read_own(None, [Path(file) for file in spec.vhdl]) if spec.vhdl else None
    board = load_board(name)[1]
    if board.family in VENDORS:
        make_project(spec, name, board, folder / "project", own=own)
    return design_of(spec, spec.interface(), name, board, folder / "work", own)


@pytest.mark.rtl
def test_the_light_of_the_page_is_bright_for_half_of_each_period(folder: Path) -> None:
    (folder / "bench.vhd").write_text(BENCH)
    for command, *files in ("-a", "cores/blink/blink.vhd", "bench.vhd"), ("-e", "bench"), ("-r", "bench"):
        done = subprocess.run(
            ["ghdl", command, "--std=08", *files], cwd=folder, check=False, capture_output=True, text=True
        )
        assert (done.returncode, done.stderr) == (0, ""), done.stdout


@pytest.mark.rtl
def test_the_core_of_the_page_is_in_the_design_of_a_board_with_its_pins(folder: Path) -> None:
    design = designed(folder, "hx8k_breakout")
    assert {port: design.pins[port].site for port in ("left_light", "right_light")} == {
        "left_light": "B5",
        "right_light": "B4",
    }
    assert design.verilog.count("module blink") == 1


@pytest.mark.rtl
@pytest.mark.parametrize("name", ["hx8k_breakout", "arty_a7"])
@pytest.mark.parametrize("text", ["", "entity other is\nend entity;\n"])
def test_core_without_a_file_of_its_entity_is_reported_by_name(text: str, name: str, folder: Path) -> None:
    file = folder / "cores" / "blink" / "blink.vhd"
    file.write_text(text) if text else file.unlink()
    with pytest.raises(
        ArgumentError, match=r"^left is a BLINK, and no \.vhd in the folder of that core has its entity blink$"
    ):
        designed(folder, name)


def test_entity_of_a_spec_without_a_file_is_reported(folder: Path) -> None:
    (folder / "lamps.ul").write_text(
        'public lamps() { left: own() @(1, light="led0"); }\n'
        'own(): @(BASE) { ENTITY("mine"); @a = BASE: WRITE(); @light: PIN(OUT); }\n'
    )
    with pytest.raises(ArgumentError, match=r"^left has the entity mine, which no file has: name its file by --vhdl"):
        designed(folder, "ulx3s")
