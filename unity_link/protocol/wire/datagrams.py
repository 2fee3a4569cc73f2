"""Frames in datagrams (docs/protocol.md, "Datagrams"): what comes late, twice or from another session is dropped.

Each datagram begins with a header, the frame ``U s c`` of a session and a count. The gateway offers a session, a ``K``
opens it, and in it a side takes only what has a newer count than all before. What is left is a line that keeps the
order and may lose frames, which the window makes up for.

Both sides use this module: `HostDatagrams` and `GatewayDatagrams`, which are without I/O. They take whole frames out of
a datagram: a frame that was cut at its end gets a line end, so that it does not spoil the next.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from unity_link.protocol.wire.frames import FrameError, Framing
from unity_link.protocol.wire.messages import ErrorCode

NO_SESSION = 0
OUTSIDE = 0
"""The count of an offer and of a refusal, which belong to no session."""
_LAST_COUNT = 0xFFFFFFFF
_HEADER = re.compile(rb"[\r\n]*((?:Z[0-9A-F]{2})?U([0-9A-Fa-f]{8})([0-9A-Fa-f]{8}))(?:\r\n?|([0-9A-Fa-f]+)\n)")
"""Groups of a header: the text that its CRC covers, session, count, and the CRC, None in a plain one."""
_FIRST_FRAME = re.compile(rb"[\r\n]*([^\r\n]*\r?)\n?")
REFUSAL = b"X%02X" % ErrorCode.NO_SESSION
"""Body of the answer to frames of a session that is over."""


class Counts:
    """Filter of late and doubled datagrams: how many were sent, and the newest count that was taken."""

    def __init__(self) -> None:
        self.sent = self.taken = OUTSIDE

    def next(self) -> int:
        """Return the count of the next datagram to send."""
        self.sent = self.sent % _LAST_COUNT + 1
        return self.sent

    def takes(self, count: int) -> bool:
        """Return whether a count is newer than all before; then it is the newest."""
        if count == OUTSIDE or not 0 < (count - self.taken & _LAST_COUNT) <= _LAST_COUNT >> 1:
            return False
        self.taken = count
        return True


class Datagram(NamedTuple):
    """A datagram with a header."""

    session: int
    number: int
    """Its count."""
    frames: bytes
    """Bytes behind the header."""
    plain: bool
    """True if the header is a plain frame."""


def read_header(datagram: bytes, framing: Framing) -> Datagram | None:
    """Return what is in a datagram, None where it has no header.

    Raises:
        FrameError: for a header that is damaged.
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
    """Return frames with a line end after the last one, which may have been cut off."""
    return frames if frames.endswith(b"\n") else frames + b"\n"


def first_line(frames: bytes) -> bytes:
    """Return what stands before the first LF, line ends before it left out."""
    first = _FIRST_FRAME.match(frames)
    assert first is not None
    return first[1]


def with_header(framing: Framing, session: int, count: int, frames: bytes, *, plain: bool = False) -> bytes:
    """Return a datagram: the header of a session and a count, and frames after it."""
    body = b"U%08X%08X" % (session, count)
    return (framing.plain_reply(body) if plain else framing.checked(body)) + frames
