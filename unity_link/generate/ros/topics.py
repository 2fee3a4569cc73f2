"""Topics: how signals are named and typed in ROS, 1 and 2 alike, and in which units (REP 103)."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from unity_link.spec import Kind

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


def topic_name(path: str) -> str:
    """Write a path as ROS writes names: ``legs[2].coxa`` as ``legs_2/coxa``."""
    return re.sub(r"\[(\d+)\]", r"_\1", path).replace(".", "/")


def message_type(kind: Kind) -> str:
    """Return the type of ``std_msgs`` that holds every value of a kind; enumerations are their numbers."""
    return _TYPES[f"{kind.dtype.kind}{kind.dtype.itemsize}"]
