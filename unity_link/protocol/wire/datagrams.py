"""Datagrams and their headers (docs/protocol.md, "Datagrams"), as both ends of a socket use them.

1. Each datagram begins with a header: the frame ``U s c`` with the number of a session and a count.
2. The gateway offers a session in its answers to a host without one. A ``K i s`` with the offered number opens it.
3. In a session, each side accepts only datagrams with a newer count than all before. Late and doubled datagrams, and
   those of other sessions, are dropped.

The result is a line that keeps the order and may lose frames, which the window retransmits. `HostDatagrams` and
`GatewayDatagrams` are the two ends, without I/O.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from unity_link.protocol.wire.frames import FrameError, Framing
from unity_link.protocol.wire.messages import ErrorCode

NO_SESSION = 0
"""Session number of a datagram that means that there is no session."""
OUTSIDE = 0
"""Count of offers and refusals, which are outside of sessions."""
_LAST_COUNT = 0xFFFFFFFF
_HEADER = re.compile(rb"[\r\n]*((?:Z[0-9A-F]{2})?U([0-9A-Fa-f]{8})([0-9A-Fa-f]{8}))(?:\r\n?|([0-9A-Fa-f]+)\n)")
"""Pattern of a header. Its groups: the text that the CRC covers, session, count, and the CRC (None if it is plain)."""
_FIRST_FRAME = re.compile(rb"[\r\n]*([^\r\n]*\r?)\n?")
REFUSAL = b"X%02X" % ErrorCode.NO_SESSION
"""Body of the answer to frames of a session that is over."""


class Counts:
    """Counts of the datagrams of one session: the last sent one, and the newest accepted one."""

    def __init__(self) -> None:
        self.sent = self.taken = OUTSIDE

    def next(self) -> int:
        """Return the count of the next datagram to send."""
        self.sent = self.sent % _LAST_COUNT + 1
        return self.sent

    def takes(self, count: int) -> bool:
        """Return whether a count is newer than all accepted ones, modulo 2**32; if so, accept it."""
        if count == OUTSIDE or not 0 < (count - self.taken & _LAST_COUNT) <= _LAST_COUNT >> 1:
            return False
        self.taken = count
        return True


class Datagram(NamedTuple):
    """The contents of a datagram with a header."""

    session: int
    number: int
    """Count of the datagram."""
    frames: bytes
    """Frames after the header; the last one has a line end."""
    plain: bool
    """True if the header is a plain frame."""


def read_header(datagram: bytes, framing: Framing) -> Datagram | None:
    """Return the contents of a datagram, or None if it has no header.

    Raises:
        FrameError: if the header is damaged.
    """
    beginning = framing.prefix + b"U"
    header = _HEADER.match(datagram)
    if header is None or not header[1].startswith(beginning):
        if datagram.lstrip(b"\r\n").startswith(beginning):
            raise FrameError(f"malformed header in {datagram[:80]!r}")
        return None
    covered, session, count, check = header.groups()
    if check is not None and check.upper() != framing.crc.text(covered):
        raise FrameError(f"wrong CRC in the header {covered!r}")
    return Datagram(int(session, 16), int(count, 16), ended(datagram[header.end() :]), check is None)


def ended(frames: bytes) -> bytes:
    """Return frames with a line end after the last one: without it, a cut frame would damage the next."""
    return frames if frames.endswith(b"\n") else frames + b"\n"


def first_line(frames: bytes) -> bytes:
    """Return the first frame without its LF; leading line ends are left out."""
    first = _FIRST_FRAME.match(frames)
    assert first is not None
    return first[1]


def with_header(framing: Framing, session: int, count: int, frames: bytes, *, plain: bool = False) -> bytes:
    """Return a datagram: a header with the session and the count, and the frames after it."""
    body = b"U%08X%08X" % (session, count)
    return (framing.plain_reply(body) if plain else framing.checked(body)) + frames
