"""A node of rclpy that executes commands from stdin, one JSON object on each line, and answers each with a JSON line.

It runs in an environment of a distribution of ROS 2, which cannot import the other modules of the tests::

    {"do": "listen", "topic": "/scara/j1/cpos", "kind": "std_msgs/Float64", "quality": "sensor_data"}
    {"do": "heard", "topic": "/scara/j1/cpos", "count": 100}

The commands are the methods of `Peer`.
"""

from __future__ import annotations

import importlib
import json
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, qos_profile_sensor_data

if TYPE_CHECKING:
    from collections.abc import Callable

PATIENCE = 60.0
DEPTH = 10_000
QUALITIES: dict[str, Any] = {
    "default": 10,
    "all": QoSProfile(history=HistoryPolicy.KEEP_ALL),
    "sensor_data": qos_profile_sensor_data,
    "latched": QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
}


def type_of(name: str, part: str = "msg") -> Any:
    package, _, message = name.partition("/")
    return getattr(importlib.import_module(f"{package}.{part}"), message)


def plain(value: Any) -> Any:
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if isinstance(value, bytes):
        return value[0]
    if hasattr(value, "tolist"):
        return value.tolist()
    return [plain(item) for item in value] if isinstance(value, (list, tuple)) else value


def made(kind: Any, fields: dict[str, Any]) -> Any:
    message = kind()
    for name, value in fields.items():
        if isinstance(value, dict):
            setattr(message, name, made(type(getattr(message, name)), value))
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            item = kind.get_fields_and_field_types()[name].removeprefix("sequence<").removesuffix(">")
            setattr(message, name, [made(type_of(item), one) for one in value])
        else:
            setattr(message, name, value)
    return message


def wait_until(condition: Callable[[], object]) -> bool:
    deadline = time.monotonic() + PATIENCE
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.005)
    return bool(condition())


class Peer:
    """The node."""

    def __init__(self, name: str) -> None:
        rclpy.init()
        self.node = rclpy.create_node(name)
        self.seen: dict[str, list[Any]] = {}
        self.publishers: dict[str, Any] = {}
        threading.Thread(target=rclpy.spin, args=(self.node,), daemon=True).start()

    def listen(self, topic: str, kind: str, quality: str = "default", seconds: float = 0) -> None:
        """Subscribe to a topic; spend `seconds` on each message."""
        seen = self.seen[topic] = []

        def take(message: Any) -> None:
            seen.append(message)
            if seconds:
                time.sleep(seconds)

        self.node.create_subscription(type_of(kind), topic, take, QUALITIES[quality])

    def heard(self, topic: str, count: int = 1) -> list[Any]:
        """Wait for `count` messages of a subscribed topic; return all that have arrived."""
        wait_until(lambda: len(self.seen[topic]) >= count)
        return [plain(message) for message in list(self.seen[topic])]

    def heard_count(self, topic: str) -> int:
        """Return the number of messages of a topic that have arrived."""
        return len(self.seen[topic])

    def heard_recent(self, topic: str, seconds: float) -> bool:
        """Wait until the header of the last message is at most `seconds` old; return True if it is."""

        def age() -> float:
            stamp = self.seen[topic][-1].header.stamp
            return float(time.time() - stamp.sec - stamp.nanosec * 1e-9)

        return wait_until(lambda: age() < seconds)

    def heard_last(self, topic: str, values: list[Any], field: str = "data") -> bool:
        """Wait until a field of the last message has one of some values; return True if it has."""
        seen = self.seen[topic]
        return wait_until(lambda: seen and plain(getattr(seen[-1], field)) in values)

    def publish(self, topic: str, kind: str, messages: list[dict[str, Any]]) -> int:
        """Publish messages as soon as the topic has a subscriber; return the number of subscribers."""
        if topic not in self.publishers:
            self.publishers[topic] = self.node.create_publisher(type_of(kind), topic, DEPTH)
        publisher = self.publishers[topic]
        wait_until(publisher.get_subscription_count)
        for message in messages:
            publisher.publish(made(type_of(kind), message))
        return int(publisher.get_subscription_count())

    def publish_often(self, topic: str, kind: str, messages: list[dict[str, Any]]) -> None:
        """Publish several times, because a subscriber that matches after the publisher misses the first messages."""
        for _ in range(5):
            self.publish(topic, kind, messages)
            time.sleep(0.1)

    def last(self, topic: str) -> Any:
        """Return the last message of a topic, or None."""
        return plain(self.seen[topic][-1]) if self.seen[topic] else None

    def unpublish(self, topic: str) -> None:
        """Destroy the publisher of a topic."""
        self.node.destroy_publisher(self.publishers.pop(topic))

    def call(self, service: str, kind: str, request: dict[str, Any]) -> Any:
        """Call a service; return its response."""
        found = type_of(kind, "srv")
        client = self.node.create_client(found, service)
        client.wait_for_service(PATIENCE)
        future = client.call_async(made(found.Request, request))
        wait_until(future.done)
        return plain(future.result())

    def graph(self) -> Any:
        """Return the names of nodes, and the topics and services with their types."""
        nodes = [f"{namespace.rstrip('/')}/{name}" for name, namespace in self.node.get_node_names_and_namespaces()]
        topics, services = self.node.get_topic_names_and_types(), self.node.get_service_names_and_types()
        return {"nodes": nodes, "topics": dict(topics), "services": dict(services)}


def main() -> None:
    peer = Peer(sys.argv[1])
    sys.stdout.write(json.dumps("ready") + "\n")
    sys.stdout.flush()
    for line in sys.stdin:
        given = json.loads(line)
        sys.stdout.write(json.dumps(getattr(peer, given.pop("do"))(**given)) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
