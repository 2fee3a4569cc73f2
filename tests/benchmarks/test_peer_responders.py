"""The responders of the peers: each answers a read, a write and a block with the bytes of the peer's protocol.

The benchmark tests the peers themselves, because only its environment has them installed.
"""

from __future__ import annotations

import os
import select
import socket
import struct

from benchmarks.peers.race import RESPONDERS
from benchmarks.responder import LOOPBACK, serving
from support.compilers import needs_c

pytestmark = needs_c
PATIENCE = 60
"""Seconds after which a test without an answer fails."""


def ask_stream(descriptor: int, request: bytes, size: int) -> bytes:
    """Write a request; return an answer of `size` bytes."""
    os.write(descriptor, request)
    answer = b""
    while len(answer) < size:
        assert select.select([descriptor], [], [], PATIENCE)[0], answer
        answer += os.read(descriptor, size - len(answer))
    return answer


def with_crc(frame: bytes) -> bytes:
    """Return a frame of Modbus RTU followed by its CRC, the lower byte first."""
    crc = 0xFFFF
    for byte in frame:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return frame + struct.pack("<H", crc)


def over_pty(protocol: str, *exchanges: tuple[bytes, bytes]) -> None:
    with serving(RESPONDERS, "pty", protocol) as path:
        port = os.open(path, os.O_RDWR | os.O_NOCTTY)
        for request, answer in exchanges:
            assert ask_stream(port, request, len(answer)) == answer
        os.close(port)


def test_it_answers_the_uart_bridge_of_litex() -> None:
    over_pty(
        "litex",
        (bytes.fromhex("02 01 00000011"), bytes.fromhex("11111111")),
        (bytes.fromhex("01 02 00000010 DEADBEEF CAFE0001 02 03 00000010"), bytes.fromhex("DEADBEEF CAFE0001 12121212")),
    )


def test_it_answers_modbus_rtu() -> None:
    over_pty(
        "modbus-rtu",
        # The first request and its CRC are the example of the specification that many manuals repeat.
        (bytes.fromhex("01 03 0000 000A C5CD"), with_crc(bytes.fromhex("01 03 14") + words_as_registers(0, 5))),
        (with_crc(bytes.fromhex("01 06 0021 BEEF")), with_crc(bytes.fromhex("01 06 0021 BEEF"))),
        (
            with_crc(bytes.fromhex("01 10 0022 0002 04 CAFE0001")) + with_crc(bytes.fromhex("01 03 0020 0004")),
            with_crc(bytes.fromhex("01 10 0022 0002")) + with_crc(bytes.fromhex("01 03 08 1010BEEF CAFE0001")),
        ),
    )


def words_as_registers(first: int, count: int) -> bytes:
    return b"".join(bytes([word] * 4) for word in range(first, first + count))


def test_it_answers_modbus_tcp_and_the_next_connection() -> None:
    with serving(RESPONDERS, "tcp", "modbus-tcp") as port:
        for _ in range(2):
            with socket.create_connection((LOOPBACK, int(port)), timeout=PATIENCE) as connection:
                request = bytes.fromhex("0007 0000 0006 01 03 0022 0002")
                answer = bytes.fromhex("0007 0000 0007 01 03 04 11111111")
                assert ask_stream(connection.fileno(), request, len(answer)) == answer


def test_it_answers_packets_of_ipbus() -> None:
    with serving(RESPONDERS, "udp", "ipbus") as port, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
        host.settimeout(PATIENCE)
        host.connect((LOOPBACK, int(port)))
        for request, answer in [
            ([0x200000F0, 0x2000020F, 0x10], [0x200000F0, 0x20000200, 0x10101010, 0x11111111]),
            (
                [0x200001F0, 0x2000011F, 0x10, 0xDEADBEEF, 0x2001010F, 0x10],
                [0x200001F0, 0x20000110, 0x20010100, 0xDEADBEEF],
            ),
        ]:
            host.send(struct.pack(f"={len(request)}I", *request))
            assert host.recv(65536) == struct.pack(f"={len(answer)}I", *answer)
