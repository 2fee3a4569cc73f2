"""The description of a robot for a Zenoh network: the keys of its signals, and their possible values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.bridges.topic_names import topic_names

if TYPE_CHECKING:
    from unity_link.data import Proxy, Robot


def describe(robot: Robot, prefix: str) -> dict[str, object]:
    """Return the interface, the gateway, and each signal by its path, as values for JSON."""
    names = topic_names(robot.interface)
    return {
        "interface": robot.interface.name,
        "gateway": msgspec.to_builtins(robot.link.gateway),
        "signals": {
            proxy.path: _describe_signal(proxy, f"{prefix}/signals/{names[proxy.path]}") for proxy in robot.signals
        },
    }


def _describe_signal(proxy: Proxy[Any], key: str) -> dict[str, object]:
    signal = proxy.signal
    enumeration = signal.kind.enumeration
    facts = {
        "key": key,
        "id": signal.id,
        "kind": str(signal.kind),
        "access": str(signal.access),
        "unit": signal.unit,
        "description": signal.doc,
        "group": signal.group,
        "values": {value.name: value.value for value in enumeration.values} if enumeration is not None else None,
        "limits": signal.limits if signal.access.writes and enumeration is None else None,
    }
    return {name: fact for name, fact in facts.items() if fact not in ("", None)}
