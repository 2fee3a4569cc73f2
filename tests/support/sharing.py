"""A shared link in this process, with its clients: links and terminals, connected by pipes, on simulated time."""

from __future__ import annotations

import asyncio
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Self

from support import pipe
from unity_link.bridges.serve.client import Client
from unity_link.bridges.serve.shared import SharedLink, Sharer
from unity_link.link.link import Link
from unity_link.transport import DriverUrl
from unity_link.virtual.gateway import BareGateway, Gateway

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable

    from unity_link.link.connection import Reconnect
    from unity_link.transport.stream import Stream
    from unity_link.virtual.faults import Noise

SEED, SEED_BACK = 2, 3
"""CRC seeds of session 1: of frames from the host, and of frames from the gateway."""
open_directly = Gateway.open
"""The original function, for use while a test has replaced it."""


class Terminal(asyncio.Protocol):
    """A client that sends the bytes of a test, and stores all received bytes."""

    def __init__(self) -> None:
        self.heard = b""
        self.gone = False

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        self.heard += data

    def connection_lost(self, exc: Exception | None) -> None:
        self.gone = True

    def take(self) -> bytes:
        heard, self.heard = self.heard, b""
        return heard


@asynccontextmanager
async def sharing(gateway: Gateway) -> AsyncIterator[SharedLink]:
    shared = SharedLink(gateway, lambda _: None)
    shared.open_when_there()
    await until(lambda: not shared.away)
    try:
        yield shared
    finally:
        await shared.finish()


def call(shared: SharedLink) -> Terminal:
    terminal = Terminal()
    pipe.connect(terminal, Client(shared))
    return terminal


def clients_of(shared: SharedLink) -> set[Client]:
    return {client for client in shared.clients if isinstance(client, Client)}


async def settle(shared: SharedLink) -> None:
    """Wait until all requests are answered."""
    await asyncio.sleep(0.01)
    await until(
        lambda: not shared._session.window.in_flight and not any(client._pending for client in clients_of(shared))
    )
    await asyncio.sleep(0.01)


async def until(condition: Callable[[], bool]) -> None:
    """Wait until a condition is true, for at most ten minutes of simulated time."""
    async with asyncio.timeout(600):
        while not condition():  # noqa: ASYNC110  (time is simulated)
            await asyncio.sleep(0.001)


async def tell_of_reset(shared: SharedLink, gateway: BareGateway, client: Terminal, said: bytes = b"") -> None:
    """Reset the gateway of a shared link and wait until the link has detected it; meanwhile a client sends bytes."""
    sessions = shared._session.epoch
    gateway.reset()
    client.transport.write(said)
    # The server forwards requests with an ID; a gateway after a reset answers such a request by error 0A.
    prober = call(shared)
    prober.transport.write(b"R00\r")
    await until(lambda: shared._session.epoch > sessions and shared.connected and not shared.away)
    prober.transport.abort()


class PipedLink(Link):
    """A link to a shared link, over a pipe.

    Args:
        shared: the shared link.
        noise: noise in each direction.
        reconnect: as for any link.
    """

    def __init__(
        self, shared: SharedLink, noise: tuple[Noise, Noise] | None = None, reconnect: Reconnect | None = None
    ) -> None:
        assert not isinstance(shared._target, DriverUrl)
        super().__init__(shared._target, reconnect)
        self._shared = shared
        self._noise = noise or (None, None)
        self.client: Client

    async def _connect_stream(self, stream: Stream) -> None:
        self.client = Client(self._shared)
        pipe.connect(stream, self.client, *self._noise)

    async def __aenter__(self) -> Self:
        await self.open(3600)
        return self


class ServedGateway(SharedLink):
    """A shared link of one client, which ends with its client."""

    async def _connect_stream(self, stream: Stream) -> None:
        assert not isinstance(self._target, DriverUrl)
        assert isinstance(self._target, Gateway)
        await open_directly(self._target, stream)

    def leave(self, client: Sharer) -> None:
        super().leave(client)
        self._run(self.finish())


async def connect_through_server(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect a protocol to a gateway through a shared link; a substitute for `Gateway.open`."""
    shared = ServedGateway(gateway, lambda _: None)
    shared.open_when_there()
    return pipe.connect(protocol, Client(shared))
