"""Side effects of accesses in SystemRDL: conversion to the effects of UL-spec, and warnings for all others."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.model import Effect
from unity_link.spec.systemrdl.numbers import are_bits
from unity_link.spec.systemrdl.places import about, flat_path

if TYPE_CHECKING:
    from collections.abc import Iterator

    from systemrdl.node import FieldNode, RegNode

    from unity_link.spec.diagnostics import Diagnostic

_READING = {"rclr": "clears it", "rset": "sets all of its bits", "ruser": "has an effect of the design's own"}
_WRITING = {
    "woset": "writing 1 sets a bit, and 0 leaves it",
    "woclr": "writing 1 clears a bit, and 0 leaves it",
    "wot": "writing 1 inverts a bit, and 0 leaves it",
    "wzs": "writing 0 sets a bit, and 1 leaves it",
    "wzc": "writing 0 clears a bit, and 1 leaves it",
    "wzt": "writing 0 inverts a bit, and 1 leaves it",
    "wclr": "each write clears it",
    "wset": "each write sets all of its bits",
    "wuser": "each write has an effect of the design's own",
}


def effect_of(node: FieldNode, bits: int) -> Effect | None:
    """Return the effect of a field's signal; None if it has none, or none that a signal in its word can have.

    Args:
        node: the field.
        bits: width of a word.
    """
    if node.low // bits != node.high // bits or not are_bits(node):
        return None
    effect = _word_of(node)
    same = [one for one in node.parent.fields() if one.low // bits <= node.low // bits <= one.high // bits]
    beside = [one for one in same if one.inst_name != node.inst_name]
    if effect is Effect.CLEAR_ON_READ:
        return effect if cleared_together(node.parent, bits) else None
    if effect is Effect.WRITE_1_TO_CLEAR:
        written = [one for one in beside if one.is_sw_writable]
        return effect if all(_word_of(one) is not None and are_bits(one) for one in written) else None
    return effect


def cleared_together(register: RegNode, bits: int) -> list[FieldNode]:
    """Return the fields of a register if all are bits of one word that a read clears; otherwise an empty list.

    Args:
        register: node of the register.
        bits: width of a word.
    """
    fields = [one for one in register.fields() if one.is_sw_readable or one.is_sw_writable]
    words = {place // bits for one in fields for place in (one.low, one.high)}
    is_cleared = all(_word_of(one) is Effect.CLEAR_ON_READ and are_bits(one) for one in fields)
    return fields if is_cleared and len(words) == 1 else []


def _word_of(node: FieldNode) -> Effect | None:
    """Return the effect that UL-spec has for the side effects of a field; None if there is none."""
    onread, onwrite, sw = node.get_property("onread"), node.get_property("onwrite"), node.get_property("sw")
    has_pulse = node.get_property("singlepulse")
    words = {
        ("r", "rclr", None, False): Effect.CLEAR_ON_READ,
        ("rw", None, "woclr", False): Effect.WRITE_1_TO_CLEAR,
        ("w", None, None, True): Effect.PULSE,
        ("rw", None, None, True): Effect.PULSE,
    }
    return words.get((sw.name, onread and onread.name, onwrite and onwrite.name, has_pulse))


def effects(node: FieldNode, effect: Effect | None) -> Iterator[str]:
    """Yield sentences for a doc string on the side effects of a field that its signal does not have."""
    for word, name in (("Reading", "onread"), ("Writing", "onwrite")):
        other = node.get_property(name)
        if other is not None and effect is None:
            yield f"{word} it has an effect: {other.name}."


def warnings(node: FieldNode, effect: Effect | None) -> Iterator[Diagnostic]:
    """Yield a warning for each side effect of a field that is not the `effect` of its signal."""
    for code, message in _messages(node, effect):
        yield about("warning", code, f"{flat_path(node)}: {message}", node)


def _messages(node: FieldNode, effect: Effect | None) -> Iterator[tuple[str, str]]:
    onread, onwrite, sw = node.get_property("onread"), node.get_property("onwrite"), node.get_property("sw").name
    if onread is not None and effect is None:
        lost = "a read that is repeated on a noisy line, or by a sample or a page, loses what the first one took"
        yield "side-effect-read", f"reading {_READING[onread.name]} ({onread.name}): {lost}"
    if onwrite is not None and effect is None:
        yield "side-effect-write", f"{_WRITING[onwrite.name]} ({onwrite.name}), {_neighbours(node)}"
    if node.get_property("singlepulse") and effect is None:
        yield "side-effect-write", f"1 lasts for one cycle of the clock (singlepulse), {_neighbours(node)}"
    if sw in {"rw1", "w1"}:
        yield "side-effect-write", f"only the first write after a reset counts ({sw}), {_neighbours(node)}"
    for name in ("swacc", "swmod"):
        if node.get_property(name):
            yield "side-effect", f"the hardware sees each access ({name}), those to other fields of its word too"
    if node.is_sw_writable and not node.is_sw_readable and effect is None and _written_beside(node):
        message = "it cannot be read back, so that a write of another field of its register writes what is read there"
        yield "write-only-field", message


def _neighbours(node: FieldNode) -> str:
    beside = ", ".join(_written_beside(node))
    plain = "and its signal is a plain one"
    return f"{plain}: a write of {beside} writes back what was read of this field" if beside else plain


def _written_beside(node: FieldNode) -> list[str]:
    """Return the names of the writable other fields in the register of a field."""
    return [one.inst_name for one in node.parent.fields() if one.is_sw_writable and one.inst_name != node.inst_name]
