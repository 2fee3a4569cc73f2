"""The checks of a received line in a gateway, before it executes anything (docs/protocol.md, "Errors").

- `Reception` makes the checks 1 to 5: overflow, length, CRC, command and form.
- `Sequence` makes check 6: the ID.
- `group_fits` makes the part of check 7 that concerns the settings of a group.
"""

from __future__ import annotations

import enum
import re
from typing import TYPE_CHECKING

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import NO_SESSION, seed_of
from unity_link.protocol.wire.messages import DecodedRequest, ErrorCode, GroupFlag, RequestError

if TYPE_CHECKING:
    from unity_link.protocol.wire.messages import Codec

_HEX = re.compile(rb"[0-9A-Fa-f]*")
_NEEDED_FEATURES = {
    GroupFlag.TRIGGER: Feature.EXTERNAL_TRIGGERS,
    GroupFlag.IMMEDIATE: Feature.SEND_IMMEDIATE,
    GroupFlag.TIMESTAMP: Feature.TIMESTAMPS,
}
_ALWAYS_KNOWN = GroupFlag.PERIODIC | GroupFlag.ON_CHANGE | GroupFlag.PLAIN
_UNASKED = GroupFlag.PERIODIC | GroupFlag.TRIGGER
"""Flags of groups that publish without a request, which half-duplex nodes do not support."""


class Reception:
    """Checks and decodes received lines.

    Args:
        codec: message codec of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self.longest = codec.info.longest_request
        """Characters of the longest request, without the prefix of the node and the line end."""
        self._codec = codec
        self._crc = codec.framing.crc

    def read(
        self, line: bytes, *, plain: bool, prefix: bytes = b"", session: int = NO_SESSION, bytes_lost: bool = False
    ) -> DecodedRequest:
        """Check overflow, length, CRC, command and form, in this order.

        Args:
            line: the line without its end and without the prefix of an addressed frame.
            plain: True if the line ended in CR, so that it has no CRC.
            prefix: prefix of an addressed frame, which the CRC covers.
            session: number of the current session, which is in the CRC of a frame with an ID. Without a session that
                CRC is not checked, and `DecodedRequest.residue` is the difference.
            bytes_lost: True if the receive FIFO has lost bytes of the line.

        Raises:
            RequestError: with the code of the error response.
        """
        if bytes_lost:
            raise RequestError(ErrorCode.RECEIVE_OVERFLOW)
        if len(line) > self.longest:
            raise RequestError(ErrorCode.TOO_LONG)
        if plain:
            return self._codec.decode_plain_request(line)
        body, check = line[: -self._crc.digits], line[-self._crc.digits :]
        if len(check) != self._crc.digits or not _HEX.fullmatch(check):
            raise RequestError(ErrorCode.CRC)
        has_id = body[:1].islower()
        begun = self._crc.of(prefix) ^ (seed_of(session, from_gateway=False) if has_id else 0)
        residue = self._crc.of(body, begun) ^ int(check, 16)
        if residue and not (has_id and session == NO_SESSION):
            raise RequestError(ErrorCode.CRC)
        return self._codec.decode_request(body)._replace(residue=residue)


def group_fits(
    info: GatewayInfo, number: int, flags: int, divisor: int, addresses: list[int], *, for_program: bool
) -> bool:
    """Return whether a gateway accepts the settings of a group; otherwise it answers error 06.

    Args:
        info: configuration of the gateway.
        number: number of the group.
        flags: flags of the group.
        divisor: divisor of the base frequency.
        addresses: addresses of the group's words.
        for_program: True if a program began the session; then samples must be checked frames.
    """
    known = int(_ALWAYS_KNOWN)
    if for_program:
        known &= ~int(GroupFlag.PLAIN)
    for flag, feature in _NEEDED_FEATURES.items():
        if feature in info.features:
            known |= int(flag)
    if Feature.HALF_DUPLEX in info.features:
        known &= ~int(_UNASKED)
    return (
        number < info.groups
        and not flags & ~known
        and divisor > 0
        and 1 <= len(addresses) <= info.group_words
        and max(addresses) < 1 << info.address_bits
    )


class SequencePlace(enum.Enum):
    """Position of a request's ID relative to the expected one (docs/protocol.md, "Exactly once, in order")."""

    NO_SESSION = enum.auto()
    """There is no session, so no request with an ID is executed."""
    NEXT = enum.auto()
    """The request has the expected ID, and the expected ID was advanced."""
    FIRST_AHEAD = enum.auto()
    """A request before it was lost; the gateway reports the gap by ``n``."""
    AHEAD = enum.auto()
    """A request before it was lost, and the gap was reported before."""
    REPETITION = enum.auto()
    """The request was executed before."""


class Sequence:
    """The expected ID, -1 without a session, and the outcomes of earlier requests.

    Args:
        id_count: number of IDs.
    """

    __slots__ = ("_half", "expected", "gap_reported", "mask", "outcomes")

    def __init__(self, id_count: int) -> None:
        self.mask = id_count - 1
        self._half = id_count // 2
        self.outcomes = bytearray(self._half)
        """Error code of the last request of each ID, modulo half the sequence space; 0 for success.

        Neither a reset nor a new session clears them, as in the gateware; a host asks only for its own outcomes.
        """
        self.reset()

    def reset(self) -> None:
        """Go back to the state after reset: no session has begun."""
        self.expected = -1
        self.gap_reported = False
        """True if an ``n`` was sent since the last request with the expected ID."""

    def start(self, expected: int) -> None:
        """Begin a session with its first ID."""
        self.expected = expected
        self.gap_reported = False

    def advance(self, count: int = 1) -> None:
        """Advance the expected ID by `count` requests, and set their outcomes to success."""
        for number in range(self.expected, self.expected + count):
            self.outcomes[number % self._half] = 0
        self.expected = self.expected + count & self.mask
        self.gap_reported = False

    def outcome(self, number: int) -> int:
        """Return the error code of an executed request, 0 for success."""
        return self.outcomes[number % self._half]

    def place(self, number: int) -> SequencePlace:
        """Return the position of a request's ID; advance the expected ID if it is that one."""
        if self.expected < 0:
            return SequencePlace.NO_SESSION
        distance = number - self.expected & self.mask
        if distance == 0:
            self.advance()
            return SequencePlace.NEXT
        if distance >= self._half:
            return SequencePlace.REPETITION
        if self.gap_reported:
            return SequencePlace.AHEAD
        self.gap_reported = True
        return SequencePlace.FIRST_AHEAD
