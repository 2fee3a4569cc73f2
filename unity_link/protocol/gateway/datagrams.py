"""The gateway's end of the datagrams of one socket (docs/protocol.md, "Datagrams").

1. A datagram of the open session, from the address that opened it, and with a newer count: its frames are executed.
2. A datagram with the offered session number that begins with `K i s`: that session begins, and the previous one ends.
3. A datagram without a header, or one with the offered session number and a session query: requests without an ID are
   executed, others are refused. The answers have a header that offers a session.
4. Any other datagram with an undamaged header is refused by error 0A, unless it is itself an offer or a refusal.
"""

from __future__ import annotations

import re
import secrets
from itertools import groupby
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from unity_link.protocol.gateway.reception import Reception
from unity_link.protocol.wire.compact import START, cut, text_of
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
from unity_link.protocol.wire.frames import FrameError, datagrams
from unity_link.protocol.wire.messages import RequestError
from unity_link.protocol.wire.path import Path

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.messages import Codec

_OF_SESSION = re.compile(rb"[g-zP]")
"""Pattern of the first letter of samples, and of answers with an ID."""
_FULL = Path()
"""The longest datagrams, which a gateway always uses."""
A = TypeVar("A")


def _frames(data: bytes) -> list[bytes]:
    """Return the frames in `data`, each with its end: CR, LF or CR LF; empty ones are left out."""
    return [frame for frame in data.splitlines(keepends=True) if frame.strip(b"\r\n")]


class Requester(NamedTuple, Generic[A]):
    """The source of the last requests without a session."""

    address: A
    plain: bool
    """True if the first of these requests was a plain frame."""


class GatewayDatagrams(Generic[A]):
    """The gateway's end of a socket, between two resets.

    Frames of the session go to the address that opened it. Answers to requests without a header go to the address of
    these requests. A response without an ID goes to the address of the last datagram that was accepted.

    Args:
        codec: message codec of the gateway.
        execute: passes frames to the gateway; it may call `put` before it returns.
        send: sends a datagram to an address.
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
        """Number of the offered session; `NO_SESSION` before the first offer."""
        self.counts = Counts()
        self._codec = codec
        self._framing = codec.framing
        self._reception = Reception(codec)
        self.requester: Requester[A] | None = None
        """Destination of answers without an ID; None if it is the opener."""
        self._execute = execute
        self._send = send
        self._draw = draw

    def take(self, datagram: bytes, source: A) -> None:
        """Take a datagram from an address."""
        try:
            read = read_header(datagram, self._framing)
        except FrameError:
            return
        if read is None:
            self._take_unopened(datagram, source)
        elif read.number == OUTSIDE:
            # Another gateway sent it. Do not refuse it, because that gateway would refuse the refusal, without end.
            return
        elif (read.session, source) == (self.session, self.opener):
            if self.counts.takes(read.number):
                self.requester = None
                self._execute(read.frames)
        elif NO_SESSION != read.session == self.offer and (after_k := self._after_k(read.frames)) is not None:
            if self._framing.checked(b"K")[len(self._framing.prefix) + 1 :].startswith(after_k.rstrip(b"\r").upper()):
                # A session query must not open the session of the datagrams: it would not end the gateway's session.
                self._take_unopened(read.frames, source)
            else:
                self._open(read, source)
        else:
            self._refuse(read.session, source, plain=read.plain)

    def put(self, frames: bytes) -> None:
        """Send frames of the gateway; frames without a destination are dropped."""
        if self.requester is None:
            self._send_to_opener(frames)
            return
        for of_session, group in groupby(cut(frames), self._is_of_session):
            (self._send_to_opener if of_session else self._send_to_requester)(b"".join(group))

    # Sessions

    def _open(self, read: Datagram, source: A) -> None:
        """Begin the offered session; the previous one is over, and its opener gets a refusal."""
        if self.opener is not None:
            self._refuse(self.session, self.opener, plain=False)
        self.session, self.opener, self.offer = read.session, source, NO_SESSION
        self.counts = Counts()
        self.counts.takes(read.number)
        self.requester = None
        self._execute(read.frames)

    def _after_k(self, frames: bytes) -> bytes | None:
        """Return the characters after the `K` of the first frame; None if it is another command."""
        line, beginning = first_line(frames), self._framing.prefix + b"K"
        return line[len(beginning) :] if line.startswith(beginning) else None

    def _refuse(self, session: int, address: A, *, plain: bool) -> None:
        frame = self._framing.plain_reply if plain else self._framing.checked
        self._send(with_header(self._framing, session, OUTSIDE, frame(REFUSAL), plain=plain), address)

    def _send_to_opener(self, frames: bytes) -> None:
        if self.opener is not None:
            for packed in datagrams(frames, _FULL.room(self._framing)):
                self._send(with_header(self._framing, self.session, self.counts.next(), packed), self.opener)

    # Requests without a session

    def _take_unopened(self, datagram: bytes, source: A) -> None:
        """Execute requests without an ID, and refuse the others."""
        frames = _frames(text_of(self._codec.info, from_gateway=False)(ended(datagram)))
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
        """Return the answer to a request that needs a session; None for frames that the gateway handles without one."""
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
        error = REFUSAL if request.id is None else self._codec.no_session(request.id, request.residue)
        return self._framing.plain_reply(error) if plain else self._framing.checked(error)

    def _send_to_requester(self, frames: bytes) -> None:
        assert self.requester is not None
        address, plain = self.requester
        while self.offer in (NO_SESSION, self.session):
            self.offer = self._draw()
        for packed in datagrams(frames, _FULL.room(self._framing)):
            self._send(with_header(self._framing, self.offer, OUTSIDE, packed, plain=plain), address)

    def _is_of_session(self, frame: bytes) -> bool:
        """Return whether a frame of the gateway belongs to the open session: a sample, or an answer with an ID."""
        if self.session == NO_SESSION:
            return False
        if frame.startswith(START):
            return True
        body = frame[len(self._framing.prefix) :].rstrip(b"\r\n")
        if body.startswith(b"K"):
            # The answer to a session query is shorter than the answer to `K i s`.
            ending = 0 if b"\r" in frame else self._framing.crc.digits
            return len(body) > 1 + self._codec.info.session_digits + ending
        return _OF_SESSION.match(body) is not None
