"""The session between a host and a gateway, as one who listens to both knows it.

The answer to `K i s` names it. Where listening began later, two frames show it: the CRC run backwards over a frame
gives what it began with, which is the same number in both if they are whole and of one session.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.crc import NO_SESSION, last_session, seed_of
from unity_link.protocol.wire.frames import CheckError, Framing, in_session

if TYPE_CHECKING:
    from unity_link.protocol.wire.messages import DecodedResponse


class ObservedSession:
    """Opens the frames of both sides.

    Args:
        framing: takes bodies out of frames.
    """

    def __init__(self, framing: Framing) -> None:
        self.number = NO_SESSION
        """Number of the session, 0 for none or one that has not been found yet."""
        self._framing = framing
        self._guess = NO_SESSION

    def open(self, line: bytes, *, from_gateway: bool) -> bytes:
        """Return the body of a frame.

        Args:
            line: what came before the LF.
            from_gateway: True for a frame of the gateway.

        Raises:
            FrameError: where it is damaged or another node's.
        """
        try:
            return self._framing.open(line, seed_of(self.number, from_gateway=from_gateway))
        except CheckError:
            if self.number != NO_SESSION and (body := self._without_session(line)):
                return body
            if not self._finds(line, from_gateway=from_gateway):
                raise
            return self._framing.open(line, seed_of(self.number, from_gateway=from_gateway))

    def hear(self, response: DecodedResponse) -> None:
        """Take it from an answer to `K` which session is under way; the bit above its number asks for a form."""
        if response.command == "K":
            self.number, self._guess = response.fields["k"] & last_session(self._framing.crc.digits), NO_SESSION

    def _without_session(self, line: bytes) -> bytes:
        """Return the body of a frame as it is without a session, empty if it is none: after a reset there is none."""
        try:
            body = self._framing.open(line)
        except CheckError:
            return b""
        return body

    def _finds(self, line: bytes, *, from_gateway: bool) -> bool:
        """Return whether a frame is the second of a session that was not known."""
        framing = self._framing
        digits = framing.crc.digits
        body, check = line[len(framing.prefix) : -digits], line[-digits:]
        if not body or not in_session(body[0]) or check.strip(b"0123456789ABCDEFabcdef"):
            return False
        seed = framing.crc.begun(body, int(check, 16)) ^ framing.begun
        guess = seed >> 1
        if seed & 1 != from_gateway or not guess or seed >> 4 * min(digits, 4):
            return False
        self._guess, before = guess, self._guess
        if guess == before:
            self.number = guess
        return guess == before
