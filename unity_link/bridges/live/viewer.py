"""One browser that looks at the page: what it is told, and what it asks for."""

from __future__ import annotations

import asyncio
import contextlib
import time
from typing import TYPE_CHECKING

import msgspec
from starlette.websockets import WebSocketDisconnect

from unity_link.bridges.live.outbox import Outbox
from unity_link.bridges.live.writing import Hello, Refused, Write

if TYPE_CHECKING:
    from starlette.websockets import WebSocket

    from unity_link.bridges.live.writing import Writing

PICTURES_PER_SECOND = 60
"""How often samples are sent: as often as a screen shows another picture."""
_NO_WRITES = "writes are off: they are allowed by unity-link live --allow-writes"
_WRONG_TOKEN = "this page does not know the token: open the link that unity-link live printed"  # noqa: S105
_POLICY_VIOLATION = 1008


class Welcome(msgspec.Struct, tag_field="type", tag="welcome"):
    """The answer to `Hello`."""

    may_write: bool


class Viewer:
    """A WebSocket of the page.

    Args:
        socket: accepted.
        about: the first message.
        writing: what writes; None where writes are not allowed.
    """

    def __init__(self, socket: WebSocket, about: bytes, writing: Writing | None) -> None:
        self.outbox = Outbox()
        self.status = b""
        """What is sent next of how the link is; a newer one takes the place of one that waits."""
        self._socket = socket
        self._about = about
        self._writing = writing
        self._may_write = False

    async def run(self) -> None:
        """Serve it until it has gone."""
        sending = asyncio.create_task(self._send())
        # Either one finds out that the browser has gone.
        with contextlib.suppress(WebSocketDisconnect):
            try:
                await self._receive()
            finally:
                sending.cancel()
                with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect):
                    await sending

    async def _send(self) -> None:
        """Send what there is at the pace of a screen; waits here while the browser does not read."""
        send = self._socket.send_bytes
        await self._socket.send_text(self._about.decode())
        while True:
            await asyncio.sleep(1 / PICTURES_PER_SECOND)
            samples = self.outbox.take(time.time())
            if samples is not None:
                await send(samples)
            if self.status:
                status, self.status = self.status, b""
                await self._socket.send_text(status.decode())

    async def _receive(self) -> None:
        decode = msgspec.json.Decoder(Hello | Write).decode
        while True:
            event = await self._socket.receive()
            if event["type"] == "websocket.disconnect":
                return
            try:
                answer = await self._answer(decode(event.get("text") or event.get("bytes") or b""))
            except msgspec.DecodeError:
                await self._socket.close(_POLICY_VIOLATION)
                return
            await self._socket.send_text(msgspec.json.encode(answer).decode())

    async def _answer(self, message: Hello | Write) -> object:
        if isinstance(message, Hello):
            self._may_write = self._writing is not None and self._writing.knows(message.token)
            return Welcome(self._may_write)
        if self._writing is None:
            return Refused(message.number, _NO_WRITES)
        if not self._may_write:
            return Refused(message.number, _WRONG_TOKEN)
        return await self._writing.write(message)
