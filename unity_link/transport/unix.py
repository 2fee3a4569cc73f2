"""``unix:/path``: a gateway that another program of this machine serves."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

OPTIONS: frozenset[str] = frozenset()


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect to a Unix socket."""
    if not url.path:
        raise ArgumentError(f"{url.text} names no socket: unix:/path was expected")
    try:
        transport, _ = await asyncio.get_running_loop().create_unix_connection(lambda: protocol, url.path)
    except OSError as error:
        raise ConnectError(
            f"no connection to the socket {url.path} ({error.strerror or error}); is it served?"
        ) from error
    return transport
