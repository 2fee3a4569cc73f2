"""A gateway whose line a test can stop, empty and cut, to disturb a link."""

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
    """Passes bytes to and from a gateway, or loses them.

    Args:
        gateway: the gateway at the end of the line.
    """

    def __init__(self, gateway: Gateway) -> None:
        self.gateway = gateway
        self.info, self.wake = gateway.info, gateway.wake
        self.requests_pass = True
        self.answers_pass = True
        self.instead = b""
        """Bytes added to the answer to each write of the host."""
        self.heard = b""
        """Bytes that the host has sent."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.gateway, name)

    def go_away(self, connection: Connection) -> None:
        """Cut a connection, and answer no other until `come_back` is called."""
        self.requests_pass = self.answers_pass = False
        cut(connection)

    def come_back(self) -> None:
        """Pass all bytes again."""
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
    """Return the IDs of the requests in sent bytes, in their order."""
    heads = rb"^[g-z]+([0-9A-F]{%d})" % info.id_digits
    return [int(digits, 16) for digits in re.findall(heads, sent, re.MULTILINE)]


def as_gateway(codec: HostCodec, body: bytes) -> bytes:
    """Return a body as a frame that the gateway sends in the current session."""
    return codec.framing.checked(body, codec.seed_back if body and in_session(body[0]) else 0)


def cut(connection: Connection) -> None:
    """Cut the connection of a link or a server, as if its cable were unplugged."""
    assert connection._flow.stream is not None
    assert connection._flow.stream._transport is not None
    connection._flow.stream._transport.abort()
