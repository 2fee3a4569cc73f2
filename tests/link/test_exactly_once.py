"""Exactly once, in order: the host on each kind of gateway, over lines that lose, damage and duplicate bytes.

All tests run on simulated time, so a seed takes milliseconds and a campaign runs thousands of them. The bus behind the
gateway records each access, and each write has a word of its own. Most seeds use a CRC of 32 bits: a CRC of 8 bits
passes one damaged frame in 256, so over thousands of seeds some damage would inevitably go unnoticed. The seeds that
run with a CRC of 8 or 16 bits are fixed, and in them the CRC finds all damage.
"""

from __future__ import annotations

import asyncio
import random
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.makers import CRC_32, SHORT, Maker
from support.recorded_bus import RecordedBus
from support.simulated_time import run_simulated
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from unity_link import Link
    from unity_link.virtual import BareGateway, Gateway

CALLS = 30
BATCH = 40
ADDRESSES = 16


class Program:
    """A seeded program of calls on one link, and the writes that the bus must have recorded."""

    def __init__(self, link: Link, seed: int) -> None:
        self._link = link
        self._random = random.Random(seed)
        self._value = 0
        self.expected: list[tuple[int, int]] = []
        """Writes in the order of the calls, except those of batches, which are interleaved with other calls."""
        self.batches: list[list[tuple[int, int]]] = []
        self._calls: list[Callable[[], Coroutine[Any, Any, None]]] = [
            self._write,
            self._write,
            self._post,
            self._post,
            self._write_block,
            self._write_queue,
            self._write_masked,
            self._read,
            self._read_block,
            self._write_many,
            self._fence,
        ]

    async def run(self) -> None:
        """Make the calls one after another; at random, wait until all pending calls have returned."""
        tasks: list[asyncio.Task[None]] = []
        for _ in range(CALLS):
            tasks.append(asyncio.create_task(self._random.choice(self._calls)()))
            if self._random.random() < 0.3:
                await asyncio.gather(*tasks)
                tasks.clear()
        await asyncio.gather(*tasks)
        await self._link.fence()

    def _unique(self, address: int) -> int:
        self._value += 1
        self.expected.append((address, self._value))
        return self._value

    async def _write(self) -> None:
        address = self._random.randrange(ADDRESSES)
        await self._link.write(address, self._unique(address))

    async def _post(self) -> None:
        address = self._random.randrange(ADDRESSES)
        await self._link.post(address, self._unique(address))

    async def _write_block(self) -> None:
        count = self._random.randint(1, 6)
        address = self._random.randrange(ADDRESSES - count)
        await self._link.write_block(address, [self._unique(address + index) for index in range(count)])

    async def _write_queue(self) -> None:
        address = self._random.randrange(ADDRESSES)
        await self._link.write_queue(address, [self._unique(address) for _ in range(self._random.randint(1, 4))])

    async def _write_masked(self) -> None:
        address = self._random.randrange(ADDRESSES)
        value = self._unique(address)
        assert await self._link.write_masked(address, value, 0xFFFFFFFF) < value

    async def _read(self) -> None:
        assert await self._link.read(self._random.randrange(ADDRESSES)) <= self._value

    async def _read_block(self) -> None:
        words = await self._link.read_block(0, self._random.randint(1, ADDRESSES))
        assert words.max() <= self._value

    async def _write_many(self) -> None:
        addresses = [ADDRESSES + self._random.randrange(ADDRESSES) for _ in range(self._random.randint(1, BATCH))]
        batch = [(address, self._unique(address)) for address in addresses]
        del self.expected[-len(batch) :]
        self.batches.append(batch)
        await self._link.write_many([address for address, _ in batch], [value for _, value in batch])

    async def _fence(self) -> None:
        await self._link.fence()


def wait_for_nobody(gateway: Gateway) -> Gateway:
    return gateway


async def run_program(
    seed: int, bare: BareGateway, chances: dict[str, float], line: Callable[[BareGateway], Gateway] = wait_for_nobody
) -> Program:
    """Run the program of a seed, and compare the accesses that the bus recorded with the calls."""
    bus = RecordedBus(bare)
    noisy = NoisyLine(line(bare), Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))
    async with unity_link.connect(noisy, timeout=3600) as link:
        program = Program(link, seed)
        await program.run()
    assert [write for write in bus.writes if write[0] < ADDRESSES] == program.expected
    batched = [write for write in bus.writes if write[0] >= ADDRESSES]
    assert sorted(batched, key=lambda write: write[1]) == [write for batch in program.batches for write in batch]
    position = {value: index for index, (_, value) in enumerate(batched)}
    for batch in program.batches:
        places = [position[value] for _, value in batch]
        assert places == sorted(places)
    return program


def spread(total: float) -> dict[str, float]:
    """Return the probabilities that a byte is lost, damaged or duplicated; they add up to `total`."""
    return {"loss": total / 3, "flip": total / 3, "double": total / 3}


def small_fifo(bare: BareGateway) -> Gateway:
    """Put a slow line before a gateway, whose receive FIFO overflows unless the host counts its bytes."""
    return SlowLine(bare, bytes_per_second=100_000)


WITHOUT_FLOW_CONTROL = {
    **CRC_32,
    "features": GatewayInfo().features & ~Feature.FLOW_CONTROL,
    "receive_fifo_bytes": 64,
    "transmit_fifo_bytes": 64,
}
SHORT_IDS = {**CRC_32, "id_digits": 2}
LONG_IDS = {**CRC_32, "id_digits": 3}
SEEDS = 10
RATES = pytest.mark.parametrize("total", [0.0, 0.003, 0.01], ids="{:.1%}".format)


@pytest.mark.slow
@RATES
@pytest.mark.parametrize("fields", [SHORT_IDS, LONG_IDS], ids=["short IDs", "long IDs"])
def test_each_write_is_executed_exactly_once_and_in_order(
    make_bare: Maker, fields: dict[str, int], total: float
) -> None:
    for seed in range(SEEDS):
        run_simulated(run_program(seed, make_bare(**fields), spread(total)))


@pytest.mark.slow
@RATES
def test_writes_are_executed_once_through_a_small_receive_fifo(make_bare: Maker, total: float) -> None:
    for seed in range(SEEDS):
        run_simulated(run_program(seed, make_bare(**WITHOUT_FLOW_CONTROL), spread(total), small_fifo))


@pytest.mark.slow
@RATES
@pytest.mark.parametrize("fields", [SHORT, {}], ids=["8", "16"])
def test_writes_are_executed_once_with_a_short_crc_that_finds_the_damage(
    make_bare: Maker, fields: dict[str, int], total: float
) -> None:
    for seed in range(SEEDS):
        run_simulated(run_program(seed, make_bare(**fields), spread(total)))


@pytest.mark.campaign
@pytest.mark.parametrize("kind", ["loss", "flip", "double", "all"])
def test_thousands_of_seeds_are_executed_exactly_once_and_in_order(make_bare: Maker, kind: str) -> None:
    for seed in range(1000, 1500):
        chances = spread(0.01) if kind == "all" else {kind: 0.006}
        run_simulated(run_program(seed, make_bare(**CRC_32), chances))
        if seed % 4 == 0:
            run_simulated(run_program(seed, make_bare(**WITHOUT_FLOW_CONTROL), chances, small_fifo))


def test_a_gateway_that_executes_twice_is_detected() -> None:
    """A gateway that forgets the next expected ID executes requests twice, and the comparison finds it."""

    class Forgetful(VirtualGateway):
        def receive(self, data: bytes, now: float) -> bytes:
            if b"h" in data:
                self._sequence.expected = self.expected - 1 & 16**self.info.id_digits - 1
            return super().receive(data, now)

    async def all_seeds() -> None:
        for seed in range(20):
            forgetful = Forgetful(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7))
            await run_program(seed, forgetful, spread(0.003))

    with pytest.raises((AssertionError, unity_link.UnityLinkError)):
        run_simulated(all_seeds())
