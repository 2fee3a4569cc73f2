"""The compiled gateway with RMII: it answers frames that are for it, and ignores all others."""

from __future__ import annotations

import random
import struct
from typing import TYPE_CHECKING

import pytest

from gateware.bench.ethernet import with_check
from gateware.bench.network.host import (
    ALL_STATIONS,
    EVERYBODY,
    HOST_IP,
    HOST_MAC,
    Host,
    carried,
    checked,
    ethernet,
    ip,
    ping,
    question,
    sum_of,
    to_all,
    udp,
    write_over_a_bad_line,
)
from gateware.bench.network.wire import CLOCK_HZ, GATEWAY_IP, GATEWAY_MAC, GATEWAY_PORT, Wire, line_of
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.discovery import Found, ask, read_answer

if TYPE_CHECKING:
    from collections.abc import Callable

pytestmark = pytest.mark.slow


def test_a_question_for_its_address_is_answered() -> None:
    wire = Wire()
    for to in (b"\xff" * 6, GATEWAY_MAC):
        (taken,) = wire.ask(question(to=to))
        head = HOST_MAC + GATEWAY_MAC + bytes.fromhex("0806 0001 0800 06 04 0002")
        assert taken.body == (head + GATEWAY_MAC + GATEWAY_IP + HOST_MAC + HOST_IP).ljust(60, b"\0")
        assert taken.sound


@pytest.mark.parametrize("size", [0, 1, 17, 18, 19, 56, 1472])
def test_ping_is_answered_with_its_own_data(size: int) -> None:
    wire, rng = Wire(), random.Random(size)
    for number in range(40 if size <= 56 else 3):
        data = rng.randbytes(size)
        (taken,) = wire.ask(ping(data, number))
        total = int.from_bytes(taken.body[16:18], "big")
        reply = taken.body[34 : 14 + total]
        assert taken.sound
        assert (sum_of(taken.body[14:34]), sum_of(reply)) == (0, 0)
        assert reply == struct.pack("!BB", 0, 0) + reply[2:4] + struct.pack("!HH", 0x1234, number) + data


def test_answers_to_pings_have_the_right_checksum() -> None:
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


LINES: dict[str, Callable[[bytes, random.Random], bytes]] = {
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
def test_a_write_is_not_made_by_a_frame(spoilt: Callable[[bytes, random.Random], bytes]) -> None:
    wire, rng = Wire(), random.Random(7)
    good = with_check(udp(b"W0A00000001\r"))
    for _ in range(20):
        wire.put_line(spoilt(good, rng))
        wire.run(6000 + wire.waiting())
        assert wire.take() == []
    assert wire.writes() == []
    wire.put_line(line_of(good, preamble=rng.randrange(3, 60), toggling=3))
    wire.run(20_000, 1)
    assert wire.writes() == [(10, 1)]


# Sessions


def test_the_table_of_datagrams_holds() -> None:
    wire = Wire()
    host, other = Host(wire), Host(wire, 4001)
    wire.poke(0x0A, 0x12345678)
    host.open()
    read = host.checked(b"r5A00A")
    answer = host.answered(b"r5A012345678")
    assert host.ask(host.datagram(read)) == checked(b"U%s00000002" % host.session) + answer
    # Late, duplicated, without a count, damaged, malformed.
    for count in (2, 1, 0, 0x80000002):
        assert host.ask(host.datagram(read, count), 4000) == b""
    for data in (b"U%s00000009" % host.session + b"0000\n" + read, b"U%s0000009\n" % host.session + read, b"U"):
        assert host.ask(udp(data), 4000) == b""
    # From another host, and of another session.
    other.session = host.session
    assert other.ask(other.datagram(read, 3)) == checked(b"U%s00000000" % host.session, b"X0A")
    assert host.ask(host.datagram(read, 3, b"00000001")) == checked(b"U0000000100000000", b"X0A")
    # Without a header; the answer has the form of the first frame.
    answer = other.ask(udp(b"R0A\r", port=4001))
    offer = answer[1:9]
    assert answer == b"U%s00000000\r\nR0A12345678\r\n" % offer
    assert other.ask(udp(checked(b"R0A"), port=4001)) == checked(b"U%s00000000" % offer, b"R0A12345678")
    headed = checked(b"U%s00000000" % offer)
    asked = b"w5A10A00000005"
    left = int(Crc().text(asked, seed_of(host.number, from_gateway=False)), 16) ^ int(Crc().text(asked), 16)
    assert other.ask(udp(host.checked(asked), port=4001)) == headed + checked(b"x5A10A%04X" % left)
    assert other.ask(udp(b"w5A10A00000005\r", port=4001)) == b"U%s00000000\r\nx5A10A0000\r\n" % offer
    assert other.ask(udp(b"K0001235\r", port=4001)) == b"U%s00000000\r\nX0A\r\n" % offer
    assert other.ask(udp(checked(b"W0A00000005", b"K"), port=4001)) == headed + checked(b"X0B", b"K%04X" % host.number)
    # The session continues with the newest count; a frame ends with its datagram.
    assert host.ask(host.datagram(host.checked(b"r5A10A")[:-1], 0x7FFFFFFF)).endswith(host.answered(b"r5A112345678"))
    # Under the offer, but no K; then the other host opens it, and the first host gets a refusal.
    other.session = offer
    assert other.ask(other.datagram(read, 1)) == checked(b"U%s00000000" % offer, b"X0A")
    wire.put(other.datagram(checked(b"K1114321"), 2))
    wire.run(60_000, 2)
    told = [carried(taken) for taken in wire.take()]
    begun = checked(b"U%s00000001" % offer, b"K1114321%04X" % host.number)
    assert told == [checked(b"U%s00000000" % host.session, b"X0A"), begun]
    assert host.ask(host.datagram(read, 0x80000001)) == checked(b"U%s00000000" % host.session, b"X0A")
    assert (0x0A, 5) not in wire.writes()


def _answered_under_the_offer(frames: bytes) -> tuple[bytes, bytes, bool]:
    """Return the offer, the answer to frames under it, and whether the former host has lost its session."""
    wire = Wire()
    host, other = Host(wire), Host(wire, 4001)
    host.open()
    other.session = other.ask(udp(b"Q\r", port=4001))[1:9]
    wire.put(other.datagram(frames))
    wire.run(60_000, 2)
    answers = b"".join(carried(taken) for taken in wire.take() if taken.body[36:38] == struct.pack("!H", 4001))
    told = host.ask(host.datagram(host.checked(b"r5A00A")))
    return other.session, answers, told == checked(b"U%s00000000" % host.session, b"X0A")


@pytest.mark.parametrize("frames", [checked(b"K"), b"Kf9af\n", b"KF9AF", b"\r\nKF9AF\n"])
@pytest.mark.parametrize("behind", [b"", checked(b"K4441235")])
def test_a_bare_k_opens_no_session(frames: bytes, behind: bytes) -> None:
    if not frames.endswith(b"\n"):
        behind = b""
    offer, answers, is_lost = _answered_under_the_offer(frames + behind)
    refusals = [b"X0A"] if behind else []
    assert answers == checked(b"U%s00000000" % offer, b"K%04X" % 4000, *refusals)
    assert not is_lost


@pytest.mark.parametrize("frames", [b"K\r", b"K\r\n", b"KF9\r", b"KF9AF\r", b"KF9AF\rR0A\r"])
def test_a_plain_k_without_fields_opens_no_session(frames: bytes) -> None:
    offer, answers, is_lost = _answered_under_the_offer(frames)
    said = b"K%04X\r\n" % 4000 if frames.startswith(b"K\r") else b"X03\r\n"
    assert answers == b"U%s00000000\r\n" % offer + said + b"R0A00000000\r\n" * frames.endswith(b"R0A\r")
    assert not is_lost


@pytest.mark.parametrize("first", [0x000, 0xF00, 0xF9A, 0xFA0])
@pytest.mark.parametrize("number", [0x1234, 0x7ABC])
def test_a_k_with_fields_takes_the_offer_whatever_its_first_digits(first: int, number: int) -> None:
    body = b"K%03X%04X" % (first, number)
    offer, answers, is_lost = _answered_under_the_offer(checked(body))
    assert answers == checked(b"U%s00000001" % offer, body + b"%04X" % 4000)
    assert is_lost


@pytest.mark.parametrize("frame", [b"KF9AF0\n", b"K0\n", b"K~\n", b"Kr\n", b"KF9A~\r"])
def test_malformed_k_with_trailing_data_accepts_the_offer(frame: bytes) -> None:
    offer, answers, is_lost = _answered_under_the_offer(frame)
    is_plain = frame.endswith(b"\r")
    assert answers == checked(b"U%s00000001" % offer) + (b"X03\r\n" if is_plain else checked(b"X01"))
    assert is_lost


def test_a_datagram_without_a_response_brings_none_back() -> None:
    wire = Wire()
    assert wire.ask(udp(b"WS0A00000001\r"), 6000) == []
    assert wire.writes() == [(0x0A, 1)]


def test_session_differs_after_a_reset() -> None:
    wire = Wire()
    host = Host(wire)
    host.open()
    wire.reset()
    assert host.ask(host.datagram(host.checked(b"w5A00A00000001"))) == checked(b"U%s00000000" % host.session, b"X0A")
    before = host.session
    host.open(0x5A0)
    assert host.session != before
    assert wire.writes() == []


def test_counts_go_round() -> None:
    wire = Wire()
    host = Host(wire)
    host.open()
    for place, count in enumerate((0x7FFFFFF0, 0xE0000000, 0xFFFFFFFF, 1, 2)):
        body = b"h%03X" % (0x5A0 + place)
        assert host.ask(host.datagram(host.checked(body), count)).endswith(host.answered(body + b"000"))


# Found and addressed

OTHER_IP = bytes((10, 0, 0, 7))


def _find(wire: Wire, frame: bytes) -> tuple[bytes, Found] | None:
    """Send a frame; return the IP address that answers, and the answer, or None without one."""
    frames = wire.ask(frame, 6000)
    if not frames:
        return None
    (taken,) = frames
    body = taken.body
    assert taken.sound
    assert body[:14] == HOST_MAC + GATEWAY_MAC + b"\x08\0"
    assert sum_of(body[14:34]) == 0
    assert body[30:42] == HOST_IP + struct.pack("!HHHH", GATEWAY_PORT, 4000, 40, 0)
    assert int.from_bytes(body[16:18], "big") == 60
    found = read_answer(body[42:74])
    assert found is not None
    return body[26:30], found


@pytest.mark.parametrize("to", [ALL_STATIONS, bytes((192, 168, 1, 255)), bytes((10, 0, 0, 255))])
def test_discovery_query_to_all_or_to_this_board_is_answered_once(to: bytes) -> None:
    wire = Wire()
    lamp = Found(GATEWAY_MAC, GATEWAY_IP, 0x1234ABCD, has_fingerprint=True, session_open=False, name="lamp")
    for _ in range(3):
        assert _find(wire, to_all(ask(), to=to)) == (GATEWAY_IP, lamp)
    Host(wire).open()
    assert _find(wire, to_all(ask() + bytes(100), to=to)) == (GATEWAY_IP, lamp._replace(session_open=True))
    assert _find(wire, to_all(ask(bytes.fromhex("02554c000002"), OTHER_IP), to=to)) is None


def test_a_gateway_takes_an_address_and_keeps_it_until_its_reset() -> None:
    wire = Wire()
    here = Found(GATEWAY_MAC, OTHER_IP, 0x1234ABCD, has_fingerprint=True, session_open=False, name="lamp")
    assert _find(wire, to_all(ask(GATEWAY_MAC, OTHER_IP))) == (OTHER_IP, here)
    assert _find(wire, to_all(ask())) == (OTHER_IP, here)
    assert wire.ask(question(), 4000) == wire.ask(udp(b"Q\r"), 4000) == wire.ask(ping(b"", 1), 4000) == []
    (taken,) = wire.ask(question(OTHER_IP))
    assert taken.body[22:32] == GATEWAY_MAC + OTHER_IP
    (taken,) = wire.ask(ip(17, struct.pack("!HHHH", 4000, GATEWAY_PORT, 12, 0) + b"R0A\r", to=OTHER_IP))
    assert taken.body[26:34] == OTHER_IP + HOST_IP
    assert sum_of(taken.body[14:34]) == 0
    assert taken.body[42:].endswith(b"R0A00000000\r\n")
    wire.reset()
    assert _find(wire, to_all(ask())) == (GATEWAY_IP, here._replace(ip=GATEWAY_IP))


NO_QUESTIONS = {
    "one byte short": to_all(ask()[:-1]),
    "of another mark": to_all(b"U!" + ask()[2:]),
    "of frames": to_all(b"W0A00000001\r" * 4),
    "of frames of a session": to_all(checked(b"U0000000000000001") + b"W0A00000001\r" * 4),
    "to another port": to_all(ask(), to_port=GATEWAY_PORT + 1),
    "to a group": to_all(ask(), station=bytes.fromhex("01005e000001")),
    "to it alone": udp(ask()),
    "a ping": ethernet(0x0800, ping(b"")[14:], EVERYBODY),
}


@pytest.mark.parametrize("frame", NO_QUESTIONS.values(), ids=NO_QUESTIONS)
def test_broadcast_other_than_a_query_has_no_effect(frame: bytes) -> None:
    wire = Wire()
    for _ in range(3):
        assert wire.ask(frame, 5000) == []
    assert wire.writes() == []
    assert Host(wire).ask(udp(b"R0A\r")).endswith(b"R0A00000000\r\n")


def test_a_question_with_a_wrong_check_gives_no_address() -> None:
    wire, rng = Wire(), random.Random(3)
    good = with_check(to_all(ask(GATEWAY_MAC, OTHER_IP)))
    for spoilt in LINES.values():
        wire.put_line(spoilt(good, rng))
        wire.run(8000 + wire.waiting())
        assert wire.take() == []
    found = _find(wire, to_all(ask()))
    assert found is not None
    assert found[0] == GATEWAY_IP


def test_session_continues_while_other_boards_are_queried() -> None:
    wire, rng = Wire(), random.Random(11)
    host = Host(wire)
    host.open(0)
    for number in range(60):
        for _ in range(rng.randrange(3)):
            wire.put(rng.choice([to_all(ask()), to_all(ask(bytes(6), OTHER_IP)), question(OTHER_IP)]))
        wire.put(host.datagram(host.checked(b"w%03X0A%08X" % (number, number))))
        wire.run(wire.waiting() + 6000)
        answers = [taken.body[42:] for taken in wire.take()]
        assert any(host.answered(b"w%03X" % number) in one for one in answers)
    assert [word for _, word in wire.writes()] == [*range(60)]


# Rates


def test_a_word_is_read_within_sixteen_microseconds() -> None:
    """From the first bit of the request's preamble to the last bit of the answer's frame check sequence."""
    wire = Wire()
    host = Host(wire)
    host.open()
    for frame, most_us in ((host.datagram(host.checked(b"r5A00A")), 15.7), (udp(b"R0A\r", port=4000), 15)):
        wire.run(5000)
        began = wire.run(0)
        (taken,) = wire.ask(frame)
        # Without the two symbols before the preamble, which belong to the PHY.
        assert (taken.ended - began - 2) * 1e6 / CLOCK_HZ <= most_us


def test_ten_megabytes_a_second_go_in_and_out() -> None:
    wire = Wire()
    host = Host(wire)
    host.open()
    write = [host.checked(b"ws%03X0A%08X" % (0x5A0 + number & 0xFFF, number)) for number in range(1200)]
    each = 1378 // len(write[0])
    began = wire.run(0)
    for at in range(0, len(write), each):
        wire.put(host.datagram(b"".join(write[at : at + each])))
    wire.run(wire.waiting())
    seconds = (wire.run(0) - began) / CLOCK_HZ
    wire.run(30_000)
    assert [word for _, word in wire.writes()] == [*range(1200)]
    assert sum(map(len, write)) / seconds > 10e6
    wire.take()
    reads = b"".join(checked(b"RM0080") for _ in range(40))
    wire.put(host.datagram(reads))
    wire.run(10_000_000, 1)
    wire.run(400_000)
    taken = wire.take()
    data = [carried(frame) for frame in taken]
    answer = checked(b"RM0080" + b"".join(b"%08X" % (1199 if place == 10 else 0) for place in range(128)))
    assert b"".join(one[22:] for one in data) == answer * 40
    seconds = (taken[-2].ended - taken[0].ended) / CLOCK_HZ
    assert sum(map(len, data[1:-1])) / seconds > 10e6


def test_datagram_too_long_is_dropped_as_a_whole_and_counted() -> None:
    wire = Wire()
    host = Host(wire)
    host.open(plain=True)
    for number in range(40):
        frames = [checked(b"RM0080")] * 40 + [checked(b"WS0B%08X" % number)]
        wire.put(host.datagram(b"".join(frames)))
    wire.run(2_000_000)
    taken = [carried(frame) for frame in wire.take()]
    executed = len([word for _, word in wire.writes()])
    assert 0 < executed < 40
    assert wire.dropped() == 40 - executed
    assert sum(one.count(b"RM0080") for one in taken) == 40 * executed
    assert host.ask(host.datagram(host.checked(b"h5A0"))).endswith(host.answered(b"h5A0000"))


# In a campaign


def _put_sound(wire: Wire, body: bytes, rng: random.Random) -> None:
    wire.put_line(line_of(with_check(body), preamble=rng.randrange(2, 40), toggling=rng.randrange(6)))


def _put(spoil: Callable[[bytes, random.Random], bytes]) -> Callable[[Wire, bytes, random.Random], None]:
    return lambda wire, body, rng: wire.put_line(spoil(with_check(body), rng))


@pytest.mark.parametrize(
    ("frames", "seed"), [(2000, 0), *(pytest.param(250_000, seed, marks=pytest.mark.campaign) for seed in range(1, 5))]
)
def test_core_gets_no_wrong_datagram_and_each_right_one_once(frames: int, seed: int) -> None:
    wire = Wire()
    counts = write_over_a_bad_line(
        wire,
        frames,
        random.Random(seed),
        put=_put_sound,
        spoilt={name: _put(spoil) for name, spoil in LINES.items()},
        foreign=[*FOREIGN.values()],
        patience=800,
    )
    assert counts.keys() == {"sound", "lost", "late", "doubled", "foreign", *LINES}
    assert min(counts.values()) > frames // 100
    assert wire.dropped() == 0
