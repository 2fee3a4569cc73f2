"""``diagnostic_msgs`` of ROS 1, made from its definition: not every distribution of rospy has the package."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from unity_link.bridges.diagnostics import array_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.bridges.diagnostics import Status

_LINE = "=" * 80
_DEFINITION = f"""Header header
diagnostic_msgs/DiagnosticStatus[] status
{_LINE}
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
{_LINE}
MSG: diagnostic_msgs/DiagnosticStatus
byte OK=0
byte WARN=1
byte ERROR=2
byte STALE=3
byte level
string name
string message
string hardware_id
diagnostic_msgs/KeyValue[] values
{_LINE}
MSG: diagnostic_msgs/KeyValue
string key
string value
"""


@cache
def types() -> dict[str, Any]:
    """Return the classes by the names of their types, such as ``diagnostic_msgs/DiagnosticArray``."""
    from genpy.dynamic import generate_dynamic

    made: dict[str, Any] = generate_dynamic("diagnostic_msgs/DiagnosticArray", _DEFINITION)
    return made


def message(statuses: Sequence[Status], at: float) -> Any:
    """Return a message, at an instant in seconds since 1970."""
    names = ("DiagnosticArray", "DiagnosticStatus", "KeyValue")
    array = array_of(statuses, *(types()[f"diagnostic_msgs/{name}"] for name in names))
    array.header.stamp = type(array.header.stamp).from_sec(at)
    return array
