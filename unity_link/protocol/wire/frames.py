"""The bytes between two line ends (docs/protocol.md, "Frames"): a body, its check and its end.

A *checked* frame is the body, its CRC and LF. A *plain* one, which a person can type, is the body and CR; a gateway
ends its plain replies with CR LF. On a medium that several nodes share ("Addressed frames") each body stands behind a
prefix of `Z` and two digits, which the CRC covers. Everything above this module sees bodies only, and of a session
what it puts into checks: the seed (`unity_link.protocol.wire.crc.seed_of`).
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
"""Value that is xored into a byte behind `COMPACT_ESCAPE`."""
COMPACT_RESERVED = LF + CR + COMPACT_START + COMPACT_END + COMPACT_ESCAPE
"""Bytes that stand between start and end behind an escape only."""
TOKEN_LINE = b"token "
"""Beginning of the first line of a connection where a token is wanted; no command begins so."""
LONGEST_FRAME = 16_384
"""Bytes without a line end that are kept: more than the longest message, a sample of 255 words of 64 bits, has."""
MOST_LINES = 128
"""Lines that a host looks at one by one in one turn of what runs it; the rest of a read waits for the next."""
_END = re.compile(rb"[\r\n\xca]")
_SMALL = ord("a")
_SAMPLE = ord("P")
LARGEST_DATAGRAM = 1400
"""Bytes that are put together into one datagram, its header among them: what passes an Ethernet in one piece."""


def in_session(letter: int) -> bool:
    """Return whether a frame with a first letter belongs to a session, if there is one: with an ID, or a sample."""
    return letter >= _SMALL or letter == _SAMPLE


class FrameError(ValueError):
    """A frame that is damaged, cut, or not for us."""


class CheckError(FrameError):
    """A frame whose check fails. Its text is made when it is asked for, which is seldom."""

    def __str__(self) -> str:
        """Return what is wrong."""
        return f"wrong CRC in {self.args[0][:80]!r}"


class OtherNodeError(FrameError):
    """A frame of another node on a shared medium."""


class Framing:
    """Puts bodies into frames and takes them out again.

    Args:
        crc: the check in use.
        node: number of the node on a shared medium, 0 to 0xFE, or None for a medium of our own.
    """

    def __init__(self, crc: Crc, node: int | None = None) -> None:
        self.crc = crc
        self.prefix = b"" if node is None else b"Z%02X" % node
        self.begun: int = crc.of(self.prefix)
        """The CRC of the prefix, with which that of a body begins; the seed of a session is xored into it."""
        self.ending = crc.text_before(LF)
        """Returns what stands behind a body, given the value with which its CRC begins: the CRC and LF."""
        self.ending_size = crc.digits + len(LF)
        self.overhead = len(self.prefix) + self.ending_size
        """Characters of a checked frame beyond its body."""

    def checked(self, body: bytes, seed: int = 0) -> bytes:
        """Return the checked frame of `body`, with the seed of a session if it is a frame of one."""
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
            line: what came before the LF.
            seed: of the session under way and what its gateway sends, 0 without one.

        Raises:
            OtherNodeError: where the frame is another node's; its check has a session that is not known here.
            CheckError: where the check fails.
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
    """Return frames in as few pieces of at most `room` bytes as they fit in; a longer frame is not cut."""
    if 0 < len(data) <= room:
        return [data]
    return _pieces(room).findall(data)


def end_of_first(data: bytes | bytearray) -> int:
    """Return where the first of some frames ends, 0 where none does."""
    found = _END.search(data)
    return 0 if found is None else found.end()


def end_of_last(data: bytes) -> int:
    """Return where the last frame that ends in LF or is compact ends, 0 where none does."""
    return max(data.rfind(LF), data.rfind(COMPACT_END)) + 1


@functools.cache
def _pieces(room: int) -> re.Pattern[bytes]:
    """Return what matches as many whole frames as fit, or one that is longer."""
    return re.compile(rb"(?s:.{1,%d}(?<=[\r\n\xca])(?![\r\n\xca])|[^\r\n\xca]*[\r\n\xca]+)" % room)
