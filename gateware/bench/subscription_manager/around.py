"""The surroundings of the subscription manager: operations, the bus master, the sample ring.

One task simulates them all, one cycle at a time; outputs that are combinational in the gateware change within the
cycle.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import ClockCycles, NextTimeStep, ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from collections.abc import Callable

    from cocotb.handle import SimHandleBase

PERIODIC, TRIGGER, IMMEDIATE, STAMP, ON_CHANGE, PLAIN = 1, 2, 4, 8, 16, 32
OPERATIONS = {"set": 0, "start": 1, "stop": 2, "publish": 3, "stop all": 4}


class Sample(NamedTuple):
    """A sample that was committed to the ring."""

    group: int
    sequence: int
    stamp: int | None
    words: list[int]
    plain: bool
    immediate: bool
    epoch: int
    cycle: int
    """Cycle in which its first access was granted."""


class Around:
    """Simulates the surroundings of the manager, and stores the samples that were committed."""

    def __init__(self, dut: SimHandleBase, *, slow: float = 0.0) -> None:
        self.dut = dut
        self.samples: list[Sample] = []
        self.read: Callable[[int], int] = lambda address: address + 1
        """Function that returns the word read at an address."""
        self.failing: set[int] = set()
        self.waits = 0
        """Wait states of the bus."""
        self.room = 511
        self.cycle = 0
        self.slow = slow
        self.bits = int(dut.data_bits.value)
        self._digit_bits = 4 * -(-self.bits // 4)
        self._rng = random.Random(2)
        self._trial: list[int] = []
        self._begun = 0

    async def begin(self) -> None:
        """Reset, and start the simulation of the surroundings."""
        dut = self.dut
        for name in ("trigger", "group_request", "group_operation", "group_number", "group_flags", "group_divisor"):
            getattr(dut, name).value = 0
        for name in ("group_count", "list_write", "list_index", "list_address", "access_granted", "access_done"):
            getattr(dut, name).value = 0
        dut.access_failure.value = dut.access_read_data.value = dut.epoch.value = 0
        dut.ring_room.value = self.room
        await start(dut.clk, dut.rst)
        cocotb.start_soon(self._run())

    async def operate(self, operation: str, group: int = 0) -> None:
        """Request an operation until it is done."""
        dut = self.dut
        dut.group_number.value, dut.group_operation.value = group, OPERATIONS[operation]
        dut.group_request.value = 1
        for _ in range(20_000):
            await ReadOnly()
            done = dut.group_done.value == 1
            await RisingEdge(dut.clk)
            if done:
                dut.group_request.value = 0
                await RisingEdge(dut.clk)
                return
        raise AssertionError(f"{operation} of group {group} was not done")

    async def set(self, group: int, flags: int, addresses: list[int], divisor: int = 1) -> None:
        """Do the operations of GS."""
        dut = self.dut
        await self.operate("stop", group)
        dut.list_write.value = 1
        for index, address in enumerate(addresses):
            dut.list_index.value, dut.list_address.value = index, address
            await RisingEdge(dut.clk)
        dut.list_write.value = 0
        dut.group_flags.value, dut.group_divisor.value, dut.group_count.value = flags, divisor, len(addresses)
        await self.operate("set", group)

    async def take(self, cycles: int) -> list[Sample]:
        """Simulate cycles, and return the samples since the last call."""
        await ClockCycles(self.dut.clk, cycles)
        samples, self.samples = self.samples, []
        return samples

    async def next_sample(self) -> Sample:
        """Wait for a sample and return it; discard those before."""
        self.samples = []
        while not self.samples:
            await RisingEdge(self.dut.clk)
        return self.samples.pop()

    async def _run(self) -> None:
        dut, rng = self.dut, self._rng
        address: int | None = None
        waits = 0
        while True:
            dut.ring_room.value = self.room
            await ReadOnly()
            granted = address is None and dut.access_request.value == 1 and rng.random() >= self.slow
            told = address is not None and waits == 0
            await NextTimeStep()
            dut.access_granted.value, dut.access_done.value = granted, told
            if told:
                dut.access_failure.value = 4 * (address in self.failing)
                dut.access_read_data.value = self.read(address) & (1 << self.bits) - 1
            await ReadOnly()
            self._note(granted=granted)
            if granted:
                address = int(dut.access_address.value)
                # Grant and report take a cycle each, as in the bus master.
                waits = 1 + self.waits + (rng.randrange(5) if self.slow else 0)
            elif told:
                address = None
            elif address is not None:
                waits -= 1
            if dut.rst.value == 1:
                address = None
                self._trial = []
            await RisingEdge(dut.clk)
            self.cycle += 1
            dut.access_granted.value = dut.access_done.value = 0

    def _note(self, *, granted: bool) -> None:
        dut = self.dut
        if dut.ring_write.value == 1:
            self._trial.append(int(dut.ring_data.value))
            if len(self._trial) == 1:
                self._begun = 0
        if granted and not self._begun:
            self._begun = self.cycle
        if dut.ring_commit.value == 1:
            self.samples.append(self._laid_out(self._trial))
        if dut.ring_commit.value == 1 or dut.ring_rollback.value == 1:
            self._trial = []

    def _laid_out(self, ring: list[int]) -> Sample:
        """Return the sample that the words of the ring contain, read as by the frame writer."""
        top = len(self.dut.ring_data)
        header, rest = ring[0] >> top - 32, ring[1:]
        assert header >> 7 & 0x1FF == len(ring)
        stamp = rest.pop(0) >> top - 32 if header >> 6 & 1 else None
        words = [word >> top - self._digit_bits for word in rest]
        flags = bool(header >> 5 & 1), bool(header >> 4 & 1)
        return Sample(header >> 24, header >> 16 & 0xFF, stamp, words, *flags, header >> 3 & 1, self._begun)
