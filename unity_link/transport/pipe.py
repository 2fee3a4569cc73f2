"""A connection within this process: two ends with a buffer in each direction, and flow control like that of sockets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.transport.buffered import BufferedTransport

if TYPE_CHECKING:
    import asyncio


class PipeEnd(BufferedTransport):
    """One end of a connection; written bytes reach the other end's protocol in the next turn of the event loop."""

    peer: PipeEnd

    def __init__(self, protocol: asyncio.Protocol) -> None:
        super().__init__(protocol)
        self._out = bytearray()
        self._delivery_planned = False

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send bytes to the other end."""
        if self._closing:
            return
        self._out += data
        self._pause_writing_if_full()
        self._plan_delivery()

    def get_write_buffer_size(self) -> int:
        """Return the number of bytes that the other end has not received yet."""
        return len(self._out)

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        """Do nothing: all transports of this package have the same limits."""

    def resume_reading(self) -> None:
        """Deliver received bytes again."""
        self._reading = True
        self.peer._plan_delivery()  # noqa: SLF001  (they are two halves of one thing)

    def close(self) -> None:
        """Close both ends at once, and drop undelivered bytes."""
        self.abort()

    def abort(self) -> None:
        """Close both ends at once, and drop undelivered bytes."""
        self._end()
        self.peer._end()  # noqa: SLF001

    def _end(self) -> None:
        if not self._closing:
            self._closing = True
            self._loop.call_soon(self._protocol.connection_lost, None)

    def _plan_delivery(self) -> None:
        if not self._delivery_planned and self._out:
            self._delivery_planned = True
            self._loop.call_soon(self._deliver)

    def _deliver(self) -> None:
        self._delivery_planned = False
        if self._closing or not self.peer.is_reading() or not self._out:
            return
        data, self._out = bytes(self._out), bytearray()
        self.peer._protocol.data_received(data)  # noqa: SLF001
        self._resume_writing_if_calm()


def connect_pipe(one: PipeEnd, other: PipeEnd) -> None:
    """Connect two ends, and call `connection_made` of their protocols."""
    one.peer, other.peer = other, one
    for end in (one, other):
        end.get_protocol().connection_made(end)
