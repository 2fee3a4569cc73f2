"""The build of the gateware that the experiment asks for: the paper's check, and what a board with an FT232H has."""

from __future__ import annotations

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.frames import in_session
from unity_link.protocol.wire.messages import Codec
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
SESSION = 1
"""Number of the session of frames with an ID."""
OPENING = CODEC.opening(0, SESSION) + b"\r"
"""Begins that session as a person does it, so that frames without an ID write as well."""
OPENED_BYTES = len(OPENING) + CODEC.info.session_digits + len(b"\n")
"""Bytes of the answer: the request, the session that ended, and one more end."""


def compiled_gateway(features: Feature = MODEL.features) -> RtlGateway:
    """Return the gateware itself, built with some features.

    Raises:
        ConnectError: where it can't be compiled here.
    """
    names = ("clock_hz", "id_digits", "crc_bits", "crc_polynomial", "groups", "base_frequency_millihertz")
    return RtlGateway(choose({"features": features, **{name: getattr(MODEL, name) for name in names}}).name)


def checked(body: bytes) -> bytes:
    """Return the checked frame of a request; of one with an ID in the session `SESSION`."""
    return CODEC.framing.checked(body, seed_of(SESSION, from_gateway=False) if in_session(body[0]) else 0)
