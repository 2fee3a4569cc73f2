"""The quick synthesis includes every top and every board, and reports designs that a tool rejects."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from gateware.tools.synth import CONFIGURATIONS, Configuration, map_only
from gateware.tools.synth_quick import designs, faults, main
from unity_link.boards.families import FAMILIES
from unity_link.boards.loading import board_names, load_board
from unity_link.gateware.ghdl import converting_ghdl

if TYPE_CHECKING:
    from pathlib import Path

    import pytest

_ENTITY = """\
library ieee;
  use ieee.std_logic_1164.all;
entity tried is port (clk, d : in std_logic; q : out std_logic); end entity tried;
architecture rtl of tried is
  signal s : std_logic;
begin
  {statements}
end architecture rtl;
"""


def test_each_top_and_board_is_tried_once_and_boards_alike_share_one_run() -> None:
    tried = [together.split(", ") for together in designs()]
    boards = [name for name in board_names() if load_board(name)[1].family in FAMILIES]
    names = {name for together in tried for name in together}
    assert sum(map(len, tried)) == len(names)
    # Only the smallest size of a core is synthesised.
    left_out = {*CONFIGURATIONS, *boards} - names
    assert all(CONFIGURATIONS[name].is_core for name in left_out)
    assert names - {*CONFIGURATIONS} == {*boards}
    assert {name.rpartition("_")[0] for name in left_out} <= {name.rpartition("_")[0] for name in names}
    assert "encoder_1" in names
    assert "encoder_6" not in names
    assert ["ulx3s", "ulx3s_85f"] in tried


def test_unknown_name_is_an_error(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["synth_quick", "ulx4s"])
    assert main() == 2
    assert capsys.readouterr().err.startswith("no top and no board has 'ulx4s' in its name; there are default, ")


def test_designs_that_a_tool_refuses_are_found_and_right_ones_pass(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # `faults` would report a missing tool as a fault of the design.
    converting_ghdl()
    right = "q <= s; s <= d when rising_edge(clk);"
    tops = {"right": right, "latch": "q <= d when clk = '1';", "circle": "s <= not s; q <= s;"}
    tried = {}
    for name, statements in tops.items():
        source = tmp_path / f"{name}.vhd"
        source.write_text(_ENTITY.format(statements=statements))
        top = Configuration("tried", devices=("ice40",), sources=(source,))
        tried[name] = lambda top=top: map_only(top)
    found = faults(tried)
    assert found.keys() == {"latch", "circle"}
    assert "latch" in found["latch"]
    assert "check -assert" in found["circle"]
    assert capsys.readouterr().out == "right\n"
