"""Names, types and units of signals as topics, in ROS 1 and 2 and in Zenoh (REP 103)."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from unity_link.spec.model import ComponentArray, ComponentSpec

if TYPE_CHECKING:
    from unity_link.spec import Interface, Kind, Signal

_TYPES = {
    "b1": "Bool",
    **{f"u{size}": f"UInt{8 * size}" for size in (1, 2, 4, 8)},
    **{f"i{size}": f"Int{8 * size}" for size in (1, 2, 4, 8)},
    "f2": "Float32",
    "f4": "Float32",
    "f8": "Float64",
}
SI = {"deg": math.pi / 180, "deg/s": math.pi / 180, "mm": 1e-3, "mm/s": 1e-3, "cm": 1e-2, "cm/s": 1e-2, "Nmm": 1e-3}
"""Factors to the units of REP 103; values in other units are not converted."""


def topic_names(interface: Interface) -> dict[str, str]:
    """Return the names in ROS of all components and signals by their paths: ``legs[2].coxa`` is ``legs_2/coxa``.

    All names differ: if the component has a member ``legs_2``, too, the element of the array is ``legs_2_2``. The
    name of the interface itself, under the empty path, is for joints whose signals are in no component; it is not
    a prefix of the other names.
    """
    names = {"": ""}
    for component in interface.root.walk():
        parts = [part for part in component.parts if isinstance(part, ComponentSpec)]
        elements = [one for part in component.parts if isinstance(part, ComponentArray) for one in part.items]
        # Members without an index come first, so that they keep their names in the spec.
        signals = sorted(component.signals, key=lambda signal: signal.index is not None)
        members: list[Signal | ComponentSpec] = [*signals, *parts, *elements]
        taken: set[str] = set()
        for member in members:
            name = unique_name(re.sub(r"\[(\d+)\]", r"_\1", member.path.rpartition(".")[2]), taken)
            taken.add(name)
            names[member.path] = f"{names[component.path]}/{name}".lstrip("/")
    return names | {"": unique_name(interface.name, set(names.values()))}


def unique_name(wanted: str, taken: set[str]) -> str:
    """Return a name that is not taken: the wanted one, otherwise with a number, as ``legs_2``."""
    number, name = 1, wanted
    while name in taken:
        number += 1
        name = f"{wanted}_{number}"
    return name


def message_type(kind: Kind) -> str:
    """Return the type in ``std_msgs`` that can hold all values of a kind; values of enumerations are numbers."""
    return _TYPES[f"{kind.dtype.kind}{kind.dtype.itemsize}"]
