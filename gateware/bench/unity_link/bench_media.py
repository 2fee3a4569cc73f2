"""Bench: the whole gateway at the pins of a medium, with the model of the medium's own bench at the other end.

The layers have benches of their own. This one tests that `unity_link` connects them: bytes from the pins to the bus and
back, lost bytes, and the flush after an answer.
"""

from __future__ import annotations

import os
from types import SimpleNamespace
from typing import TYPE_CHECKING, Protocol

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge

from gateware.bench.ft245_async.chip import AsyncChip
from gateware.bench.ft245_sync.chip import SyncChip
from gateware.bench.streams import start
from gateware.bench.uart.bench_uart import Line
from gateware.bench.unity_link.gateway import SESSION, checked, opening, with_id

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cocotb.handle import SimHandleBase

PINS = ("data_in", "data_out", "data_oe", "rxf_n", "txe_n", "rd_n", "wr_n", "oe_n", "siwu_n")


class Medium(Protocol):
    """The other end of a medium."""

    flushed_after: list[int] | None
    """Number of bytes received at each flush; None if the medium has no flush."""

    def send(self, data: bytes) -> None:
        """Send bytes."""

    def received(self) -> Sequence[int]:
        """Return all bytes received."""


class Uart:
    """A line at the pins of the UART."""

    flushed_after = None

    def __init__(self, dut: SimHandleBase) -> None:
        pins = {"rxd": dut.uart_rxd, "txd": dut.uart_txd, "clock_hz": dut.clock_hz, "baud": dut.baud}
        self._line = Line(SimpleNamespace(**pins))
        self._line.drive(level=1)
        cocotb.start_soon(self._line.listen())

    def send(self, data: bytes) -> None:
        cocotb.start_soon(self._line.send(data))

    def received(self) -> Sequence[int]:
        return self._line.received


class Ft245:
    """A chip at the pins of the FT245, in asynchronous or synchronous mode."""

    def __init__(self, dut: SimHandleBase) -> None:
        pins = {name: getattr(dut, f"ft_{name}") for name in PINS}
        dut.ft_rxf_n.value = dut.ft_txe_n.value = 1
        if os.environ["MEDIUM"] == "ft245":
            skew = SimpleNamespace(value=5)
            self._chip = AsyncChip(SimpleNamespace(**pins, skew_ns=skew), most_pause_ns=100)
        else:
            self._chip = SyncChip(SimpleNamespace(**pins, clkout=dut.ft_clkout, rst=dut.rst), no_rxf=0.1, no_txe=0.1)
        self.flushed_after = self._chip.flushed_after

    def send(self, data: bytes) -> None:
        if isinstance(self._chip, AsyncChip):
            self._chip.send(data)
        else:
            self._chip.to_gateware.extend(data)

    def received(self) -> Sequence[int]:
        return self._chip.from_gateware


async def memory(dut: SimHandleBase) -> None:
    """Answer each access one cycle later; every address returns the word written there, or 0."""
    words: dict[int, int] = {}
    dut.wb_ack.value = dut.wb_err.value = dut.wb_stall.value = dut.wb_dat_i.value = 0
    while True:
        await ReadOnly()
        asked = dut.wb_cyc.value == 1 and dut.wb_stb.value == 1 and dut.wb_ack.value == 0
        if asked and dut.wb_we.value == 1:
            words[int(dut.wb_adr.value)] = int(dut.wb_dat_o.value)
        word = words.get(int(dut.wb_adr.value), 0) if asked else 0
        await RisingEdge(dut.clk)
        dut.wb_ack.value, dut.wb_dat_i.value = asked, word


async def _begin(dut: SimHandleBase) -> Medium:
    dut.in_valid.value = dut.out_ready.value = dut.trigger.value = 0
    medium = Uart(dut) if os.environ["MEDIUM"] == "uart" else Ft245(dut)
    await start(dut.clk, dut.rst)
    cocotb.start_soon(memory(dut))
    return medium


async def _answers(dut: SimHandleBase, medium: Medium, data: bytes, expected: bytes) -> None:
    """Send bytes, wait for as many as expected, and compare them."""
    before = len(medium.received())
    medium.send(data)
    for _ in range(20_000):
        if len(medium.received()) >= before + len(expected):
            break
        await RisingEdge(dut.clk)
    assert bytes(medium.received()[before:]) == expected
    # A flush may follow, for 250 ns.
    await ClockCycles(dut.clk, 40)


@cocotb.test
async def requests_are_answered_at_the_pins(dut: SimHandleBase) -> None:
    medium = await _begin(dut)
    for request, answer in (
        (checked(b"W0A00000012"), checked(b"W0A")),
        (checked(b"R0A"), checked(b"R0A00000012")),
        (checked(opening()), checked(opening() + b"0000")),
        (checked(with_id(b"r", 0, b"0A"), SESSION), checked(with_id(b"r", 0, b"00000012"), SESSION, answers=True)),
        (checked(with_id(b"w", 1, b"0A0000002A"), SESSION), checked(with_id(b"w", 1), SESSION, answers=True)),
        (b"R0A\r", b"R0A0000002A\r\n"),
        (b"R0A0000\n", checked(b"X01")),
    ):
        await _answers(dut, medium, request, answer)


@cocotb.test
async def a_block_goes_in_and_out_whole(dut: SimHandleBase) -> None:
    medium = await _begin(dut)
    words = b"".join(b"%08X" % (number * 0x01020304) for number in range(30))
    await _answers(dut, medium, checked(b"WM20" + words), checked(b"WM201E"))
    await _answers(dut, medium, checked(b"RM201E"), checked(b"RM201E" + words))


@cocotb.test
async def a_lone_answer_is_flushed_behind_its_last_byte(dut: SimHandleBase) -> None:
    medium = await _begin(dut)
    if medium.flushed_after is None:
        return
    for _ in range(3):
        await _answers(dut, medium, checked(b"H"), checked(b"H"))
        assert medium.flushed_after[-1] == len(medium.received())
    assert len(medium.flushed_after) == 3
