"""Verifies an import: compiles the spec and compares it, field by field, with the tree of the SystemRDL compiler."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple

from unity_link.spec.diagnostics import SpecError
from unity_link.spec.model import Access, Effect
from unity_link.spec.systemrdl.effects import cleared_together, effect_of
from unity_link.spec.systemrdl.numbers import number_of
from unity_link.spec.systemrdl.places import about, flat_path, spec_path

if TYPE_CHECKING:
    from collections.abc import Mapping

    from systemrdl.node import AddrmapNode, FieldNode

    from unity_link.spec.diagnostics import Diagnostic
    from unity_link.spec.model import Interface, Signal


class _Seen(NamedTuple):
    """The properties of a field that are compared."""

    address: int
    """Address of its first word."""
    lowest_bit: int
    access: Access
    width: int = 0
    signed: bool = False
    step: float = 1
    values: tuple[int, ...] = ()
    """Numbers of its enumeration, sorted."""
    reset: int = 0
    """Bits of a writable field after a reset."""
    effect: Effect | None = None


def compare(text: str, top: AddrmapNode, names: Mapping[str, str]) -> list[Diagnostic]:
    """Return errors of a spec that was made from SystemRDL: errors of its compilation, or differences.

    Args:
        text: the spec.
        top: node of the address map, from the SystemRDL compiler.
        names: names of nodes in the spec, by their flat paths.
    """
    from unity_link.spec import compile_text

    try:
        interface = compile_text(text).interface()
    except SpecError as error:
        return [_refused(one, top, names) for one in error.diagnostics if one.severity == "error"]
    return [*_differing_fields(interface, top, names), *_differing_memories(interface, top)]


def _refused(one: Diagnostic, top: AddrmapNode, names: Mapping[str, str]) -> Diagnostic:
    """Return an error of the spec as an error at the SystemRDL node that was declared in the same line."""
    declared = re.match(r"\s*@?(\w+)", one.text)
    name = declared[1] if declared is not None else ""
    node = next((node for node in top.descendants() if names.get(flat_path(node)) == name), top)
    return about("error", one.code, f"{one.message}: a spec cannot express this", node)


def _differing_fields(interface: Interface, top: AddrmapNode, names: Mapping[str, str]) -> list[Diagnostic]:
    from systemrdl.node import FieldNode

    found = dict(interface.signals)
    differing = []
    for node in top.descendants(unroll=True):
        if not isinstance(node, FieldNode) or not (node.is_sw_readable or node.is_sw_writable):
            continue
        ours = node.get_property("ul_path") if "ul_path" in node.list_properties() else None
        if ours is None and not names:
            # This field is a further word of a signal that was exported from a spec; the first word was compared.
            continue
        together = [] if ours is not None else cleared_together(node.parent, interface.data_bits)
        if together and node.inst_name != together[0].inst_name:
            # The fields are cleared together and became one signal, which was compared at the first field.
            continue
        path = spec_path(node, names) if ours is None else re.sub(r"\[(\d+)\]", r"_\1", ours)
        expected = _expected(node, interface.data_bits, whole=ours is None)
        if together:
            low, high = min(one.low for one in together), max(one.high for one in together)
            expected = expected._replace(lowest_bit=low % interface.data_bits, width=high - low + 1)
        signal = found.pop(path, None)
        seen = None if signal is None else _seen(signal, whole=ours is None)
        if seen != expected:
            message = f"{node.get_path()} is {expected}, and {path} of the spec would be {seen}"
            differing.append(about("error", "differs", message, node))
    if found:
        message = f"{next(iter(found))} of the spec is no field"
        differing.append(about("error", "differs", message, top))
    return differing


def _expected(node: FieldNode, bits: int, *, whole: bool) -> _Seen:
    access = Access.READ if not node.is_sw_writable else Access.READWRITE if node.is_sw_readable else Access.WRITE
    address, low = divmod(node.parent.absolute_address * 8 + node.low, bits)
    if not whole:
        return _Seen(address, low, access)
    number, encode = number_of(node), node.get_property("encode")
    values = () if encode is None else tuple(sorted(member.value for member in encode))
    given = node.get_property("reset")
    reset = given if isinstance(given, int) and access.writes else 0
    step = math.ldexp(1, -(number.fraction or 0))
    return _Seen(address, low, access, node.width, number.signed, step, values, reset, effect_of(node, bits))


def _seen(signal: Signal, *, whole: bool) -> _Seen:
    if not whole:
        return _Seen(signal.address, signal.lowest_bit, signal.access)
    kind = signal.kind
    values = () if kind.enumeration is None else tuple(sorted(one.value for one in kind.enumeration.values))
    place = signal.address, signal.lowest_bit, signal.access, signal.width
    return _Seen(*place, kind.is_signed, kind.step, values, signal.reset, signal.effect)


def _differing_memories(interface: Interface, top: AddrmapNode) -> list[Diagnostic]:
    from systemrdl.node import MemNode

    width = interface.data_bits // 8
    found = sorted((one.base, one.words or 0) for one in interface.modules if one.type == "MEMORY")
    nodes = [node for node in top.descendants(unroll=True) if isinstance(node, MemNode)]
    # All elements of an array are one memory in a spec.
    first = [node for node in nodes if not any(node.current_idx or ())]
    expected = sorted((node.absolute_address // width, -(-node.total_size // width)) for node in first)
    if found == expected:
        return []
    message = f"the memories are at {expected} in words, and those of the spec would be at {found}"
    return [about("error", "differs", message, top)]
