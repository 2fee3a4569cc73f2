"""The pace at which messages of pages are handled: enough for people, and slow enough to leave time for samples."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from uvicorn.server import ServerState

from support.live_page import handshake
from support.simulated_time import on_simulated_time
from unity_link.bridges.live.server import INTERVAL, MOST_FRAMES, PageConversation, make_server

if TYPE_CHECKING:
    from starlette.types import Receive, Scope, Send

PING = b"\x89\x80" + bytes(4)


def message(text: str) -> bytes:
    """Return a message as browsers send it; the mask of zeros leaves the text unchanged."""
    return bytes([0x81, 0x80 | len(text)]) + bytes(4) + text.encode()


class Line(asyncio.Transport):
    """A connection with the test at its other end."""

    def __init__(self) -> None:
        super().__init__()
        self.written = bytearray()
        self._reads = True
        self._closing = False

    def write(self, data: Any) -> None:
        self.written += data

    def pause_reading(self) -> None:
        self._reads = False

    def resume_reading(self) -> None:
        self._reads = True

    def is_reading(self) -> bool:
        return self._reads

    def is_closing(self) -> bool:
        return self._closing

    def close(self) -> None:
        self._closing = True

    abort = close


class Talk:
    """Pages of one server, with the messages that it has handled and their times."""

    def __init__(self, pages: int) -> None:
        now = asyncio.get_running_loop().time
        self.heard: list[list[tuple[float, str]]] = []
        self.lines: list[Line] = []
        self.pages: list[PageConversation] = []

        async def listen(_: Scope, receive: Receive, send: Send) -> None:
            heard: list[tuple[float, str]] = []
            self.heard.append(heard)
            await receive()
            await send({"type": "websocket.accept"})
            while (event := await receive())["type"] == "websocket.receive":
                heard.append((now(), event["text"]))

        config, state = make_server(listen).config, ServerState()
        for _ in range(pages):
            page, line = PageConversation(config, state, {}), Line()
            page.connection_made(line)
            page.data_received(handshake("localhost"))
            self.lines.append(line)
            self.pages.append(page)

    async def begin(self) -> None:
        """Wait until the handshakes, and the interval in which they were made, have passed."""
        await asyncio.sleep(2 * INTERVAL)


@on_simulated_time
async def test_messages_of_a_flooding_page_are_all_handled_at_a_bounded_pace() -> None:
    talk = Talk(1)
    await talk.begin()
    said = [str(number) for number in range(20 * MOST_FRAMES)]
    talk.pages[0].data_received(b"".join(map(message, said)))
    await asyncio.sleep(10 * INTERVAL)
    assert len(talk.heard[0]) < 15 * MOST_FRAMES
    assert not talk.lines[0].is_reading()
    await asyncio.sleep(15 * INTERVAL)
    assert [text for _, text in talk.heard[0]] == said
    assert talk.lines[0].is_reading()


@on_simulated_time
async def test_paused_page_is_not_read_again_when_its_messages_are_handled() -> None:
    talk = Talk(1)
    await talk.begin()
    for _ in range(3):
        talk.pages[0].data_received(message("a") * 2 * MOST_FRAMES)
        await asyncio.sleep(0)
        assert not talk.lines[0].is_reading()


@on_simulated_time
async def test_small_pieces_are_handled_at_the_pace_of_large_ones() -> None:
    talk = Talk(1)
    await talk.begin()
    for _ in range(20 * MOST_FRAMES):
        talk.pages[0].data_received(message("a"))
    await asyncio.sleep(10 * INTERVAL)
    assert len(talk.heard[0]) < 15 * MOST_FRAMES


@on_simulated_time
async def test_page_is_heard_at_once_beside_flooding_pages_within_the_total_pace() -> None:
    talk = Talk(6)
    await talk.begin()
    for page in talk.pages[1:]:
        page.data_received(message("flood") * 4000)
    before = asyncio.get_running_loop().time()
    for number in range(60):
        talk.pages[0].data_received(message(f"{before + number * INTERVAL:.6f}"))
        await asyncio.sleep(INTERVAL)
    assert len(talk.heard[0]) == 60
    assert all(at - float(text) < INTERVAL / 2 for at, text in talk.heard[0])
    for heard in talk.heard[1:]:
        assert len(heard) > 60
    assert sum(map(len, talk.heard)) < 65 * MOST_FRAMES


@on_simulated_time
async def test_pings_count_as_messages_do() -> None:
    talk = Talk(1)
    await talk.begin()
    before = len(talk.lines[0].written)
    talk.pages[0].data_received(PING * 20 * MOST_FRAMES)
    await asyncio.sleep(10 * INTERVAL)
    assert 5 * MOST_FRAMES < (len(talk.lines[0].written) - before) // 2 < 15 * MOST_FRAMES


@on_simulated_time
async def test_messages_of_a_closed_page_are_dropped() -> None:
    talk = Talk(1)
    await talk.begin()
    talk.pages[0].data_received(message("a") * 20 * MOST_FRAMES)
    talk.lines[0].close()
    talk.pages[0].connection_lost(None)
    await asyncio.sleep(100 * INTERVAL)
    assert len(talk.heard[0]) < 2 * MOST_FRAMES
