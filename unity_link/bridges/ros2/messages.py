"""ROS 2's types that the bridge speaks, as DDS sees them, with their hashes.

Since Iron, each endpoint of ROS 2 announces the hash of its type (REP 2016); a warning follows if two hashes differ, or
one is missing.
"""

from __future__ import annotations

import struct
from typing import Any, NamedTuple

from cyclonedds.idl import IdlStruct, make_idl_struct, types

from unity_link.bridges.ros_rows import HEADER


class MessageType(NamedTuple):
    """A type of ROS 2."""

    struct: Any
    """The class of its messages."""
    hash: str
    """Hash of the type, as REP 2016 computes it."""


TYPES: dict[str, MessageType] = {}
"""Types by their names, such as ``Float64``."""


def _kind_of(word: str) -> Any:
    """Return the type of a field, such as ``float64``, ``float64[9]``, ``string[]`` or the name of a message."""
    base, _, size = word.rstrip("]").partition("[")
    kind = {"string": str, "bool": bool}.get(base) or (TYPES[base].struct if base in TYPES else getattr(types, base))
    makers: Any = types
    if not word.endswith("]"):
        return kind
    return makers.array[kind, int(size)] if size else makers.sequence[kind]


def _add(package: str, name: str, fields: str, digest: str = "") -> Any:
    """Add a type; return the class of its messages.

    Args:
        package: of the type.
        name: of the type.
        fields: a type and the names of its fields, such as ``int32 sec; float32 x y``.
        digest: the hash of the type; empty for one that is only a field of others.
    """
    kinds = {field: _kind_of(kind) for kind, *names in map(str.split, fields.split(";")) for field in names}
    made: Any = make_idl_struct(f"{name}_", f"{package}::msg::dds_::{name}_", kinds)
    # Not from a base class: that would be one in DDS, too.
    made.packed, made.serialize = b"", _serialize
    TYPES[name] = MessageType(made, f"RIHS01_{digest}")
    return made


def _serialize(message: Any, *arguments: Any, **options: Any) -> bytes:
    """Return the bytes of a message that may have been serialised before, with many others: see `ros_rows`."""
    return message.packed or IdlStruct.serialize(message, *arguments, **options)


def _read_number(kind: Any, data: bytes, *_: Any, **__: Any) -> Any:
    """Read a message by `struct`, as CycloneDDS's own way, which is Python, takes five times as long.

    The value is None if the data is too short for the type.
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
    _number = _add("std_msgs", _name, f"{_name.lower()} data", _digest)
    _number.readers = struct.Struct(f">{_letter}"), struct.Struct(f"<{_letter}")
    _number.deserialize = classmethod(_read_number)

_add("builtin_interfaces", "Time", "int32 sec; uint32 nanosec")
_add("builtin_interfaces", "Duration", "int32 sec; uint32 nanosec")
_add("std_msgs", "Header", "Time stamp; string frame_id")
_add("std_msgs", "MultiArrayDimension", "string label; uint32 size stride")
_add("std_msgs", "MultiArrayLayout", "MultiArrayDimension[] dim; uint32 data_offset")
_add("geometry_msgs", "Vector3", "float64 x y z")
_add("geometry_msgs", "Quaternion", "float64 x y z w")
_add(
    "trajectory_msgs",
    "JointTrajectoryPoint",
    "float64[] positions velocities accelerations effort; Duration time_from_start",
)
_add("diagnostic_msgs", "KeyValue", "string key value")
_add("diagnostic_msgs", "DiagnosticStatus", "byte level; string name message hardware_id; KeyValue[] values")
for _package, _name, _fields, _digest in (
    ("std_msgs", "Float64MultiArray", "MultiArrayLayout layout; float64[] data",
     "1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f"),
    ("sensor_msgs", "JointState", "Header header; string[] name; float64[] position velocity effort",
     "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"),
    ("sensor_msgs", "Imu", ("Header header; Quaternion orientation; float64[9] orientation_covariance; "
     "Vector3 angular_velocity; float64[9] angular_velocity_covariance; "
     "Vector3 linear_acceleration; float64[9] linear_acceleration_covariance"),
     "7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"),
    ("sensor_msgs", "BatteryState", ("Header header; float32 voltage temperature current charge capacity "
     "design_capacity percentage; uint8 power_supply_status power_supply_health power_supply_technology; "
     "bool present; float32[] cell_voltage cell_temperature; string location serial_number"),
     "4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741"),
    ("sensor_msgs", "Range", ("Header header; uint8 radiation_type; "
     "float32 field_of_view min_range max_range range variance"),
     "b42b62562e93cbfe9d42b82fe5994dfa3d63d7d5c90a317981703f7388adff3a"),
    ("trajectory_msgs", "JointTrajectory", "Header header; string[] joint_names; JointTrajectoryPoint[] points",
     "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e"),
    ("diagnostic_msgs", "DiagnosticArray", "Header header; DiagnosticStatus[] status",
     "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"),
):  # fmt: skip
    _add(_package, _name, _fields, _digest)
