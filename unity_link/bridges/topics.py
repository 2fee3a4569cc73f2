"""Topics: how the signals of a robot are named, typed and grouped in ROS, 1 and 2 alike.

A signal that is sampled is published at its path, ``legs[2].coxa.cpos`` as ``legs_2/coxa/cpos``; one that can be
written is subscribed to at its path, or, where that is taken by what it publishes itself, at ``PATH/set``. A group that
the spec declares as joints is a ``sensor_msgs/JointState`` besides, in radians and metres (REP 103).
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.bridges.sampled import sampled_groups
from unity_link.data import Writable
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

    from unity_link.data import Batch, Group, Proxy, Robot
    from unity_link.spec import Joint, Kind

_TYPES = {
    "b1": "Bool",
    **{f"u{size}": f"UInt{8 * size}" for size in (1, 2, 4, 8)},
    **{f"i{size}": f"Int{8 * size}" for size in (1, 2, 4, 8)},
    "f2": "Float32",
    "f4": "Float32",
    "f8": "Float64",
}
_SI = {"deg": math.pi / 180, "deg/s": math.pi / 180, "mm": 1e-3, "mm/s": 1e-3, "cm": 1e-2, "cm/s": 1e-2, "Nmm": 1e-3}
"""Factors to what REP 103 asks for; every other unit is taken as it is."""

_NAMESPACE = re.compile(r"([A-Za-z_]\w*(/[A-Za-z_]\w*)*)?", re.ASCII)


class Topic(NamedTuple):
    """One signal as a topic."""

    name: str
    """Relative to the namespace of the bridge."""
    type: str
    """Of ``std_msgs``: ``Float64``."""
    proxy: Proxy[Any]


class CommandTopic(NamedTuple):
    """One signal that is written by a topic; the fields are those of `Topic`."""

    name: str
    type: str
    proxy: Writable[Any]


class Direction:
    """The signs of velocities of which a gateway gives the magnitude: each has that of the last move of its joint.

    Args:
        joints: which ones' velocities are magnitudes, as numbers without a sign are; they have positions.
    """

    def __init__(self, joints: Sequence[int]) -> None:
        self._joints = list(joints)
        self._position: NDArray[np.float64] | None = None
        self._sign = np.ones(len(self._joints))

    def signed(self, positions: NDArray[np.float64], velocities: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the velocities of samples with their signs; of shape (samples, joints), in the order of sampling."""
        if not self._joints or not len(positions):
            return velocities
        seen = positions[:, self._joints]
        before = seen[0] if self._position is None else self._position
        moves = np.sign(np.diff(seen, axis=0, prepend=before[np.newaxis]))
        signs = np.vstack([self._sign, moves])
        # Where a joint has not moved, the row of its last move.
        rows = np.maximum.accumulate(np.where(signs != 0, np.arange(len(signs))[:, np.newaxis], 0), axis=0)
        signs = np.take_along_axis(signs, rows, axis=0)
        self._position, self._sign = seen[-1], signs[-1]
        velocities[:, self._joints] *= signs[1:]
        return velocities


class JointTopic(NamedTuple):
    """A group as the states of joints."""

    name: str
    names: list[str]
    positions: list[Any]
    velocities: list[Any]
    efforts: list[Any]
    """Columns by joint; empty where no joint of the group has such a signal."""
    direction: Direction

    def rows(self, batch: Batch) -> Iterator[tuple[list[float], list[float], list[float]]]:
        """Return positions, velocities and efforts of each sample, in SI units; NaN where a joint has none."""
        return zip(*(column.tolist() for column in self.columns(batch).values()), strict=True)

    def columns(self, batch: Batch) -> dict[str, NDArray[np.float64]]:
        """Return the same as arrays by ``position``, ``velocity`` and ``effort``, of shape (samples, joints or 0)."""
        parts = {"position": self.positions, "velocity": self.velocities, "effort": self.efforts}
        columns = {name: _in_si(proxies, batch) for name, proxies in parts.items()}
        columns["velocity"] = self.direction.signed(columns["position"], columns["velocity"])
        return columns


class PublishedGroup(NamedTuple):
    """A group that is published."""

    group: Group
    topics: list[Topic]
    joints: JointTopic | None


def published_groups(robot: Robot, poll_hz: float | None = None) -> list[PublishedGroup]:
    """Return what a robot publishes, as topics.

    Raises:
        ArgumentError: where there is nothing.
    """
    sampled = sampled_groups(robot, poll_hz)
    several = sum(group.model is not None and bool(group.model.joints) for _, group in sampled) > 1
    found = []
    for name, group in sampled:
        topics = [Topic(topic_name(proxy.path), message_type(proxy.signal.kind), proxy) for proxy in group.proxies]
        joints = group.model.joints if group.model is not None else ()
        topic = f"{name}/joint_states" if several else "joint_states"
        found.append(PublishedGroup(group, topics, _joint_topic(topic, joints, robot) if joints else None))
    return found


def command_topics(robot: Robot, published: list[PublishedGroup]) -> list[CommandTopic]:
    """Return the topics by which a robot's signals are written."""
    taken = {topic.name for group in published for topic in group.topics}
    found = []
    for proxy in robot.signals:
        if isinstance(proxy, Writable):
            name = topic_name(proxy.path)
            full_name = f"{name}/set" if name in taken else name
            found.append(CommandTopic(full_name, message_type(proxy.signal.kind), proxy))
    return found


def read_namespace(text: str) -> str:
    """Return a namespace as it stands before names that begin with a slash: ``/arm``, or nothing.

    Raises:
        ArgumentError: where it is none that ROS takes.
    """
    name = text.strip("/")
    if not _NAMESPACE.fullmatch(name):
        raise ArgumentError(
            f"{text!r} is no namespace of ROS: names of letters, digits and _ were expected, with / between them"
        )
    return f"/{name}" if name else ""


def topic_name(path: str) -> str:
    """Write a path as ROS writes names: ``legs[2].coxa`` as ``legs_2/coxa``."""
    return re.sub(r"\[(\d+)\]", r"_\1", path).replace(".", "/")


def message_type(kind: Kind) -> str:
    """Return the type of ``std_msgs`` that holds every value of a kind; enumerations are their numbers."""
    return _TYPES[f"{kind.dtype.kind}{kind.dtype.itemsize}"]


def _joint_topic(name: str, joints: tuple[Joint, ...], robot: Robot) -> JointTopic:
    def proxies(part: str) -> list[Any]:
        paths = [getattr(joint, part) for joint in joints]
        return [None if path is None else robot[path] for path in paths] if any(paths) else []

    names = [topic_name(joint.name) for joint in joints]
    positions, velocities = proxies("position"), proxies("velocity")
    magnitudes = [
        place
        for place, (position, velocity) in enumerate(zip(positions, velocities, strict=False))
        if position is not None and velocity is not None and velocity.signal.kind.range[0] >= 0
    ]
    return JointTopic(name, names, positions, velocities, proxies("effort"), Direction(magnitudes))


def _in_si(proxies: list[Any], batch: Batch) -> NDArray[np.float64]:
    missing = np.full(len(batch), np.nan)
    columns = [missing if proxy is None else batch[proxy] * _SI.get(proxy.unit, 1.0) for proxy in proxies]
    return np.stack(columns, axis=1).astype(np.float64) if columns else np.empty((len(batch), 0))
