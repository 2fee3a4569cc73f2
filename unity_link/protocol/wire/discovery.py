"""The datagrams that find gateways in a network (docs/protocol.md, "Finding boards"): the question and its answer."""

from __future__ import annotations

import ipaddress
import re
import struct
from typing import NamedTuple

from unity_link.errors import ArgumentError
from unity_link.quoting import one_line

DEFAULT_PORT = 21_845
"""UDP port of gateways that were built with the default."""
EVERYBODY = bytes([0xFF] * 6)
"""MAC address in a question to all gateways."""
NOWHERE = bytes(4)
"""IPv4 address that means none, or an unknown one."""
_MARK = b"U?"
_LAYOUT = struct.Struct("!2s6s4sIB15s")
_FINGERPRINT, _SESSION_OPEN = 1, 2


_MAC = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}")


def parse_mac(text: str) -> bytes:
    """Return the six bytes of a board's MAC address, such as ``02:55:4c:00:00:01``.

    Raises:
        ArgumentError: if the text is not a MAC address, or is a multicast address.
    """
    if not _MAC.fullmatch(text):
        raise ArgumentError(f"{text!r} is no MAC address, such as 02:55:4c:00:00:01")
    mac = bytes.fromhex(re.sub("[:-]", "", text))
    if mac[0] & 1:
        raise ArgumentError(f"{text} is the address of a group, not of one board")
    return mac


def parse_ip(text: str) -> bytes:
    """Return the four bytes of a board's IPv4 address.

    Raises:
        ArgumentError: if the text is not an IPv4 address, or is a multicast, loopback or reserved address.
    """
    try:
        address = ipaddress.IPv4Address(text)
    except ValueError:
        raise ArgumentError(f"{text!r} is no IPv4 address, such as 192.168.1.101") from None
    if address.is_multicast or address.is_unspecified or address.is_loopback or address.is_reserved:
        raise ArgumentError(f"{text} can't be the address of a board")
    return address.packed


class Found(NamedTuple):
    """The contents of a gateway's answer."""

    mac: bytes
    """MAC address, six bytes."""
    ip: bytes
    """IPv4 address, four bytes; `NOWHERE` if the gateway does not know its own."""
    build_id: int
    """The gateway's build identifier."""
    has_fingerprint: bool
    """True if `build_id` is the fingerprint of a spec."""
    session_open: bool
    """True if a host has opened a session since the gateway's reset."""
    name: str
    """Name of the board, 15 ASCII characters at most."""


def ask(mac: bytes = EVERYBODY, ip: bytes = NOWHERE) -> bytes:
    """Return a question to all gateways, or to the gateway with one MAC address.

    Args:
        mac: MAC address of the gateway, or `EVERYBODY`.
        ip: IPv4 address that this gateway is to use from now on, or `NOWHERE`.
    """
    return _LAYOUT.pack(_MARK, mac, ip, 0, 0, b"")


def asked(datagram: bytes, mac: bytes) -> bool:
    """Return whether a datagram is a question to all gateways, or to the one with this MAC address.

    A question is at least as long as its answer, so that the answer amplifies no forged question.
    """
    return (
        len(datagram) >= _LAYOUT.size and datagram.startswith(_MARK) and (bool(datagram[2] & 1) or datagram[2:8] == mac)
    )


def answer(found: Found) -> bytes:
    """Return the answer of a gateway; its name is cut after 15 characters."""
    flags = _FINGERPRINT * found.has_fingerprint | _SESSION_OPEN * found.session_open
    name = found.name.encode("ascii", "replace")
    return _LAYOUT.pack(_MARK, found.mac, found.ip, found.build_id, flags, name)


def read_answer(datagram: bytes) -> Found | None:
    """Return the contents of an answer, the name as one printable line; None for a datagram that is no answer.

    A question to all gateways that comes back is no answer: its MAC address is a multicast address.
    """
    if len(datagram) != _LAYOUT.size or not datagram.startswith(_MARK) or datagram[2] & 1:
        return None
    _, mac, ip, build_id, flags, name = _LAYOUT.unpack(datagram)
    shown = one_line(name.partition(b"\0")[0].decode("ascii", "replace"))
    return Found(mac, ip, build_id, bool(flags & _FINGERPRINT), bool(flags & _SESSION_OPEN), shown)
