"""A medium on which both sides share one pair of wires; it detects a host that does not wait for its turn."""

from __future__ import annotations

from typing import TYPE_CHECKING

from support.valve import Valve
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from unity_link.virtual import VirtualGateway

PAIR = GatewayInfo(features=GatewayInfo().features | Feature.HALF_DUPLEX)


class SharedPair(Valve):
    """Records in `collisions` each frame that the host sends while an answer is on its way."""

    def __init__(self, gateway: VirtualGateway) -> None:
        super().__init__(SlowLine(gateway, 100_000))
        self.owed = 0
        self.collisions: list[bytes] = []

    def receive(self, data: bytes, now: float) -> bytes:
        for frame in data.splitlines():
            if self.owed:
                self.collisions.append(frame)
            self.owed += bool(frame)
        return self._count(super().receive(data, now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        return self._count(super().advance(now, room))

    def _count(self, answers: bytes) -> bytes:
        self.owed -= sum(
            not line.startswith(b"P") for line in answers.splitlines(keepends=True) if line.endswith(b"\n")
        )
        return answers
