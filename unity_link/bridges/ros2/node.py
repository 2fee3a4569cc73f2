"""The bridge as a participant of DDS."""

from __future__ import annotations

import asyncio
import functools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from unity_link.bridges.diagnostics import TOPIC
from unity_link.bridges.ros import PATIENCE, RosBridge
from unity_link.bridges.ros2.domain import find_dds
from unity_link.bridges.ros2.settings import BridgeSettings, Quality
from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.ros2.inlets import Inlets
    from unity_link.bridges.ros2.messages import MessageType
    from unity_link.bridges.ros2.outlet import Ros2Outlet
    from unity_link.data import Robot

MOST_KEPT = 1 << 14
"""Values of a topic that wait for the link; beyond, who writes it waits."""


class Ros2Bridge(RosBridge["Ros2Outlet"]):
    """Publishes what a robot publishes, and writes what it is told.

    Args:
        robot: a robot of any spec, behind an open link.
        settings: what was chosen; its link is the caller's affair.
        report: is told in a sentence what a person should know.

    Raises:
        ArgumentError: where nothing is published, polled or can be written; for a namespace that ROS does not
            take, or settings of a topic that there is not.
        ConnectError: where CycloneDDS is not installed.
    """

    def __init__(
        self, robot: Robot, settings: BridgeSettings | None = None, *, report: Callable[[str], None] = lambda _: None
    ) -> None:
        self._settings = settings or BridgeSettings()
        find_dds()
        chosen = self._settings
        super().__init__(robot, chosen.namespace, chosen.poll_hz, chosen.frame_id, report)
        self._inlets: Inlets | None = None
        self._diagnostics_outlet: Any = None
        self._check_topics()

    def _check_topics(self) -> None:
        from unity_link.spec.diagnostics import did_you_mean

        known = {topic.name for published in self._groups for topic in published.topics}
        known |= {published.joints.name for published in self._groups if published.joints is not None}
        known |= {topic.name for topic in self._command_topics}
        known |= {topic.name for topic in self._joint_command_topics}
        for name in self._settings.topics.keys() - known:
            hint = did_you_mean(name, known) or "names without the namespace were expected"
            raise ArgumentError(f"the parameters choose a quality for {name!r}, which is no topic here: {hint}")

    async def run(self) -> None:
        """Be the bridge until it is cancelled.

        Raises:
            ConnectError: where DDS cannot be reached, or another bridge has the namespace.
            LinkLostError: where the link ends.
        """
        publishing = ThreadPoolExecutor(1, "ros2-publish")
        loop = asyncio.get_running_loop()
        try:
            await loop.run_in_executor(publishing, self._open)
            self._report(self._describe_topics())
            await self._carrier.run(publishing, self._commands.run(), self._diagnose(publishing))
        finally:
            await asyncio.shield(loop.run_in_executor(publishing, self._close))
            publishing.shutdown(wait=False)

    # Topics

    def _open(self) -> None:
        """Join the domain."""
        from cyclonedds.topic import Topic

        from unity_link.bridges.ros2.domain import is_alone, open_participant
        from unity_link.bridges.ros2.inlets import Inlets
        from unity_link.bridges.ros2.messages import DIAGNOSTICS, FLOAT_ARRAY, JOINT_STATE, STANDARD
        from unity_link.bridges.ros2.outlet import Ros2Outlet

        mark = f"unity_link={self._namespace or '/'};"
        self._participant, self._domain = open_participant(self._settings, mark)
        if not is_alone(self._participant, mark):
            raise ConnectError(
                f"another bridge is at {self._namespace or '/'}, and both would write: "
                "end that one, or choose another namespace"
            )
        self._open_outlets()
        topic = Topic(self._participant, f"rt{TOPIC}", DIAGNOSTICS.struct)
        quality = self._quality(TOPIC, DIAGNOSTICS)
        self._diagnostics_outlet = Ros2Outlet(self._participant, topic, quality, self._faults.tell)
        readers = [(self._reader(topic.name, STANDARD[topic.type]), topic.proxy) for topic in self._command_topics]
        joints = [
            (
                self._reader(topic.name, JOINT_STATE if topic.part is None else FLOAT_ARRAY),
                functools.partial(self._give_joints, topic),
            )
            for topic in self._joint_command_topics
        ]
        self._inlets = Inlets(self._participant, readers, joints, self._commands.give, self._faults.tell)

    def _close(self) -> None:
        if self._inlets is not None:
            self._inlets.close()
        self._finish_outlets()
        self._inlets = self._participant = self._domain = self._diagnostics_outlet = None

    def _topic(self, name: str, message: MessageType) -> Any:
        from cyclonedds.topic import Topic

        return Topic(self._participant, f"rt{self._namespace}/{name}", message.struct)

    def _quality(self, name: str, message: MessageType, *limits: Any) -> Any:
        from cyclonedds.core import Policy, Qos
        from cyclonedds.util import duration

        if self._settings.quality_of(name) is Quality.SENSOR_DATA:
            reliability, history = Policy.Reliability.BestEffort, Policy.History.KeepLast(5)
        else:
            reliability = Policy.Reliability.Reliable(duration(seconds=PATIENCE))
            history = Policy.History.KeepAll
        # What differs between the two ends of a topic for no reason is warned of: the rest is as in ROS 2's profiles.
        return Qos(
            reliability,
            history,
            Policy.Durability.Volatile,
            Policy.Userdata(f"typehash={message.hash};".encode()),
            *limits,
        )

    def _open_outlet(self, name: str, package: str, kind: str) -> Ros2Outlet:
        from unity_link.bridges.ros2.messages import JOINT_STATE, STANDARD
        from unity_link.bridges.ros2.outlet import Ros2Outlet

        message = STANDARD[kind] if package == "std_msgs" else JOINT_STATE
        quality = self._quality(name, message)
        return Ros2Outlet(self._participant, self._topic(name, message), quality, self._faults.tell)

    def _reader(self, name: str, message: MessageType) -> Any:
        from cyclonedds.core import Policy
        from cyclonedds.sub import DataReader

        quality = self._quality(name, message, Policy.ResourceLimits(MOST_KEPT, -1, MOST_KEPT))
        return DataReader(self._participant, self._topic(name, message), qos=quality)

    # Messages

    def _number_rows(self, kind: str, values: NDArray[Any]) -> list[bytes]:
        from unity_link.bridges.ros2.rows import number_rows

        return number_rows(kind, values)

    def _joint_rows(
        self,
        names: list[str],
        instants: NDArray[np.float64],
        columns: dict[str, NDArray[np.float64]],
        first: int,  # noqa: ARG002  (messages of ROS 2 have no numbers)
    ) -> list[bytes]:
        from unity_link.bridges.ros2.rows import joint_rows

        return joint_rows(names, instants, columns, self._frame_id)

    def _tell(self, statuses: list[Status], at: float) -> None:
        from unity_link.bridges.ros2.messages import diagnostics

        if self._diagnostics_outlet.is_wanted:
            self._diagnostics_outlet.send([diagnostics(statuses, at)])
