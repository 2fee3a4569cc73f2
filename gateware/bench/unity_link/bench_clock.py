"""Bench: base tick and timestamp run whatever the gateway does, and samples contain that timestamp."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.unity_link.gateway import Gateway, body_of, checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

TICK = 200
"""Cycles between two base ticks."""


@cocotb.test
async def neither_base_tick_nor_timestamp_waits_for_anything(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    if int(dut.groups.value):
        # The group is due at each third tick, and each of its samples has a timestamp.
        await gateway.ask(b"GS000900030120")
        await gateway.ask(b"GN00")
    dut.wait_states.value = 7
    gateway.send(checked(b"RM00FF") * 2)
    received = len(gateway.received)
    ticks, stamps, last = [], [], None
    for cycle in range(20 * TICK):
        await RisingEdge(dut.clk)
        now = int(dut.timestamp.value)
        assert last is None or now == last + 1
        last = now
        if dut.base_tick.value == 1:
            ticks.append(cycle)
        if dut.sample_strobe.value == 1:
            stamps.append(now)
    assert [tick - ticks[0] for tick in ticks] == [TICK * index for index in range(20)]
    await gateway.quiet()
    frames = bytes(gateway.received[received:]).splitlines(keepends=True)
    told = [int(body_of(frame)[5:13], 16) for frame in frames if frame.startswith(b"P")]
    assert told[: len(stamps)] == stamps
    assert bool(stamps) == bool(int(dut.groups.value))
