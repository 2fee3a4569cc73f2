"""``unix:/path``: a gateway that another program on this machine serves."""

from __future__ import annotations

import asyncio
import socket
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.transport.channel import SocketChannel, refused_as

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from unity_link.transport import DriverUrl
    from unity_link.transport.channel import Channel

OPTIONS: frozenset[str] = frozenset()
NODES_SHARE = True


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect to a Unix socket."""
    path = _path(url)
    with _refused(path):
        transport, _ = await asyncio.get_running_loop().create_unix_connection(lambda: protocol, path)
    return transport


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:
    """Connect to a Unix socket without an event loop."""
    path = _path(url)
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        connection.settimeout(timeout)
        with _refused(path):
            connection.connect(path)
    except BaseException:
        connection.close()
        raise
    return SocketChannel(connection)


def _refused(path: str) -> AbstractContextManager[None]:
    return refused_as(f"no connection to the socket {path}", lambda error: _question(path, error))


def _question(path: str, error: OSError | UnicodeError) -> str:
    if isinstance(error, PermissionError):
        return "it is another user's, and open to that one alone: serve to several users by --tcp and a token"
    if Path(path).exists() and not Path(path).is_socket():
        return "it is no socket"
    return "is it served?"


def _path(url: DriverUrl) -> str:
    if url.host:
        raise ArgumentError(f"{url.text} names a host, {url.host}: did you mean {url.without_host}?")
    if not url.path:
        raise ArgumentError(f"{url.text} names no socket: unix:/path was expected")
    return url.path
