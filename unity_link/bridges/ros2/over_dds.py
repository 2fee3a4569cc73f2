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

from unity_link.bridges.diagnostics import TOPIC, array_of
from unity_link.bridges.ros import PATIENCE
from unity_link.bridges.ros2.domain import finder, open_participant
from unity_link.bridges.ros2.inlets import Inlets
from unity_link.bridges.ros2.messages import TYPES
from unity_link.bridges.ros2.node import Ros2Bridge, Ros2Outlet
from unity_link.bridges.ros_settings import Quality

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.ros2.arguments import NodeNames
    from unity_link.bridges.ros_leases import RosLease
    from unity_link.bridges.ros_rows import Rows
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.data import Robot

_RELIABLE = Policy.Reliability.Reliable(duration(seconds=PATIENCE))
# DDS warns of each difference between the two ends of a topic: the other policies are those of ROS 2's profiles.
_PROFILES = {
    Quality.RELIABLE: (_RELIABLE, Policy.History.KeepAll, Policy.Durability.Volatile),
    Quality.SENSOR_DATA: (Policy.Reliability.BestEffort, Policy.History.KeepLast(5), Policy.Durability.Volatile),
}
_LATCHED = _RELIABLE, Policy.History.KeepLast(1), Policy.Durability.TransientLocal
MOST_KEPT = 1 << 14
"""Limit of values of a topic that wait for the link; at the limit, the writer of the topic waits."""

# Functions of CycloneDDS's C library that its Python package does not name. The library sends a packet for each
# message, unless messages are gathered until a flush.
_library = ctypes.CDLL(DDS._dll_handle._name)  # noqa: SLF001
_library.dds_write_set_batch.argtypes = [ctypes.c_bool]
_library.dds_write_flush.argtypes = [ctypes.c_int32]
_library.dds_wait_for_acks.argtypes = [ctypes.c_int32, ctypes.c_int64]


class DdsBridge(Ros2Bridge):
    """A bridge that is a participant of DDS, with the names that ROS gives a node from outside."""

    def __init__(self, robot: Robot, settings: BridgeSettings, names: NodeNames, report: Callable[[str], None]) -> None:
        super().__init__(robot, settings, report)
        self._names = names
        self._inlets: Inlets | None = None
        self._participant: Any = None
        self._domain: Any = None
        self._diagnostics: DdsOutlet | None = None
        self._readers: list[tuple[Any, Callable[[Any], object]]] = []
        """Readers, each with a function that takes its messages."""

    def _open(self) -> None:
        mark = f"unity_link={self._resolve(self._namespace)};"
        self._participant, self._domain = open_participant(self._settings, mark)
        self._refuse_second(finder(self._participant, mark))
        self._open_outlets()
        self._diagnostics = self._outlet(TOPIC, "diagnostic_msgs", "DiagnosticArray", Quality.RELIABLE)
        for name, _, kind, take in self._subscriptions():
            self._subscribe(self._namespace + name, kind, take)
        self._open_leases()
        self._inlets = Inlets(self._participant, self._readers, self._faults.tell)

    def _offer(self, lease: RosLease, name: str) -> None:
        # Services do not cross from one vendor of DDS to another, so a topic arms.
        self._subscribe(name, "Bool", lambda message: lease.ask(message.data))

    def _programs(self, topics: list[str]) -> set[str]:
        names = {f"rt{self._resolve(self._namespace + topic)}" for topic in topics}
        readers = [reader for reader, _ in self._readers if reader.topic.name in names]
        found = (
            reader.get_matched_publication_data(one) for reader in readers for one in reader.get_matched_publications()
        )
        return {str(one.participant_key) for one in found if one is not None}

    def _close(self) -> None:
        if self._inlets is not None:
            self._inlets.close()
        self._finish_outlets()
        self._readers.clear()
        self._inlets = self._participant = self._domain = self._diagnostics = None

    def _resolve(self, name: str) -> str:
        return self._names.resolve(name)

    def _topic(self, name: str, kind: str) -> Any:
        return Topic(self._participant, f"rt{self._resolve(name)}", TYPES[kind].struct)

    def _outlet(
        self,
        name: str,
        package: str,  # noqa: ARG002  (DDS finds a type by its name)
        kind: str,
        quality: Quality,
        *,
        latched: bool = False,
    ) -> DdsOutlet:
        policies = _quality(kind, *(_LATCHED if latched else _PROFILES[quality]))
        return DdsOutlet(self._participant, self._topic(name, kind), policies, self._losses.tell)

    def _subscribe(self, name: str, kind: str, take: Callable[[Any], object]) -> None:
        quality = _quality(kind, *_PROFILES[Quality.RELIABLE], Policy.ResourceLimits(MOST_KEPT, -1, MOST_KEPT))
        self._readers.append((DataReader(self._participant, self._topic(name, kind), qos=quality), take))

    def _tell(self, statuses: list[Status], at: float) -> None:
        if self._diagnostics is not None and self._diagnostics.is_wanted:
            seconds, nanoseconds = divmod(round(at * 1e9), 1_000_000_000)
            stamp = TYPES["Time"].struct(sec=seconds, nanosec=nanoseconds)
            header = TYPES["Header"].struct(stamp=stamp, frame_id="")
            array, *parts = (TYPES[name].struct for name in ("DiagnosticArray", "DiagnosticStatus", "KeyValue"))
            message = array_of(statuses, functools.partial(array, header=header), *parts)
            self._diagnostics.send(np.array([np.void(message.serialize())]))


def _quality(kind: str, *policies: Any) -> Any:
    return Qos(*policies, Policy.Userdata(f"typehash={TYPES[kind].hash};".encode()))


class DdsOutlet(Ros2Outlet):
    """A topic that a participant publishes."""

    def __init__(self, participant: Any, topic: Any, quality: Any, report: Callable[[str], None]) -> None:
        super().__init__(topic.name.removeprefix("rt"), report)
        # It is for all writers that are made from now on.
        _library.dds_write_set_batch(True)  # noqa: FBT003
        self._writer = DataWriter(participant, topic, qos=quality)
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

    def send(self, rows: Rows) -> None:
        """Send as in the base class, and send the packet of the last messages."""
        super().send(rows)
        _library.dds_write_flush(self._writer._ref)  # noqa: SLF001

    def finish(self) -> None:
        """Wait as in the base class, and release the writer."""
        super().finish()
        del self._writer

    def _is_confirmed(self, patience: float) -> bool:
        return int(_library.dds_wait_for_acks(self._writer._ref, round(patience * 1e9))) == 0  # noqa: SLF001
