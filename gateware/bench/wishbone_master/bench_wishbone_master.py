"""Bench: the Wishbone wrapper with classic and pipelined slaves of any speed."""

from __future__ import annotations

import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import NextTimeStep, ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


class _Slave:
    """Wishbone memory that counts the accesses it accepted, so that an access made twice is found."""

    def __init__(self, dut: SimHandleBase, rng: random.Random, pause: float) -> None:
        self.dut = dut
        self.memory: dict[int, int] = {}
        self.taken = 0
        self.failing: set[int] = set()
        self.sends_away = 0
        """Number of next accesses that are answered with `rty`."""
        self.away = 0.0
        """Share (0 to 1) of the other accesses that are answered with `rty`."""
        self.most_at_once = 0
        """Maximum number of accesses that were accepted but not answered."""
        self.silent = False
        self._rng, self._pause = rng, pause
        self._pipelined = bool(dut.pipelined.value)
        cocotb.start_soon(self._run_pipelined() if self._pipelined else self._run_classic())

    def _sometimes(self) -> bool:
        return self._rng.random() >= self._pause and not self.silent

    def _answer(self, address: int, word: int, write: int) -> None:
        dut = self.dut
        if self.sends_away or self._rng.random() < self.away:
            self.sends_away = max(0, self.sends_away - 1)
            dut.rty.value = 1
            return
        self.taken += 1
        failed = address in self.failing
        dut.ack.value, dut.err.value = int(not failed), int(failed)
        dut.dat_i.value = self.memory.get(address, 0)
        if write and not failed:
            self.memory[address] = word

    def _rest(self) -> None:
        self.dut.ack.value = self.dut.err.value = self.dut.rty.value = 0

    async def _run_classic(self) -> None:
        """Answer within the cycle, as a slave without registers does."""
        dut = self.dut
        while True:
            await ReadOnly()
            asked = dut.cyc.value == 1 and dut.stb.value == 1 and self._sometimes()
            access = (int(dut.adr.value), int(dut.dat_o.value), int(dut.we.value)) if asked else None
            await NextTimeStep()
            self._rest()
            if access is not None:
                self._answer(*access)
            await RisingEdge(dut.clk)
            self._rest()

    async def _run_pipelined(self) -> None:
        dut = self.dut
        taken: deque[tuple[int, int, int]] = deque()
        while True:
            stalls = not self._sometimes()
            dut.stall.value = int(stalls)
            self._rest()
            if taken and self._sometimes():
                self._answer(*taken.popleft())
            await RisingEdge(dut.clk)
            if dut.cyc.value == 0:
                taken.clear()
            elif dut.stb.value == 1 and not stalls:
                taken.append((int(dut.adr.value), int(dut.dat_o.value), int(dut.we.value)))
                self.most_at_once = max(self.most_at_once, len(taken))


async def _access(
    dut: SimHandleBase, address: int, word: int | None = None, most: int = 300
) -> tuple[int, bool] | None:
    dut.bus_request.value = 1
    dut.bus_write.value = int(word is not None)
    dut.bus_address.value = address
    dut.bus_write_data.value = word or 0
    result = None
    for _ in range(most):
        await RisingEdge(dut.clk)
        if dut.bus_done.value == 1:
            result = (int(dut.bus_read_data.value), dut.bus_error.value == 1)
            break
    dut.bus_request.value = 0
    await RisingEdge(dut.clk)
    return result


async def _read_ahead(dut: SimHandleBase, addresses: list[int]) -> list[tuple[int, bool]]:
    """Read words as the core does, up to four before the first answer; return each, and whether it failed."""
    dut.bus_lock.value = dut.bus_ahead.value = 1
    dut.bus_write.value = 0
    waiting, results, under_way, stands = deque(addresses), [], 0, False
    while len(results) < len(addresses):
        if not stands and waiting and under_way < 4:
            dut.bus_address.value = waiting.popleft()
            stands = True
        dut.bus_request.value = int(stands)
        await RisingEdge(dut.clk)
        taken, done = dut.bus_next.value == 1, dut.bus_done.value == 1
        stands = stands and not taken and not (done and not under_way)
        if done:
            results.append((int(dut.bus_read_data.value), dut.bus_error.value == 1))
        if done and not taken and not under_way:
            dut.bus_request.value = 0
            await RisingEdge(dut.clk)
        under_way = max(0, under_way + taken - done)
    dut.bus_request.value = dut.bus_lock.value = dut.bus_ahead.value = 0
    await RisingEdge(dut.clk)
    return results


async def _begin(dut: SimHandleBase, pause: float) -> _Slave:
    inputs = ("bus_request", "bus_write", "bus_lock", "bus_ahead", "bus_address", "bus_write_data", "dat_i")
    for name in (*inputs, "ack", "err", "rty", "stall"):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    return _Slave(dut, random.Random(8), pause)


@cocotb.test
async def each_access_is_made_once_and_read_back(dut: SimHandleBase) -> None:
    for pause in (0.0, 0.5):
        slave = await _begin(dut, pause)
        rng = random.Random(2)
        written: dict[int, int] = {}
        for count in range(100):
            address, word = rng.randrange(256), rng.getrandbits(32)
            assert await _access(dut, address, word) is not None
            written[address] = word
            other = rng.choice(list(written))
            assert await _access(dut, other) == (written[other], False)
            assert slave.taken == 2 * (count + 1)


@cocotb.test
async def errors_are_told(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.3)
    slave.failing = {7}
    for word in (None, 1):
        result = await _access(dut, 7, word)
        assert result is not None
        assert result[1]
    assert await _access(dut, 8, 1) is not None


@cocotb.test
async def an_access_that_was_given_up_does_not_disturb_the_next(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.3)
    await _access(dut, 1, 0x11)
    for most in range(1, 10):
        slave.silent = True
        assert await _access(dut, 2, most=most) is None
        slave.silent = False
        assert await _access(dut, 1) == (0x11, False)


@cocotb.test
async def an_access_that_is_sent_away_is_repeated_until_the_slave_takes_it(dut: SimHandleBase) -> None:
    for pause in (0.0, 0.5):
        slave = await _begin(dut, pause)
        for times in (1, 2, 9):
            slave.sends_away = times
            assert await _access(dut, times, 0x100 + times) is not None
            slave.sends_away = times
            assert await _access(dut, times) == (0x100 + times, False)
        assert slave.taken == 6


@cocotb.test
async def an_access_that_is_sent_away_for_ever_can_be_given_up(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.3)
    await _access(dut, 1, 0x11)
    for most in range(1, 20):
        slave.sends_away = 1000
        assert await _access(dut, 2, 0x22, most=most) is None
        slave.sends_away = 0
        assert await _access(dut, 1) == (0x11, False)
    assert 2 not in slave.memory


@cocotb.test
async def several_reads_get_their_own_words_in_order_also_where_some_are_sent_away(dut: SimHandleBase) -> None:
    pipelined = dut.pipelined.value == 1
    for pause, away in ((0.0, 0.0), (0.0, 0.3), (0.5, 0.0), (0.5, 0.3), (0.2, 0.7)):
        slave = await _begin(dut, pause)
        rng = random.Random(3)
        slave.memory = {address: rng.getrandbits(32) for address in range(256)}
        slave.away = away
        for _ in range(60):
            slave.failing = set(rng.sample(range(256), 20))
            addresses = [rng.randrange(256) for _ in range(rng.randrange(1, 12))]
            before = slave.taken
            read = await _read_ahead(dut, addresses)
            assert read == [(slave.memory[address], address in slave.failing) for address in addresses]
            assert slave.taken - before == len(addresses)
        assert slave.most_at_once > 1 or not pipelined or not pause


@cocotb.test
async def a_word_of_a_block_takes_a_cycle_in_a_pipeline(dut: SimHandleBase) -> None:
    await _begin(dut, 0.0)
    reading, cycles = cocotb.start_soon(_read_ahead(dut, list(range(100)))), 0
    while not reading.done():
        await RisingEdge(dut.clk)
        cycles += 1
    assert cycles <= (105 if dut.pipelined.value == 1 else 205)


@cocotb.test
async def another_master_may_have_the_bus_after_a_retry_but_not_in_a_transaction(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.0)
    for locked in (0, 1):
        dut.bus_lock.value = locked
        slave.sends_away = 3
        access, free = cocotb.start_soon(_access(dut, 5)), 0
        while not access.done():
            await ReadOnly()
            free += dut.bus_request.value == 1 and dut.cyc.value == 0
            await RisingEdge(dut.clk)
        assert free == (0 if locked else 3)
        dut.bus_lock.value = 0


@cocotb.test
async def cyc_stands_while_the_lock_does(dut: SimHandleBase) -> None:
    await _begin(dut, 0.0)
    dut.bus_lock.value = 1
    await RisingEdge(dut.clk)
    await ReadOnly()
    assert dut.cyc.value == 1
    assert dut.stb.value == 0
    await RisingEdge(dut.clk)
    dut.bus_lock.value = 0
    await ReadOnly()
