"""The parts of what a gateway makes of a line that a host sent, before it executes anything.

`Reception` is steps 1 to 5 of the checks in docs/protocol.md, "Errors", `Sequence` is step 6, `group_fits` is what step
7 says of the settings of a group. `unity_link.protocol.gateway.session` joins the first two.
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

    def read(
        self, line: bytes, *, plain: bool, prefix: bytes = b"", session: int = NO_SESSION, bytes_lost: bool = False
    ) -> DecodedRequest:
        """Check overflow, length, CRC, command and form, in this order.

        Args:
            line: what stood before the line end, without the prefix of an addressed frame.
            plain: whether the line ended in CR, and so has no CRC.
            prefix: of an addressed frame, which its CRC covers.
            session: the session under way, which is in the check of a frame with an ID; without one such a check is
                not compared.
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
    """Return whether a gateway takes the settings of a group; otherwise it answers error 06.

    Args:
        info: the configuration of the gateway.
        number: of the group.
        flags: of the group.
        divisor: of the base frequency.
        addresses: of the words.
        for_program: whether the session is a program's, in which samples are checked frames.
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
    """The next ID expected, -1 without a session, and how the requests before it ended.

    Args:
        ring: number of IDs.
    """

    __slots__ = ("_half", "expected", "fates", "gap_told", "mask")

    def __init__(self, ring: int) -> None:
        self.mask = ring - 1
        self._half = ring // 2
        self.fates = bytearray(self._half)
        """Error with which the last request of each ID, modulo half the ring, ended; 0 if it ended well.

        As in the gateware neither a reset nor a session changes them: a host asks for none that it did not cause.
        """
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
        """Count requests that were the expected ones, and ended well if nothing else is noted."""
        for number in range(self.expected, self.expected + count):
            self.fates[number % self._half] = 0
        self.expected = self.expected + count & self.mask
        self.gap_told = False

    def fate(self, number: int) -> int:
        """Return the error with which a request ended that was executed, 0 if it ended well."""
        return self.fates[number % self._half]

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
