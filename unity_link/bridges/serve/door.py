"""The listener: it checks the tokens of connections, and limits their number.

If a token is required, the first line of a connection must be `TOKEN_LINE` and the token (protocol, "Shared links").
Until the token has arrived, the server processes and sends no other data. A connection that takes longer than `HURRY`
seconds, or sends anything else, is closed.

Unauthenticated clients do not count as clients. There are at most `MOST_STRANGERS` of them: if one more connects, the
oldest is disconnected.
"""

from __future__ import annotations

import asyncio
import hmac
import socket
from typing import TYPE_CHECKING, cast

from unity_link.bridges.serve.client import Client
from unity_link.protocol.wire.frames import TOKEN_LINE

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

HURRY = 5.0
"""Seconds within which the token must arrive."""
KEEP_ALIVE = {
    "TCP_KEEPIDLE": 30,
    "TCP_KEEPALIVE": 30,
    "TCP_KEEPINTVL": 5,
    "TCP_KEEPCNT": 3,
    "TCP_USER_TIMEOUT": 45_000,
}
"""Socket options with which the system detects, after 45 s of silence, that a client's machine is gone.

After 30 s of silence the system sends three probes, one every 5 s. Sent data that is not acknowledged within 45 s also
ends the connection (RFC 5482). macOS calls TCP_KEEPIDLE TCP_KEEPALIVE. Options that a system does not have are left
out.
"""
MOST_CLIENTS = 256
MOST_STRANGERS = 512
"""Most unauthenticated clients; above the backlog of the system, so that none is dropped before its token is read."""
LONGEST_TOKEN = 256


def enable_keep_alive(connection: socket.socket) -> None:
    """Enable TCP keep-alive, so that the groups of a client are freed if its machine disappears."""
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in KEEP_ALIVE.items():
        if hasattr(socket, name):
            connection.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)


class Door(asyncio.Protocol):
    """A connection of an unauthenticated client.

    Args:
        shared: link that the client will share.
        token: token that the client must send; None if no token is required.
    """

    def __init__(self, shared: SharedLink, token: str | None) -> None:
        self._shared = shared
        self._token = None if token is None else token.encode()
        self._transport: asyncio.Transport
        self._said = b""
        self._timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Accept the client, or wait for its token."""
        # Do not check the class: transports of uvloop are no subclasses of asyncio's.
        self._transport = cast("asyncio.Transport", transport)
        connection = transport.get_extra_info("socket")
        if connection is not None and connection.family != socket.AF_UNIX:
            enable_keep_alive(connection)
        if self._token is None:
            self._let_in()
            return
        strangers = self._shared.strangers
        if len(strangers) >= MOST_STRANGERS:
            oldest = next(iter(strangers))
            del strangers[oldest]
            oldest.abort()
        strangers[self._transport] = None
        self._timer = self._shared.loop.call_later(HURRY, self.hang_up)

    def data_received(self, data: bytes) -> None:
        """Compare the first line with the token."""
        self._said += data
        line, end, rest = self._said.partition(b"\n")
        if end and self._token is not None and hmac.compare_digest(line.rstrip(b"\r"), TOKEN_LINE + self._token):
            self._leave()
            self._let_in(rest)
        elif end or len(line) > len(TOKEN_LINE) + LONGEST_TOKEN:
            self.hang_up()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002
        """Remove the unauthenticated client."""
        self._leave()

    def hang_up(self) -> None:
        """End the connection."""
        self._leave()
        self._transport.abort()

    def _leave(self) -> None:
        self._shared.strangers.pop(self._transport, None)
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _let_in(self, rest: bytes = b"") -> None:
        """Make a client of the connection, or close it if there are too many clients."""
        if len(self._shared.clients) >= MOST_CLIENTS:
            self._transport.abort()
            return
        client = Client(self._shared)
        self._transport.set_protocol(client)
        client.connection_made(self._transport)
        if rest:
            client.data_received(rest)
