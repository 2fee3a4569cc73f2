"""Bench: cycles from the sampling strobe to the read of each word, during block reads and without them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.unity_link.gateway import Gateway, checked, note_figure

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

PERIOD = 375
"""Cycles between two samples: odd, so that a strobe comes at any position within a block."""
TICKS = 3
"""The same in base ticks."""
WORDS = 8
WAIT_STATES = (0, 3)


class _Samples:
    """Times of samples: the cycles of their strobes, and the delays after which the slave accepted each read."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.strobes: list[int] = []
        self.reads: list[list[int]] = []
        self.into_blocks = 0
        """Number of strobes in the middle of a block."""
        self._watching = cocotb.start_soon(self._watch(dut))

    async def _watch(self, dut: SimHandleBase) -> None:
        cycle, in_block = 0, False
        while True:
            await RisingEdge(dut.clk)
            cycle += 1
            if dut.sample_strobe.value == 1:
                self.strobes.append(cycle)
                self.reads.append([])
                self.into_blocks += in_block
            in_block = dut.wb_cyc.value == 1 and dut.sample_access.value == 0
            if self.strobes and dut.sample_access.value == 1 and dut.wb_taken.value == 1:
                self.reads[-1].append(cycle - self.strobes[-1])

    def end(self) -> tuple[set[int], set[tuple[int, ...]]]:
        """Return the positions of strobes within a tick, and the delays of the words after each strobe."""
        self._watching.cancel()
        # Drop the first sample (taken when the group starts) and the last one (its reads may be incomplete).
        return {strobe % PERIOD for strobe in self.strobes[1:-1]}, set(map(tuple, self.reads[1:-1]))


@cocotb.test
async def each_word_of_a_sample_is_read_at_its_cycle_behind_the_strobe_also_beside_blocks(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    await gateway.ask(b"GS0001%04X%02X" % (TICKS, WORDS) + bytes(range(0x20, 0x20 + WORDS)).hex().upper().encode())
    for wait_states in WAIT_STATES:
        dut.wait_states.value = wait_states
        await gateway.ask(b"GN00")
        alone = _Samples(dut)
        await gateway.cycles(10 * PERIOD)
        (place,), (reads,) = alone.end()
        assert len(reads) == WORDS
        # A response that is sent irregularly makes the words of its block be read at any time.
        gateway.pause_out = 0.2
        gateway.send(checked(b"RM00FF") * 30)
        beside = _Samples(dut)
        await gateway.cycles(80 * PERIOD)
        places, reads_beside = beside.end()
        assert beside.into_blocks > 5
        assert reads_beside == {reads}
        late = {(found - place) % PERIOD for found in places}
        assert max(late) < PERIOD // 2
        note_figure(f"first word with {wait_states} wait states", reads[0])
        note_figure(f"last word with {wait_states} wait states", reads[-1])
        note_figure(f"strobe late with {wait_states} wait states", max(late))
        gateway.send(checked(b"GX00"))
        gateway.pause_out = 0.0
        await gateway.quiet(4 * 255 * (4 + wait_states))
        gateway.take()
