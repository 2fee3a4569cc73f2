"""Comparison of the cores in a board's description with the cores of this version, whose Python API they would get.

A board may have been built by another version. An API reads registers and generics by their names, so each of them
must exist and mean the same.
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
    """Return why the API of a core does not fit, by the paths of the components that differ from this version's.

    A core that has no folder here, or whose own map needs more than an address, is not compared.

    Args:
        interface: from a description.
        compiled: compiles the text of a spec with the maps of all cores.
    """
    components = [part for part in interface.cores if part.core is not None and part.core.python]
    if not components:
        return {}
    ranks = reversed(list(core_folders(None)))
    maps = {word: read_text(folders[0].map) for rank in ranks for word, folders in rank.items()}
    # A description has one map for all placements of a core, so the first one is compared: there may be thousands.
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
    """Return a component of the core of this version with the arguments of another one; None if it has none."""
    arguments = ", ".join(f"{name}={_text(value)}" for name, value in part.arguments.items())
    # Parameters may differ, too; the registers are compared with those of the defaults then.
    for given in (arguments, ""):
        text = f"public known() {{ GATEWAY(DATA_BITS={data_bits}); core: {part.type}({given}) @(0); }}"
        try:
            return compiled(text, maps).interface().cores[0]
        except SpecError:
            pass
    return None


def _text(value: float | str) -> str:
    """Return an argument as a spec has it."""
    if isinstance(value, str):
        return f'"{value.translate(_OPEN)}"'
    return str(value).lower() if isinstance(value, bool) else f"{value!r}"


def _difference(part: ComponentSpec, known: ComponentSpec) -> str:
    """Return the first difference of a component from the known one, as a clause; empty if there is none."""
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
    """Return the properties that an API relies on. Scale, unit and limits may differ: the description has them."""
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
