"""The session between a host and a gateway, as a passive observer of both directions finds it.

The initial value of a frame's CRC contains the number of the session. The observer learns that number in two ways:

- The answer to `K i s` contains it.
- If observation began later, two consecutive frames reveal it: running the CRC backwards over a frame gives its initial
  value. Equal results for two frames mean that both are undamaged and belong to that session.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.crc import NO_SESSION, last_session, seed_of
from unity_link.protocol.wire.frames import CheckError, Framing, in_session

if TYPE_CHECKING:
    from unity_link.protocol.wire.messages import DecodedResponse


class ObservedSession:
    """Checks the CRC of frames from both directions, and finds the number of their session.

    Args:
        framing: the framing of the gateway, with its CRC and node number.
    """

    def __init__(self, framing: Framing) -> None:
        self.number = NO_SESSION
        """Number of the session; 0 if there is none, or its number is not found yet."""
        self._framing = framing
        self._guess = NO_SESSION
        """Number that the CRC of the last frame of an unknown session implies."""

    def open(self, line: bytes, *, from_gateway: bool) -> bytes:
        """Return the body of a frame.

        Args:
            line: the frame without its LF.
            from_gateway: True for a frame of the gateway.

        Raises:
            FrameError: if the frame is damaged, or belongs to another node.
        """
        try:
            return self._framing.open(line, seed_of(self.number, from_gateway=from_gateway))
        except CheckError:
            if self.number != NO_SESSION and (body := self._without_session(line)):
                return body
            if not self._find_session(line, from_gateway=from_gateway):
                raise
            return self._framing.open(line, seed_of(self.number, from_gateway=from_gateway))

    def hear(self, response: DecodedResponse) -> None:
        """Set the session from an answer to `K`; the bit above the number (compact form) is masked out."""
        if response.command == "K":
            self.number, self._guess = response.fields["k"] & last_session(self._framing.crc.digits), NO_SESSION

    def _without_session(self, line: bytes) -> bytes:
        """Return the body of a frame whose CRC has no session, as after a reset; empty if the CRC has one."""
        try:
            body = self._framing.open(line)
        except CheckError:
            return b""
        return body

    def _find_session(self, line: bytes, *, from_gateway: bool) -> bool:
        """Set the session if this frame and the last one imply the same number; return whether they do."""
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
