"""ROS 2's types that the bridge speaks, as DDS sees them, with their hashes.

Since Iron, ROS 2 tells the hash of a type with each endpoint (REP 2016), and warns where two differ or one is missing.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, NamedTuple

from cyclonedds.idl import IdlStruct, make_idl_struct, types

from unity_link.bridges.ros_rows import HEADER

if TYPE_CHECKING:
    from collections.abc import Mapping


class MessageType(NamedTuple):
    """A type of ROS 2."""

    struct: Any
    """The class of its messages."""
    hash: str
    """Hash of the type, as REP 2016 computes it."""


TYPES: dict[str, MessageType] = {}
"""Types by their names, such as ``Float64``."""


def _add(package: str, name: str, fields: Mapping[str, Any], digest: str = "") -> Any:
    """Add a type; return the class of its messages."""
    made: Any = make_idl_struct(f"{name}_", f"{package}::msg::dds_::{name}_", dict(fields))
    # Not from a base class: that would be one in DDS, too.
    made.packed, made.serialize = b"", _serialize
    TYPES[name] = MessageType(made, f"RIHS01_{digest}")
    return made


def _serialize(message: Any, *arguments: Any, **options: Any) -> bytes:
    """Return the bytes of a message that may have been serialised before, with many others: see `ros_rows`."""
    return message.packed or IdlStruct.serialize(message, *arguments, **options)


def _read_number(kind: Any, data: bytes, *_: Any, **__: Any) -> Any:
    """Read a message by `struct`, as CycloneDDS's own way, which is Python, takes five times as long.

    What is too short to be one has None as its value.
    """
    made = kind.__new__(kind)
    reader = kind.readers[data[1] & 1]
    made.data = reader.unpack_from(data, HEADER)[0] if len(data) >= HEADER + reader.size else None
    return made


# The types of numbers, with their format characters of `struct`.
for _name, _letter, _digest in (
    ("Bool", "?", "feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9"),
    ("Float32", "f", "7170d3d8f841f7be3172ce5f4f59f3a4d7f63b0447e8b33327601ad64d83d6e2"),
    ("Float64", "d", "705ba9c3d1a09df43737eb67095534de36fd426c0587779bda2bc51fe790182a"),
    ("Int8", "b", "26525065a403d972cb672f0777e333f0c799ad444ae5fcd79e43d1e73bd0f440"),
    ("Int16", "h", "1dcc3464e47c288a55f943a389d337cdb06804de3f5cd7a266b0de718eee17e5"),
    ("Int32", "i", "b6578ded3c58c626cfe8d1a6fb6e04f706f97e9f03d2727c9ff4e74b1cef0deb"),
    ("Int64", "q", "8cd1048c2f186b6bd9a92472dc1ce51723c0833a221e2b7aecfff111774f4b49"),
    ("UInt8", "B", "6138bd83d8c3569cb80a667db03cfc1629f529fee79d944c39c34e352e72f010"),
    ("UInt16", "H", "08a406e4b022bc22e907f985d6a9e9dd1d4fbecae573549cf49350113e7757b1"),
    ("UInt32", "I", "a5c874829b752bc5fa190024b0ad76f578cc278271e855c7d02a818b3516fb4a"),
    ("UInt64", "Q", "fbdc52018fc13755dce18024d1a671c856aa8b4aaf63adfb095b608f98e8c943"),
):
    _number = _add("std_msgs", _name, {"data": getattr(types, _name.lower(), bool)}, _digest)
    _number.readers = struct.Struct(f">{_letter}"), struct.Struct(f"<{_letter}")
    _number.deserialize = classmethod(_read_number)

_sequence: Any = types.sequence
_floats = _sequence[types.float64]
_time = _add("builtin_interfaces", "Time", {"sec": types.int32, "nanosec": types.uint32})
_duration = _add("builtin_interfaces", "Duration", {"sec": types.int32, "nanosec": types.uint32})
_header = _add("std_msgs", "Header", {"stamp": _time, "frame_id": str})

_sizes = {"label": str, "size": types.uint32, "stride": types.uint32}
_dimension = _add("std_msgs", "MultiArrayDimension", _sizes)
_layout = _add("std_msgs", "MultiArrayLayout", {"dim": _sequence[_dimension], "data_offset": types.uint32})
_add(
    "std_msgs",
    "Float64MultiArray",
    {"layout": _layout, "data": _floats},
    "1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f",
)
_add(
    "sensor_msgs",
    "JointState",
    {"header": _header, "name": _sequence[str], "position": _floats, "velocity": _floats, "effort": _floats},
    "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
)

_numbers = dict.fromkeys(("positions", "velocities", "accelerations", "effort"), _floats)
_point = _add("trajectory_msgs", "JointTrajectoryPoint", {**_numbers, "time_from_start": _duration})
_add(
    "trajectory_msgs",
    "JointTrajectory",
    {"header": _header, "joint_names": _sequence[str], "points": _sequence[_point]},
    "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e",
)

_pair = _add("diagnostic_msgs", "KeyValue", {"key": str, "value": str})
_texts = dict.fromkeys(("name", "message", "hardware_id"), str)
_status = _add("diagnostic_msgs", "DiagnosticStatus", {"level": types.byte, **_texts, "values": _sequence[_pair]})
_add(
    "diagnostic_msgs",
    "DiagnosticArray",
    {"header": _header, "status": _sequence[_status]},
    "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e",
)
