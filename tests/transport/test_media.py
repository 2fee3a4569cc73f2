"""Links over the media of the operating system to a gateway in another process, which may be killed."""

from __future__ import annotations

import asyncio
import contextlib
import math
import os
import pty
import signal
import socket
import subprocess
import sys
import tty
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

import unity_link
from unity_link import ArgumentError, ConnectError, LinkLostError, blocking
from unity_link.protocol.window.constants import QUICK_TIMEOUT
from unity_link.transport import load_driver, parse_url
from unity_link.transport.serial import _transport_class
from unity_link.transport.stream import Stream
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_unix

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

SERVER = Path(__file__).with_name("serve.py")
PORTS = ["serial", "pyserial-asyncio"]
"""Serial ports, opened by the default library and by the alternative one."""
STREAMS = [*PORTS, "tcp", "unix"]
MEDIA = [*STREAMS, "udp"]


@pytest.fixture
def serve(tmp_path: Path) -> Iterator[Callable[..., tuple[str, subprocess.Popen[str]]]]:
    """Yield a function that starts a gateway in a process of its own and returns its URL and process."""
    with contextlib.ExitStack() as stack:

        def start(medium: str, loss: float = 0.0) -> tuple[str, subprocess.Popen[str]]:
            served = "serial" if medium in PORTS else medium
            command = [sys.executable, str(SERVER), served, str(tmp_path / "gateway"), str(loss)]
            process = stack.enter_context(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
            stack.callback(process.kill)
            assert process.stdout is not None
            return by_library(process.stdout.readline().strip(), medium), process

        yield start


def by_library(url: str, medium: str) -> str:
    """Return the URL of a port with the library of one of `PORTS`, any other URL unchanged."""
    return f"{url}?library={medium}" if medium in PORTS[1:] else url


async def hold(url: str) -> None:
    async with unity_link.connect(url):
        await asyncio.Event().wait()


@pytest.mark.asyncio
@pytest.mark.parametrize("turns", range(12))
@pytest.mark.parametrize("library", PORTS)
async def test_a_port_is_free_after_a_cancelled_connection(library: str, turns: int) -> None:
    async with serve_pty(VirtualGateway()) as served:
        url = by_library(served, library)
        opening = asyncio.create_task(hold(url))
        for _ in range(turns):
            await asyncio.sleep(0)
        opening.cancel()
        with pytest.raises(asyncio.CancelledError):
            await opening
        async with unity_link.connect(url) as link:
            assert await link.read(0) == 0


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", MEDIA)
async def test_a_link_works_over_every_medium(serve: Callable[..., tuple[str, object]], medium: str) -> None:
    url, _ = serve(medium)
    async with unity_link.connect(url) as link:
        await link.write(0x0A, 42)
        assert await link.read(0x0A) == 42
        values = np.arange(256)
        await link.write_block(0, values)
        assert (await link.read_block(0, 256)).tolist() == values.tolist()
        many = np.arange(20_000) % 256
        assert (await link.read_many(many)).tolist() == many.tolist()
        assert await asyncio.gather(*(link.read(address) for address in range(200))) == list(range(200))
        async with link.subscribe([1, 2], rate_hz=1000) as samples:
            for _ in range(20):
                assert (await anext(samples)).values.tolist() == [1, 2]


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", MEDIA)
async def test_a_link_makes_up_for_lost_bytes_over_every_medium(
    serve: Callable[..., tuple[str, object]], medium: str
) -> None:
    url, _ = serve(medium, 0.001)
    async with unity_link.connect(url, timeout=60) as link:
        for start in range(0, 2000, 100):
            await link.write_many(np.arange(100), np.arange(100) + start)
        assert (await link.read_many(np.arange(100))).tolist() == list(range(1900, 2000))
        assert link.statistics.repetitions > 0


@pytest.mark.slow
@pytest.mark.asyncio
@pytest.mark.parametrize("medium", MEDIA)
async def test_a_killed_gateway_raises_in_every_waiting_call(
    serve: Callable[..., tuple[str, subprocess.Popen[str]]], medium: str
) -> None:
    url, process = serve(medium)
    async with unity_link.connect(url) as link, link.subscribe([0], rate_hz=1000) as samples:
        await anext(samples)
        process.send_signal(signal.SIGSTOP)
        calls = [
            link.read(0),
            link.write(0, 1),
            link.read_many(range(256)),
            link.write_block(0, range(256)),
            link.fence(),
        ]
        waiting = [asyncio.ensure_future(call) for call in calls]
        await asyncio.sleep(0)
        process.kill()
        errors = await asyncio.gather(*waiting, return_exceptions=True)
        assert [type(error) for error in errors] == [LinkLostError] * len(calls)
        with pytest.raises(LinkLostError):
            await read_all(samples)
        with pytest.raises(LinkLostError):
            await link.read(0)


async def read_all(samples: unity_link.Subscription) -> None:
    async for _ in samples:
        pass


def serving(medium: str, gateway: VirtualGateway, folder: Path) -> contextlib.AbstractAsyncContextManager[str]:
    """Serve a gateway in this process."""
    if medium in PORTS:
        return serve_pty(gateway)
    return serve_tcp(gateway) if medium == "tcp" else serve_unix(gateway, folder / "gateway")


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", STREAMS)
async def test_a_link_may_be_opened_again_after_it_was_closed(medium: str, tmp_path: Path) -> None:
    gateway = VirtualGateway()
    async with serving(medium, gateway, tmp_path) as served:
        url = by_library(served, medium)
        for value in range(5):
            async with unity_link.connect(url) as link:
                assert await link.read(1) == value
                await link.write(1, value + 1)


# Media that cannot be opened


@pytest.mark.asyncio
@pytest.mark.parametrize("library", PORTS)
async def test_a_port_in_use_causes_one_clear_error(library: str) -> None:
    async with serve_pty(VirtualGateway()) as served, unity_link.connect(served) as link:
        url = by_library(served, library)
        with pytest.raises(ConnectError, match="in use by another program"):
            await unity_link.connect(url)
        assert await link.read(0) == 0


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("url", "message"),
    [
        ("serial:/dev/ttyNOWHERE", "there is no port /dev/ttyNOWHERE; is the adapter plugged in"),
        ("serial:/dev/null", "no usable serial port"),
        ("unix:/nowhere/at/all", "no connection to the socket /nowhere/at/all .*is it served"),
        ("tcp://127.0.0.1:1", "no connection to port 1 of 127.0.0.1 .*is it listening"),
        ("tcp://nowhere.invalid:7001", "no connection to port 7001 of nowhere.invalid"),
        ("udp://nowhere.invalid:7001", "no socket for port 7001 of nowhere.invalid"),
        ("tcp://a..b:7001", "no connection to port 7001 of a..b .that is not a host name.; is the name right"),
        ("udp://.local:7001", "no socket for port 7001 of .local .that is not a host name.; is the name right"),
        ("mmio:/dev/zero?size=4096&offset=0x10000000000000000", "it cannot be mapped"),
    ],
)
async def test_a_missing_medium_causes_one_clear_error(url: str, message: str) -> None:
    with pytest.raises(ConnectError, match=message) as caught:
        await unity_link.connect(url)
    assert "\n" not in str(caught.value)
    assert url in str(caught.value)
    with pytest.raises(ConnectError, match=message):
        await asyncio.to_thread(blocking.connect, url)


@pytest.mark.asyncio
@pytest.mark.parametrize(
    "url",
    [
        "serial:",
        "serial:/dev/ttyUSB0?baud=fast",
        "serial:/dev/ttyUSB0?baud=0",
        "serial:/dev/ttyUSB0?baud=12000000000",
        "serial:/dev/ttyUSB0?rtscts=2",
        "serial:/dev/ttyUSB0?library=pyserial",
        "serial:/dev/ttyUSB0?parity=even",
        "tcp://host",
        "tcp:host:1",
        "tcp://host:port",
        "tcp://host:99999",
        "tcp://host:1?x",
        "unix:",
        "udp://:7001",
        "sim://host",
        "sim:?loss=much",
        "tcp://host\0:1",
        "mmio:/a\0b",
        "sim:?snoop=a\0b",
    ],
)
async def test_an_impossible_url_is_refused_before_a_port_is_opened(url: str) -> None:
    with pytest.raises(ArgumentError):
        await unity_link.connect(url)


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("url", "meant"), [("unix://tmp/x", "unix:/tmp/x"), ("serial://dev/ttyS9", "serial:/dev/ttyS9")]
)
async def test_a_url_with_a_path_in_place_of_a_host_is_corrected(url: str, meant: str) -> None:
    with pytest.raises(ArgumentError, match=f"did you mean {meant}\\?"):
        await unity_link.connect(url)


@pytest.mark.asyncio
@pytest.mark.parametrize("name", ["a#b", "a+b", "a&b"])
async def test_the_name_of_a_socket_may_have_any_character_but_a_question_mark(tmp_path: Path, name: str) -> None:
    async with serve_unix(VirtualGateway(), tmp_path / name) as url, unity_link.connect(url) as link:
        assert await link.read(0) == 0


def test_a_token_is_taken_literally() -> None:
    assert parse_url("tcp://robot:1?token=q1+Zb/8=&map=any").options == {"token": "q1+Zb/8=", "map": "any"}
    assert parse_url("tcp://robot:1?token=a#%2B%23").options == {"token": "a#+#"}


def test_the_longest_timeout_connects_in_blocking_code() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
    with pytest.raises(ConnectError, match="is it listening"):
        blocking.connect(f"tcp://127.0.0.1:{port}", timeout=1e9)


@pytest.mark.parametrize("timeout", [math.inf, math.nan, 1e12])
def test_a_timeout_that_is_no_number_of_seconds_is_refused(timeout: float) -> None:
    with pytest.raises(ArgumentError, match="timeout is a number of seconds above 0"):
        blocking.connect("tcp://127.0.0.1:1", timeout=timeout)


def test_every_scheme_has_a_driver_that_lists_its_options() -> None:
    for scheme in ["serial", "tcp", "unix", "udp", "sim"]:
        assert isinstance(load_driver(scheme).OPTIONS, frozenset)
        assert parse_url(f"{scheme}:x").scheme == scheme


@pytest.mark.asyncio
async def test_the_error_without_permission_names_the_group_to_join(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: str, *_: object, **__: object) -> int:
        raise PermissionError(13, "Permission denied", path)

    monkeypatch.setattr("serial.serialposix.os.open", refuse)
    with pytest.raises(ConnectError, match=r"no permission for .*dialout"):
        await unity_link.connect(f"serial:{tmp_path}")


@pytest.mark.asyncio
async def test_a_datagram_port_without_a_listener_is_reported_at_once() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as unused:
        unused.bind(("127.0.0.1", 0))
        port = unused.getsockname()[1]
    with pytest.raises(ConnectError, match="nothing listens at that port"):
        await unity_link.connect(f"udp://127.0.0.1:{port}", timeout=600)
    with pytest.raises(ConnectError, match="nothing listens at that port"):
        await asyncio.to_thread(blocking.connect, f"udp://127.0.0.1:{port}", timeout=600)


@pytest.mark.asyncio
async def test_the_error_for_a_silent_datagram_port_says_what_to_check() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.bind(("127.0.0.1", 0))
        port = silent.getsockname()[1]
        with pytest.raises(ConnectError, match="nothing arrived: check"):
            await unity_link.connect(f"udp://127.0.0.1:{port}", timeout=0.3)


@pytest.mark.asyncio
async def test_the_error_for_a_missing_library_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "serial_asyncio", None)
    _transport_class.cache_clear()
    with pytest.raises(ConnectError, match=r"is not installed here: pip install 'unity-link\[pyserial-asyncio\]'"):
        await unity_link.connect("serial:/dev/ttyUSB0?library=pyserial-asyncio")


# Events of a port


class Listener(asyncio.Protocol):
    """Records the events of a transport."""

    def __init__(self) -> None:
        self.paused = asyncio.Event()
        self.resumed = asyncio.Event()
        self.lost: asyncio.Future[Exception | None] = asyncio.get_running_loop().create_future()

    def pause_writing(self) -> None:
        self.paused.set()

    def resume_writing(self) -> None:
        self.resumed.set()

    def connection_lost(self, exc: Exception | None) -> None:
        self.lost.set_result(exc)


class Terminal:
    """A pseudo-terminal: a port for a program, and the other end of the port."""

    def __init__(self) -> None:
        self.other_end, self._port = pty.openpty()
        tty.setraw(self._port)
        self.url = f"serial:{os.ttyname(self._port)}"
        self.complaints: list[dict[str, object]] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, complaint: self.complaints.append(complaint))

    async def connect(self, library: str, protocol: asyncio.Protocol) -> asyncio.Transport:
        url = parse_url(by_library(self.url, library))
        return await load_driver("serial").connect(url, protocol)

    async def take(self, size: int) -> bytes:
        received = bytearray()
        while len(received) < size:
            received += await asyncio.get_running_loop().run_in_executor(None, os.read, self.other_end, 65_536)
        return bytes(received)

    def unplug(self) -> None:
        """Close both ends."""
        os.close(self.other_end)
        os.close(self._port)


@pytest.mark.asyncio
@pytest.mark.parametrize("library", PORTS)
async def test_a_pseudo_terminal_has_the_shortest_time_out_of_a_socket(library: str) -> None:
    terminal = Terminal()
    stream = Stream()
    await terminal.connect(library, stream)
    assert stream.shortest_timeout == QUICK_TIMEOUT
    await stream.close()
    terminal.unplug()


@pytest.mark.asyncio
@pytest.mark.parametrize("library", PORTS)
async def test_bytes_that_a_port_cannot_take_yet_are_sent_later(library: str) -> None:
    terminal, listener = Terminal(), Listener()
    transport = await terminal.connect(library, listener)
    sent = os.urandom(500_000)
    for start in range(0, len(sent), 10_000):
        transport.write(sent[start : start + 10_000])
    await listener.paused.wait()
    assert await terminal.take(len(sent)) == sent
    await listener.resumed.wait()
    for _ in range(10):
        await asyncio.sleep(0)
    transport.write(b"more")
    assert await terminal.take(4) == b"more"
    transport.close()
    assert await listener.lost is None
    terminal.unplug()
    assert terminal.complaints == []


@pytest.mark.asyncio
@pytest.mark.parametrize("library", PORTS)
@pytest.mark.parametrize("unsent", [0, 500_000])
async def test_an_unplugged_port_is_a_lost_connection_without_a_logged_error(library: str, unsent: int) -> None:
    terminal, listener = Terminal(), Listener()
    transport = await terminal.connect(library, listener)
    transport.write(bytes(unsent))
    terminal.unplug()
    transport.write(b"into nothing")
    await listener.lost
    assert transport.is_closing()
    assert terminal.complaints == []


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", [*PORTS, "tcp"])
async def test_a_gateway_that_pauses_its_reads_gets_all_bytes(
    serve: Callable[..., tuple[str, subprocess.Popen[str]]], medium: str
) -> None:
    url, process = serve(medium)
    async with unity_link.connect(url) as link:
        process.send_signal(signal.SIGSTOP)
        blocks = [asyncio.ensure_future(link.write_queue(0, [number] * 255)) for number in range(100)]
        reads = asyncio.ensure_future(link.read_many([0] * 5000))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        process.send_signal(signal.SIGCONT)
        await asyncio.gather(*blocks)
        assert (await reads)[-1] == 99
