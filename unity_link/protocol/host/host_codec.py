"""The message codec of a host, with the current session in the CRC of each frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import NO_SESSION, seed_of
from unity_link.protocol.wire.frames import LF
from unity_link.protocol.wire.messages import Codec

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo


class HostCodec(Codec):
    """Encodes requests and decodes answers of one gateway, for one session at a time.

    Args:
        info: the gateway's configuration.
        node: its number on a shared medium, or None.
    """

    def __init__(self, info: GatewayInfo, node: int | None = None) -> None:
        super().__init__(info, node)
        self.prefix_size = len(self.framing.prefix)
        self.burst_end = b"" if Feature.HALF_DUPLEX in info.features else LF
        """An empty frame to send after a burst, so that a damaged end of the last frame is detected at once. Nothing on
        a half-duplex line, because only one frame is sent there at a time."""
        self.begin(NO_SESSION)

    def begin(self, session: int) -> None:
        """Use the number of a session from now on."""
        self.session = session
        self.seed = seed_of(session, from_gateway=False)
        """Seed of the host's frames."""
        self.seed_back = seed_of(session, from_gateway=True)
        """Seed of the gateway's frames."""
        framing = self.framing
        self.begun = framing.crc.begun(framing.prefix, framing.begun ^ self.seed)
        """Initial value of the CRC of a whole frame, prefix included, that gives the same CRC as the seed after the
        prefix; for frames of the host."""
        self.begun_back = framing.crc.begun(framing.prefix, framing.begun ^ self.seed_back)
        """As `begun`, for frames of the gateway."""

    def confirmations(self, first: int, count: int) -> bytes:
        """Return the frames of ``h`` with consecutive IDs."""
        ids = (number & self.id_count - 1 for number in range(first, first + count))
        return b"".join(self.request("H", number, b"", self.seed) for number in ids)

    def residue(self, size: int) -> int:
        """Return the residue that a gateway without a session reports for an undamaged request of `size` characters."""
        body = size - self.framing.overhead
        return self.framing.crc.of(bytes(body), self.seed)
