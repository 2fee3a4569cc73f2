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
"""Factors to what REP 103 asks for; every other unit is taken as it is."""


def topic_names(interface: Interface) -> dict[str, str]:
    """Return the names in ROS of all components and signals by their paths: ``legs[2].coxa`` is ``legs_2/coxa``.

    Each is another one: where ``legs_2`` is a member too, the element of the array is ``legs_2_2``. That of the
    interface, which a joint needs whose signals stand there, is before no other.
    """
    names = {"": ""}
    for component in interface.root.walk():
        parts = [part for part in component.parts if isinstance(part, ComponentSpec)]
        elements = [one for part in component.parts if isinstance(part, ComponentArray) for one in part.items]
        # What has a name in the spec keeps it.
        signals = sorted(component.signals, key=lambda signal: signal.index is not None)
        members: list[Signal | ComponentSpec] = [*signals, *parts, *elements]
        taken: set[str] = set()
        for member in members:
            name = _unique(re.sub(r"\[(\d+)\]", r"_\1", member.path.rpartition(".")[2]), taken)
            taken.add(name)
            names[member.path] = f"{names[component.path]}/{name}".lstrip("/")
    return names | {"": _unique(interface.name, set(names.values()))}


def _unique(wanted: str, taken: set[str]) -> str:
    number, name = 1, wanted
    while name in taken:
        number += 1
        name = f"{wanted}_{number}"
    return name


def message_type(kind: Kind) -> str:
    """Return the type of ``std_msgs`` that holds every value of a kind; enumerations are their numbers."""
    return _TYPES[f"{kind.dtype.kind}{kind.dtype.itemsize}"]
