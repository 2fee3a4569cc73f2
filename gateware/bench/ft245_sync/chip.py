"""The synchronous FT245 FIFO as its datasheet draws it (FT232H, FT_000288, section 4.4, table 4.1).

The chip makes CLKOUT. At each rising edge it looks at its pins, checks that they were stable for the setup time, and
moves a byte where both halves of a handshake are low; then its own outputs change at a random instant of the 9 ns that
they may take, the data bus being undefined until then. RXF# and TXE# go away in any cycle with the probabilities asked
for.
"""

from __future__ import annotations

import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import Timer
from cocotb.types import LogicArray
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

PERIOD_PS = 16_667
SETUP_PS = 7_500
OUTPUT_PS = 9_000
SIWU_PS = 250_000
_UNDEFINED = LogicArray("XXXXXXXX")


class SyncChip:
    """One FT232H at the pins of `ft245_sync`; everything it found wrong has raised in the simulation."""

    def __init__(self, dut: SimHandleBase, *, no_rxf: float = 0.0, no_txe: float = 0.0, seed: int = 1) -> None:
        """Take the entity, and the probabilities that a flag stays away in a cycle."""
        self._dut = dut
        self._pins = {name: getattr(dut, name) for name in ("rd_n", "wr_n", "oe_n", "siwu_n", "data_oe")}
        self._rng = random.Random(seed)
        self.no_rxf, self.no_txe = no_rxf, no_txe
        self.running = True
        self.to_gateware: deque[int] = deque()
        self.from_gateware: list[int] = []
        self.flushed_after: list[int] = []
        self.cycles = 0
        self.read_cycles: list[int] = []
        self.write_cycles: list[int] = []
        self._siwu_fell: float | None = None
        self._changed: dict[str, int] = {}
        dut.clkout.value = 0
        self._tasks = [cocotb.start_soon(self._run())]
        for name in ("rd_n", "wr_n", "oe_n", "data_out", "data_oe"):
            self._tasks.append(cocotb.start_soon(self._watch(name)))

    def stop(self) -> None:
        """Leave the pins as they are."""
        for task in self._tasks:
            task.cancel()

    async def _watch(self, name: str) -> None:
        pin, reset = getattr(self._dut, name), self._dut.rst
        while True:
            await pin.value_change
            # A reset takes the strobes away at once; the chip then knows nothing of a cycle.
            if reset.value == 0:
                self._changed[name] = get_sim_time("ps")

    async def _run(self) -> None:
        dut = self._dut
        rxf_n, txe_n, last_oe_n, last_ours = 1, 1, self._bit("oe_n"), self._bit("data_oe")
        while True:
            if not self.running:
                await Timer(PERIOD_PS, unit="ps")
                continue
            self.cycles += 1
            rd_n, wr_n, oe_n, ours = (self._bit(name) for name in ("rd_n", "wr_n", "oe_n", "data_oe"))
            self._check(rd_n, wr_n, oe_n, ours, last_oe_n, last_ours)
            if rd_n == 0 and rxf_n == 0:
                self.to_gateware.popleft()
                self.read_cycles.append(self.cycles)
            if wr_n == 0 and txe_n == 0:
                assert ours == 1, "WR# is low and the bus is not driven"
                assert self._siwu_fell is None, "a byte was written while SIWU# was low"
                self.from_gateware.append(int(dut.data_out.value))
                self.write_cycles.append(self.cycles)
            self._siwu()
            last_oe_n, last_ours = oe_n, ours
            rxf_n = int(not self.to_gateware or self._rng.random() < self.no_rxf)
            txe_n = int(self._rng.random() < self.no_txe)

            dut.clkout.value = 1
            await Timer(1, unit="ps")  # the least hold time that a simulation knows
            dut.data_in.value = _UNDEFINED
            delay = self._rng.randrange(2, OUTPUT_PS)
            await Timer(delay - 1, unit="ps")
            dut.rxf_n.value, dut.txe_n.value = rxf_n, txe_n
            # The 9 ns after OE# fell (t6) are over at the next edge, as are those after CLKOUT (t5).
            if self._bit("oe_n") == 0 and not rxf_n:
                dut.data_in.value = self.to_gateware[0]
            if delay < PERIOD_PS // 2:
                await Timer(PERIOD_PS // 2 - delay, unit="ps")
                delay = PERIOD_PS // 2
            dut.clkout.value = 0
            await Timer(PERIOD_PS - delay, unit="ps")

    def _check(self, rd_n: int, wr_n: int, oe_n: int, ours: int, last_oe_n: int, last_ours: int) -> None:
        now = get_sim_time("ps")
        for name, changed in self._changed.items():
            assert now - changed >= SETUP_PS, f"{name} changed {now - changed} ps before CLKOUT, at least {SETUP_PS}"
        assert not (ours and oe_n == 0), "both sides drive the bus"
        assert not (last_ours and oe_n == 0), "no cycle of turnaround before OE# falls"
        assert not (ours and last_oe_n == 0), "no cycle of turnaround after OE# rose"
        assert not (rd_n == 0 and (oe_n == 1 or last_oe_n == 1)), "RD# is low without OE# low one cycle before"
        assert not (rd_n == 0 and wr_n == 0), "RD# and WR# are low at once"

    def _siwu(self) -> None:
        now = get_sim_time("ps")
        if self._bit("siwu_n") == 0 and self._siwu_fell is None:
            self._siwu_fell = now
            self.flushed_after.append(len(self.from_gateware))
        elif self._bit("siwu_n") == 1 and self._siwu_fell is not None:
            assert now - self._siwu_fell >= SIWU_PS, f"SIWU# was low for {now - self._siwu_fell} ps"
            self._siwu_fell = None

    def _bit(self, name: str) -> int:
        value = self._pins[name].value
        # Before the first reset has reached the chip's side nothing is defined.
        return int(value) if value.is_resolvable else {"data_oe": 0}.get(name, 1)
