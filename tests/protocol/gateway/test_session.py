"""The gateway's side of a session: cases that no test of a whole gateway has."""

from __future__ import annotations

import pytest

from unity_link.protocol.gateway.session import GatewaySession
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec, ErrorCode


def test_a_session_exists_from_its_opening_until_a_reset() -> None:
    session = GatewaySession(Codec(GatewayInfo()))
    found = [session.begun]
    session.begin(0x1234, 0)
    found.append(session.begun)
    session.reset()
    assert [*found, session.begun] == [False, True, False]


@pytest.mark.parametrize(("crc_bits", "last"), [(8, 0x7F), (16, 0x7FFF), (32, 0x7FFF)])
def test_a_session_number_leaves_a_bit_of_the_crc_for_the_direction(crc_bits: int, last: int) -> None:
    codec = Codec(GatewayInfo(crc_bits=crc_bits, crc_polynomial=0x07))
    session = GatewaySession(codec)
    for number in (0, last + 1, 2 * last + 1):
        session.take(codec.opening(0, number), plain=True)
        assert not session.begun
    session.take(codec.opening(0, last), plain=True)
    assert session.state.number == last
    assert max(session.state.seeds) < 1 << crc_bits


def test_requests_that_end_after_their_session_leave_the_next_unchanged() -> None:
    session = GatewaySession(Codec(GatewayInfo()))
    session.begin(1, 0)
    late = session.state
    session.begin(2, 0)
    late.fail(0, ErrorCode.BUS_ERROR, posted=True)
    late.keep(0, [5])
    session.sequence.expected = 1
    assert (session.sequence.outcome(0), session.state.failed, session.state.kept[0]) == (0, 0, 0)
