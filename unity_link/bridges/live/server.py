"""The web server of the page, uvicorn, with limits on what clients can cost.

Any program of this machine can connect. There are limits on connections (with too many, the oldest that has not become
a page is closed, so that silent ones do not block others), on data that waits for a client that does not read, on the
parts of a message, and on the messages of all pages in an interval, so that time remains for samples. Data that the
libraries below do not expect ends only the client's own connection.
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
"""Most connections that are not, or not yet, a WebSocket; a browser opens at most six."""
MOST_PAGES = 64
"""Most WebSockets. It is above `MOST_VIEWERS`, so that further pages receive the reason of their refusal."""
LARGEST_MESSAGE = 4096
"""Largest message of a page, in bytes."""
MOST_PARTS = 64
"""Most parts of a message; browsers send one."""
INTERVAL = 1 / 60
"""Seconds over which messages are counted: one frame of a screen, a delay that is not visible."""
MOST_FRAMES = 32
"""Most messages, parts of messages and pings of all pages that are processed in an interval; twenty sliders that move
at once send fewer. Each takes about 50 µs."""
_PART = 64
"""Number of bytes processed at a time, so that they contain few messages."""
_BACKLOG = 64
_INVALID_DATA = 1007
Conversation = TypeVar("Conversation", "HttpConversation", "PageConversation")


class HttpConversation(H11Protocol):
    """A connection that requests files, or becomes a page."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Accept the connection, and close the oldest one if there are too many."""
        super().connection_made(transport)
        self.began = self.loop.time()
        strangers = _open(HttpConversation, self.connections)
        if len(strangers) > MOST_STRANGERS:
            min(strangers, key=lambda other: other.began).transport.abort()

    def data_received(self, data: bytes) -> None:
        """Process received data."""
        with _ending(self):
            super().data_received(data)

    def shutdown(self) -> None:
        """Close the connection, even if the client does not read its answer."""
        super().shutdown()
        self.transport.abort()


class PageConversation(WebSocketsSansIOProtocol):
    """A WebSocket of a page, or of another program."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Accept the connection, unless there are too many."""
        self.unprocessed = bytearray()
        """Received bytes that have not been processed yet."""
        self._budget = 0
        self._interval: asyncio.TimerHandle | None = None
        super().connection_made(transport)
        if len(_open(PageConversation, self.connections)) > MOST_PAGES:
            self.transport.abort()

    def data_received(self, data: bytes) -> None:
        """Process received data, as far as the limit allows."""
        self.unprocessed += data
        if self._interval is None:
            self._begin_interval()
        self._process()

    def handle_events(self) -> None:
        """Count the parsed events, and process them."""
        self._budget -= len(self.conn.events)
        super().handle_events()

    async def receive(self) -> Any:
        """Wait for a message. The library then reads on, so pause it if there are unprocessed bytes."""
        message = await super().receive()
        if self.unprocessed:
            self.transport.pause_reading()
        return message

    async def send(self, message: Any) -> None:
        """Send a message. Raise if the connection is closing, because asyncio would log a warning for each message."""
        await self.writable.wait()
        if self.transport.is_closing():
            raise ClientDisconnected
        await super().send(message)

    def handle_ping(self) -> None:
        """Answer a ping, or close a connection that does not read the answers."""
        if self.transport.is_closing():
            # Further pings may have arrived together with this one; asyncio would log a warning for each answer.
            return
        if self.writable.is_set():
            super().handle_ping()
        else:
            self.transport.abort()

    def handle_cont(self, event: Frame) -> None:
        """Process a part of a message."""
        if len(self.frames) < MOST_PARTS:
            super().handle_cont(event)
        else:
            self.transport.abort()

    def send_receive_event_to_app(self) -> None:
        """Pass a message on."""
        if self.curr_msg_data_type == "text":
            try:
                b"".join(self.frames).decode()
            except UnicodeDecodeError:
                self.conn.fail(_INVALID_DATA)
                self.handle_parser_exception()
                return
        super().send_receive_event_to_app()

    def keepalive_timeout(self) -> None:
        """Close a page that has neither read nor sent anything for long, so that another page can connect."""
        super().keepalive_timeout()
        self.transport.abort()

    def shutdown(self) -> None:
        """Close the connection, even if the page does not read."""
        super().shutdown()
        if not self.writable.is_set():
            self.transport.abort()

    def _begin_interval(self) -> None:
        senders = sum(bool(page.unprocessed) for page in _open(PageConversation, self.connections))
        # Deduct the messages beyond this page's share in the last interval.
        self._budget = min(self._budget, 0) + max(1, MOST_FRAMES // max(1, senders))
        self._interval = self.loop.call_later(INTERVAL, self._end_interval)

    def _end_interval(self) -> None:
        self._interval = None
        if self.unprocessed and not self.transport.is_closing():
            self._begin_interval()
            self._process()

    def _process(self) -> None:
        """Process received bytes up to this page's share of the interval. Pause reading while some remain."""
        with _ending(self):
            while self.unprocessed and self._budget > 0 and not self.transport.is_closing():
                part = bytes(self.unprocessed[:_PART])
                del self.unprocessed[:_PART]
                super().data_received(part)
        if self.unprocessed:
            self.transport.pause_reading()
        elif not self.read_paused:
            self.transport.resume_reading()


def _open(kind: type[Conversation], connections: Iterable[object]) -> list[Conversation]:
    """Return the connections of a type that are not closing."""
    return [other for other in connections if isinstance(other, kind) and not other.transport.is_closing()]


@contextlib.contextmanager
def _ending(conversation: HttpConversation | PageConversation) -> Iterator[None]:
    try:
        yield
    except Exception:  # noqa: BLE001  (bad data must only end this client's connection)
        conversation.transport.abort()


class PageServer(uvicorn.Server):
    """A server in a program that handles signals of the operating system itself."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Install no signal handlers."""
        yield


def make_server(app: ASGIApp) -> PageServer:
    """Return a server for an application."""
    config = uvicorn.Config(
        app,
        log_config=None,
        # Do not log errors of clients on the terminal.
        log_level="error",
        access_log=False,
        lifespan="off",
        server_header=False,
        http=HttpConversation,
        ws=PageConversation,
        ws_max_size=LARGEST_MESSAGE,
        # Within one machine, compression would cost more than it saves.
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
        backlog=_BACKLOG,
    )
    # Import uvicorn's modules now: this takes long, and would lose samples later.
    config.load()
    return PageServer(config)
