"""``tcp://host:port``: a gateway behind a serial device server, a served virtual one, or a shared link.

What shares a link may want a token; it goes before everything else (protocol, "Shared links").
"""

from __future__ import annotations

import asyncio
import socket
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.frames import LF, TOKEN_LINE

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

OPTIONS = frozenset({"token"})


def address(url: DriverUrl) -> tuple[str, int]:
    """Return host and port of a URL.

    Raises:
        ArgumentError: where one of them is missing.
    """
    if not url.host or url.port is None:
        raise ArgumentError(f"{url.text} names no host and port: {url.scheme}://host:port was expected")
    return url.host, url.port


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect to a TCP port."""
    host, port = address(url)
    token = url.options.get("token")
    if token is not None and not (token.isprintable() and token.isascii()):
        raise ArgumentError(f"token= in {url.text} has characters that are not printable ASCII")
    try:
        transport, _ = await asyncio.get_running_loop().create_connection(lambda: protocol, host, port)
    except OSError as error:
        raise ConnectError(
            f"no connection to port {port} of {host} ({error.strerror or error}); is it listening?"
        ) from error
    connection: socket.socket = transport.get_extra_info("socket")
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    if token is not None:
        transport.write(TOKEN_LINE + token.encode() + LF)
    return transport
