"""Layer 3, proxies of modules: address windows on a gateway's bus, each with addresses of its own.

A proxy uses a `Bus`, with or without a spec, and provides one for the signals and modules inside it: the link itself,
or a wrapper of an outer module, as the one of a TosNet network that commits written words::

    pool = Memory(link, 0x80, size=64)
    await pool.store(range(64))
"""

# ruff: noqa: D102  (`unity_link.Link` documents the methods of `Bus`)

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Protocol, cast

import numpy as np

from unity_link.errors import ArgumentError, Sealed
from unity_link.link.calls import returns_coroutine
from unity_link.protocol.wire.numbers import whole_number

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence

    from numpy.typing import ArrayLike

    from unity_link.link.link import Link
    from unity_link.link.publishing import Sample
    from unity_link.link.subscription import Subscription
    from unity_link.protocol.wire.arrays import Words
    from unity_link.protocol.wire.configuration import GatewayInfo

__all__ = ["Bus", "Fifo", "Memory", "Module", "link_under"]


class Bus(Protocol):
    """A link, or the wrapper of a module, which has the link as attribute ``link``."""

    gateway: GatewayInfo

    async def read(self, address: int, /) -> int: ...
    async def write(self, address: int, value: int, /) -> None: ...
    async def write_masked(self, address: int, value: int, mask: int, /) -> int: ...
    def post(self, address: int, value: int, /) -> Coroutine[Any, Any, None]: ...
    async def read_block(self, address: int, count: int, /) -> Words: ...
    async def write_block(self, address: int, values: ArrayLike, /) -> None: ...
    async def read_queue(self, address: int, count: int, /) -> Words: ...
    async def write_queue(self, address: int, values: ArrayLike, /) -> None: ...
    async def read_many(self, addresses: ArrayLike, /) -> Words: ...
    async def write_many(self, addresses: ArrayLike, values: ArrayLike, /) -> None: ...
    def post_many(self, addresses: ArrayLike, values: ArrayLike, /) -> Coroutine[Any, Any, None]: ...


def link_under(bus: Bus) -> Link:
    """Return the link below a bus."""
    # Test without getattr: a link lacks the attribute, and would search for similar names for each error.
    has_link = "link" in getattr(bus, "__dict__", ()) or hasattr(type(bus), "link")
    return cast("Link", getattr(bus, "link") if has_link else bus)  # noqa: B009  (the class of `bus` is unknown)


def caller_on(link: Link) -> object:
    """Return the calling task or thread, as an argument for `post_for`."""
    return link._caller()  # noqa: SLF001  (for a later call of the link)


def post_for(poster: object, bus: Bus, address: int, value: int) -> Coroutine[Any, Any, None]:
    """Post a write so that the `fence` of a task or thread raises its error. A program's own bus has no such method."""
    post = getattr(bus, "_post_for", None)
    return bus.post(address, value) if post is None else post(poster, address, value)


def post_many_for(poster: object, bus: Bus, addresses: ArrayLike, values: ArrayLike) -> Coroutine[Any, Any, None]:
    """Post many writes for a task or thread, like `post_for`."""
    post = getattr(bus, "_post_many_for", None)
    return bus.post_many(addresses, values) if post is None else post(poster, addresses, values)


class Module(Sealed):
    """A module on the bus. Its methods take offsets: 0 is its first word.

    Each kind of module is a subclass.

    Raises:
        ArgumentError: by all methods, for an offset outside of the module.
    """

    SIZE: ClassVar[int | None] = None
    """Number of words of modules of this kind, if it is constant."""

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None) -> None:
        """Create a proxy on a link, or on another module's `bus`.

        Args:
            bus: the bus that contains the module.
            base: address of the first word on the gateway's bus.
            size: number of words; None if it is unknown.
        """
        self.outer = bus
        """The bus that contains the module."""
        self.link = link_under(bus)
        self.base = whole_number(base, "the base of a module")
        self.size = self.SIZE if size is None else whole_number(size, "the number of words of a module")
        if self.size is not None and self.size < 1:
            raise ArgumentError(f"a module of {self.size} words was asked for, at least 1 is needed")

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.

        def __setattr__(self, name: str, value: object) -> None:
            """Set an existing attribute or property; subclasses of programs may need that."""
            if name in vars(self) or getattr(getattr(type(self), name, None), "fset", None) is not None:
                object.__setattr__(self, name, value)
            else:
                super().__setattr__(name, value)

    def __repr__(self) -> str:
        """Return the kind, address and size."""
        size = "" if self.size is None else f", {self.size} words"
        return f"<{type(self).__name__} at {self.base:#x}{size}>"

    @property
    def bus(self) -> Bus:
        """Bus for the signals and modules inside this one."""
        return self.outer

    def address(self, offset: int, count: int = 1) -> int:
        """Return the address of `offset` on the gateway's bus; `count` words from there must be in the module."""
        offset, count = whole_number(offset, "an offset"), whole_number(count, "a number of words")
        if offset < 0 or (self.size is not None and offset + count > self.size):
            end = "" if self.size is None else f" to {self.size - count}"
            words = f"{count} words at offset" if count > 1 else "offset"
            raise ArgumentError(f"{self!r}: {words} {offset} asked for, 0{end} expected")
        return self.base + offset

    async def read(self, offset: int) -> int:
        """Read the word at `offset`."""
        return await self.bus.read(self.address(offset))

    async def write(self, offset: int, value: int) -> None:
        """Write `value` to `offset`."""
        await self.bus.write(self.address(offset), value)

    async def write_masked(self, offset: int, value: int, mask: int) -> int:
        """Replace the bits that are 1 in `mask`, atomically, and return the word as it was before."""
        return await self.bus.write_masked(self.address(offset), value, mask)

    @returns_coroutine
    def post(self, offset: int, value: int) -> Coroutine[Any, Any, None]:
        """Send a write without waiting for its execution."""
        return self._post(caller_on(self.link), offset, value)

    async def _post(self, poster: object, offset: int, value: int) -> None:
        await post_for(poster, self.bus, self.address(offset), value)

    async def read_block(self, offset: int, count: int) -> Words:
        """Read `count` words from `offset` on; shape (count,)."""
        return await self.bus.read_block(self.address(offset, count), count)

    async def write_block(self, offset: int, values: ArrayLike) -> None:
        """Write words from `offset` on."""
        words = np.asarray(values)
        await self.bus.write_block(self.address(offset, words.size), words)

    async def read_many(self, offsets: Sequence[int]) -> Words:
        """Read many words in one pipelined batch."""
        return await self.bus.read_many([self.address(offset) for offset in offsets])

    async def write_many(self, offsets: Sequence[int], values: ArrayLike) -> None:
        """Write one word to each of many offsets in one pipelined batch."""
        await self.bus.write_many([self.address(offset) for offset in offsets], values)

    def subscribe(
        self, offsets: Sequence[int], *, callback: Callable[[Sample], object] | None = None, **options: Any
    ) -> Subscription:
        """Subscribe to offsets that the gateway samples; `unity_link.Link.subscribe` documents the options."""
        return self.link.subscribe([self.address(offset) for offset in offsets], callback=callback, **options)


class Memory(Module):
    """Plain memory, or registers without a proxy of their own: MEMORY in a spec.

    A read returns the last written word. Offsets count words.
    """

    def __len__(self) -> int:
        """Return the number of words."""
        return self._known_size()

    def __bool__(self) -> bool:
        """Return True, also for an empty result of `len`: the memory is not a Python container."""
        return True

    async def load(self) -> Words:
        """Read all words; shape (words,)."""
        return await self.read_block(0, self._known_size())

    async def store(self, values: ArrayLike) -> None:
        """Write words from the first one on."""
        await self.write_block(0, values)

    async def fill(self, value: int = 0) -> None:
        """Write the same value to all words."""
        word, size = whole_number(value, "a word"), self._known_size()
        await self.write_block(0, [word] * size)

    def _known_size(self) -> int:
        if self.size is None:
            raise ArgumentError(f"{self!r}: its size is not known; give SIZE in the spec, or size=")
        return self.size


class Fifo(Module):
    """A queue at one address: FIFO in a spec.

    A read of the address removes the oldest word, a write appends one. The gateware defines the behaviour of an empty
    or full queue: a bus error, which is raised here, or wait states.
    """

    SIZE = 1

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None, words: int | None = None) -> None:
        """Create a proxy of a queue.

        Args:
            bus: as for `Module`.
            base: address of the port.
            size: as for `Module`.
            words: depth of the queue in words; None if it is unknown.
        """
        super().__init__(bus, base, size=size)
        self.words = words

    async def take(self, count: int) -> Words:
        """Remove `count` words and return them; shape (count,).

        Raises:
            BusError: if the queue had fewer words and the gateware reports that; its words are lost.
        """
        return await self.bus.read_queue(self.address(0), count)

    async def append(self, values: ArrayLike) -> None:
        """Append words.

        Raises:
            BusError: if the queue became full and the gateware reports that; the first words were appended.
        """
        await self.bus.write_queue(self.address(0), np.atleast_1d(np.asarray(values)))
