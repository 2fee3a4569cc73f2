"""Inside the simulator: generated boards by their pins, a UART, and a wire from the end of the chain to its start.

`unity_link.protocol` makes the frames, and the same spec the signals; the bench is independent of the VHDL. Each board
has one test, because a board begins with a reset at power-up, which no pin repeats.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, FallingEdge, RisingEdge, Timer

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.spec import compile_file, compile_text

if TYPE_CHECKING:
    from unity_link.spec import Interface

FRAMING = Codec(GatewayInfo()).framing
PERIOD_NS = 40
BIT_CYCLES = 4
WALKER = compile_file(Path(__file__).parents[2] / "examples" / "walker.ul")
ECHO = compile_text(
    """\
public echo() {
  @sent = 0x10: unsigned 48 WRITE();
  @came = 0x12: unsigned 48 READ();
  @low = 0x14[2:0]: unsigned READWRITE();
  @high = 0x14[7:3]: signed WRITE();
  @low_came = 0x15[2:0]: unsigned READ();
  @high_came = 0x15[7:3]: signed READ();
}
"""
)
"""Pairs of a written and a read signal have the same widths in the same order, so that the wire returns all values."""


class ByUart:
    """A design, used through the two pins of its UART."""

    def __init__(self, dut: Any, interface: Interface) -> None:
        self.dut = dut
        self.interface = interface
        self.received = bytearray()

    async def begin(self) -> None:
        self.dut.uart_rxd.value = 1
        Clock(self.dut.clk, PERIOD_NS, unit="ns").start()
        await ClockCycles(self.dut.clk, 20)
        cocotb.start_soon(self._receive())

    async def _receive(self) -> None:
        while True:
            await FallingEdge(self.dut.uart_txd)
            await Timer(BIT_CYCLES * PERIOD_NS // 2, "ns")
            byte = 0
            for index in range(8):
                await Timer(BIT_CYCLES * PERIOD_NS, "ns")
                byte |= int(self.dut.uart_txd.value) << index
            self.received.append(byte)

    async def frames(self, count: int = 1) -> list[str]:
        """Wait for `count` frames; check their CRCs and return their bodies."""
        for _ in range(1000):
            if self.received.count(b"\n") == count:
                break
            await ClockCycles(self.dut.clk, 40)
        frames = bytes(self.received).splitlines()
        del self.received[:]
        assert len(frames) == count
        return [FRAMING.open(frame).decode() for frame in frames]

    async def ask(self, body: str, count: int = 1) -> list[str]:
        """Send a checked frame; return the bodies of `count` frames that answer it."""
        for byte in FRAMING.checked(body.encode()):
            for bit in (0, *(byte >> index & 1 for index in range(8)), 1):
                self.dut.uart_rxd.value = bit
                await ClockCycles(self.dut.clk, BIT_CYCLES)
        return await self.frames(count)

    async def set(self, path: str, value: float) -> None:
        signal = self.interface.signals[path]
        (word,) = signal.encode(value)
        assert await self.ask(f"W{signal.address:02X}{word:08X}") == [f"W{signal.address:02X}"]

    async def get(self, path: str) -> float:
        signal = self.interface.signals[path]
        (answer,) = await self.ask(f"R{signal.address:02X}")
        assert answer.startswith(f"R{signal.address:02X}")
        return signal.decode(int(answer[3:], 16))


class Board(ByUart):
    """The pins of a board with `bits` bits in its chain."""

    def __init__(self, dut: Any, interface: Interface, bits: int) -> None:
        super().__init__(dut, interface)
        self.chain_frame_cycles = 2 * (2 * bits + 2)

    async def begin(self) -> None:
        cocotb.start_soon(self._wire())
        await super().begin()

    async def _wire(self) -> None:
        """Connect the end of the chain to its start, as a wire would."""
        while True:
            self.dut.chain_in.value = self.dut.chain_out.value
            await self.dut.chain_out.value_change

    async def ask_counting(self, body: str, count: int) -> tuple[list[str], int]:
        """Do the same as `ask`; also return the number of cycles in which the gateway used its bus."""
        cycles = 0

        async def watch() -> None:
            nonlocal cycles
            while True:
                await RisingEdge(self.dut.clk)
                cycles += self.dut.gateway_inst.wb_cyc.value == 1

        watching = cocotb.start_soon(watch())
        answers = await self.ask(body, count)
        watching.cancel()
        return answers, cycles

    async def round_the_chain(self) -> None:
        """Wait until written values have passed the chain and the wire."""
        await ClockCycles(self.dut.clk, 2 * self.chain_frame_cycles)


@cocotb.test
async def the_walker_is_what_its_spec_says(dut: Any) -> None:
    walker = WALKER.interface()
    board = Board(dut, walker, 18 * 2 * 32)
    await board.begin()

    # The gateway reports the map that it was built for, and refuses addresses outside of the map.
    (configuration,) = await board.ask("Q")
    info = GatewayInfo.from_hex(configuration[1:].encode())
    assert Feature.FINGERPRINT in info.features
    assert info.build_id == walker.fingerprint
    assert await board.ask("R00") == ["X04"]
    assert await board.ask("W1000000001") == ["X04"]

    # Written values return through the chain.
    wanted = {"legs[0].coxa": 1.25, "legs[3].femur": -0.5, "legs[5].tibia": 2.0}
    for joint, angle in wanted.items():
        await board.set(f"{joint}.pos_sp", angle)
        await board.set(f"{joint}.spd_sp", abs(angle) / 2)
    await board.round_the_chain()
    for joint, angle in wanted.items():
        step = walker.signals[f"{joint}.cpos"].kind.step
        assert abs(await board.get(f"{joint}.cpos") - angle) <= step
        assert abs(await board.get(f"{joint}.spd") - abs(angle) / 2) <= step
    assert await board.get("legs[1].coxa.cpos") == 0

    # The group of the spec fits into the gateway, and has the same values.
    (group,) = walker.groups
    addresses = "".join(f"{address:02X}" for address in group.addresses)
    settings = f"{group.number:02X}01{group.divisor:04X}{len(group.addresses):02X}{addresses}"
    assert await board.ask(f"GS{settings}") == [f"GS{group.number:02X}"]
    answers, cycles = await board.ask_counting(f"GP{group.number:02X}", 2)
    # One cycle for each word, and one for the last answer.
    assert cycles == len(group.addresses) + 1
    answers.remove(f"GP{group.number:02X}")
    (sample,) = answers
    assert sample.startswith(f"P{group.number:02X}00")
    words = [int(sample[5 + 8 * index : 13 + 8 * index], 16) for index in range(len(group.addresses))]
    values = dict(zip(group.signals, words, strict=True))
    for joint, angle in wanted.items():
        assert [values[f"{joint}.cpos"]] == list(walker.signals[f"{joint}.pos_sp"].encode(angle))


@cocotb.test
async def blocks_and_masked_writes_reach_values_of_several_words_and_fields(dut: Any) -> None:
    board = Board(dut, ECHO.interface(), 56)
    await board.begin()
    assert await board.ask("WM10" + "89ABCDEF" + "00001234") == ["WM1002"]
    assert await board.ask("WK14" + "00000007" + "FFFFFFFD") == ["WK1400000000"]
    assert await board.ask("WK14" + "000000F8" + "FFFFFF90") == ["WK1400000005"]
    await board.round_the_chain()
    assert await board.ask_counting("RM1202", 1) == (["RM1202" + "89ABCDEF" + "00001234"], 3)
    assert await board.get("low_came") == 5
    assert await board.get("high_came") == -14
    # Of a value of several words, only the write to the last word takes effect.
    assert await board.ask("W1011111111") == ["W10"]
    await board.round_the_chain()
    assert await board.ask("RM1202") == ["RM1202" + "89ABCDEF" + "00001234"]
    assert await board.ask("W1100000001") == ["W11"]
    await board.round_the_chain()
    assert await board.ask("RM1202") == ["RM1202" + "11111111" + "00000001"]
