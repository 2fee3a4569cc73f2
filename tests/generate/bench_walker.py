"""Inside the simulator: the walker's whole generated gateware by its pins, a UART and a wire for the chain of the legs.

The frames are made by `unity_link.wire`, the signals by the same spec, and nothing here knows the VHDL.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, FallingEdge, Timer

from unity_link.generate.vhdl import fingerprint
from unity_link.spec import compile_file
from unity_link.wire.crc import Crc

PERIOD_NS = 40
BIT_CYCLES = 4
CHAIN_FRAME_CYCLES = 2 * (2 * 18 * 2 * 32 + 2)
WALKER = compile_file(Path(__file__).parents[2] / "examples" / "walker.ul").interface()


class Board:
    """The board's pins."""

    def __init__(self, dut: Any) -> None:
        self.dut = dut
        self.received = bytearray()

    async def begin(self) -> None:
        self.dut.uart_rxd.value = 1
        Clock(self.dut.clk, PERIOD_NS, unit="ns").start()
        cocotb.start_soon(self._wire())
        await ClockCycles(self.dut.clk, 20)
        cocotb.start_soon(self._receive())

    async def _wire(self) -> None:
        """Join the end of the chain to its beginning, as a wire does."""
        while True:
            self.dut.chain_in.value = self.dut.chain_out.value
            await self.dut.chain_out.value_change

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
        """Give the bodies of so many frames, once they have come; their checks must be right."""
        for _ in range(1000):
            if self.received.count(b"\n") == count:
                break
            await ClockCycles(self.dut.clk, 40)
        frames = bytes(self.received).splitlines()
        del self.received[:]
        assert [frame[-2:] for frame in frames] == [Crc().text(frame[:-2]) for frame in frames]
        assert len(frames) == count
        return [frame[:-2].decode() for frame in frames]

    async def ask(self, body: str, count: int = 1) -> list[str]:
        """Send a checked frame, and give the bodies of the frames that come."""
        for byte in body.encode() + Crc().text(body.encode()) + b"\n":
            for bit in (0, *(byte >> index & 1 for index in range(8)), 1):
                self.dut.uart_rxd.value = bit
                await ClockCycles(self.dut.clk, BIT_CYCLES)
        return await self.frames(count)

    async def set(self, path: str, value: float) -> None:
        signal = WALKER.signals[path]
        (word,) = signal.encode(value)
        assert await self.ask(f"W{signal.address:02X}{word:08X}") == [f"W{signal.address:02X}"]

    async def get(self, path: str) -> float:
        signal = WALKER.signals[path]
        (answer,) = await self.ask(f"R{signal.address:02X}")
        assert answer.startswith(f"R{signal.address:02X}")
        return signal.decode(int(answer[3:], 16))


@cocotb.test
async def everything_between_the_uart_and_the_chain_is_the_spec(dut: Any) -> None:
    """One test, as it begins with a reset at power-up, which no pin repeats."""
    board = Board(dut)
    await board.begin()

    # The gateway says which map it was built for, and refuses what is not on it.
    (configuration,) = await board.ask("Q")
    assert configuration.endswith(fingerprint(WALKER))
    assert await board.ask("R00") == ["X04"]
    assert await board.ask("W1000000001") == ["X04"]

    # What is written comes back round the chain.
    wanted = {"legs[0].coxa": 1.25, "legs[3].femur": -0.5, "legs[5].tibia": 2.0}
    for joint, angle in wanted.items():
        await board.set(f"{joint}.pos_sp", angle)
        await board.set(f"{joint}.spd_sp", abs(angle) / 2)
    await ClockCycles(dut.clk, 2 * CHAIN_FRAME_CYCLES)
    for joint, angle in wanted.items():
        step = WALKER.signals[f"{joint}.cpos"].kind.step
        assert abs(await board.get(f"{joint}.cpos") - angle) <= step
        assert abs(await board.get(f"{joint}.spd") - abs(angle) / 2) <= step
    assert await board.get("legs[1].coxa.cpos") == 0

    # The group of the spec fits into the gateway, and has the same values.
    (group,) = WALKER.groups
    addresses = "".join(f"{address:02X}" for address in group.addresses)
    settings = f"{group.number:02X}01{group.divisor:04X}{len(group.addresses):02X}{addresses}"
    assert await board.ask(f"GS{settings}") == [f"GS{group.number:02X}"]
    answers = await board.ask(f"GP{group.number:02X}", 2)
    answers.remove(f"GP{group.number:02X}")
    (sample,) = answers
    assert sample.startswith(f"P{group.number:02X}00")
    words = [int(sample[5 + 8 * index : 13 + 8 * index], 16) for index in range(len(group.addresses))]
    values = dict(zip(group.signals, words, strict=True))
    for joint, angle in wanted.items():
        assert [values[f"{joint}.cpos"]] == list(WALKER.signals[f"{joint}.pos_sp"].encode(angle))
