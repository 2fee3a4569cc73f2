"""The in-process transport behaves as a serial port, but is exact in time and bounded in memory."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import pytest

from support.simulated_time import ModelledTimeLoop, on_simulated_time
from unity_link.transport.buffered import HIGH_WATER
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.model_clock import MOST_LAG
from unity_link.virtual.transport import (
    MOST_DELIVERED,
    MOST_TAKEN,
    MOST_UNDELIVERED,
    PIECE,
    GatewayTransport,
)

if TYPE_CHECKING:
    from unity_link.virtual import Gateway

WORDS_WAITING = 512
"""Size of the buffer of waiting samples in the model's default configuration, in words."""


class Recorder(asyncio.Protocol):
    """Records its events with their times."""

    def __init__(self) -> None:
        self.received: list[tuple[float, bytes]] = []
        self.events: list[str] = []

    @property
    def data(self) -> bytes:
        return b"".join(data for _, data in self.received)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.events.append("made")

    def data_received(self, data: bytes) -> None:
        self.received.append((asyncio.get_running_loop().time(), data))

    def pause_writing(self) -> None:
        self.events.append("pause")

    def resume_writing(self) -> None:
        self.events.append("resume")

    def connection_lost(self, exc: Exception | None) -> None:
        self.events.append(f"lost {exc}")


async def connected(gateway: Gateway) -> tuple[GatewayTransport, Recorder]:
    protocol = Recorder()
    transport = await gateway.open(protocol)
    assert isinstance(transport, GatewayTransport)
    assert protocol.events == ["made"]
    return transport, protocol


async def turns(count: int = 50) -> None:
    for _ in range(count):
        await asyncio.sleep(0)


@on_simulated_time
async def test_bytes_written_in_one_turn_are_answered_in_one_read() -> None:
    transport, protocol = await connected(VirtualGateway())
    for address in range(100):
        transport.write(b"W%02X07\r" % address)
    assert protocol.received == []
    await turns()
    assert [data for _, data in protocol.received] == [b"".join(b"W%02X\r\n" % address for address in range(100))]


@on_simulated_time
async def test_samples_arrive_at_the_instants_at_which_they_are_due() -> None:
    transport, protocol = await connected(VirtualGateway())
    transport.write(b"GS000100640110\rGN00\r")
    await asyncio.sleep(0.01)
    transport.abort()
    times = [time for time, data in protocol.received if data.startswith(b"P")]
    assert times == pytest.approx([1e-5 + 1e-3 * index for index in range(10)], abs=1e-9)


@on_simulated_time
async def test_many_bytes_in_flight_are_taken_and_delivered_in_bounded_pieces() -> None:
    transport, protocol = await connected(VirtualGateway())
    transport.write(b"RM00FF\r" * 1000)
    await turns(200)
    assert len(protocol.data) == 1000 * (8 + 255 * 8 + 1) - 1000
    assert max(len(data) for _, data in protocol.received) <= MOST_DELIVERED


@on_simulated_time
async def test_a_protocol_that_does_not_read_is_paused_and_buffers_are_bounded() -> None:
    transport, protocol = await connected(VirtualGateway())
    transport.pause_reading()
    assert not transport.is_reading()
    sent = 0
    while "pause" not in protocol.events:
        transport.write(b"RM00FF\r" * 100)
        sent += 100
        await turns(5)
    assert transport.get_write_buffer_size() <= HIGH_WATER + 700
    most_answers = PIECE // 7 * 2050
    assert len(transport._to_protocol) <= HIGH_WATER + most_answers
    assert protocol.received == []
    transport.resume_reading()
    await turns(2000)
    assert protocol.events == ["made", "pause", "resume"]
    assert protocol.data == b"RM00FF" + (b"0" * 2040 + b"\r\nRM00FF") * (sent - 1) + b"0" * 2040 + b"\r\n"


@on_simulated_time
async def test_samples_for_a_protocol_that_does_not_read_are_overruns() -> None:
    gateway = VirtualGateway()
    transport, protocol = await connected(gateway)
    transport.write(b"GS000100010110\rGN00\r")
    await asyncio.sleep(0.001)
    transport.pause_reading()
    await asyncio.sleep(3600)
    assert len(transport._to_protocol) < MOST_UNDELIVERED + 100
    transport.resume_reading()
    await asyncio.sleep(0.01)
    transport.write(b"GX00\r")
    await asyncio.sleep(0.01)
    samples = protocol.data.count(b"\nP")
    assert samples + gateway.groups.overruns == pytest.approx(100_000 * 3600.011, abs=3)
    # Late samples in the transport, and samples that waited in the gateway.
    assert samples < MOST_UNDELIVERED / 16 + 1200 + WORDS_WAITING / 2


@on_simulated_time
async def test_a_busy_loop_catches_up_at_the_correct_instants_within_the_lag() -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    gateway = VirtualGateway()
    transport, protocol = await connected(gateway)
    transport.write(b"GS000900640110\rGN00\r")
    await asyncio.sleep(0)
    await asyncio.sleep(0)
    loop.jump(MOST_LAG / 2)
    await asyncio.sleep(0.001)
    stamps = [int(line[5:13], 16) for line in protocol.data.splitlines() if line.startswith(b"P")]
    assert stamps[:3] == [500, 50_500, 100_500]
    assert len(stamps) == 1 + round(MOST_LAG / 2 * 1000)
    assert gateway.groups.overruns == 0
    loop.jump(10 * MOST_LAG)
    await asyncio.sleep(0.001)
    assert gateway.groups.overruns == pytest.approx(10 * MOST_LAG * 1000 - WORDS_WAITING // 3, abs=2)
    transport.abort()


@on_simulated_time
async def test_a_trigger_wakes_the_loop() -> None:
    gateway = VirtualGateway()
    _, protocol = await connected(gateway)
    gateway.receive(b"GS000200010110\rGN00\r", 0.0)
    await asyncio.sleep(5)
    gateway.trigger(5.0)
    await asyncio.sleep(0.001)
    [(time, data)] = protocol.received
    assert time == 5.0
    assert data.startswith(b"P000000000000")


@on_simulated_time
async def test_answers_delayed_by_a_slow_line_arrive_when_it_has_space() -> None:
    transport, protocol = await connected(SlowLine(VirtualGateway(), 1000))
    transport.write(b"RM00FF\r" + b"H\r" * 3)
    await asyncio.sleep(10)
    assert protocol.data.endswith(b"H\r\nH\r\nH\r\n")
    assert protocol.received[-1][0] > 1.0


@pytest.mark.slow
@on_simulated_time
async def test_requests_wait_in_the_transport_if_a_slow_line_is_full() -> None:
    line = SlowLine(VirtualGateway(), 1e6)
    transport, protocol = await connected(line)
    transport.write(b"RM00FF\r" * 12_000)
    await turns()
    assert line.waiting <= HIGH_WATER + MOST_TAKEN
    await asyncio.sleep(100)
    assert protocol.data.count(b"\n") == 12_000


@on_simulated_time
async def test_closing_executes_written_requests_and_aborting_does_not() -> None:
    for end, word in (("close", 7), ("abort", 0)):
        gateway = VirtualGateway()
        transport, protocol = await connected(gateway)
        transport.write(b"W1007\r")
        getattr(transport, end)()
        assert transport.is_closing()
        transport.write(b"W1009\r")
        transport.close()
        await turns()
        assert gateway.memory[0x10] == word
        assert protocol.events == ["made", "lost None"]
        assert protocol.received == []


@on_simulated_time
async def test_a_closed_transport_leaves_no_timer_behind() -> None:
    transport, protocol = await connected(VirtualGateway())
    transport.write(b"GS000100010110\rGN00\r")
    await asyncio.sleep(0.001)
    transport.abort()
    count = len(protocol.received)
    await asyncio.sleep(10)
    assert len(protocol.received) == count


@on_simulated_time
async def test_a_gateway_may_be_connected_again_and_keeps_its_state() -> None:
    gateway = VirtualGateway()
    transport, _ = await connected(gateway)
    transport.write(b"W1007\rK0420001\r")
    await turns()
    transport.abort()
    transport, protocol = await connected(gateway)
    assert transport.get_extra_info("gateway") is gateway
    transport.write(b"R10\r")
    await turns()
    assert protocol.data == b"R1000000007\r\n"
    assert gateway.expected == 0x42
