"""Finds VHDL that GHDL converts to the Verilog of another circuit without a warning.

GHDL 5.0.1 simulates all of these expressions correctly. They are found in the Verilog, in which GHDL names file, line
and column of each gate's source, and in GHDL's dump of the netlist, which distinguishes more kinds of gates.
"""

from __future__ import annotations

import functools
import operator
import re
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator

    from unity_link.gateware.design import GhdlDesign

_MODULE = re.compile(r"^module .*?^endmodule$", re.MULTILINE | re.DOTALL)
_GATE = re.compile(r"^  /\* (?P<file>.+):(?P<line>\d+):(?P<column>\d+) +\*/\n(?P<text>.*)$", re.MULTILINE)
_WIDTH = re.compile(
    r"^ *\(? *(?:input|output|inout|wire|reg|localparam) +(?:\[(\d+):0\] )?(\w+|\\\S+ )(?=[,;)]| =)", re.MULTILINE
)
_ASSIGNED = re.compile(r"^  (?:assign|localparam \[\d+:0\]) (\w+) = (.*?);", re.MULTILINE)
_REST = re.compile(r"  assign \w+ = ([\w']+) % ([\w']+); // s(mod|rem)$")
_OUTPUT = re.compile(r"  assign (\w+) = ")
_DIFFERENCE = re.compile(r"  assign \w+ = \S+ - (\S+);")
_SHIFT = re.compile(r"  assign (?P<output>\w+) = .* (?P<way><<|>>) (?P<amount>[\w']+);")
_EXTENDED = re.compile(r"\{\d+'b0+, (\w+|\\\S+ )\}")
_SAME = re.compile(r"(\w+)|\{\{\d+\{\w+(?:\[\d+\])?\}\}, (\w+)\}|(\w+)\[\d+:0\]")
_CHOICE = re.compile(r"\w+ \? ([\w']+) : ([\w']+)")
_OPERATION = re.compile(r"(?:\$signed\()?[\w']+\)? [-+*/%] (?:\$signed\()?[\w']+\)?")
_OPERATIONS: dict[str, Callable[[int, int], int]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.floordiv,
}
_UNKNOWN = (-(1 << 1000), 1 << 1000)
_UNKNOWN_AS_ONES = str.maketrans("XZ", "11")
_WIDE = re.compile(r"\b(\d+)'b0+1[01]{31}\b")
_WORD = re.compile(r"\w+")
# VHDL statements, and gates without Verilog, that GHDL writes in the middle of the Verilog.
_FOREIGN = re.compile(r"  (?:\w+ <= .*| gate_(?P<gate>\w+) .*)")
_DUMPED = re.compile(r"^ *(?:\.\S+ )?%(\d+):\$\w+\{n\d+w\d+\} := \$(\w+)\{", re.MULTILINE)
_WIDE_NEGATIVE = re.compile(r"^( *).*\{n\d+w(\d+)\} := \$const_SB32\{i\d+\} #\(\$val=(\d+)\)", re.MULTILINE)
# These functions only: GHDL converts the operators rol and ror correctly, because it takes their amount modulo the
# width.
_ROTATIONS = {"rotate_left": "<<", "rotate_right": ">>"}
_INTEGER_BITS = 32
_SIGNED = (
    "of numbers that may be negative, which the Verilog takes for positive ones: take unsigned numbers or naturals"
)


class Refusal(NamedTuple):
    """A place in a source that GHDL converts wrongly."""

    place: str
    """File, line and column."""
    words: str

    def __str__(self) -> str:
        return f"{self.place}: GHDL makes another circuit of {self.words}"


INTEGER_MINUS_SIGNED = "IIR_PREDEFINED_IEEE_NUMERIC_STD_SUB_INT_SGN"
"""GHDL's name for an integer minus a signed number."""


def refusals(
    verilog: str,
    design: GhdlDesign,
    netlist: Callable[[], str],
    turned: Collection[tuple[str, str, str]] = (),
) -> list[Refusal]:
    """Return the places of a design that GHDL converts wrongly, in the order of the Verilog.

    Args:
        verilog: the design as GHDL writes it, with comments.
        design: the sources.
        netlist: returns GHDL's dump of the same design. It is called only if the Verilog is not sufficient.
        turned: file, line and column of each operator that subtracts a signed number from an integer.
    """
    dump = functools.cache(lambda: _Dump(netlist()))
    found: dict[Refusal, None] = {}
    for module in _MODULE.findall(verilog):
        nets = _Nets(module)
        gates = {match: (match["file"], match["line"], match["column"]) for match in _GATE.finditer(module)}
        places = {output[1]: place for gate, place in gates.items() if (output := _OUTPUT.match(gate["text"]))}
        for gate, place in gates.items():
            shown, source = design.line(gate["file"], int(gate["line"]))
            word = _WORD.match(source, int(gate["column"]) - 1)
            faults = list(_faults(gate["text"], word[0].lower() if word else "", nets, dump))
            difference = _DIFFERENCE.fullmatch(gate["text"])
            # GHDL swapped the operands if the integer is on the right: a constant, or a conversion at the same place.
            if place in turned and difference and ("'b" in difference[1] or places.get(difference[1]) == place):
                faults.append(
                    "an integer minus a signed number, which is turned round: take to_signed(..., x'length) - x"
                )
            for words in faults:
                found[Refusal(f"{shown}:{gate['line']}:{gate['column']}", words)] = None
    return list(found)


class _Nets:
    """The nets of a module."""

    def __init__(self, module: str) -> None:
        self._widths = {name.strip(): int(high or 0) + 1 for high, name in _WIDTH.findall(module)}
        self._values = dict(_ASSIGNED.findall(module))
        self._limits: dict[str, tuple[int, int]] = {}

    def width(self, net: str) -> int:
        return self._widths[net]

    def limits(self, value: str) -> tuple[int, int]:
        """Return the least and the greatest value of a net or a constant, read as a signed number."""
        if "'b" in value:
            bits = value.partition("'b")[2]
            number = int(bits.translate(_UNKNOWN_AS_ONES), 2)
            number -= number >> (len(bits) - 1) << len(bits)
            return number, number
        if value not in self._limits:
            half = 1 << (self.width(value) - 1)
            # Set the full range first: a net that depends on itself may have any value.
            self._limits[value] = -half, half - 1
            low, high = self._computed(self._values.get(value, ""), self.width(value))
            if -half <= low and high < half:
                self._limits[value] = low, high
        return self._limits[value]

    def greatest(self, value: str) -> int:
        """Return the greatest value of a net or a constant, read as an unsigned number."""
        low, high = self.limits(value)
        return high if low >= 0 else (1 << self._width_of(value)) - 1

    def _computed(self, value: str, width: int) -> tuple[int, int]:
        """Return the limits of an expression's value before truncation; of an unknown one, limits beyond any width."""
        if extended := _EXTENDED.fullmatch(value):
            return 0, self.greatest(extended[1])
        if same := _SAME.fullmatch(value):
            return self.limits(next(filter(None, same.groups())))
        if choice := _CHOICE.fullmatch(value):
            (low, high), (other_low, other_high) = self.limits(choice[1]), self.limits(choice[2])
            return min(low, other_low), max(high, other_high)
        operands = [name.removeprefix("$signed(").removesuffix(")") for name in value.split(" ")[::2]]
        if _OPERATION.fullmatch(value) and all(self._width_of(operand) == width for operand in operands):
            return _operated(value.split(" ")[1], *map(self.limits, operands))
        return _UNKNOWN

    def _width_of(self, value: str) -> int:
        return int(value.partition("'")[0]) if "'b" in value else self.width(value)


def _operated(sign: str, one: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
    """Return the limits of the result of an operation."""
    if sign in "/%" and min(one[0], other[0]) < 0:
        return _UNKNOWN
    if sign == "%":
        return 0, max(other[1] - 1, 0)
    rights = [max(right, 1) for right in other] if sign == "/" else other
    found = [_OPERATIONS[sign](left, right) for left in one for right in rights]
    return min(found), max(found)


class _Dump:
    """Information from GHDL's dump of a netlist that the Verilog does not have."""

    def __init__(self, text: str) -> None:
        self.kinds = {f"n{number}_o": kind for number, kind in _DUMPED.findall(text)}
        """Kind of each gate, by its output."""
        self.beside_wide_negatives: set[str] = set()
        """Outputs of gates with a negative constant of more than 32 bits, GHDL's width of an integer."""
        lines = text.splitlines()
        for number, line in enumerate(lines):
            match = _WIDE_NEGATIVE.match(line)
            if match and int(match[2]) > _INTEGER_BITS and int(match[3]) >> (_INTEGER_BITS - 1):
                # The gate is the nearest line above with less indentation.
                above = (up for up in reversed(lines[:number]) if len(up) - len(up.lstrip()) < len(match[1]))
                if gate := _DUMPED.match(next(above, "")):
                    self.beside_wide_negatives.add(f"n{gate[1]}_o")


def _faults(text: str, word: str, nets: _Nets, dump: Callable[[], _Dump]) -> Iterator[str]:
    """Yield the faults of a gate as parts of a message.

    Args:
        text: the gate in Verilog.
        word: the word of the VHDL at the gate's place.
        nets: nets of the module.
        dump: returns GHDL's dump.
    """
    rest = _REST.match(text)
    if rest and min(nets.limits(rest[1])[0], nets.limits(rest[2])[0]) < 0:
        yield f"{rest[3]} {_SIGNED}"
    if text.endswith(("// posedge", "// negedge")):
        yield "an edge of a clock that is no clock of a register"
    if foreign := _FOREIGN.fullmatch(text):
        yield f"this expression, which has no Verilog ({foreign['gate'] or word}): write it by `when` or `if`"
    output = _OUTPUT.match(text)
    net = output[1] if output else ""
    if word == "resize" and text.endswith("// trunc") and dump().kinds.get(net) == "strunc":
        yield (
            "resize of a signed number to fewer bits, which keeps the sign in VHDL and loses it in the Verilog: take "
            "the lower bits, as in x(7 downto 0)"
        )
    shift = _SHIFT.match(text)
    if shift and shift["way"] == _ROTATIONS.get(word):
        most = nets.greatest(shift["amount"])
        if most > nets.width(net):
            yield (
                f"a rotation by up to {most} of {nets.width(net)} bits: at most {nets.width(net)} was expected, by the "
                "range of the number or by its bits"
            )
    if any(int(size) > _INTEGER_BITS for size in _WIDE.findall(text)) and net in dump().beside_wide_negatives:
        yield (
            f"a negative integer beside a signed number of more than {_INTEGER_BITS} bits, whose upper bits are 0 in "
            "the Verilog: take to_signed(..., x'length)"
        )
