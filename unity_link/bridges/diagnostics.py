"""The state of a bridge as ``diagnostic_msgs``, which `RosBridge` publishes on ``/diagnostics``."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.cores.lease import LeasedRobot, LeaseRegisters, leases_of
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from unity_link.data import Robot
    from unity_link.link.link import Link

TOPIC = "/diagnostics"
EVERY = 1.0
"""Seconds between two statuses, as in ROS's own programs."""
OK, WARN, ERROR, STALE = range(4)
_OF_LEASES = {"disarmed": WARN, "armed": OK, "fault": ERROR, "finishing": WARN}
"""Levels by the state of a lease."""


class Status(NamedTuple):
    """State at one instant; the fields are those of ``diagnostic_msgs/DiagnosticStatus``."""

    level: int
    name: str
    message: str
    hardware_id: str
    values: list[tuple[str, str]]


def array_of(
    statuses: Sequence[Status], array: Any, status: Any, pair: Any, level: Callable[[int], Any] = lambda level: level
) -> Any:
    """Return a ``DiagnosticArray`` without a stamp.

    Args:
        statuses: statuses in the message.
        array: class of the message.
        status: class of a ``DiagnosticStatus``.
        pair: class of a ``KeyValue``.
        level: converts a level to the message's type.
    """
    fields = (
        {
            **one._asdict(),
            "level": level(one.level),
            "values": [pair(key=key, value=value) for key, value in one.values],
        }
        for one in statuses
    )
    return array(status=[status(**one) for one in fields])


class Diagnostics:
    """Makes the status of a link and its bridge.

    Args:
        name: name of the bridge.
        link: link of the bridge.
        hardware: name of the gateway.
    """

    def __init__(self, name: str, link: Link, hardware: str) -> None:
        self._name = name
        self._link = link
        self._hardware = hardware
        self._troubles = 0

    def status(self, published: int, lost: int, written: int, *, away: bool = False) -> Status:
        """Return the present status.

        Args:
            published: number of samples published.
            lost: number of samples and messages lost.
            written: number of values written.
            away: True if the gateway is away although the link is connected (to a server).
        """
        seen = self._link.statistics
        troubles = lost + seen.repetitions + seen.damaged_frames + seen.errors
        more, self._troubles = troubles - self._troubles, troubles
        if away or not self._link.connected:
            level, message = ERROR, "the gateway is away"
        elif more:
            level, message = WARN, "samples or frames were lost, or the bus refused"
        else:
            level, message = OK, "connected"
        values = {
            "connected": self._link.connected,
            "samples published": published,
            "samples lost": lost,
            "values written": written,
            "round trip (ms)": "" if seen.round_trip is None else f"{1e3 * seen.round_trip:.3f}",
            "requests": seen.requests,
            "requests repeated": seen.repetitions,
            "time-outs": seen.timeouts,
            "frames damaged": seen.damaged_frames,
            "errors of the bus": seen.errors,
            "reconnections": seen.reconnections,
            "bytes sent": seen.bytes_sent,
            "bytes received": seen.bytes_received,
        }
        rows = [(key, str(value)) for key, value in values.items()]
        return Status(level, f"{self._name}: link", message, self._hardware, rows)


class LeaseDiagnostics:
    """Makes the statuses of the leases of a robot, one for each lease.

    Args:
        name: name of the bridge.
        robot: robot with any number of leases.
        hardware: name of the gateway.
    """

    def __init__(self, name: str, robot: Robot, hardware: str) -> None:
        paths = leases_of(robot) if isinstance(robot, LeasedRobot) else ()
        self._leases = [LeaseRegisters(robot, path) for path in paths if path not in robot.interface.misfits]
        self._name = name
        self._hardware = hardware

    async def statuses(self, *, away: bool) -> list[Status]:
        """Read the leases, and return their present statuses; ``STALE`` if the gateway does not answer or is `away`."""
        return await asyncio.gather(*(self._status(lease, away=away) for lease in self._leases))

    async def _status(self, lease: LeaseRegisters, *, away: bool) -> Status:
        level, message, values = STALE, "the gateway is away", dict[str, object]()
        if not away:
            try:
                async with asyncio.timeout(EVERY):
                    level, message, values = await self._read(lease)
            except UnityLinkError as error:
                message = str(error)
            except TimeoutError:
                message = f"no answer came within {EVERY:g} s"
        rows = [(key, str(value)) for key, value in values.items()]
        return Status(level, f"{self._name}: lease {lease.name}", message, self._hardware, rows)

    async def _read(self, lease: LeaseRegisters) -> tuple[int, str, dict[str, object]]:
        condition = await lease.condition()
        values: dict[str, object] = {
            "state": condition.state,
            "reason": condition.reason,
            "e-stop": "open" if condition.estop_open else "closed",
            "leases begun": condition.arms,
        }
        message = condition.state
        if condition.state != "armed":
            fault = await lease.fault(condition)
            message += f": {str(fault).partition(': ')[2]}"
            values["time of the fault (s)"] = "" if fault.instant is None else f"{fault.instant:.6f}"
        return _OF_LEASES.get(condition.state, ERROR), message, values
