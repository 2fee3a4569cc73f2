"""An `asyncio` transport to a gateway in this process, as ``sim:`` opens it.

It behaves like a serial port: `write` returns at once, bytes written in one turn of the event loop are processed in the
next turn, and answers arrive in large reads. It has no task. Each turn processes at most `MOST_TAKEN` bytes, in pieces
of `PIECE` bytes, and delivers at most `MOST_DELIVERED` bytes, so that the loop stays responsive. If the protocol pauses
reading, the gateway stops sending and processing requests, and the protocol must pause writing once `HIGH_WATER` bytes
wait; all buffers are therefore bounded.
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
"""Number of undelivered bytes above which samples are lost; a late model clock sends `MOST_BYTES` in one turn."""


class GatewayTransport(BufferedTransport):
    """The transport between a protocol and a gateway, on the running event loop.

    Args:
        gateway: the gateway.
        protocol: receives the bytes.
        at_once: True to call `data_received` before `write` returns if no turn is scheduled, which saves a turn of the
            loop; the protocol must support that.
    """

    def __init__(self, gateway: ClockedGateway, protocol: asyncio.Protocol, *, at_once: bool = False) -> None:
        refusal = lambda: gateway.refusal  # noqa: E731  (read when an access is refused)
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
        """Deliver received bytes again."""
        self._reading = True
        self._plan_turn()

    def get_write_buffer_size(self) -> int:
        """Return the number of bytes that the gateway has not got yet."""
        return len(self._to_gateway)

    def close(self) -> None:
        """Pass all written bytes to the gateway, then close the transport."""
        if not self._closing:
            self._clock.feed(bytes(self._to_gateway))
            self.abort()

    def abort(self) -> None:
        """Close the transport at once, and drop all buffered bytes."""
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
        """Process requests and deliver answers, once each."""
        if self._closing:
            return
        # Calls from here on must not schedule a turn; this is decided below.
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
        """Process requests, and return the answers to deliver."""
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
