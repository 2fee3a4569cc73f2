"""Bench: a gateway without a datalink layer, for a person at a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb

from gateware.bench.unity_link.gateway import Gateway

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def every_line_is_a_plain_frame(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    for sent, answered in (
        (b"W0A12\r", b"W0A\r\n"),
        (b"R0A\r", b"R0A00000012\r\n"),
        (b"R0A\n", b"R0A00000012\r\n"),
        (b"r7FF0A\r", b"x7FF0A0000\r\n"),
        (b"K7FF1234\r", b"K7FF12340000\r\n"),
        (b"r7FF0A\r\n", b"r7FF00000012\r\n"),
        (b"\r\n\nrm8000A02\r", b"rm8000000001200000000\r\n"),
        (b"w801F000000012\r", b"w801\r\n"),
        (b"h802\r", b"h802000\r\n"),
        (b"K\n", b"K1234\r\n"),
        (b"R0ACB\n", b"X03\r\n"),
        (b"Y\r", b"X02\r\n"),
        (b"H\r", b"H\r\n"),
    ):
        assert await gateway.answer(sent) == answered


@cocotb.test
async def lines_survive_back_pressure_and_loss_is_told(dut: SimHandleBase) -> None:
    gateway = Gateway(dut, pause_in=0.3, pause_out=0.5)
    await gateway.begin()
    gateway.send(b"R10\r" * 20)
    gateway.send(b"R10\r", lost_before=2)
    gateway.send(b"\r", lost_before=0)
    gateway.send(b"H\n")
    await gateway.quiet()
    assert gateway.take() == b"R1000000000\r\n" * 20 + b"X09\r\n" * 2 + b"H\r\n"
