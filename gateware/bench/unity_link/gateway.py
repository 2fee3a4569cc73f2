"""Operates the gateway in a simulation: sends frames, divides received bytes into frames, and counts cycles.

One task does all work of a clock edge, because each task takes simulation time in every cycle.
"""

from __future__ import annotations

import json
import os
import random
from pathlib import Path
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from gateware.bench.streams import start
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import in_session

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

QUIET_CYCLES = 400
"""Longer than the gateway is silent during any request of the benches, even while it copies a list of 255 addresses."""


def note_figure(name: str, value: float) -> None:
    """Store a measured figure, the maximum for its name, in the file that the environment variable FIGURES names."""
    path = Path(os.environ["FIGURES"])
    figures = json.loads(path.read_text()) if path.exists() else {}
    figures[name] = max(value, figures.get(name, value))
    path.write_text(json.dumps(figures))


IDS = 16 ** GatewayInfo().id_digits


SESSION = 0x1234
"""Number of the session, for benches that need only one."""


def checked(body: bytes, session: int = 0, *, answers: bool = False) -> bytes:
    """Return the checked frame of a body as the host sends it in a session, or the gateway if `answers` is true."""
    seed = seed_of(session, from_gateway=answers) if in_session(body[0]) else 0
    return body + Crc().text(body, seed) + b"\n"


def body_of(frame: bytes, session: int = 0) -> bytes:
    """Return the body of a checked frame of the gateway, after checking its CRC."""
    body = frame[: -Crc().digits - 1]
    assert frame == checked(body, session, answers=True), frame
    return body


def opening(first: int = 0, session: int = SESSION) -> bytes:
    """Return the body of a `K` that begins a session."""
    return with_id(b"K", first, b"%04X" % session)


def with_id(letters: bytes, number: int, fields: bytes = b"") -> bytes:
    """Return the body of a message with an ID, or of a `K`."""
    return b"%s%0*X" % (letters, GatewayInfo().id_digits, number % IDS) + fields


class Gateway:
    """The gateway with its FIFO port.

    Args:
        dut: `unity_link_bench`.
        pause_in: probability (0 to 1) that a waiting byte is not offered in a cycle.
        pause_out: probability (0 to 1) that no byte is accepted in a cycle.
    """

    def __init__(self, dut: SimHandleBase, *, pause_in: float = 0.0, pause_out: float = 0.0, seed: int = 1) -> None:
        self.dut = dut
        self.pause_in = pause_in
        self.pause_out = pause_out
        self.cycle = 0
        self.session = 0
        """Number of the session that was begun last."""
        self.received = bytearray()
        self.sent_at: list[int] = []
        """Cycle at whose end the gateway accepted each byte."""
        self.received_at: list[int] = []
        """Cycle at whose end each byte of the gateway was accepted."""
        self.flushed_after: list[int] = []
        """Number of bytes received at each flush."""
        self.flushed_at: list[int] = []
        self._waiting: list[tuple[int, int]] = []
        self._next = 0
        self._rng = random.Random(seed)
        self._quiet = 0

    async def begin(self, *, session: bool = False) -> None:
        """Reset, start to transfer bytes, and begin a session if requested."""
        dut = self.dut
        dut.in_valid.value = 0
        dut.in_data.value = 0
        dut.in_lost.value = 0
        dut.out_ready.value = 0
        dut.trigger.value = 0
        dut.wait_states.value = 0
        await start(dut.clk, dut.rst)
        cocotb.start_soon(self._run())
        self.session = 0
        if session:
            await self.open()

    async def open(self, first: int = 0, session: int = SESSION) -> None:
        """Begin a session with a plain frame, like a person; it also accepts requests without an ID."""
        body, ended = opening(first, session), b"%04X" % self.session
        assert await self.answer(body + b"\r") == body + ended + b"\r\n"
        self.session = session

    def next_session(self) -> bytes:
        """Return the plain frame that begins another session, and use that session from now on."""
        self.session += 1
        return opening(0, self.session) + b"\r"

    def checked(self, *bodies: bytes) -> bytes:
        """Return checked frames of the session."""
        return b"".join(checked(body, self.session) for body in bodies)

    def answered(self, *bodies: bytes) -> bytes:
        """Return checked frames as the gateway sends them in the session."""
        return b"".join(checked(body, self.session, answers=True) for body in bodies)

    async def _run(self) -> None:
        dut, rng = self.dut, self._rng
        clk, in_valid, in_ready = dut.clk, dut.in_valid, dut.in_ready
        in_data, in_lost = dut.in_data, dut.in_lost
        out_valid, out_ready, out_data, out_flush = dut.out_valid, dut.out_ready, dut.out_data, dut.out_flush
        edge = RisingEdge(clk)
        offering = takes = False
        offered: tuple[int, int] | None = None
        while True:
            if not offering:
                offering = self._next < len(self._waiting) and not (self.pause_in and rng.random() < self.pause_in)
                if offering and self._waiting[self._next] != offered:
                    offered = self._waiting[self._next]
                    in_data.value, in_lost.value = offered
                in_valid.value = offering
            takes_now = not (self.pause_out and rng.random() < self.pause_out)
            if takes_now != takes:
                takes = takes_now
                out_ready.value = takes
            await edge
            self.cycle += 1
            self._quiet += 1
            if offering and in_ready.value == 1:
                offering = False
                self._next += 1
                self.sent_at.append(self.cycle)
                self._quiet = 0
            if out_valid.value == 1:
                self._quiet = 0
                if takes:
                    self.received.append(int(out_data.value))
                    self.received_at.append(self.cycle)
            if out_flush.value == 1:
                self.flushed_after.append(len(self.received))
                self.flushed_at.append(self.cycle)

    def send(self, data: bytes, *, lost_before: int | None = None) -> None:
        """Send bytes after the waiting ones; `lost_before` is the index of a byte before which others were lost."""
        self._waiting += [(byte, int(index == lost_before)) for index, byte in enumerate(data)]

    async def reset(self) -> None:
        """Reset the gateway for one cycle, and discard the waiting bytes except the one that is being offered."""
        self.session = 0
        self.dut.rst.value = 1
        await RisingEdge(self.dut.clk)
        self.dut.rst.value = 0
        del self._waiting[self._next + 1 :]
        await RisingEdge(self.dut.clk)

    async def sent(self) -> None:
        """Wait until all bytes were sent."""
        while self._next < len(self._waiting):
            await ClockCycles(self.dut.clk, 1)

    async def quiet(self, cycles: int = QUIET_CYCLES) -> None:
        """Wait until all bytes were sent and none was received for `cycles` cycles."""
        self._quiet = 0
        while self._quiet < cycles or self._next < len(self._waiting):
            await ClockCycles(self.dut.clk, max(1, cycles - self._quiet, len(self._waiting) - self._next))

    async def cycles(self, count: int) -> None:
        """Wait for clock cycles."""
        await ClockCycles(self.dut.clk, count)

    def take(self) -> bytes:
        """Return the bytes received since the last call."""
        data = bytes(self.received)
        del self.received[:]
        return data

    async def answer(self, data: bytes, *, count: int = 1, most_cycles: int = 20_000) -> bytes:
        """Send bytes and return the next `count` frames.

        Raises:
            AssertionError: if they are not received within `most_cycles`.
        """
        self.send(data)
        for _ in range(most_cycles):
            if self.received.count(b"\n") >= count and self._next == len(self._waiting):
                return self.take()
            await RisingEdge(self.dut.clk)
        raise AssertionError(f"{data!r} was answered by {bytes(self.received)!r} in {most_cycles} cycles")

    async def ask(self, body: bytes) -> bytes:
        """Send a body in a checked frame and return the body of the answer."""
        return body_of(await self.answer(self.checked(body)), self.session)
