"""The first words on a new connection: what the gateway is, and the start of a session (protocol sections 2 and 5).

`Q` is asked in plain form, because nothing is known yet, and again in the checked form that follows from the answer;
only if both agree is the answer believed. `K` then starts the session: the gateway expects ID 0 and publishes nothing.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from unity_link.errors import ConnectError
from unity_link.wire.crc import Crc
from unity_link.wire.frames import LF, FrameError, Framing
from unity_link.wire.gateway_info import GatewayInfo
from unity_link.wire.messages import Codec

if TYPE_CHECKING:
    from unity_link.stream import Stream

FIRST_TRY = 0.1
"""Seconds until a question is asked again, doubled each time."""
LONGEST_TRY = 1.0


class _Listener:
    """Waits for the one answer that a handshake is asking for."""

    def __init__(self) -> None:
        self.heard = 0
        self.framing = Framing(Crc())
        self.beginning = b""
        self.plain = True
        self.answer: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

    def receive(self, data: bytes) -> int:
        self.heard += len(data)
        *lines, rest = data.split(LF)
        for line in lines:
            self._receive_line(line)
        return len(data) - len(rest)

    def _receive_line(self, line: bytes) -> None:
        if line.endswith(b"\r") != self.plain:
            return
        try:
            body = self.framing.open(line)
        except FrameError:
            return
        if body.startswith(self.beginning) and not self.answer.done():
            self.answer.set_result(body)

    def disconnected(self, reason: Exception | None) -> None:
        if not self.answer.done():
            self.answer.set_exception(ConnectError(f"the connection ended before the gateway answered ({reason})"))
            # Nobody may be waiting at this moment.
            self.answer.exception()


async def shake_hands(stream: Stream, node: int | None) -> tuple[Codec, float]:
    """Learn what the gateway is and start a session.

    Args:
        stream: a new connection.
        node: number of the node on a shared medium, or None.

    Returns:
        The messages of the gateway, and the round trip of the last question in seconds.

    Raises:
        ConnectError: where the connection ends, or the two answers differ.
        UnsupportedError: where the gateway is of another protocol version or reports impossible widths.
    """
    listener = _Listener()
    listener.framing = Framing(Crc(), node)
    stream.receiver = listener
    # A line end first, for what an earlier program left unfinished. LF, not CR: that would execute it unchecked.
    plain = await _ask(stream, listener, LF + listener.framing.plain_request(b"Q"), b"Q")
    info = _read(plain)
    codec = Codec(info, node)
    listener.framing, listener.plain = codec.framing, False
    checked = await _ask(stream, listener, codec.framing.checked(b"Q"), b"Q")
    if _read(checked) != info:
        raise ConnectError(f"the gateway described itself first as {plain!r} and then as {checked!r}")
    start = asyncio.get_running_loop().time()
    session = b"K" + codec.id_text[0]
    await _ask(stream, listener, codec.framing.checked(session), session)
    stream.receiver = None
    return codec, asyncio.get_running_loop().time() - start


def _read(body: bytes) -> GatewayInfo:
    try:
        return GatewayInfo.from_hex(body[1:])
    except ValueError as error:
        raise ConnectError(f"what answers is no gateway: {error}") from None


async def _ask(stream: Stream, listener: _Listener, question: bytes, beginning: bytes) -> bytes:
    """Ask until the answer comes; the caller's time out ends it."""
    listener.beginning = beginning
    listener.answer = asyncio.get_running_loop().create_future()
    patience = FIRST_TRY
    while True:
        if stream.closed:
            raise ConnectError("the connection ended before the gateway answered")
        stream.send(question)
        try:
            return await asyncio.wait_for(asyncio.shield(listener.answer), patience)
        except TimeoutError:
            patience = min(2 * patience, LONGEST_TRY)
