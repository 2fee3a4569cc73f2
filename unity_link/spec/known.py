"""Compares the cores in a board's description with those of this version, whose API programs would use.

The board may have been built with another version. An API uses registers and generics by name, so each of them must
exist on the board with the same meaning.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.cores import core_folders
from unity_link.spec.diagnostics import SpecError
from unity_link.spec.loading import read_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec.model import ComponentSpec, Interface, Signal, Spec

_OPEN = str.maketrans({"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"})


def misfits(interface: Interface, compiled: Callable[[str, Mapping[str, str]], Spec]) -> dict[str, str]:
    """Return reasons why the API of a core does not fit, by the paths of components that differ from this version.

    A core is not compared if this computer has no folder for it, or if its map requires more than one address.

    Args:
        interface: interface from a description.
        compiled: compiles the text of a spec, given the maps of all cores.
    """
    components = [part for part in interface.cores if part.core is not None and part.core.python]
    if not components:
        return {}
    ranks = reversed(list(core_folders(None)))
    maps = {word: read_text(folders[0].map) for rank in ranks for word, folders in rank.items()}
    # Compare only the first placement of each core: the description has one map for all of its placements, of which
    # there may be thousands.
    faults: dict[str, str] = {}
    for part in components:
        if part.type not in faults:
            known = _known(part, maps, interface.data_bits, compiled)
            faults[part.type] = "" if known is None else _difference(part, known)
    return {
        part.path: f"{part.path} is no {part.type} as this version of Unity-Link has it: {faults[part.type]}"
        for part in components
        if faults[part.type]
    }


def _known(
    part: ComponentSpec, maps: Mapping[str, str], data_bits: int, compiled: Callable[[str, Mapping[str, str]], Spec]
) -> ComponentSpec | None:
    """Return the component that this version's core gives for the same arguments; None if it cannot be compiled."""
    arguments = ", ".join(f"{name}={_text(value)}" for name, value in part.arguments.items())
    # If the parameters differ between the versions, compare the registers for the default values.
    for given in (arguments, ""):
        text = f"public known() {{ GATEWAY(DATA_BITS={data_bits}); core: {part.type}({given}) @(0); }}"
        try:
            return compiled(text, maps).interface().cores[0]
        except SpecError:
            pass
    return None


def _text(value: float | str) -> str:
    """Return an argument in the syntax of a spec."""
    if isinstance(value, str):
        return f'"{value.translate(_OPEN)}"'
    return str(value).lower() if isinstance(value, bool) else f"{value!r}"


def _difference(part: ComponentSpec, known: ComponentSpec) -> str:
    """Return the first difference between a component and the known one, as a clause; empty if they agree."""
    assert part.core is not None
    assert known.core is not None
    for name, value in known.core.generics.items():
        if name not in part.core.generics:
            return f"it has no generic {name}"
        if isinstance(part.core.generics[name], str) != isinstance(value, str):
            return f"its generic {name} is {part.core.generics[name]!r}, a value such as {value!r} was expected"
    registers = {signal.label: signal for signal in part.signals}
    if missing := [signal.label for signal in known.signals if signal.label not in registers]:
        return f"it has no register {missing[0]}"
    for signal in known.signals:
        first = known.signals[0]
        meant = _meaning(signal, first.address)
        there = _meaning(registers[signal.label], registers[first.label].address)
        for name, wanted in meant.items():
            if there[name] != wanted:
                return f"{name} of its register {signal.label} is {there[name]}, {wanted} was expected"
    return ""


def _meaning(signal: Signal, base: int) -> dict[str, object]:
    """Return the properties that an API relies on. Scale, unit and limits may differ: programs use the board's."""
    names = signal.kind.enumeration.values if signal.kind.enumeration is not None else ()
    return {
        "the distance in words": signal.address - base,
        "the lowest bit": signal.lowest_bit,
        "the width": signal.width,
        "the access": signal.access.name,
        "the kind": signal.kind.name.value,
        "the enumeration": " ".join(one.name for one in sorted(names, key=lambda one: one.value)) or "none",
        "the queue": signal.fifo,
    }
