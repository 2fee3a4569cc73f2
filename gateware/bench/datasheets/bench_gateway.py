"""Bench for the pictures of the whole gateway: its FIFO port and its Wishbone bus."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, RisingEdge

from gateware.bench.datasheets.window import Picture
from gateware.bench.unity_link.gateway import Gateway, checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


WORDS = (0x2A, 0x2B, 0x2C, 0x2D)


async def _gateway(dut: SimHandleBase) -> Gateway:
    gateway = Gateway(dut)
    await gateway.begin()
    for address, word in enumerate(WORDS, 0x10):
        await gateway.ask(b"W%02X%08X" % (address, word))
    await gateway.ask(b"R10")
    await gateway.quiet()
    return gateway


async def _answered(dut: SimHandleBase, gateway: Gateway, picture: Picture, count: int = 1) -> None:
    """Wait for answers; the cycles are numbered from the edge at which the last byte of the request was accepted."""
    await FallingEdge(dut.in_valid)
    picture.zero()
    while gateway.received.count(b"\n") < count:
        await RisingEdge(dut.clk)
    await ClockCycles(dut.clk, 1)


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def read(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    with Picture("read") as picture:
        gateway.send(checked(b"R10"))
        await _answered(dut, gateway, picture)
    assert gateway.take() == checked(b"R100000002A")


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def write(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    with Picture("write") as picture:
        gateway.send(checked(b"W100000002E"))
        await _answered(dut, gateway, picture)
    assert gateway.take() == checked(b"W10")


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def block(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    gateway.send(checked(b"RM1004"))
    await RisingEdge(dut.wb_cyc)
    await RisingEdge(dut.clk)
    with Picture("block", before=20) as picture:
        picture.zero()
        await ClockCycles(dut.clk, 22)
    await gateway.quiet()
    assert gateway.take() == checked(b"RM1004" + b"".join(b"%08X" % word for word in WORDS))


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def sample(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    assert await gateway.ask(b"GS0002000103101112") == b"GS00"
    assert await gateway.ask(b"GN00") == b"GN00"
    await gateway.quiet()
    with Picture("sample", behind=20) as picture:
        await ClockCycles(dut.clk, 1)
        dut.trigger.value = 1
        picture.zero()
        await ClockCycles(dut.clk, 3)
        dut.trigger.value = 0
        while not gateway.received:
            await RisingEdge(dut.clk)
        await ClockCycles(dut.clk, 3)
    await gateway.quiet()
    assert gateway.take() == checked(b"P0000" + b"".join(b"%08X" % word for word in WORDS[:3]))


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def timeout(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    gateway.send(checked(b"RE8") + checked(b"R10"))
    await RisingEdge(dut.wb_cyc)
    with Picture("timeout", before=40) as picture:
        await RisingEdge(dut.clk)
        picture.zero()
        while gateway.received.count(b"\n") < 2:
            await RisingEdge(dut.clk)
    assert gateway.take() == checked(b"X05") + checked(b"R100000002A")
