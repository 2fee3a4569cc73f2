"""The build of the gateware that the experiment asks for: the paper's check, and what a board with an FT232H has."""

from __future__ import annotations

from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.messages import Codec
from unity_link.virtual.rtl import RtlGateway, choose

MODEL = GatewayInfo(
    clock_hz=50_000_000,
    id_digits=3,
    crc_bits=8,
    crc_polynomial=0x07,
    groups=16,
    base_frequency_millihertz=1_000_000_000,
)
"""Parts of the model that count here. Fewer digits of ID would leave too few requests under way for a USB."""
CODEC = Codec(MODEL)
"""Its messages."""


def compiled_gateway() -> RtlGateway:
    """Return the gateware itself.

    Raises:
        ConnectError: where it can't be compiled here.
    """
    names = ("clock_hz", "id_digits", "crc_bits", "crc_polynomial", "groups", "base_frequency_millihertz")
    return RtlGateway(choose({name: getattr(MODEL, name) for name in names}).name)


def checked(body: bytes) -> bytes:
    """Return the checked frame of a message."""
    return CODEC.framing.checked(body)
