"""The bridge as a node of ROS 2, by the rclpy of a distribution."""

from __future__ import annotations

import contextlib
import functools
import importlib
import importlib.util
import logging
import os
import threading
from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.bridges.diagnostics import TOPIC, array_of
from unity_link.bridges.ros import PATIENCE
from unity_link.bridges.ros2.arguments import BEGIN, set_parameter
from unity_link.bridges.ros2.node import Ros2Bridge, Ros2Outlet
from unity_link.bridges.ros_settings import Quality
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.ros_leases import RosLease
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.data import Robot

_OF_ROS = {"use_sim_time", "start_type_description_service", "qos_overrides"}
"""Parameters that a node has by itself."""
_FROM_OUTSIDE = {"domain", "network"}
"""Settings that rclpy takes from its environment when the node begins."""


def has_rclpy() -> bool:
    """Return whether this Python has rclpy."""
    return importlib.util.find_spec("rclpy") is not None


@contextlib.contextmanager
def open_node(name: str, words: Sequence[str], domain: int | None, *, network: bool) -> Iterator[Any]:
    """Be a node of ROS 2, which answers in a thread of its own.

    Args:
        name: of the node, unless the words have another one.
        words: arguments for ROS, without ``--ros-args``.
        domain: None for ROS_DOMAIN_ID.
        network: True to speak to other machines; otherwise ROS_AUTOMATIC_DISCOVERY_RANGE decides, or LOCALHOST.

    Raises:
        ArgumentError: if ROS refuses the words, or the name.
    """
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.signals import SignalHandlerOptions

    if network:
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "SUBNET"
    os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    try:
        rclpy.init(args=[BEGIN, *words], domain_id=domain, signal_handler_options=SignalHandlerOptions.NO)
        node = rclpy.create_node(name, automatically_declare_parameters_from_overrides=True)
    except Exception as error:  # noqa: BLE001  (rclpy raises many types, of its own and of Python)
        reason, given = str(error).partition("\n")[0], " ".join(words) or "no arguments"
        raise ArgumentError(f"ROS 2 does not start the node {name} with {given}: {reason}") from None
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    spinning = threading.Thread(target=_spin, args=(executor,), name="ros2-spin", daemon=True)
    spinning.start()
    try:
        yield node
    finally:
        executor.shutdown()
        spinning.join(PATIENCE)
        node.destroy_node()
        rclpy.try_shutdown()


def _spin(executor: Any) -> None:
    from rclpy.executors import ExternalShutdownException, ShutdownException

    with contextlib.suppress(ExternalShutdownException, ShutdownException):
        executor.spin()


def parameters_of(node: Any) -> dict[str, Any]:
    """Return the parameters that a node was given, nested as in a file.

    Raises:
        ArgumentError: for parameters that come too late.
    """
    found: dict[str, Any] = {}
    for name, parameter in node.get_parameters_by_prefix("").items():
        if name.partition(".")[0] not in _OF_ROS:
            set_parameter(found, name, parameter.value)
    for name in _FROM_OUTSIDE & found.keys():
        raise ArgumentError(f"{name} is no parameter of a node of rclpy: --{name} was expected, or ROS's environment")
    return found


def declare(node: Any, settings: BridgeSettings) -> None:
    """Declare the settings that were not given as parameters."""
    from rcl_interfaces.msg import ParameterDescriptor

    for name, value in msgspec.structs.asdict(settings).items():
        if not isinstance(value, dict) and name not in _FROM_OUTSIDE and not node.has_parameter(name):
            descriptor = ParameterDescriptor(read_only=True, dynamic_typing=True)
            node.declare_parameter(name, "" if value is None else value, descriptor)


def log(node: Any, text: str, *, level: int = logging.INFO) -> None:
    """Log a sentence by a node's logger, which demands that each line of a program has one level."""
    logger = node.get_logger()
    if level >= logging.ERROR:
        logger.error(text)
    elif level >= logging.WARNING:
        logger.warning(text)
    else:
        logger.info(text)


class RclpyBridge(Ros2Bridge):
    """A bridge that is a node, of `open_node`."""

    def __init__(self, robot: Robot, settings: BridgeSettings, node: Any) -> None:
        super().__init__(robot, settings, functools.partial(log, node))
        self._node = node
        self._diagnostics: Any = None

    def _log(self, text: str, *, level: int = logging.INFO) -> None:
        log(self._node, text, level=level)

    def _resolve(self, name: str) -> str:
        is_root = not name.strip("/")
        return name or str(self._node.get_namespace()) if is_root else self._node.resolve_topic_name(name.rstrip("/"))

    def _open(self) -> None:
        self._refuse_second(lambda: self._count_publishers() > 0)
        self._open_outlets()
        for name, package, kind, take in self._subscriptions():
            self._node.create_subscription(_type(package, kind), self._namespace + name, take, _reliable())
        self._open_leases()
        self._diagnostics = self._node.create_publisher(_type("diagnostic_msgs", "DiagnosticArray"), TOPIC, 10)

    def _count_publishers(self) -> int:
        """Return how many programs publish the first topic of this bridge."""
        names = [topic.name for published in self._groups for topic in published.topics]
        return int(self._node.count_publishers(self._resolve(self._namespace + names[0]))) if names else 0

    def _close(self) -> None:
        self._finish_outlets()

    def _outlet(self, name: str, package: str, kind: str, quality: Quality, *, latched: bool = False) -> RclpyOutlet:
        from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data

        profile = qos_profile_sensor_data if quality is Quality.SENSOR_DATA else _reliable()
        if latched:
            profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        publisher = self._node.create_publisher(_type(package, kind), name, profile)
        return RclpyOutlet(publisher, self._resolve(name), self._losses.tell)

    def _offer(self, lease: RosLease, name: str) -> None:
        def answer(request: Any, response: Any) -> Any:
            response.success, response.message = lease.ask(request.data)
            return response

        self._node.create_service(_type("std_srvs", "SetBool", "srv"), name, answer)

    def _programs(self, topics: list[str]) -> set[str]:
        found = (self._node.get_publishers_info_by_topic(self._resolve(self._namespace + topic)) for topic in topics)
        # The first bytes of an endpoint's number are those of its participant, which is a process.
        return {f"{one.node_name} ({bytes(one.endpoint_gid[:12]).hex()})" for several in found for one in several}

    def _tell(self, statuses: list[Status], at: float) -> None:
        # A slow discovery may have found the other bridge after this one began.
        if self._count_publishers() > 1:
            self._faults.tell(self._second_bridge())
        array, status, pair = (
            _type("diagnostic_msgs", name) for name in ("DiagnosticArray", "DiagnosticStatus", "KeyValue")
        )
        message = array_of(statuses, array, status, pair, level=lambda level: bytes([level]))
        stamp = message.header.stamp
        stamp.sec, stamp.nanosec = divmod(round(at * 1e9), 1_000_000_000)
        self._diagnostics.publish(message)


class RclpyOutlet(Ros2Outlet):
    """A topic that a node publishes."""

    def __init__(self, publisher: Any, name: str, report: Callable[[str], None]) -> None:
        super().__init__(name, report)
        self._publisher = publisher

    @property
    def is_wanted(self) -> bool:
        """Return whether the topic has a subscriber."""
        return bool(self._publisher.get_subscription_count())

    def _write(self, row: bytes) -> bool:
        try:
            self._publisher.publish(row)
        except RuntimeError:
            return False
        return True

    def _is_confirmed(self, patience: float) -> bool:
        from rclpy.duration import Duration

        return bool(self._publisher.wait_for_all_acked(Duration(seconds=patience)))


def _reliable() -> Any:
    from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy

    return QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)


def _type(package: str, kind: str, part: str = "msg") -> Any:
    return getattr(importlib.import_module(f"{package}.{part}"), kind)
