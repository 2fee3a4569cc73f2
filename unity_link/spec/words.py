"""Describes the hardware of a spec in words, for `show` and generated documents."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.quoting import vhdl_literal
from unity_link.spec.kinds import KindName
from unity_link.spec.model import Access, Effect, Way

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec.model import Core, Interface, Pin, Signal, Trigger


EFFECTS = {
    Effect.CLEAR_ON_READ: "cleared by each read",
    Effect.WRITE_1_TO_CLEAR: "cleared by writing 1",
    Effect.PULSE: "a pulse of one clock cycle",
}
"""Effects of accesses, for display."""
_WAYS = {Access.READ: Way.IN, Access.WRITE: Way.OUT, Access.READWRITE: Way.OUT}


def entity(core: Core) -> str:
    """Format an entity and its generics like VHDL: ``unity_link.ul_pwm(width => 12)``."""
    generics = ", ".join(f"{name} => {vhdl_literal(value)}" for name, value in core.generics.items())
    return f"{core.library}.{core.entity}" + (f"({generics})" if generics else "")


def site(pin: Pin) -> str:
    """Return the board's name of a pin, or that it is not wired, or that the spec names no pin."""
    if not pin.is_used:
        return "not wired"
    return "no pin of a board yet" if pin.at is None else pin.at


def triggered(trigger: Trigger) -> str:
    """Return the name of the group that a trigger publishes, as a phrase."""
    return "no group" if trigger.group is None else f"group {trigger.group}"


def at_hardware(signal: Signal) -> Iterator[str]:
    """Yield phrases for the hardware properties of a register: effect, reset, safe value, wrap, schedule, pins."""
    if signal.effect is not None:
        yield EFFECTS[signal.effect]
    if signal.safe is not None and signal.safe.bits is not None:
        yield f"{_value(signal, signal.safe.bits)} after a reset and while {signal.safe.lease} is not armed"
    elif signal.reset:
        yield f"{_value(signal, signal.reset)} after a reset"
    if signal.safe is not None and signal.safe.bits is None:
        yield f"keeps its value while {signal.safe.lease} is not armed"
    if signal.laps_of is not None:
        yield "goes round, and a program counts on"
    if signal.timed is not None:
        yield f"TIMED by {signal.timed}"
    if signal.pin is not None:
        yield f"at {signal.pin}" if signal.kind.name is KindName.BOOL else f"at {signal.width} pins of {signal.pin}"


def wired(interface: Interface) -> Iterator[tuple[str, str, str]]:
    """Yield the pins of the board that a spec names: the pin, its direction, and the port or signal that it carries."""
    for component in interface.root.walk():
        for signal in component.signals:
            if signal.pin is not None:
                yield signal.pin, _WAYS[signal.access], signal.path
        for pin in () if component.core is None else component.core.pins:
            if pin.is_used and pin.at is not None:
                yield pin.at, pin.way, pin.path


def _value(signal: Signal, bits: int) -> str:
    """Format the value of a signal's bits with its unit; for an enumeration, its name."""
    value = signal.kind.decode(bits)
    if signal.kind.enumeration is not None:
        return next((one.name for one in signal.kind.enumeration.values if one.value == value), str(value))
    number = (
        str(value).lower() if isinstance(value, bool) else f"{value:.12g}" if isinstance(value, float) else str(value)
    )
    return f"{number} {signal.unit}".rstrip()
