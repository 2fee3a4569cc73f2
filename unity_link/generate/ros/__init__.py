"""The common part of packages for ROS 1 and ROS 2: a client of a shared link, and a bridge, for Python from 3.8.

- ``client.py``: the connection to `unity-link serve`
- ``values.py``: signals and groups of them, as values
- ``bridge.py``: what is published and subscribed to
- ``robot.py``: tables of the signals and groups of an interface

The nodes, which differ, are those of the targets. Nothing of a package needs Unity-Link, or any other package, in the
Python of a distribution of ROS.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.generate import GeneratedFile
from unity_link.generate.python.classes import module_name
from unity_link.generate.ros.topics import SI, message_type, topic_names
from unity_link.protocol.host.handshake import NEVER_CHOSEN
from unity_link.protocol.wire.configuration import FIELDS, PROTOCOL_VERSION, Feature
from unity_link.protocol.wire.frames import TOKEN_LINE
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.spec import KindName, ParameterReference

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import GroupSpec, Interface, ModuleSpec, Signal

OLDEST_PYTHON = (3, 8)
"""Python of ROS 1 Noetic."""
RUNTIME = ("client.py", "values.py", "bridge.py")
_NETWORKS = ("TOSNET",)
_PARTS = ("position", "velocity", "effort")
_SET_PARTS = ("velocity", "effort", "position")
"""Parts of a joint in the order in which they are written: a speed before the position that it is for."""
_OF_A_LEASE = ("state", "reason", "estop_open", "arms", "fault_time")
"""Signals that tell how a lease is."""


class SampledSignals(NamedTuple):
    """A group that is sampled again and again."""

    name: str
    group: GroupSpec | None
    rate_hz: float | None
    signals: list[Signal]


class Options(NamedTuple):
    """Options of a package that the user chooses."""

    maintainer: str = "Maintainer"
    email: str = "user@example.com"
    licence: str = "BSD-3-Clause"


def package_name(interface: Interface) -> str:
    """Return the name of the package; ROS wants small letters, and one of them first (REP 144)."""
    name = interface.name.lower().strip("_")
    return f"{name if name[:1].isalpha() else f'x{name}'}_unity_link"


def names(interface: Interface, package: Options) -> dict[str, Any]:
    """Return what every template sees."""
    return {
        "package": package_name(interface),
        "interface": interface.name,
        "module": module_name(interface),
        "parameters": [parameter.name for parameter in interface.parameters if parameter.value is None],
        "description": next(iter(interface.doc.splitlines()), "") or f"The robot {interface.name} behind Unity-Link.",
        "maintainer": package.maintainer,
        "email": package.email,
        "licence": package.licence,
    }


def runtime(interface: Interface, templates: Templates, dot: str) -> Iterator[GeneratedFile]:
    """Make the modules beside a node.

    Args:
        interface: whose node it is.
        templates: of the target.
        dot: what stands before the names of modules that they import: a dot in a package.
    """
    own = templates.of("ros", {})
    own.origin = templates.origin
    protocol = {
        "version": PROTOCOL_VERSION,
        "widths": tuple(digits for _, digits in FIELDS),
        "never_chosen": NEVER_CHOSEN,
        "token_line": TOKEN_LINE.decode(),
        "group_flags": {flag.name: flag.value for flag in GroupFlag},
        "has_timestamps": int(Feature.TIMESTAMPS),
    }
    for name in RUNTIME:
        yield GeneratedFile(name, own.render(name, dot=dot, **protocol))
    yield GeneratedFile(
        "robot.py",
        own.render(
            "robot.py",
            dot=dot,
            networks=repr([_control(module) for module in _networks(interface)]),
            data_bits=interface.data_bits,
            lines=list(_table(interface)),
            **names(interface, Options()),
        ),
    )


def _networks(interface: Interface) -> list[ModuleSpec]:
    return [module for module in interface.modules if module.type in _NETWORKS]


def _control(module: ModuleSpec) -> int | str | None:
    """Return the address of a network's control word, or the name of the parameter that is."""
    given = module.arguments.get("CTRL")
    if isinstance(given, ParameterReference):
        return given.name
    return int(given) if isinstance(given, (int, float)) else None


def _network_of(interface: Interface, signal: Signal) -> int | None:
    number = signal.module
    while number is not None:
        module = interface.modules[number]
        if module.type in _NETWORKS:
            return _networks(interface).index(module)
        number = module.parent
    return None


# The tables


def _table(interface: Interface) -> Iterator[str]:
    """Return the lines of the tables."""
    variables = {path: f"S{number}" for number, path in enumerate(interface.signals)}
    names = topic_names(interface)
    for path, signal in interface.signals.items():
        if _has_topics(signal):
            yield f"{variables[path]} = Signal({', '.join(_signal(interface, signal, names[path]))})"
    yield ""
    listed = functools.partial(_listed, variables)
    sampled = list(_sampled(interface))
    several = sum(one.group is not None and bool(one.group.joints) for one in sampled) > 1
    yield "GROUPS = ["
    yield from (f"    {_group(one, variables, names, several=several)}," for one in sampled)
    yield "]"
    taken = {signal.path for one in sampled for signal in one.signals}
    signals = [signal for signal in interface.signals.values() if _has_topics(signal)]
    yield f"REST = {listed([one.path for one in signals if one.access.reads and one.path not in taken])}"
    yield f"WRITABLE = {listed([one.path for one in signals if one.access.writes])}"
    yield "JOINTS = ["
    for one in sampled:
        if one.group is not None and any(
            getattr(joint, f"set_{part}") for joint in one.group.joints for part in _PARTS
        ):
            parts = ", ".join(
                f"{part!r}: {listed([getattr(joint, f'set_{part}') for joint in one.group.joints])}"
                for part in _SET_PARTS
            )
            before = f"{one.name}/" if several else ""
            yield f"    Joints({before!r}, {_joint_names(one.group, names)!r}, {{{parts}}}),"
    yield "]"
    yield "LEASES = ["
    for lease in interface.leases:
        told = {name: interface.signals[f"{lease}.{name}"] for name in _OF_A_LEASE}
        addresses = sorted({address for signal in told.values() for address in signal.addresses})
        group = f"Group(None, 0, None, None, {addresses!r}, {listed([signal.path for signal in told.values()])})"
        yield f"    Lease({lease!r}, {group}, {_numbers(told['state'])!r}, {_numbers(told['reason'])!r}),"
    yield "]"


def _has_topics(signal: Signal) -> bool:
    """Return whether it is published or written: not a queue, nor what a read clears, as who polls would take it."""
    return not signal.access_moves


def _numbers(signal: Signal) -> dict[int, str]:
    """Return the names of an enumeration by their numbers."""
    enumeration = signal.kind.enumeration
    return {} if enumeration is None else {one.value: one.name for one in enumeration.values}


def _listed(variables: dict[str, str], paths: list[str | None]) -> str:
    return f"[{', '.join('None' if path is None else variables[path] for path in paths)}]"


def _signal(interface: Interface, signal: Signal, topic: str) -> Iterator[str]:
    kind = signal.kind
    simple = {KindName.BOOL: "bool", KindName.FLOAT: "float"}.get(kind.name, "signed" if kind.is_signed else "unsigned")
    yield repr(signal.path)
    yield repr(topic)
    yield repr(message_type(kind))
    yield repr(simple)
    yield repr((signal.address, signal.lowest_bit, signal.width, signal.word_bits))
    yield repr((kind.step, kind.offset) if kind.is_scaled else (None, 0))
    yield repr(None if signal.minimum is None and signal.maximum is None else signal.limits).replace(
        "inf", 'float("inf")'
    )
    yield repr(signal.unit)
    yield repr(SI.get(signal.unit, 1.0))
    yield repr(signal.is_field)
    yield repr(_network_of(interface, signal))
    yield repr(signal.laps_of)


def _sampled(interface: Interface) -> Iterator[SampledSignals]:
    """Return the groups that the gateway publishes or the node polls; those that publish a FIFO are left out."""
    queues = {signal.group for signal in interface.signals.values() if signal.fifo}
    published = {signal.group for signal in interface.signals.values() if signal.access.reads} - queues
    for group in interface.groups:
        if group.number is not None and group.name in published:
            signals = [interface.signals[path] for path in group.signals]
            yield SampledSignals(group.name, group, group.rate_hz, signals)
    rates: dict[float, list[Signal]] = {}
    for signal in interface.signals.values():
        if signal.poll_hz is not None and signal.group is None and not signal.fifo:
            rates.setdefault(signal.poll_hz, []).append(signal)
    for rate, signals in rates.items():
        yield SampledSignals(f"poll_{rate:g}_hz".replace(".", "_"), None, rate, signals)


def _group(one: SampledSignals, variables: dict[str, str], names: dict[str, str], *, several: bool) -> str:
    group, listed = one.group, functools.partial(_listed, variables)
    signals = listed([signal.path for signal in one.signals])
    if group is None:
        addresses = sorted({address for signal in one.signals for address in signal.addresses})
        return f"Group(None, 0, None, {one.rate_hz!r}, {addresses!r}, {signals})"
    flags = GroupFlag(0)
    for wanted, flag in (
        (group.divisor is not None or group.rate_hz is not None, GroupFlag.PERIODIC),
        (group.trigger, GroupFlag.TRIGGER),
        (group.immediate, GroupFlag.IMMEDIATE),
        (group.on_change, GroupFlag.ON_CHANGE),
    ):
        flags |= flag if wanted else GroupFlag(0)
    arguments = [repr(group.number), str(int(flags)), repr(group.divisor), repr(group.rate_hz)]
    arguments += [repr(list(group.addresses)), signals]
    if group.joints:
        columns = (
            [getattr(joint, part) for joint in group.joints]
            if any(getattr(joint, part) for joint in group.joints)
            else []
            for part in _PARTS
        )
        arguments.append(f"({_joint_names(group, names)!r}, {', '.join(map(listed, columns))})")
        arguments.append(repr(f"{one.name}/joint_states" if several else "joint_states"))
    return f"Group({', '.join(arguments)})"


def _joint_names(group: GroupSpec, names: dict[str, str]) -> list[str]:
    return [names[joint.name] for joint in group.joints]
