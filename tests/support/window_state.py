"""The complete state of a window, for tests that compare two ways to reach it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.protocol.window.sequence_space import Run

if TYPE_CHECKING:
    from unity_link.protocol.window.window import Window


def window_state(window: Window[Any]) -> object:
    """Return all attributes of a window, its parts and its runs, in a form that can be compared."""
    return _state_of(window)


def _state_of(thing: object) -> object:
    if isinstance(thing, Run):
        return type(thing).__name__, thing.first, thing.count, thing.sending, thing.posted
    if isinstance(thing, list | tuple):
        # Most places of the sequence space are free: count them, compare the others.
        free = thing.count(None)
        return free, [] if free == len(thing) else [_state_of(part) for part in thing if part is not None]
    slots = [name for kind in type(thing).__mro__ for name in getattr(kind, "__slots__", ())]
    if not slots:
        return thing
    return {name: _state_of(getattr(thing, name)) for name in slots if name != "_ids"}
