"""A program on a line that another program uses, in this process or in its own."""

from __future__ import annotations

import asyncio
import random
from typing import TYPE_CHECKING

import unity_link
from unity_link.transport.channel_transport import LoopWatcher, make_transport
from unity_link.transport.serial import PortChannel, SerialPort

if TYPE_CHECKING:
    from unity_link.transport import Medium

WORDS = {address: 0x0100_0001 * address + 7 for address in range(64)}
"""Words that stay constant, by address; each program reads half of them."""
ADDRESSES = (64, 65)
"""Address to which each of the two programs writes."""
SIDE_BY_SIDE = 24


class UnlockedPort:
    """A serial port as opened by a program that neither locks it nor checks locks."""

    def __init__(self, path: str) -> None:
        self._path = path

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        port = SerialPort(self._path, timeout=0, write_timeout=0)
        port.keep_settings()
        return make_transport(LoopWatcher(), PortChannel(port), protocol)


class Program:
    """Reads its half of the words, writes increasing numbers to its address, and subscribes to one of its words."""

    def __init__(self, link: unity_link.Link, half: int, draw: random.Random) -> None:
        self.link, self._draw = link, draw
        self._words = range(half * 32, half * 32 + 32)
        self._address = ADDRESSES[half]
        self.asked: list[int] = []
        self.acknowledged: set[int] = set()

    async def ask_side_by_side(self) -> None:
        """Make a random number of requests at once; raise the error of one that failed."""
        count = self._draw.randint(1, SIDE_BY_SIDE)
        done = await asyncio.gather(*(self._ask() for _ in range(count)), return_exceptions=True)
        for error in done:
            if error is not None:
                raise error

    async def _ask(self) -> None:
        if self._draw.random() < 0.5:
            address = self._draw.choice(self._words)
            assert await self.link.read(address) == WORDS[address]
            return
        number = len(self.asked) + 1
        self.asked.append(number)
        if self._draw.random() < 0.7:
            await self.link.write(self._address, number)
            self.acknowledged.add(number)
        else:
            await self.link.post(self._address, number)

    async def subscribe(self) -> None:
        address = self._words[0]
        async with self.link.subscribe(address, rate_hz=500) as samples:
            async for sample in samples:
                assert list(sample.values) == [WORDS[address]]


async def _run(target: str | Medium, seed: int) -> Program:
    async with unity_link.connect(target) as link:
        program = Program(link, 1, random.Random(seed))
        samples = asyncio.create_task(program.subscribe())
        for _ in range(5):
            await program.ask_side_by_side()
        samples.cancel()
        await asyncio.wait([samples])
        assert samples.cancelled()
    return program


def run_alone(url: str, seed: int) -> tuple[list[int], set[int]]:
    """Run a program that ignores locks; return the numbers that it wrote, and the numbers that were acknowledged."""
    target = UnlockedPort(url.removeprefix("serial:")) if url.startswith("serial:") else url
    program = asyncio.run(_run(target, seed))
    return program.asked, program.acknowledged
