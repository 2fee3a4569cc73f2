"""ROS 2's types that the bridge speaks, as DDS sees them, with their hashes.

Since Iron, ROS 2 tells the hash of a type with each endpoint (REP 2016), and warns where two differ or one is missing.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, NamedTuple

from cyclonedds.idl import IdlStruct, make_idl_struct
from cyclonedds.idl.types import (
    byte,
    float32,
    float64,
    int8,
    int16,
    int32,
    int64,
    sequence,
    uint8,
    uint16,
    uint32,
    uint64,
)

from unity_link.bridges.ros2.rows import HEADER

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from unity_link.bridges.diagnostics import Status


class MessageType(NamedTuple):
    """A type of ROS 2."""

    struct: Any
    """The class of its messages."""
    hash: str
    """Hash of the type, as REP 2016 computes it."""


_LETTERS = {"Bool": "?", "Float32": "f", "Float64": "d"}
_LETTERS |= dict(
    zip(("Int8", "Int16", "Int32", "Int64", "UInt8", "UInt16", "UInt32", "UInt64"), "bhiqBHIQ", strict=True)
)
"""Format characters of `struct` for the types."""


def _type(package: str, name: str, fields: Mapping[str, Any], digest: str) -> MessageType:
    made: Any = make_idl_struct(f"{name}_", f"{package}::dds_::{name}_", dict(fields))
    # Not from a base class: that would be one in DDS, too.
    made.packed, made.serialize = b"", _serialize
    return MessageType(made, f"RIHS01_{digest}")


def _standard(name: str, data: Any, digest: str) -> MessageType:
    known = _type("std_msgs::msg", name, {"data": data}, digest)
    letter = _LETTERS[name]
    known.struct.readers = struct.Struct(f">{letter}"), struct.Struct(f"<{letter}")
    known.struct.deserialize = classmethod(_read_number)
    return known


def _serialize(message: Any, *arguments: Any, **options: Any) -> bytes:
    """Return the bytes of a message that may have been serialised before, with many others at a time: see `rows`."""
    return message.packed or IdlStruct.serialize(message, *arguments, **options)


def _read_number(kind: Any, data: bytes, *_: Any, **__: Any) -> Any:
    """Read a message by `struct`, as CycloneDDS's own way, which is Python, takes five times as long.

    What is too short to be one has None as its value.
    """
    made = kind.__new__(kind)
    reader = kind.readers[data[1] & 1]
    made.data = reader.unpack_from(data, HEADER)[0] if len(data) >= HEADER + reader.size else None
    return made


_sequence: Any = sequence
_time = _type("builtin_interfaces::msg", "Time", {"sec": int32, "nanosec": uint32}, "").struct
_header = _type("std_msgs::msg", "Header", {"stamp": _time, "frame_id": str}, "").struct

STANDARD: dict[str, MessageType] = {
    "Bool": _standard("Bool", bool, "feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9"),
    "Float32": _standard("Float32", float32, "7170d3d8f841f7be3172ce5f4f59f3a4d7f63b0447e8b33327601ad64d83d6e2"),
    "Float64": _standard("Float64", float64, "705ba9c3d1a09df43737eb67095534de36fd426c0587779bda2bc51fe790182a"),
    "Int8": _standard("Int8", int8, "26525065a403d972cb672f0777e333f0c799ad444ae5fcd79e43d1e73bd0f440"),
    "Int16": _standard("Int16", int16, "1dcc3464e47c288a55f943a389d337cdb06804de3f5cd7a266b0de718eee17e5"),
    "Int32": _standard("Int32", int32, "b6578ded3c58c626cfe8d1a6fb6e04f706f97e9f03d2727c9ff4e74b1cef0deb"),
    "Int64": _standard("Int64", int64, "8cd1048c2f186b6bd9a92472dc1ce51723c0833a221e2b7aecfff111774f4b49"),
    "UInt8": _standard("UInt8", uint8, "6138bd83d8c3569cb80a667db03cfc1629f529fee79d944c39c34e352e72f010"),
    "UInt16": _standard("UInt16", uint16, "08a406e4b022bc22e907f985d6a9e9dd1d4fbecae573549cf49350113e7757b1"),
    "UInt32": _standard("UInt32", uint32, "a5c874829b752bc5fa190024b0ad76f578cc278271e855c7d02a818b3516fb4a"),
    "UInt64": _standard("UInt64", uint64, "fbdc52018fc13755dce18024d1a671c856aa8b4aaf63adfb095b608f98e8c943"),
}
"""Those of ``std_msgs``, by their names."""

_dimension = _type("std_msgs::msg", "MultiArrayDimension", {"label": str, "size": uint32, "stride": uint32}, "").struct
_layout = _type("std_msgs::msg", "MultiArrayLayout", {"dim": _sequence[_dimension], "data_offset": uint32}, "").struct
FLOAT_ARRAY = _type(
    "std_msgs::msg",
    "Float64MultiArray",
    {"layout": _layout, "data": _sequence[float64]},
    "1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f",
)
_key_value = _type("diagnostic_msgs::msg", "KeyValue", {"key": str, "value": str}, "").struct
_status = _type(
    "diagnostic_msgs::msg",
    "DiagnosticStatus",
    {"level": byte, "name": str, "message": str, "hardware_id": str, "values": _sequence[_key_value]},
    "",
).struct
DIAGNOSTICS = _type(
    "diagnostic_msgs::msg",
    "DiagnosticArray",
    {"header": _header, "status": _sequence[_status]},
    "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e",
)

_duration = _type("builtin_interfaces::msg", "Duration", {"sec": int32, "nanosec": uint32}, "").struct
_numbers = dict.fromkeys(("positions", "velocities", "accelerations", "effort"), _sequence[float64])
_point = _type("trajectory_msgs::msg", "JointTrajectoryPoint", {**_numbers, "time_from_start": _duration}, "").struct
JOINT_TRAJECTORY = _type(
    "trajectory_msgs::msg",
    "JointTrajectory",
    {"header": _header, "joint_names": _sequence[str], "points": _sequence[_point]},
    "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e",
)


def diagnostics(statuses: Sequence[Status], at: float) -> bytes:
    """Return a ``diagnostic_msgs/DiagnosticArray``, at an instant in seconds since 1970."""
    seconds, nanoseconds = divmod(round(at * 1e9), 1_000_000_000)
    told = [
        _status(**{**one._asdict(), "values": [_key_value(key=key, value=value) for key, value in one.values]})
        for one in statuses
    ]
    header = _header(stamp=_time(sec=seconds, nanosec=nanoseconds), frame_id="")
    return bytes(IdlStruct.serialize(DIAGNOSTICS.struct(header=header, status=told)))


JOINT_STATE = _type(
    "sensor_msgs::msg",
    "JointState",
    {
        "header": _header,
        "name": _sequence[str],
        "position": _sequence[float64],
        "velocity": _sequence[float64],
        "effort": _sequence[float64],
    },
    "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
)
