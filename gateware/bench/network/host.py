"""A host on the cable of a `Wire`: frames of ARP, ICMP and UDP, and the headers of docs/protocol.md, "Datagrams"."""

from __future__ import annotations

import collections
import struct
from typing import TYPE_CHECKING

from gateware.bench.network.wire import GATEWAY_IP, GATEWAY_MAC, GATEWAY_PORT, Taken, Wire
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import Framing, in_session

if TYPE_CHECKING:
    import random
    from collections.abc import Callable, Mapping, Sequence

    Put = Callable[[Wire, bytes, random.Random], None]

HOST_MAC = bytes.fromhex("0200000000aa")
HOST_IP = bytes((192, 168, 1, 5))
EVERYBODY = b"\xff" * 6
ALL_STATIONS = bytes((255, 255, 255, 255))
HEADERS = 42
"""Bytes before the payload of UDP, and before the data of a ping."""
_FRAMING = Framing(Crc())


def sum_of(data: bytes) -> int:
    """Return the checksum of IP and ICMP over bytes; it is 0 for bytes that include a right one."""
    total = sum(struct.unpack(f"!{(len(data) + 1) // 2}H", data + bytes(len(data) % 2)))
    while total >> 16:
        total = (total & 0xFFFF) + (total >> 16)
    return 0xFFFF ^ total


def ethernet(kind: int, payload: bytes, to: bytes = GATEWAY_MAC) -> bytes:
    """Return a frame without padding and frame check sequence."""
    return to + HOST_MAC + struct.pack("!H", kind) + payload


def ip(
    protocol: int,
    payload: bytes,
    *,
    to: bytes = GATEWAY_IP,
    origin: bytes = HOST_IP,
    fragment: int = 0x4000,
    length: int | None = None,
    options: bytes = b"",
    wrong: int = 0,
) -> bytes:
    """Return an IP datagram in a frame."""
    size = 20 + len(options) + len(payload)
    head = struct.pack(
        "!BBHHHBBH4s4s",
        *(0x45 + len(options) // 4, 0, size if length is None else length, 7, fragment, 64, protocol, 0),
        *(origin, to),
    )
    head += options
    check = sum_of(head) ^ wrong
    return ethernet(0x0800, head[:10] + struct.pack("!H", check) + head[12:] + payload)


def udp(data: bytes, *, port: int = 4000, to_port: int = GATEWAY_PORT, length: int | None = None) -> bytes:
    """Return a UDP datagram in a frame."""
    size = 8 + len(data) if length is None else length
    return ip(17, struct.pack("!HHHH", port, to_port, size, 0) + data)


def to_all(data: bytes, *, to: bytes = ALL_STATIONS, to_port: int = GATEWAY_PORT, station: bytes = EVERYBODY) -> bytes:
    """Return a broadcast UDP datagram in a frame."""
    return station + ip(17, struct.pack("!HHHH", 4000, to_port, 8 + len(data), 0) + data, to=to)[6:]


def ping(data: bytes, number: int = 1, *, kind: int = 8) -> bytes:
    """Return an echo request in a frame."""
    head = struct.pack("!BBHHH", kind, 0, 0, 0x1234, number)
    check = sum_of(head + data)
    return ip(1, head[:2] + struct.pack("!H", check) + head[4:] + data)


def question(address: bytes = GATEWAY_IP, *, to: bytes = EVERYBODY, operation: int = 1) -> bytes:
    """Return an ARP request in a frame."""
    head = struct.pack("!HHBBH", 1, 0x0800, 6, 4, operation)
    return ethernet(0x0806, head + HOST_MAC + HOST_IP + bytes(6) + address, to)


def checked(*bodies: bytes, number: int = 0, answers: bool = False) -> bytes:
    """Return checked frames as the host sends them in a session, or as the gateway sends them if `answers` is true."""
    seed = seed_of(number, from_gateway=answers)
    return b"".join(_FRAMING.checked(body, seed if in_session(body[0]) else 0) for body in bodies)


class Host:
    """A host with a session, or without one yet.

    Args:
        wire: connected to the gateway.
        port: UDP port of the host.
    """

    def __init__(self, wire: Wire, port: int = 4000) -> None:
        self.wire, self.port = wire, port
        self.session = b""
        self.count = 0
        self.number = port
        """Number of the session, for the CRC of its frames."""

    def datagram(self, frames: bytes, count: int | None = None, session: bytes | None = None) -> bytes:
        """Return a frame with a datagram of the session, by default with the next count."""
        if count is None:
            self.count = count = self.count + 1
        header = b"U%s%08X" % (self.session if session is None else session, count)
        return udp(checked(header) + frames, port=self.port)

    def ask(self, frame: bytes, cycles: int = 20_000) -> bytes:
        """Send a frame; return the payload of the answer, empty without an answer."""
        return b"".join(carried(taken) for taken in self.wire.ask(frame, cycles))

    def open(self, first: int = 0x5A0, *, plain: bool = False) -> None:
        """Request an offer and open it with a checked frame, as a program does, or a plain one, as a person does."""
        offer = self.ask(udp(b"Q\r", port=self.port))
        self.session, self.count = offer[1:9], 0
        body = b"K%03X%04X" % (first, self.number)
        answer = self.ask(self.datagram(body + b"\r" if plain else checked(body)))
        body += b"0000"
        assert answer == checked(b"U%s00000001" % self.session) + (body + b"\r\n" if plain else checked(body))

    def checked(self, *bodies: bytes) -> bytes:
        """Return checked frames of the host's session."""
        return checked(*bodies, number=self.number)

    def answered(self, *bodies: bytes) -> bytes:
        """Return checked frames as the gateway sends them in that session."""
        return checked(*bodies, number=self.number, answers=True)


def carried(taken: Taken) -> bytes:
    """Return the UDP payload of a frame of the gateway, after checking its headers.

    Raises:
        AssertionError: if a header is wrong.
    """
    body = taken.body
    assert taken.sound
    assert body[:14] == HOST_MAC + GATEWAY_MAC + b"\x08\0"
    assert sum_of(body[14:34]) == 0
    total, size = (int.from_bytes(body[at : at + 2], "big") for at in (16, 38))
    assert (total, body[23], body[26:34]) == (size + 20, 17, GATEWAY_IP + HOST_IP)
    assert int.from_bytes(body[34:36], "big") == GATEWAY_PORT
    assert size <= 1408
    return body[HEADERS : 14 + total]


def write_over_a_bad_line(
    wire: Wire,
    frames: int,
    rng: random.Random,
    *,
    put: Put,
    spoilt: Mapping[str, Put],
    foreign: Sequence[bytes],
    patience: int,
) -> collections.Counter[str]:
    """Write numbers from 0 on in a session, each until it is answered, while frames are lost, delayed and duplicated.

    Args:
        wire: connected to the gateway.
        frames: number of frames to send, with those that are lost.
        rng: decides the outcome of each frame.
        put: puts an intact frame on the line.
        spoilt: functions that put a frame on the line which the gateway must not accept, by name.
        foreign: frames that are not for the gateway.
        patience: cycles without an answer after which the host retransmits.

    Returns:
        The number of frames of each kind.

    Raises:
        AssertionError: if a number was not written exactly once and in order, or the gateway stops answering.
    """
    host = Host(wire)
    host.open(0)
    counts: collections.Counter[str] = collections.Counter()
    late: list[bytes] = []
    done = 0
    while counts.total() < frames:
        frame = host.datagram(host.checked(b"w%03X0A%08X" % (done & 0xFFF, done)))
        on_line: list[tuple[str, bytes, Put]] = []
        chance = rng.random()
        if chance < 0.08:
            late.append(frame)
        elif chance < 0.16:
            counts["lost"] += 1
        elif chance < 0.26:
            on_line += [("doubled", frame, put)] * 2
        elif chance < 0.38 and spoilt:
            name = rng.choice([*spoilt])
            on_line.append((name, frame, spoilt[name]))
        else:
            on_line.append(("sound", frame, put))
        if rng.random() < 0.2:
            on_line.insert(rng.randrange(len(on_line) + 1), ("foreign", rng.choice(foreign), put))
        if late and rng.random() < 0.1:
            on_line.append(("late", late.pop(rng.randrange(len(late))), put))
        for kind, body, way in on_line:
            counts[kind] += 1
            way(wire, body, rng)
        wire.run(patience + wire.waiting(), 1)
        answers = b"".join(carried(taken)[22:] for taken in wire.take())
        if host.answered(b"w%03X" % (done & 0xFFF)) in answers:
            done += 1
    # The last write may still be in progress.
    wire.run(10 * patience)
    wire.take()
    writes = [word for _, word in wire.writes()]
    assert writes in ([*range(done)], [*range(done + 1)])
    assert done > frames // 4
    fence = b"h%03X" % (len(writes) & 0xFFF)
    assert host.ask(host.datagram(host.checked(fence))).endswith(host.answered(fence + b"000"))
    return counts
