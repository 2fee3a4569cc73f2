"""Links to gateways of this process over Zenoh: the streams of a bridge on one session, the driver on another."""

from __future__ import annotations

import itertools
import socket
from contextlib import contextmanager
from typing import TYPE_CHECKING

from support.sharing import ServedGateway
from unity_link.bridges.zenoh.streams import Streams
from unity_link.transport import load_driver, parse_url
from unity_link.transport.zenoh_session import KeyTransport, Network, close_session, open_session

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Awaitable, Callable, Iterator

    from unity_link.virtual import Gateway


@contextmanager
def zenoh_network() -> Iterator[Callable[[Gateway, asyncio.Protocol], Awaitable[asyncio.Transport]]]:
    """Yield a function that connects a protocol to a gateway over Zenoh; a substitute for `Gateway.open`."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        endpoint = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    session = open_session(Network(listen=(endpoint,)))
    numbers = itertools.count()

    async def connect(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
        shared = ServedGateway(gateway, lambda _: None)
        shared.open_when_there()
        prefix = f"gateway/{next(numbers)}"
        streams = Streams(session, prefix, shared)
        url = parse_url(f"zenoh:{prefix}?connect={endpoint}")
        transport = await load_driver(url.scheme).connect(url, protocol)
        assert isinstance(transport, KeyTransport)
        over = transport._over

        def end() -> None:
            # Close now, not when Zenoh reports the end: the event loop of the test may have ended by then.
            streams.close()
            over()

        transport._over = end
        return transport

    try:
        yield connect
    finally:
        close_session(session)
