"""One port of the system that all links of a program share, in whatever thread or event loop they run."""

from __future__ import annotations

import asyncio
import functools
import socket
import threading
from contextlib import AsyncExitStack, ExitStack, asynccontextmanager, contextmanager
from typing import TYPE_CHECKING, Any, ParamSpec

import pytest
import trio

import unity_link
from unity_link import ArgumentError, ConnectError, LinkLostError, blocking
from unity_link.transport import open_channel, parse_url, serial, shared_port
from unity_link.transport.channel import SocketChannel
from unity_link.transport.shared_port import SharedChannel, SharedPort
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_pty, serve_tcp
from unity_link.virtual.shared_line import SharedLine, build_shared_line

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
    from contextlib import AbstractAsyncContextManager
    from pathlib import Path

    from unity_link.transport import DriverUrl
    from unity_link.transport.channel import Channel

P = ParamSpec("P")
NODES = (1, 2, 3, 4)
BAUD = 2_000_000


def in_a_loop(test: Callable[P, Coroutine[Any, Any, None]]) -> Callable[P, None]:
    """Run an asynchronous test."""

    @functools.wraps(test)
    def run(*args: P.args, **kwargs: P.kwargs) -> None:
        asyncio.run(test(*args, **kwargs))

    return run


@pytest.fixture(params=[serve_pty, serve_tcp], ids=["pty", "tcp"])
def served(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[SharedLine, str]]:
    """Serve a line of four nodes from a thread; assert that no request was sent while an answer was pending."""
    # Wait longer than for a board: the thread that answers may be delayed on a busy machine.
    for name in ("session.ANSWER_PATIENCE", "session._UNKNOWN_PATIENCE", "handshake.FIRST_TRY"):
        monkeypatch.setattr(f"unity_link.protocol.host.{name}", 10.0)
    with serving(request.param) as (line, url):
        yield line, url
    assert line.collisions == []
    assert not shared_port._PORTS


@contextmanager
def serving(way: Callable[[SharedLine], AbstractAsyncContextManager[str]]) -> Iterator[tuple[SharedLine, str]]:
    line = build_shared_line(NODES, BAUD)
    urls: list[str] = []
    ready, over = threading.Event(), asyncio.Event()
    loop = asyncio.new_event_loop()

    async def serve() -> None:
        async with way(line) as url:
            urls.append(url)
            ready.set()
            await over.wait()

    def run() -> None:
        with asyncio.Runner(loop_factory=lambda: loop) as runner:
            runner.run(serve())

    thread = threading.Thread(target=run)
    thread.start()
    ready.wait()
    try:
        yield line, f"{urls[0]}?baud={BAUD}&node=" if way is serve_pty else f"{urls[0]}?node="
    finally:
        loop.call_soon_threadsafe(over.set)
        thread.join()


@asynccontextmanager
async def all_nodes(url: str) -> AsyncIterator[list[unity_link.Link]]:
    async with AsyncExitStack() as stack:
        yield [await stack.enter_async_context(unity_link.connect(f"{url}{node}")) for node in NODES]


def test_links_share_a_port_in_one_event_loop(served: tuple[SharedLine, str]) -> None:
    asyncio.run(_in_one_event_loop(served[1]))


async def _in_one_event_loop(url: str) -> None:
    async with all_nodes(url) as links:
        await asyncio.gather(*[link.write(number, number) for number, link in enumerate(links) for _ in range(20)])
        words = await asyncio.gather(*[link.read_many([number] * 30) for number, link in enumerate(links)])
        assert [set(some) for some in words] == [{0}, {1}, {2}, {3}]


def test_links_share_a_port_in_blocking_code_of_one_or_more_threads(served: tuple[SharedLine, str]) -> None:
    with ExitStack() as stack:
        links = [stack.enter_context(blocking.connect(f"{served[1]}{node}")) for node in NODES]
        for _ in range(10):
            for number, link in enumerate(links):
                link.write(1, number)
        assert [link.read(1) for link in links] == [0, 1, 2, 3]

        def count(link: blocking.BlockingLink) -> None:
            for value in range(50):
                link.write(2, value)
                assert link.read(2) == value

        threads = [threading.Thread(target=count, args=[link]) for link in links]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert [link.read(2) for link in links] == [49] * 4


def test_links_share_a_port_under_trio_and_in_blocking_code_at_once(served: tuple[SharedLine, str]) -> None:
    async def main() -> None:
        async with unity_link.connect(served[1] + "1") as link:
            for value in range(50):
                await link.write(1, value)
                assert await link.read(1) == value

    with blocking.connect(served[1] + "2") as link:
        thread = threading.Thread(target=trio.run, args=[main])
        thread.start()
        for value in range(50):
            link.write(1, value)
            assert link.read(1) == value
        thread.join()


def test_an_idle_blocking_link_does_not_delay_the_others() -> None:
    with (
        serving(serve_pty) as (line, url),
        blocking.connect(url + "1") as link,
        blocking.connect(url + "2") as other,
    ):
        line.gone.add(1)
        with pytest.raises(TimeoutError):
            link._call(_impatient, link._link)
        line.gone.discard(1)
        assert [other.read(0) for _ in range(20)] == [0] * 20
        assert link.read(0) == 0


async def _impatient(link: unity_link.Link) -> None:
    async with link._runtime.timeout(0.02):
        await link.read(0)


@in_a_loop
async def test_sharing_a_port_with_other_settings_is_refused() -> None:
    line = build_shared_line(NODES)
    async with serve_pty(line) as url, unity_link.connect(f"{url}?node=1"):
        async with unity_link.connect(f"{url}?node=2&baud=115200&rtscts=0"):
            pass
        with pytest.raises(ArgumentError, match=r"node=2&baud=9600: this program has opened the port as .*node=1"):
            await unity_link.connect(f"{url}?node=2&baud=9600").__aenter__()
        with pytest.raises(ConnectError, match=r"has a link to node 1 of .* already"):
            await unity_link.connect(f"{url}?node=1").__aenter__()
        with pytest.raises(ConnectError, match="in use"):
            await unity_link.connect(url).__aenter__()


@in_a_loop
async def test_a_single_full_duplex_node_has_a_full_window_in_flight() -> None:
    async with serve_pty(VirtualGateway(node=5)) as url, unity_link.connect(f"{url}?node=5") as link:
        for _ in range(5):
            writes = [asyncio.ensure_future(link.write(number % 256, number)) for number in range(500)]
            await asyncio.sleep(0)
            assert link.statistics.in_flight == 500
            await asyncio.gather(*writes)
            assert len(await link.read_many([1] * 500)) == 500
        async with link.subscribe([1], rate_hz=1000) as samples:
            for _ in range(20):
                await anext(samples)
            assert await link.read(0) == 256
        with pytest.raises(ConnectError, match="was not built half-duplex"):
            await unity_link.connect(f"{url}?node=6").__aenter__()


@in_a_loop
async def test_a_port_with_a_single_node_is_opened_again_after_a_loss() -> None:
    async with AsyncExitStack() as stack:
        async with serve_tcp(VirtualGateway(node=5)) as url:
            link = await stack.enter_async_context(unity_link.connect(f"{url}?node=5", reconnect=True))
        async with serve_tcp(VirtualGateway(node=5), int(url.rpartition(":")[2])), asyncio.timeout(10):
            assert await link.read(0) == 0
    assert not shared_port._PORTS


@pytest.mark.parametrize("lost", [False, True])
def test_a_link_waits_for_a_port_that_is_reopened_during_an_answer(lost: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared_port, "_OWED", {})
    with serving(serve_pty) as (_, url):
        first = open_shared_channel(url + "1")
        assert first.seat.ask()
        first.seat.begin(60.0)
        if lost:
            first.lose()
        first.close()
        second = open_shared_channel(url + "2")
        assert not second.seat.ask()
        assert 0 < second.seat.patience <= 60.0
        second.close()


def open_shared_channel(url: str) -> SharedChannel:
    channel = open_channel(parse_url(url), None)
    assert isinstance(channel, SharedChannel)
    return channel


@in_a_loop
async def test_a_lost_port_is_lost_to_all_links_and_opened_again(tmp_path: Path) -> None:
    path = tmp_path / "port"
    async with AsyncExitStack() as stack:
        async with serve_pty(build_shared_line(NODES), path):
            again = await stack.enter_async_context(unity_link.connect(f"serial:{path}?node=1", reconnect=True))
            once = await stack.enter_async_context(unity_link.connect(f"serial:{path}?node=2"))
            # This link sends no request, so only the other link can report the loss to it.
        with pytest.raises(LinkLostError):
            await once.read(0)
        async with serve_pty(build_shared_line(NODES), path):
            assert await again.read(0) == 0
            async with unity_link.connect(f"serial:{path}?node=2") as new:
                assert await new.read(0) == 0
    assert not shared_port._PORTS


@in_a_loop
async def test_a_link_cancelled_while_its_port_is_opened_frees_its_node() -> None:
    entered, held = threading.Event(), threading.Event()
    opened = serial.open_channel

    def open_slowly(url: DriverUrl, timeout: float | None) -> Channel:
        entered.set()
        assert held.wait(10)
        return opened(url, timeout)

    async def use(url: str) -> int:
        async with unity_link.connect(url) as link:
            return await link.read(0)

    with serving(serve_pty) as (_, url), pytest.MonkeyPatch.context() as patch:
        patch.setattr(serial, "open_channel", open_slowly)
        given_up = asyncio.create_task(use(url + "1"))
        await asyncio.to_thread(entered.wait)
        given_up.cancel()
        with pytest.raises(asyncio.CancelledError):
            await given_up
        following = asyncio.create_task(use(url + "1"))
        await asyncio.sleep(0.01)
        held.set()
        assert await following == 0
    assert not shared_port._PORTS


def test_all_bytes_that_arrived_between_two_turns_are_dropped() -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    port = SharedPort(("a port",), parse_url("tcp://gateway:1?node=1"), {})
    port.channel = SocketChannel(ours)
    channel = SharedChannel(port, port.line.join(1))
    with theirs:
        for piece in (bytes(4_095), bytes(4_095), b"the rest"):
            theirs.send(piece)
        channel.drop_input()
        with pytest.raises(BlockingIOError):
            channel.read()
    channel.close()
