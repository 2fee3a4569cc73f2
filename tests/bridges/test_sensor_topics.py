"""Sensors of a spec as messages of ROS: the bytes that ROS makes of them, in SI units."""

from __future__ import annotations

import importlib
import io
import math
import struct
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.bridges.ros1 import environment
from unity_link.bridges.ros_rows import stamped_rows
from unity_link.bridges.topics import published_groups
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated

if TYPE_CHECKING:
    from unity_link.bridges.sensor_topics import SensorTopic
    from unity_link.data import Batch

SPEC = """
group fast(RATE=100, TIMESTAMPS,
  IMU(ANGULAR_VELOCITY=gyro, LINEAR_ACCELERATION=acc),
  BATTERY(VOLTAGE=voltage, PERCENTAGE=level),
  RANGEFINDER(DISTANCE=distance, FIELD_OF_VIEW=0.25, INFRARED));
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  body: chip() @(0x10);
  @voltage = 0x20: READWRITE(SCALE=0.001, UNIT="V", PUBLISH(fast));
  @level = 0x21: READWRITE(UNIT="%", PUBLISH(fast));
  front: eye() @(0x30);
}
chip(): @(base) {
  @gyro[3] = base + i: signed 16 READWRITE(SCALE=0.01, UNIT="deg/s", PUBLISH(fast));
  @acc[3] = base + 4 + i: signed 16 READWRITE(SCALE=0.001, UNIT="g", PUBLISH(fast));
}
eye(): @(base) {
  @distance = base: READWRITE(MIN=20, MAX=4000, UNIT="mm", PUBLISH(fast));
}
"""
WORDS = [(0x10, [9000, -9000 & 0xFFFF, 0]), (0x14, [0, 0, 1000]), (0x20, [12_600, 80]), (0x30, [500])]
"""Addresses and words: 90 and -90 degrees/s, the acceleration of a resting robot, 12.6 V, 80 %, 0.5 m."""
TOPICS = {"body/imu": "Imu", "battery_state": "BatteryState", "front/range": "Range"}
EXPECTED: dict[str, dict[str, Any]] = {
    "Imu": {
        "orientation_covariance": [-1.0, *[0.0] * 8],
        "angular_velocity": {"x": math.pi / 2, "y": -math.pi / 2, "z": 0.0},
        "linear_acceleration": {"x": 0.0, "y": 0.0, "z": 9.80665},
    },
    "BatteryState": {"voltage": 12.6, "percentage": 0.8, "current": math.nan, "present": True, "cell_voltage": []},
    "Range": {"radiation_type": 1, "field_of_view": 0.25, "min_range": 0.02, "max_range": 4.0, "range": 0.5},
}


async def sampled() -> tuple[list[SensorTopic], Batch]:
    """Return the topics of the robot's sensors, and a batch of samples."""
    robot_type: Any = unity_link.load(compile_text(SPEC))
    async with unity_link.connect(simulated(compile_text(SPEC).interface())) as link:
        for address, words in WORDS:
            await link.write_block(address, words)
        (published,) = published_groups(robot_type(link))
        async with published.group.subscribe() as samples:
            return published.sensors, await samples.take()


def filled(message: Any, values: dict[str, Any], make: Any) -> Any:
    """Set fields of a message; return it. `make` converts a list of numbers to the type of the field."""
    for name, value in values.items():
        if isinstance(value, dict):
            filled(getattr(message, name), value, make)
        else:
            setattr(message, name, make(value) if isinstance(value, list) else value)
    return message


@on_simulated_time
async def test_each_sensor_of_a_group_has_a_topic_and_a_frame() -> None:
    topics, _ = await sampled()
    assert {topic.name: topic.kind for topic in topics} == TOPICS
    assert [topic.frame for topic in topics] == ["body", "rover", "front"]


@on_simulated_time
async def test_messages_of_sensors_are_the_bytes_that_ros_2_gives_them() -> None:
    store = get_typestore(Stores.ROS2_JAZZY)
    types = store.types
    topics, batch = await sampled()
    instants = np.full(len(batch), 12.5)
    stamp = types["builtin_interfaces/msg/Time"](sec=12, nanosec=500_000_000)

    def vector(values: dict[str, float]) -> Any:
        return types["geometry_msgs/msg/Vector3"](**values)

    none, unknown = np.zeros(9), math.nan
    expected = EXPECTED["Imu"]
    bodies: dict[str, dict[str, Any]] = {
        "Imu": {
            "orientation": types["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=0.0, w=0.0),
            "orientation_covariance": np.array(expected["orientation_covariance"]),
            "angular_velocity": vector(expected["angular_velocity"]),
            "angular_velocity_covariance": none,
            "linear_acceleration": vector(expected["linear_acceleration"]),
            "linear_acceleration_covariance": none,
        },
        "BatteryState": {
            **dict.fromkeys(("temperature", "current", "charge", "capacity", "design_capacity"), unknown),
            **dict.fromkeys(("power_supply_status", "power_supply_health", "power_supply_technology"), 0),
            "cell_voltage": np.zeros(0, np.float32),
            "cell_temperature": np.zeros(0, np.float32),
            "voltage": 12.6,
            "percentage": 0.8,
            "present": True,
            "location": "",
            "serial_number": "",
        },
        "Range": {**EXPECTED["Range"], "variance": 0.0},
    }
    for topic in topics:
        name = f"sensor_msgs/msg/{topic.kind}"
        header = types["std_msgs/msg/Header"](stamp=stamp, frame_id=topic.frame)
        message = types[name](header=header, **bodies[topic.kind])
        rows = stamped_rows(instants, topic.fields(batch, has_variance=True), topic.frame)
        assert rows[-1].tobytes() == bytes(store.serialize_cdr(message, name))


@pytest.mark.slow
@on_simulated_time
async def test_messages_of_sensors_are_the_bytes_that_rospy_gives_them() -> None:
    environment.find_rospy()
    genpy, messages = importlib.import_module("genpy"), importlib.import_module("sensor_msgs.msg")
    topics, batch = await sampled()
    unknown = dict.fromkeys(("temperature", "current", "charge", "capacity", "design_capacity"), math.nan)
    for topic in topics:
        message = filled(getattr(messages, topic.kind)(), EXPECTED[topic.kind], list)
        if topic.kind == "BatteryState":
            filled(message, unknown, list)
        message.header.seq, message.header.stamp, message.header.frame_id = 7, genpy.Time(12, 500_000_000), topic.frame
        buffer = io.BytesIO()
        message.serialize(buffer)
        rows = stamped_rows(np.array([12.5]), topic.fields(batch, has_variance=False), topic.frame, 7)
        assert rows[-1].tobytes() == struct.pack("<I", len(buffer.getvalue())) + buffer.getvalue()
