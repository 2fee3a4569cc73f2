"""A gateway whose line can be stopped, emptied and cut at will: what a test needs to bring a link into trouble."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import MutableMapping

    from unity_link import GatewayInfo, Link


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
        """What the host hears whenever it says something, besides the answers."""
        self.heard = b""
        """What the host has said."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.gateway, name)

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


def numbers_in(sent: bytes, info: GatewayInfo) -> list[int]:
    """Return the IDs of the requests in what a host has sent, in their order."""
    heads = rb"^[g-z]+([0-9A-F]{%d})" % info.id_digits
    return [int(digits, 16) for digits in re.findall(heads, sent, re.MULTILINE)]


def cut(link: Link) -> None:
    """End the connection of a link as a cable that is pulled out does."""
    assert link._flow.stream is not None
    assert link._flow.stream._transport is not None
    link._flow.stream._transport.abort()
