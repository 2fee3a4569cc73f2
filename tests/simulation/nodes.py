"""The line that nodes share in a scenario: bytes on it are lost, damaged and duplicated as planned."""

from __future__ import annotations

from typing import TYPE_CHECKING

from simulation.plan import WIRE
from unity_link.virtual.shared_line import SharedLine

if TYPE_CHECKING:
    from collections.abc import Mapping

    from simulation.medium import Network
    from unity_link.virtual.gateway import Gateway


class Wire(SharedLine):
    """A line with gateways on it.

    Args:
        gateways: the gateways by their node numbers.
        baud: bit rate of the line.
        network: network whose courses apply the faults.
    """

    def __init__(self, gateways: Mapping[int, Gateway], baud: int, network: Network) -> None:
        super().__init__(gateways, baud)
        self._network = network
        self.on_collision = lambda text: network.trace.append((network.loop.time(), WIRE, "collision", text))

    @property
    def was_disturbed(self) -> bool:
        """Return true if a fault has affected any bytes."""
        return any(self._network.courses[WIRE, back].fired for back in (False, True))

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes as the host; return the bytes that have arrived from the nodes."""
        return super().receive(self._carry(data, now, back=False), now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass, and return the bytes that have arrived."""
        return self._carry(super().advance(now, room), now, back=True)

    def _carry(self, data: bytes, now: float, *, back: bool) -> bytes:
        arrived, _, _ = self._network.courses[WIRE, back].carry(data, now)
        return arrived
