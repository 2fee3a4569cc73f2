"""The messages of one gateway as its host speaks them: with the session under way in their checks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import NO_SESSION, seed_of
from unity_link.protocol.wire.frames import LF
from unity_link.protocol.wire.messages import Codec

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo


class HostCodec(Codec):
    """The messages of one gateway, in one session after the other.

    Args:
        info: what the gateway said of itself.
        node: its number on a shared medium, or None.
    """

    def __init__(self, info: GatewayInfo, node: int | None = None) -> None:
        super().__init__(info, node)
        self.prefix_size = len(self.framing.prefix)
        self.burst_end = b"" if Feature.HALF_DUPLEX in info.features else LF
        """An empty frame, by which damage to the end of the last one is found; none where sides take turns, for it is
        alone there."""
        self.begin(NO_SESSION)

    def begin(self, session: int) -> None:
        """Begin a session."""
        self.session = session
        self.seed = seed_of(session, from_gateway=False)
        """Seed of what is sent."""
        self.seed_back = seed_of(session, from_gateway=True)
        """Seed of what the gateway sends."""
        framing = self.framing
        self.begun = framing.crc.begun(framing.prefix, framing.begun ^ self.seed)
        """Value with which the checks of what is sent begin, so that the seed is in them behind the prefix."""
        self.begun_back = framing.crc.begun(framing.prefix, framing.begun ^ self.seed_back)
        """The same of what the gateway sends."""

    def confirmations(self, first: int, count: int) -> bytes:
        """Return the frames of ``h`` with consecutive IDs."""
        ids = (number & self.id_count - 1 for number in range(first, first + count))
        return b"".join(self.request("H", number, b"", self.seed) for number in ids)

    def residue(self, size: int) -> int:
        """Return what a gateway without a session finds in the check of a sound request of so many characters."""
        body = size - self.framing.overhead
        return self.framing.crc.of(bytes(body), self.seed)
