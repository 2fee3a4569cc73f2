"""The gateway with RMII, compiled, at a cable: what is for it is answered, all else leaves no trace."""

from __future__ import annotations

import random
import struct

import pytest

from gateware.bench.ethernet import with_check
from gateware.bench.network.host import (
    HOST_IP,
    HOST_MAC,
    Host,
    checked,
    ethernet,
    ip,
    ping,
    question,
    sum_of,
    udp,
)
from gateware.bench.network.wire import CLOCK_HZ, GATEWAY_IP, GATEWAY_MAC, Wire, line_of

pytestmark = pytest.mark.slow


def test_a_question_for_its_address_is_answered() -> None:
    wire = Wire()
    for to in (b"\xff" * 6, GATEWAY_MAC):
        (taken,) = wire.ask(question(to=to))
        head = HOST_MAC + GATEWAY_MAC + bytes.fromhex("0806 0001 0800 06 04 0002")
        assert taken.body == (head + GATEWAY_MAC + GATEWAY_IP + HOST_MAC + HOST_IP).ljust(60, b"\0")
        assert taken.sound


@pytest.mark.parametrize("size", [0, 1, 17, 18, 19, 56, 1472])
def test_a_ping_is_answered_with_what_it_carries(size: int) -> None:
    wire, rng = Wire(), random.Random(size)
    for number in range(40 if size <= 56 else 3):
        data = rng.randbytes(size)
        (taken,) = wire.ask(ping(data, number))
        total = int.from_bytes(taken.body[16:18], "big")
        reply = taken.body[34 : 14 + total]
        assert taken.sound
        assert (sum_of(taken.body[14:34]), sum_of(reply)) == (0, 0)
        assert reply == struct.pack("!BB", 0, 0) + reply[2:4] + struct.pack("!HH", 0x1234, number) + data


def test_every_check_of_a_ping_is_answered_by_a_right_one() -> None:
    wire = Wire()
    for word in (*range(0xF7F0, 0x10000, 37), 0x00FF, 0xF8FF, 0xFFFF, 0, 1):
        (taken,) = wire.ask(ping(struct.pack("!H", word)))
        assert sum_of(taken.body[34:44]) == 0


_ASKS = udp(b"R00\r")
FOREIGN = {
    "another station's": b"\x02" * 6 + _ASKS[6:],
    "a group's": b"\x01\x00\x5e\x00\x00\x01" + _ASKS[6:],
    "everybody's, but a datagram": b"\xff" * 6 + _ASKS[6:],
    "with a tag": _ASKS[:12] + b"\x81\x00\x00\x05" + _ASKS[12:],
    "of IPv6": ethernet(0x86DD, bytes(60)),
    "of a length": ethernet(46, bytes(46)),
    "for another address of IP": ip(17, _ASKS[34:], to=bytes((192, 168, 1, 101))),
    "the first fragment": ip(17, _ASKS[34:], fragment=0x2000),
    "another fragment": ip(17, _ASKS[34:], fragment=0x0007),
    "with options": ip(17, _ASKS[34:], options=bytes(4)),
    "with a wrong check of IP": ip(17, _ASKS[34:], wrong=0x0100),
    "of TCP": ip(6, bytes(20)),
    "for another port": udp(b"R00\r", to_port=7),
    "longer in IP than it is": ip(17, _ASKS[34:], length=1400),
    "shorter in IP than UDP's head": ip(17, _ASKS[34:], length=27),
    "of another length in UDP": udp(b"R00\r", length=9),
    "an answer to a ping": ping(b"", kind=0),
    "a question for another address": question(bytes((192, 168, 1, 101))),
    "an answer to a question": question(operation=2),
    "empty": udp(b""),
    "of line ends alone": udp(b"\r\n\n\r"),
}


@pytest.mark.parametrize("frame", FOREIGN.values(), ids=FOREIGN)
def test_a_frame_leaves_no_trace_that_is(frame: bytes) -> None:
    wire = Wire()
    for _ in range(3):
        assert wire.ask(frame, 3000) == []
    assert Host(wire).ask(udp(b"R00\r")).endswith(b"R0000000000\r\n")


LINES = {
    "with a wrong check": lambda data, rng: line_of(_with_a_wrong_bit(data, rng)),
    "cut short": lambda data, rng: line_of(data[: rng.randrange(len(data))]),
    "with an error of the PHY": lambda data, rng: line_of(data, error_at=rng.randrange(4 * len(data))),
    "too short": lambda data, rng: line_of(with_check(data[: rng.randrange(20)])[-30:]),
    "too long": lambda data, rng: line_of(data + rng.randbytes(1500)),
}


def _with_a_wrong_bit(data: bytes, rng: random.Random) -> bytes:
    place = rng.randrange(len(data))
    return data[:place] + bytes([data[place] ^ 1 << rng.randrange(8)]) + data[place + 1 :]


@pytest.mark.parametrize("spoilt", LINES.values(), ids=LINES)
def test_a_write_is_not_made_by_a_frame(spoilt: object) -> None:
    wire, rng = Wire(), random.Random(7)
    good = with_check(udp(b"W0A00000001\r"))
    for _ in range(20):
        wire.put_line(spoilt(good, rng))  # type: ignore[operator]
        wire.run(6000 + wire.waiting())
        assert wire.take() == []
    assert wire.writes() == []
    wire.put_line(line_of(good, preamble=rng.randrange(3, 60), toggling=3))
    wire.run(20_000, 1)
    assert wire.writes() == [(10, 1)]


# Sessions


def test_after_a_reset_there_is_another_session() -> None:
    wire = Wire()
    host = Host(wire)
    host.open()
    wire.reset()
    assert host.ask(host.datagram(checked(b"w5A00A00000001"))) == checked(b"U%s00000000" % host.session, b"X0A")
    before = host.session
    host.open(0x5A0)
    assert host.session != before
    assert wire.writes() == []


def test_counts_go_round() -> None:
    wire = Wire()
    host = Host(wire)
    host.open()
    for place, count in enumerate((0x7FFFFFF0, 0xE0000000, 0xFFFFFFFF, 1, 2)):
        assert host.ask(host.datagram(checked(b"h%03X" % (0x5A0 + place)), count)).endswith(
            checked(b"h%03X" % (0x5A0 + place))
        )


# Rates


def test_a_word_is_read_within_sixteen_microseconds() -> None:
    """From the first bit of the request's preamble to the last of the answer's check; 15 without a session."""
    wire = Wire()
    host = Host(wire)
    host.open()
    for frame, most_us in ((host.datagram(checked(b"r5A00A")), 15.7), (udp(b"R0A\r", port=4000), 15)):
        wire.run(5000)
        began = wire.run(0)
        (taken,) = wire.ask(frame)
        # Two symbols before the preamble are the PHY's.
        assert (taken.ended - began - 2) * 1e6 / CLOCK_HZ <= most_us
