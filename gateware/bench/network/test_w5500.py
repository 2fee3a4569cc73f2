"""The compiled gateway with a W5500, a model of the chip: its normal behaviour and its faults."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import pytest

from gateware.bench.network.host import (
    HEADERS,
    Host,
    carried,
    checked,
    ping,
    question,
    to_all,
    write_over_a_bad_line,
)
from gateware.bench.network.wire import CLOCK_HZ, Wire
from unity_link.protocol.wire.discovery import ask, read_answer

if TYPE_CHECKING:
    from collections.abc import Callable

MOST_DATA = 1472
W5500 = {"physical": "w5500"}


@pytest.fixture
def wire() -> Wire:
    return Wire(W5500)


def answers(wire: Wire, *data: bytes) -> list[bytes]:
    """Put pings on the cable all at once, and return the payloads of the answers."""
    for number, each in enumerate(data):
        wire.put(ping(each, number))
    found: list[bytes] = []
    while len(found) < len(data):
        wire.run(CLOCK_HZ // 100, 1)
        taken = wire.take()
        assert taken, f"{len(found)} of {len(data)} pings are answered"
        found += [frame.body[HEADERS:] for frame in taken]
    return found


def asked(host: Host, body: bytes) -> bytes:
    """Return the answer to a frame of the host's session."""
    return host.ask(host.datagram(checked(body, number=host.number)))


def padded(data: bytes) -> bytes:
    return data.ljust(60 - HEADERS, b"\0")


@pytest.mark.parametrize("busy", [0, 3])
@pytest.mark.parametrize("first", [0, 0xFF00])
def test_frames_of_all_sizes_pass_at_every_position_of_the_pointers(wire: Wire, first: int, busy: int) -> None:
    rng = random.Random(first + busy)
    wire.spoil(first=first, busy=busy)
    wire.lose_power()
    wire.run(CLOCK_HZ // 100)
    assert wire.is_open()
    sizes = [0, 17, 18, 19, MOST_DATA, *(rng.randrange(MOST_DATA) for _ in range(10))]
    for size in sizes:
        data = rng.randbytes(size)
        assert answers(wire, data) == [padded(data)]


def test_frames_faster_than_the_spi_are_kept_or_lost_as_a_whole(wire: Wire) -> None:
    rng = random.Random(1)
    given = [rng.randbytes(1200) for _ in range(40)]
    for number, data in enumerate(given):
        wire.put(ping(data, number))
    wire.run(CLOCK_HZ // 25)
    found = [frame.body[HEADERS:] for frame in wire.take()]
    left = iter(given)
    assert all(data in left for data in found)
    assert 10 < len(found) < len(given)
    assert answers(wire, given[0]) == [given[0]]


def test_a_host_reads_and_writes_in_a_session(wire: Wire) -> None:
    host = Host(wire)
    host.open(0)
    for number in range(200):
        address = number % 250
        wrote = asked(host, b"w%03X%02X%08X" % (2 * number, address, number))
        assert wrote.endswith(checked(b"w%03X" % (2 * number), number=host.number, answers=True))
        read = asked(host, b"r%03X%02X" % (2 * number + 1, address))
        assert read.endswith(checked(b"r%03X%08X" % (2 * number + 1, number), number=host.number, answers=True))
    assert wire.writes() == [(number % 250, number) for number in range(200)]


@pytest.mark.parametrize(
    ("frames", "seed"), [(200, 0), *(pytest.param(25_000, seed, marks=pytest.mark.campaign) for seed in range(1, 3))]
)
def test_over_a_bad_line_all_is_done_once(wire: Wire, frames: int, seed: int) -> None:
    """The chip itself drops damaged and truncated frames."""
    counts = write_over_a_bad_line(
        wire,
        frames,
        random.Random(seed),
        put=lambda wire, body, _: wire.put(body),
        spoilt={},
        foreign=[to_all(b"R00\r"), question(to=bytes.fromhex("020000000001")), ping(b"", kind=0)],
        patience=8000,
    )
    assert counts.keys() == {"sound", "lost", "late", "doubled", "foreign"}


def test_a_word_is_read_in_less_than_a_tenth_of_a_millisecond(wire: Wire) -> None:
    host = Host(wire)
    host.open(0)
    before = wire.run(1)
    (answer,) = wire.ask(host.datagram(checked(b"r00010", number=host.number)))
    assert carried(answer).endswith(checked(b"r00000000000", number=host.number, answers=True))
    assert answer.ended - before < CLOCK_HZ // 10_000


def test_frames_for_other_stations_are_not_answered(wire: Wire) -> None:
    other = bytes.fromhex("020000000001")
    assert wire.ask(other + ping(b"")[6:]) == []
    assert len(wire.ask(question())) == 1
    assert wire.ask(question(to=other)) == []


def test_discovery_finds_boards_through_the_chip(wire: Wire) -> None:
    (answer,) = wire.ask(to_all(ask()))
    assert read_answer(answer.body[HEADERS : HEADERS + 32]) is not None


@pytest.mark.parametrize("length", [0, 61, 1521])
def test_frames_after_an_impossible_length_are_answered(wire: Wire, length: int) -> None:
    wire.spoil(length=length)
    wire.put(ping(b"lost"))
    wire.put(ping(b"lost as well"))
    wire.run(CLOCK_HZ // 100)
    assert wire.take() == []
    assert answers(wire, bytes(100)) == [bytes(100)]
    assert wire.resets() == 0


def _lose_power(wire: Wire) -> None:
    wire.lose_power()


def _lose_power_in_an_answer(wire: Wire) -> None:
    wire.put(ping(bytes(1000)))
    wire.run(CLOCK_HZ // 2000)
    wire.lose_power()


@pytest.mark.parametrize("lose_power", [_lose_power, _lose_power_in_an_answer])
def test_a_chip_that_lost_its_power_is_reset_and_set_up_again(wire: Wire, lose_power: Callable[[Wire], None]) -> None:
    lose_power(wire)
    wire.run(CLOCK_HZ // 50)
    wire.take()
    assert wire.is_open()
    assert wire.resets() == 1
    assert wire.ask(bytes.fromhex("020000000001") + ping(b"")[6:]) == []
    assert answers(wire, b"there again") == [padded(b"there again")]


def test_frame_that_the_chip_never_reports_as_sent_is_given_up(wire: Wire) -> None:
    wire.spoil(unsaid=1)
    assert answers(wire, b"sent") == [padded(b"sent")]
    wire.run(CLOCK_HZ // 50)
    assert answers(wire, b"next") == [padded(b"next")]
    assert wire.resets() == 0


def test_gateway_works_after_a_reset_at_any_instant(wire: Wire) -> None:
    rng = random.Random(2)
    for _ in range(5):
        wire.put(ping(rng.randbytes(700)))
        wire.run(rng.randrange(40_000))
        wire.reset()
        wire.take()
        assert answers(wire, b"there") == [padded(b"there")]
