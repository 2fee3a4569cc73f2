"""The state of a bridge in terms of ``diagnostic_msgs``: what `RosBridge` publishes on ``/diagnostics``."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from unity_link.link.link import Link

TOPIC = "/diagnostics"
EVERY = 1.0
"""Seconds, as ROS's own programs have it."""
OK, WARN, ERROR = range(3)


class Status(NamedTuple):
    """State at one instant, as the fields of ``diagnostic_msgs/DiagnosticStatus``."""

    level: int
    name: str
    message: str
    hardware_id: str
    values: list[tuple[str, str]]


class Diagnostics:
    """Tells how a link and its bridge are.

    Args:
        name: of the bridge.
        link: what it is on.
        hardware: names the gateway.
    """

    def __init__(self, name: str, link: Link, hardware: str) -> None:
        self._name = name
        self._link = link
        self._hardware = hardware
        self._troubles = 0

    def status(self, published: int, lost: int, written: int, *, away: bool = False) -> Status:
        """Return how it is now.

        Args:
            published: samples.
            lost: samples and messages.
            written: values.
            away: whether the gateway is, though the link is connected.
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
        told = [(key, str(value)) for key, value in values.items()]
        return Status(level, f"{self._name}: link", message, self._hardware, told)
