"""Numbers in SystemRDL's fields: PeakRDL's properties `is_signed`, `intwidth` and `fracwidth`, and enumerations.

PeakRDL declares its properties itself, so that a file may use them with or without a declaration.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterable

    from systemrdl.compiler import RDLCompiler
    from systemrdl.node import FieldNode

PEAKRDL = ("is_signed", "intwidth", "fracwidth")


class Number(NamedTuple):
    """The number format of a field."""

    signed: bool
    fraction: int | None
    """Bits after the binary point; may be negative or larger than the width. None for a whole number."""


def number_of(node: FieldNode) -> Number:
    """Return the number format of a field.

    Raises:
        ValueError: if its widths contradict each other or its enumeration.
    """
    signed = _property(node, "is_signed")
    whole, fraction = _property(node, "intwidth"), _property(node, "fracwidth")
    if (signed or whole is not None or fraction is not None) and node.get_property("encode") is not None:
        raise ValueError("an enumeration is neither signed nor a fixed-point number")
    if whole is not None and fraction is not None and whole + fraction != node.width:
        raise ValueError(f"intwidth={whole} and fracwidth={fraction} are not the {node.width} bits of the field")
    return Number(bool(signed), node.width - whole if fraction is None and whole is not None else fraction)


def are_bits(node: FieldNode) -> bool:
    """Return whether a field is plain bits: no enumeration, and neither signed nor fixed-point."""
    try:
        return number_of(node) == Number(signed=False, fraction=None) and node.get_property("encode") is None
    except ValueError:
        return False


def reset_of(node: FieldNode) -> str:
    """Return the value of a field after a reset in the syntax of a spec; empty if it is 0 or not a number.

    Raises:
        ValueError: if `number_of` raises one.
    """
    bits = node.get_property("reset")
    if not isinstance(bits, int) or not bits:
        return ""
    number = number_of(node)
    if node.width == 1 and not number.signed and number.fraction is None and node.get_property("encode") is None:
        return "true"
    value = bits - (1 << node.width) if number.signed and bits >> node.width - 1 else bits
    return str(value) if number.fraction is None else repr(math.ldexp(value, -number.fraction))


def _property(node: FieldNode, name: str) -> int | None:
    if name not in node.list_properties():
        return None
    value = node.get_property(name)
    # A property that was declared without a default, and is used without a value, has a value of another type.
    return value if isinstance(value, int) else None


def declare(compiler: RDLCompiler, names: Iterable[str]) -> None:
    """Declare properties of PeakRDL to a SystemRDL compiler."""
    from systemrdl.component import Field
    from systemrdl.udp import UDPDefinition

    for one in names:
        is_flag = one == "is_signed"
        members = {
            "name": one,
            "valid_components": {Field},
            "valid_type": bool if is_flag else int,
            "default_assignment": True if is_flag else None,
        }
        compiler.register_udp(type(one, (UDPDefinition,), members), soft=False)
