"""The common part of the two ways to ROS 2: a node of rclpy, or a participant of DDS."""

from __future__ import annotations

import abc
import asyncio
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from unity_link.bridges.ros import RosBridge
from unity_link.bridges.ros2.outlet import Ros2Outlet
from unity_link.bridges.ros2.rows import joint_rows, number_rows
from unity_link.errors import ArgumentError
from unity_link.spec.diagnostics import did_you_mean

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.bridges.ros2.settings import BridgeSettings
    from unity_link.data import Robot


class Ros2Bridge(RosBridge[Ros2Outlet]):
    """Publishes the samples of a robot, and writes its set points.

    Args:
        robot: a robot of any spec, behind an open link.
        settings: parameters of the bridge; the caller opens the link.
        report: logs a sentence.

    Raises:
        ArgumentError: if the robot has no topics, or for a wrong namespace or settings of an unknown topic.
    """

    def __init__(self, robot: Robot, settings: BridgeSettings, report: Callable[[str], None]) -> None:
        self._settings = settings
        arming: dict[str, Any] = {"allow_arm": settings.allow_arm, "timeout": settings.timeout}
        super().__init__(robot, settings.namespace, settings.poll_hz, settings.frame_id, report, **arming)
        self._check_topics()

    def _check_topics(self) -> None:
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
            ConnectError: where ROS 2 cannot be reached, or another bridge has the namespace.
            LinkLostError: where the link ends.
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

    def _second_bridge(self) -> str:
        namespace = self._resolve(self._namespace)
        return f"another bridge is at {namespace}, and both would write: end that one, or choose another namespace"

    def _number_rows(self, kind: str, values: NDArray[Any]) -> list[bytes]:
        return number_rows(kind, values)

    def _joint_rows(
        self,
        names: list[str],
        instants: NDArray[np.float64],
        columns: dict[str, NDArray[np.float64]],
        first: int,  # noqa: ARG002  (messages of ROS 2 have no numbers)
    ) -> list[bytes]:
        return joint_rows(names, instants, columns, self._frame_id)
