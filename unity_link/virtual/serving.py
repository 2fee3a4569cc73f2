"""Gateways for others: on an event loop, each `Gateway` to one client."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.transport import GatewayTransport

if TYPE_CHECKING:
    import asyncio

    from unity_link.virtual.gateway import Gateway


async def connect_gateway(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect a protocol to a gateway of this process, as a driver does to a medium."""
    transport = GatewayTransport(gateway, protocol)
    protocol.connection_made(transport)
    return transport
