"""Parsers other than GHDL read every VHDL file, and find no construct that a vendor's tool rejects."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from gateware.tools.subset import faults
from unity_link.gateware.cache import GATEWARE, vhdl_sources
from unity_link.generate import generate
from unity_link.spec import compile_file

if TYPE_CHECKING:
    from pathlib import Path

EXAMPLES = GATEWARE.parent / "examples"
SOURCES = [*vhdl_sources(), *sorted((GATEWARE / "boards").rglob("*.vhd"))]
_FILE = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity tried is
  generic (groups : positive := 3);
  port (clk : in std_logic; d : in unsigned(7 downto 0); q : out std_logic_vector(7 downto 0));
end entity tried;

architecture rtl of tried is

  signal s, t : unsigned(7 downto 0);
  signal k    : natural range 0 to 7;
  constant c  : std_logic_vector(1 downto 0) := "10";

  function twice (a : unsigned) return unsigned is
  begin
    return a + a;
  end function twice;

begin

{concurrent}

  process (clk) is
    variable v : unsigned(7 downto 0);
  begin
    if rising_edge(clk) then
{sequential}
    end if;
  end process;

end architecture rtl;
"""
REFUSED = {
    "a modulo by a generic": ("s <= d mod groups;", "", "mod by groups, which is no power of two"),
    "a division by three": ("s <= d / 3;", "", "/ by 3, which is no power of two"),
    "a remainder by a signal": ("s <= 6 rem d;", "", "rem by d"),
    "a power of three": ("k <= 3 ** k;", "", "3 ** k is a power of another number than 2"),
    "a slice that moves": ("s(1 downto 0) <= d(k + 1 downto k);", "", "both ends of the slice (k + 1 downto k) move"),
    "an else generate": (
        "g : if groups > 1 generate s <= d; else generate s <= t; end generate;",
        "",
        "not every tool reads an `else generate` (write a second `if generate`)",
    ),
    "a case generate": ("g : case groups generate when 1 => s <= d; end generate;", "", "`case generate`"),
    "a function as an actual": ("u : entity work.x port map (a => resize(d, 9));", "", "the actual resize(d, 9)"),
    "our own function as an actual": ("u : entity work.x port map (a => twice(d));", "", "the actual twice(d)"),
    "an operator in an actual": ("u : entity work.x port map (a => not clk);", "", "the actual not clk"),
    "an expression as a choice": (
        "",
        "case v is when '0' & c => null; when others => null; end case;",
        "the choice '0' & c",
    ),
    "a matching case": ("", 'case? v is when "1-" => null; when others => null; end case?;', "`case?`"),
    "a matching operator": ("", "if v ?= s then null; end if;", "not every tool reads ?="),
    "a conditional variable": ("", "v := s when clk = '1' else t;", "conditional assignment in a process"),
    "a conditional signal in a process": ("", "t <= s when clk = '1' else t;", "conditional assignment in a process"),
    "a force": ("", "s <= force d;", "a `force`"),
    "an external name": ("", "v := << signal a.b : unsigned >>;", "an external name"),
    "a delay": ("s <= d after 3 ns;", "", "a time"),
    "a wait": ("process is begin wait until clk = '1'; end process;", "", "a `wait`"),
    "what is no VHDL": ("s <= <= d;", "", "it is no VHDL-2008"),
}
TAKEN = {
    "a modulo by a power of two": "s <= d mod 8;",
    "a modulo of constants": "k <= 7 mod groups;",
    "a slice of which one end moves": "s <= d(7 downto k);",
    "a slice by constants": "s(groups downto 0) <= d(groups + 1 downto 1);",
    "a slice by the bounds of a signal": "s <= d(s'high downto s'low);",
    "names, indices, slices and conversions as actuals": (
        "u : entity work.x generic map (g => groups + 1) "
        "port map (a => d(k), b => s(7 downto 4), c => std_logic_vector(s), e => open, f => '0', g => clk);"
    ),
    "two if generates": (
        "g : if groups > 1 generate s <= d; end generate; h : if groups = 1 generate s <= t; end generate;"
    ),
}


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.stem)
def test_gateware_uses_only_constructs_that_all_tools_accept(path: Path) -> None:
    assert faults(path.read_text()) == []


@pytest.mark.parametrize(("name", "count"), [("scara", 3), ("walker", 10)])
def test_generated_designs_use_only_constructs_that_all_tools_accept(name: str, count: int) -> None:
    made = [file for file in generate("vhdl", compile_file(EXAMPLES / f"{name}.ul")) if "_bench" not in file.name]
    # The scara has its signals in a TosNet, which is not part of a generated top.
    assert len(made) == count
    assert {file.name: found for file in made if (found := faults(file.text))} == {}


@pytest.mark.parametrize(("concurrent", "sequential", "said"), REFUSED.values(), ids=REFUSED)
def test_the_check_refuses(concurrent: str, sequential: str, said: str) -> None:
    text = _FILE.format(concurrent=concurrent, sequential=sequential)
    found = faults(text)
    assert any(said in fault.sentence for fault in found), found
    line = next(number for number, line in enumerate(text.splitlines(), 1) if line in (concurrent, sequential) and line)
    assert {fault.line for fault in found} <= {line, line + 1}


@pytest.mark.parametrize("concurrent", TAKEN.values(), ids=TAKEN)
def test_the_check_takes(concurrent: str) -> None:
    assert faults(_FILE.format(concurrent=concurrent, sequential="")) == []
