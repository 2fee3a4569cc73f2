"""A gateway that floods its host: the work in one turn of an event loop is bounded, and no answer is lost."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

import anyio
import anyio.lowlevel
import pytest
import trio
import uvloop

import unity_link
from unity_link import blocking
from unity_link.link.runtimes.calling_thread import CallingThread
from unity_link.protocol.host import session
from unity_link.protocol.host.handshake import Handshake
from unity_link.protocol.host.receiver import ResponseReceiver
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.frames import MOST_LINES
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_udp

if TYPE_CHECKING:
    from collections.abc import Iterator

FLOODS = {
    "empty lines": b"\n",
    "empty plain lines": b"\r\n",
    "errors": Codec(GatewayInfo()).framing.checked(b"X01"),
    "damaged lines": b"a\n",
}
LINES = 5_000


def _answer(listener: socket.socket, flood: bytes, *, before: bytes) -> None:
    """Answer one host as a gateway does; send a flood before the first answer to data that contains `before`."""
    gateway = VirtualGateway()
    gateway.memory[0x0A] = 42
    flooded = False
    # A host that closes the connection during the flood resets it.
    with contextlib.suppress(ConnectionError), listener, listener.accept()[0] as connection:
        while data := connection.recv(65_536):
            if before in data and not flooded:
                flooded = True
                connection.sendall(flood)
            connection.sendall(gateway.receive(data, time.monotonic()))


@contextmanager
def flooding(flood: bytes, before: bytes = b"r") -> Iterator[str]:
    listener = socket.create_server(("127.0.0.1", 0))
    url = f"tcp://127.0.0.1:{listener.getsockname()[1]}"
    thread = threading.Thread(target=_answer, args=(listener, flood), kwargs={"before": before})
    thread.start()
    try:
        yield url
    finally:
        thread.join()


class Turns:
    """Counts the lines that are decoded one by one, and the largest number of them in one turn."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.lines = self.before = self.most = 0
        # On a busy machine the flood takes long to arrive.
        monkeypatch.setattr(session, "FLOOD_PATIENCE", 60.0)
        for kind, name in ((ResponseReceiver, "_receive_next"), (Handshake, "_receive_line")):
            self._count(monkeypatch, kind, name)

    def _count(self, monkeypatch: pytest.MonkeyPatch, kind: type, name: str) -> None:
        method = getattr(kind, name)

        def counted(*arguments: object) -> object:
            self.lines += 1
            return method(*arguments)

        monkeypatch.setattr(kind, name, counted)

    def end(self) -> None:
        self.most = max(self.most, self.lines - self.before)
        self.before = self.lines

    async def watch(self) -> None:
        while True:
            await anyio.lowlevel.checkpoint()
            self.end()


async def read(url: str, turns: Turns) -> None:
    async with anyio.create_task_group() as tasks:
        tasks.start_soon(turns.watch)
        async with unity_link.connect(url, timeout=60) as link:
            assert await link.read(0x0A) == 42
        tasks.cancel_scope.cancel()


def read_blocking(url: str | VirtualGateway, turns: Turns, monkeypatch: pytest.MonkeyPatch) -> None:
    poll = CallingThread._poll_once

    def count_and_poll(calling: CallingThread, *, may_spin: bool) -> None:
        turns.end()
        poll(calling, may_spin=may_spin)

    monkeypatch.setattr(CallingThread, "_poll_once", count_and_poll)
    with blocking.connect(url, timeout=60) as link:
        assert link.read(0x0A) == 42
    turns.end()


@pytest.mark.parametrize("face", ["asyncio", "uvloop", "trio", "blocking"])
@pytest.mark.parametrize("kind", FLOODS)
def test_a_flood_is_processed_in_small_shares_and_answers_are_received(
    kind: str, face: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    turns = Turns(monkeypatch)
    with flooding(FLOODS[kind] * LINES) as url:
        if face == "trio":
            trio.run(read, url, turns)
        elif face == "blocking":
            read_blocking(url, turns, monkeypatch)
        else:
            loops = {"asyncio": asyncio.new_event_loop, "uvloop": uvloop.new_event_loop}
            with asyncio.Runner(loop_factory=loops[face]) as runner:
                runner.run(read(url, turns))
    assert turns.lines > LINES // 2
    # Newly arrived and deferred lines can use one share each, and trio runs its tasks in any order.
    assert turns.most <= 4 * MOST_LINES


class FloodingGateway(VirtualGateway):
    """Sends a flood before its first answer to a read."""

    def __init__(self) -> None:
        super().__init__()
        self.memory[0x0A] = 42
        self.flood = b"\r\n" * LINES

    def receive(self, data: bytes, now: float) -> bytes:
        answered = super().receive(data, now)
        if b"r" not in data:
            return answered
        flood, self.flood = self.flood, b""
        return flood + answered


def test_datagrams_full_of_lines_are_processed_in_small_shares(monkeypatch: pytest.MonkeyPatch) -> None:
    async def serve_and_read() -> None:
        async with serve_udp(FloodingGateway()) as url:
            await read(url, turns)

    turns = Turns(monkeypatch)
    asyncio.run(serve_and_read())
    assert turns.lines > LINES // 2
    assert turns.most <= 4 * MOST_LINES


def test_a_flood_from_a_medium_in_a_thread_is_processed_in_small_shares(monkeypatch: pytest.MonkeyPatch) -> None:
    turns = Turns(monkeypatch)
    read_blocking(FloodingGateway(), turns, monkeypatch)
    assert turns.lines > LINES // 2
    assert turns.most <= 4 * MOST_LINES


def test_a_flood_before_a_session_is_processed_in_small_shares(monkeypatch: pytest.MonkeyPatch) -> None:
    turns = Turns(monkeypatch)
    with flooding(b"a\n" * LINES, before=b"Q") as url:
        asyncio.run(read(url, turns))
    assert turns.lines > LINES
    assert turns.most <= 2 * MOST_LINES


def test_answers_before_the_end_of_a_connection_are_received() -> None:
    """A flood precedes the answer, and the connection ends right after the answer."""

    def answer(listener: socket.socket) -> None:
        gateway = VirtualGateway()
        gateway.memory[0x0A] = 42
        with listener, listener.accept()[0] as connection:
            while data := connection.recv(65_536):
                answered = gateway.receive(data, 0.0)
                if b"r" in data:
                    connection.sendall(b"\r\n" * 10 * MOST_LINES + answered)
                    return
                connection.sendall(answered)

    async def read_last(url: str) -> None:
        async with unity_link.connect(url) as link:
            assert await link.read(0x0A) == 42

    listener = socket.create_server(("127.0.0.1", 0))
    thread = threading.Thread(target=answer, args=(listener,))
    thread.start()
    asyncio.run(read_last(f"tcp://127.0.0.1:{listener.getsockname()[1]}"))
    thread.join()
