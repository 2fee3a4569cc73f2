"""Two ways to a gateway: the driver alone, and the whole link."""

from __future__ import annotations

import asyncio
from collections import deque
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np

from benchmarks.paper.build import checked
from unity_link.link.connecting import connect
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.transport import parse_url

if TYPE_CHECKING:
    from collections.abc import AsyncIterator
    from contextlib import AbstractAsyncContextManager

    from benchmarks.paper.probe import Probe
    from unity_link.link.link import Link, SendImmediate

StackName = Literal["low-level", "full stack"]
Access = Literal["read", "block", "write", "post"]
"""A block is an RM of `BLOCK_WORDS`. A post is a posted write, without an answer."""
ACCESSES: tuple[Access, ...] = ("read", "block", "write", "post")
Mode = Literal["off", "off, 1 ms", "always", "adaptive"]
"""Mode of send-immediate; off with the latency timer after the chip's reset, and with one of 1 ms, as in the paper."""
MODES: tuple[Mode, ...] = ("off", "off, 1 ms", "always", "adaptive")
URL = "ftdi-async://ftdi:232h/1"
ADDRESS, ADDRESSES = 0x0A, 0xF0
"""Single accesses use the first; bursts cycle through the addresses below the second."""
PROBE = 0xFE
"""Address of the probe (`probe.Probe`)."""
WORD = 0x12
BLOCK_WORDS = 16
_GROUP = 1


def url_of(mode: Mode, options: str = "") -> str:
    """Return the URL that opens the chip for a mode."""
    parts = [part for part in (options, "latency=1" if mode == "off, 1 ms" else "") if part]
    return URL + ("?" + "&".join(parts) if parts else "")


def of_the_link(mode: Mode) -> SendImmediate:
    """Return the link's name of a mode."""
    return "off" if mode == "off, 1 ms" else mode


class Samples(Protocol):
    """Samples of a subscription."""

    @property
    def lost(self) -> int:
        """Number of samples that were due and not received, as far as the received ones show."""

    async def __anext__(self) -> Any:
        """Return the next sample."""


class Stack(Protocol):
    """An open way to a gateway."""

    probe: Probe
    sizes: dict[Access, tuple[int, int]]
    """Bytes of the request and of the answer."""

    async def one(self, access: Access, address: int = ADDRESS) -> None:
        """Make one access, and wait for its answer; for a post, until it is sent."""

    async def burst(self, access: Access, count: int, address: int | None = None) -> None:
        """Make many accesses at once, and wait until the last is answered or, for posts, known to be executed.

        Args:
            access: kind of access.
            count: number of accesses.
            address: of all of them; None to cycle through `ADDRESSES`.
        """

    async def clocks(self, count: int) -> list[int]:
        """Make many reads of the probe at once; return their words."""

    def publishing(
        self, addresses: list[int], divisor: int, *, immediate: bool
    ) -> AbstractAsyncContextManager[Samples]:
        """Publish addresses, without timestamps, for the duration of the context."""

    def clock_of(self, sample: Any) -> int:
        """Return the first word of a sample."""


class FullStack:
    """The link: messages with IDs, each executed exactly once and in order."""

    def __init__(self, link: Link, probe: Probe) -> None:
        self.link, self.probe = link, probe
        info = link.gateway
        word, address, end = info.data_digits, info.address_digits, info.crc_bits // 4 + 1
        head = 1 + info.id_digits
        self.sizes: dict[Access, tuple[int, int]] = {
            "read": (head + address + end, head + word + end),
            "block": (head + 1 + address + 2 + end, head + 1 + BLOCK_WORDS * word + end),
            "write": (head + address + word + end, head + end),
            "post": (head + 1 + address + word + end, 0),
        }

    @classmethod
    @asynccontextmanager
    async def opened(cls, url: str, mode: Mode, probe: Probe, timeout: float) -> AsyncIterator[FullStack]:
        """Open a link to the virtual chip."""
        async with connect(url, timeout=timeout) as link:
            await link.send_immediate(of_the_link(mode))
            yield cls(link, probe)

    async def one(self, access: Access, address: int = ADDRESS) -> None:
        """Make one access."""
        if access == "read":
            await self.link.read(address)
        elif access == "block":
            await self.link.read_block(address, BLOCK_WORDS)
        elif access == "write":
            await self.link.write(address, WORD)
        else:
            await self.link.post(address, WORD)

    async def burst(self, access: Access, count: int, address: int | None = None) -> None:
        """Make many accesses at once."""
        addresses = np.arange(count) % ADDRESSES if address is None else np.full(count, address)
        if access == "read":
            await self.link.read_many(addresses)
        elif access == "write":
            await self.link.write_many(addresses, addresses)
        elif access == "post":
            await self.link.post_many(addresses, addresses)
            await self.link.fence()
        else:
            await asyncio.gather(*(self.link.read_block(ADDRESS, BLOCK_WORDS) for _ in range(count)))

    async def clocks(self, count: int) -> list[int]:
        """Read the probe many times at once."""
        return [int(word) for word in await self.link.read_many([PROBE] * count)]

    def publishing(
        self, addresses: list[int], divisor: int, *, immediate: bool
    ) -> AbstractAsyncContextManager[Samples]:
        """Subscribe to addresses."""
        return self.link.subscribe(addresses, divisor=divisor, immediate=immediate, timestamps=False, buffer=1 << 20)

    def clock_of(self, sample: Any) -> int:
        """Return the first word of a sample."""
        return int(sample.values[0])


class LowLevel(asyncio.Protocol):
    """The driver's transport alone, with prepared messages without IDs.

    The messages are those of the paper, except that the answer to a write has one more byte.
    """

    def __init__(self, probe: Probe) -> None:
        self.probe = probe
        self._loop = asyncio.get_running_loop()
        self._missing = 0
        self._kept: list[bytes] | None = None
        """Received bytes, if they are needed."""
        self._samples: _Frames | None = None
        self._arrived: asyncio.Future[None] = self._loop.create_future()
        self._ended: asyncio.Future[None] = self._loop.create_future()
        self._transport: asyncio.Transport
        read, words = len(checked(b"R%02X%08X" % (ADDRESS, WORD))), 8 * BLOCK_WORDS
        answers = {"read": read, "block": read - 8 + 1 + words, "write": len(checked(b"W%02X" % ADDRESS)), "post": 0}
        self.sizes: dict[Access, tuple[int, int]] = {
            access: (len(_request(access, ADDRESS)), answers[access]) for access in ACCESSES
        }

    @classmethod
    @asynccontextmanager
    async def opened(cls, url: str, mode: Mode, probe: Probe, timeout: float) -> AsyncIterator[LowLevel]:
        """Open the driver of the virtual chip."""
        from unity_link.transport.ft232h import with_libusb

        async with asyncio.timeout(timeout):
            stack = cls(probe)
            stack._transport = await with_libusb.connect(parse_url(url), stack)
        try:
            name = of_the_link(mode)
            request = checked(b"I%02X" % ("off", "always", "adaptive").index(name))
            await stack._exchange(request, len(request))
            await stack._transport.get_extra_info("send_immediate")(name)
            yield stack
        finally:
            stack._transport.close()
            await stack._ended

    async def one(self, access: Access, address: int = ADDRESS) -> None:
        """Make one access."""
        await self._exchange(_request(access, address), self.sizes[access][1])

    async def burst(self, access: Access, count: int, address: int | None = None) -> None:
        """Make many accesses at once; after posts, the answer to a read shows that they are executed."""
        requests = _request(access, ADDRESS if address is None else address) * count
        size = self.sizes[access][1] * count
        if access == "post":
            requests, size = requests + _request("read", ADDRESS), self.sizes["read"][1]
        await self._exchange(requests, size)

    async def clocks(self, count: int) -> list[int]:
        """Read the probe many times at once."""
        self._kept = []
        await self.burst("read", count, PROBE)
        text, self._kept = b"".join(self._kept), None
        return [int(line[3:11], 16) for line in text.splitlines()]

    @asynccontextmanager
    async def publishing(self, addresses: list[int], divisor: int, *, immediate: bool) -> AsyncIterator[Samples]:
        """Set a group and start it; stop it at the end."""
        flags = GroupFlag.PERIODIC | (GroupFlag.IMMEDIATE if immediate else GroupFlag(0))
        listed = b"".join(b"%02X" % address for address in addresses)
        await self._exchange(b"", 0)
        self._samples = frames = _Frames()
        try:
            for command in (
                b"GS%02X%02X%04X%02X" % (_GROUP, flags, divisor, len(addresses)) + listed,
                b"GN%02X" % _GROUP,
            ):
                self._transport.write(checked(command))
                answer = await frames.answered()
                assert answer.startswith(command[:4]), answer
            yield frames
            self._transport.write(checked(b"GX%02X" % _GROUP))
            await frames.answered()
        finally:
            self._samples = None

    def clock_of(self, sample: Any) -> int:
        """Return the first word of a sample."""
        return int(sample[5:13], 16)

    async def _exchange(self, request: bytes, answer_size: int) -> None:
        self._missing = answer_size
        self._arrived = self._loop.create_future()
        self._transport.write(request)
        if answer_size:
            await self._arrived

    # asyncio.Protocol

    def data_received(self, data: bytes) -> None:
        """Count the bytes, or store them."""
        if self._samples is not None:
            self._samples.add(data)
            return
        if self._kept is not None:
            self._kept.append(bytes(data))
        self._missing -= len(data)
        if self._missing <= 0 and not self._arrived.done():
            self._arrived.set_result(None)

    def connection_lost(self, exc: Exception | None) -> None:
        """End the connection; pending accesses end with the reason."""
        if exc is not None and not self._arrived.done():
            self._arrived.set_exception(exc)
        if not self._ended.done():
            self._ended.set_result(None)


class _Frames:
    """Samples as a small program reads them: divided at the line ends, with a check of their sequence numbers."""

    def __init__(self) -> None:
        self.lost = 0
        self._rest = b""
        self._frames: deque[bytes] = deque()
        self._next: int | None = None
        self._came: asyncio.Future[None] | None = None
        self._answers: asyncio.Queue[bytes] = asyncio.Queue()

    def add(self, data: bytes) -> None:
        """Divide received bytes into frames."""
        *frames, self._rest = (self._rest + data).split(b"\n")
        for frame in frames:
            if frame[:1] == b"P":
                sequence = int(frame[3:5], 16)
                if self._next is not None:
                    self.lost += (sequence - self._next) % 256
                self._next = sequence + 1
                self._frames.append(frame)
            else:
                self._answers.put_nowait(frame)
        if self._frames and self._came is not None and not self._came.done():
            self._came.set_result(None)

    async def answered(self) -> bytes:
        """Wait for the answer to a command."""
        return await self._answers.get()

    async def __anext__(self) -> bytes:
        """Return the next sample."""
        while not self._frames:
            self._came = asyncio.get_running_loop().create_future()
            await self._came
        return self._frames.popleft()


def _request(access: Access, address: int) -> bytes:
    bodies: dict[Access, bytes] = {
        "read": b"R%02X" % address,
        "block": b"RM%02X%02X" % (address, BLOCK_WORDS),
        "write": b"W%02X%08X" % (address, WORD),
        "post": b"WS%02X%08X" % (address, WORD),
    }
    return checked(bodies[access])
