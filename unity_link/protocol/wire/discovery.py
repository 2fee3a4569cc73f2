"""The datagrams of docs/protocol.md, "Finding boards": a question who is there, and the answer, without any I/O."""

from __future__ import annotations

import ipaddress
import re
import struct
from typing import NamedTuple

from unity_link.errors import ArgumentError
from unity_link.quoting import one_line

DEFAULT_PORT = 21_845
"""The port of gateways that were built with no other."""
EVERYBODY = bytes([0xFF] * 6)
"""The address that asks all gateways."""
NOWHERE = bytes(4)
"""No address of IP."""
_MARK = b"U?"
_LAYOUT = struct.Struct("!2s6s4sIB15s")
_FINGERPRINT, _SESSION_OPEN = 1, 2


_MAC = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}")


def parse_mac(text: str) -> bytes:
    """Return the address of a board's MAC.

    Raises:
        ArgumentError: where a text is none, or that of a group.
    """
    if not _MAC.fullmatch(text):
        raise ArgumentError(f"{text!r} is no address of a MAC, such as 02:55:4c:00:00:01")
    mac = bytes.fromhex(re.sub("[:-]", "", text))
    if mac[0] & 1:
        raise ArgumentError(f"{text} is the address of a group, not of one board")
    return mac


def parse_ip(text: str) -> bytes:
    """Return the address of IP of a board.

    Raises:
        ArgumentError: where a text is none, or one that no board can have.
    """
    try:
        address = ipaddress.IPv4Address(text)
    except ValueError:
        raise ArgumentError(f"{text!r} is no IPv4 address, such as 192.168.1.101") from None
    if address.is_multicast or address.is_unspecified or address.is_loopback or address.is_reserved:
        raise ArgumentError(f"{text} can't be the address of a board")
    return address.packed


class Found(NamedTuple):
    """A gateway's answer."""

    mac: bytes
    """Its six bytes."""
    ip: bytes
    """Four bytes; `NOWHERE` of a gateway that does not know under which address it is reached."""
    build_id: int
    has_fingerprint: bool
    """True if `build_id` is the fingerprint of a spec."""
    session_open: bool
    name: str


def ask(mac: bytes = EVERYBODY, ip: bytes = NOWHERE) -> bytes:
    """Return a question: to all, or to the gateway with an address, which is to take one of IP."""
    return _LAYOUT.pack(_MARK, mac, ip, 0, 0, b"")


def asked(datagram: bytes, mac: bytes) -> bool:
    """Return whether a datagram asks all gateways, or the one with that address, and is as long as the answer."""
    return (
        len(datagram) >= _LAYOUT.size and datagram.startswith(_MARK) and (bool(datagram[2] & 1) or datagram[2:8] == mac)
    )


def answer(found: Found) -> bytes:
    """Return the answer of a gateway; of its name as much as there is room for."""
    flags = _FINGERPRINT * found.has_fingerprint | _SESSION_OPEN * found.session_open
    name = found.name.encode("ascii", "replace")
    return _LAYOUT.pack(_MARK, found.mac, found.ip, found.build_id, flags, name)


def read_answer(datagram: bytes) -> Found | None:
    """Return the contents of an answer, the name as one printable line; None for a datagram that is no answer.

    The echo of a question to all gateways is none: it has the MAC of a group.
    """
    if len(datagram) != _LAYOUT.size or not datagram.startswith(_MARK) or datagram[2] & 1:
        return None
    _, mac, ip, build_id, flags, name = _LAYOUT.unpack(datagram)
    shown = one_line(name.partition(b"\0")[0].decode("ascii", "replace"))
    return Found(mac, ip, build_id, bool(flags & _FINGERPRINT), bool(flags & _SESSION_OPEN), shown)
