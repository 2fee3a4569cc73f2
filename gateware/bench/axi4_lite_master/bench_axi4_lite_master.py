"""Bench: the AXI4-Lite wrapper with a slave that accepts each channel at random times."""

from __future__ import annotations

import random
from types import SimpleNamespace
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

SLVERR = 2
TO_SLAVE = ("awaddr", "awvalid", "wdata", "wstrb", "wvalid", "bready", "araddr", "arvalid", "rready")
FROM_SLAVE = ("awready", "wready", "bresp", "bvalid", "arready", "rdata", "rresp", "rvalid")


class Slave:
    """AXI4-Lite memory that checks the rules of its channels: a valid transfer stays valid until it is accepted.

    Args:
        dut: the master.
        pause: probability (0 to 1) that a channel is not ready.
        prefix: of the names of its pins.
    """

    def __init__(self, dut: SimHandleBase, pause: float, prefix: str = "") -> None:
        pins = {name: getattr(dut, prefix + name) for name in (*TO_SLAVE, *FROM_SLAVE)}
        self.dut = SimpleNamespace(clk=dut.clk, **pins)
        self.memory: dict[int, int] = {}
        self.failing: set[int] = set()
        self.pause = pause
        self.silent = False
        self._rng = random.Random(6)
        self._write_address: int | None = None
        self._write_data: int | None = None
        self._read_address: int | None = None
        self._held: dict[str, tuple[int, ...]] = {}
        self._running = cocotb.start_soon(self._run())

    def end(self) -> None:
        """Leave the bus, as at a reset of both ends."""
        self._running.cancel()

    def _sometimes(self) -> int:
        return int(self._rng.random() >= self.pause and not self.silent)

    async def _run(self) -> None:
        while True:
            self._offer()
            await RisingEdge(self.dut.clk)
            self._check_what_is_held()
            self._take()

    def _offer(self) -> None:
        """Set the ready signals, and answer accepted accesses, at random times."""
        dut = self.dut
        dut.awready.value = self._sometimes() if self._write_address is None else 0
        dut.wready.value = self._sometimes() if self._write_data is None else 0
        dut.arready.value = self._sometimes() if self._read_address is None else 0
        has_write = self._write_address is not None and self._write_data is not None
        if has_write and dut.bvalid.value == 0 and self._sometimes():
            dut.bvalid.value = 1
            dut.bresp.value = SLVERR if self._write_address in self.failing else 0
        if self._read_address is not None and dut.rvalid.value == 0 and self._sometimes():
            dut.rvalid.value = 1
            dut.rdata.value = self.memory.get(self._read_address, 0)
            dut.rresp.value = SLVERR if self._read_address in self.failing else 0

    def _check_what_is_held(self) -> None:
        dut = self.dut
        for name, ready, payload in (
            ("awvalid", dut.awready, (dut.awaddr,)),
            ("wvalid", dut.wready, (dut.wdata, dut.wstrb)),
            ("arvalid", dut.arready, (dut.araddr,)),
        ):
            values = tuple(int(signal.value) for signal in payload)
            valid = getattr(dut, name).value == 1
            if name in self._held:
                assert valid, f"{name} was taken back"
                assert values == self._held.pop(name)
            if valid and ready.value == 0:
                self._held[name] = values

    def _take(self) -> None:
        dut = self.dut
        if dut.awvalid.value == 1 and dut.awready.value == 1:
            self._write_address = int(dut.awaddr.value)
        if dut.wvalid.value == 1 and dut.wready.value == 1:
            self._write_data = int(dut.wdata.value)
        if dut.arvalid.value == 1 and dut.arready.value == 1:
            self._read_address = int(dut.araddr.value)
        if dut.bvalid.value == 1 and dut.bready.value == 1:
            assert self._write_address is not None
            if self._write_address not in self.failing:
                self.memory[self._write_address] = self._write_data or 0
            self._write_address = self._write_data = None
            dut.bvalid.value = 0
        if dut.rvalid.value == 1 and dut.rready.value == 1:
            self._read_address = None
            dut.rvalid.value = 0


async def _begin(dut: SimHandleBase, pause: float = 0.0) -> Slave:
    for name in ("bus_request", "bus_write", "bus_address", "bus_write_data", *FROM_SLAVE):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    return Slave(dut, pause)


async def _access(
    dut: SimHandleBase, address: int, word: int | None = None, most: int = 200
) -> tuple[int, bool] | None:
    """Access one word as the core does; return the word read and whether it failed, or None if it was given up."""
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
    assert dut.bus_done.value == 0
    return result


@cocotb.test
async def words_are_written_and_read_at_byte_addresses(dut: SimHandleBase) -> None:
    for pause in (0.0, 0.6):
        slave = await _begin(dut, pause)
        width = len(dut.wdata) // 8
        for address in (0, 1, 0x7F, 0xFF):
            written = await _access(dut, address, 0x1000 + address)
            assert written is not None
            assert not written[1]
            assert slave.memory[address * width] == 0x1000 + address
            assert await _access(dut, address) == (0x1000 + address, False)


@cocotb.test
async def slave_errors_are_told(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.3)
    slave.failing = {0x10 * len(dut.wdata) // 8}
    for word in (None, 5):
        result = await _access(dut, 0x10, word)
        assert result is not None
        assert result[1]


@cocotb.test
async def an_access_that_was_given_up_is_seen_through_and_its_answer_thrown_away(dut: SimHandleBase) -> None:
    slave = await _begin(dut, 0.3)
    await _access(dut, 1, 0x11)
    for give_up_after in range(1, 12):
        slave.silent = True
        assert await _access(dut, 1, most=give_up_after) is None
        slave.silent = False
        await _access(dut, 2, 0x22)
        assert await _access(dut, 2) == (0x22, False)
        assert await _access(dut, 1) == (0x11, False)


@cocotb.test
async def a_slave_that_never_answers_lets_every_access_time_out(dut: SimHandleBase) -> None:
    slave = await _begin(dut)
    slave.silent = True
    for _ in range(3):
        assert await _access(dut, 1, most=30) is None
