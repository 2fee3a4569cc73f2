"""Signals as C data: the initializer of an interface, and the comments beside signals."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.generate.c.layout import brackets
from unity_link.generate.c.names import number
from unity_link.quoting import c_string
from unity_link.spec.kinds import KindName
from unity_link.spec.model import ComponentArray, ComponentSpec, Effect
from unity_link.spec.words import EFFECTS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate.c.layout import GroupMember, Layout, SignalMember
    from unity_link.spec.model import GroupSpec, Signal


def initializer(layout: Layout) -> str:
    """Return the designated initializers of the interface's structure, indented by one level."""
    return "\n".join(_component(layout, layout.interface.root, "    "))


def _component(layout: Layout, component: ComponentSpec, indent: str) -> Iterator[str]:
    names = layout.member_names(component)
    if not names:
        # C has neither empty structures nor empty initializers.
        yield f"{indent}.empty = 0,"
    for signal in component.signals:
        yield f"{indent}.{names[signal.name]}{brackets(signal.index)}.signal = {signal_initializer(layout, signal)},"
    for part in component.parts:
        yield f"{indent}.{names[part.name]} = {{"
        yield from _part(layout, part, f"{indent}    ")
        yield f"{indent}}},"
    for name, modules in layout.modules_of(component).items():
        values = [f"{{0x{module.base:02X}, {module.words or 0}}}" for module in modules]
        text = values[0] if "[" not in str(modules[0].path) else f"{{{', '.join(values)}}}"
        yield f"{indent}.{names[name]} = {text},"


def _part(layout: Layout, part: ComponentSpec | ComponentArray, indent: str) -> Iterator[str]:
    if isinstance(part, ComponentSpec):
        yield from _component(layout, part, indent)
        return
    for index, item in enumerate(part.items):
        yield f"{indent}[{index}] = {{"
        yield from _component(layout, item, f"{indent}    ")
        yield f"{indent}}},"


def signal_initializer(layout: Layout, signal: Signal) -> str:
    """Return the initializer of a `ul_signal`, with the fields in order."""
    is_real = layout.value_types[signal.path].coding == "real"
    step, offset = (
        (signal.kind.step, signal.kind.offset) if is_real and signal.kind.name is not KindName.FLOAT else (1, 0)
    )
    fields = [
        c_string(signal.path),
        c_string(signal.unit),
        f"0x{signal.address:02X}",
        str(signal.word_bits),
        str(signal.lowest_bit),
        str(signal.width),
        _kind(signal),
        _properties(signal, layout, is_real=is_real),
        *map(number, (step, offset)),
        *_limits(signal, is_real=is_real),
        f"0x{layout.interface.fingerprint:08X}",
        layout.guards.get(signal.path, "NULL"),
    ]
    return f"{{{', '.join(fields)}}}"


def _kind(signal: Signal) -> str:
    if signal.kind.name is KindName.FLOAT:
        return "UL_FLOAT"
    return "UL_SIGNED" if signal.kind.is_signed else "UL_UNSIGNED"


def _is_limited(signal: Signal) -> bool:
    return signal.minimum is not None or signal.maximum is not None


def _limits(signal: Signal, *, is_real: bool) -> tuple[str, str]:
    low, high = signal.limits
    if not _is_limited(signal):
        return "{0}", "{0}"
    if is_real:
        return f"{{.real = {number(low)}}}", f"{{.real = {number(high)}}}"
    member = "whole" if signal.kind.is_signed else "natural"
    least, most = (_integer(value, is_signed=signal.kind.is_signed) for value in (math.ceil(low), math.floor(high)))
    return f"{{.{member} = {least}}}", f"{{.{member} = {most}}}"


def _integer(value: int, *, is_signed: bool) -> str:
    if abs(value) < 1 << 31:
        return str(value)
    # C has no negative literals: INT64_MIN would be the negative of a literal that is too large.
    if value == -(1 << 63):
        return "INT64_MIN"
    return f"{'INT64_C' if is_signed else 'UINT64_C'}({value})"


def _properties(signal: Signal, layout: Layout, *, is_real: bool) -> str:
    properties = {
        "UL_READABLE": signal.access.reads,
        "UL_WRITABLE": signal.access.writes,
        "UL_FIELD": signal.is_field,
        "UL_QUEUE": signal.fifo,
        "UL_LIMITED": _is_limited(signal),
        "UL_SHARED": signal.access.writes and signal.address in layout.shared and not signal.fifo,
        "UL_WHOLE": not is_real,
        "UL_CLEARED": signal.effect is Effect.CLEAR_ON_READ,
    }
    return " | ".join(name for name, holds in properties.items() if holds)


def limits(signal: Signal) -> str:
    """Return the range of a writable signal for a comment; empty if its type implies it."""
    low, high = signal.limits
    if not signal.access.writes or _says_it(signal) or not (math.isfinite(low) or math.isfinite(high)):
        return ""
    if math.isfinite(low) and math.isfinite(high):
        return f"{low:.12g} to {high:.12g}"
    return f"at most {high:.12g}" if math.isfinite(high) else f"at least {low:.12g}"


def _says_it(signal: Signal) -> bool:
    kind = signal.kind
    if kind.name in {KindName.BOOL, KindName.ENUM}:
        return True
    return not kind.is_scaled and not _is_limited(signal) and kind.width in {32, 64}


def describe(member: SignalMember) -> str:
    """Return the comment beside a signal: doc string, access, limits and unit."""
    signal = member.signal
    what = {"READ": "read", "WRITE": "write", "READWRITE": "read, write"}[signal.access]
    if signal.fifo:
        what += ", queue"
    if signal.effect is not None:
        what += f", {EFFECTS[signal.effect]}"
    where = "" if member.varies else " ".join(part for part in (limits(signal), signal.unit) if part)
    text = f"{what}; {where}" if where else what
    return f"{signal.doc.rstrip('.')} ({text})" if signal.doc else text


def schedule(group: GroupSpec) -> str:
    """Return when a group is published, as a phrase."""
    when = []
    if group.divisor is not None:
        when.append(f"at the gateway's base frequency / {group.divisor}")
    if group.rate_hz is not None and group.published_hz is not None:
        when.append(f"at {group.published_hz:.6g} Hz, or the nearest rate that it has")
    if group.trigger:
        when.append("on its external trigger")
    changes = ", if a word has changed" if group.on_change else ""
    return f"as group {group.number}{', ' * bool(when)}{' and '.join(when)}{changes}"


def decoding(member: GroupMember) -> str:
    """Return the C expression for a member of a group, from the words of a sample."""
    value = f"ul_decode_{member.type.coding}(&{member.expression}.signal, {member.words})"
    return value if member.type.value in {"uint64_t", "int64_t", "double"} else f"({member.type.value}){value}"


def examples(layout: Layout) -> list[str]:
    """Return calls that read and write the first suitable signals, for the comment at the top of the file."""
    calls = []
    for verb, pointer, wanted in (("get", "&value", "reads"), ("set", "value", "writes")):
        first = next((one for one in layout.interface.signals.values() if getattr(one.access, wanted)), None)
        if first is None:
            continue
        made = layout.value_types[first.path]
        function = f"{made.value}_{verb}" if made.is_enumeration else f"ul_{verb}_{made.signal.removeprefix('ul_')}"
        calls.append(f"{function}(&link, &{layout.expressions[first.path]}, {pointer})")
    return calls
