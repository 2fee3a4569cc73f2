"""The bridge as a participant of DDS, by CycloneDDS: for a Python without rclpy."""

from __future__ import annotations

import ctypes
import functools
from typing import TYPE_CHECKING, Any

import numpy as np
from cyclonedds.core import DDSException, Policy, Qos
from cyclonedds.internal import DDS
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from unity_link.bridges.diagnostics import TOPIC
from unity_link.bridges.ros import PATIENCE
from unity_link.bridges.ros2.domain import is_alone, open_participant
from unity_link.bridges.ros2.inlets import Inlets
from unity_link.bridges.ros2.messages import (
    DIAGNOSTICS,
    FLOAT_ARRAY,
    JOINT_STATE,
    JOINT_TRAJECTORY,
    STANDARD,
    diagnostics,
)
from unity_link.bridges.ros2.node import Ros2Bridge
from unity_link.bridges.ros2.outlet import Ros2Outlet
from unity_link.bridges.ros2.rows import number_rows
from unity_link.bridges.ros2.settings import Quality
from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.ros2.arguments import NodeNames
    from unity_link.bridges.ros2.messages import MessageType
    from unity_link.bridges.ros2.settings import BridgeSettings
    from unity_link.bridges.ros_leases import RosLease
    from unity_link.data import Robot

MOST_KEPT = 1 << 14
"""Values of a topic that wait for the link; beyond, who writes it waits."""

# Functions of CycloneDDS's C library that its Python package does not name. The library sends a packet for each
# message, unless messages are gathered until a flush.
_library = ctypes.CDLL(DDS._dll_handle._name)  # noqa: SLF001
_library.dds_write_set_batch.argtypes = [ctypes.c_bool]
_library.dds_write_flush.argtypes = [ctypes.c_int32]
_library.dds_wait_for_acks.argtypes = [ctypes.c_int32, ctypes.c_int64]


class DdsBridge(Ros2Bridge):
    """A bridge that is a participant of DDS, and no node.

    Args:
        robot: a robot of any spec, behind an open link.
        settings: parameters of the bridge.
        names: that ROS gives the node from outside.
        report: logs a sentence.
    """

    def __init__(
        self,
        robot: Robot,
        settings: BridgeSettings,
        names: NodeNames,
        *,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        super().__init__(robot, settings, report)
        self._names = names
        self._inlets: Inlets | None = None
        self._participant: Any = None
        self._domain: Any = None
        self._diagnostics: DdsOutlet | None = None
        self._set_points: dict[str, Any] = {}
        self._arming: list[tuple[Any, Callable[[Any], Any]]] = []

    def _open(self) -> None:
        mark = f"unity_link={self._resolve(self._namespace)};"
        self._participant, self._domain = open_participant(self._settings, mark)
        if not is_alone(self._participant, mark):
            raise ConnectError(self._second_bridge())
        self._open_outlets()
        self._diagnostics = self._outlet(TOPIC, DIAGNOSTICS, Quality.RELIABLE)
        readers = [(self._reader(topic.name, STANDARD[topic.type]), topic.proxy) for topic in self._command_topics]
        joints: list[tuple[Any, Callable[[Any], None]]] = [
            (
                self._reader(topic.name, JOINT_STATE if topic.part is None else FLOAT_ARRAY),
                functools.partial(self._give_joints, topic),
            )
            for topic in self._joint_command_topics
        ]
        joints += [(self._reader(one.name, JOINT_TRAJECTORY), one.give) for one in self._trajectories]
        self._set_points = {reader.topic.name: reader for reader, _ in (*readers, *joints)}
        self._open_leases()
        self._inlets = Inlets(
            self._participant, readers, [*joints, *self._arming], self._commands.give, self._faults.tell
        )

    def _open_lease(self, lease: RosLease, name: str) -> Callable[[bool], None]:
        # Services do not cross from one vendor of DDS to another, so a topic arms.
        kind = STANDARD["Bool"]
        self._arming.append(
            (self._reader(f"{name.removeprefix(self._namespace)}/arm", kind), lambda one: lease.ask(one.data))
        )
        outlet = self._outlet(f"{name}/armed", kind, Quality.RELIABLE, Policy.Durability.TransientLocal)
        self._outlets[f"{name}/armed"] = outlet
        return lambda armed: outlet.send(number_rows("Bool", np.array([armed])))

    def _programs(self, topics: list[str]) -> set[str]:
        names = [f"rt{self._resolve(self._namespace + topic)}" for topic in topics]
        found = (
            reader.get_matched_publication_data(one)
            for reader in (self._set_points[name] for name in names)
            for one in reader.get_matched_publications()
        )
        return {str(one.participant_key) for one in found if one is not None}

    def _close(self) -> None:
        if self._inlets is not None:
            self._inlets.close()
        self._finish_outlets()
        self._set_points.clear()
        self._arming.clear()
        self._inlets = self._participant = self._domain = self._diagnostics = None

    def _resolve(self, name: str) -> str:
        return self._names.resolve(name)

    def _topic(self, name: str, message: MessageType) -> Any:
        return Topic(self._participant, f"rt{self._resolve(name)}", message.struct)

    def _outlet(self, name: str, message: MessageType, profile: Quality, *more: Any) -> DdsOutlet:
        writer = functools.partial(DataWriter, self._participant, qos=_quality(profile, message, *more))
        return DdsOutlet(writer, self._topic(name, message), self._losses.tell)

    def _open_outlet(self, name: str, package: str, kind: str) -> DdsOutlet:
        message = STANDARD[kind] if package == "std_msgs" else JOINT_STATE
        return self._outlet(self._namespace + name, message, self._settings.quality_of(name))

    def _reader(self, name: str, message: MessageType) -> Any:
        quality = _quality(Quality.RELIABLE, message, Policy.ResourceLimits(MOST_KEPT, -1, MOST_KEPT))
        return DataReader(self._participant, self._topic(self._namespace + name, message), qos=quality)

    def _tell(self, statuses: list[Status], at: float) -> None:
        if self._diagnostics is not None and self._diagnostics.is_wanted:
            self._diagnostics.send([diagnostics(statuses, at)])


def _quality(profile: Quality, message: MessageType, *more: Any) -> Any:
    if profile is Quality.SENSOR_DATA:
        reliability, history = Policy.Reliability.BestEffort, Policy.History.KeepLast(5)
    else:
        reliability = Policy.Reliability.Reliable(duration(seconds=PATIENCE))
        history = Policy.History.KeepAll
    # What differs between the two ends of a topic for no reason is warned of: the rest is as in ROS 2's profiles.
    typehash = Policy.Userdata(f"typehash={message.hash};".encode())
    if Policy.Durability.TransientLocal in more:
        return Qos(reliability, Policy.History.KeepLast(1), typehash, *more)
    return Qos(reliability, history, Policy.Durability.Volatile, typehash, *more)


class DdsOutlet(Ros2Outlet):
    """A topic that a participant publishes.

    Args:
        writer: makes the writer of a topic.
        topic: of CycloneDDS.
        report: logs a sentence about readers that are stuck.
    """

    def __init__(self, writer: Callable[[Any], Any], topic: Any, report: Callable[[str], None]) -> None:
        super().__init__(topic.name.removeprefix("rt"), report)
        # It is for all writers that are made from now on.
        _library.dds_write_set_batch(True)  # noqa: FBT003
        self._writer = writer(topic)
        _library.dds_write_set_batch(False)  # noqa: FBT003
        self._message = topic.data_type.__new__(topic.data_type)

    @property
    def is_wanted(self) -> bool:
        """Return whether the topic has a reader."""
        return bool(self._writer.get_matched_subscriptions())

    def _write(self, row: bytes) -> bool:
        self._message.packed = row
        try:
            self._writer.write(self._message)
        except DDSException:
            return False
        return True

    def _flush(self) -> None:
        _library.dds_write_flush(self._writer._ref)  # noqa: SLF001

    def finish(self) -> None:
        """Wait as in the base class, and release the writer."""
        super().finish()
        del self._writer

    def _is_confirmed(self, patience: float) -> bool:
        return int(_library.dds_wait_for_acks(self._writer._ref, round(patience * 1e9))) == 0  # noqa: SLF001
