"""pymodbus in the races, with both framings."""

from __future__ import annotations

import asyncio
import statistics
import time
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

from benchmarks.expected import ADDRESS, expect
from benchmarks.measure import seconds
from benchmarks.peers.race import BLOCK, Contender, Size
from benchmarks.responder import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

_AT_ONCE = 256
_WORDS = 62
"""Words of a block request: it has up to 125 registers of 16 bits."""
_HALF = BLOCK // 2
"""Words of half a block, because there are 65,536 registers of 16 bits."""


class Modbus:
    """pymodbus on a pseudo-terminal with RTU frames, or on TCP.

    Args:
        name: of the contender.
        place: path of the pseudo-terminal, or the port.
        size: amount of work.
    """

    def __init__(self, name: str, place: str | int, size: Size) -> None:
        self._name = name
        self._place = place
        self._size = size

    def lone(self, beside: str) -> Contender:
        """Return the contender that reads one word after the other."""
        return Contender(f"{self._name}, `await client.read_holding_registers`", self._read_alone, beside)

    def gathered(self, beside: str) -> Contender:
        """Return the contender that reads many words."""
        return Contender(f"{self._name}, `gather` of 256", self._read_gathered, beside)

    def block(self, beside: str) -> Contender:
        """Return the contender that reads a block."""
        overhead = 9 if isinstance(self._place, int) else 5
        wire = (4 * _WORDS + overhead) / _WORDS
        return Contender(f"{self._name}, 62 words at a time", self._read_block, beside, wire)

    @asynccontextmanager
    async def _client(self) -> AsyncIterator[Any]:
        from pymodbus import FramerType
        from pymodbus.client import AsyncModbusSerialClient, AsyncModbusTcpClient

        if isinstance(self._place, int):
            client = AsyncModbusTcpClient(LOOPBACK, port=self._place)
        else:
            client = AsyncModbusSerialClient(self._place, framer=FramerType.RTU, baudrate=115_200)
        await client.connect()
        expect(await _read(client, ADDRESS), [0x0A0A, 0x0A0A])
        try:
            yield client
        finally:
            client.close()

    def _read_alone(self) -> float:
        async def work() -> float:
            async with self._client() as client:
                times = []
                for _ in range(self._size.lone):
                    start = time.perf_counter()
                    await _read(client, ADDRESS)
                    times.append(time.perf_counter() - start)
                return statistics.median(times)

        return asyncio.run(work())

    def _read_gathered(self) -> float:
        rounds = max(1, self._size.lone // _AT_ONCE)

        async def work() -> float:
            async with self._client() as client:

                async def gathered() -> None:
                    for _ in range(rounds):
                        await asyncio.gather(*[_read(client, ADDRESS) for _ in range(_AT_ONCE)])

                return await seconds(gathered()) / (rounds * _AT_ONCE)

        return asyncio.run(work())

    def _read_block(self) -> float:
        async def work() -> float:
            async with self._client() as client:

                async def block() -> None:
                    for first in range(0, _HALF, _WORDS):
                        await _read(client, first, min(_WORDS, _HALF - first))

                return await seconds(block()) / _HALF

        return asyncio.run(work())


async def _read(client: Any, address: int, words: int = 1) -> list[int]:
    answer = await client.read_holding_registers(2 * address, count=2 * words, device_id=1)
    registers: list[int] = answer.registers
    return registers
