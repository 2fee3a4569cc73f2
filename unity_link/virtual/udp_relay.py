"""A UDP relay in front of a gateway's port, with the faults of a bad network.

Each client has its own port towards the gateway, as behind a router, so that the gateway can distinguish clients.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from typing import TYPE_CHECKING, Any, TypeAlias

from unity_link.transport import parse_url
from unity_link.transport.listening import LOOPBACK, serving
from unity_link.transport.tcp import address
from unity_link.transport.udp import refused

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.virtual.faults import Straying

Address: TypeAlias = Any
Parcel: TypeAlias = "tuple[bytes, Address]"
"""A datagram, and the client that sent it or receives it."""
_LARGEST = 65_536
MOST_CLIENTS = 64
"""Largest number of clients; a further one replaces the client that has been silent for longest."""


@serving("a network")
async def relay_udp(url: str, towards: Straying[Parcel], back: Straying[Parcel]) -> AsyncIterator[str]:
    """Relay the datagrams of clients to a gateway; yield the URL for clients, a port of this machine.

    Args:
        url: URL of the gateway, ``udp://host:port``.
        towards: faults of the datagrams to the gateway, from all clients.
        back: faults of the datagrams from the gateway.

    Raises:
        ArgumentError: if the URL has no host or no port.
        ConnectError: if the host does not exist.
    """
    relay = _Relay(address(parse_url(url)), towards, back)
    try:
        yield f"udp://{LOOPBACK}:{relay.port}"
    finally:
        relay.close()


class _Relay:
    def __init__(self, gateway: tuple[str, int], towards: Straying[Parcel], back: Straying[Parcel]) -> None:
        with refused(*gateway):
            known = socket.getaddrinfo(*gateway, type=socket.SOCK_DGRAM)
        # Prefer IPv4: by default gateways are served at an IPv4 address, and localhost often has both.
        chosen = min(known, key=lambda one: one[0] != socket.AF_INET)
        self._family, self._gateway = chosen[0], chosen[4]
        self._towards = towards
        self._back = back
        self._loop = asyncio.get_running_loop()
        self._near = self._socket(socket.AF_INET)
        self._near.bind((LOOPBACK, 0))
        self._loop.add_reader(self._near, self._take)
        self._far: dict[Address, socket.socket] = {}
        """Socket of each client towards the gateway; the client with the latest datagram is last."""

    @property
    def port(self) -> int:
        port: int = self._near.getsockname()[1]
        return port

    def close(self) -> None:
        for opened in (self._near, *self._far.values()):
            self._close(opened)

    def _close(self, opened: socket.socket) -> None:
        self._loop.remove_reader(opened)
        opened.close()

    @staticmethod
    def _socket(family: int) -> socket.socket:
        opened = socket.socket(family, socket.SOCK_DGRAM)
        opened.settimeout(0)
        return opened

    def _take(self) -> None:
        """Relay a datagram of a client to the gateway."""
        with contextlib.suppress(OSError):
            for datagram, client in self._towards.carry(self._near.recvfrom(_LARGEST)):
                self._far_of(client).send(datagram)

    def _far_of(self, client: Address) -> socket.socket:
        far = self._far.pop(client, None)
        if far is None:
            if len(self._far) == MOST_CLIENTS:
                self._close(self._far.pop(next(iter(self._far))))
            far = self._socket(self._family)
            far.connect(self._gateway)
            self._loop.add_reader(far, self._take_back, far, client)
        self._far[client] = far
        return far

    def _take_back(self, far: socket.socket, client: Address) -> None:
        """Relay a datagram of the gateway to a client."""
        with contextlib.suppress(OSError):
            for datagram, receiver in self._back.carry((far.recv(_LARGEST), client)):
                self._near.sendto(datagram, receiver)
