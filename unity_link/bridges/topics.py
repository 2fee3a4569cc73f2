"""Topics: names, types and groups of a robot's signals in ROS 1 and ROS 2.

A sampled signal is published at its path: ``legs[2].coxa.cpos`` as ``legs_2/coxa/cpos``. A writable one is subscribed
to at its path, or at ``PATH/set`` if the robot publishes the path itself. A group that the spec declares as joints is
also published as ``sensor_msgs/JointState``, in radians and metres (REP 103). If the joints have set points, the topic
``joint_commands`` sets all of them, and topics such as ``position_commands`` those of one kind.
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from unity_link.bridges.commands import check_number
from unity_link.bridges.sampled import sampled_groups
from unity_link.bridges.sensor_topics import sensor_topics
from unity_link.bridges.topic_names import SI, message_type, topic_names
from unity_link.data import Writable
from unity_link.errors import ArgumentError
from unity_link.spec.diagnostics import did_you_mean

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from unity_link.bridges.commands import Command
    from unity_link.bridges.sensor_topics import Field, SensorTopic
    from unity_link.data import Batch, Group, Proxy, Robot
    from unity_link.spec import Joint

_NAMESPACE = re.compile(r"([A-Za-z_]\w*(/[A-Za-z_]\w*)*)?", re.ASCII)


class Topic(NamedTuple):
    """One signal as a topic."""

    name: str
    """Name relative to the namespace of the bridge."""
    type: str
    """Type in ``std_msgs``, such as ``Float64``."""
    proxy: Proxy[Any]


class CommandTopic(NamedTuple):
    """One signal that messages of a topic write; the fields are those of `Topic`."""

    name: str
    type: str
    proxy: Writable[Any]


class VelocitySigns:
    """Signs for velocities of which a gateway only gives the magnitude: the direction of the joint's last move.

    Args:
        joints: numbers of the joints whose velocities are magnitudes; they also have positions.
    """

    def __init__(self, joints: Sequence[int]) -> None:
        self._joints = list(joints)
        self._position: NDArray[np.float64] | None = None
        self._sign = np.ones(len(self._joints))

    def signed(self, positions: NDArray[np.float64], velocities: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return velocities with their signs; both arrays of shape (samples, joints), in the order of sampling."""
        if not self._joints or not len(positions):
            return velocities
        seen = positions[:, self._joints]
        before = seen[0] if self._position is None else self._position
        moves = np.sign(np.diff(seen, axis=0, prepend=before[np.newaxis]))
        signs = np.vstack([self._sign, moves])
        # For a joint that has not moved, use the row of its last move.
        rows = np.maximum.accumulate(np.where(signs != 0, np.arange(len(signs))[:, np.newaxis], 0), axis=0)
        signs = np.take_along_axis(signs, rows, axis=0)
        self._position, self._sign = seen[-1], signs[-1]
        velocities[:, self._joints] *= signs[1:]
        return velocities


class JointTopic(NamedTuple):
    """A group as states of joints."""

    name: str
    names: list[str]
    positions: list[Any]
    velocities: list[Any]
    efforts: list[Any]
    """Signals by joint, None for a joint without one; empty if no joint of the group has such a signal."""
    direction: VelocitySigns

    @property
    def kind(self) -> str:
        """Type in ``sensor_msgs``."""
        return "JointState"

    @property
    def frame(self) -> str | None:
        """None: the frame in the bridge's settings."""
        return None

    def columns(self, batch: Batch) -> dict[str, NDArray[np.float64]]:
        """Return arrays for ``position``, ``velocity`` and ``effort``, in SI units, of shape (samples, joints or 0)."""
        parts = {"position": self.positions, "velocity": self.velocities, "effort": self.efforts}
        columns = {name: _in_si(proxies, batch) for name, proxies in parts.items()}
        columns["velocity"] = self.direction.signed(columns["position"], columns["velocity"])
        return columns

    def fields(self, batch: Batch, **_: bool) -> list[Field]:
        """Return the fields of ``sensor_msgs/JointState`` messages after their header."""
        return joint_fields(self.names, self.columns(batch))


def joint_fields(names: Sequence[str], parts: Mapping[str, NDArray[np.float64]]) -> list[Field]:
    """Return the fields of ``sensor_msgs/JointState`` messages after their header.

    Args:
        names: of the joints.
        parts: position, velocity and effort, in this order, of shape (samples, joints), or (samples, 0) for none.
    """
    arrays = (
        field
        for columns in parts.values()
        for field in (("<u4", columns.shape[1]), (("<f8", columns.shape[1:]), columns))
    )
    return [("<u4", len(names)), *names, *arrays]


class JointCommands(NamedTuple):
    """The set points of all joints of a group, which one message sets in SI units."""

    names: list[str]
    """Names of the joints, as in the topic of their states."""
    parts: dict[str, list[Writable[Any] | None]]
    """Signals by joint for ``velocity``, ``effort`` and ``position``, in the order in which they are written."""

    def of_state(self, names: Sequence[str], values: Mapping[str, Sequence[float]]) -> list[Command]:
        """Return the commands for a ``sensor_msgs/JointState``; a NaN gives no command.

        Args:
            names: names of the joints to set; empty for all.
            values: for each of the `parts`, one value for each name, or none.

        Raises:
            ArgumentError: for unknown joints, joints without such a set point, or a wrong number of values.
        """
        places = [self._place(name) for name in names] if names else list(range(len(self.names)))
        if len(set(places)) != len(places):
            raise ArgumentError(f"a joint is named twice among {', '.join(names)}")
        found: list[Command] = []
        for part, proxies in self.parts.items():
            given = values[part]
            if len(given) not in (0, len(places)):
                raise ArgumentError(f"{len(given)} values of {part} were given for {len(places)} joints")
            for place, value in zip(places, given, strict=False):
                if not math.isnan(value):
                    found.append(_command(proxies[place], value, f"{self.names[place]} has no set point of {part}"))
        return found

    def of_array(self, part: str, values: Sequence[float]) -> list[Command]:
        """Return the commands for a ``std_msgs/Float64MultiArray``: one value for each joint; a NaN gives no command.

        Raises:
            ArgumentError: as `of_state`.
        """
        if len(values) != len(self.names):
            raise ArgumentError(f"{len(values)} values of {part} were given for {len(self.names)} joints")
        return self.of_state((), {name: values if name == part else () for name in self.parts})

    def _place(self, name: str) -> int:
        if name not in self.names:
            hint = did_you_mean(name, self.names) or f"one of {', '.join(self.names)} was expected"
            raise ArgumentError(f"no joint is called {name!r}: {hint}")
        return self.names.index(name)


class JointCommandTopic(NamedTuple):
    """A topic whose messages set joints."""

    name: str
    part: str | None
    """Kind of set points in a ``std_msgs/Float64MultiArray``; None for a ``sensor_msgs/JointState`` with all kinds."""
    joints: JointCommands


class PublishedGroup(NamedTuple):
    """A group whose samples are published."""

    group: Group
    topics: list[Topic]
    joints: JointTopic | None
    sensors: list[SensorTopic]

    @property
    def stamped(self) -> list[JointTopic | SensorTopic]:
        """Topics whose messages have a header with the instant of sampling."""
        return [*([] if self.joints is None else [self.joints]), *self.sensors]


def published_groups(robot: Robot, poll_hz: float | None = None) -> list[PublishedGroup]:
    """Return the published groups of a robot as topics. The list may be empty if the robot has writable signals.

    Raises:
        ArgumentError: if the robot has neither.
    """
    is_needed = not any(isinstance(proxy, Writable) for proxy in robot.signals)
    sampled = sampled_groups(robot, poll_hz, is_needed=is_needed)
    several = sum(group.model is not None and bool(group.model.joints) for _, group in sampled) > 1
    names = topic_names(robot.interface)
    # The bridge itself has a topic of this name.
    armed = {f"{lease}.armed" for lease in robot.interface.leases}
    found = []
    taken = {"joint_states", *names.values()}
    for name, group in sampled:
        topics = [
            Topic(names[proxy.path], message_type(proxy.signal.kind), proxy)
            for proxy in group.proxies
            if proxy.path not in armed
        ]
        joints = group.model.joints if group.model is not None else ()
        topic = f"{name}/joint_states" if several else "joint_states"
        states = _joint_topic(topic, joints, robot, names) if joints else None
        sensors = sensor_topics(() if group.model is None else group.model.sensors, robot, names, taken)
        found.append(PublishedGroup(group, topics, states, sensors))
    return found


def command_topics(robot: Robot, published: list[PublishedGroup]) -> list[CommandTopic]:
    """Return the topics that write a robot's signals; registers of leases and schedules have none."""
    cores = {part.path: part.core for part in robot.interface.cores}
    raw = {path for path, core in cores.items() if core is not None and core.word in {"LEASE", "SCHEDULE"}}
    taken = {topic.name for group in published for topic in group.topics}
    names = topic_names(robot.interface)
    found = []
    for proxy in robot.signals:
        # Words of leases and schedules contain a program's token and instants; for ROS, `RosLease` arms the lease.
        if isinstance(proxy, Writable) and proxy.path.rpartition(".")[0] not in raw:
            name = names[proxy.path]
            full_name = f"{name}/set" if name in taken else name
            found.append(CommandTopic(full_name, message_type(proxy.signal.kind), proxy))
    return found


def joint_command_topics(robot: Robot, published: list[PublishedGroup]) -> list[JointCommandTopic]:
    """Return the topics that set the joints of a group together."""
    found = []
    for group in published:
        joints = group.group.model.joints if group.joints is not None and group.group.model is not None else ()
        parts = {part: _set_points(part, joints, robot) for part in ("velocity", "effort", "position")}
        there = [part for part, proxies in parts.items() if any(proxy is not None for proxy in proxies)]
        if group.joints is not None and there:
            commands = JointCommands(group.joints.names, parts)
            before = group.joints.name.removesuffix("joint_states")
            found.append(JointCommandTopic(f"{before}joint_commands", None, commands))
            found += [JointCommandTopic(f"{before}{part}_commands", part, commands) for part in there]
    return found


def _set_points(part: str, joints: tuple[Joint, ...], robot: Robot) -> list[Writable[Any] | None]:
    paths = [getattr(joint, f"set_{part}") for joint in joints]
    return [None if path is None else cast("Writable[Any]", robot[path]) for path in paths]


def _command(proxy: Writable[Any] | None, value: float, refusal: str) -> Command:
    """Return the command that sets a signal to a value in SI units."""
    if proxy is None:
        raise ArgumentError(refusal)
    check_number(proxy.path, value)
    in_unit = value / SI.get(proxy.unit, 1.0)
    if not math.isfinite(in_unit):
        raise ArgumentError(f"{proxy.path}: {value} is no finite number" + (proxy.unit and f" in {proxy.unit}"))
    return proxy, round(in_unit) if proxy.signal.kind.dtype.kind in "iu" else in_unit


def read_namespace(text: str) -> str:
    """Return a namespace as a prefix of the names of topics: ``arm/``, ``/arm/``, or empty.

    If it does not begin with a slash, ROS resolves the namespace in the namespace of the node.


    Raises:
        ArgumentError: if the text is no namespace of ROS.
    """
    name = text.strip("/")
    root = "/" if text.startswith("/") else ""
    if not _NAMESPACE.fullmatch(name):
        raise ArgumentError(
            f"{text!r} is no namespace of ROS: names of letters, digits and _ were expected, with / between them"
        )
    return f"{root}{name}/" if name else root


def _joint_topic(topic: str, joints: tuple[Joint, ...], robot: Robot, names: Mapping[str, str]) -> JointTopic:
    def proxies(part: str) -> list[Any]:
        paths = [getattr(joint, part) for joint in joints]
        return [None if path is None else robot[path] for path in paths] if any(paths) else []

    positions, velocities = proxies("position"), proxies("velocity")
    magnitudes = [
        place
        for place, (position, velocity) in enumerate(zip(positions, velocities, strict=False))
        if position is not None and velocity is not None and velocity.signal.kind.range[0] >= 0
    ]
    return JointTopic(
        topic,
        [names[joint.name] for joint in joints],
        positions,
        velocities,
        proxies("effort"),
        VelocitySigns(magnitudes),
    )


def _in_si(proxies: list[Any], batch: Batch) -> NDArray[np.float64]:
    missing = np.full(len(batch), np.nan)
    columns = [missing if proxy is None else batch[proxy] * SI.get(proxy.unit, 1.0) for proxy in proxies]
    return np.stack(columns, axis=1).astype(np.float64) if columns else np.empty((len(batch), 0))
