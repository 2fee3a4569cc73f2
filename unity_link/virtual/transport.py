"""A gateway in this process, behind an `asyncio` transport: what ``sim:`` opens.

It behaves as a serial port does: `write` returns at once, what is written in one turn of the loop is looked at in the
next, and answers arrive in whole reads. It has no task. Each turn takes in at most `MOST_TAKEN` bytes, in pieces of
which none has too many answers, and delivers at most `MOST_DELIVERED`, so the loop stays alive. A protocol that pauses
reading stops the gateway from sending, and so from looking at requests, and so, when `HIGH_WATER` bytes wait, is itself
asked to pause writing: no more than that is ever kept.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.window.constants import QUICK_TIMEOUT
from unity_link.transport.buffered import HIGH_WATER, LOW_WATER, BufferedTransport
from unity_link.virtual.model_clock import MOST_BYTES, ModelClock

if TYPE_CHECKING:
    import asyncio

    from unity_link.virtual.model_clock import ClockedGateway

MOST_TAKEN = 16384
PIECE = 2048
MOST_DELIVERED = 65536
MOST_UNDELIVERED = 4 * MOST_BYTES
"""Bytes for the protocol beyond which samples are lost; a clock that is late gives `MOST_BYTES` in one turn."""


class GatewayTransport(BufferedTransport):
    """Pairs a protocol with a gateway on the running loop.

    Args:
        gateway: who answers.
        protocol: who is answered.
        at_once: whether what is written to a gateway at rest is answered before `write` returns, which saves a turn of
            the loop; only for a protocol that expects `data_received` at that time.
    """

    def __init__(self, gateway: ClockedGateway, protocol: asyncio.Protocol, *, at_once: bool = False) -> None:
        refusal = lambda: gateway.refusal  # noqa: E731  (it is asked when an access is refused)
        super().__init__(protocol, {"gateway": gateway, "shortest_timeout": QUICK_TIMEOUT, "refusal": refusal})
        self._clock = ModelClock(gateway, self._collect, self._loop)
        self._to_gateway = bytearray()
        self._to_protocol = bytearray()
        self._turn_planned = False
        self._at_once = at_once

    # asyncio.Transport

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Pass bytes to the gateway."""
        if self._closing:
            return
        self._to_gateway += data
        self._pause_writing_if_full()
        if self._at_once and not self._turn_planned:
            self._turn()
        else:
            self._plan_turn()

    def resume_reading(self) -> None:
        """Deliver again."""
        self._reading = True
        self._plan_turn()

    def get_write_buffer_size(self) -> int:
        """Return how many bytes the gateway has not taken yet."""
        return len(self._to_gateway)

    def close(self) -> None:
        """Pass what was written to the gateway, and end."""
        if not self._closing:
            self._clock.feed(bytes(self._to_gateway))
            self.abort()

    def abort(self) -> None:
        """End at once."""
        if not self._closing:
            self._closing = True
            self._clock.close()
            self._to_gateway.clear()
            self._to_protocol.clear()
            self._loop.call_soon(self._protocol.connection_lost, None)

    # The inside

    def _collect(self, data: bytes) -> None:
        self._to_protocol += data
        if len(self._to_protocol) > MOST_UNDELIVERED:
            self._clock.block()
        if self._to_protocol or self._to_gateway:
            self._plan_turn()

    def _plan_turn(self) -> None:
        if not self._turn_planned and not self._closing:
            self._turn_planned = True
            self._loop.call_soon(self._turn)

    def _turn(self) -> None:
        """Take requests, deliver answers, once each."""
        if self._closing:
            return
        # What happens from here on is looked at below.
        self._turn_planned = True
        try:
            delivered = self._take_and_collect()
        finally:
            self._turn_planned = False
        if self._can_take() or (self._to_protocol and self._reading):
            self._plan_turn()
        if delivered:
            self._protocol.data_received(delivered)

    def _take_and_collect(self) -> bytes:
        """Take requests; return the answers that are to be delivered."""
        for _ in range(MOST_TAKEN // PIECE):
            if not self._can_take():
                break
            piece = bytes(self._to_gateway[:PIECE])
            del self._to_gateway[:PIECE]
            self._clock.feed(piece)
        self._resume_writing_if_calm()
        if not self._reading:
            return b""
        delivered = bytes(self._to_protocol[:MOST_DELIVERED])
        del self._to_protocol[:MOST_DELIVERED]
        if len(self._to_protocol) <= LOW_WATER:
            self._clock.unblock()
        return delivered

    def _can_take(self) -> bool:
        return bool(self._to_gateway) and not self._clock.blocked and self._clock.gateway.waiting < HIGH_WATER
