"""The common part of the bridges to ROS 1 and ROS 2: samples to topics, values from topics, and counts."""

from __future__ import annotations

import abc
import asyncio
import functools
import logging
import math
import time
from typing import TYPE_CHECKING, Any, ClassVar

from unity_link.bridges.commands import SignalCommands
from unity_link.bridges.diagnostics import EVERY, Diagnostics, LeaseDiagnostics
from unity_link.bridges.gateway_time import GatewayTime
from unity_link.bridges.log_once import Faults
from unity_link.bridges.presence import Presence
from unity_link.bridges.ros_leases import RosLease
from unity_link.bridges.ros_rows import number_rows, stamped_rows
from unity_link.bridges.ros_trajectories import RosTrajectory, schedule_of
from unity_link.bridges.thread_queue import Carrier
from unity_link.bridges.topic_names import topic_names
from unity_link.bridges.topics import command_topics, joint_command_topics, published_groups, read_namespace
from unity_link.cores import members_of
from unity_link.cores.lease import LeasedRobot, leases_of
from unity_link.cores.schedule import ScheduleVerbs
from unity_link.cores.timeline import ScheduleRegisters
from unity_link.errors import ArgumentError, first_error

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator, Sequence
    from concurrent.futures import Executor

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.merged_writes import Value
    from unity_link.bridges.ros_rows import Rows
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.bridges.topics import JointCommandTopic
    from unity_link.data import Batch, Robot, Writable

BUFFER = 1 << 16
"""Samples of each group that wait while subscribers are slow; after that the oldest are lost and counted."""
LOOKS = 10
"""Between two messages of how the bridge is, whether the gateway is there."""
PATIENCE = 1.0
"""Seconds to wait for a subscriber whose queue is full."""
ENDS_WITHIN = 4.0
"""Seconds for slow subscribers at the end: `ros2 launch` interrupts a node, and terminates the node 5 s later."""


class Outlet(abc.ABC):
    """A topic that is published.

    Args:
        name: full name of the topic.
        report: logs a sentence about slow subscribers.
    """

    def __init__(self, name: str, report: Callable[[str], None]) -> None:
        self.sent = 0
        """Messages that were sent while the topic had a subscriber."""
        self.lost = 0
        """Messages that a subscriber did not take."""
        self.deadline = math.inf
        """Instant of `time.monotonic` until which messages are sent and confirmed."""
        self._name = name
        self._report = report

    @property
    @abc.abstractmethod
    def is_wanted(self) -> bool:
        """Return whether the topic has a subscriber."""

    @abc.abstractmethod
    def send(self, rows: Rows) -> None:
        """Send serialised messages."""

    @abc.abstractmethod
    def finish(self) -> None:
        """Wait until the subscribers have all messages, or until the deadline."""


class RosBridge(abc.ABC):
    """Publishes the samples of a robot, and writes its set points.

    Args:
        robot: a robot of any spec, behind an open link.
        settings: parameters of the bridge; the caller opens the link.
        report: logs a sentence.

    Raises:
        ArgumentError: if the robot has no topics, or for a wrong namespace, frame or time-out.
    """

    _has_cdr: ClassVar[bool]
    """True if messages are serialised as in ROS 2."""

    def __init__(self, robot: Robot, settings: BridgeSettings, report: Callable[[str], None]) -> None:
        if "\0" in settings.frame_id:
            raise ArgumentError("the name of a frame has no zero bytes")
        self._settings = settings
        self._robot, self._link = robot, robot.link
        self._namespace = read_namespace(robot.interface.name if settings.namespace is None else settings.namespace)
        """Prefix of the names of topics, which ROS resolves in the namespace of the node."""
        self._report = report
        self._groups = published_groups(robot, settings.poll_hz)
        self._command_topics = command_topics(robot, self._groups)
        self._joint_command_topics = joint_command_topics(robot, self._groups)
        self._outlets: dict[str, Outlet] = {}
        self._faults = Faults(functools.partial(self._log, level=logging.ERROR))
        self._losses = Faults(functools.partial(self._log, level=logging.WARNING))
        leases = leases_of(robot) if isinstance(robot, LeasedRobot) else {}
        self._ros_leases = [
            RosLease(verbs, path, allowed=settings.allow_arm, timeout=settings.timeout, log=self._log)
            for path, verbs in leases.items()
            if path in robot.interface.leases
        ]
        self._trajectories = list(self._find_trajectories())
        self._commands = SignalCommands(robot.link, self._log, self._check_allowed, self._accept)
        self._time = GatewayTime(robot.link)
        groups = [published.group for published in self._groups]
        self._carrier = Carrier(groups, self._publish, self._losses.tell, buffer=BUFFER)

    @property
    def published(self) -> int:
        """Samples that were published."""
        return self._carrier.carried

    @property
    def lost(self) -> int:
        """Samples that the gateway took and that were not published, and messages that a subscriber did not take."""
        return self._carrier.lost + sum(outlet.lost for outlet in self._outlets.values())

    @property
    def messages(self) -> int:
        """Messages that were sent, of all topics that somebody subscribes to."""
        return sum(outlet.sent for outlet in self._outlets.values())

    @property
    def written(self) -> int:
        """Values that came by topics and were written."""
        return self._commands.written

    @abc.abstractmethod
    async def run(self) -> None:
        """Be the bridge until it is cancelled."""

    # Of each ROS

    def _log(self, text: str, *, level: int = logging.INFO) -> None:  # noqa: ARG002  (nodes of ROS have levels)
        """Log a sentence for people, at a level of `logging`."""
        self._report(text)

    @abc.abstractmethod
    def _resolve(self, name: str) -> str:
        """Return the full name of a topic or a namespace: resolved in the namespace of the node, and remapped."""

    @abc.abstractmethod
    def _open_outlet(self, name: str, package: str, kind: str) -> Outlet:
        """Publish a topic, such as ``j1/cpos`` of ``std_msgs`` and ``Float64``."""

    @abc.abstractmethod
    def _tell(self, statuses: list[Status], at: float) -> None:
        """Publish a ``diagnostic_msgs/DiagnosticArray``, with its instant in seconds since 1970."""

    @abc.abstractmethod
    def _open_lease(self, lease: RosLease, name: str) -> Callable[[bool], None]:
        """Offer ``NAME/arm``, and return what publishes on ``NAME/armed``, which is latched."""

    @abc.abstractmethod
    def _programs(self, topics: list[str]) -> set[str]:
        """Return the names of the programs that publish on some topics that are subscribed to."""

    # Of both

    def _find_trajectories(self) -> Iterator[RosTrajectory]:
        schedules = members_of(self._robot, ScheduleVerbs)
        for topic in self._joint_command_topics:
            schedule = schedule_of(topic.joints) if topic.part is None else None
            if schedule in schedules:
                guard = ScheduleRegisters.of(schedules[schedule]).lease
                lease = next((one for one in self._ros_leases if one.path == guard), None)
                name = topic.name.replace("joint_commands", "joint_trajectory")
                yield RosTrajectory(name, topic.joints, schedules[schedule], lease, self._log)

    def _open_leases(self) -> None:
        names = topic_names(self._robot.interface)
        for lease in self._ros_leases:
            topics = [topic.name for topic in self._command_topics if lease.guards([topic.proxy])]
            for joints in self._joint_command_topics:
                parts = joints.joints.parts
                if lease.guards(one for part, ones in parts.items() if joints.part in {None, part} for one in ones):
                    topics.append(joints.name)
            topics += [one.name for one in self._trajectories if one.is_under(lease)]
            lease.programs = functools.partial(self._programs, topics)
            lease.show = self._open_lease(lease, self._namespace + names[lease.path])

    def _check_allowed(self, proxy: Writable[Any]) -> None:
        for lease in self._ros_leases:
            lease.check_allowed(proxy)

    def _accept(self, values: Sequence[Value]) -> None:
        for lease in self._ros_leases:
            lease.accept(values)

    def _beside(self, publishing: Executor) -> list[Coroutine[Any, Any, None]]:
        """Return the tasks that run beside the publication of samples."""
        return [
            self._commands.run(),
            self._diagnose(publishing),
            self._limit_end_if_cancelled(),
            *(one.run() for one in self._ros_leases + self._trajectories),
        ]

    async def _diagnose(self, publishing: Executor) -> None:
        """Publish how the bridge is, again and again."""
        loop, link = asyncio.get_running_loop(), self._link
        # Robots of one kind have namespaces of their own, and so names.
        name = self._name_at(self._resolve(self._namespace))
        diagnostics, leases = Diagnostics(name, link, link.name), LeaseDiagnostics(name, self._robot, link.name)
        presence = Presence(link, loop.time())
        with first_error():
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(presence.ask())
                while True:
                    away = presence.away_since is not None
                    statuses = [diagnostics.status(self.published, self.lost, self.written, away=away)]
                    statuses += await leases.statuses(away=away or not link.connected)
                    statuses += [one.status(name, link.name) for one in self._trajectories]
                    await asyncio.shield(loop.run_in_executor(publishing, self._tell, statuses, time.time()))
                    for _ in range(LOOKS):
                        await asyncio.sleep(EVERY / LOOKS)
                        presence.look(loop.time(), self._carrier.received, self._carrier.rate_hz)

    def _name_at(self, namespace: str) -> str:
        """Return the name of the bridge at a namespace."""
        return f"unity_link_{namespace.strip('/').replace('/', '_') or self._robot.interface.name}"

    def _subscriptions(self) -> Iterator[tuple[str, str, str, Callable[[Any], None]]]:
        """Return names, packages and types of the topics to subscribe to, and functions that take their messages."""
        for topic in self._command_topics:
            yield topic.name, "std_msgs", topic.type, functools.partial(self._give, topic.proxy)
        for joints in self._joint_command_topics:
            package, kind = ("sensor_msgs", "JointState") if joints.part is None else ("std_msgs", "Float64MultiArray")
            yield joints.name, package, kind, functools.partial(self._give_joints, joints)
        for trajectory in self._trajectories:
            yield trajectory.name, "trajectory_msgs", "JointTrajectory", trajectory.give

    def _give(self, proxy: Writable[Any], message: Any) -> None:
        self._commands.give((proxy, message.data))

    def _give_joints(self, topic: JointCommandTopic, message: Any) -> None:
        joints = topic.joints
        try:
            if topic.part is None:
                commands = joints.of_state(message.name, {part: getattr(message, part) for part in joints.parts})
            else:
                commands = joints.of_array(topic.part, message.data)
        except ArgumentError as error:
            self._faults.tell(f"{topic.name}: {error}")
        else:
            self._commands.give_together(commands)

    def _open_outlets(self) -> None:
        for published in self._groups:
            for topic in published.topics:
                self._outlets[topic.name] = self._open_outlet(topic.name, "std_msgs", topic.type)
            for stamped in published.stamped:
                self._outlets[stamped.name] = self._open_outlet(stamped.name, "sensor_msgs", stamped.kind)

    async def _limit_end_if_cancelled(self) -> None:
        """Limit the time in which the samples that have come are published after the bridge is cancelled."""
        try:
            await asyncio.Event().wait()
        finally:
            self._limit_end()

    def _limit_end(self) -> None:
        deadline = time.monotonic() + ENDS_WITHIN
        for outlet in self._outlets.values():
            outlet.deadline = min(outlet.deadline, deadline)

    def _finish_outlets(self) -> None:
        self._limit_end()
        for outlet in self._outlets.values():
            outlet.finish()

    def _describe_topics(self) -> str:
        published = sum(len(published.topics) for published in self._groups)
        subscribed = len(self._command_topics) + len(self._joint_command_topics)
        return f"{published} topics published, {subscribed} subscribed to at {self._resolve(self._namespace)}"

    def _publish(self, number: int, batch: Batch) -> None:
        published = self._groups[number]
        for topic in published.topics:
            outlet = self._outlets[topic.name]
            if outlet.is_wanted:
                outlet.send(number_rows(topic.type, batch[topic.proxy], cdr=self._has_cdr))
        wanted = [stamped for stamped in published.stamped if self._outlets[stamped.name].is_wanted]
        instants = self._time.instants(number, batch) if wanted else batch.arrived
        for stamped in wanted:
            outlet = self._outlets[stamped.name]
            first = None if self._has_cdr else outlet.sent + 1
            frame = self._settings.frame_id if stamped.frame is None else stamped.frame
            fields = stamped.fields(batch, has_variance=self._has_cdr)
            outlet.send(stamped_rows(instants, fields, frame, first))
