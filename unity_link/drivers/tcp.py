"""``tcp://host:port``: a gateway behind a serial device server, or a served virtual one."""

from __future__ import annotations

import asyncio
import socket
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    from unity_link.drivers import DriverUrl

OPTIONS: frozenset[str] = frozenset()


def address(url: DriverUrl) -> tuple[str, int]:
    """Give host and port of a URL.

    Raises:
        ArgumentError: where one of them is missing.
    """
    if not url.host or url.port is None:
        raise ArgumentError(f"{url.text} names no host and port: {url.scheme}://host:port was expected")
    return url.host, url.port


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect to a TCP port."""
    host, port = address(url)
    try:
        transport, _ = await asyncio.get_running_loop().create_connection(lambda: protocol, host, port)
    except OSError as error:
        raise ConnectError(
            f"no connection to port {port} of {host} ({error.strerror or error}); is it listening?"
        ) from error
    connection: socket.socket = transport.get_extra_info("socket")
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return transport
