"""Noise is repeatable and has the given probability; a slow line overflows as its FIFOs determine."""

from __future__ import annotations

import tracemalloc
from collections import Counter
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.transport.buffered import HIGH_WATER
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.line import SlowLine

STREAM = bytes(range(256)) * 40


def spoiled(noise: Noise, data: bytes) -> bytes:
    return b"".join(noise.spoil(data))


@given(seed=st.integers(0, 2**32), cuts=st.lists(st.integers(0, len(STREAM)), max_size=20))
def test_a_seed_changes_the_same_bytes_however_the_stream_is_cut(seed: int, cuts: list[int]) -> None:
    chances = {"loss": 0.02, "flip": 0.02, "double": 0.02, "stall": 0.02}
    whole = spoiled(Noise(seed, **chances), STREAM)
    noise = Noise(seed, **chances)
    places = [0, *sorted(cuts), len(STREAM)]
    assert b"".join(spoiled(noise, STREAM[a:b]) for a, b in pairwise(places)) == whole


def test_another_seed_changes_other_bytes() -> None:
    assert spoiled(Noise(1, loss=0.01), STREAM) != spoiled(Noise(2, loss=0.01), STREAM)


@pytest.mark.parametrize("chance", [0.001, 0.01, 0.3, 1.0])
def test_bytes_are_lost_with_the_given_probability(chance: float) -> None:
    data = bytes(200_000)
    lost = len(data) - len(spoiled(Noise(7, loss=chance), data))
    deviation = (len(data) * chance * (1 - chance)) ** 0.5
    assert abs(lost - len(data) * chance) <= 5 * deviation


def test_a_flip_inverts_any_one_of_the_eight_bits() -> None:
    flips = Counter(spoiled(Noise(3, flip=0.1), bytes(50_000)))
    assert set(flips) == {0, 1, 2, 4, 8, 16, 32, 64, 128}


def test_a_duplicated_byte_arrives_twice_in_its_place() -> None:
    assert spoiled(Noise(1, double=1.0), b"abc") == b"aabbcc"


def test_a_line_without_noise_changes_no_byte() -> None:
    assert Noise(5).spoil(STREAM) == [STREAM]


@pytest.mark.parametrize(
    ("chances", "words"), [({"loss": -0.1}, "loss=-0.1"), ({"loss": 0.7, "flip": 0.7}, "together")]
)
def test_an_invalid_probability_is_refused(chances: dict[str, float], words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        Noise(0, **chances)


def test_a_noisy_line_changes_both_directions_independently() -> None:
    deaf = NoisyLine(VirtualGateway(), Noise(loss=1.0), Noise())
    assert deaf.receive(b"W1005\r", 0.0) == b""
    assert deaf.memory[0x10] == 0
    mute = NoisyLine(VirtualGateway(), Noise(), Noise(loss=1.0))
    assert mute.receive(b"W1005\r", 0.0) == b""
    assert mute.memory[0x10] == 5


def test_a_stall_delays_later_bytes_until_it_ends() -> None:
    line = NoisyLine(VirtualGateway(), Noise(), Noise(stall=1.0, stall_seconds=0.5))
    assert line.receive(b"H\r", 1.0) == b""
    assert line.next_due == 1.0 + 0.5
    assert line.advance(1.5) == b"H"
    assert line.advance(1.9) == b""
    assert line.advance(3.0) == b"\r\n"
    assert line.next_due is None


def test_a_stall_before_the_gateway_keeps_requests_waiting() -> None:
    line = NoisyLine(VirtualGateway(), Noise(stall=1.0, stall_seconds=0.5), Noise())
    assert line.receive(b"H\r", 0.0) == b""
    assert line.waiting == 2
    assert line.advance(1.0) == b"H\r\n"
    assert line.waiting == 0


def test_samples_pass_a_noisy_line_at_their_instants() -> None:
    line = NoisyLine(VirtualGateway(), Noise(), Noise())
    line.receive(b"GS0009000A0110\rGN00\r", 0.0)
    assert line.next_due == 1e-5
    assert line.advance(1e-5).startswith(b"P0000000001F4")


def slow_gateway(**changes: object) -> tuple[VirtualGateway, SlowLine]:
    features = Feature(0x7F) & ~Feature.FLOW_CONTROL
    info = GatewayInfo(**{"receive_fifo_bytes": 32, "transmit_fifo_bytes": 16, "features": features, **changes})  # type: ignore[arg-type]
    gateway = VirtualGateway(info)
    return gateway, SlowLine(gateway, 1000)


def test_a_response_that_fills_the_transmit_fifo_delays_the_next_request() -> None:
    _, line = slow_gateway()
    # 40 bytes of response at 1000 bytes/s: the last enters the FIFO of 16 bytes after 24 ms, and arrives after 40 ms.
    assert line.receive(b"RM0004\rH\r", 0.0) == b""
    assert line.next_due == pytest.approx(0.024)
    line.advance(0.0239)
    assert line.waiting == len(b"H\r")
    line.advance(0.0241)
    assert line.waiting == 0
    assert line.next_due == pytest.approx(0.040)
    assert line.advance(0.0399) == b""
    assert len(line.advance(0.0401)) == 40
    assert line.advance(0.0431) == b"H\r\n"


def test_bytes_beyond_the_receive_fifo_are_lost_and_reported_by_their_frame() -> None:
    _, line = slow_gateway()
    line.receive(b"RM00FF\r", 0.0)
    assert line.receive(b"W1001\rW1102\rW1203\rW1304\rW1405\rW1506\r", 0.001) == b""
    assert line.waiting == 32
    assert line.receive(b"lost as well\r", 0.002) == b""
    later = line.advance(10.0)
    assert later.endswith(b"0\r\nW10\r\nW11\r\nW12\r\nW13\r\nW14\r\n")
    # Two characters of the last write arrived, and its end arrives now.
    line.receive(b"\r", 10.0)
    assert line.advance(10.1) == b"X09\r\n"
    line.receive(b"H\r", 10.1)
    assert line.advance(10.2) == b"H\r\n"
    assert line.memory[0x15] == 0


def test_no_byte_is_lost_with_flow_control() -> None:
    _, line = slow_gateway(features=Feature(0x7F))
    line.receive(b"RM00FF\r", 0.0)
    line.receive(b"H\r" * 100, 0.001)
    assert line.waiting == 200
    assert line.advance(10.0).endswith(b"0\r\n" + b"H\r\n" * 100)


def test_samples_beyond_the_rate_of_the_line_are_overruns() -> None:
    gateway, line = slow_gateway()
    line.receive(b"GS000100640110\rGN00\r", 0.0)
    # 1000 samples per second, on a line of 1000 bytes per second.
    arrived = line.advance(10.0)
    assert len(arrived) == pytest.approx(10_000, rel=0.01)
    size = arrived.index(b"P", arrived.index(b"P") + 1) - arrived.index(b"P")
    still_in_the_fifo = line.advance(10.1)[: 3 * size].count(b"P")
    waiting = len(gateway.groups.ring.waiting)
    assert waiting == 256
    on_their_way = len(arrived) // size + still_in_the_fifo + waiting
    assert gateway.groups.overruns == pytest.approx(10_000 - on_their_way, abs=100)


def test_a_slow_line_passes_on_the_notice_of_a_trigger() -> None:
    gateway = VirtualGateway()
    line = NoisyLine(SlowLine(gateway, 1e6), Noise(), Noise())
    woken: list[bool] = []
    line.wake = lambda: woken.append(True)
    line.receive(b"GS000200010110\rGN00\r", 0.0)
    gateway.trigger(1.0)
    assert woken == [True]
    line.advance(0.9)
    assert line.next_due == 1.0
    line.advance(1.0)
    assert line.advance(1.1).startswith(b"P0000")


def test_a_line_without_a_rate_is_refused() -> None:
    with pytest.raises(ArgumentError, match="bytes_per_second=0"):
        SlowLine(VirtualGateway(), 0)


@pytest.mark.slow
@pytest.mark.parametrize("asked", [b"", b"RM00FF\r" * 10], ids=["samples", "answers"])
def test_a_stalled_line_buffers_no_more_than_a_socket(asked: bytes) -> None:
    line = NoisyLine(VirtualGateway(), Noise(), Noise(stall=0.01, stall_seconds=60))
    line.receive(b"GS000900010110\rGN00\r", 0.0)
    tracemalloc.start()
    try:
        for step in range(1, 1001):
            now = step / 1000
            line.advance(now)
            if asked and line.waiting < HIGH_WATER:
                line.receive(asked, now)
        # An unlimited buffer would keep more than 15 MB; a process that ran other tests allocates some memory itself.
        assert tracemalloc.get_traced_memory()[0] < 16 * HIGH_WATER
    finally:
        tracemalloc.stop()
