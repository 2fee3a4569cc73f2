"""Drivers and monitors for the byte streams of the gateware (data, valid, ready), and the reset for all benches.

All of them read signals at the rising edge (cocotb still returns the values before it) and change them after it, as
registers do.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, Event, RisingEdge, SimTimeoutError, with_timeout
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from collections.abc import Iterable

    from cocotb.handle import LogicArrayObject, LogicObject
    from cocotb.task import Task


_clocks: dict[str, Task[None]] = {}


async def start(clk: LogicObject, rst: LogicObject, period_ns: float = 20.0) -> None:
    """Start a clock of this period, unless it is running, and reset for five cycles; return one cycle after that."""
    running = _clocks.get(clk._path)  # noqa: SLF001 - a handle has no public name that is unique
    if running is None or running.done():
        _clocks[clk._path] = cocotb.start_soon(Clock(clk, 2 * round(period_ns * 500), unit="ps").start())  # noqa: SLF001
    rst.value = 1
    await ClockCycles(clk, 5)
    rst.value = 0
    # `runner` searches for this message: undefined signals are no fault before it.
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    await RisingEdge(clk)


class Joined:
    """Several signals as one value, the first one at the lowest bits, for the signals of a stream beside its data."""

    def __init__(self, *parts: tuple[LogicArrayObject | LogicObject, int]) -> None:
        """Store the signals and the number of bits of each."""
        self._parts = parts

    @property
    def value(self) -> int:
        """Write-only."""
        raise NotImplementedError

    @value.setter
    def value(self, entry: int) -> None:
        for signal, bits in self._parts:
            signal.value = entry & (1 << bits) - 1
            entry >>= bits


class Source:
    """Offers entries on a stream, with random pauses."""

    def __init__(
        self,
        clk: LogicObject,
        data: LogicArrayObject | Joined,
        valid: LogicObject,
        ready: LogicObject,
        *,
        pause: float = 0.0,
        rng: random.Random | None = None,
    ) -> None:
        """Store the stream's signals, and the probability (0 to 1) of not offering an entry in a cycle."""
        self._clk, self._data, self._valid, self._ready = clk, data, valid, ready
        self.pause = pause
        self._rng = rng or random.Random(1)
        valid.value = 0

    async def send(self, entries: Iterable[int]) -> None:
        """Offer each entry until it is accepted; return when the last one was."""
        for entry in entries:
            paused = 0
            while self._rng.random() < self.pause:
                paused += 1
            if paused:
                await ClockCycles(self._clk, paused)
            self._data.value = entry
            self._valid.value = 1
            await RisingEdge(self._clk)
            while self._ready.value != 1:
                await RisingEdge(self._ready)
                await RisingEdge(self._clk)
            self._valid.value = 0


class Sink:
    """Accepts entries of a stream into `received`, with random pauses.

    `data` may be several signals: entries are then tuples of their values.
    """

    def __init__(
        self,
        clk: LogicObject,
        data: LogicArrayObject | tuple[LogicArrayObject | LogicObject, ...],
        valid: LogicObject,
        ready: LogicObject,
        *,
        pause: float = 0.0,
        rng: random.Random | None = None,
    ) -> None:
        """Store the stream's signals and the probability (0 to 1) of not being ready in a cycle, and start at once."""
        self._clk, self._data, self._valid, self._ready = clk, data, valid, ready
        self.pause = pause
        self.received: list[int | tuple[int, ...]] = []
        self._wanted = 0
        self._came = Event()
        self._rng = rng or random.Random(2)
        self._task = cocotb.start_soon(self._run())

    def stop(self) -> None:
        """Accept no more entries; the ready signal keeps its level."""
        self._task.cancel()

    async def _run(self) -> None:
        offered = None
        while True:
            offers = not self.pause or self._rng.random() >= self.pause
            # Write ready only if it changes, and sleep while no entry is offered, because each access takes time in the
            # simulator.
            if offers is not offered:
                offered = offers
                self._ready.value = int(offers)
            if not self.pause and self._valid.value != 1:
                await RisingEdge(self._valid)
            await RisingEdge(self._clk)
            if offered and self._valid.value == 1:
                self.received.append(self._entry())
                if len(self.received) == self._wanted:
                    self._came.set()

    def _entry(self) -> int | tuple[int, ...]:
        if isinstance(self._data, tuple):
            return tuple(int(signal.value) for signal in self._data)
        return int(self._data.value)

    async def wait_for(self, count: int, most_us: int = 10_000) -> list[int | tuple[int, ...]]:
        """Wait until `count` entries were received and return them.

        Raises:
            AssertionError: if they have not been received within `most_us` of simulated time.
        """
        if len(self.received) < count:
            self._wanted = count
            self._came.clear()
            try:
                await with_timeout(self._came.wait(), most_us, "us")
            except SimTimeoutError as error:
                raise AssertionError(f"{len(self.received)} entries received, expected {count}") from error
        return self.received
