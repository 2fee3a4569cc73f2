"""A network of real sockets that carries only short packets, and drops longer ones without a report."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.path import HEADERS
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying
from unity_link.virtual.serving import serve_udp
from unity_link.virtual.udp_relay import relay_udp

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

INFO = GatewayInfo(address_bits=16)


class Short(Straying[Any]):
    """Drops datagrams whose packets are longer than an MTU.

    Args:
        mtu: longest packet of IPv4 in bytes.
    """

    def __init__(self, mtu: int) -> None:
        super().__init__()
        self.mtu = mtu
        self.passed: list[int] = []
        """Length in bytes of each packet that arrived."""
        self.dropped: list[int] = []
        """Length in bytes of each packet that was too long."""

    def carry(self, datagram: Any) -> list[Any]:
        size = len(datagram[0]) + HEADERS
        (self.passed if size <= self.mtu else self.dropped).append(size)
        return [datagram] if size <= self.mtu else []


@contextlib.asynccontextmanager
async def short_path(mtu: int, back: int | None = None) -> AsyncIterator[tuple[str, Short, Short]]:
    """Serve a gateway across such a network; yield the URL and both directions.

    Args:
        mtu: longest packet to the gateway in bytes.
        back: longest packet from the gateway in bytes; by default the same.
    """
    directions = Short(mtu), Short(mtu if back is None else back)
    async with serve_udp(VirtualGateway(INFO)) as url, relay_udp(url, *directions) as relayed:
        yield relayed, *directions
