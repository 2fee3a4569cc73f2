"""Bench: the VHDL, with the clock, the medium and the bus of `unity_link/virtual/rtl/shim.cc`."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge
from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def it_sends_what_the_compiled_gateware_sent(dut: SimHandleBase) -> None:
    plan = json.loads(Path(os.environ["PLAN"]).read_text())  # noqa: ASYNC240  (no loop waits in a simulation)
    sent = [tuple(entry) for entry in plan["sent"]]
    waiting = list(bytes.fromhex(plan["requests"]))
    waiting.reverse()
    starts, length = plan["triggers"]
    memory: dict[int, int] = {}
    ack = err = read_data = 0
    got: list[tuple[int, int]] = []
    flushed: list[int] = []
    for name in ("in_valid", "in_data", "in_lost", "out_ready", "trigger", "wb_ack", "wb_err", "wb_dat_i", "wb_stall"):
        getattr(dut, name).value = 0
    cocotb.start_soon(Clock(dut.clk, 20, unit="ns").start())
    dut.rst.value = 1
    await ClockCycles(dut.clk, 5)
    dut.rst.value = 0
    cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
    for cycle in range(plan["cycles"]):
        dut.in_valid.value = int(bool(waiting))
        dut.in_data.value = waiting[-1] if waiting else 0
        dut.out_ready.value = 1
        dut.wb_ack.value, dut.wb_err.value, dut.wb_dat_i.value = ack, err, read_data
        raised = any(at <= cycle < at + length for at in starts)
        dut.trigger.value = (1 << len(dut.trigger)) - 1 if raised else 0
        await ReadOnly()
        if waiting and dut.in_ready.value == 1:
            waiting.pop()
        if dut.out_valid.value == 1:
            got.append((cycle, int(dut.out_data.value)))
        if dut.out_flush.value == 1:
            flushed.append(cycle)
        access = dut.wb_cyc.value == 1 and dut.wb_stb.value == 1 and not (ack or err)
        ack = err = 0
        if access:
            ack, err, read_data = _access(dut, memory, plan)
        await RisingEdge(dut.clk)
    for number, (ours, theirs) in enumerate(zip(got, sent, strict=False)):
        assert ours == theirs, (
            f"byte {number}: VHDL in cycle {ours[0]} {ours[1]:#x}, compiled {theirs[0]} {theirs[1]:#x}"
        )
    assert len(got) == len(sent)
    assert flushed == plan["flushed"]


def _access(dut: SimHandleBase, memory: dict[int, int], plan: dict[str, int]) -> tuple[int, int, int]:
    """Answer one access as the shim does; return ack, err and the word."""
    address, write = int(dut.wb_adr.value), dut.wb_we.value == 1
    value = int(dut.wb_dat_o.value) if write else 0
    if address == plan["error_at"]:
        return 0, 1, value
    if address == plan["silence_at"]:
        return 0, 0, value
    if write:
        memory[address] = value
    else:
        value = memory.get(address, 0)
    return 1, 0, value
