"""Bench: a gateway on AXI4-Lite answers the same requests as one on Wishbone."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.utils import get_sim_time

from gateware.bench.axi4_lite_master.bench_axi4_lite_master import FROM_SLAVE, Slave
from gateware.bench.streams import Sink, Source, start
from gateware.bench.unity_link.gateway import SESSION, checked, opening, with_id

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


MOST_NS = 20 * (3 * 64 + 200)
"""Maximum time to an answer in ns: the bus is first released after a timeout of 64 cycles; then an access times out."""


class _Gateway:
    """A gateway with a memory on its bus, whose channels are ready at random times."""

    def __init__(self, dut: SimHandleBase, pause: float) -> None:
        self.slave = Slave(dut, pause, "axi_")
        self._source = Source(dut.clk, dut.in_data, dut.in_valid, dut.in_ready)
        self._sink = Sink(dut.clk, dut.out_data, dut.out_valid, dut.out_ready)
        self._session = 0

    async def ask(self, body: bytes, expected: bytes) -> None:
        """Send a checked request, and check that the answer is the checked frame of `expected`."""
        self._sink.received.clear()
        await self._source.send(checked(body, self._session))
        answer = checked(expected, self._session, answers=True)
        assert bytes(await self._sink.wait_for(len(answer))) == answer, body

    async def open(self) -> None:
        """Begin a session with a plain frame."""
        self._sink.received.clear()
        await self._source.send(opening() + b"\r")
        answer = opening() + b"0000\r\n"
        assert bytes(await self._sink.wait_for(len(answer))) == answer
        self._session = SESSION


async def _begin(dut: SimHandleBase, pause: float) -> _Gateway:
    for name in ("in_data", "in_valid", "out_ready", *(f"axi_{name}" for name in FROM_SLAVE)):
        getattr(dut, name).value = 0
    await start(dut.clk, dut.rst)
    return _Gateway(dut, pause)


@cocotb.test
async def requests_read_and_write_the_bus(dut: SimHandleBase) -> None:
    for pause in (0.0, 0.4):
        gateway = await _begin(dut, pause)
        words = [random.Random(5).getrandbits(32) for _ in range(20)]
        block = b"".join(b"%08X" % word for word in words)
        await gateway.ask(b"W0A0000002A", b"W0A")
        await gateway.ask(b"R0A", b"R0A0000002A")
        await gateway.ask(b"WM20" + block, b"WM2014")
        await gateway.ask(b"RM2014", b"RM2014" + block)
        await gateway.ask(b"WK0A0000000F00000005", b"WK0A0000002A")
        await gateway.open()
        await gateway.ask(with_id(b"r", 0, b"0A"), with_id(b"r", 0, b"00000025"))
        await gateway.ask(b"GS000000010220210A", b"X03")
        await gateway.ask(b"GS00000001022021", b"GS00")
        assert gateway.slave.memory[0x0A * 4] == 0x25


@cocotb.test
async def errors_of_the_bus_are_answered_and_the_next_request_works(dut: SimHandleBase) -> None:
    gateway = await _begin(dut, 0.0)
    gateway.slave.failing = {0x30 * 4}
    await gateway.ask(b"R30", b"X04")
    await gateway.ask(b"W3000000001", b"X04")
    gateway.slave.silent = True
    await gateway.ask(b"R0A", b"X05")
    gateway.slave.silent = False
    await gateway.ask(b"W0A00000007", b"W0A")
    await gateway.ask(b"R0A", b"R0A00000007")


@cocotb.test
async def a_slave_that_never_answers_costs_each_access_an_error_and_no_request_its_answer(dut: SimHandleBase) -> None:
    gateway = await _begin(dut, 0.0)
    await gateway.open()
    await gateway.ask(b"GS00000001022021", b"GS00")
    gateway.slave.silent = True
    # The slave never answers the first access, a read or a write; no later access reaches it.
    for number, (letters, fields) in enumerate(
        ((b"r", b"0A"), (b"w", b"0B00000001"), (b"rm", b"2014"), (b"wm", b"20" + b"%08X" % 1 * 3), (b"r", b"30")) * 2
    ):
        asked_at = get_sim_time("ns")
        await gateway.ask(with_id(letters, number, fields), with_id(b"x", number, b"05"))
        assert get_sim_time("ns") - asked_at < MOST_NS
    for _ in range(2):
        await gateway.ask(b"R0A", b"X05")
        await gateway.ask(b"WK0A0000000F00000005", b"X05")
        # A sample is not published if its read fails.
        await gateway.ask(b"GP00", b"GP00")
    gateway.slave.end()
    gateway = await _begin(dut, 0.0)
    await gateway.ask(b"W0A00000007", b"W0A")
    await gateway.ask(b"R0A", b"R0A00000007")
