"""The bridge as a node of ROS 1."""

from __future__ import annotations

import asyncio
import contextlib
import importlib
import logging
import threading
import time
import xmlrpc.client
from concurrent.futures import ThreadPoolExecutor
from http.client import HTTPException
from typing import TYPE_CHECKING, Any

from unity_link.bridges.diagnostics import TOPIC
from unity_link.bridges.ros import RosBridge
from unity_link.bridges.ros1.environment import choose_address, find_rospy
from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable
    from http.client import HTTPConnection

    from unity_link.bridges.diagnostics import Status
    from unity_link.bridges.ros1.outlet import Ros1Outlet
    from unity_link.bridges.ros_leases import RosLease
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.bridges.topics import CommandTopic, Topic
    from unity_link.data import Robot

LOOK_EVERY = 1.0
"""Seconds between looks whether the master knows the node."""
MOST_LOGGED = 100
"""Length of the queue of /rosout, in messages."""
ANSWERS_WITHIN = 2.0
"""Seconds after which a master that does not answer is away."""
LEAVES_WITHIN = 3.0
"""Limit in seconds for unregistering from the master at the end."""


class Ros1Bridge(RosBridge):
    """A node of ROS 1; arguments and errors are those of `RosBridge`.

    Raises:
        ConnectError: if ROS 1 is not installed.
        ArgumentError: if the master is on another machine, and ROS_IP does not say how this one is reached.
    """

    _has_cdr = False

    def __init__(self, robot: Robot, settings: BridgeSettings, report: Callable[[str], None]) -> None:
        find_rospy()
        choose_address()
        super().__init__(robot, settings, report)
        self._node_name = self._name_at(self._namespace)
        self._publishers: list[Any] = []
        self._services: list[Any] = []
        self._subscribers: list[Any] = []
        self._rosout: Any = None
        self._diagnostics_publisher: Any = None

    async def run(self) -> None:
        """Be the bridge until it is cancelled.

        Raises:
            ConnectError: if ROS ends the node, because another node took its name.
            LinkLostError: if the link ends.
        """
        # ROS cannot be stopped and started again in one process; its threads end with the process.
        loop = asyncio.get_running_loop()
        # What asks the master may wait for long, and must not hold up samples.
        asking, publishing = ThreadPoolExecutor(1, "ros-master"), ThreadPoolExecutor(1, "ros-publish")
        try:
            await self._find_master(asking)
            await loop.run_in_executor(asking, self._start)
            self._log(f"node {self._node_name}: {self._describe_topics()}")
            await self._carrier.run(
                publishing,
                *self._beside(publishing),
                self._stay_registered(asking),
                self._stay_till_shut_down(),
            )
        finally:
            await asyncio.shield(loop.run_in_executor(publishing, self._finish_outlets))
            _leave()
            asking.shutdown(wait=False)
            publishing.shutdown(wait=False)

    # The node

    def _start(self) -> None:
        import rospy

        from unity_link.bridges.ros1.diagnostics import types

        rospy.init_node(self._node_name, disable_signals=True)
        # It may have been given another one on the command line.
        self._node_name = rospy.get_name()
        self._rosout = self._publisher("/rosout", _message("rosgraph_msgs", "Log"), queue_size=MOST_LOGGED)
        self._open_outlets()
        for name, package, kind, take in self._subscriptions():
            subscriber = rospy.Subscriber(self._namespace + name, _message(package, kind), take, tcp_nodelay=True)
            self._subscribers.append(subscriber)
        self._open_leases()
        self._diagnostics_publisher = self._publisher(TOPIC, types()["diagnostic_msgs/DiagnosticArray"], queue_size=10)
        self._describe()

    def _open_outlet(self, name: str, package: str, kind: str) -> Ros1Outlet:
        from unity_link.bridges.ros1.outlet import MOST_WRITES, Ros1Outlet

        publisher = self._publisher(self._namespace + name, _message(package, kind), queue_size=MOST_WRITES)
        return Ros1Outlet(publisher, self._losses.tell)

    def _publisher(self, name: str, kind: Any, **options: Any) -> Any:
        import rospy

        self._publishers.append(rospy.Publisher(name, kind, tcp_nodelay=True, **options))
        return self._publishers[-1]

    def _log(self, text: str, *, level: int = logging.INFO) -> None:
        super()._log(text, level=level)
        if self._rosout is not None:
            # rospy's own functions query the master, and would wait for a master that does not answer.
            message = _message("rosgraph_msgs", "Log")(level=1 << level // 10 - 1, name=self._node_name, msg=text)
            message.header.stamp = type(message.header.stamp).from_sec(time.time())
            self._rosout.publish(message)

    def _resolve(self, name: str) -> str:
        import rospy

        return str(rospy.resolve_name(name))

    def _tell(self, statuses: list[Status], at: float) -> None:
        from unity_link.bridges.ros1.diagnostics import message

        self._diagnostics_publisher.publish(message(statuses, at))

    def _open_lease(self, lease: RosLease, name: str) -> Callable[[bool], None]:
        import rospy

        kind = _message("std_srvs", "SetBool", "srv")
        # rospy makes a response of the tuple.
        service = rospy.Service(f"{name}/arm", kind, lambda request: lease.ask(bool(request.data)))
        self._services.append(service)
        publish: Callable[[bool], None] = self._publisher(
            f"{name}/armed", _message("std_msgs", "Bool"), latch=True, queue_size=10
        ).publish
        return publish

    def _programs(self, topics: list[str]) -> set[str]:
        import rospy

        names = {rospy.resolve_name(self._namespace + topic) for topic in topics}
        subscribers = [one for one in self._subscribers if one.resolved_name in names]
        return {str(connection.endpoint_id) for one in subscribers for connection in list(one.impl.connections)}

    def _describe(self) -> None:
        """Leave units, IDs and descriptions at the parameter server: ``~signals/j1/cpos/unit``."""
        import rospy

        topics: list[Topic | CommandTopic] = [topic for published in self._groups for topic in published.topics]
        topics += self._command_topics
        for topic in topics:
            signal = topic.proxy.signal
            facts = {"unit": signal.unit, "id": signal.id, "description": signal.doc}
            rospy.set_param(f"~signals/{topic.name}", {name: text for name, text in facts.items() if text})

    # The master

    async def _find_master(self, asking: ThreadPoolExecutor) -> None:
        loop = asyncio.get_running_loop()
        told = False
        while not await loop.run_in_executor(asking, _is_online):
            if not told:
                self._log(f"waiting for the ROS master at {_master_uri()}")
            told = True
            await asyncio.sleep(LOOK_EVERY)

    async def _stay_registered(self, asking: ThreadPoolExecutor) -> None:
        loop = asyncio.get_running_loop()
        away = False
        while True:
            await asyncio.sleep(LOOK_EVERY)
            was_away, away = away, not await loop.run_in_executor(asking, _is_online)
            if away and not was_away:
                away_text = f"the ROS master at {_master_uri()} is away: nodes that are connected stay so"
                self._log(away_text, level=logging.WARNING)
            if not away and await loop.run_in_executor(asking, self._register_again):
                self._log("registered with the ROS master again")

    def _register_again(self) -> bool:
        """Register with a master that does not know the node; say whether it was one."""
        import rosgraph
        import rospy
        from rospy.impl.registration import Registration, get_registration_listeners

        try:
            rosgraph.Master(self._node_name).lookupNode(self._node_name)
        except rosgraph.MasterError:
            pass
        except OSError:
            return False
        else:
            return False
        listeners = get_registration_listeners()
        for publisher in self._publishers:
            listeners.notify_added(publisher.resolved_name, publisher.type, Registration.PUB)
        for service in self._services:
            listeners.notify_added(service.resolved_name, service.uri, Registration.SRV)
        for subscriber in self._subscribers:
            listeners.notify_added(subscriber.resolved_name, subscriber.type, Registration.SUB)
        try:
            self._describe()
        except (OSError, rospy.ROSException):
            return False
        return True

    async def _stay_till_shut_down(self) -> None:
        """Raise where ROS ends the node: by `rosnode kill`, or as another one takes its name."""
        import rospy.core

        loop = asyncio.get_running_loop()
        told: asyncio.Future[str] = loop.create_future()

        def end(reason: str) -> None:
            if not told.done():
                told.set_result(reason)

        def tell(reason: str) -> None:
            # The bridge ends the node, too, and with it the loop.
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(end, reason)

        rospy.core.add_preshutdown_hook(tell)
        raise ConnectError(f"ROS ended the node {self._node_name}: {await told}")


def _message(package: str, kind: str, part: str = "msg") -> Any:
    try:
        return getattr(importlib.import_module(f"{package}.{part}"), kind)
    except ImportError:
        advice = f"apt install python3-{package.replace('_', '-')} (Debian), or source the set-up file of your ROS"
        raise ConnectError(f"this robot needs {package} of ROS 1: {advice}") from None


class _Limited(xmlrpc.client.Transport):
    """Queries a master with a time limit of `ANSWERS_WITHIN`, for a stopped process or an absent machine."""

    def make_connection(self, host: Any) -> HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = ANSWERS_WITHIN
        return connection


def _is_online() -> bool:
    try:
        xmlrpc.client.ServerProxy(_master_uri(), transport=_Limited()).getPid("/unity_link")
    except (OSError, HTTPException, xmlrpc.client.Error):
        return False
    return True


def _leave() -> None:
    """End the node and unregister it; give up after `LEAVES_WITHIN`, because rospy sets no limit for the master."""
    import rospy

    leaving = threading.Thread(target=rospy.signal_shutdown, args=("the bridge ends",), daemon=True)
    leaving.start()
    leaving.join(LEAVES_WITHIN)


def _master_uri() -> str:
    import rosgraph

    uri: str = rosgraph.get_master_uri()
    return uri
