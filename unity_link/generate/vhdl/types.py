"""The VHDL types of kinds on the hardware's side, and conversions to and from the bits on the bus."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.quoting import hdl_comment_lines
from unity_link.spec import KindName

if TYPE_CHECKING:
    from collections.abc import Mapping

    from unity_link.generate.vhdl.names import Scope
    from unity_link.spec import Enumeration, Kind

_VECTORS = {
    KindName.UNSIGNED: "unsigned",
    KindName.SIGNED: "signed",
    KindName.FIXED: "signed",
    KindName.UFIXED: "unsigned",
    KindName.FLOAT: "std_logic_vector",
}
ENUMERATION_BITS = 64
"""Width of the numbers in `to_bits` for enumerations and its inverse: that of the widest signal."""


class Literal(NamedTuple):
    """A value of an enumeration as a VHDL literal."""

    name: str
    bits: str
    """Its number as a bit string literal."""
    doc: str


class VhdlEnumeration(NamedTuple):
    """An enumeration as a VHDL type; its last literal represents all numbers without a name."""

    source: Enumeration
    type: str
    literals: tuple[Literal, ...]
    unnamed: Literal
    decode: str
    """Name of the function that converts bits to a literal."""


def enumeration_type(enumeration: Enumeration, scope: Scope) -> VhdlEnumeration:
    """Return the VHDL type of an enumeration; its literals begin with the enumeration's name."""
    name = scope.unique(enumeration.name, "_t")
    literals = [
        Literal(scope.unique(f"{name}_{value.name}"), bit_literal(value.value, ENUMERATION_BITS), value.doc)
        for value in enumeration.values
    ]
    numbers = {value.value for value in enumeration.values}
    free = next(number for number in range(len(numbers) + 1) if number not in numbers)
    unnamed = Literal(scope.unique(f"{name}_unnamed"), bit_literal(free, ENUMERATION_BITS), "")
    return VhdlEnumeration(enumeration, f"{name}_t", tuple(literals), unnamed, scope.unique(f"to_{name}"))


def bit_literal(number: int, width: int) -> str:
    """Return a number as a bit string literal, in hexadecimal if it has more than four bits."""
    if width <= 4:
        return f'"{number:0{width}b}"'
    size = str(width) if width % 4 else ""
    return f'{size}x"{number:0{-(-width // 4)}X}"'


def real_literal(number: float) -> str:
    """Return a number as a literal of VHDL's type `real`."""
    mantissa, _, exponent = repr(float(number)).partition("e")
    whole = mantissa if "." in mantissa else f"{mantissa}.0"
    return whole + (f"e{int(exponent)}" if exponent else "")


def vhdl_type(kind: Kind, enumerations: Mapping[str, VhdlEnumeration]) -> str:
    """Return the VHDL type of a signal's kind."""
    if kind.name is KindName.BOOL:
        return "std_logic"
    if kind.enumeration is not None:
        return enumerations[kind.enumeration.name].type
    return f"{_VECTORS[kind.name]}({kind.width - 1} downto 0)"


def to_bits(kind: Kind, expression: str) -> str:
    """Return an expression for the bits of a value: a `std_logic_vector`, or for a bool a `std_logic`."""
    if kind.name in {KindName.BOOL, KindName.FLOAT}:
        return expression
    if kind.enumeration is not None:
        return f"to_bits({expression}, {kind.width})"
    return f"std_logic_vector({expression})"


def from_bits(kind: Kind, expression: str, enumerations: Mapping[str, VhdlEnumeration]) -> str:
    """Return an expression for the value of bits: a `std_logic_vector`, or for a bool a `std_logic`."""
    if kind.name is KindName.BOOL:
        return expression
    if kind.enumeration is not None:
        return f"{enumerations[kind.enumeration.name].decode}({expression})"
    return expression if kind.name is KindName.FLOAT else f"{_VECTORS[kind.name]}({expression})"


def comment(text: str, indent: int = 0, width: int = 120) -> list[str]:
    """Return a text as lines of comment."""
    prefix = " " * indent + "-- "
    return [(prefix + line).rstrip() for line in hdl_comment_lines(text, width - len(prefix))]
