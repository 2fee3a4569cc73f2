"""The bus below a module: addresses that can be read and written as those of a link."""

# ruff: noqa: D102  (the methods are those of `unity_link.Link`, which says what they do)

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, cast

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from unity_link.link.link import Link
    from unity_link.protocol.arrays import Words
    from unity_link.protocol.configuration import GatewayInfo


class Bus(Protocol):
    """A link, or what a module puts before it. The latter names the link as ``link``."""

    gateway: GatewayInfo

    async def read(self, address: int, /) -> int: ...
    async def write(self, address: int, value: int, /) -> None: ...
    async def write_masked(self, address: int, value: int, mask: int, /) -> int: ...
    async def post(self, address: int, value: int, /) -> None: ...
    async def read_block(self, address: int, count: int, /) -> Words: ...
    async def write_block(self, address: int, values: ArrayLike, /) -> None: ...
    async def read_queue(self, address: int, count: int, /) -> Words: ...
    async def write_queue(self, address: int, values: ArrayLike, /) -> None: ...
    async def read_many(self, addresses: ArrayLike, /) -> Words: ...
    async def write_many(self, addresses: ArrayLike, values: ArrayLike, /) -> None: ...
    async def post_many(self, addresses: ArrayLike, values: ArrayLike, /) -> None: ...


def link_under(bus: Bus) -> Link:
    """Return the link that a bus stands on."""
    return cast("Link", getattr(bus, "link", bus))
