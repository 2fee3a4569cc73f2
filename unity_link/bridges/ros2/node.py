"""The common part of the two ways to ROS 2: a node of rclpy, or a participant of DDS."""

from __future__ import annotations

import abc
import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np

from unity_link.bridges.ros import Outlet, RosBridge
from unity_link.bridges.ros_rows import number_rows
from unity_link.bridges.ros_settings import Quality
from unity_link.errors import ArgumentError, ConnectError
from unity_link.spec.diagnostics import did_you_mean

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.ros_leases import RosLease
    from unity_link.bridges.ros_rows import Rows
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.data import Robot

LOOK = 1.0
"""Seconds for the discovery of another bridge at the same namespace."""


class Ros2Outlet(Outlet):
    """A topic that is published: a reader that is stuck holds up no other topic for long."""

    _stuck = False

    @abc.abstractmethod
    def _write(self, row: bytes) -> bool:
        """Write a message; return False if there is no room for it."""

    @abc.abstractmethod
    def _is_confirmed(self, patience: float) -> bool:
        """Return whether the readers have all messages within so many seconds."""

    def send(self, rows: Rows) -> None:
        """Send serialised messages. If a reader is stuck, send none until all readers have the earlier ones."""
        if self._stuck and not self._is_confirmed(0):
            self.lost += len(rows)
            return
        self._stuck = False
        # A slow reader may take each message just in time.
        late = (n for n, row in enumerate(rows) if time.monotonic() > self.deadline or not self._write(row.tobytes()))
        sent = next(late, len(rows))
        self.sent += sent
        if sent < len(rows):
            self._stuck = True
            self.lost += len(rows) - sent
            self._report(f"a reader of {self._name} takes nothing: messages are lost")

    def finish(self) -> None:
        """Wait until the readers have all messages, or until the deadline."""
        if not self._is_confirmed(max(0.0, self.deadline - time.monotonic())):
            self._report(f"a reader of {self._name} has not confirmed all messages: the last ones may be lost")


class Ros2Bridge(RosBridge):
    """A bridge to ROS 2; arguments and errors are those of `RosBridge`. Settings of unknown topics are errors, too."""

    _has_cdr = True

    def __init__(self, robot: Robot, settings: BridgeSettings, report: Callable[[str], None]) -> None:
        super().__init__(robot, settings, report)
        known = {topic.name for published in self._groups for topic in published.topics}
        known |= {stamped.name for published in self._groups for stamped in published.stamped}
        known |= {name for name, *_ in self._subscriptions()}
        for name in settings.topics.keys() - known:
            hint = did_you_mean(name, known) or "names without the namespace were expected"
            raise ArgumentError(f"the parameters choose a quality for {name!r}, which is no topic here: {hint}")

    async def run(self) -> None:
        """Be the bridge until it is cancelled.

        Raises:
            ConnectError: if ROS 2 cannot be reached, or another bridge has the namespace.
            LinkLostError: if the link ends.
        """
        publishing = ThreadPoolExecutor(1, "ros2-publish")
        loop = asyncio.get_running_loop()
        try:
            await loop.run_in_executor(publishing, self._open)
            self._log(self._describe_topics())
            await self._carrier.run(publishing, *self._beside(publishing))
        finally:
            await asyncio.shield(loop.run_in_executor(publishing, self._close))
            publishing.shutdown(wait=False)

    @abc.abstractmethod
    def _open(self) -> None:
        """Open all topics, unless another bridge has the namespace."""

    @abc.abstractmethod
    def _close(self) -> None:
        """Leave ROS 2."""

    @abc.abstractmethod
    def _outlet(self, name: str, package: str, kind: str, quality: Quality, *, latched: bool = False) -> Outlet:
        """Publish a topic by its name in the namespace of the node."""

    @abc.abstractmethod
    def _offer(self, lease: RosLease, name: str) -> None:
        """Let programs arm a lease by a service or a topic of this name."""

    def _open_outlet(self, name: str, package: str, kind: str) -> Outlet:
        return self._outlet(self._namespace + name, package, kind, self._settings.quality_of(name))

    def _open_lease(self, lease: RosLease, name: str) -> Callable[[bool], None]:
        self._offer(lease, f"{name}/arm")
        armed = f"{name}/armed"
        outlet = self._outlets[armed] = self._outlet(armed, "std_msgs", "Bool", Quality.RELIABLE, latched=True)
        return lambda is_armed: outlet.send(number_rows("Bool", np.array([is_armed]), cdr=True))

    def _refuse_second(self, is_there: Callable[[], bool]) -> None:
        """Check for `LOOK` seconds that there is no other bridge.

        Raises:
            ConnectError: if there is one.
        """
        until = time.monotonic() + LOOK
        while time.monotonic() < until:
            if is_there():
                raise ConnectError(self._second_bridge())
            time.sleep(LOOK / 50)

    def _second_bridge(self) -> str:
        namespace = self._resolve(self._namespace)
        return f"another bridge is at {namespace}, and both would write: end that one, or choose another namespace"
