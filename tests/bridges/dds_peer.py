"""A program on ROS 2's topics, independent of the bridge: it makes its types from ROS 2's own definitions.

``dds_peer.py DOMAIN listen TOPIC TYPE COUNT`` prints messages as JSON, ``DOMAIN talk TOPIC TYPE VALUE...`` sends some;
``DOMAIN follow TOPIC TYPE COUNT`` prints one line with the first message and one with message number ``COUNT``, and
``DOMAIN count TOPIC TYPE`` sends 0, 1, 2 and so on until it is killed.
"""

from __future__ import annotations

import dataclasses
import itertools
import json
import sys
import time
from typing import Any

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import make_idl_struct, types
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration
from rosbags.typesys import Stores, get_typestore

DEFINITIONS = get_typestore(Stores.ROS2_JAZZY).fielddefs
LOOPBACK = """
<CycloneDDS><Domain>
<General><Interfaces><NetworkInterface name="lo"/></Interfaces><AllowMulticast>false</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>
"""
RELIABLE = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.History.KeepAll)
_made: dict[str, Any] = {}


def struct_of(name: str) -> Any:
    """Return the class of a message, made from ROS 2's definition of it."""
    if name not in _made:
        _, fields = DEFINITIONS[name]
        package, _, message = name.split("/")
        typename = f"{package}.msg.dds_.{message}_"
        _made[name] = make_idl_struct(
            f"{message}_", typename, {field: type_of(described) for field, described in fields}
        )
    return _made[name]


def type_of(described: Any) -> Any:
    node, detail = described
    if node.name == "NAME":
        return struct_of(detail)
    if node.name == "SEQUENCE":
        return types.sequence[type_of(detail[0])]  # type: ignore[misc]
    base, _ = detail
    return {"string": str, "bool": bool}.get(base) or getattr(types, base)


def plain(value: Any) -> Any:
    if hasattr(value, "__idl__"):
        return {field.name: plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    return [plain(item) for item in value] if isinstance(value, list) else value


def made(name: str, given: dict[str, Any]) -> Any:
    """Return a message with the given fields; other numbers are 0, other sequences empty."""
    _, fields = DEFINITIONS[name]
    return struct_of(name)(**{field: value_of(described, given.get(field)) for field, described in fields})


def value_of(described: Any, given: Any) -> Any:
    node, detail = described
    if node.name == "NAME":
        return made(detail, given or {})
    if given is not None:
        return given
    return [] if node.name == "SEQUENCE" else "" if detail[0] == "string" else 0


def listen(participant: DomainParticipant, topic: str, name: str, count: int) -> None:
    reader = DataReader(participant, Topic(participant, topic, struct_of(name)), qos=RELIABLE)
    seen: list[Any] = []
    deadline = time.monotonic() + 60
    while len(seen) < count and time.monotonic() < deadline:
        seen += [plain(message) for message in reader.take(N=1000) if hasattr(message, "__idl__")]
        time.sleep(0.002)
    print(json.dumps(seen))  # noqa: T201


def talk(participant: DomainParticipant, topic: str, name: str, values: list[str]) -> None:
    struct = struct_of(name)
    writer = DataWriter(participant, Topic(participant, topic, struct), qos=RELIABLE)
    while not writer.get_matched_subscriptions():
        time.sleep(0.01)
    for value in values:
        given = json.loads(value)
        writer.write(made(name, given if isinstance(given, dict) else {"data": given}))
    time.sleep(1)


def follow(participant: DomainParticipant, topic: str, name: str, count: int) -> None:
    reader = DataReader(participant, Topic(participant, topic, struct_of(name)), qos=RELIABLE)
    seen = 0
    while seen < count:
        came = sum(hasattr(message, "__idl__") for message in reader.take(N=1000))
        if came and not seen:
            print("listening", flush=True)  # noqa: T201
        seen += came
        time.sleep(0.002)
    print("enough", flush=True)  # noqa: T201


def count_up(participant: DomainParticipant, topic: str, name: str) -> None:
    struct = struct_of(name)
    writer = DataWriter(participant, Topic(participant, topic, struct), qos=RELIABLE)
    while not writer.get_matched_subscriptions():
        time.sleep(0.01)
    for value in itertools.count():
        writer.write(struct(data=value))
        time.sleep(0.001)


def main() -> None:
    number, what, topic, name, *rest = sys.argv[1:]
    domain = Domain(int(number), LOOPBACK)
    participant = DomainParticipant(int(number))
    if what == "listen":
        listen(participant, topic, name, int(rest[0]))
    elif what == "follow":
        follow(participant, topic, name, int(rest[0]))
    elif what == "count":
        count_up(participant, topic, name)
    else:
        talk(participant, topic, name, rest)
    del domain


if __name__ == "__main__":
    main()
