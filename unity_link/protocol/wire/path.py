"""The longest datagram that the network between host and gateway carries (docs/protocol.md, "Short paths").

A host limits its own datagrams to this length, and requests only answers that fit in it, because a gateway fills
datagrams of 1,400 bytes. The length follows from:

1. the MTU in the URL, if there is one;
2. otherwise from the MTU that the operating system knows, and from the opening of the session: the host pads `K i s` to
   the longest datagram, and tries a shorter length after `TRIES` attempts without an answer.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.frames import LARGEST_DATAGRAM, LF

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.frames import Framing

SHORTEST_MTU, LONGEST_MTU = 576, 1500
"""Bytes of an IP packet: the size that every host must accept (RFC 791), and the MTU of Ethernet."""
HEADERS, HEADERS_6 = 28, 48
"""Bytes of the headers of IP and UDP in a packet, for IPv4 and IPv6."""
LENGTHS = (LARGEST_DATAGRAM, 1280 - HEADERS_6, SHORTEST_MTU - HEADERS)
"""Datagram lengths in bytes that are tried in turn; 1280 is the smallest MTU of IPv6 (RFC 8200)."""
TRIES = 2
"""Unanswered requests for a session of one length before the next length is tried."""
HEADER_SIZE = len("U") + 16
"""Characters of the body of a datagram's header: the letter, the session and the count."""
MOST_AROUND = 2 * len("ZFF") + HEADER_SIZE + 8 + len("\n")
"""Most bytes of a datagram beside one frame: its header, with node prefixes and the longest CRC."""
RESERVE = 64
"""Bytes of a datagram that a host reserves for errors and answers without an ID."""


class Path:
    """The longest datagram between a host and its gateway.

    Args:
        mtu: bytes of the longest IP packet, from the URL; None to find the length.
    """

    def __init__(self, mtu: int | None = None) -> None:
        self._mtu = mtu
        self._headers = HEADERS
        self.largest = LARGEST_DATAGRAM
        """Bytes of UDP payload of the longest datagram."""
        self.on_lowered: Callable[[], None] | None = None
        """Called after `largest` became smaller."""
        self._unanswered = 0
        self.begin(HEADERS, LONGEST_MTU)

    def begin(self, headers: int, known_mtu: int) -> None:
        """Set the size of the headers of IP and UDP, and the MTU that the system knows."""
        self._headers = headers
        mtu = known_mtu if self._mtu is None else self._mtu
        self.largest = min(mtu - headers, LARGEST_DATAGRAM)

    @property
    def mtu(self) -> int:
        """Bytes of the IP packet that carries the longest datagram."""
        return self.largest + self._headers

    @property
    def is_short(self) -> bool:
        """True if the path may lose the longest datagrams of a gateway."""
        return self.largest < LARGEST_DATAGRAM

    @property
    def longest_frame(self) -> int:
        """Bytes of the longest frame that fits in the longest datagram."""
        return self.largest - MOST_AROUND

    @property
    def shortest_frame(self) -> int:
        """Bytes of the longest frame that fits in a datagram of the shortest length."""
        return LENGTHS[-1] - MOST_AROUND

    def room(self, framing: Framing) -> int:
        """Return how many bytes of frames fit in a datagram after its header."""
        return self.largest - HEADER_SIZE - framing.overhead

    def padding(self, framing: Framing, size: int, most: float) -> bytes:
        """Return empty frames that extend a datagram to the longest length.

        Args:
            framing: framing of the header.
            size: bytes of the other frames in the datagram.
            most: most bytes of frames that the gateway can receive at once.
        """
        return LF * (int(min(self.room(framing), most)) - size)

    @property
    def bound(self) -> str:
        """The longest frame and the MTU of the path, as the last part of an error."""
        return f"and the network carries frames of {self.longest_frame} bytes at most (mtu={self.mtu})"

    @property
    def advice(self) -> str:
        """Advice for an error about missing answers: a shorter MTU; empty if the length is the shortest already."""
        if self.largest <= LENGTHS[-1]:
            return ""
        return f" (if the network loses long packets, mtu={SHORTEST_MTU} in the URL keeps them short)"

    # Finding the longest datagram

    def lower(self, mtu: int) -> None:
        """Use an MTU of the system or of an earlier session if it is smaller, unless the user gave one."""
        self._lower(mtu - self._headers)

    def unanswered(self) -> None:
        """Record that a datagram of the longest length was not answered; after `TRIES` of them, shorten it."""
        self._unanswered += 1
        if self._unanswered % TRIES == 0:
            self.shorten()

    def shorten(self) -> None:
        """Use the next shorter length of `LENGTHS`, if there is one."""
        self._lower(next((length for length in LENGTHS if length < self.largest), self.largest))

    def carried(self, largest: int) -> None:
        """Record that the gateway answered a datagram of `largest` bytes."""
        if self._mtu is None:
            self.largest = max(self.largest, largest)

    def _lower(self, largest: int) -> None:
        if self._mtu is None and largest < self.largest:
            self.largest = max(largest, LENGTHS[-1] // 2)
            if self.on_lowered is not None:
                self.on_lowered()
