"""A passive listener finds the number of a session from the frames on the line."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.capture.observed_session import ObservedSession
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import CheckError
from unity_link.protocol.wire.messages import Codec, DecodedResponse

CODECS = [Codec(GatewayInfo()), Codec(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7)), Codec(GatewayInfo(), 5)]


@given(bits=st.sampled_from([8, 16, 32]), polynomial=st.integers(0, 127), data=st.binary(), begun=st.integers(0, 0xFF))
def test_the_initial_value_of_a_crc_is_computed_from_its_result(
    bits: int, polynomial: int, data: bytes, begun: int
) -> None:
    crc = Crc(bits, 2 * polynomial + 1)
    assert crc.begun(data, crc.of(data, begun)) == begun


@pytest.mark.parametrize("codec", CODECS, ids=["CRC-16", "CRC-32", "node"])
@pytest.mark.parametrize("from_gateway", [True, False])
def test_two_frames_reveal_the_number_of_the_session(codec: Codec, from_gateway: bool) -> None:
    overheard, seed = ObservedSession(codec.framing), seed_of(0x1234, from_gateway=from_gateway)
    first, second = codec.framing.checked(b"h000000", seed)[:-1], codec.framing.checked(b"r00100000005", seed)[:-1]
    with pytest.raises(CheckError):
        overheard.open(first, from_gateway=from_gateway)
    assert overheard.open(second, from_gateway=from_gateway) == b"r00100000005"
    assert overheard.open(first, from_gateway=from_gateway) == b"h000000"
    assert overheard.number == 0x1234


def test_a_damaged_or_foreign_frame_does_not_change_a_known_session() -> None:
    codec = CODECS[0]
    overheard = ObservedSession(codec.framing)
    overheard.hear(DecodedResponse("K", None, {"k": 0x1234}))
    seed = seed_of(0x1234, from_gateway=True)
    frame = codec.framing.checked(b"h000000", seed)[:-1]
    with pytest.raises(CheckError):
        overheard.open(frame[:3] + b"1" + frame[4:], from_gateway=True)
    with pytest.raises(CheckError):
        overheard.open(codec.framing.checked(b"h000000", seed_of(5, from_gateway=True))[:-1], from_gateway=True)
    assert overheard.open(frame, from_gateway=True) == b"h000000"
    # After a reset, frames belong to no session.
    refused = codec.framing.checked(b"x0000A1234")[:-1]
    assert overheard.open(refused, from_gateway=True) == b"x0000A1234"
