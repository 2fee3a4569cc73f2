"""Bench: number of cycles for which blocks and samples occupy the bus, with a slave without wait states."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.unity_link.gateway import Gateway, checked, note_figure

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

WORDS = (1, 16, 255)


async def _cycles_on_the_bus(dut: SimHandleBase, gateway: Gateway, body: bytes) -> int:
    count = 0

    async def watch() -> None:
        nonlocal count
        while True:
            await RisingEdge(dut.clk)
            count += dut.wb_cyc.value == 1

    watching = cocotb.start_soon(watch())
    gateway.send(checked(body))
    # The answer to the longest block begins only after its last word was read.
    await gateway.quiet(4 * WORDS[-1])
    gateway.take()
    watching.cancel()
    return count


@cocotb.test
async def blocks_and_samples_have_the_bus_for_the_cycles_of_the_documentation(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    for words in WORDS:
        note_figure(f"block of {words}", await _cycles_on_the_bus(dut, gateway, b"RM10%02X" % words))
    listed = b"".join(b"%02X" % address for address in range(0x20, 0x30))
    await gateway.ask(b"GS00200001%02X" % 16 + listed)
    note_figure("sample of 16", await _cycles_on_the_bus(dut, gateway, b"GP00"))
