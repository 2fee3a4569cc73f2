"""A trajectory of ROS, played by a schedule: each of its points acts in one clock cycle of the gateway."""

from __future__ import annotations

import asyncio
import itertools
import logging
import math
import time
from typing import TYPE_CHECKING, Any

from unity_link.bridges.diagnostics import ERROR, OK, Status
from unity_link.errors import ArgumentError, UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.bridges.commands import Command, LevelledLog
    from unity_link.bridges.ros_leases import RosLease
    from unity_link.bridges.topics import JointCommands
    from unity_link.cores.schedule import ScheduleVerbs
    from unity_link.data import Writable

LEAD = 0.1
"""Seconds from the arrival of a trajectory with the stamp 0 to its start."""
_NANOSECONDS = 1_000_000_000


class RosTrajectory:
    """Plays ``trajectory_msgs/JointTrajectory`` of a group of joints.

    Args:
        name: of the topic.
        joints: whose set points of position are timed by the schedule.
        schedule: plays them.
        lease: that guards the set points; None if none does.
        log: logs a sentence.
    """

    def __init__(
        self, name: str, joints: JointCommands, schedule: ScheduleVerbs, lease: RosLease | None, log: LevelledLog
    ) -> None:
        self.name = name
        self._joints = joints
        self._schedule = schedule
        self._lease = lease
        self._log = log
        self._outcome = OK, "no trajectory has come"
        self._playing: asyncio.Task[None] | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    def is_under(self, lease: RosLease) -> bool:
        """Return whether a lease guards the set points."""
        return self._lease is lease

    def status(self, name: str, hardware: str) -> Status:
        """Return the outcome of the last trajectory."""
        return Status(self._outcome[0], f"{name}: {self.name}", self._outcome[1], hardware, [])

    def give(self, message: Any) -> None:
        """Play a trajectory; to be called from a thread of ROS."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._take, message)

    async def run(self) -> None:
        """Play trajectories from `give`, until it is cancelled."""
        self._loop = asyncio.get_running_loop()
        try:
            await asyncio.Event().wait()
        finally:
            self._loop = None
            if self._playing is not None:
                self._playing.cancel()
                await asyncio.wait([self._playing])

    def _take(self, message: Any) -> None:
        try:
            if not message.points:
                self._stop()
                return
            times, values = self._read(message)
            lead = self._lead(_seconds(message.header.stamp, "header.stamp"))
        except ArgumentError as error:
            self._tell(f"the trajectory is refused: {error}", logging.ERROR)
        else:
            self._tell(f"{len(times)} points are played", logging.INFO)
            self._playing = asyncio.create_task(self._play(times, values, lead))

    def _stop(self) -> None:
        if self._playing is not None:
            self._playing.cancel()
        if self._lease is not None:
            self._lease.disarm_soon()
        self._tell("an empty trajectory has stopped the robot", logging.INFO)

    def _tell(self, text: str, level: int) -> None:
        self._outcome = (ERROR if level >= logging.ERROR else OK), text
        self._log(f"{self.name}: {text}", level=level)

    async def _play(self, times: list[float], values: dict[Writable[Any], list[Any]], lead: float) -> None:
        lease = None if self._lease is None else self._lease.held
        try:
            acted = await self._schedule.play(times, dict(values), lead=lead, lease=lease)
        except UnityLinkError as error:
            self._tell(f"the trajectory has ended: {error}", logging.ERROR)
        else:
            self._tell(f"{acted} points have acted", logging.INFO)
        finally:
            self._playing = None

    def _read(self, message: Any) -> tuple[list[float], dict[Writable[Any], list[Any]]]:
        """Return the times of the points, in seconds from the start, and the values of each signal."""
        if self._playing is not None:
            raise ArgumentError("another one is being played")
        if self._lease is not None:
            self._lease.check_held("it is not played")
        names, points = list(message.joint_names), list(message.points)
        if not names:
            raise ArgumentError("it names no joints")
        times = [_seconds(point.time_from_start, f"time_from_start of point {n}") for n, point in enumerate(points)]
        if times[0] < 0 or any(after <= before for before, after in itertools.pairwise(times)):
            raise ArgumentError("time_from_start of its points does not rise from 0 on")
        values: dict[Writable[Any], list[Any]] = {}
        for number, point in enumerate(points):
            try:
                for proxy, value in self._set_points(names, point):
                    values.setdefault(proxy, []).append(value)
            except ArgumentError as error:
                raise ArgumentError(f"point {number}: {error}") from None
        if short := next((proxy for proxy, column in values.items() if len(column) != len(points)), None):
            raise ArgumentError(f"{short.path} has a value in some points and none in others")
        return times, values

    def _set_points(self, names: list[str], point: Any) -> list[Command]:
        """Return the set points of a point."""
        parts = {"velocity": point.velocities, "effort": point.effort, "position": point.positions}
        # A planner gives the velocities of all joints, also of joints that have no set point of velocity.
        there = {part for part, proxies in self._joints.parts.items() if any(one is not None for one in proxies)}
        parts = {part: values if part in there else () for part, values in parts.items()}
        if len(point.positions) != len(names):
            raise ArgumentError(f"{len(point.positions)} positions were given for {len(names)} joints")
        if any(math.isnan(value) for several in parts.values() for value in several):
            raise ArgumentError("a value is no number")
        found = self._joints.of_state(names, parts)
        for proxy, value in found:
            proxy.encode(value)
        return found

    @staticmethod
    def _lead(start: float) -> float:
        lead = start - time.time() if start else LEAD
        if lead < 0:
            raise ArgumentError(f"its start, header.stamp, was {-lead:.3f} s ago")
        return lead


def _seconds(stamp: Any, what: str) -> float:
    """Return a time or duration of ROS 1 or ROS 2 in seconds.

    Raises:
        ArgumentError: if its nanoseconds are a second or more.
    """
    seconds, nanoseconds = (stamp.sec, stamp.nanosec) if hasattr(stamp, "nanosec") else (stamp.secs, stamp.nsecs)
    if not 0 <= nanoseconds < _NANOSECONDS:
        raise ArgumentError(f"{what} has {nanoseconds} nanoseconds: less than a second was expected")
    return float(seconds + nanoseconds / _NANOSECONDS)


def schedule_of(joints: JointCommands) -> str | None:
    """Return the path of the schedule that times all set points of position of some joints; None if none does."""
    proxies: Sequence[Any] = joints.parts["position"]
    schedules = {None if proxy is None else proxy.signal.timed for proxy in proxies}
    return schedules.pop() if len(schedules) == 1 else None
