"""Frames in datagrams (docs/protocol.md, "Datagrams"): what comes late, twice or from another session is dropped.

Each datagram begins with a header, the frame ``U s c`` of a session and a count. The gateway offers a session, a ``K``
opens it, and in it a side takes only what has a newer count than all before. What is left is a line that keeps the
order and may lose frames, which the window makes up for.

`HostDatagrams` and `GatewayDatagrams` are the two sides, without I/O. What they take out of a datagram are whole
frames: one that was cut at its end is ended, so that it does not spoil the next.
"""

from __future__ import annotations

import re
import secrets
from itertools import groupby
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from unity_link.errors import ConnectError, UnsupportedError
from unity_link.protocol.compact import START, cut, text_of
from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.crc import Crc
from unity_link.protocol.frames import COMPACT_END, LF, FrameError, Framing, datagrams
from unity_link.protocol.messages import ErrorCode, RequestError
from unity_link.protocol.path import Path
from unity_link.protocol.reception import Reception

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.messages import Codec

A = TypeVar("A")

NO_SESSION = 0
_OUTSIDE = 0
"""The count of an offer and of a refusal, which belong to no session."""
_LAST_COUNT = 0xFFFFFFFF
_HEADER = re.compile(rb"[\r\n]*((?:Z[0-9A-F]{2})?U([0-9A-Fa-f]{8})([0-9A-Fa-f]{8}))(?:\r\n?|([0-9A-Fa-f]+)\n)")
"""Groups of a header: the text that its CRC covers, session, count, and the CRC, None in a plain one."""
_FIRST_FRAME = re.compile(rb"[\r\n]*([^\r\n]*\r?)\n?")
_REFUSAL = b"X%02X" % ErrorCode.NO_SESSION
_OF_SESSION = re.compile(rb"[g-zP]")
"""First letters of answers that only a session has, and of samples."""


class Counts:
    """Filter of late and doubled datagrams: how many were sent, and the newest count that was taken."""

    def __init__(self) -> None:
        self.sent = self.taken = _OUTSIDE

    def next(self) -> int:
        """Return the count of the next datagram to send."""
        self.sent = self.sent % _LAST_COUNT + 1
        return self.sent

    def takes(self, count: int) -> bool:
        """Return whether a count is newer than all before; then it is the newest."""
        if count == _OUTSIDE or not 0 < (count - self.taken & _LAST_COUNT) <= _LAST_COUNT >> 1:
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
    return Datagram(int(session, 16), int(count, 16), _ended(datagram[header.end() :]), check is None)


def _ended(frames: bytes) -> bytes:
    return frames if frames.endswith(b"\n") else frames + b"\n"


def _frames(data: bytes) -> list[bytes]:
    """Return the frames that are not empty, each with its end: CR, LF or CR LF."""
    return [frame for frame in data.splitlines(keepends=True) if frame.strip(b"\r\n")]


def _first_line(frames: bytes) -> bytes:
    """Return what stands before the first LF, line ends before it left out."""
    first = _FIRST_FRAME.match(frames)
    assert first is not None
    return first[1]


def _with_header(framing: Framing, session: int, count: int, frames: bytes, *, plain: bool = False) -> bytes:
    body = b"U%08X%08X" % (session, count)
    return (framing.plain_reply(body) if plain else framing.checked(body)) + frames


_FULL = Path()
"""The path for which a gateway packs its datagrams."""


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
            _with_header(self._framing, self.session, self.counts.next(), packed)
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
        if read.number == _OUTSIDE and self._is_refusal(read.frames):
            raise ConnectError("the gateway was reset, or another program has opened a session with it")
        if not self.counts.takes(read.number):
            return b""
        # A line end behind a compact frame would be an empty line.
        return read.frames[:-1] if read.frames.endswith(COMPACT_END + LF) else read.frames

    def _take_offer(self, datagram: bytes, read: Datagram | None) -> bytes:
        if read is None:
            # A gateway of version 01 has no headers; its answer says so.
            return _ended(datagram)
        if read.number != _OUTSIDE or read.session == NO_SESSION or self._is_refusal(read.frames):
            return b""
        self.offer = read.session
        if read.plain:
            self._learn(read.frames)
        return read.frames

    def _learn(self, frames: bytes) -> None:
        """Take the CRC from an answer to a plain ``Q``."""
        try:
            body = self._framing.open(_first_line(frames))
            info = GatewayInfo.from_hex(body.removeprefix(b"Q"))
        except (ValueError, UnsupportedError):
            return
        self._framing = Framing(Crc(info.crc_bits, info.crc_polynomial), self._node)

    def _is_refusal(self, frames: bytes) -> bool:
        try:
            return self._framing.open(_first_line(frames)) == _REFUSAL
        except FrameError:
            return False


class Requester(NamedTuple, Generic[A]):
    """Host whose requests without a session were taken last, and their form."""

    address: A
    plain: bool


class GatewayDatagrams(Generic[A]):
    """The gateway's side of a socket, from one reset to the next.

    What the gateway sends goes to the address that opened the session; answers to requests without a header go to the
    address that they came from. A response without an ID does not say whose it is: it is for the address whose datagram
    was taken last.

    Args:
        codec: the messages of the gateway.
        execute: takes frames for the gateway, and may call `put` at once.
        send: takes a datagram and where it goes.
        draw: returns a random number of 32 bits.
    """

    def __init__(
        self,
        codec: Codec,
        execute: Callable[[bytes], object],
        send: Callable[[bytes, A], object],
        draw: Callable[[], int] = lambda: secrets.randbits(32),
    ) -> None:
        self.session = NO_SESSION
        self.opener: A | None = None
        """The address that opened the session."""
        self.offer = NO_SESSION
        """The session that can be opened next; none before it is first needed."""
        self.counts = Counts()
        self._codec = codec
        self._framing = codec.framing
        self._reception = Reception(codec)
        self.requester: Requester[A] | None = None
        """Destination of answers without an ID, if not the opener."""
        self._execute = execute
        self._send = send
        self._draw = draw

    def take(self, datagram: bytes, source: A) -> None:
        """Take a datagram that came from an address."""
        try:
            read = read_header(datagram, self._framing)
        except FrameError:
            return
        if read is None:
            self._take_questions(datagram, source)
        elif read.number == _OUTSIDE:
            # Another gateway's. Were it refused, that one would refuse the refusal, and so on for ever.
            return
        elif (read.session, source) == (self.session, self.opener):
            if self.counts.takes(read.number):
                self.requester = None
                self._execute(read.frames)
        elif NO_SESSION != read.session == self.offer and (after_k := self._after_k(read.frames)) is not None:
            if self._framing.checked(b"K")[len(self._framing.prefix) + 1 :].startswith(after_k.rstrip(b"\r").upper()):
                # A `K` without fields only looks: it would leave the former host's session under way.
                self._take_questions(read.frames, source)
            else:
                self._open(read, source)
        else:
            self._refuse(read.session, source, plain=read.plain)

    def put(self, frames: bytes) -> None:
        """Send frames of the gateway; those that are for no address are lost."""
        if self.requester is None:
            self._send_to_opener(frames)
            return
        for of_session, group in groupby(cut(frames), self._is_of_session):
            (self._send_to_opener if of_session else self._send_to_requester)(b"".join(group))

    # Sessions

    def _open(self, read: Datagram, source: A) -> None:
        """Begin the session that was offered; the one before is over, and its opener is told."""
        if self.opener is not None:
            self._refuse(self.session, self.opener, plain=False)
        self.session, self.opener, self.offer = read.session, source, NO_SESSION
        self.counts = Counts()
        self.counts.takes(read.number)
        self.requester = None
        self._execute(read.frames)

    def _after_k(self, frames: bytes) -> bytes | None:
        """Return what stands behind the `K` of the first frame; None where that begins otherwise."""
        line, beginning = _first_line(frames), self._framing.prefix + b"K"
        return line[len(beginning) :] if line.startswith(beginning) else None

    def _refuse(self, session: int, address: A, *, plain: bool) -> None:
        frame = self._framing.plain_reply if plain else self._framing.checked
        self._send(_with_header(self._framing, session, _OUTSIDE, frame(_REFUSAL), plain=plain), address)

    def _send_to_opener(self, frames: bytes) -> None:
        if self.opener is not None:
            for packed in datagrams(frames, _FULL.room(self._framing)):
                self._send(_with_header(self._framing, self.session, self.counts.next(), packed), self.opener)

    # Requests without a session

    def _take_questions(self, datagram: bytes, source: A) -> None:
        """Execute requests without an ID, and refuse the others."""
        frames = _frames(text_of(self._codec.info, from_gateway=False)(_ended(datagram)))
        if not frames:
            return
        self.requester = Requester(source, plain=b"\r" in frames[0])
        for refusal, group in groupby(frames, self._refusal):
            if refusal is None:
                self._execute(b"".join(group))
            else:
                for _ in group:
                    self._send_to_requester(refusal)

    def _refusal(self, frame: bytes) -> bytes | None:
        """Return the answer to a request that needs a session, None for all that the gateway may see without one."""
        line, plain = frame.rstrip(b"\r\n"), b"\r" in frame
        size = len(self._framing.prefix)
        try:
            request = self._reception.read(line[size:], plain=plain, prefix=line[:size])
        except RequestError:
            return None
        if request.id is None and not (request.command == "K" and request.values):
            return None
        if line[:size] != self._framing.prefix:
            return b""
        error = _REFUSAL if request.id is None else self._codec.no_session(request.id, request.residue)
        return self._framing.plain_reply(error) if plain else self._framing.checked(error)

    def _send_to_requester(self, frames: bytes) -> None:
        assert self.requester is not None
        address, plain = self.requester
        while self.offer in (NO_SESSION, self.session):
            self.offer = self._draw()
        for packed in datagrams(frames, _FULL.room(self._framing)):
            self._send(_with_header(self._framing, self.offer, _OUTSIDE, packed, plain=plain), address)

    def _is_of_session(self, frame: bytes) -> bool:
        if self.session == NO_SESSION:
            return False
        if frame.startswith(START):
            return True
        body = frame[len(self._framing.prefix) :].rstrip(b"\r\n")
        if body.startswith(b"K"):
            # The answer to the question is shorter than that to the opening of a session.
            ending = 0 if b"\r" in frame else self._framing.crc.digits
            return len(body) > 1 + self._codec.info.session_digits + ending
        return _OF_SESSION.match(body) is not None
