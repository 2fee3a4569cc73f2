"""The description of a robot for the page: its signals, their streams, and their possible values."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import msgspec

from unity_link.cores.lease import LeasedRobot, leases_of
from unity_link.data import Writable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Proxy, Robot

WIDEST_EXACT = 53
"""Widest whole number, in bits, that a double, and so the page, represents exactly."""


class SignalStream(msgspec.Struct, frozen=True):
    """Signals that are sampled together."""

    name: str
    rate_hz: float | None
    """Rate in Hz from the spec or the host; None if samples are not periodic."""


class SignalAbout(msgspec.Struct, frozen=True, kw_only=True):
    """One signal."""

    path: str
    name: str
    part: str
    """Path of the component that contains it; empty for the robot itself."""
    id: str
    unit: str
    doc: str
    kind: str
    step: float | None
    """Difference of two neighbouring values; None for floats."""
    low: float | None
    high: float | None
    """Limits of the values that may be written; None for no limit."""
    limited: bool
    """True if the spec gives limits narrower than the range of the bits."""
    names: list[tuple[int, str]]
    """Numbers and names of the values of an enumeration."""
    writable: bool
    stream: int | None
    column: int | None
    """Number of its stream, and its column in that; None for a signal without samples."""


class About(msgspec.Struct, frozen=True, kw_only=True, tag_field="type", tag="about"):
    """All that the page needs before it can show values."""

    robot: str
    doc: str
    gateway: str
    """URL of the gateway, without tokens."""
    writes: bool
    """True if pages with the token may write."""
    parts: dict[str, str]
    """Descriptions of the components by their paths."""
    streams: list[SignalStream]
    signals: list[SignalAbout]
    leases: list[str]
    """Paths of the leases."""


def describe(robot: Robot, groups: Sequence[SampledGroup], rates: Sequence[float | None], gateway: str) -> About:
    """Return the description of a robot whose signals cannot be written."""
    places = {
        proxy: (stream, column)
        for stream, group in enumerate(groups)
        for column, proxy in enumerate(group.group.proxies)
    }
    interface = robot.interface
    return About(
        robot=interface.name,
        doc=interface.doc,
        gateway=gateway.partition("?")[0],
        writes=False,
        parts={part.path: part.doc for part in interface.root.walk()},
        streams=[SignalStream(group.name, rate) for group, rate in zip(groups, rates, strict=True)],
        leases=list(leases_of(robot)) if isinstance(robot, LeasedRobot) else [],
        signals=[_about(proxy, places.get(proxy)) for proxy in robot.signals if proxy in places or is_written(proxy)],
    )


def is_written(proxy: Proxy[object]) -> bool:
    """Return whether the page can write a signal. It cannot write queues, because a value in a queue stays there."""
    return isinstance(proxy, Writable)


def _about(proxy: Proxy[object], place: tuple[int, int] | None) -> SignalAbout:
    signal = proxy.signal
    kind = signal.kind
    part, _, name = signal.path.rpartition(".")
    low, high = signal.limits
    return SignalAbout(
        path=signal.path,
        name=name,
        part=part,
        id=signal.id,
        unit=signal.unit,
        doc=signal.doc,
        kind=kind.name.value,
        step=None if kind.name == "float" else abs(kind.step),
        low=low if math.isfinite(low) else None,
        high=high if math.isfinite(high) else None,
        limited=signal.minimum is not None and signal.maximum is not None,
        names=[(value.value, value.name) for value in kind.enumeration.values] if kind.enumeration else [],
        writable=is_written(proxy),
        stream=None if place is None else place[0],
        column=None if place is None else place[1],
    )
