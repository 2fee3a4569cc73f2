"""A gateway whose line can be stopped, emptied and cut at will: what a test needs to bring a link into trouble."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from unity_link.protocol.wire.frames import in_session
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import MutableMapping

    from unity_link import GatewayInfo
    from unity_link.link.connection import Connection
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.messages import DecodedRequest


class Valve(Gateway):
    """Stands in front of a gateway and lets bytes through, or loses them.

    Args:
        gateway: what is behind.
    """

    def __init__(self, gateway: Gateway) -> None:
        self.gateway = gateway
        self.info, self.wake = gateway.info, gateway.wake
        self.requests_pass = True
        self.answers_pass = True
        self.instead = b""
        """Bytes that the host hears whenever it says something, besides the answers."""
        self.heard = b""
        """Bytes that the host has sent."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.gateway, name)

    def go_away(self, connection: Connection) -> None:
        """End a connection, and answer no other until `come_back`."""
        self.requests_pass = self.answers_pass = False
        cut(connection)

    def come_back(self) -> None:
        """Let everything through."""
        self.requests_pass = self.answers_pass = True

    @property
    def memory(self) -> MutableMapping[int, int]:
        return self.gateway.memory

    @property
    def next_due(self) -> float | None:
        return self.gateway.next_due

    @property
    def waiting(self) -> int:
        return self.gateway.waiting

    def receive(self, data: bytes, now: float) -> bytes:
        self.heard += data
        answer = self.gateway.receive(data if self.requests_pass else b"", now)
        return (answer if self.answers_pass else b"") + self.instead

    def advance(self, now: float, room: int | None = None) -> bytes:
        return self.gateway.advance(now, room)


class Uncounting(VirtualGateway):
    """Answers each ``h`` by an error, as a server does while its gateway is away; it knows how each request ended."""

    def _execute(self, request: DecodedRequest, now: float) -> bytes:
        if request.command != "H" or request.id is None:
            return super()._execute(request, now)
        self._session.state.fail(request.id, ErrorCode.BUS_TIMEOUT, posted=False)
        return self._codec.error(ErrorCode.BUS_TIMEOUT, request.id)


def numbers_in(sent: bytes, info: GatewayInfo) -> list[int]:
    """Return the IDs of the requests in what a host has sent, in their order."""
    heads = rb"^[g-z]+([0-9A-F]{%d})" % info.id_digits
    return [int(digits, 16) for digits in re.findall(heads, sent, re.MULTILINE)]


def as_gateway(codec: HostCodec, body: bytes) -> bytes:
    """Return the frame of a body as the gateway of a host sends it in the session under way."""
    return codec.framing.checked(body, codec.seed_back if body and in_session(body[0]) else 0)


def cut(connection: Connection) -> None:
    """End the connection of a link, or of a server, as a cable that is pulled out does."""
    assert connection._flow.stream is not None
    assert connection._flow.stream._transport is not None
    connection._flow.stream._transport.abort()
