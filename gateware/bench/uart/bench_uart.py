"""Bench: the UART with a line that is modelled bit by bit, in ps.

The model is independent of the gateware's clock: its bits begin at any time and have the length of the tested baud rate
error. It samples the transmitter's output in the middle of each bit of nominal length.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, ReadOnly, RisingEdge, Timer
from cocotb.utils import get_sim_time

from gateware.bench.streams import Sink, Source, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_HELD_BYTES = 1


class Line:
    """The far end of the line: sends bytes to `rxd` and decodes `txd`."""

    def __init__(self, dut: SimHandleBase) -> None:
        self._dut = dut
        self.clock_hz, self.baud = int(dut.clock_hz.value), int(dut.baud.value)
        self.bit_ps = 1e12 / self.baud
        self.ratio = self.clock_hz / self.baud
        self.received: list[int] = []
        self.rng = random.Random(7)
        self._level, self._inverted = 1, 0

    def drive(self, *, level: int | None = None, inverted: int | None = None) -> None:
        """Set the level of the line, or whether a disturbance inverts it."""
        self._level = self._level if level is None else level
        self._inverted = self._inverted if inverted is None else inverted
        self._dut.rxd.value = self._level ^ self._inverted

    async def send(self, data: bytes, *, error: float = 0.0, stop: int = 1, pause_bits: float = 0.0) -> None:
        """Send bytes with a bit length that is off by the fraction `error` (0.02: bits are 2 % too long)."""
        begin = get_sim_time("ps")
        bits = 0.0
        for byte in data:
            for level in (0, *((byte >> n & 1) for n in range(8)), stop):
                self.drive(level=level)
                bits += 1
                await self._until(begin + bits * self.bit_ps * (1 + error))
            if pause_bits:
                self.drive(level=1)
                bits += pause_bits * self.rng.random()
                await self._until(begin + bits * self.bit_ps * (1 + error))
        self.drive(level=1)

    async def listen(self) -> None:
        """Decode the transmitter's output for ever; a wrong start or stop bit raises an AssertionError."""
        while True:
            await FallingEdge(self._dut.txd)
            begin = get_sim_time("ps")
            byte = 0
            for bit in range(10):
                await self._until(begin + (bit + 0.5) * self.bit_ps)
                level = int(self._dut.txd.value)
                if bit == 0:
                    assert level == 0, "the start bit ended early"
                elif bit == 9:
                    assert level == 1, "no stop bit"
                else:
                    byte |= level << (bit - 1)
            self.received.append(byte)

    async def some_time(self) -> None:
        """Wait for a random part of a clock cycle, so that edges come at any point of it."""
        await Timer(self.rng.randrange(1, round(1e12 / self.clock_hz)), unit="ps")

    @staticmethod
    async def _until(instant_ps: float) -> None:
        remaining = round(instant_ps - get_sim_time("ps"))
        if remaining > 0:
            await Timer(remaining, unit="ps")


async def _prepare(dut: SimHandleBase) -> Line:
    dut.rxd.value = 1
    dut.cts_n.value = 0
    dut.rx_ready.value = 0
    dut.tx_valid.value = 0
    dut.tx_data.value = 0
    dut.flush.value = 0
    line = Line(dut)
    await start(dut.clk, dut.rst, 1e9 / line.clock_hz)
    await ClockCycles(dut.clk, round(line.ratio) + 8)
    return line


def _sink(dut: SimHandleBase, pause: float = 0.0) -> Sink:
    return Sink(dut.clk, (dut.rx_data, dut.rx_lost), dut.rx_valid, dut.rx_ready, pause=pause)


def _source(dut: SimHandleBase, pause: float = 0.0) -> Source:
    return Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready, pause=pause)


def _bytes(line: Line) -> bytes:
    """Return as many bytes as fit into a simulation of some 50,000 cycles, with every value if possible."""
    count = max(6, min(256, round(50_000 / (10 * line.ratio))))
    values = list(range(256)) if count == 256 else [0x00, 0xFF, 0x55, 0xAA, 0x01, 0x80, *range(0x20, 0x20 + count - 6)]
    line.rng.shuffle(values)
    return bytes(values)


def _expected(data: bytes) -> list[tuple[int, int]]:
    return [(byte, 0) for byte in data]


@cocotb.test
async def bytes_arrive_at_any_baud_error_of_two_percent(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    # All values at the critical errors, some in between.
    for error, count in ((0.0, 256), (-0.02, 256), (0.02, 256), (-0.01, 40), (0.01, 40)):
        sink = _sink(dut)
        data = _bytes(line)[:count]
        await line.some_time()
        await line.send(data, error=error)
        await ClockCycles(dut.clk, round(2 * line.ratio) + 10)
        assert sink.received == _expected(data), f"baud error {error:+.0%}"
        sink.stop()


@cocotb.test
async def bytes_arrive_with_pauses_of_any_length(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    sink = _sink(dut, pause=0.3)
    data = _bytes(line)[:40]
    await line.send(data, pause_bits=2.5, error=0.01)
    await ClockCycles(dut.clk, round(2 * line.ratio) + 10)
    assert sink.received == _expected(data)


@cocotb.test
async def bytes_leave_with_bits_of_the_right_length_and_without_gaps(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    cocotb.start_soon(line.listen())
    data = _bytes(line)
    source = cocotb.start_soon(_source(dut).send(data))
    await FallingEdge(dut.txd)
    begin = get_sim_time("ps")
    await source
    # The last byte was accepted when the one before it ended.
    cycles = (get_sim_time("ps") - begin) * line.clock_hz / 1e12
    nominal = 10 * (len(data) - 1) * line.ratio
    assert abs(cycles - nominal) <= 3 + 0.0005 * nominal
    await Timer(round(11 * line.bit_ps), unit="ps")
    assert line.received == list(data)
    assert dut.driver_enable.value == 1


@cocotb.test
async def bytes_leave_whatever_the_pauses_between_them(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    cocotb.start_soon(line.listen())
    data = _bytes(line)[:40]
    await _source(dut, pause=1 - 0.1 / line.ratio).send(data)
    await Timer(round(11 * line.bit_ps), unit="ps")
    assert line.received == list(data)


@cocotb.test
async def both_directions_work_at_once(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    sink = _sink(dut)
    data = _bytes(line)
    cocotb.start_soon(line.listen())
    source = cocotb.start_soon(_source(dut).send(data[::-1]))
    await line.send(data)
    await source
    await Timer(round(12 * line.bit_ps), unit="ps")
    assert sink.received == _expected(data)
    assert line.received == list(data[::-1])


@cocotb.test
async def a_byte_without_stop_bit_is_dropped_and_the_next_one_says_so(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    sink = _sink(dut)
    await line.send(b"A")
    await line.send(b"B", stop=0)
    await Timer(round(2 * line.bit_ps), unit="ps")
    await line.send(b"CD")
    await Timer(round(2 * line.bit_ps), unit="ps")
    assert sink.received == [(ord("A"), 0), (ord("C"), 1), (ord("D"), 0)]


@cocotb.test
async def after_a_break_the_line_must_be_high_first(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    sink = _sink(dut)
    dut.rxd.value = 0
    await Timer(round(35 * line.bit_ps), unit="ps")
    dut.rxd.value = 1
    await Timer(round(2 * line.bit_ps), unit="ps")
    await line.send(b"AB")
    await Timer(round(2 * line.bit_ps), unit="ps")
    assert sink.received == [(ord("A"), 1), (ord("B"), 0)]


@cocotb.test
async def a_line_that_is_low_at_reset_is_no_byte(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    sink = _sink(dut)
    dut.rxd.value = 0
    dut.rst.value = 1
    await ClockCycles(dut.clk, 3)
    dut.rst.value = 0
    await Timer(round(15 * line.bit_ps), unit="ps")
    dut.rxd.value = 1
    await Timer(round(2 * line.bit_ps), unit="ps")
    await line.send(b"AB")
    await Timer(round(2 * line.bit_ps), unit="ps")
    assert sink.received == _expected(b"AB")


@cocotb.test
async def a_byte_that_finds_no_room_is_dropped_and_the_next_one_says_so(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    held = _HELD_BYTES + (int(dut.rx_slack.value) if dut.flow_control.value else 0)
    data = bytes(range(0x30, 0x30 + held + 3))
    await line.send(data)
    await Timer(round(line.bit_ps), unit="ps")
    sink = _sink(dut)
    await ClockCycles(dut.clk, held + 5)
    await line.send(b"YZ")
    await Timer(round(2 * line.bit_ps), unit="ps")
    assert sink.received == [*_expected(data[:held]), (ord("Y"), 1), (ord("Z"), 0)]


@cocotb.test
async def a_glitch_shorter_than_the_filter_is_nothing(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    if line.ratio < 16:
        return  # every cycle is sampled, so glitches are not filtered
    sink = _sink(dut)
    glitch = round(0.95 * (line.ratio // 16) * 1e12 / line.clock_hz)

    async def disturb() -> None:
        while True:
            await Timer(round(line.bit_ps * (0.6 + line.rng.random())), unit="ps")
            line.drive(inverted=1)
            await Timer(glitch, unit="ps")
            line.drive(inverted=0)

    disturbance = cocotb.start_soon(disturb())
    data = _bytes(line)[:20]
    await line.send(data, pause_bits=5.0)
    disturbance.cancel()
    line.drive(inverted=0)
    await Timer(round(12 * line.bit_ps), unit="ps")
    assert sink.received == _expected(data)


@cocotb.test
async def reset_in_any_state_recovers(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    for tenth in range(0, 110, 7):
        sending = cocotb.start_soon(line.send(b"\x00"))
        source = cocotb.start_soon(_source(dut).send(b"\x00\x00"))
        await Timer(round(tenth / 10 * line.bit_ps) + 1, unit="ps")
        await RisingEdge(dut.clk)
        dut.rst.value = 1
        sending.cancel()
        source.cancel()
        dut.rxd.value = 1
        dut.tx_valid.value = 0
        await ClockCycles(dut.clk, 2)
        await ReadOnly()
        assert dut.txd.value == 1
        assert dut.rx_valid.value == 0
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        await Timer(round(line.bit_ps), unit="ps")
        sink = _sink(dut)
        listening = cocotb.start_soon(line.listen())
        await RisingEdge(dut.clk)
        echo = cocotb.start_soon(_source(dut).send(b"K"))
        await line.send(b"K")
        await echo
        await Timer(round(2 * line.bit_ps), unit="ps")
        assert sink.received == _expected(b"K")
        assert line.received == [ord("K")]
        line.received.clear()
        listening.cancel()
        sink.stop()
        dut.rx_ready.value = 0


@cocotb.test
async def rts_stops_the_far_end_before_a_byte_is_lost(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    if not dut.flow_control.value:
        assert dut.rts_n.value == 0
        return
    sink = _sink(dut, pause=1 - 0.04 / line.ratio)
    slack = int(dut.rx_slack.value)
    data = bytes(line.rng.randrange(256) for _ in range(3 * slack))
    sent = 0
    while sent < len(data):
        if dut.rts_n.value == 1:
            # The far end reacts late: it sends a few more bytes.
            late = line.rng.randrange(slack // 4)
            await line.send(data[sent : sent + late])
            sent += late
            while dut.rts_n.value == 1:
                await RisingEdge(dut.clk)
        await line.send(data[sent : sent + 1])
        sent += 1
    sink.pause = 0.0
    assert await sink.wait_for(len(data)) == _expected(data)


@cocotb.test
async def no_byte_begins_while_cts_is_away(dut: SimHandleBase) -> None:
    line = await _prepare(dut)
    if not dut.flow_control.value:
        return
    cocotb.start_soon(line.listen())
    source = cocotb.start_soon(_source(dut).send(b"AB"))
    await FallingEdge(dut.txd)
    await Timer(round(3 * line.bit_ps), unit="ps")
    dut.cts_n.value = 1
    await Timer(round(30 * line.bit_ps), unit="ps")
    assert line.received == [ord("A")]
    dut.cts_n.value = 0
    await source
    await Timer(round(11 * line.bit_ps), unit="ps")
    assert line.received == [ord("A"), ord("B")]
