"""The hardware of a spec in words, as `show` and generated documents have it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.quoting import vhdl_literal
from unity_link.spec.kinds import KindName
from unity_link.spec.model import Effect

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec.model import Core, Pin, Signal, Trigger


EFFECTS = {
    Effect.CLEAR_ON_READ: "cleared by each read",
    Effect.WRITE_1_TO_CLEAR: "cleared by writing 1",
    Effect.PULSE: "a pulse of one clock cycle",
}
"""Effects of accesses, as people read them."""


def entity(core: Core) -> str:
    """Write an entity as VHDL names it, with its generics: ``unity_link.ul_pwm(width => 12)``."""
    generics = ", ".join(f"{name} => {vhdl_literal(value)}" for name, value in core.generics.items())
    return f"{core.library}.{core.entity}" + (f"({generics})" if generics else "")


def site(pin: Pin) -> str:
    """Write where a pin is: the board's name of it; that it is not wired, or that the spec does not say."""
    if not pin.is_used:
        return "not wired"
    return "no pin of a board yet" if pin.at is None else pin.at


def triggered(trigger: Trigger) -> str:
    """Write what a trigger does."""
    return "no group" if trigger.group is None else f"group {trigger.group}"


def at_hardware(signal: Signal) -> Iterator[str]:
    """Return what hardware has of a register beside its bits: effect, value after a reset, wrap, schedule, pins."""
    if signal.effect is not None:
        yield EFFECTS[signal.effect]
    if signal.reset:
        value = signal.kind.decode(signal.reset)
        yield f"{str(value).lower() if isinstance(value, bool) else value} after a reset"
    if signal.laps_of is not None:
        yield "goes round, and a program counts on"
    if signal.timed is not None:
        yield f"timed by {signal.timed}"
    if signal.pin is not None:
        yield f"at {signal.pin}" if signal.kind.name is KindName.BOOL else f"at {signal.width} pins of {signal.pin}"
