"""Groups with periodic samples, which bridges carry to other programs."""

from __future__ import annotations

from typing import NamedTuple

from unity_link.data import Group, Robot
from unity_link.errors import ArgumentError


class SampledGroup(NamedTuple):
    """A group that is sampled repeatedly."""

    name: str
    """Name in the spec; or ``poll_10_hz`` for signals with POLL, or ``rest`` for other polled signals."""
    group: Group


def sampled_groups(robot: Robot, poll_hz: float | None = None, *, is_needed: bool = True) -> list[SampledGroup]:
    """Return the groups of a robot that the gateway publishes or the host polls, in the order of the spec.

    Args:
        robot: a robot of any spec.
        poll_hz: rate at which all other readable registers are polled, too; None not to poll them.
        is_needed: False if an empty list is allowed.

    Raises:
        ArgumentError: if there is no group, and one is needed.
    """
    from unity_link.data.blocking import View

    given: object = robot
    if isinstance(given, View):
        raise ArgumentError(
            "a robot on a blocking link was given: bridges and recorders need one on a link of `unity_link.connect`"
        )
    if not isinstance(robot, Robot):
        raise ArgumentError(f"a robot was expected, as `Scara(link)` of a loaded spec, not {robot!r:.80}")
    found: dict[str, Group] = {}
    rest = []
    for proxy in robot.signals:
        if not proxy.signal.access.reads:
            continue
        group = robot.publishing_group(proxy)
        if group is None and proxy.signal.read_takes:
            continue
        if group is None:
            rest.append(proxy)
        elif group.model is not None:
            found[group.model.name] = group
        else:
            found[f"poll_{proxy.signal.poll_hz:g}_hz".replace(".", "_")] = group
    if poll_hz is not None and rest:
        found["rest"] = Group.polled(poll_hz, rest)
    if is_needed and not found:
        raise ArgumentError(
            f"nothing says when signals of {robot.interface.name} are to be sampled: give PUBLISH or POLL in the spec, "
            "or a rate to poll all of them"
        )
    return [SampledGroup(name, group) for name, group in found.items()]
