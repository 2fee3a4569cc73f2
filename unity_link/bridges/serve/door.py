"""The door: who may come in, and how many.

Where a token is wanted, the first line of a connection is `TOKEN_LINE` and the token (protocol, "Shared links"). Until
it was right nothing else is looked at, and nothing is said; who takes longer than `HURRY` seconds, or says anything
else, is hung up on.

Connections without the token take no place of a client's. There are `MOST_STRANGERS` of them at most: one more, and the
oldest is hung up on.
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
"""Seconds within which the token must have come."""
KEEP_ALIVE = {
    "TCP_KEEPIDLE": 30,
    "TCP_KEEPALIVE": 30,
    "TCP_KEEPINTVL": 5,
    "TCP_KEEPCNT": 3,
    "TCP_USER_TIMEOUT": 45_000,
}
"""Socket options by which the system notices, after 45 s of silence, that a client's machine is gone.

After 30 s of silence it asks, every 5 s, three times; what was sent and is not confirmed in 45 s ends the connection,
too (RFC 5482). TCP_KEEPALIVE is what macOS calls TCP_KEEPIDLE. An option that a system does not have is left out.
"""
MOST_CLIENTS = 256
MOST_STRANGERS = 512
"""More than the system accepts before what the first of them has said is read, so that no token comes too late."""
LONGEST_TOKEN = 256


def enable_keep_alive(connection: socket.socket) -> None:
    """Enable TCP keep-alive, so that the groups of a client whose machine has gone without a word are freed."""
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in KEEP_ALIVE.items():
        if hasattr(socket, name):
            connection.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)


class Door(asyncio.Protocol):
    """A connection that has not been let in yet.

    Args:
        shared: the link that it leads to.
        token: what lets in; None: everyone may.
    """

    def __init__(self, shared: SharedLink, token: str | None) -> None:
        self._shared = shared
        self._token = None if token is None else token.encode()
        self._transport: asyncio.Transport
        self._said = b""
        self._timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Let in, or wait for the token."""
        # No check by class: the transports of uvloop are of none of asyncio's.
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
        """Compare the first line with what lets in."""
        self._said += data
        line, end, rest = self._said.partition(b"\n")
        if end and self._token is not None and hmac.compare_digest(line.rstrip(b"\r"), TOKEN_LINE + self._token):
            self._leave()
            self._let_in(rest)
        elif end or len(line) > len(TOKEN_LINE) + LONGEST_TOKEN:
            self.hang_up()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002
        """Forget the stranger."""
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
        """Make a client of the connection, or hang up where there are too many."""
        if len(self._shared.clients) >= MOST_CLIENTS:
            self._transport.abort()
            return
        client = Client(self._shared)
        self._transport.set_protocol(client)
        client.connection_made(self._transport)
        if rest:
            client.data_received(rest)
