"""Two programs open one line of the operating system, unaware of each other, while requests are in flight.

On TCP both receive all frames of the gateway, as behind a device server that accepts several clients. On a terminal
each byte is read by one of the two programs.
"""

from __future__ import annotations

import asyncio
import contextlib
import multiprocessing
import random
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.recorded_bus import RecordedBus
from support.searching import seeds
from support.second_program import ADDRESSES, WORDS, Program, run_alone
from unity_link import LinkLostError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_pty
from unity_link.virtual.transport import GatewayTransport

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator
    from contextlib import AbstractAsyncContextManager

    Line = Callable[[VirtualGateway], AbstractAsyncContextManager[str]]

LONGEST_RUN = 60.0


class SharedServer(asyncio.Protocol):
    """Passes the output of the gateway to all its clients."""

    def __init__(self, gateway: VirtualGateway) -> None:
        self.clients: list[asyncio.Transport] = []
        self.gateway = GatewayTransport(gateway, self, at_once=True)

    def data_received(self, data: bytes) -> None:
        for client in self.clients:
            client.write(data)

    def make_client(self) -> asyncio.Protocol:
        return _Client(self)


class _Client(asyncio.Protocol):
    def __init__(self, server: SharedServer) -> None:
        self._server = server
        self._transport: asyncio.Transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        self._server.clients.append(transport)

    def data_received(self, data: bytes) -> None:
        self._server.gateway.write(data)

    def connection_lost(self, exc: Exception | None) -> None:
        self._server.clients.remove(self._transport)


@contextlib.asynccontextmanager
async def on_tcp(gateway: VirtualGateway) -> AsyncIterator[str]:
    shared = SharedServer(gateway)
    server = await asyncio.get_running_loop().create_server(shared.make_client, "127.0.0.1", 0)
    async with server:
        yield f"tcp://127.0.0.1:{server.sockets[0].getsockname()[1]}"
        shared.gateway.abort()


@pytest.fixture(scope="module")
def process() -> Iterator[ProcessPoolExecutor]:
    """Return another process, in which the second programs run."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as process:
        yield process


def check(bus: RecordedBus, half: int, asked: list[int], acknowledged: set[int]) -> None:
    """Compare the writes of a program with those that the bus executed."""
    executed = [word for address, word in bus.writes if address == ADDRESSES[half]]
    assert executed == sorted(set(executed))
    assert acknowledged <= set(executed) <= set(asked)


async def ask_until_it_is_lost(program: Program, draw: random.Random) -> None:
    while True:
        await program.ask_side_by_side()
        await asyncio.sleep(0.01 * draw.random())


async def two_programs(line: Line, process: ProcessPoolExecutor, seed: int) -> None:
    draw = random.Random(seed)
    features = GatewayInfo().features | (Feature.COMPACT if seed % 2 else Feature(0))
    bus = RecordedBus(gateway := VirtualGateway(GatewayInfo(features=features, base_frequency_millihertz=1_000_000)))
    bus.words.update(WORDS)
    async with line(gateway) as url, asyncio.timeout(LONGEST_RUN):
        first = Program(await unity_link.connect(url), 0, draw)
        samples = asyncio.create_task(first.subscribe())
        for _ in range(draw.randint(1, 5)):
            await first.ask_side_by_side()
        second = asyncio.get_running_loop().run_in_executor(process, run_alone, url, seed)
        for lost in (ask_until_it_is_lost(first, draw), samples):
            with pytest.raises(LinkLostError, match="another program"):
                await lost
        # Closing raises the errors of posted writes, if any were in flight.
        with contextlib.suppress(LinkLostError):
            await first.link.aclose()
        check(bus, 1, *await second)
    check(bus, 0, first.asked, first.acknowledged)


@pytest.mark.parametrize("seed", seeds(5, 100))
@pytest.mark.parametrize("line", [on_tcp, serve_pty], ids=["tcp", "pty"])
def test_a_second_program_ends_the_first_without_losing_a_write(
    line: Line, process: ProcessPoolExecutor, seed: int
) -> None:
    asyncio.run(two_programs(line, process, seed))
