"""Ethernet frames as bytes, and a PHY at 100 Mb/s for the pins of the gateware: RMII, MII or RGMII.

The PHY outputs frames symbol by symbol, intact or with the faults of lines and hosts. It receives frames from the pins,
and checks preamble, delimiter, gap and CRC of each. The names of the pins are those of `ul_mac` and of `unity_link`.
"""

from __future__ import annotations

import dataclasses
import zlib
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.queue import Queue
from cocotb.triggers import (
    Event,
    FallingEdge,
    First,
    RisingEdge,
    SimTimeoutError,
    Timer,
    ValueChange,
    with_timeout,
)
from cocotb.types import Logic, LogicArray
from cocotb.utils import get_sim_time

from unity_link.gateware.pin_times import PIN_TIMES

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

SHORTEST = 60
"""Bytes of the shortest frame without its frame check sequence."""
BYTE_NS = 80
PREAMBLE = b"\x55" * 7 + b"\xd5"
_GAP_NS = 12 * BYTE_NS


def check_of(body: bytes) -> bytes:
    """Return the four bytes of a frame check sequence, in the order in which they are sent."""
    return zlib.crc32(body).to_bytes(4, "little")


def with_check(body: bytes) -> bytes:
    """Return a frame with padding and frame check sequence."""
    padded = body.ljust(SHORTEST, b"\0")
    return padded + check_of(padded)


def symbols_of(data: bytes, lanes: int) -> list[int]:
    """Return the symbols that transfer bytes over this number of lines."""
    return [byte >> place & (1 << lanes) - 1 for byte in data for place in range(0, 8, lanes)]


def bytes_of(symbols: list[int], lanes: int) -> bytes:
    """Return the bytes of symbols; an incomplete byte at the end is dropped."""
    each = 8 // lanes
    groups = (symbols[at : at + each] for at in range(0, len(symbols) - each + 1, each))
    return bytes(sum(symbol << lanes * place for place, symbol in enumerate(group)) for group in groups)


@dataclasses.dataclass(frozen=True)
class Sent:
    """A frame to the gateware, and its faults."""

    data: bytes
    """Bytes after the delimiter, with the frame check sequence."""
    preamble: int | None = None
    """Symbols of the preamble without those of the delimiter; None: as many as in IEEE 802.3."""
    toggling: int = 0
    """For RMII: nibbles at the end for which CRS_DV is low with the first symbol."""
    dribble: int = 0
    """Symbols after the last byte."""
    error_at: int | None = None
    """Symbol after the delimiter in which the PHY reports an error; None: no error."""
    delimited: bool = True
    """False if the delimiter is missing."""
    gap: int = 12
    """Bytes of silence after the frame."""


class Phy:
    """A PHY at the pins; a fault in a frame of the gateware raises an AssertionError in the simulation.

    Args:
        dut: has the pins.
        interface: "rmii", "mii" or "rgmii".
        timed: whether its outputs are undefined from the minimum to the maximum of their delay
            (`unity_link.gateware.pin_times`); otherwise they change at the edge.
    """

    def __init__(self, dut: SimHandleBase, interface: str, *, timed: bool = False) -> None:
        self.received: list[bytes] = []
        """Frames of the gateware, without preamble and frame check sequence."""
        self.ended_ns: list[float] = []
        """Simulated time in ns at which each of them had ended."""
        self.began_ns: list[float] = []
        """Simulated time in ns at which the preamble of each frame to the gateware began."""
        self._dut, self._interface = dut, interface
        self._timed = timed
        self._lanes = 2 if interface == "rmii" else 4
        self._waiting: Queue[tuple[Sent, Event]] = Queue()
        self._came = Event()
        dut.phy_rxd.value = dut.phy_rx_dv.value = dut.phy_rx_er.value = 0
        self._tasks = [
            cocotb.start_soon(task)
            for task in (*self._clocks(), self._give(), self._take(RisingEdge), *self._other_edge())
        ]

    def _clocks(self) -> list[object]:
        period = 20 if self._interface == "rmii" else 40
        tx_period = 40 if self._interface == "mii" else 20
        return [
            Clock(self._dut.phy_rx_clk, period, unit="ns").start(),
            Clock(self._dut.phy_tx_clk, tx_period, unit="ns").start(start_high=self._interface != "mii"),
        ]

    def _other_edge(self) -> list[object]:
        return [self._compare_edges(), self._time_outputs()] if self._interface == "rgmii" else []

    # To the gateware

    async def send(self, *frames: bytes | Sent) -> None:
        """Send frames; return after the gap of the last one."""
        done = Event()
        for frame in frames:
            done = Event()
            self._waiting.put_nowait((frame if isinstance(frame, Sent) else Sent(with_check(frame)), done))
        await done.wait()

    async def _give(self) -> None:
        while True:
            frame, done = await self._waiting.get()
            await self._edge()
            self.began_ns.append(get_sim_time("ns"))
            for symbol, valid, error in self._line(frame):
                await self._put(symbol, valid, error)
            for _ in range(frame.gap * 8 // self._lanes):
                await self._put(0, 0, 0)
            done.set()

    async def _edge(self) -> None:
        """Wait until the PHY may change its outputs."""
        await (FallingEdge if self._interface == "rgmii" else RisingEdge)(self._dut.phy_rx_clk)

    async def _put(self, symbol: int, valid: int, error: int) -> None:
        if self._interface == "rgmii":
            self._change(phy_rxd=symbol, phy_rx_dv=valid)
            await RisingEdge(self._dut.phy_rx_clk)
            self._change(phy_rxd=symbol, phy_rx_dv=valid ^ error)
        else:
            self._change(phy_rxd=symbol, phy_rx_dv=valid, phy_rx_er=error)
        await self._edge()

    def _change(self, **pins: int) -> None:
        """Set pins, after an edge of their clock."""
        if self._timed:
            cocotb.start_soon(self._change_in_time(pins))
        else:
            for name, value in pins.items():
                getattr(self._dut, name).value = value

    async def _change_in_time(self, pins: dict[str, int]) -> None:
        least, most = (round(1000 * time) for time in PIN_TIMES[self._interface][0].arrival_ns)
        await Timer(least, "ps")
        for name in pins:
            pin = getattr(self._dut, name)
            pin.value = LogicArray("X" * len(pin)) if name == "phy_rxd" else Logic("X")
        await Timer(most - least, "ps")
        for name, value in pins.items():
            getattr(self._dut, name).value = value

    def _line(self, frame: Sent) -> list[tuple[int, int, int]]:
        """Return symbol, valid and error for each symbol period."""
        head = symbols_of(PREAMBLE, self._lanes)
        own = 1 if self._lanes == 4 else 4
        preamble = len(head) - own if frame.preamble is None else frame.preamble
        start = [head[0]] * preamble + head[-own:]
        if not frame.delimited:
            start[-1] = head[0]
        data = symbols_of(frame.data, self._lanes) + [0] * frame.dribble
        line = [[symbol, 1, 0] for symbol in [*start, *data]]
        if self._interface == "rmii":
            line[:0] = [[0, 1, 0]] * 3
            for nibble in range(frame.toggling):
                line[-2 * nibble - 2][1] = 0
        if frame.error_at is not None:
            line[len(start) + frame.error_at][2] = 1
        return [(symbol, valid, error) for symbol, valid, error in line]

    # From the gateware

    async def wait_for(self, count: int, most_us: int = 2000) -> list[bytes]:
        """Wait until a number of frames were received, and return all.

        Raises:
            AssertionError: if they have not been received within `most_us` of simulated time.
        """
        while len(self.received) < count:
            self._came.clear()
            try:
                await with_timeout(self._came.wait(), most_us, "us")
            except SimTimeoutError as error:
                raise AssertionError(f"{len(self.received)} frames received, expected {count}") from error
        return self.received

    def _symbol_clock(self) -> object:
        return self._dut.phy_txc if self._interface == "rgmii" else self._dut.phy_tx_clk

    async def _take(self, edge: type) -> None:
        clock, silent_since = self._symbol_clock(), -1e9
        while True:
            await RisingEdge(self._dut.phy_tx_en)
            symbols: list[int] = []
            await edge(clock)
            began = get_sim_time("ns")
            assert began - silent_since >= _GAP_NS, f"a gap of {began - silent_since} ns, expected {_GAP_NS} or more"
            while self._dut.phy_tx_en.value == 1:
                symbols.append(int(self._dut.phy_txd.value))
                await edge(clock)
            silent_since = get_sim_time("ns")
            self._end(symbols, silent_since)

    def _end(self, symbols: list[int], now_ns: float) -> None:
        assert len(symbols) % (8 // self._lanes) == 0, "a frame ends within a byte"
        data = bytes_of(symbols, self._lanes)
        assert data.startswith(PREAMBLE), f"a frame begins with {data[:8].hex()}"
        frame = data.removeprefix(PREAMBLE)
        assert len(frame) <= SHORTEST + 4 or len(frame) <= 1518
        self.spoilt = frame[-4:] != check_of(frame[:-4])
        self.received.append(frame[:-4])
        self.ended_ns.append(now_ns)
        self._came.set()

    async def _compare_edges(self) -> None:
        """Check that the data at the falling edge of TXC equals that at the rising edge."""
        pins = (self._dut.phy_txd, self._dut.phy_tx_en)
        while True:
            await RisingEdge(self._dut.phy_txc)
            rising = [pin.value for pin in pins]
            await FallingEdge(self._dut.phy_txc)
            assert [pin.value for pin in pins] == rising, "RGMII: data differ between the edges of TXC"

    async def _time_outputs(self) -> None:
        """Check that data does not change within setup and hold time of the PHY around each edge of TXC."""
        times = PIN_TIMES["rgmii"][1]
        pins = (self._dut.phy_txd, self._dut.phy_tx_en)
        changed, edge = -1e9, -1e9
        while True:
            seen = await First(ValueChange(self._dut.phy_txc), *map(ValueChange, pins))
            now = get_sim_time("ns")
            if seen.signal is self._dut.phy_txc:
                assert now - changed >= times.setup_ns, f"RGMII: data change {now - changed} ns before an edge of TXC"
                edge = now
            else:
                assert now - edge >= times.hold_ns, f"RGMII: data change {now - edge} ns after an edge of TXC"
                changed = now
