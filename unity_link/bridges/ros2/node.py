"""The bridge as a participant of DDS."""

from __future__ import annotations

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from unity_link.bridges.carrying import Carrier
from unity_link.bridges.commands import Commands
from unity_link.bridges.gateway_time import GatewayTime
from unity_link.bridges.ros2.settings import Quality, Settings
from unity_link.bridges.telling import Faults
from unity_link.bridges.topics import command_topics, published_groups
from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.ros2.inlets import Inlets
    from unity_link.bridges.ros2.messages import MessageType
    from unity_link.bridges.ros2.outlet import Outlet
    from unity_link.data import Batch, Robot

BUFFER = 1 << 16
"""Samples of each group that wait while readers are slow; after that the oldest are lost and counted."""
MOST_KEPT = 1 << 14
"""Values of a topic that wait for the link; beyond, who writes it waits."""
PATIENCE = 1.0
"""Seconds for which a reliable reader may confirm nothing before messages are lost to it, also at the end."""


class Ros2Bridge:
    """Publishes what a robot publishes, and writes what it is told.

    Args:
        robot: a robot of any spec, behind an open link.
        settings: what was chosen; its link is the caller's affair.
        report: is told in a sentence what a person should know.

    Raises:
        ArgumentError: where the spec publishes nothing and no rate to poll is given.
        ConnectError: where CycloneDDS is not installed.
    """

    def __init__(
        self, robot: Robot, settings: Settings | None = None, *, report: Callable[[str], None] = lambda _: None
    ) -> None:
        self._settings = settings or Settings()
        self._robot = robot
        namespace = self._settings.namespace
        self._namespace = (robot.interface.name if namespace is None else namespace).strip("/")
        self._report = report
        self._groups = published_groups(robot, self._settings.poll_hz)
        self._outlets: dict[str, Outlet] = {}
        self._inlets: Inlets | None = None
        self._faults = Faults(report)
        self._commands = Commands(robot.link, report)
        self._time = GatewayTime()
        self._carrier = Carrier([published.group for published in self._groups], self._publish, report, buffer=BUFFER)
        try:
            import cyclonedds  # noqa: F401  (its absence is told before anything is opened)
        except ImportError:
            raise ConnectError("CycloneDDS is not installed here: pip install 'unity-link[ros2]'") from None

    @property
    def published(self) -> int:
        """Samples that were published."""
        return self._carrier.carried

    @property
    def lost(self) -> int:
        """Samples that the gateway took and that were not published, and messages that a reader did not take."""
        return self._carrier.lost + sum(outlet.lost for outlet in self._outlets.values())

    @property
    def messages(self) -> int:
        """Messages that were sent, of all topics that somebody reads."""
        return sum(outlet.sent for outlet in self._outlets.values())

    @property
    def written(self) -> int:
        """Values that came by topics and were written."""
        return self._commands.written

    async def run(self) -> None:
        """Be the bridge until it is cancelled.

        Raises:
            ConnectError: where DDS cannot be reached, or another bridge has the namespace.
            LinkLostError: where the link ends.
        """
        publishing = ThreadPoolExecutor(1, "ros2-publish")
        loop = asyncio.get_running_loop()
        try:
            subscribed = await loop.run_in_executor(publishing, self._open)
            count = sum(len(published.topics) for published in self._groups)
            self._report(f"{count} topics published, {subscribed} subscribed to at /{self._namespace}")
            await self._carrier.run(publishing, self._commands.run())
        finally:
            await asyncio.shield(loop.run_in_executor(publishing, self._close))
            publishing.shutdown(wait=False)

    # Topics

    def _open(self) -> int:
        """Join the domain; give the number of topics that are subscribed to."""
        from unity_link.bridges.ros2.domain import is_alone, open_participant
        from unity_link.bridges.ros2.inlets import Inlets
        from unity_link.bridges.ros2.messages import JOINT_STATE, STANDARD

        mark = f"unity_link=/{self._namespace};"
        self._participant, self._domain = open_participant(self._settings, mark)
        if not is_alone(self._participant, mark):
            raise ConnectError(
                f"another bridge is at /{self._namespace}, and both would write: "
                "end that one, or choose another namespace"
            )
        for published in self._groups:
            for topic in published.topics:
                self._open_outlet(topic.name, STANDARD[topic.type])
            if published.joints is not None:
                self._open_outlet(published.joints.name, JOINT_STATE)
        topics = command_topics(self._robot, self._groups)
        readers = [(self._reader(topic.name, STANDARD[topic.type]), topic.proxy) for topic in topics]
        self._inlets = Inlets(self._participant, readers, self._commands.give, self._faults.tell)
        return len(readers)

    def _close(self) -> None:
        if self._inlets is not None:
            self._inlets.close()
        deadline = time.monotonic() + PATIENCE
        for outlet in self._outlets.values():
            outlet.finish(deadline)
        self._inlets = self._participant = self._domain = None

    def _topic(self, name: str, message: MessageType) -> Any:
        from cyclonedds.topic import Topic

        return Topic(self._participant, f"rt/{self._namespace}/{name}", message.struct)

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

    def _open_outlet(self, name: str, message: MessageType) -> None:
        from unity_link.bridges.ros2.outlet import Outlet

        quality = self._quality(name, message)
        self._outlets[name] = Outlet(self._participant, self._topic(name, message), quality, self._faults.tell)

    def _reader(self, name: str, message: MessageType) -> Any:
        from cyclonedds.core import Policy
        from cyclonedds.sub import DataReader

        quality = self._quality(name, message, Policy.ResourceLimits(MOST_KEPT, -1, MOST_KEPT))
        return DataReader(self._participant, self._topic(name, message), qos=quality)

    # Samples

    def _publish(self, number: int, batch: Batch) -> None:
        from unity_link.bridges.ros2.rows import joint_rows, number_rows

        published = self._groups[number]
        for topic in published.topics:
            outlet = self._outlets[topic.name]
            if outlet.is_wanted:
                outlet.send(number_rows(topic.type, batch[topic.proxy]))
        joints = published.joints
        if joints is not None and (outlet := self._outlets[joints.name]).is_wanted:
            instants = self._time.instants(number, batch)
            outlet.send(joint_rows(joints.names, instants, joints.columns(batch)))
