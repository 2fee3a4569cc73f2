"""The other end of a bridge, in a process of its own: `bridge_peer.py ros1|ros2|zenoh listen|talk SECONDS RATE`.

A listener prints a line when it is ready, counts the messages of one signal until none has arrived for `QUIET` seconds,
and prints the number and the seconds. A talker sends values of another signal at a steady rate, and prints the same.
"""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

QUIET = 2.0
TOPIC_OUT, TOPIC_IN = "bench/value", "bench/target"
PIECES_PER_SECOND = 200


Count = tuple[int, float]
"""Number of messages, and the seconds that they took."""


def listen(count: Callable[[], int]) -> Count:
    """Wait until messages have arrived and stopped; return their number, and the seconds from the first to the last."""
    seen, at, began = 0, time.monotonic(), 0.0
    while not seen or time.monotonic() - at < QUIET:
        time.sleep(0.01)
        if (now := count()) != seen:
            at = time.monotonic()
            began = began if seen else at
            seen = now
    return seen, at - began


def talk(send: Callable[[float], Any], seconds: float, rate: float, flush: Callable[[], Any] = lambda: None) -> Count:
    """Send values at a rate, in bursts; return their number, and the seconds that this took."""
    sent, began = 0, time.monotonic()
    while (elapsed := time.monotonic() - began) < seconds:
        while sent < elapsed * rate:
            send(float(sent))
            sent += 1
        flush()
        time.sleep(1 / PIECES_PER_SECOND)
    return sent, time.monotonic() - began


def ros1(what: str, seconds: float, rate: float) -> Count:
    """Run as a node of rospy."""
    import rospy
    from std_msgs.msg import Float64

    rospy.init_node("peer", anonymous=True, disable_signals=True)
    if what == "listen":
        seen = [0]

        def take(_: Any) -> None:
            seen[0] += 1

        rospy.Subscriber(f"/{TOPIC_OUT}", Float64, take, tcp_nodelay=True)
        ready()
        return listen(lambda: seen[0])
    publisher = rospy.Publisher(f"/{TOPIC_IN}", Float64, tcp_nodelay=True, queue_size=None)
    while not publisher.get_num_connections():
        time.sleep(0.01)
    ready()
    return talk(lambda value: publisher.publish(Float64(value)), seconds, rate)


def ros2(what: str, seconds: float, rate: float) -> Count:
    """Run as a participant of DDS."""
    from cyclonedds.core import Policy, Qos
    from cyclonedds.pub import DataWriter
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
    from cyclonedds.util import duration

    from unity_link.bridges.ros2.domain import open_participant
    from unity_link.bridges.ros2.messages import TYPES
    from unity_link.bridges.ros_settings import BridgeSettings

    participant, domain = open_participant(BridgeSettings())
    struct = TYPES["Float64"].struct
    quality = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.History.KeepAll)
    if what == "listen":
        reader = DataReader(participant, Topic(participant, f"rt/{TOPIC_OUT}", struct), qos=quality)
        seen = 0

        def count() -> int:
            nonlocal seen
            # A sample without a value reports that the writer has left.
            seen += sum(hasattr(one, "data") for one in reader.take(N=10_000))
            return seen

        ready()
        return listen(count)
    writer = DataWriter(participant, Topic(participant, f"rt/{TOPIC_IN}", struct), qos=quality)
    while not writer.get_matched_subscriptions():
        time.sleep(0.01)
    ready()
    said = talk(lambda value: writer.write(struct(value)), seconds, rate)
    time.sleep(QUIET)
    del domain
    return said


def zenoh(what: str, seconds: float, rate: float) -> Count:
    """Run as a peer of Zenoh."""
    import msgspec
    from zenoh import CongestionControl

    from unity_link.transport.zenoh_session import Network, close_session, open_session

    session = open_session(Network())
    seen = [0]

    def take(sample: Any) -> None:
        seen[0] += len(msgspec.json.decode(sample.payload.to_bytes())["sequence"])

    if what == "listen":
        session.declare_subscriber("bench/samples/fast", take)
        ready()
        count = listen(lambda: seen[0])
        close_session(session)
        return count
    piece: list[dict[str, float]] = []
    publisher = session.declare_publisher("bench/write", congestion_control=CongestionControl.BLOCK)

    def flush() -> None:
        publisher.put(msgspec.json.encode(piece))
        piece.clear()

    while not list(session.get("bench/info")):
        time.sleep(0.01)
    ready()
    said = talk(lambda value: piece.append({"target": value}), seconds, rate, flush)

    def written() -> int:
        (number,) = [
            msgspec.json.decode(reply.ok.payload.to_bytes())["written"]
            for reply in session.get("bench/info")
            if reply.ok is not None
        ]
        return int(number)

    listen(written)
    close_session(session)
    return said


def ready() -> None:
    """Report that messages can be sent."""
    print("ready", flush=True)


if __name__ == "__main__":
    kind, way, length, hertz = sys.argv[1:]
    print(*{"ros1": ros1, "ros2": ros2, "zenoh": zenoh}[kind](way, float(length), float(hertz)), flush=True)
