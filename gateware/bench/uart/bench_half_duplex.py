"""Bench: the UART with a transceiver, on a pair of wires that it shares with the far end.

The model of the line is that of `bench_uart`. In addition, this bench watches the driver in ps: when it is enabled,
when it is disabled, and whether the far end was sending.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge, Timer, with_timeout
from cocotb.utils import get_sim_time

from gateware.bench.streams import Sink, Source, start
from gateware.bench.uart.bench_uart import Line

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


class Pair:
    """Both ends of a pair of wires: the far end's line, and the times of the driver.

    Args:
        pins: `rxd`, `txd` and `driver_enable`, and the generics `clock_hz` and `baud`.
    """

    def __init__(self, pins: SimHandleBase) -> None:
        self.pins = pins
        self.line = Line(pins)
        self.cycle_ps = 1e12 / self.line.clock_hz
        self.far_end_sends = False
        self.enabled_at: list[float] = []
        self.disabled_at: list[float] = []
        self.first_edge_at: list[float] = []
        """Times in ps at which `txd` fell first after each enabling."""
        self.line.drive(level=1)

    async def begin(self) -> None:
        """Begin to watch, after a reset, and wait until the receiver has seen the line idle."""
        for watched in (self.line.listen(), self._watch_driver(), self._watch_line(), self._echo()):
            cocotb.start_soon(watched)
        await self.bits(2)

    async def far_end(self, data: bytes) -> None:
        """Send from the far end, which uses the line until the end of its last stop bit."""
        assert self.pins.driver_enable.value == 0, "the far end would begin while the driver is enabled"
        self.far_end_sends = True
        await self.line.send(data)
        self.far_end_sends = False

    async def bits(self, number: float) -> None:
        await Timer(round(number * self.line.bit_ps), unit="ps")

    async def _watch_driver(self) -> None:
        while True:
            await self.pins.driver_enable.value_change
            if self.pins.driver_enable.value == 1:
                assert not self.far_end_sends, "the driver is enabled while the far end sends"
                self.enabled_at.append(get_sim_time("ps"))
            else:
                self.disabled_at.append(get_sim_time("ps"))

    async def _watch_line(self) -> None:
        while True:
            await self.pins.txd.value_change
            assert self.pins.driver_enable.value == 1, "txd changes while the driver is disabled"
            if len(self.first_edge_at) < len(self.enabled_at):
                self.first_edge_at.append(get_sim_time("ps"))

    async def _echo(self) -> None:
        """Feed the transmitted bits to the receiver, like a transceiver whose receiver stays enabled meanwhile."""
        while True:
            await self.pins.txd.value_change
            await ReadOnly()
            level = int(self.pins.txd.value)
            await Timer(1, unit="ps")
            self.line.drive(level=level)


async def _begin(dut: SimHandleBase) -> tuple[Pair, Sink, Source]:
    dut.cts_n.value = dut.flush.value = 0
    pair = Pair(dut)
    sink = Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready)
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    await start(dut.clk, dut.rst, 1e9 / pair.line.clock_hz)
    await pair.begin()
    return pair, sink, source


@cocotb.test
async def the_driver_is_enabled_from_its_lead_to_its_tail(dut: SimHandleBase) -> None:
    pair, _, source = await _begin(dut)
    lead, tail = int(dut.driver_lead.value), int(dut.driver_tail.value)
    data = bytes(range(0x40, 0x48))
    for count in (1, 8):
        begin = len(pair.line.received)
        await pair.bits(2)
        await source.send(data[:count])
        await pair.bits(12 + tail)
        assert bytes(pair.line.received[begin:]) == data[:count]
    assert len(pair.enabled_at) == len(pair.disabled_at) == 2
    ratio = pair.line.bit_ps
    for count, enabled, first, disabled in zip(
        (1, 8), pair.enabled_at, pair.first_edge_at, pair.disabled_at, strict=True
    ):
        # Without a lead, the start bit begins one cycle later; a bit is a whole number of cycles only on average.
        assert abs(first - enabled - lead * ratio - pair.cycle_ps) <= 1.01 * pair.cycle_ps
        slack = 1.01 * pair.cycle_ps + 0.0005 * 10 * count * ratio
        assert abs(disabled - first - (10 * count + tail) * ratio) <= slack + (tail > 0) * pair.cycle_ps


@cocotb.test
async def what_is_sent_is_not_heard(dut: SimHandleBase) -> None:
    pair, sink, source = await _begin(dut)
    await source.send(b"U\x00\xff")
    await pair.bits(13 + int(dut.driver_tail.value))
    assert bytes(pair.line.received) == b"U\x00\xff"
    assert sink.received == []
    await pair.far_end(b"A")
    await pair.bits(2)
    assert sink.received == [(ord("A"), 0)]


@cocotb.test
async def nothing_is_driven_while_the_far_end_sends_whenever_there_is_something_to_send(dut: SimHandleBase) -> None:
    """Bytes that are offered at any time during the far end's frame are sent after it."""
    pair, sink, source = await _begin(dut)
    tail = int(dut.driver_tail.value)
    frame = b"\x00\xff\r\x55\n"
    # Up to two bits before the end, so that the delay below does not extend beyond it.
    for hundredth in range(0, 100 * (10 * len(frame) - 2), 170):
        await pair.line.some_time()
        sent, heard = len(pair.line.received), len(sink.received)
        far_end = cocotb.start_soon(pair.far_end(frame))
        # Not before the first start bit has passed the receiver's synchroniser and filter.
        await Timer(round((0.25 + hundredth / 100) * pair.line.bit_ps + 6 * pair.cycle_ps), unit="ps")
        sending = cocotb.start_soon(source.send(b"ok"))
        await far_end
        ended = get_sim_time("ps")
        await with_timeout(sending, round(40 * pair.line.bit_ps), "ps")
        await pair.bits(12 + tail)
        # Half a bit after the stop bit; the receiver samples at most two cycles and an eighth of a bit late.
        delay = pair.enabled_at[-1] - ended
        assert 0.4 * pair.line.bit_ps <= delay <= 0.65 * pair.line.bit_ps + 4 * pair.cycle_ps
        assert bytes(pair.line.received[sent:]) == b"ok"
        assert sink.received[heard:] == [(byte, 0) for byte in frame]


@cocotb.test
async def a_reset_disables_the_driver(dut: SimHandleBase) -> None:
    _, _, source = await _begin(dut)
    sending = cocotb.start_soon(source.send(b"\x00\x00"))
    while dut.driver_enable.value == 0:
        await RisingEdge(dut.clk)
    await ClockCycles(dut.clk, 2)
    dut.rst.value = 1
    sending.cancel()
    dut.tx_valid.value = 0
    await ClockCycles(dut.clk, 2)
    await ReadOnly()
    assert dut.driver_enable.value == 0
