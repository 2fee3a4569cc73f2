"""A bad network on purpose: a UDP port before that of a gateway, between which datagrams stray.

A client gets a port of its own towards the gateway for each of its own ports, as behind a router, so that the gateway
tells clients apart.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from typing import TYPE_CHECKING, Any, TypeAlias

from unity_link.transport import parse_url
from unity_link.transport.listening import LOOPBACK, serving
from unity_link.transport.tcp import address

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.virtual.faults import Straying

Address: TypeAlias = Any
Parcel: TypeAlias = "tuple[bytes, Address]"
"""A datagram and the client that it comes from or goes to."""
_LARGEST = 65_536


@serving("a network")
async def relay_udp(url: str, towards: Straying[Parcel], back: Straying[Parcel]) -> AsyncIterator[str]:
    """Relay the datagrams of clients to a gateway. Gives the URL for clients, a port of this machine.

    Args:
        url: of the gateway, ``udp://host:port``.
        towards: what happens to datagrams on their way to the gateway, from all clients together.
        back: what happens to those that it sends.

    Raises:
        ArgumentError: for a URL that names no host and port.
    """
    relay = _Relay(address(parse_url(url)), towards, back)
    try:
        yield f"udp://{LOOPBACK}:{relay.port}"
    finally:
        relay.close()


class _Relay:
    def __init__(self, gateway: tuple[str, int], towards: Straying[Parcel], back: Straying[Parcel]) -> None:
        self._gateway = gateway
        self._towards = towards
        self._back = back
        self._loop = asyncio.get_running_loop()
        self._near = self._socket()
        self._near.bind((LOOPBACK, 0))
        self._loop.add_reader(self._near, self._take)
        self._far: dict[Address, socket.socket] = {}
        """The port towards the gateway of each client."""

    @property
    def port(self) -> int:
        port: int = self._near.getsockname()[1]
        return port

    def close(self) -> None:
        for opened in (self._near, *self._far.values()):
            self._loop.remove_reader(opened)
            opened.close()

    @staticmethod
    def _socket() -> socket.socket:
        opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        opened.settimeout(0)
        return opened

    def _take(self) -> None:
        """Pass on what clients sent."""
        with contextlib.suppress(OSError):
            for datagram, client in self._towards.carry(self._near.recvfrom(_LARGEST)):
                self._far_of(client).send(datagram)

    def _far_of(self, client: Address) -> socket.socket:
        if client not in self._far:
            far = self._far[client] = self._socket()
            far.connect(self._gateway)
            self._loop.add_reader(far, self._take_back, far, client)
        return self._far[client]

    def _take_back(self, far: socket.socket, client: Address) -> None:
        """Pass on what the gateway sent to a client."""
        with contextlib.suppress(OSError):
            for datagram, receiver in self._back.carry((far.recv(_LARGEST), client)):
                self._near.sendto(datagram, receiver)
