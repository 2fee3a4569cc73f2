"""The configuration of the gateware for the experiment: the paper's CRC, and the features of a board with an FT232H."""

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
"""Relevant fields of the model. With fewer ID digits, too few requests would be in flight for USB."""
CODEC = Codec(MODEL)
"""Messages of the model."""
SESSION = 1
"""Number of the session for frames with an ID."""
OPENING = CODEC.opening(0, SESSION) + b"\r"
"""Begins that session with a plain frame, so that frames without an ID can write as well."""
OPENED_BYTES = len(OPENING) + CODEC.info.session_digits + len(b"\n")
"""Bytes of the answer: the request, the session that ended, and one more end."""


def compiled_gateway(features: Feature = MODEL.features) -> RtlGateway:
    """Return the compiled gateware, built with some features.

    Raises:
        ConnectError: if it cannot be compiled on this machine.
    """
    names = ("clock_hz", "id_digits", "crc_bits", "crc_polynomial", "groups", "base_frequency_millihertz")
    return RtlGateway(choose({"features": features, **{name: getattr(MODEL, name) for name in names}}).name)


def checked(body: bytes) -> bytes:
    """Return the checked frame of a request; one with an ID belongs to the session `SESSION`."""
    return CODEC.framing.checked(body, seed_of(SESSION, from_gateway=False) if in_session(body[0]) else 0)
