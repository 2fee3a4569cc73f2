"""A transport of a medium with a file descriptor, where no event loop is."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Protocol

from unity_link.errors import ConnectError
from unity_link.link.polling import POLLIN, POLLOUT
from unity_link.transport.buffered import HIGH_WATER, LOW_WATER

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.transport.channel import Channel


class Watcher(Protocol):
    """What polls."""

    def call_soon(self, function: Callable[[], object], /) -> object:
        """Call a function when what runs now waits."""

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler where a file descriptor is ready."""

    def unwatch(self, descriptor: int) -> None:
        """Call no handler any more."""


class ChannelTransport(asyncio.Transport):
    """Writes at once what the channel takes, and the rest when it takes more.

    Args:
        watcher: polls the channel.
        channel: is closed with the transport.
        protocol: takes what arrives.
    """

    def __init__(self, watcher: Watcher, channel: Channel, protocol: asyncio.Protocol) -> None:
        super().__init__({"shortest_timeout": channel.shortest_timeout})
        self._watcher = watcher
        self._channel = channel
        self._put = channel.write
        self._protocol = protocol
        self._descriptor = channel.fileno()
        self._unwritten = bytearray()
        self._paused = self._closing = False
        watcher.watch(self._descriptor, POLLIN, self._on_ready)
        protocol.connection_made(self)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send bytes."""
        if self._closing:
            return
        if not self._unwritten:
            written = self._write(data)
            if written == len(data):
                return
            data = data[written:]
            self._watcher.watch(self._descriptor, POLLIN | POLLOUT, self._on_ready)
        self._unwritten += data
        if not self._paused and len(self._unwritten) > HIGH_WATER:
            self._paused = True
            self._protocol.pause_writing()

    def is_closing(self) -> bool:
        """Return whether the end was asked for, or has come."""
        return self._closing

    def abort(self) -> None:
        """End the connection at once."""
        self._lose(None)

    close = abort

    def _write(self, data: bytes | bytearray | memoryview) -> int:
        try:
            return self._put(data)
        except BlockingIOError:
            return 0
        except OSError as error:
            self._lose(error)
            return len(data)

    def _on_ready(self, event: int) -> None:
        if event & POLLOUT:
            self._write_more()
        if event & ~POLLOUT and not self._closing:
            self._read()

    def _write_more(self) -> None:
        del self._unwritten[: self._write(self._unwritten)]
        if self._closing:
            return
        if not self._unwritten:
            self._watcher.watch(self._descriptor, POLLIN, self._on_ready)
        if self._paused and len(self._unwritten) <= LOW_WATER:
            self._paused = False
            self._protocol.resume_writing()

    def _read(self) -> None:
        try:
            data = self._channel.read()
        except BlockingIOError:
            return
        except EOFError:
            self._lose(None)
        except (OSError, ConnectError) as error:
            self._lose(error)
        else:
            if data:
                self._protocol.data_received(data)

    def _lose(self, reason: Exception | None) -> None:
        if self._closing:
            return
        self._closing = True
        self._unwritten.clear()
        self._watcher.unwatch(self._descriptor)
        self._channel.close()
        self._watcher.call_soon(lambda: self._protocol.connection_lost(reason))
