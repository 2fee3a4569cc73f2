"""What GHDL converts to another circuit is refused with its place, and what looks similar is not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from unity_link.gateware.design import GhdlDesign, OwnFile
from unity_link.gateware.entity import SyntaxTree
from unity_link.gateware.refused import INTEGER_MINUS_SIGNED, Refusal, refusals

HEAD = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;"
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
BEFORE = "  q <= "
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


def refused(expression: str, folder: Path) -> list[Refusal]:
    """Return the refusals of an expression, on line 17 of an entity."""
    text = (
        f"{HEAD}\nentity one is port (i : in signed(71 downto 0); q : out signed(7 downto 0)); end entity;\n"
        f"architecture rtl of one is\n{DECLARED}\nbegin\n"
        "  s <= i(7 downto 0); t <= i(15 downto 8); u <= unsigned(i(23 downto 16)); v <= unsigned(i(31 downto 24));\n"
        "  six <= u(5 downto 0); wide <= i(71 downto 32); some <= to_integer(s);\n"
        "  k <= to_integer(u(2 downto 0)); l <= to_integer(u(5 downto 3)); n <= to_integer(v(3 downto 0));\n"
        f"{BEFORE}{expression};\nend architecture;\n"
    )
    design = GhdlDesign(folder, own=[OwnFile(Path("my core.vhd"), text.encode())])
    design.make("one")
    turned = SyntaxTree(design.description(*design.copies.values())).operators(INTEGER_MINUS_SIGNED)
    return refusals(design.verilog("one", {}), design, lambda: design.netlist("one", {}), turned)


@pytest.mark.rtl
@pytest.mark.parametrize(("expression", "words"), WRONG.items())
def test_a_wrong_conversion_is_refused_with_file_line_and_column(expression: str, words: str, tmp_path: Path) -> None:
    (refusal,) = refused(expression, tmp_path)
    place = re.fullmatch(r"my core\.vhd:17:(\d+)", refusal.place)
    assert place is not None
    operator = f"{BEFORE}{expression}"[int(place[1]) - 1 :]
    assert operator.startswith(("mod", "rem", "resize", "rotate", "<", "-", "maximum"))
    assert refusal.words.startswith(words)


@pytest.mark.rtl
@pytest.mark.parametrize("expression", RIGHT)
def test_a_right_conversion_is_not_refused(expression: str, tmp_path: Path) -> None:
    assert refused(expression, tmp_path) == []
