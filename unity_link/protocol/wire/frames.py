"""Frames (docs/protocol.md, "Frames"): the bytes between two line ends.

- A *checked* frame is a body, its CRC and LF.
- A *plain* frame, which a person can type, is a body and CR. A gateway ends its plain replies with CR LF.
- On a medium that several nodes share ("Addressed frames"), each frame begins with a prefix: `Z` and the number of the
  node in two digits. The CRC covers the prefix.

Other modules handle bodies, and pass the seed of their session (`unity_link.protocol.wire.crc.seed_of`).
"""

from __future__ import annotations

import functools
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from unity_link.protocol.wire.crc import Crc

LF = b"\n"
CR = b"\r"
_CR_BYTE = CR[0]
COMPACT_START, COMPACT_END, COMPACT_ESCAPE = b"\xb5", b"\xca", b"\xd3"
"""Bytes before and after a frame in compact form, and before a byte with a value of these three."""
COMPACT_STUFFED = 0x40
"""Value that is xored into a byte after `COMPACT_ESCAPE`."""
COMPACT_RESERVED = LF + CR + COMPACT_START + COMPACT_END + COMPACT_ESCAPE
"""Byte values that must be escaped between the start and the end of a compact frame."""
TOKEN_LINE = b"token "
"""Beginning of the first line of a connection to a server that requires a token; no command begins with it."""
LONGEST_FRAME = 16_384
"""Most bytes without a line end that a receiver keeps; the longest message, a sample of 255 64-bit words, has less."""
MOST_LINES = 128
"""Most lines that a host decodes one by one in one turn of its event loop; the rest waits for the next turn."""
_END = re.compile(rb"[\r\n\xca]")
_SMALL = ord("a")
_SAMPLE = ord("P")
LARGEST_DATAGRAM = 1400
"""Most bytes of a datagram with its header, so that it fits in one Ethernet packet."""


def in_session(letter: int) -> bool:
    """Return whether frames with this first letter have the session in their CRC: those with an ID, and samples."""
    return letter >= _SMALL or letter == _SAMPLE


class FrameError(ValueError):
    """A frame that is damaged, cut, or for another node."""


class CheckError(FrameError):
    """A frame with a wrong CRC. Few handlers print it, so the text is formatted by `__str__`, not when it is raised."""

    def __str__(self) -> str:
        """Return the message."""
        return f"wrong CRC in {self.args[0][:80]!r}"


class OtherNodeError(FrameError):
    """A frame of another node on a shared medium."""


class Framing:
    """Makes frames of bodies, and checks frames and returns their bodies.

    Args:
        crc: the CRC of the gateway.
        node: number of the node on a shared medium, 0 to 0xFE, or None if the medium has one gateway.
    """

    def __init__(self, crc: Crc, node: int | None = None) -> None:
        self.crc = crc
        self.prefix = b"" if node is None else b"Z%02X" % node
        self.begun: int = crc.of(self.prefix)
        """CRC of the prefix: the initial value for a body, before the seed of a session is xored into it."""
        self.ending = crc.text_before(LF)
        """Returns the CRC of a body and LF; the second argument is the initial value of the CRC."""
        self.ending_size = crc.digits + len(LF)
        self.overhead = len(self.prefix) + self.ending_size
        """Characters of a checked frame beyond its body."""

    def checked(self, body: bytes, seed: int = 0) -> bytes:
        """Return the checked frame of `body`; `seed` is that of the session, or 0."""
        return self.prefix + body + self.ending(body, self.begun ^ seed)

    def plain_request(self, body: bytes) -> bytes:
        """Return the plain frame of `body` as a host sends it."""
        return self.prefix + body + CR

    def plain_reply(self, body: bytes) -> bytes:
        """Return the plain frame of `body` as a gateway sends it."""
        return self.prefix + body + CR + LF

    def open(self, line: bytes, seed: int = 0) -> bytes:
        """Return the body of a frame that a gateway sent.

        Args:
            line: the frame without its LF.
            seed: seed of the current session for frames of the gateway, 0 if there is no session.

        Raises:
            OtherNodeError: if the frame is another node's. Its CRC is not checked, because its session is unknown.
            CheckError: if the CRC is wrong.
        """
        if self.prefix:
            if not line.startswith(self.prefix):
                if line[:1] == b"Z":
                    raise OtherNodeError(f"not from node {self.prefix[1:].decode()}: {line[:80]!r}")
                raise CheckError(line)
            line = line[len(self.prefix) :]
        if line and line[-1] == _CR_BYTE:
            return line[:-1]
        digits = self.crc.digits
        body = line[:-digits]
        begun = self.begun ^ seed if body and in_session(body[0]) else self.begun
        if self.crc.text(body, begun) != line[-digits:]:
            raise CheckError(line)
        return body


def datagrams(data: bytes, room: int = LARGEST_DATAGRAM) -> list[bytes]:
    """Divide frames into as few datagrams of at most `room` bytes as possible; a longer frame is not cut."""
    if 0 < len(data) <= room:
        return [data]
    return _pieces(room).findall(data)


def end_of_first(data: bytes | bytearray) -> int:
    """Return the offset after the first complete frame, or 0 if none is complete."""
    found = _END.search(data)
    return 0 if found is None else found.end()


def end_of_last(data: bytes) -> int:
    """Return the offset after the last frame that ends in LF or in compact form, or 0 if there is none."""
    return max(data.rfind(LF), data.rfind(COMPACT_END)) + 1


@functools.cache
def _pieces(room: int) -> re.Pattern[bytes]:
    """Return a pattern that matches as many complete frames as fit in `room` bytes, or one longer frame."""
    return re.compile(rb"(?s:.{1,%d}(?<=[\r\n\xca])(?![\r\n\xca])|[^\r\n\xca]*[\r\n\xca]+)" % room)
