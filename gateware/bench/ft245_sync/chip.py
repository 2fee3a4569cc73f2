"""Model of the synchronous FT245 FIFO according to its datasheets, and of the pads of an FPGA in front of it.

The chip generates CLKOUT. At each rising edge it samples its pins, checks that they were stable for the setup time, and
transfers a byte if both halves of a handshake are low. Then all its outputs are undefined, from the end of their hold
time to a random time within their maximum delay. RXF# and TXE# become inactive in any cycle with the given
probabilities; TXE# then stays inactive for `txe_high` cycles.

Outputs of the gateware reach the chip's pins with the delay of the slowest pads for which a budget was calculated.
"""

from __future__ import annotations

import dataclasses
import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import Timer
from cocotb.types import Logic, LogicArray
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

PERIOD_PS = 16_667
SIWU_PS = 250_000
PADS_PS = 6_800
"""Clock to output of an ECP5 of speed grade 6 (docs/gateware.md, "What the pins leave")."""
MOST_IDLE = 24
"""Maximum number of cycles of CLKOUT with an enabled driver and no transfer: `patience`, and both turnarounds."""
_UNDEFINED = LogicArray("XXXXXXXX")


@dataclasses.dataclass(frozen=True)
class Timing:
    """Setup time, hold time and output delay of a chip, in ps: table 4.1 of FT_000288 and that of FT_000061."""

    setup: int
    hold: int
    output: int


CHIPS = {"ft232h": Timing(7_500, 1, 9_000), "ft2232h": Timing(8_000, 1_000, 7_150)}
"""A hold time of 0 is replaced by the smallest time of a simulation."""


class SyncChip:
    """A chip at the pins of `ul_ft245_sync`; a violated rule raises an AssertionError in the simulation."""

    def __init__(
        self,
        dut: SimHandleBase,
        *,
        no_rxf: float = 0.0,
        no_txe: float = 0.0,
        txe_high: int = 2,
        kind: str = "ft232h",
        running: bool = True,
        seed: int = 1,
    ) -> None:
        """Store the entity, and the probabilities (0 to 1) that a flag becomes inactive in a cycle."""
        self._dut = dut
        self._timing = CHIPS[kind]
        self._pins = {name: getattr(dut, name) for name in ("rd_n", "wr_n", "oe_n", "siwu_n")}
        self._rng = random.Random(seed)
        self.no_rxf, self.no_txe, self._txe_high = no_rxf, no_txe, txe_high
        self.running = running
        self.to_gateware: deque[int] = deque()
        self.from_gateware: list[int] = []
        self.flushed_after: list[int] = []
        self.cycles = 0
        self.read_cycles: list[int] = []
        self.write_cycles: list[int] = []
        self._siwu_fell: float | None = None
        self._siwu_rose = -1e9
        self._idle = 0
        self._txe_away = 0
        self._changed: dict[str, int] = {}
        dut.clkout.value = 0
        self._tasks = [cocotb.start_soon(self._run())]
        for name in ("rd_n", "wr_n", "oe_n", "data_out", "data_oe"):
            self._tasks.append(cocotb.start_soon(self._watch(name)))

    @property
    def at_rest(self) -> bool:
        """Whether the gateware neither asserts a strobe nor drives the data pins."""
        return not self._ours() and all(self._bit(name) for name in self._pins)

    def stop(self) -> None:
        """Leave the pins as they are."""
        for task in self._tasks:
            task.cancel()

    async def _watch(self, name: str) -> None:
        pin, reset = getattr(self._dut, name), self._dut.rst
        while True:
            await pin.value_change
            # A reset, and a stopped CLKOUT, deassert the strobes asynchronously; the chip has no clock edge then.
            if reset.value == 0 and self.running:
                self._changed[name] = get_sim_time("ps")

    async def _run(self) -> None:
        dut = self._dut
        rxf_n, txe_n, last_oe_n, last_ours = 1, 1, self._bit("oe_n"), self._ours()
        while True:
            if not self.running:
                await Timer(PERIOD_PS, unit="ps")
                continue
            self.cycles += 1
            rd_n, wr_n, oe_n = (self._bit(name) for name in ("rd_n", "wr_n", "oe_n"))
            ours = self._ours()
            self._check(rd_n, wr_n, oe_n, ours, last_oe_n, last_ours)
            self._idle = self._idle + 1 if (ours or not oe_n) and rd_n and wr_n else 0
            assert self._idle <= MOST_IDLE, "the bus is driven, and nothing moves"
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
            txe_n = self._next_txe_n()
            await self._cycle(rxf_n, txe_n)

    def _next_txe_n(self) -> int:
        self._txe_away = max(self._txe_away - 1, 0)
        if not self._txe_away and self._rng.random() < self.no_txe:
            self._txe_away = self._txe_high
        return int(self._txe_away > 0)

    async def _cycle(self, rxf_n: int, txe_n: int) -> None:
        """Generate one period of CLKOUT, with the chip's outputs in it."""
        dut, hold = self._dut, self._timing.hold
        dut.clkout.value = 1
        await Timer(hold, unit="ps")
        dut.data_in.value = _UNDEFINED
        dut.rxf_n.value = dut.txe_n.value = Logic("X")
        delay = self._rng.choice((hold + 1, self._rng.randrange(hold + 1, self._timing.output), self._timing.output))
        await Timer(delay - hold, unit="ps")
        dut.rxf_n.value, dut.txe_n.value = rxf_n, txe_n
        # The times after the falling edge of OE# (t6) and after CLKOUT (t5) end before the next edge.
        if self._bit("oe_n") == 0 and not rxf_n:
            dut.data_in.value = self.to_gateware[0]
        if delay < PERIOD_PS // 2:
            await Timer(PERIOD_PS // 2 - delay, unit="ps")
            delay = PERIOD_PS // 2
        dut.clkout.value = 0
        await Timer(PERIOD_PS - delay, unit="ps")

    def _check(self, rd_n: int, wr_n: int, oe_n: int, ours: int, last_oe_n: int, last_ours: int) -> None:
        now, setup = get_sim_time("ps"), self._timing.setup
        for name, changed in self._changed.items():
            stable = now - changed - PADS_PS
            assert stable >= setup, f"{name} changed {stable} ps before CLKOUT, at least {setup}"
        assert not (ours and oe_n == 0), "both sides drive the bus"
        assert not (last_ours and oe_n == 0), "no cycle of turnaround before OE# falls"
        assert not (ours and last_oe_n == 0), "no cycle of turnaround after OE# rose"
        assert not (rd_n == 0 and (oe_n == 1 or last_oe_n == 1)), "RD# is low without OE# low one cycle before"
        assert not (rd_n == 0 and wr_n == 0), "RD# and WR# are low at once"

    def _siwu(self) -> None:
        now = get_sim_time("ps")
        if self._bit("siwu_n") == 0 and self._siwu_fell is None:
            assert now - self._siwu_rose >= SIWU_PS, f"SIWU# was high for {now - self._siwu_rose} ps"
            self._siwu_fell = now
            self.flushed_after.append(len(self.from_gateware))
        elif self._bit("siwu_n") == 1 and self._siwu_fell is not None:
            assert now - self._siwu_fell >= SIWU_PS, f"SIWU# was low for {now - self._siwu_fell} ps"
            self._siwu_fell, self._siwu_rose = None, now

    def _bit(self, name: str) -> int:
        value = self._pins[name].value
        # Before the first reset has reached the chip's side, all levels are undefined.
        return int(value) if value.is_resolvable else 1

    def _ours(self) -> int:
        value = self._dut.data_oe.value
        driven = int(value) if value.is_resolvable else 0
        assert driven in (0, 0xFF), "some data pins are driven and others are not"
        return int(driven != 0)
