"""Transports of media with a file descriptor, which a thread, a task group or an event loop polls."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from typing import TYPE_CHECKING, Protocol

from unity_link.errors import ConnectError
from unity_link.transport.buffered import HIGH_WATER, LOW_WATER
from unity_link.transport.polling import READABLE, WRITABLE
from unity_link.transport.shared_port import SharedChannel

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.transport.channel import Channel


class Watcher(Protocol):
    """A poller of file descriptors."""

    def call_soon(self, function: Callable[[], object], /) -> object:
        """Call a function after the code that runs now."""

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> object:
        """Call a function soon; other threads may use this."""

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler with the events whenever a file descriptor is ready for some of `events`."""

    def unwatch(self, descriptor: int) -> None:
        """Stop calling the handler of a file descriptor."""


class LoopWatcher:
    """Polls file descriptors by the running event loop of asyncio."""

    def __init__(self) -> None:
        self._loop = loop = asyncio.get_running_loop()
        self.call_soon = loop.call_soon
        self.call_soon_threadsafe = loop.call_soon_threadsafe

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler with the events whenever a file descriptor is ready for some of `events`."""
        self._loop.add_reader(descriptor, handler, READABLE)
        if events & WRITABLE:
            self._loop.add_writer(descriptor, handler, WRITABLE)
        else:
            self._loop.remove_writer(descriptor)

    def unwatch(self, descriptor: int) -> None:
        """Stop calling the handler of a file descriptor."""
        self._loop.remove_reader(descriptor)
        self._loop.remove_writer(descriptor)


class ChannelTransport(asyncio.Transport):
    """A transport that writes at once as much as the channel accepts, and the rest once the channel is writable again.

    Args:
        watcher: polls the channel.
        channel: the channel; the transport closes it.
        protocol: receives the bytes.
    """

    def __init__(self, watcher: Watcher, channel: Channel, protocol: asyncio.Protocol) -> None:
        names = ("shortest_timeout", "longest_try", "path", "byte_time", "seat", "set_again")
        super().__init__({name: getattr(channel, name) for name in names if hasattr(channel, name)})
        self._watcher = watcher
        self._channel = channel
        self._put = channel.write
        self._protocol = protocol
        self._descriptor = channel.fileno()
        self._unwritten = bytearray()
        self._paused = self._closing = False
        self._listening = self._reading = True
        watcher.watch(self._descriptor, READABLE, self._on_ready)
        protocol.connection_made(self)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Write bytes, or buffer them until the channel accepts them."""
        if self._closing:
            return
        if not self._unwritten:
            written = self._write(data)
            if written == len(data):
                return
            data = data[written:]
            self._watcher.watch(self._descriptor, READABLE | WRITABLE, self._on_ready)
        self._unwritten += data
        if not self._paused and len(self._unwritten) > HIGH_WATER:
            self._paused = True
            self._protocol.pause_writing()

    def pause_reading(self) -> None:
        """Leave received bytes in the channel until `resume_reading`.

        Pause only briefly: polling continues and returns at once while unread bytes are pending.
        """
        self._reading = False

    def resume_reading(self) -> None:
        """Deliver received bytes again."""
        self._reading = True

    def is_closing(self) -> bool:
        """Return True if the transport is closed."""
        return self._closing

    def abort(self) -> None:
        """Close the channel at once, and drop unwritten bytes."""
        self._end(None)

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
        if event & WRITABLE:
            self._write_more()
        if not event & ~WRITABLE or self._closing or not self._reading:
            return
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

    def _write_more(self) -> None:
        del self._unwritten[: self._write(self._unwritten)]
        if self._closing:
            return
        if not self._unwritten:
            self._watcher.watch(self._descriptor, READABLE, self._on_ready)
        if self._paused and len(self._unwritten) <= LOW_WATER:
            self._paused = False
            self._protocol.resume_writing()

    def _lose(self, reason: Exception | None) -> None:
        """End the connection because the medium is lost."""
        self._end(reason)

    def _end(self, reason: Exception | None) -> None:
        if self._closing:
            return
        self._closing = True
        self._unwritten.clear()
        if self._listening:
            self._watcher.unwatch(self._descriptor)
        self._channel.close()
        self._watcher.call_soon(lambda: self._protocol.connection_lost(reason))


class SharedTransport(ChannelTransport):
    """The transport of a link on a shared port; it reads and writes only in the link's slots."""

    def __init__(self, watcher: Watcher, channel: SharedChannel, protocol: asyncio.Protocol) -> None:
        self._shared = channel
        channel.on_lost = self._lost_elsewhere
        super().__init__(watcher, channel, protocol)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send a frame in the link's slot; outside of it, drop the frame."""
        seat = self._shared.seat
        if self._closing or not seat.has_turn:
            return
        if not self._unwritten and not seat.is_kept:
            # This frame is the first one in the slot.
            self._shared.drop_input()
        if not self._listening:
            self._listening = True
            self._watcher.watch(self._descriptor, READABLE, self._on_ready)
        super().write(data)

    def _on_ready(self, event: int) -> None:
        if self._shared.seat.listens:
            super()._on_ready(event)
        elif self._listening:
            self._listening = False
            self._unwritten.clear()
            self._watcher.unwatch(self._descriptor)

    def _lost_elsewhere(self) -> None:
        # If the link was not closed, its event loop may have ended.
        with suppress(RuntimeError):
            self._watcher.call_soon_threadsafe(lambda: self._end(ConnectError("the port is lost")))

    def _lose(self, reason: Exception | None) -> None:
        if not self._closing:
            self._shared.lose()
        super()._lose(reason)


def make_transport(watcher: Watcher, channel: Channel, protocol: asyncio.Protocol) -> ChannelTransport:
    """Return the transport for a channel."""
    if isinstance(channel, SharedChannel):
        return SharedTransport(watcher, channel, protocol)
    return ChannelTransport(watcher, channel, protocol)
