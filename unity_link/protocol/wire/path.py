"""The longest datagram that the network between host and gateway carries (docs/protocol.md, "Short paths").

A host bounds its own datagrams by it, and the answers that it asks for, because a gateway fills datagrams of 1,400
bytes. The longest datagram follows from the MTU in the URL, or from the MTU that the system knows, and from the opening
of the session: the host pads its `K`, so only a path that carries datagrams of that length answers it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.frames import LARGEST_DATAGRAM, LF

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.frames import Framing

SHORTEST_MTU, LONGEST_MTU = 576, 1500
"""Bytes of an IP packet: RFC 791 requires each host to take the first, and Ethernet carries the second."""
HEADERS, HEADERS_6 = 28, 48
"""Bytes of the headers of IPv4 or IPv6, and of UDP, in a packet."""
LENGTHS = (LARGEST_DATAGRAM, 1280 - HEADERS_6, SHORTEST_MTU - HEADERS)
"""Bytes of the datagrams that are tried in turn; the smallest MTU of IPv6, RFC 8200, is 1280."""
TRIES = 2
"""Unanswered requests for a session of one length before the next length is tried."""
HEADER_SIZE = len("U") + 16
MOST_AROUND = 2 * len("ZFF") + HEADER_SIZE + 8 + len("\n")
"""Bytes beside one frame in a datagram, at most: with any CRC and on any medium, with its line end."""
RESERVE = 64
"""Bytes of a datagram that are left to errors and to answers without an ID."""


class Path:
    """The network between a host and its gateway.

    Args:
        mtu: bytes of the longest IP packet, as the user gave it; None: the longest datagram is found.
    """

    def __init__(self, mtu: int | None = None) -> None:
        self._mtu = mtu
        self._headers = HEADERS
        self.largest = LARGEST_DATAGRAM
        """Bytes of UDP of the longest datagram."""
        self.on_lowered: Callable[[], None] | None = None
        """Called when `largest` has become smaller."""
        self._unanswered = 0
        self.begin(HEADERS, LONGEST_MTU)

    def begin(self, headers: int, known_mtu: int) -> None:
        """Set the size of the headers of IP and UDP, and the MTU that the system knows."""
        self._headers = headers
        mtu = known_mtu if self._mtu is None else self._mtu
        self.largest = min(mtu - headers, LARGEST_DATAGRAM)

    @property
    def mtu(self) -> int:
        """Bytes of the IP packet of the longest datagram."""
        return self.largest + self._headers

    @property
    def is_short(self) -> bool:
        """True if the path is not known to carry each datagram of a gateway."""
        return self.largest < LARGEST_DATAGRAM

    @property
    def longest_frame(self) -> int:
        """Bytes of the longest frame that has room in a datagram."""
        return self.largest - MOST_AROUND

    @property
    def shortest_frame(self) -> int:
        """Bytes of a frame that has room in a datagram of the shortest length."""
        return LENGTHS[-1] - MOST_AROUND

    def room(self, framing: Framing) -> int:
        """Return how many bytes of frames have room in a datagram, beside its header."""
        return self.largest - HEADER_SIZE - framing.overhead

    def padding(self, framing: Framing, size: int, most: float) -> bytes:
        """Return the empty frames that make a datagram with frames of `size` bytes the longest.

        Args:
            framing: of the header.
            size: bytes of the frames in the datagram.
            most: bytes that the gateway takes at once.
        """
        return LF * (int(min(self.room(framing), most)) - size)

    @property
    def bound(self) -> str:
        """The longest frame and the MTU of the path, as the part of an error."""
        return f"and the network carries frames of {self.longest_frame} bytes at most (mtu={self.mtu})"

    @property
    def advice(self) -> str:
        """The option that may help if answers are missing, for an error; empty if no shorter datagram is possible."""
        if self.largest <= LENGTHS[-1]:
            return ""
        return f" (if the network loses long packets, mtu={SHORTEST_MTU} in the URL keeps them short)"

    # Finding the longest datagram

    def lower(self, mtu: int) -> None:
        """Take an MTU that the system or an earlier session has learned, if it is smaller and the user gave none."""
        self._lower(mtu - self._headers)

    def unanswered(self) -> None:
        """Record that a datagram of the longest length had no answer; `TRIES` of them lower the length."""
        self._unanswered += 1
        if self._unanswered % TRIES == 0:
            self.shorten()

    def shorten(self) -> None:
        """Take the next shorter length."""
        self._lower(next((length for length in LENGTHS if length < self.largest), self.largest))

    def carried(self, largest: int) -> None:
        """Record that a datagram of so many bytes was answered."""
        if self._mtu is None:
            self.largest = max(self.largest, largest)

    def _lower(self, largest: int) -> None:
        if self._mtu is None and largest < self.largest:
            self.largest = max(largest, LENGTHS[-1] // 2)
            if self.on_lowered is not None:
                self.on_lowered()
