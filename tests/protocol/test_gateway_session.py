"""The gateway's side of a session, where no test of a gateway says it."""

from __future__ import annotations

from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.gateway_session import GatewaySession
from unity_link.protocol.messages import Codec


def test_there_is_a_session_from_its_first_id_on_whatever_that_is_until_a_reset() -> None:
    session = GatewaySession(Codec(GatewayInfo()))
    found = [session.begun]
    session.sequence.expected = 0
    found.append(session.begun)
    session.reset()
    assert [*found, session.begun] == [False, True, False]
