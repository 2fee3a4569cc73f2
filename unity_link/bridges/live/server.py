"""The web server under the page, uvicorn, bounded against any client.

Any program of this machine may connect. What it may cost is bounded here: connections, by hanging up on the oldest that
has not become a page, so that silent ones keep no others out; what waits for a client that asks and does not read;
parts of a message; what all pages together say in an interval, so that samples have time. Whatever a client says that
the libraries below do not foresee ends its own connection.
"""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any, TypeVar

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.protocols.utils import ClientDisconnected
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Iterable, Iterator

    from starlette.types import ASGIApp
    from websockets.frames import Frame

MOST_STRANGERS = 128
"""Connections that are no WebSocket, or not yet; a browser has six at most."""
MOST_PAGES = 64
"""WebSockets, more than are looked after: the others are told so."""
LARGEST_MESSAGE = 4096
"""Bytes of what a page says."""
MOST_PARTS = 64
"""Most parts of a message; browsers send one."""
INTERVAL = 1 / 60
"""Seconds over which messages are counted: one picture of a screen, a delay that cannot be seen."""
MOST_FRAMES = 32
"""Messages, their parts and pings that are heard of all pages in an interval; a page where twenty sliders move at once
says less. Each takes some 50 µs."""
_PART = 64
"""Bytes that are heard together, so that few messages are in them."""
_BACKLOG = 64
_INVALID_DATA = 1007
Conversation = TypeVar("Conversation", "HttpConversation", "PageConversation")


class HttpConversation(H11Protocol):
    """A connection that asks for files, or to become a page."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Take it, and hang up on the oldest one where there are too many."""
        super().connection_made(transport)
        self.began = self.loop.time()
        strangers = _open(HttpConversation, self.connections)
        if len(strangers) > MOST_STRANGERS:
            min(strangers, key=lambda other: other.began).transport.abort()

    def data_received(self, data: bytes) -> None:
        """Take what was said."""
        with _ending(self):
            super().data_received(data)

    def shutdown(self) -> None:
        """End it, whether or not it reads what it asked for."""
        super().shutdown()
        self.transport.abort()


class PageConversation(WebSocketsSansIOProtocol):
    """A page's WebSocket, or what says that it is one."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Take it, unless there are too many."""
        self.unheard = bytearray()
        """Bytes received that wait for their turn."""
        self._may_say = 0
        self._interval: asyncio.TimerHandle | None = None
        super().connection_made(transport)
        if len(_open(PageConversation, self.connections)) > MOST_PAGES:
            self.transport.abort()

    def data_received(self, data: bytes) -> None:
        """Take what was said."""
        self.unheard += data
        if self._interval is None:
            self._begin_interval()
        self._hear()

    def handle_events(self) -> None:
        """Count them, and take them."""
        self._may_say -= len(self.conn.events)
        super().handle_events()

    async def receive(self) -> Any:
        """Wait for a message, which has the library read on; what has not been heard holds that up."""
        message = await super().receive()
        if self.unheard:
            self.transport.pause_reading()
        return message

    async def send(self, message: Any) -> None:
        """Send, unless the connection has ended, of which the library learns later: asyncio would warn each time."""
        await self.writable.wait()
        if self.transport.is_closing():
            raise ClientDisconnected
        await super().send(message)

    def handle_ping(self) -> None:
        """Answer, or hang up on one that does not read the answers."""
        if self.transport.is_closing():
            # More of them came with the one at which it was hung up on; each would be a warning of asyncio's.
            return
        if self.writable.is_set():
            super().handle_ping()
        else:
            self.transport.abort()

    def handle_cont(self, event: Frame) -> None:
        """Take a part of a message."""
        if len(self.frames) < MOST_PARTS:
            super().handle_cont(event)
        else:
            self.transport.abort()

    def send_receive_event_to_app(self) -> None:
        """Hand on a message."""
        if self.curr_msg_data_type == "text":
            try:
                b"".join(self.frames).decode()
            except UnicodeDecodeError:
                self.conn.fail(_INVALID_DATA)
                self.handle_parser_exception()
                return
        super().send_receive_event_to_app()

    def keepalive_timeout(self) -> None:
        """Hang up on a page that has neither read nor said anything for long; the place is free for another one."""
        super().keepalive_timeout()
        self.transport.abort()

    def shutdown(self) -> None:
        """End it, whether or not it reads."""
        super().shutdown()
        if not self.writable.is_set():
            self.transport.abort()

    def _begin_interval(self) -> None:
        talkers = sum(bool(page.unheard) for page in _open(PageConversation, self.connections))
        # What it said beyond its share the last time is of this one.
        self._may_say = min(self._may_say, 0) + max(1, MOST_FRAMES // max(1, talkers))
        self._interval = self.loop.call_later(INTERVAL, self._end_interval)

    def _end_interval(self) -> None:
        self._interval = None
        if self.unheard and not self.transport.is_closing():
            self._begin_interval()
            self._hear()

    def _hear(self) -> None:
        """Hear what was said, up to this page's share of the interval; until the rest is heard, no more is read."""
        with _ending(self):
            while self.unheard and self._may_say > 0 and not self.transport.is_closing():
                part = bytes(self.unheard[:_PART])
                del self.unheard[:_PART]
                super().data_received(part)
        if self.unheard:
            self.transport.pause_reading()
        elif not self.read_paused:
            self.transport.resume_reading()


def _open(kind: type[Conversation], connections: Iterable[object]) -> list[Conversation]:
    """Return the connections of a kind that have not been closed."""
    return [other for other in connections if isinstance(other, kind) and not other.transport.is_closing()]


@contextlib.contextmanager
def _ending(conversation: HttpConversation | PageConversation) -> Iterator[None]:
    try:
        yield
    except Exception:  # noqa: BLE001  (whatever it is: it is about what this client said, and costs no other)
        conversation.transport.abort()


class PageServer(uvicorn.Server):
    """A server in a program that looks after signals itself."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Leave them alone."""
        yield


def make_server(app: ASGIApp) -> PageServer:
    """Make a server of an application."""
    config = uvicorn.Config(
        app,
        log_config=None,
        # What a client says wrong is no matter of the terminal.
        log_level="error",
        access_log=False,
        lifespan="off",
        server_header=False,
        http=HttpConversation,
        ws=PageConversation,
        ws_max_size=LARGEST_MESSAGE,
        # On one machine bytes cost less than making them fewer.
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
        backlog=_BACKLOG,
    )
    # It imports for long, which would lose samples once they come.
    config.load()
    return PageServer(config)
