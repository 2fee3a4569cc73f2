"""Rates of published groups: the base frequency of a gateway that is generated for a spec, and the resulting rates."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.spec.arguments import DIVISOR

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from unity_link.spec.model import GroupSpec

_OWN = 100_000_000
"""Default base frequency of the gateware in mHz, from which divisors in specs count."""
_MOST = (1 << 31) - 1
"""Highest base frequency in mHz: the largest integer of VHDL."""


def base_millihertz(groups: Iterable[GroupSpec], usual: int = _OWN) -> int:
    """Return the base frequency in mHz of a gateway that is generated for groups.

    It is `usual` if that gives all rates exactly. Otherwise it is a frequency that every rate divides, or if none
    exists, one from which a divisor reaches each rate approximately. If a group has a divisor, it is the default of the
    gateware, from which the author has counted.
    """
    published = [group for group in groups if group.number is not None]
    rates = [float(group.rate_hz * 1000) for group in published if group.rate_hz is not None]
    if any(group.divisor is not None for group in published):
        return _OWN
    if not rates:
        return usual
    lowest, highest = math.ceil(max(rates)), math.floor(min(min(rates) * DIVISOR[1], _MOST))
    start = min(max(usual, lowest), highest)
    if not all(rate.is_integer() for rate in rates):
        return start
    common = math.lcm(*(int(rate) for rate in rates))
    if common > highest:
        return start
    if start <= usual and usual % common == 0:
        # Prefer a part of the usual frequency: more of the rates that programs may choose later divide it.
        parts = usual // common
        return usual // next(part for part in range(-(-usual // start), parts + 1) if parts % part == 0)
    return max(start // common, 1) * common


def published_hz(group: GroupSpec, base: int) -> float | None:
    """Return the rate in Hz at which a gateway publishes a group; None if the group is not periodic.

    Args:
        group: the group as declared in the spec.
        base: the gateway's base frequency in mHz.
    """
    if group.number is None or (group.rate_hz is None and group.divisor is None):
        return None
    divisor = group.divisor if group.rate_hz is None else round(base / 1000 / group.rate_hz)
    return base / 1000 / min(max(divisor or 1, 1), DIVISOR[1])


def out_of_reach(group: GroupSpec, groups: Sequence[GroupSpec]) -> str:
    """Return why no gateway can publish a group at its rate beside the other groups; empty if one can."""
    if group.number is None or group.rate_hz is None:
        return ""
    others = [one for one in groups if one.number is not None and one is not group]
    counted = next((one for one in others if one.divisor is not None), None)
    if counted is not None:
        low, high = _OWN / 1000 / DIVISOR[1], _OWN / 1000
        why = f"as {counted.name} has a divisor of {high:g} Hz"
    else:
        rates = [one.rate_hz for one in others if one.rate_hz is not None]
        high = min([_MOST / 1000, *(rate * DIVISOR[1] for rate in rates)])
        low = max([0, *(rate / DIVISOR[1] for rate in rates)])
        why = f"as one base frequency is divided by {DIVISOR[0]} to {DIVISOR[1]}"
    if low <= group.rate_hz <= high:
        return ""
    return (
        f"the group {group.name} has a rate of {group.rate_hz:.12g} Hz, "
        f"and {low:.4g} to {high:.10g} Hz is expected, {why}"
    )
