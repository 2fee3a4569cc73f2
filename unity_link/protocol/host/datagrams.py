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
    """The host's end of one socket, which opens one session.

    The width and polynomial of the headers' CRC are those in the gateway's last answer to a plain ``Q``.

    Args:
        node: number of the gateway on a shared medium, or None.
        path: longest datagram of the network; None for the default.
    """

    def __init__(self, node: int | None = None, path: Path | None = None) -> None:
        self._path = path or Path()
        self.session = NO_SESSION
        self.offer = NO_SESSION
        """Number of the session that the gateway offered last; `NO_SESSION` before the first offer."""
        self.counts = Counts()
        self._node = node
        self._framing = Framing(Crc(), node)

    def put(self, frames: bytes) -> list[bytes]:
        """Return the datagrams with these frames for the gateway; the first ``K i s`` opens the session."""
        if self.session == NO_SESSION:
            if not self._begins_session(frames):
                return datagrams(frames)
            self.session = self.offer
            if self.session == NO_SESSION:
                # Without an offer the ``K i s`` cannot be sent. Drop it: the handshake sends another one.
                return []
        return [
            with_header(self._framing, self.session, self.counts.next(), packed)
            for packed in datagrams(frames, self._path.room(self._framing))
        ]

    def _begins_session(self, frames: bytes) -> bool:
        # A session query must have no header: with one it would open a session, and end that of another host.
        text, letter = frames.lstrip(b"\r\n"), self._framing.prefix + b"K"
        return text.startswith(letter) and not text.startswith((letter + b"\r", self._framing.checked(b"K")))

    def take(self, datagram: bytes) -> bytes:
        """Return the frames of a datagram of this session; nothing for a late, damaged or foreign datagram.

        Raises:
            ConnectError: if the gateway refuses the session, because it is over.
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
        # Remove the line end after a compact frame: it would count as an empty line.
        return read.frames[:-1] if read.frames.endswith(COMPACT_END + LF) else read.frames

    def _take_offer(self, datagram: bytes, read: Datagram | None) -> bytes:
        if read is None:
            # A gateway of protocol version 01 sends no headers. Return its answer, which contains the version.
            return ended(datagram)
        if read.number != OUTSIDE or read.session == NO_SESSION or self._is_refusal(read.frames):
            return b""
        self.offer = read.session
        if read.plain:
            self._learn(read.frames)
        return read.frames

    def _learn(self, frames: bytes) -> None:
        """Use the width and polynomial of the CRC in an answer to a plain ``Q``."""
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
