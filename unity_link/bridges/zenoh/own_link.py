"""The bridge's own link: one more client of the shared link, in the same process."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import msgspec

from unity_link.bridges.serve.client import Client
from unity_link.link.link import Link
from unity_link.transport import DriverUrl

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink
    from unity_link.transport import Medium
    from unity_link.transport.stream import Stream

HIGH_WATER = 1 << 18


class OwnLink(Link):
    """A link to a gateway through what shares it.

    Args:
        shared: the link that is shared.
        target: what that is a link to: messages name it.
    """

    def __init__(self, shared: SharedLink, target: DriverUrl | Medium) -> None:
        # A node's number is between the shared link and its gateway alone.
        super().__init__(
            msgspec.structs.replace(target, options={}) if isinstance(target, DriverUrl) else target, reconnect=None
        )
        self._shared = shared

    async def _connect_stream(self, stream: Stream) -> None:
        ends = _End(stream), _End(Client(self._shared))
        for end, other in (ends, ends[::-1]):
            end.peer = other
            end.protocol.connection_made(end)


class _End(asyncio.Transport):
    """What one of two protocols writes to, and is fed from in the next turn of the loop."""

    peer: _End

    def __init__(self, protocol: asyncio.Protocol) -> None:
        super().__init__()
        self.protocol = protocol
        self._loop = asyncio.get_running_loop()
        self._out = bytearray()
        self._planned = self._paused = self._closing = False
        self._reading = True

    def write(self, data: bytes | bytearray | memoryview) -> None:
        if self._closing:
            return
        self._out += data
        if len(self._out) > HIGH_WATER and not self._paused:
            self._paused = True
            self.protocol.pause_writing()
        self._plan()

    def _plan(self) -> None:
        if not self._planned and self._out:
            self._planned = True
            self._loop.call_soon(self._deliver)

    def _deliver(self) -> None:
        self._planned = False
        if self._closing or not self.peer._reading or not self._out:  # noqa: SLF001  (it is one of two halves)
            return
        data, self._out = bytes(self._out), bytearray()
        self.peer.protocol.data_received(data)
        if self._paused:
            self._paused = False
            self.protocol.resume_writing()

    def pause_reading(self) -> None:
        self._reading = False

    def resume_reading(self) -> None:
        self._reading = True
        self.peer._plan()  # noqa: SLF001

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        pass

    def is_closing(self) -> bool:
        return self._closing

    def close(self) -> None:
        self.abort()

    def abort(self) -> None:
        for end in (self, self.peer):
            if not end._closing:  # noqa: SLF001
                end._closing = True  # noqa: SLF001
                self._loop.call_soon(end.protocol.connection_lost, None)
