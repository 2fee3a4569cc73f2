"""Sensors of a group as messages of ``sensor_msgs``: Imu, BatteryState and Range, in SI units (REP 103, 117, 145)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.bridges.topic_names import SI, unique_name
from unity_link.spec.arguments import SENSORS

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from unity_link.data import Batch, Proxy, Robot
    from unity_link.spec import Sensor

Field = str | tuple[Any, Any]
"""A text; or the numpy type of a field, and its value for all messages or one for each, of shape (samples, ...)."""
KINDS = {"IMU": "Imu", "BATTERY": "BatteryState", "RANGEFINDER": "Range"}
"""Types in ``sensor_msgs`` by the words for sensors in a spec."""
TOPICS = {"IMU": "imu", "BATTERY": "battery_state", "RANGEFINDER": "range"}
_FACTORS = SI | {"g": 9.80665, "mV": 1e-3, "mA": 1e-3, "mAh": 1e-3, "%": 1e-2}
_NOT_MEASURED = (-1.0, *[0.0] * 8)
"""Covariance for a quantity that an IMU does not measure; zeros would mean an unknown covariance."""
_BATTERY = ("VOLTAGE", "TEMPERATURE", "CURRENT", "CHARGE", "CAPACITY", "DESIGN_CAPACITY", "PERCENTAGE")
_BYTE, _COUNT, _FLOAT, _DOUBLE = "u1", "<u4", "<f4", "<f8"


class SensorTopic(NamedTuple):
    """A sensor whose samples are published as a topic."""

    name: str
    frame: str
    """Frame of the messages: the name of the component, with ``_`` in place of each slash."""
    sensor: Sensor
    proxies: Mapping[str, Sequence[Proxy[Any]]]
    """Signals of each part of the sensor, such as ``ORIENTATION``."""

    @property
    def kind(self) -> str:
        """Type in ``sensor_msgs``."""
        return KINDS[self.sensor.word]

    def fields(self, batch: Batch, *, has_variance: bool) -> list[Field]:
        """Return the fields of the messages after their header; `has_variance` must be True for the Range of ROS 2."""
        if self.sensor.word == "IMU":
            return self._imu(batch)
        if self.sensor.word == "BATTERY":
            return self._battery(batch)
        return [*self._range(batch), *([(_FLOAT, 0.0)] if has_variance else [])]

    def _imu(self, batch: Batch) -> list[Field]:
        fields: list[Field] = []
        # The message has the parts in the same order.
        for part, size in SENSORS["IMU"].items():
            is_there = part in self.proxies
            values = self._columns(part, batch) if is_there else (0.0,) * size
            covariance = (0.0,) * 9 if is_there else _NOT_MEASURED
            fields += [((_DOUBLE, size), values), ((_DOUBLE, 9), covariance)]
        return fields

    def _battery(self, batch: Batch) -> list[Field]:
        numbers = [self._columns(part, batch)[:, 0] if part in self.proxies else math.nan for part in _BATTERY]
        # Status, health and technology are unknown, the battery is present; other fields are empty.
        states: list[Field] = [(_BYTE, state) for state in (0, 0, 0, 1)]
        return [*((_FLOAT, number) for number in numbers), *states, (_COUNT, 0), (_COUNT, 0), "", ""]

    def _range(self, batch: Batch) -> list[Field]:
        (distance,) = self.proxies["DISTANCE"]
        factor = _FACTORS.get(distance.unit, 1.0)
        lowest, highest = (limit * factor for limit in distance.signal.limits)
        known = self.sensor.field_of_view, max(0.0, lowest), highest
        values = self._columns("DISTANCE", batch)[:, 0]
        return [(_BYTE, int(self.sensor.infrared)), *((_FLOAT, value) for value in (*known, values))]

    def _columns(self, part: str, batch: Batch) -> NDArray[np.float64]:
        """Return the values of a part in SI units, shape (samples, signals)."""
        columns = [batch[proxy] * _FACTORS.get(proxy.unit, 1.0) for proxy in self.proxies[part]]
        return np.stack(columns, axis=1).astype(np.float64)


def sensor_topics(sensors: Sequence[Sensor], robot: Robot, names: dict[str, str], taken: set[str]) -> list[SensorTopic]:
    """Return the topics of the sensors of a group.

    Args:
        sensors: sensors of the group.
        robot: robot with their signals.
        names: names of components and signals in ROS, by their paths.
        taken: names of topics in use; the names of the sensors' topics are added.
    """
    found = []
    for sensor in sensors:
        component = names[sensor.name] if sensor.name else ""
        name = unique_name(f"{component}/{TOPICS[sensor.word]}".lstrip("/"), taken)
        taken.add(name)
        proxies = {part: [robot[path] for path in paths] for part, paths in sensor.signals.items()}
        frame = component.replace("/", "_") or robot.interface.name
        found.append(SensorTopic(name, frame, sensor, proxies))
    return found
