"""The line that nodes share in a world: what is sent on it is lost, damaged and doubled as the plan has it."""

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
        gateways: by the numbers of their nodes.
        baud: of the line.
        network: whose courses spoil what is sent.
    """

    def __init__(self, gateways: Mapping[int, Gateway], baud: int, network: Network) -> None:
        super().__init__(gateways, baud)
        self._network = network
        self.on_collision = lambda text: network.trace.append((network.loop.time(), WIRE, "collision", text))

    @property
    def was_disturbed(self) -> bool:
        """Return whether something has happened to what was sent."""
        return any(self._network.courses[WIRE, back].fired for back in (False, True))

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes as the host; return what has arrived from the nodes."""
        return super().receive(self._carry(data, now, back=False), now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass, and return what has arrived."""
        return self._carry(super().advance(now, room), now, back=True)

    def _carry(self, data: bytes, now: float, *, back: bool) -> bytes:
        arrived, _, _ = self._network.courses[WIRE, back].carry(data, now)
        return arrived
