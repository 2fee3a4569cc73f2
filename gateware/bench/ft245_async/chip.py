"""Model of the asynchronous FT245 FIFO according to its datasheet (FT232H, FT_000288, section 4.5, table 4.2).

The chip checks every required interval at our pins, lengthened by the skew for which the gateware was built. It uses
every freedom that the datasheet permits: its own delays are random within the limits, its data bus is undefined except
while it must be valid, and its flags return after the minimum time or any longer one.
"""

from __future__ import annotations

import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import Event, FallingEdge, RisingEdge, Timer
from cocotb.types import LogicArray
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

T1, T2, T3, T4 = (1, 14), 49, (1, 14), 30
T6, T7, T8, T9, T10 = (1, 14), 49, 5, 5, 30
SIWU_WIDTH = 250
_UNDEFINED = LogicArray("XXXXXXXX")


class AsyncChip:
    """An FT232H at the pins of `ul_ft245_async`; a violated interval raises an AssertionError in the simulation."""

    def __init__(self, dut: SimHandleBase, *, most_pause_ns: int = 0, seed: int = 1) -> None:
        """Store the entity, and the maximum time in ns for which a flag stays inactive above the datasheet's limit."""
        self._dut = dut
        self._rng = random.Random(seed)
        self._skew = int(dut.skew_ns.value)
        self.most_pause_ns = most_pause_ns
        self.to_gateware: deque[int] = deque()
        self.from_gateware: list[int] = []
        self.flushed_after: list[int] = []
        self.write_times: list[float] = []
        self._more = Event()
        self._data_changed = -1e9
        self._read_ended = -1e9
        dut.rxf_n.value = 1
        dut.txe_n.value = 1
        dut.data_in.value = _UNDEFINED
        self._tasks = [
            cocotb.start_soon(coroutine)
            for coroutine in (
                self._reads(),
                self._writes(),
                self._siwu(),
                self._watch_data(),
                self._watch_output_enable(),
                self._watch_read_strobe(),
                self._watch_write_strobe(),
            )
        ]

    def stop(self) -> None:
        """Leave the pins as they are and stop checking."""
        for task in self._tasks:
            task.cancel()

    def send(self, data: bytes) -> None:
        """Pass the chip bytes for the gateware, as if they came from the PC."""
        self.to_gateware.extend(data)
        self._more.set()

    async def _reads(self) -> None:
        dut = self._dut
        while True:
            while not self.to_gateware:
                self._more.clear()
                await self._more.wait()
            dut.rxf_n.value = 0
            await FallingEdge(dut.rd_n)
            fell = get_sim_time("ns")
            assert int(dut.data_oe.value) == 0, "the gateware drives the bus while it reads"
            valid = self._rng.randint(*T3) + self._rng.randint(0, self._skew)
            await Timer(valid, unit="ns")
            dut.data_in.value = self.to_gateware.popleft()
            await RisingEdge(dut.rd_n)
            self._read_ended = get_sim_time("ns")
            _least("T4: RD# low", self._read_ended - fell, T4 + self._skew)
            dut.data_in.value = _UNDEFINED
            await Timer(self._rng.randint(*T1) + self._rng.randint(0, self._skew), unit="ns")
            dut.rxf_n.value = 1
            await self._pause(T2)

    async def _writes(self) -> None:
        dut = self._dut
        while True:
            dut.txe_n.value = 0
            await FallingEdge(dut.wr_n)
            fell = get_sim_time("ns")
            self.write_times.append(fell)
            assert int(dut.data_oe.value) == 0xFF, "WR# fell and the bus is not driven"
            _least("T8: data before WR# falls", fell - self._data_changed, T8 + self._skew)
            self.from_gateware.append(int(dut.data_out.value))
            withdrawn = self._rng.randint(*T6) + self._rng.randint(0, self._skew)
            await Timer(withdrawn, unit="ns")
            dut.txe_n.value = 1
            self._tasks.append(cocotb.start_soon(self._write_end(fell)))
            await self._pause(T7)

    async def _write_end(self, fell: float) -> None:
        await RisingEdge(self._dut.wr_n)
        rose = get_sim_time("ns")
        _least("T10: WR# low", rose - fell, T10 + self._skew)
        assert self._data_changed < fell, "the data changed while WR# was low"
        await Timer(T9 + self._skew, unit="ns")
        assert self._data_changed < fell, "T9: the data changed too early after WR# rose"

    async def _siwu(self) -> None:
        dut, rose = self._dut, -1e9
        while True:
            await FallingEdge(dut.siwu_n)
            fell = get_sim_time("ns")
            _least("SIWU# high", fell - rose, SIWU_WIDTH + self._skew)
            assert int(dut.wr_n.value) == 1, "SIWU# fell before the end of WR#"
            self.flushed_after.append(len(self.from_gateware))
            await RisingEdge(dut.siwu_n)
            rose = get_sim_time("ns")
            _least("SIWU# low", rose - fell, SIWU_WIDTH + self._skew)
            assert len(self.from_gateware) == self.flushed_after[-1], "a byte was written while SIWU# was low"

    async def _watch_data(self) -> None:
        dut = self._dut
        while True:
            await dut.data_out.value_change
            self._data_changed = get_sim_time("ns")

    async def _watch_output_enable(self) -> None:
        dut = self._dut
        while True:
            await dut.data_oe.value_change
            self._data_changed = get_sim_time("ns")
            if int(dut.data_oe.value):
                assert dut.rd_n.value == 1, "the gateware drives the bus while it reads"
                _least("bus free after a read", self._data_changed - self._read_ended, T1[1] + self._skew)

    async def _watch_read_strobe(self) -> None:
        dut = self._dut
        while True:
            await FallingEdge(dut.rd_n)
            assert dut.rxf_n.value == 0, "T5: RD# fell while RXF# was high"

    async def _watch_write_strobe(self) -> None:
        dut = self._dut
        while True:
            await FallingEdge(dut.wr_n)
            assert dut.txe_n.value == 0, "T11: WR# fell while TXE# was high"
            assert dut.siwu_n.value == 1, "WR# fell while SIWU# was low"

    async def _pause(self, least_ns: int) -> None:
        await Timer(least_ns + (self._rng.randint(0, self.most_pause_ns) if self.most_pause_ns else 0), unit="ns")


def _least(what: str, measured_ns: float, least_ns: float) -> None:
    assert measured_ns >= least_ns, f"{what}: {measured_ns:.1f} ns, at least {least_ns} ns"
