"""Expressions that GHDL converts to another circuit are refused with their places; similar ones are accepted."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from unity_link.gateware.design import GhdlDesign, OwnFile
from unity_link.gateware.entity import SyntaxTree
from unity_link.gateware.refused import INTEGER_MINUS_SIGNED, Refusal, refusals

if TYPE_CHECKING:
    from collections.abc import Collection

HEAD = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;"
pytestmark = pytest.mark.rtl
DECLARED = """\
  signal s, t : signed(7 downto 0);
  signal wide : signed(39 downto 0);
  signal u, v : unsigned(7 downto 0);
  signal six : unsigned(5 downto 0);
  signal some : integer range -100 to 100;
  signal k, l : natural range 0 to 7;
  signal n : natural range 0 to 15;
  function choose(c : boolean; a, b : integer) return integer is
  begin if c then return a; else return b; end if; end function;"""
WRONG = {
    "s mod t": "mod of numbers that may be negative",
    "s rem 3": "rem of numbers that may be negative",
    "to_signed(some mod 7, 8)": "mod of numbers that may be negative",
    "to_signed((k - l) rem 5, 8)": "rem of numbers that may be negative",
    "resize(resize(s, 4), 8)": "resize of a signed number to fewer bits",
    "resize(s * t, 8)": "resize of a signed number to fewer bits",
    "signed(rotate_left(u, n))": "a rotation by up to 15 of 8 bits",
    "signed(rotate_right(u, k + l))": "a rotation by up to 14 of 8 bits",
    "signed(rotate_left(u, 11))": "a rotation by up to 11 of 8 bits",
    "resize(signed(rotate_left(six, k)), 8)": "a rotation by up to 7 of 6 bits",
    'signed\'(x"01") when wide < -5 else s': "a negative integer beside a signed number of more than 32 bits",
    "5 - s": "an integer minus a signed number",
    "k - s": "an integer minus a signed number",
    "maximum(s, t)": "this expression, which has no Verilog",
}
RIGHT = [
    "signed(u mod v)",
    "signed(u rem 3)",
    "to_signed(n mod 5, 8)",
    "to_signed((k + 1) mod 5, 8)",
    "to_signed((k * l + 3) rem 7, 8)",
    "to_signed(choose(k < l, k, l + 9) mod 5, 8)",
    "to_signed((n / 3) mod 5, 8)",
    "to_signed(n mod (k + 1), 8)",
    "resize(s(3 downto 0), 8)",
    "s - 5",
    "s - some",
    "signed(5 - u)",
    "to_signed(5, 8) - s",
    "signed(resize(resize(u, 4), 8))",
    "signed(rotate_left(u, k))",
    "signed(u rol 11)",
    "signed(u ror some)",
    "signed(rotate_right(u, 8))",
    "signed(rotate_right(u, k + 1))",
    'signed\'(x"01") when wide < 5 else s',
    'signed\'(x"01") when wide < to_signed(-5, 40) else s',
]


def refused(expressions: Collection[str], folder: Path) -> dict[str, list[tuple[str, Refusal]]]:
    """Return the refusals of each expression, each with the source text from its place on."""
    ports = "; ".join(f"q{number} : out signed(7 downto 0)" for number, _ in enumerate(expressions))
    lines = [f"  q{number} <= {expression};" for number, expression in enumerate(expressions)]
    text = (
        f"{HEAD}\nentity one is port (i : in signed(71 downto 0); {ports}); end entity;\n"
        f"architecture rtl of one is\n{DECLARED}\nbegin\n"
        "  s <= i(7 downto 0); t <= i(15 downto 8); u <= unsigned(i(23 downto 16)); v <= unsigned(i(31 downto 24));\n"
        "  six <= u(5 downto 0); wide <= i(71 downto 32); some <= to_integer(s);\n"
        "  k <= to_integer(u(2 downto 0)); l <= to_integer(u(5 downto 3)); n <= to_integer(v(3 downto 0));\n"
    )
    first = text.count("\n")
    text += "\n".join([*lines, "end architecture;", ""])
    design = GhdlDesign(folder, own=[OwnFile(Path("my core.vhd"), text.encode())])
    design.make("one")
    turned = SyntaxTree(design.description(*design.copies.values())).operators(INTEGER_MINUS_SIGNED)
    found: dict[str, list[tuple[str, Refusal]]] = {expression: [] for expression in expressions}
    for refusal in refusals(design.verilog("one", {}), design, lambda: design.netlist("one", {}), turned):
        place = re.fullmatch(r"my core\.vhd:(\d+):(\d+)", refusal.place)
        assert place is not None
        number = int(place[1]) - 1 - first
        found[list(expressions)[number]].append((lines[number][int(place[2]) - 1 :], refusal))
    return found


def test_wrong_conversions_are_refused_with_file_line_and_column(tmp_path: Path) -> None:
    for expression, found in refused(WRONG, tmp_path).items():
        assert [refusal.words.startswith(WRONG[expression]) for _, refusal in found] == [True], (expression, found)
        assert found[0][0].startswith(("mod", "rem", "resize", "rotate", "<", "-", "maximum"))


def test_right_conversions_are_not_refused(tmp_path: Path) -> None:
    assert [found for found in refused(RIGHT, tmp_path).values() if found] == []
