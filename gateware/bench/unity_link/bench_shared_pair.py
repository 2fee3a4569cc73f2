"""Bench: the whole gateway with a transceiver, on a pair of wires that it shares with the host.

`Pair` raises an AssertionError if both sides would drive the wires at once.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.streams import start
from gateware.bench.uart.bench_half_duplex import Pair
from gateware.bench.unity_link.bench_media import memory
from gateware.bench.unity_link.gateway import checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_QUIET_BITS = 40
"""Longer than the gateway takes from a request to its answer, and between two frames that it sends."""


@cocotb.test
async def each_request_is_answered_behind_its_last_byte_and_the_pair_is_free_again(dut: SimHandleBase) -> None:
    dut.in_valid.value = dut.out_ready.value = dut.trigger.value = 0
    pins = {"rxd": dut.uart_rxd, "txd": dut.uart_txd, "driver_enable": dut.uart_de}
    pair = Pair(SimpleNamespace(**pins, clock_hz=dut.clock_hz, baud=dut.baud))
    await start(dut.clk, dut.rst)
    cocotb.start_soon(memory(dut))
    await pair.begin()
    words = b"".join(b"%08X" % (number * 0x01020304) for number in range(30))
    for request, answer in (
        (checked(b"WM20" + words), checked(b"WM201E")),
        (checked(b"RM201E"), checked(b"RM201E" + words)),
        (checked(b"GS000000010122"), checked(b"GS00")),
        (checked(b"GP00"), checked(b"P0000" + words[16:24]) + checked(b"GP00")),
        # A posted write has no answer, unless it fails.
        (checked(b"WS2000000012"), b""),
        (checked(b"r0000A"), checked(b"x0000A0000")),
        # A frame ends within the bytes that the host sends: by the LF after a CR, and by noise.
        (b"R20\r\n", b"R2000000012\r\n"),
        (checked(b"R20")[:2] + b"\r" + checked(b"R20")[3:], b"X03\r\n" + checked(b"X01")),
    ):
        before = len(pair.line.received)
        await pair.far_end(request)
        await pair.bits(10 * len(answer) + _QUIET_BITS)
        assert bytes(pair.line.received[before:]) == answer
        assert len(pair.enabled_at) == len(pair.disabled_at)
        assert dut.uart_de.value == 0
