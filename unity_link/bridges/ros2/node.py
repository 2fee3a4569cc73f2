"""The bridge as a participant of DDS."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from unity_link.bridges.carrying import Carrier
from unity_link.bridges.commands import Commands
from unity_link.bridges.gateway_time import GatewayTime
from unity_link.bridges.ros2.settings import Quality, Settings
from unity_link.bridges.topics import command_topics, published_groups
from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.ros2.messages import MessageType
    from unity_link.bridges.topics import CommandTopic
    from unity_link.data import Batch, Robot

BUFFER = 1 << 16
"""Samples of each group that wait while readers are slow; after that the oldest are lost and counted."""
TAKEN_AT_ONCE = 512
PATIENCE_MS = 1000
"""How long a reliable reader may be silent before samples are lost to all rather than kept for it."""


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
        self.messages = 0
        """Messages that were sent, of all topics that somebody reads."""
        self._commands = Commands(robot.link, report)
        self._time = GatewayTime()
        self._carrier = Carrier([published.group for published in self._groups], self._publish, buffer=BUFFER)
        self._unsent = 0
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
        return self._carrier.lost + self._unsent

    @property
    def written(self) -> int:
        """Values that came by topics and were written."""
        return self._commands.written

    async def run(self) -> None:
        """Be the bridge until it is cancelled.

        Raises:
            ConnectError: where DDS cannot be reached.
            LinkLostError: where the link ends.
        """
        publishing = ThreadPoolExecutor(1, "ros2-publish")
        loop = asyncio.get_running_loop()
        try:
            await loop.run_in_executor(publishing, self._open)
            count = sum(len(published.topics) for published in self._groups)
            self._report(f"{count} topics published, {len(self._readers)} subscribed to at /{self._namespace}")
            await self._carrier.run(publishing, self._commands.run())
        finally:
            # A reader that is gone may hold up one write; a second later that is given up.
            await asyncio.shield(loop.run_in_executor(publishing, self._close))
            publishing.shutdown(wait=False)

    # Topics

    def _open(self) -> None:
        from unity_link.bridges.ros2.domain import open_participant
        from unity_link.bridges.ros2.messages import JOINT_STATE, STANDARD

        self._participant, self._domain = open_participant(self._settings)
        self._writers = {
            topic.name: self._writer(topic.name, STANDARD[topic.type])
            for published in self._groups
            for topic in published.topics
        }
        for published in self._groups:
            if published.joints is not None:
                self._writers[published.joints.name] = self._writer(published.joints.name, JOINT_STATE)
        self._readers = [
            self._reader(topic, STANDARD[topic.type]) for topic in command_topics(self._robot, self._groups)
        ]

    def _close(self) -> None:
        self._readers = []
        self._writers = {}
        self._participant = self._domain = None

    def _topic(self, name: str, message: MessageType) -> Any:
        from cyclonedds.topic import Topic

        return Topic(self._participant, f"rt/{self._namespace}/{name}", message.struct)

    def _quality(self, name: str, message: MessageType) -> Any:
        from cyclonedds.core import Policy, Qos
        from cyclonedds.util import duration

        if self._settings.quality_of(name) is Quality.SENSOR_DATA:
            reliability, history = Policy.Reliability.BestEffort, Policy.History.KeepLast(5)
        else:
            reliability = Policy.Reliability.Reliable(duration(milliseconds=PATIENCE_MS))
            history = Policy.History.KeepAll
        # What differs between the two ends of a topic for no reason is warned of: the rest is as in ROS 2's profiles.
        return Qos(
            reliability, history, Policy.Durability.Volatile, Policy.Userdata(f"typehash={message.hash};".encode())
        )

    def _writer(self, name: str, message: MessageType) -> Any:
        from cyclonedds.pub import DataWriter

        quality = self._quality(name, message)
        return DataWriter(self._participant, self._topic(name, message), qos=quality)

    def _reader(self, topic: CommandTopic, message: MessageType) -> Any:
        from cyclonedds.core import Listener
        from cyclonedds.sub import DataReader

        proxy, give = topic.proxy, self._commands.give

        class Arrival(Listener):
            """Called by a thread of CycloneDDS."""

            def on_data_available(self, reader: Any) -> None:
                while messages := reader.take(N=TAKEN_AT_ONCE):
                    give(*[(proxy, one.data) for one in messages if hasattr(one, "data")])

        quality = self._quality(topic.name, message)
        arrival: Any = Arrival
        return DataReader(self._participant, self._topic(topic.name, message), qos=quality, listener=arrival())

    # Samples

    def _publish(self, number: int, batch: Batch) -> None:
        from unity_link.bridges.ros2.messages import STANDARD

        published = self._groups[number]
        for topic in published.topics:
            struct = STANDARD[topic.type].struct
            self._write(topic.name, (struct(value) for value in batch[topic.proxy].tolist()))
        if published.joints is not None:
            self._publish_joints(number, batch)

    def _publish_joints(self, number: int, batch: Batch) -> None:
        from unity_link.bridges.ros2.messages import joint_state

        joints = self._groups[number].joints
        assert joints is not None
        rows = zip(self._time.instants(number, batch).tolist(), joints.rows(batch), strict=True)
        self._write(joints.name, (joint_state(at, joints.names, *row) for at, row in rows))

    def _write(self, name: str, messages: Any) -> None:
        from cyclonedds.core import DDSException

        writer = self._writers[name]
        if not writer.get_matched_subscriptions():
            return
        write = writer.write
        for message in messages:
            try:
                write(message)
                self.messages += 1
            except DDSException:
                # A reader asked for all and takes nothing.
                self._unsent += 1
