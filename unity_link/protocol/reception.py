"""The parts of what a gateway makes of a line that a host sent, before it executes anything.

`Reception` is steps 1 to 5 of the checks in docs/protocol.md, "Errors", `Sequence` is step 6, `group_fits` is what step
7 says of the settings of a group. `unity_link.protocol.gateway_session` joins the first two.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING

from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.messages import DecodedRequest, ErrorCode, GroupFlag, RequestError

if TYPE_CHECKING:
    from unity_link.protocol.messages import Codec

_NEEDED_FEATURES = {
    GroupFlag.TRIGGER: Feature.EXTERNAL_TRIGGERS,
    GroupFlag.IMMEDIATE: Feature.SEND_IMMEDIATE,
    GroupFlag.TIMESTAMP: Feature.TIMESTAMPS,
}
_ALWAYS_KNOWN = GroupFlag.PERIODIC | GroupFlag.ON_CHANGE | GroupFlag.PLAIN
_UNASKED = GroupFlag.PERIODIC | GroupFlag.TRIGGER
"""Flags of groups that publish without being asked to, which half-duplex nodes do not."""


class Reception:
    """Makes requests of lines.

    Args:
        codec: the messages of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self.longest = codec.info.longest_request
        """Characters before the line end of the longest request, prefix not counted."""
        self._codec = codec
        self._crc = codec.framing.crc

    def read(self, line: bytes, *, plain: bool, prefix: bytes = b"", bytes_lost: bool = False) -> DecodedRequest:
        """Check overflow, length, CRC, command and form, in this order.

        Args:
            line: what stood before the line end, without the prefix of an addressed frame.
            plain: whether the line ended in CR, and so has no CRC.
            prefix: of an addressed frame, which its CRC covers.
            bytes_lost: whether bytes of the line were lost before they could be looked at.

        Raises:
            RequestError: with the code of the error to answer.
        """
        if bytes_lost:
            raise RequestError(ErrorCode.RECEIVE_OVERFLOW)
        if len(line) > self.longest:
            raise RequestError(ErrorCode.TOO_LONG)
        if plain:
            return self._codec.decode_plain_request(line)
        body, check = line[: -self._crc.digits], line[-self._crc.digits :]
        if self._crc.text(prefix + body) != check.upper():
            raise RequestError(ErrorCode.CRC)
        return self._codec.decode_request(body)


def group_fits(info: GatewayInfo, number: int, flags: int, divisor: int, addresses: list[int]) -> bool:
    """Return whether a gateway takes the settings of a group; otherwise it answers error 06."""
    known = int(_ALWAYS_KNOWN)
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
    """Place of a request with an ID in the order (docs/protocol.md, "Exactly once, in order")."""

    NO_SESSION = enum.auto()
    """No session has begun since reset: nothing with an ID is executed."""

    NEXT = enum.auto()
    """The request is the one expected, and now counted."""
    FIRST_AHEAD = enum.auto()
    """Something before it was lost, and the host has not been told yet."""
    AHEAD = enum.auto()
    """Something before it was lost, and the host knows."""
    REPETITION = enum.auto()


class Sequence:
    """The one number that a gateway keeps: the next ID expected, -1 before the first session since reset.

    Args:
        ring: number of IDs.
    """

    __slots__ = ("_half", "expected", "gap_told", "mask")

    def __init__(self, ring: int) -> None:
        self.mask = ring - 1
        self._half = ring // 2
        self.reset()

    def reset(self) -> None:
        """Go back to the state after reset: no session has begun."""
        self.expected = -1
        self.gap_told = False
        """True if the host knows of the gap before the requests that come now."""

    def start(self, expected: int) -> None:
        """Begin a session."""
        self.expected = expected
        self.gap_told = False

    def advance(self, count: int = 1) -> None:
        """Count requests that were the expected ones."""
        self.expected = self.expected + count & self.mask
        self.gap_told = False

    def place(self, number: int) -> SequencePlace:
        """Return where a request stands, and count it if it is the next."""
        if self.expected < 0:
            return SequencePlace.NO_SESSION
        distance = number - self.expected & self.mask
        if distance == 0:
            self.advance()
            return SequencePlace.NEXT
        if distance >= self._half:
            return SequencePlace.REPETITION
        if self.gap_told:
            return SequencePlace.AHEAD
        self.gap_told = True
        return SequencePlace.FIRST_AHEAD
