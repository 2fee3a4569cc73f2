"""The compiled gateware at the virtual chip's pins, in simulated time."""

from __future__ import annotations

import asyncio
from itertools import pairwise

import pytest

import unity_link
from support.compilers import needs_cxx
from support.simulated_time import on_simulated_time
from unity_link.protocol.wire.crc import Crc
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.virtual.ft232h.bus import LoopClock, SimulatedClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.host import Transfer
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.ft232h.rtl_board import RtlBoard
from unity_link.virtual.rtl import RtlGateway

pytestmark = [pytest.mark.rtl, needs_cxx]
MICROFRAME = 125e-6
IN, OUT = 0x81, 0x02
URL = "ftdi-async://ftdi:232h/1"
RATE = 8e6


def checked(body: bytes) -> bytes:
    return body + Crc(8, 0x07).text(body) + b"\n"


def chip(image: bytes | None = None) -> tuple[VirtualFt232h, RtlGateway]:
    gateway = RtlGateway("ft232h")
    return VirtualFt232h(RtlBoard(gateway, RATE), image=image, clock=SimulatedClock()), gateway


def ask(device: VirtualFt232h, request: bytes) -> bytes:
    """Write a request, and read the bytes that arrive within the latency timer."""
    device.run(Transfer(OUT, data=request), 1.0)
    answer = Transfer(IN, size=512)
    device.run(answer, 1.0)
    return bytes(answer.data[2:])


def test_a_single_request_is_timed_to_the_cycle() -> None:
    gateway = RtlGateway("ft232h")
    gateway.set_pace(RATE)
    request = checked(b"R0A")
    passage = gateway.pass_pins(request, 1000, 1024)
    assert passage.sent == checked(b"R0A00000000")
    assert passage.taken == len(request)
    # A byte takes 6.25 cycles; the gateware adds the cycles that it also takes at a port as fast as itself.
    assert 19 * 6.25 <= passage.cycles <= 20 * 6.25 + 25


@pytest.mark.parametrize("mode", [1, 2])
def test_an_answer_arrives_in_the_next_microframe_after_a_siwu_pulse(mode: int) -> None:
    device, _ = chip()
    assert ask(device, checked(b"I%02X" % mode)) == checked(b"I%02X" % mode)
    began = device.clock.now()
    assert ask(device, checked(b"R0A")) == checked(b"R0A00000000")
    assert device.clock.now() - began <= 2 * MICROFRAME + 1e-9


def test_an_answer_without_a_pulse_waits_for_the_latency_timer() -> None:
    device, _ = chip()
    ask(device, checked(b"I00"))
    began = device.clock.now()
    assert ask(device, checked(b"R0A")) == checked(b"R0A00000000")
    assert 0.015 < device.clock.now() - began <= 0.016 + 2 * MICROFRAME


def test_a_group_of_255_addresses_is_set_up_despite_a_long_silence() -> None:
    device, _ = chip()
    assert ask(device, checked(b"I02")) == checked(b"I02")
    request = checked(b"GS01010190FF" + b"".join(b"%02X" % address for address in range(255)))
    assert ask(device, request) == checked(b"GS01")


def test_each_cycle_has_a_time() -> None:
    gateway = RtlGateway("ft232h")
    board = RtlBoard(gateway, RATE)
    device = VirtualFt232h(board, clock=SimulatedClock())
    ask(device, checked(b"I02"))
    began = device.clock.now()
    ask(device, checked(b"W0A00000012"))
    # Within the microframe in which the request was sent; a cycle is a fiftieth of a microsecond.
    assert began - 1e-9 <= board.time_of(gateway.cycles) <= device.clock.now() + 1e-9
    assert board.time_of(gateway.cycles + 1) - board.time_of(gateway.cycles) == pytest.approx(20e-9)


def test_cycles_pass_only_while_something_can_move() -> None:
    device, gateway = chip()
    ask(device, checked(b"R0A"))
    spent = gateway.cycles
    device.run(Transfer(IN, size=512), 1.0)
    assert gateway.cycles == spent
    assert spent < 1000


def test_bytes_without_space_in_the_chip_are_sent_later() -> None:
    device, _ = chip()
    count = 200
    # No program reads, so the chip's FIFO of 1 KiB fills, then the gateway's, then both in the other direction.
    requests = Transfer(OUT, data=checked(b"R0A") * count)
    with device.changed:
        device.host.submit(requests, device.now())
    device.clock.wait(device.changed, 0.01)
    received = b""
    while len(received) < 14 * count:
        answer = Transfer(IN, size=512)
        device.run(answer, 1.0)
        received += bytes(answer.data[2:])
    assert received == checked(b"R0A00000000") * count


def test_no_byte_passes_if_the_pins_are_no_fifo() -> None:
    device, gateway = chip(build_eeprom("UART", "UL000001"))
    assert ask(device, checked(b"R0A")) == b""
    assert gateway.cycles == 0


@on_simulated_time
async def test_a_link_reads_writes_and_subscribes_through_the_chip() -> None:
    device = VirtualFt232h(RtlBoard(RtlGateway("ft232h"), RATE), clock=LoopClock())
    with installed(VirtualBus(device)):
        async with unity_link.connect(URL, timeout=60) as link:
            addresses = list(range(256))
            await link.write_many(addresses, addresses)
            assert (await link.read_many(addresses)).tolist() == addresses
            async with link.subscribe([3, 4], rate_hz=10_000) as samples:
                taken = [await anext(samples) for _ in range(50)]
            assert link.statistics.repetitions == 0
    assert all(sample.values.tolist() == [3, 4] for sample in taken)
    times = [sample.time for sample in taken if sample.time is not None]
    # The gateware's own clock makes the times exact to the cycle.
    assert [round((after - before) * 1e9) for before, after in pairwise(times)] == [100_000] * 49


@pytest.mark.slow
@on_simulated_time
async def test_time_passes_for_groups_while_no_byte_passes() -> None:
    device = VirtualFt232h(RtlBoard(RtlGateway("ft232h"), RATE), clock=LoopClock())
    with installed(VirtualBus(device)):
        async with unity_link.connect(URL, timeout=60) as link, link.subscribe(5, rate_hz=1000) as samples:
            await asyncio.sleep(0.0105)
            assert len(await samples.take()) in (10, 11)
