"""Shares a port with a file descriptor between the links to several nodes (``node=`` in a URL).

Links of a program whose URLs name the same port share it automatically. Only the link with the current slot reads and
writes, in its own thread or event loop, so that sharing needs no further thread. Bytes that arrive between two slots
are dropped. The port is closed with its last link. If one link finds the port lost, all of its links are lost.
"""

from __future__ import annotations

import contextlib
import os
import threading
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, ConnectError
from unity_link.transport.channel import LARGEST_READ, has_ended
from unity_link.transport.turns import Line

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.transport.channel import Channel
    from unity_link.transport.turns import Seat
    from unity_link.transport.url import DriverUrl

_OWN_OPTIONS = frozenset({"node", "snoop", "library"})
"""Options that may differ between links on the same port."""
_PORTS: dict[tuple[object, ...], SharedPort] = {}
"""Open ports, by scheme, host, port and path."""
_OWED: dict[tuple[object, ...], float] = {}
"""Time until which a late answer may arrive on a port that was closed."""
_LOCK = threading.Lock()
_READS_OF_ALL = 16
"""Number of reads that empty a port: Linux buffers up to 64 KiB of a terminal, and returns 4,095 bytes at a time."""


class SharedPort:
    """A medium that is open once for all links of this process."""

    def __init__(self, key: tuple[object, ...], url: DriverUrl, settings: Mapping[str, str]) -> None:
        self.key = key
        self.text = url.text
        self.settings = settings
        self.opening = threading.Lock()
        """Lock that is held while the port is being opened, which may be slow."""
        self.channel: Channel | None = None
        self.over = False
        """True if the port was closed, or could not be opened."""
        self.line = Line(_without_node(url), free_at=_OWED.pop(key, float("-inf")))
        self.users: set[SharedChannel] = set()

    def end(self) -> None:
        """Close the port; the next link opens it again."""
        self.over = True
        if _PORTS.get(self.key) is self:
            del _PORTS[self.key]
        if self.line.owed_until > self.line.clock():
            _OWED[self.key] = self.line.owed_until
        if self.channel is not None:
            self.channel.close()


def open_shared(
    url: DriverUrl,
    settings: Mapping[str, str],
    open_alone: Callable[[], Channel],
    is_given_up: Callable[[], bool] = lambda: False,
) -> SharedChannel:
    """Return a link's part of a port; open the port if it is not open.

    Args:
        url: URL with the port and the node.
        settings: options of the URL, and the driver's defaults for the others.
        open_alone: opens the port.
        is_given_up: returns True once the caller no longer waits; the node is then free for another link.

    Raises:
        ArgumentError: if the port is open with other settings.
        ConnectError: if the port cannot be opened, or the node has a link already.
    """
    assert url.node is not None
    of_port = {name: value for name, value in settings.items() if name not in _OWN_OPTIONS}
    key = (url.scheme, url.host, url.port, os.path.realpath(url.path) if url.path else "")
    while True:
        with _LOCK:
            port = _PORTS.get(key) or _PORTS.setdefault(key, SharedPort(key, url, of_port))
        with port.opening:
            if port.channel is None and not port.over:
                try:
                    port.channel = open_alone()
                except BaseException:
                    with _LOCK:
                        port.end()
                    raise
        with _LOCK:
            if port.over:
                continue
            if is_given_up():
                if not port.users:
                    port.end()
                raise ConnectError("it was given up")
            if port.settings != of_port:
                raise ArgumentError(f"{url.text}: this program has opened the port as {port.text}, with other options")
            return SharedChannel(port, port.line.join(url.node))


def _without_node(url: DriverUrl) -> str:
    return url.text.partition("?")[0]


class SharedChannel:
    """A link's part of a port: a channel that can be used in the link's slots."""

    def __init__(self, port: SharedPort, seat: Seat) -> None:
        assert port.channel is not None
        self.seat = seat
        self.shortest_timeout = port.channel.shortest_timeout
        self.byte_time: float | None = getattr(port.channel, "byte_time", None)
        self.set_again: Callable[[], None] | None = getattr(port.channel, "set_again", None)
        self.on_lost: Callable[[], object] = lambda: None
        """Is called in any thread when another link finds that the port is lost."""
        self._port = port
        # A duplicate of the descriptor, so that each thread or event loop can poll the port by itself.
        self._descriptor = os.dup(port.channel.fileno())
        port.users.add(self)

    def fileno(self) -> int:
        """Return the file descriptor."""
        return self._descriptor

    def read(self) -> bytes:
        """Return the received bytes; outside of the link's slot, drop them."""
        data = os.read(self._descriptor, LARGEST_READ)
        if not data and has_ended(self._descriptor):
            raise EOFError
        return data if self.seat.has_turn else b""

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Write as many bytes as the port accepts, and return their number.

        Outside of the link's slot the bytes are dropped, as if they were lost on the line.
        """
        if not self.seat.has_turn:
            return len(data)
        return os.write(self._descriptor, data)

    def drop_input(self) -> None:
        """Drop the bytes that arrived between two slots."""
        with contextlib.suppress(OSError):
            for _ in range(_READS_OF_ALL):
                if not os.read(self._descriptor, LARGEST_READ):
                    return

    def lose(self) -> None:
        """Close the port after an error, and notify the other links."""
        with _LOCK:
            if self not in self._port.users:
                return
            others = [user for user in self._port.users if user is not self]
            self._port.end()
        for user in others:
            user.on_lost()

    def close(self) -> None:
        """Release this part of the port; the last part closes the port."""
        with _LOCK:
            if self not in self._port.users:
                return
            self._port.users.remove(self)
            os.close(self._descriptor)
            self.seat.leave()
            if not self._port.users and not self._port.over:
                self._port.end()
