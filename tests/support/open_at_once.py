"""A session that is open from the beginning, without a handshake."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.window.constants import SHORTEST_TIMEOUT

if TYPE_CHECKING:
    from unity_link.protocol.host.receiver import ResponseReceiver
    from unity_link.protocol.host.session import Session
    from unity_link.protocol.wire.configuration import GatewayInfo


def open_at_once(
    session: Session,
    info: GatewayInfo,
    node: int | None,
    number: int,
    *,
    first: int = 0,
    round_trip: float | None = None,
) -> ResponseReceiver:
    """Open a session with group 1 set up for samples of one word; return its response receiver."""
    known = {"session": number, "first": first, "round_trip": round_trip}
    handshake = SimpleNamespace(
        codec=HostCodec(info, node), byte_time=0.0, compact=False, has_echo=False, line_changes_bytes=False, **known
    )
    session._shortest_timeout = SHORTEST_TIMEOUT
    session._open(cast("Any", handshake), 0.0, [])
    session.groups.begun[b"01"] = session.groups.hold(b"", 5 + info.data_digits, None)
    assert session._receiver is not None
    return session._receiver
