"""One browser that looks at the page: what it is told, and what it asks for."""

from __future__ import annotations

import asyncio
import contextlib
import time
from typing import TYPE_CHECKING

import msgspec
from starlette.websockets import WebSocketDisconnect

from unity_link.bridges.live.outbox import Outbox
from unity_link.bridges.live.writing import Hello, Refused, Stop, Write

if TYPE_CHECKING:
    from starlette.websockets import WebSocket

    from unity_link.bridges.live.writing import Stopping, Writing

PICTURES_PER_SECOND = 60
"""Rate at which samples are sent: that of the pictures of a screen."""
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
        stopping: what disarms.
    """

    def __init__(self, socket: WebSocket, about: bytes, writing: Writing | None, stopping: Stopping) -> None:
        self.outbox = Outbox()
        self.status = b""
        """The link's state to be sent next; a newer one replaces one that waits."""
        self._socket = socket
        self._about = about
        self._writing = writing
        self._stopping = stopping
        self._may_write = False
        self._said_nonsense = False
        self._left = asyncio.Event()

    async def run(self) -> None:
        """Serve it until it has gone."""
        # Whichever finds out that it is over, the others may wait for ever.
        working = [asyncio.create_task(one) for one in (self._send(), self._receive(), self._left.wait())]
        try:
            await asyncio.wait(working, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in working:
                task.cancel()
            outcomes = await asyncio.gather(*working, return_exceptions=True)
        # All but the first task to find out have another error.
        if any(isinstance(outcome, WebSocketDisconnect) for outcome in outcomes):
            return
        for outcome in outcomes:
            if isinstance(outcome, Exception):
                raise outcome
        if self._said_nonsense:
            with contextlib.suppress(WebSocketDisconnect):
                await self._socket.close(_POLICY_VIOLATION)

    def leave(self) -> None:
        """Serve it no longer."""
        self._left.set()

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
        decode = msgspec.json.Decoder(Hello | Write | Stop).decode
        while True:
            event = await self._socket.receive()
            if event["type"] == "websocket.disconnect":
                return
            try:
                message = decode(event.get("text") or event.get("bytes") or b"")
            # The last two are of messages that no page sends: nested too deeply, or no UTF-8.
            except (msgspec.DecodeError, RecursionError, UnicodeError):
                self._said_nonsense = True
                return
            answer = await self._answer(message)
            await self._socket.send_text(msgspec.json.encode(answer).decode())

    async def _answer(self, message: Hello | Write | Stop) -> object:
        if isinstance(message, Hello):
            self._may_write = self._writing is not None and self._writing.knows(message.token)
            return Welcome(self._may_write)
        if isinstance(message, Stop):
            return await self._stopping.stop(message)
        if self._writing is None:
            return Refused(message.number, _NO_WRITES)
        if not self._may_write:
            return Refused(message.number, _WRONG_TOKEN)
        return await self._writing.write(message)
