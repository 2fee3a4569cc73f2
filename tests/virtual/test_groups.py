"""Groups publish at the correct instants."""

from __future__ import annotations

import re
from typing import NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

PERIODIC, TRIGGER, STAMPED, ON_CHANGE, PLAIN = 1, 2, 8, 16, 32
WORDS_WAITING = 512
"""Size of the buffer of waiting samples, in words, if groups have up to 255 addresses."""


CRC = Crc()


class Clocked:
    """A device whose words are the time in microseconds."""

    def read(self, offset: int, now: float) -> int:
        return round(now * 1e6)

    def write(self, offset: int, value: int, now: float) -> None:
        pass


class Sample(NamedTuple):
    group: int
    sequence: int
    rest: bytes


def samples(data: bytes) -> list[Sample]:
    found = []
    for line in data.split(b"\n"):
        if line.startswith(b"P"):
            body = line[:-1] if line.endswith(b"\r") else line[: -CRC.digits]
            found.append(Sample(int(body[1:3], 16), int(body[3:5], 16), body[5:]))
    return found


def stamps(data: bytes) -> list[int]:
    return [int(sample.rest[:8], 16) for sample in samples(data)]


def sequences(data: bytes) -> list[int]:
    return [sample.sequence for sample in samples(data)]


def send(gateway: VirtualGateway, *bodies: str, now: float = 0.0) -> bytes:
    return gateway.receive("".join(body + "\r" for body in bodies).encode(), now)


def checked(body: bytes) -> bytes:
    return body + CRC.text(body) + b"\n"


def setting(group: int, flags: int, divisor: int, *addresses: int) -> str:
    return f"GS{group:02X}{flags:02X}{divisor:04X}{len(addresses):02X}" + "".join(f"{a:02X}" for a in addresses)


def test_a_group_publishes_at_multiples_of_the_base_tick() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | STAMPED, 10, 0x10), "GN00")
    # Base tick of 100 kHz, clock of 50 MHz: the first tick is at clock 500, the next sample ten ticks later.
    assert stamps(gateway.advance(0.000_311)) == [500, 5500, 10500, 15500]
    assert gateway.next_due == pytest.approx(0.000_410, abs=1e-12)


@given(calls=st.lists(st.floats(0, 0.01), max_size=30), divisor=st.integers(1, 50))
def test_the_times_of_calls_do_not_change_the_samples(calls: list[float], divisor: int) -> None:
    gateway = VirtualGateway()
    gateway.attach(Clocked(), [0x10])
    send(gateway, setting(0, PERIODIC | STAMPED, divisor, 0x10), "GN00")
    sent = b"".join(gateway.advance(now) for now in [*sorted(calls), 0.01])
    ticks = range(1, 1001, divisor)
    assert [sample.rest for sample in samples(sent)] == [b"%08X%08X" % (500 * tick, 10 * tick) for tick in ticks]
    assert sequences(sent) == [index % 256 for index in range(len(ticks))]


def test_advancing_to_each_due_time_returns_one_sample() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 7, 0x10), "GN00", now=1234.5)
    count = 0
    while (due := gateway.next_due) is not None and due < 1234.6:
        assert len(samples(gateway.advance(due))) == 1
        count += 1
    assert count == len(range(1, 10_000, 7))


def test_timestamps_wrap_at_32_bits() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | STAMPED, 1, 0x10))
    wrap = 2**32 / 50e6
    gateway.advance(wrap - 5e-6)
    send(gateway, "GN00", now=wrap - 5e-6)
    first, second = stamps(gateway.advance(wrap + 15e-6))
    assert second == first + 500
    assert first < 500


def test_a_clock_that_is_no_multiple_of_the_base_causes_no_drift() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=3_000_000, clock_hz=10_000))
    send(gateway, setting(0, PERIODIC | STAMPED, 1, 0x10), "GN00")
    assert stamps(gateway.advance(0.0021)) == [3, 6, 10, 13, 16, 20]


def test_groups_due_at_the_same_tick_publish_in_the_order_of_their_numbers() -> None:
    gateway = VirtualGateway()
    for group in (3, 1, 2):
        send(gateway, setting(group, PERIODIC, group, 0x10), f"GN{group:02X}")
    gateway.advance(0.000_065)
    assert [sample.group for sample in samples(gateway.advance(0.000_070))] == [1, 2, 3]


def test_256_groups_of_255_words_publish_together() -> None:
    gateway = VirtualGateway()
    for group in range(256):
        send(gateway, setting(group, PERIODIC, 1000, *range(255)), f"GN{group:02X}")
    published = gateway.advance(0.0101)
    assert [sample.group for sample in samples(published)] == list(range(256)) * 2
    assert all(len(sample.rest) == 255 * 8 for sample in samples(published))


def test_a_trigger_makes_running_groups_with_the_flag_due_at_its_instant() -> None:
    gateway = VirtualGateway()
    for group, flags in enumerate((TRIGGER | STAMPED, PERIODIC, TRIGGER | STAMPED, TRIGGER)):
        send(gateway, setting(group, flags, 1000, 0x10))
    send(gateway, "GN00", "GN01", "GN02")
    gateway.trigger(0.002)
    assert gateway.next_due == pytest.approx(1e-5)
    gateway.advance(0.001)
    assert gateway.next_due == 0.002
    published = gateway.advance(0.005)
    assert [(sample.group, sample.rest[:8]) for sample in samples(published)] == [(0, b"000186A0"), (2, b"000186A0")]


def test_a_restarted_group_begins_at_the_next_tick() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | STAMPED, 100, 0x10), "GN00")
    assert stamps(gateway.advance(0.000_5)) == [500]
    assert stamps(send(gateway, "GN00", now=0.000_5) + gateway.advance(0.001)) == [51 * 500]


def test_a_restarted_group_continues_its_count() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    assert sequences(gateway.advance(0.000_031)) == [0, 1, 2]
    send(gateway, "GX00", now=0.000_032)
    assert (gateway.next_due, gateway.advance(1.0)) == (None, b"")
    assert sequences(send(gateway, "GN00", now=1.0) + gateway.advance(1.000_011)) == [3]


def test_a_session_stops_all_groups_and_keeps_their_settings() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00", "K0000001")
    assert (gateway.next_due, gateway.advance(1.0)) == (None, b"")
    assert sequences(send(gateway, "GP00", now=1.0)) == [0]


def test_on_change_publishes_the_first_sample_and_then_changes_only() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | ON_CHANGE, 1, 0x10), "GN00")
    assert sequences(gateway.advance(0.001_001)) == [0]
    gateway.memory[0x10] = 7
    assert sequences(gateway.advance(0.002_001)) == [1]
    assert sequences(send(gateway, "GP00", "GP00", now=0.002_002)) == [2, 3]
    assert sequences(gateway.advance(0.003_001)) == []
    assert sequences(send(gateway, "GN00", now=0.003_001) + gateway.advance(0.004_001)) == [4]


def test_samples_without_space_wait_and_are_sent_in_order() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    assert sequences(gateway.advance(0.000_051, room=0)) == []
    # Space for one byte is enough to send a sample, because the line takes it byte by byte.
    assert sequences(gateway.advance(0.000_061, room=len(checked(b"P000000000000")) + 1)) == [0, 1]
    assert gateway.next_due == pytest.approx(0.000_07)
    assert sequences(gateway.advance(0.000_081)) == [2, 3, 4, 5, 6, 7]
    assert gateway.groups.overruns == 0


def test_a_sample_without_space_in_the_buffer_is_dropped_and_counted() -> None:
    gateway = VirtualGateway()
    # Samples of 257 words and of 2 words: beside one of the first, the buffer has space for 127 of the others.
    send(gateway, setting(0, PERIODIC | STAMPED, 1000, *range(255)), setting(1, PERIODIC, 1, 0x10), "GN00", "GN01")
    gateway.advance(0.000_001)
    assert gateway.advance(0.030_001, room=0) == b""
    left = samples(gateway.advance(0.030_001))
    assert [sample.sequence for sample in left if sample.group == 0] == [0]
    assert [sample.sequence for sample in left if sample.group == 1] == [number % 256 for number in range(127)]
    assert gateway.groups.overruns == (3 - 1) + (3000 - 127)
    assert sequences(gateway.advance(0.030_011)) == [3, 3000 % 256]


def test_waiting_samples_make_a_gateway_due() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, TRIGGER, 1, 0x10), "GN00")
    gateway.trigger(0.001)
    gateway.advance(0.002, room=0)
    assert gateway.next_due == pytest.approx(0.003)
    assert sequences(gateway.advance(0.003)) == [0]
    assert gateway.next_due is None


def test_waiting_samples_and_responses_are_sent_alternately() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    gateway.advance(0.000_031, room=0)
    answers = send(gateway, "W1005", "H", "WS1005", now=0.000_031) + gateway.receive(checked(b"H") * 2, 0.000_031)
    assert re.findall(rb"^[G-Z]+", answers, re.MULTILINE) == [b"W", b"P", b"H", b"P", b"H", b"P", b"H"]


@pytest.mark.parametrize(
    ("command", "answer"),
    [
        ("GX00", "GX00"),
        ("GN00", "GN00"),
        (setting(0, PERIODIC, 1, 0x20), "GS00"),
        (setting(2, 0, 1, 0x20), "GS02"),
        ("gx00000", "gx000"),
        # Errors instead of such a response.
        (setting(0, PERIODIC, 0, 0x20), "X06"),
        ("GN07", "X06"),
        ("gx00007", "x00006"),
    ],
)
def test_waiting_samples_are_sent_before_the_answer_to_a_group_command(command: str, answer: str) -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), setting(1, PERIODIC, 2, 0x10), "K0000001", "GN00", "GN01")
    gateway.advance(0.000_101, room=0)
    frames = send(gateway, command, "H", now=0.000_101).splitlines()
    assert [frame[:1] for frame in frames[:-2]] == [b"P"] * 15
    assert frames[-2:] == [answer.encode(), b"H"]


def test_a_session_discards_the_waiting_samples() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    gateway.advance(0.000_101, room=0)
    assert send(gateway, "K0000001", now=0.000_101) == b"K00000010000\r\n"
    assert (gateway.next_due, gateway.advance(0.01)) == (None, b"")


def test_the_crc_of_a_sample_depends_on_the_session() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, 0, 1, 0x10))
    without = gateway.receive(checked(b"GP00"), 0.0)
    assert without.startswith(checked(b"P000000000000"))
    send(gateway, "K0001234")
    seed = seed_of(0x1234, from_gateway=True)
    body = b"P000100000000"
    assert gateway.receive(checked(b"GP00"), 0.0).startswith(b"%b%04X\n" % (body, CRC.of(body, seed)))


def test_a_requested_sample_follows_waiting_ones_and_precedes_the_response() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    gateway.advance(0.000_031, room=0)
    frames = send(gateway, "GP00", now=0.000_031)
    assert sequences(frames) == [0, 1, 2, 3]
    assert frames.endswith(b"GP00\r\n")


def test_a_reset_discards_the_waiting_samples() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    gateway.advance(0.001, room=0)
    gateway.reset()
    assert (gateway.next_due, gateway.advance(0.002)) == (None, b"")


def test_overruns_of_years_are_counted_at_once() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 3, 0x10), "GN00")
    gateway.advance(1e8, room=0)
    waiting = len(samples(gateway.advance(1e8)))
    assert waiting == WORDS_WAITING / 2
    assert gateway.groups.overruns == (10**13 - 1) // 3 + 1 - waiting


def test_overruns_of_a_group_on_change_keep_its_last_sample() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | ON_CHANGE, 1, 0x10), setting(1, TRIGGER, 1, *range(255)), "GN00", "GN01")
    gateway.advance(0.000_011)
    # Two samples of 256 words fill the buffer.
    gateway.trigger(0.000_012)
    gateway.trigger(0.000_013)
    gateway.advance(0.000_041, room=0)
    assert 0 not in [sample.group for sample in samples(gateway.advance(0.000_051))]
    gateway.memory[0x10] = 1
    assert sequences(gateway.advance(0.000_061)) == [4]


def test_a_trigger_or_a_request_without_space_is_an_overrun() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, TRIGGER, 1, 0x10), setting(1, PERIODIC, 100, *range(255)), "GN00", "GN01")
    # Two samples of 256 words fill the buffer.
    gateway.trigger(0.001_5)
    assert gateway.advance(0.001_6, room=0) == b""
    assert [sample.group for sample in samples(send(gateway, "GP00", now=0.001_6))] == [1, 1]
    assert gateway.groups.overruns == 2
    assert sequences(send(gateway, "GP00", now=0.001_6)) == [2]


def test_a_sample_whose_bus_read_fails_is_not_sent_and_counts() -> None:
    gateway = VirtualGateway()
    gateway.attach(Failing(), [0x11])
    send(gateway, setting(0, PERIODIC, 1, 0x10, 0x11), "GN00")
    assert gateway.advance(0.000_031) == b""
    gateway.detach([0x11])
    assert sequences(gateway.advance(0.000_041)) == [3]


@pytest.mark.parametrize(
    ("flag", "feature"),
    [(TRIGGER, Feature.EXTERNAL_TRIGGERS), (4, Feature.SEND_IMMEDIATE), (STAMPED, Feature.TIMESTAMPS)],
)
def test_flags_that_the_gateway_was_not_built_for_are_refused(flag: int, feature: Feature) -> None:
    assert send(VirtualGateway(), setting(0, flag, 1, 0x10)) == b"GS00\r\n"
    without = VirtualGateway(GatewayInfo(features=Feature(0x7F) & ~feature))
    assert send(without, setting(0, flag, 1, 0x10)) == b"X06\r\n"
    assert send(without, setting(0, PERIODIC | ON_CHANGE | PLAIN, 1, 0x10)) == b"GS00\r\n"


@pytest.mark.parametrize("flags", [PERIODIC, TRIGGER, PERIODIC | ON_CHANGE, TRIGGER | STAMPED])
def test_a_half_duplex_gateway_has_no_groups_that_publish_by_themselves(flags: int) -> None:
    gateway = VirtualGateway(GatewayInfo(features=GatewayInfo().features | Feature.HALF_DUPLEX))
    assert send(gateway, setting(0, flags, 1, 0x10)) == b"X06\r\n"
    assert send(gateway, setting(0, STAMPED | ON_CHANGE | PLAIN, 1, 0x10), "GP00").startswith(b"GS00\r\nP0000")


def test_plain_groups_publish_plain_frames() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC | PLAIN, 1, 0x10), "GN00")
    assert gateway.advance(0.000_011) == b"P000000000000\r\n"


def test_due_samples_are_sent_before_the_answer_to_a_later_request() -> None:
    gateway = VirtualGateway()
    send(gateway, setting(0, PERIODIC, 1, 0x10), "GN00")
    answer = send(gateway, "W1005", now=0.000_025)
    assert samples(answer) == [Sample(0, 0, b"00000000"), Sample(0, 1, b"00000000")]
    assert answer.endswith(b"W10\r\n")
