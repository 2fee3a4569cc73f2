"""One browser that shows the page: the messages to it, and its requests."""

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
"""Rate at which samples are sent: the frame rate of a screen."""
_NO_WRITES = "writes are off: they are allowed by unity-link live --allow-writes"
_WRONG_TOKEN = "this page does not know the token: open the link that unity-link live printed"  # noqa: S105
_POLICY_VIOLATION = 1008


class Welcome(msgspec.Struct, tag_field="type", tag="welcome"):
    """The answer to `Hello`."""

    may_write: bool


class Viewer:
    """A WebSocket of the page.

    Args:
        socket: accepted WebSocket.
        about: the first message, which describes the robot.
        writing: writes values; None if pages may not write.
        stopping: disarms leases.
    """

    def __init__(self, socket: WebSocket, about: bytes, writing: Writing | None, stopping: Stopping) -> None:
        self.outbox = Outbox()
        self.status = b""
        """State of the link, to be sent next; a newer one replaces it."""
        self._socket = socket
        self._about = about
        self._writing = writing
        self._stopping = stopping
        self._may_write = False
        self._sent_garbage = False
        self._left = asyncio.Event()

    async def run(self) -> None:
        """Serve the browser until it disconnects."""
        # End all tasks as soon as one of them ends: the others might wait forever.
        working = [asyncio.create_task(one) for one in (self._send(), self._receive(), self._left.wait())]
        try:
            await asyncio.wait(working, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in working:
                task.cancel()
            outcomes = await asyncio.gather(*working, return_exceptions=True)
        # Only the first task gets a WebSocketDisconnect; the others end with other errors.
        if any(isinstance(outcome, WebSocketDisconnect) for outcome in outcomes):
            return
        for outcome in outcomes:
            if isinstance(outcome, Exception):
                raise outcome
        if self._sent_garbage:
            with contextlib.suppress(WebSocketDisconnect):
                await self._socket.close(_POLICY_VIOLATION)

    def leave(self) -> None:
        """End the service."""
        self._left.set()

    async def _send(self) -> None:
        """Send samples and states at the frame rate of a screen; this blocks while the browser does not read."""
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
            # The last two are raised for messages that no page sends: nested too deeply, or not in UTF-8.
            except (msgspec.DecodeError, RecursionError, UnicodeError):
                self._sent_garbage = True
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
