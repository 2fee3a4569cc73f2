"""Two ways to a gateway: the driver alone, and the whole link."""

from __future__ import annotations

import asyncio
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np

from benchmarks.paper.build import checked
from unity_link.link.link import connect
from unity_link.transport import parse_url

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.link.link import Link, SendImmediate

StackName = Literal["low-level", "full stack"]
Access = Literal["read", "write", "post"]
"""A post is a stateless write: it has no answer."""
URL = "ftdi-async://ftdi:232h/1"
ADDRESS, ADDRESSES = 0x0A, 256
WORD = 0x12


class Stack(Protocol):
    """A way to a gateway, open."""

    line_bytes: dict[Access, int]
    """What one access moves in the direction that it fills: a read's answer, the request of a write or a post."""

    async def send_immediate(self, mode: SendImmediate) -> None:
        """Choose a mode, in the gateway and in the driver."""

    async def one(self, access: Access) -> None:
        """Make one access, and wait for its answer; for a post, until it is sent."""

    async def burst(self, access: Access, count: int) -> None:
        """Make many accesses at once, and wait until the last is answered or, for posts, known to be executed."""


class FullStack:
    """The link: messages with IDs, each executed exactly once and in order."""

    def __init__(self, link: Link) -> None:
        self.link = link
        info = link.gateway
        word, address, check = info.data_digits, info.address_digits, info.crc_bits // 4
        head, end = 1 + info.id_digits, check + 1
        self.line_bytes: dict[Access, int] = {
            "read": head + word + end,
            "write": head + address + word + end,
            "post": 1 + head + address + word + end,
        }

    @classmethod
    @asynccontextmanager
    async def opened(cls, timeout: float) -> AsyncIterator[FullStack]:  # noqa: ASYNC109  (handed on)
        """Open a link to the chip that is plugged in."""
        async with connect(URL, timeout=timeout) as link:
            yield cls(link)

    async def send_immediate(self, mode: SendImmediate) -> None:
        """Choose a mode."""
        await self.link.send_immediate(mode)

    async def one(self, access: Access) -> None:
        """Make one access."""
        if access == "read":
            await self.link.read(ADDRESS)
        elif access == "write":
            await self.link.write(ADDRESS, WORD)
        else:
            await self.link.post(ADDRESS, WORD)

    async def burst(self, access: Access, count: int) -> None:
        """Make many accesses at once."""
        addresses = np.arange(count) % ADDRESSES
        if access == "read":
            await self.link.read_many(addresses)
        elif access == "write":
            await self.link.write_many(addresses, addresses)
        else:
            await self.link.post_many(addresses, addresses)
            await self.link.fence()


class LowLevel(asyncio.Protocol):
    """The driver's transport alone, with ready-made messages without IDs: those of the paper, 6 and 14 bytes."""

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._missing = 0
        self._arrived: asyncio.Future[None] = self._loop.create_future()
        self._ended: asyncio.Future[None] = self._loop.create_future()
        self._transport: asyncio.Transport
        self._requests: dict[Access, bytes] = {
            "read": checked(b"R%02X" % ADDRESS),
            "write": checked(b"W%02X%08X" % (ADDRESS, WORD)),
            "post": checked(b"WS%02X%08X" % (ADDRESS, WORD)),
        }
        answer = len(checked(b"R%02X%08X" % (ADDRESS, WORD)))
        self._answers: dict[Access, int] = {"read": answer, "write": len(checked(b"W%02X" % ADDRESS)), "post": 0}
        self.line_bytes: dict[Access, int] = {
            "read": answer,
            "write": len(self._requests["write"]),
            "post": len(self._requests["post"]),
        }

    @classmethod
    @asynccontextmanager
    async def opened(cls, timeout: float) -> AsyncIterator[LowLevel]:  # noqa: ASYNC109  (as `FullStack.opened`)
        """Open the driver of the chip that is plugged in."""
        from unity_link.transport.ft232h import with_libusb

        async with asyncio.timeout(timeout):
            stack = cls()
            stack._transport = await with_libusb.connect(parse_url(URL), stack)
        try:
            yield stack
        finally:
            stack._transport.close()
            await stack._ended

    async def send_immediate(self, mode: SendImmediate) -> None:
        """Choose a mode."""
        request = checked(b"I%02X" % ("off", "always", "adaptive").index(mode))
        await self._exchange(request, len(request))
        await self._transport.get_extra_info("send_immediate")(mode)

    async def one(self, access: Access) -> None:
        """Make one access."""
        await self._exchange(self._requests[access], self._answers[access])

    async def burst(self, access: Access, count: int) -> None:
        """Make many accesses at once; behind posts, a read tells that they are executed."""
        requests, size = self._requests[access] * count, self._answers[access] * count
        if access == "post":
            requests, size = requests + self._requests["read"], self._answers["read"]
        await self._exchange(requests, size)

    async def _exchange(self, request: bytes, answer_size: int) -> None:
        self._missing = answer_size
        self._arrived = self._loop.create_future()
        self._transport.write(request)
        if answer_size:
            await self._arrived

    # asyncio.Protocol

    def data_received(self, data: bytes) -> None:
        """Count."""
        self._missing -= len(data)
        if self._missing <= 0 and not self._arrived.done():
            self._arrived.set_result(None)

    def connection_lost(self, exc: Exception | None) -> None:
        """End; what waits ends with the reason."""
        if exc is not None and not self._arrived.done():
            self._arrived.set_exception(exc)
        if not self._ended.done():
            self._ended.set_result(None)


def link_of(stack: Any) -> Link:
    """Return the link of a full stack."""
    assert isinstance(stack, FullStack)
    return stack.link
