"""Bench: which client gets the bus, in which order, and the behaviour if the bus does not answer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import NextTimeStep, ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

BUS_ERROR, TIMEOUT = 4, 5


class _Slave:
    """Answers each access after some cycles with the inverted address; records accesses, their kinds, and the lock."""

    def __init__(self, dut: SimHandleBase, waits: int = 0) -> None:
        self.dut = dut
        self.waits = waits
        self.silent = False
        self.strays: set[int] = set()
        """Cycles after the end of an access in which the slave answers again, without an access."""
        self.failing: set[int] = set()
        self.accesses: list[tuple[int, int]] = []
        """Address, and 1 for a write, of each access."""
        self.unlocked_after: list[int] = []
        """Number of accesses that had been made whenever the lock fell."""
        cocotb.start_soon(self._run())

    async def _run(self) -> None:
        dut, waited, locked, idle = self.dut, 0, False, 0
        while True:
            await ReadOnly()
            asked = dut.bus_request.value == 1
            idle = 0 if asked else idle + 1
            strays = not asked and idle in self.strays
            answers = asked and waited >= self.waits and not self.silent
            address = int(dut.bus_address.value) if asked else 0
            write = dut.bus_write.value == 1
            if locked and dut.bus_lock.value == 0:
                self.unlocked_after.append(len(self.accesses))
            locked = dut.bus_lock.value == 1
            await NextTimeStep()
            dut.bus_done.value = int(answers or strays)
            dut.bus_error.value = int(address in self.failing)
            dut.bus_read_data.value = 0xEE if strays else address ^ 0xFF
            await RisingEdge(dut.clk)
            waited = 0 if answers or not asked else waited + 1
            if answers:
                self.accesses.append((address, int(write)))


async def _begin(dut: SimHandleBase, waits: int = 0) -> _Slave:
    for name in ("request", "request_write", "request_more", "request_exclusive", "request_address", "request_data"):
        getattr(dut, name).value = 0
    for name in (
        "request_kept",
        "kept_word",
        "sample",
        "sample_more",
        "sample_address",
        "bus_next",
        "bus_done",
        "bus_error",
        "bus_read_data",
    ):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    return _Slave(dut, waits)


async def _request(
    dut: SimHandleBase, addresses: list[int], *, write: bool = False, exclusive: bool = False
) -> list[int]:
    """Access addresses as one transaction; return the failure of each, up to the first one that is not 0."""
    failures = []
    dut.request.value = 1
    for index, address in enumerate(addresses):
        dut.request_address.value = address
        dut.request_write.value = write
        dut.request_exclusive.value = exclusive
        dut.request_more.value = index < len(addresses) - 1
        while True:
            await RisingEdge(dut.clk)
            # After its last access a client requests nothing until that access is done.
            if dut.request_granted.value == 1 and dut.request_more.value == 0:
                dut.request.value = 0
            if dut.request_done.value == 1:
                break
        failures.append(int(dut.failure.value))
        if failures[-1]:
            break
    dut.request.value = 0
    dut.request_more.value = 0
    return failures


async def _sample(dut: SimHandleBase, addresses: list[int], after: int = 0) -> list[int]:
    """Read addresses as one sample, beginning after some cycles; return the words."""
    for _ in range(after):
        await RisingEdge(dut.clk)
    words = []
    dut.sample.value = 1
    for index, address in enumerate(addresses):
        dut.sample_address.value = address
        dut.sample_more.value = index < len(addresses) - 1
        while True:
            await RisingEdge(dut.clk)
            if dut.sample_granted.value == 1 and dut.sample_more.value == 0:
                dut.sample.value = 0
            if dut.sample_done.value == 1:
                break
        words.append(int(dut.read_data.value))
    dut.sample.value = 0
    return words


@cocotb.test
async def an_access_without_wait_states_takes_three_cycles(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    dut.request_address.value = 5
    dut.request.value = 1
    for _ in range(30):
        await RisingEdge(dut.clk)
    dut.request.value = 0
    assert len(slave.accesses) == 10


@cocotb.test
async def a_sample_comes_between_the_words_of_a_read_and_is_not_interrupted(dut: SimHandleBase) -> None:
    slave = await _begin(dut, waits=2)
    sampling = cocotb.start_soon(_sample(dut, [0x80, 0x81, 0x82], after=8))
    assert await _request(dut, list(range(6))) == [0] * 6
    assert await sampling == [0x7F, 0x7E, 0x7D]
    order = [address for address, _ in slave.accesses]
    first = order.index(0x80)
    assert 0 < first < 4
    assert order[first : first + 3] == [0x80, 0x81, 0x82]
    # The lock of the block was asserted all the time.
    assert slave.unlocked_after == [8]


@cocotb.test
async def the_instant_of_a_sample_is_in_front_of_its_first_access(dut: SimHandleBase) -> None:
    await _begin(dut, waits=2)
    reading = cocotb.start_soon(_request(dut, list(range(4))))
    sampling = cocotb.start_soon(_sample(dut, [0x80, 0x81, 0x82], after=3))
    levels = []
    while not (sampling.done() and reading.done()):
        await ReadOnly()
        of_sample = dut.bus_request.value == 1 and int(dut.bus_address.value) >= 0x80
        levels.append((dut.sample_strobe.value == 1, dut.sample_access.value == 1, of_sample))
        await RisingEdge(dut.clk)
    instant = levels.index((True, False, False))
    last = max(cycle for cycle, (_, _, of_sample) in enumerate(levels) if of_sample)
    assert [strobe for strobe, _, _ in levels].count(True) == 1
    assert levels[instant + 1] == (False, True, True)
    assert [access for _, access, _ in levels] == [instant < cycle <= last for cycle in range(len(levels))]


@cocotb.test
async def a_sample_waits_for_an_exclusive_transaction(dut: SimHandleBase) -> None:
    slave = await _begin(dut, waits=2)
    sampling = cocotb.start_soon(_sample(dut, [0x80], after=8))
    assert await _request(dut, list(range(6)), write=True, exclusive=True) == [0] * 6
    await sampling
    assert slave.accesses == [*((address, 1) for address in range(6)), (0x80, 0)]


@cocotb.test
async def a_silent_bus_is_given_up_and_the_next_access_works(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    slave.silent = True
    cycles = 0

    async def count() -> None:
        nonlocal cycles
        while True:
            await RisingEdge(dut.clk)
            cycles += dut.bus_request.value == 1

    cocotb.start_soon(count())
    assert await _request(dut, [1, 2, 3], exclusive=True) == [TIMEOUT]
    assert cycles == int(dut.timeout.value)
    await ReadOnly()
    assert dut.bus_lock.value == 0
    await RisingEdge(dut.clk)
    slave.silent = False
    assert await _sample(dut, [9]) == [0xF6]
    assert await _request(dut, [1, 2, 3]) == [0, 0, 0]


@cocotb.test
async def an_answer_that_comes_late_is_for_nobody(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    timeout = int(dut.timeout.value)
    for late in range(1, timeout + 2):
        slave.silent = True
        assert await _request(dut, [1], write=bool(late % 2)) == [TIMEOUT]
        slave.silent = False
        slave.strays = {late}
        if late % 3:
            assert await _request(dut, [2]) == [0]
            assert dut.read_data.value == 0xFD
        else:
            assert await _sample(dut, [2]) == [0xFD]
        assert slave.accesses.pop() == (2, 0)


@cocotb.test
async def the_bus_rests_after_a_timeout_and_not_after_an_answer(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    timeout = int(dut.timeout.value)
    dut.request.value = 1
    idle, asked, gaps = 0, False, []
    for cycle in range(8 * timeout):
        slave.silent = cycle < 4 * timeout
        await RisingEdge(dut.clk)
        if dut.bus_request.value == 1 and not asked:
            gaps.append(idle)
        asked = dut.bus_request.value == 1
        idle = 0 if asked else idle + 1
    assert gaps[1:3] == [timeout + 2] * 2
    assert set(gaps[3:]) == {2}


@cocotb.test
async def an_error_ends_the_transaction_and_frees_the_bus(dut: SimHandleBase) -> None:
    slave = await _begin(dut, waits=1)
    slave.failing = {2}
    assert await _request(dut, [1, 2, 3], write=True, exclusive=True) == [0, BUS_ERROR]
    assert await _sample(dut, [7]) == [0xF8]
    assert slave.accesses == [(1, 1), (2, 1), (7, 0)]


@cocotb.test
async def a_reset_frees_the_bus(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    slave.silent = True
    task = cocotb.start_soon(_request(dut, [1, 2], exclusive=True))
    for _ in range(5):
        await RisingEdge(dut.clk)
    task.cancel()
    dut.request.value = 0
    dut.rst.value = 1
    await RisingEdge(dut.clk)
    dut.rst.value = 0
    await RisingEdge(dut.clk)
    await ReadOnly()
    assert dut.bus_request.value == 0
    assert dut.bus_lock.value == 0
    await RisingEdge(dut.clk)
    slave.silent = False
    assert await _sample(dut, [7]) == [0xF8]


@cocotb.test
async def a_kept_word_is_read_while_the_bus_sees_nothing(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    slave.failing = {5}
    dut.request_kept.value, dut.kept_word.value = 1, 0x77
    assert await _request(dut, [5]) == [0]
    assert (slave.accesses, int(dut.read_data.value)) == ([], 0x77)
    dut.request_kept.value = 0
    assert await _request(dut, [6]) == [0]
    assert (slave.accesses, int(dut.read_data.value)) == ([(6, 0)], 6 ^ 0xFF)
