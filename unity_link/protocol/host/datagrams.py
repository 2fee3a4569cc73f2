"""The host's end of the datagrams of one socket (docs/protocol.md, "Datagrams")."""

from __future__ import annotations

from unity_link.errors import ConnectError, UnsupportedError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.datagrams import (
    NO_SESSION,
    OUTSIDE,
    REFUSAL,
    Counts,
    Datagram,
    ended,
    first_line,
    read_header,
    with_header,
)
from unity_link.protocol.wire.frames import COMPACT_END, LF, FrameError, Framing, datagrams
from unity_link.protocol.wire.path import Path


class HostDatagrams:
    """The host's side of one socket: it opens one session.

    The CRC of the headers is that of the gateway's last answer to a plain ``Q``.

    Args:
        node: number of the gateway on a shared medium, or None.
        path: has the length of the longest datagram; None for the usual one.
    """

    def __init__(self, node: int | None = None, path: Path | None = None) -> None:
        self._path = path or Path()
        self.session = NO_SESSION
        self.offer = NO_SESSION
        """The session that the gateway offered last."""
        self.counts = Counts()
        self._node = node
        self._framing = Framing(Crc(), node)

    def put(self, frames: bytes) -> list[bytes]:
        """Return the datagrams in which frames go to the gateway; the first ``K i s`` opens the session."""
        if self.session == NO_SESSION:
            if not self._begins_session(frames):
                return datagrams(frames)
            self.session = self.offer
            if self.session == NO_SESSION:
                # As good as lost: it will be asked for again.
                return []
        return [
            with_header(self._framing, self.session, self.counts.next(), packed)
            for packed in datagrams(frames, self._path.room(self._framing))
        ]

    def _begins_session(self, frames: bytes) -> bool:
        # A `K` without fields only looks: with a header it would open a session all the same, and end another's.
        text, letter = frames.lstrip(b"\r\n"), self._framing.prefix + b"K"
        return text.startswith(letter) and not text.startswith((letter + b"\r", self._framing.checked(b"K")))

    def take(self, datagram: bytes) -> bytes:
        """Return the frames of a datagram that are the host's, none of one that is late or damaged.

        Raises:
            ConnectError: where the gateway says that the session is over.
        """
        try:
            read = read_header(datagram, self._framing)
        except FrameError:
            return b""
        if self.session == NO_SESSION:
            return self._take_offer(datagram, read)
        if read is None or read.session != self.session:
            return b""
        if read.number == OUTSIDE and self._is_refusal(read.frames):
            raise ConnectError("the gateway was reset, or another program has opened a session with it")
        if not self.counts.takes(read.number):
            return b""
        # A line end behind a compact frame would be an empty line.
        return read.frames[:-1] if read.frames.endswith(COMPACT_END + LF) else read.frames

    def _take_offer(self, datagram: bytes, read: Datagram | None) -> bytes:
        if read is None:
            # A gateway of version 01 has no headers; its answer says so.
            return ended(datagram)
        if read.number != OUTSIDE or read.session == NO_SESSION or self._is_refusal(read.frames):
            return b""
        self.offer = read.session
        if read.plain:
            self._learn(read.frames)
        return read.frames

    def _learn(self, frames: bytes) -> None:
        """Take the CRC from an answer to a plain ``Q``."""
        try:
            body = self._framing.open(first_line(frames))
            info = GatewayInfo.from_hex(body.removeprefix(b"Q"))
        except (ValueError, UnsupportedError):
            return
        self._framing = Framing(Crc(info.crc_bits, info.crc_polynomial), self._node)

    def _is_refusal(self, frames: bytes) -> bool:
        try:
            return self._framing.open(first_line(frames)) == REFUSAL
        except FrameError:
            return False
