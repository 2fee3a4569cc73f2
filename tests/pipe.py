"""Two ends of a connection in this process, with buffers and flow control as a socket has them."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from unity_link.virtual.faults import Noise

HIGH, LOW = 65_536, 16_384


class End(asyncio.Transport):
    """What one side writes to, and the other is fed from.

    Args:
        protocol: who writes here, and is told to pause.
        noise: what becomes of the bytes on their way.
    """

    def __init__(self, protocol: asyncio.Protocol, noise: Noise | None) -> None:
        super().__init__()
        self._noise = noise
        self.protocol: asyncio.Protocol = protocol
        self.peer: End
        self._loop = asyncio.get_running_loop()
        self._buffer = bytearray()
        self._high = HIGH
        self._pausing = self._closing = self._planned = False
        self._reading = True

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        self._high = HIGH if high is None else high

    def set_protocol(self, protocol: asyncio.BaseProtocol) -> None:
        assert isinstance(protocol, asyncio.Protocol)
        self.protocol = protocol

    def write(self, data: bytes | bytearray | memoryview) -> None:
        if self._closing:
            return
        data = bytes(data)
        self._buffer += data if self._noise is None else b"".join(self._noise.spoil(data))
        if len(self._buffer) > self._high and not self._pausing:
            self._pausing = True
            self.protocol.pause_writing()
        self._plan()

    def pause_reading(self) -> None:
        self._reading = False

    def resume_reading(self) -> None:
        self._reading = True
        self.peer._plan()

    def is_closing(self) -> bool:
        return self._closing

    def close(self) -> None:
        self.abort()

    def abort(self) -> None:
        for end in (self, self.peer):
            if not end._closing:
                end._closing = True
                self._loop.call_soon(end.protocol.connection_lost, None)

    def _plan(self) -> None:
        if not self._planned and self._buffer:
            self._planned = True
            self._loop.call_soon(self._deliver)

    def _deliver(self) -> None:
        self._planned = False
        if self._closing or not self.peer._reading:
            return
        data = bytes(self._buffer)
        self._buffer.clear()
        if data:
            self.peer.protocol.data_received(data)
        if self._pausing:
            self._pausing = False
            self.protocol.resume_writing()


def connect(
    one: asyncio.Protocol, other: asyncio.Protocol, there: Noise | None = None, back: Noise | None = None
) -> End:
    """Connect two protocols, and give the end of the first."""
    ends = End(one, there), End(other, back)
    ends[0].peer, ends[1].peer = ends[1], ends[0]
    one.connection_made(ends[0])
    other.connection_made(ends[1])
    return ends[0]
