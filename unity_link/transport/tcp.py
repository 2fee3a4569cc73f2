"""``tcp://host:port``: a gateway at a serial device server, a served virtual gateway, or a shared link.

A server of a shared link may require a token, which is then sent first (docs/protocol.md, "Shared links").
"""

from __future__ import annotations

import asyncio
import socket
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.frames import LF, TOKEN_LINE
from unity_link.transport.channel import SocketChannel, refused_as

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from unity_link.transport import DriverUrl
    from unity_link.transport.channel import Channel

OPTIONS = frozenset({"token"})
NODES_SHARE = True
NAMELESS = (socket.gaierror, UnicodeError)
"""Errors for a host name without an address."""


def address(url: DriverUrl) -> tuple[str, int]:
    """Return host and port of a URL.

    Raises:
        ArgumentError: if one of them is missing.
    """
    if not url.host or url.port is None:
        raise ArgumentError(f"{url.text} names no host and port: {url.scheme}://host:port was expected")
    return url.host, url.port


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect to a TCP port."""
    host, port = address(url)
    first = _first_line(url)
    with _refused(host, port):
        transport, _ = await asyncio.get_running_loop().create_connection(lambda: protocol, host, port)
    connection: socket.socket = transport.get_extra_info("socket")
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    if first:
        transport.write(first)
    return transport


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:
    """Connect to a TCP port without an event loop."""
    host, port = address(url)
    first = _first_line(url)
    with _refused(host, port):
        connection = socket.create_connection((host, port), timeout)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.sendall(first)
    return SocketChannel(connection)


def _refused(host: str, port: int) -> AbstractContextManager[None]:
    return refused_as(
        f"no connection to port {port} of {host}",
        lambda error: "is the name right?" if isinstance(error, NAMELESS) else "is it listening?",
    )


def _first_line(url: DriverUrl) -> bytes:
    """Return the line with the token, which is sent first; empty if the URL has no token."""
    token = url.options.get("token")
    if token is None:
        return b""
    if not (token.isprintable() and token.isascii()):
        raise ArgumentError(f"token= in {url.text} has characters that are not printable ASCII")
    return TOKEN_LINE + token.encode() + LF
