"""Access to a server with a token, however many unauthenticated clients are connected."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from typing import TYPE_CHECKING

import pytest

import unity_link
from support import pipe
from support.sharing import Terminal, sharing
from support.simulated_time import on_simulated_time
from unity_link.bridges.serve import serve
from unity_link.bridges.serve.door import (
    HURRY,
    KEEP_ALIVE,
    MOST_CLIENTS,
    MOST_STRANGERS,
    Door,
    enable_keep_alive,
)
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

TOKEN = "open-sesame"


def knock(shared: SharedLink, said: bytes = b"") -> Terminal:
    terminal = Terminal()
    pipe.connect(terminal, Door(shared, TOKEN))
    terminal.transport.write(said)
    return terminal


async def is_served(terminal: Terminal) -> bool:
    terminal.transport.write(b"H\r")
    await asyncio.sleep(0.01)
    return terminal.take() == b"H\r\n"


@pytest.mark.parametrize("strangers", [MOST_CLIENTS, MOST_STRANGERS, 3 * MOST_STRANGERS])
@on_simulated_time
async def test_silent_unauthenticated_clients_keep_no_client_with_the_token_out(strangers: int) -> None:
    async with sharing(VirtualGateway()) as shared:
        silent = [knock(shared) for _ in range(strangers)]
        for _ in range(20):
            silent += [knock(shared) for _ in range(10)]
            assert await is_served(knock(shared, f"token {TOKEN}\n".encode()))
        assert len(shared.clients) == 20
        assert len(shared.strangers) <= MOST_STRANGERS
        # The server has closed the oldest connections.
        left = [terminal for terminal in silent if not terminal.gone]
        assert left == silent[-len(left) :]
        await asyncio.sleep(HURRY + 0.1)
        assert not shared.strangers
        assert all(terminal.gone for terminal in silent)


@on_simulated_time
async def test_only_clients_count_towards_the_limit_of_clients() -> None:
    async with sharing(VirtualGateway()) as shared:
        inside = [knock(shared, f"token {TOKEN}\n".encode()) for _ in range(MOST_CLIENTS)]
        await asyncio.sleep(0.01)
        late = knock(shared, f"token {TOKEN}\n".encode())
        await asyncio.sleep(0.01)
        assert late.gone
        inside[0].transport.abort()
        await asyncio.sleep(0.01)
        assert await is_served(knock(shared, f"token {TOKEN}\n".encode()))


@pytest.mark.asyncio
async def test_links_open_by_token_beside_256_unauthenticated_connections() -> None:
    async with serve("sim:", tcp=0, token=TOKEN) as server, contextlib.AsyncExitStack() as stack:
        host, port = server.urls[0].removeprefix("tcp://").split(":")
        for _ in range(256):
            _, writer = await asyncio.open_connection(host, int(port))
            stack.callback(writer.close)
        for _ in range(5):
            async with unity_link.connect(f"{server.urls[0]}?token={TOKEN}", timeout=60) as link:
                assert await link.read(0) == 0


@pytest.mark.parametrize("names", [set(KEEP_ALIVE), {"TCP_KEEPALIVE", "TCP_KEEPINTVL", "TCP_KEEPCNT"}, set()])
@pytest.mark.skipif(not hasattr(socket, "TCP_USER_TIMEOUT"), reason="has not all options")
def test_the_system_finds_machines_that_have_gone_by_the_options_that_it_has(
    names: set[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(socket, "TCP_KEEPALIVE", socket.TCP_KEEPIDLE, raising=False)
    numbers = {name: getattr(socket, name) for name in KEEP_ALIVE}
    for name in set(KEEP_ALIVE) - names:
        monkeypatch.delattr(socket, name)
    with socket.socket() as connection, socket.socket() as untouched:
        enable_keep_alive(connection)
        assert connection.getsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE)
        for name, number in numbers.items():
            default = untouched.getsockopt(socket.IPPROTO_TCP, number)
            is_set = any(numbers[other] == number for other in names)
            assert connection.getsockopt(socket.IPPROTO_TCP, number) == (KEEP_ALIVE[name] if is_set else default)
