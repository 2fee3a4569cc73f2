"""Every API of a link on every medium; docs/reference/faces.md has the same table, with C, C++ and Octave."""

from __future__ import annotations

import asyncio
import shlex
import socket
import subprocess
import sys
from contextlib import ExitStack, asynccontextmanager, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import trio
import uvloop
from anyio.from_thread import start_blocking_portal

import examples.own_medium  # noqa: F401  (it registers its scheme)
import unity_link
from support.faces import face, use
from support.sharing import ServedGateway
from unity_link.bridges.serve import serve
from unity_link.bridges.zenoh.streams import Streams
from unity_link.transport.zenoh_session import Network, close_session, open_session
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Iterator

SERVER = Path(__file__).with_name("serve.py")
ON_PIPES = Path(__file__).parents[2] / "examples" / "gateway_on_pipes.py"
FACES = ("asyncio", "uvloop", "trio", "blocking")
OF_A_PROCESS = ("serial", "serial?library=pyserial-asyncio", "tcp", "unix", "udp")
MEDIA = (*OF_A_PROCESS, "ftdi", "ftdi-async", "zenoh", "served", "pipes", "mmio", "sim")


@pytest.fixture(params=MEDIA)
def url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """Yield the URL of a gateway, in another process or in the event loop of another thread if the medium needs one."""
    with ExitStack() as stack:
        if request.param in OF_A_PROCESS:
            yield stack.enter_context(_process(request.param, tmp_path))
        elif request.param in ("zenoh", "served"):
            portal = stack.enter_context(start_blocking_portal())
            making = _over_zenoh() if request.param == "zenoh" else _served(tmp_path)
            yield stack.enter_context(portal.wrap_async_context_manager(making))
        elif request.param == "mmio":
            (tmp_path / "bus").write_bytes(bytes(1024))
            yield f"mmio:{tmp_path / 'bus'}"
        else:
            pipes = f"pipes:{shlex.join([sys.executable, str(ON_PIPES)])}"
            yield {"pipes": pipes, "sim": "sim:"}.get(request.param, f"{request.param}://virtual")


@contextmanager
def _process(medium: str, folder: Path) -> Iterator[str]:
    kind, mark, options = medium.partition("?")
    command = [sys.executable, str(SERVER), kind, str(folder / "gateway"), "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip() + mark + options
        process.kill()


@asynccontextmanager
async def _served(folder: Path) -> AsyncIterator[str]:
    path = folder / "shared"
    async with serve(VirtualGateway(), unix=path):
        yield f"unix:{path}"


@asynccontextmanager
async def _over_zenoh() -> AsyncIterator[str]:
    with socket.create_server(("127.0.0.1", 0)) as free:
        endpoint = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    session = open_session(Network(listen=(endpoint,)))
    try:
        shared = ServedGateway(VirtualGateway(), lambda _: None)
        shared.open_when_there()
        streams = Streams(session, "gateway", shared)
        yield f"zenoh:gateway?connect={endpoint}"
        streams.close()
        await shared.finish()
    finally:
        close_session(session)


@pytest.mark.slow
@pytest.mark.parametrize("name", FACES)
def test_every_kind_of_call_works_on_every_medium(name: str, url: str, tmp_path: Path) -> None:
    if name == "trio":
        trio.run(use, unity_link.connect, url)
    elif name == "blocking":
        with face("blocking", tmp_path) as connect:
            asyncio.run(use(connect, url))
    else:
        factory = uvloop.new_event_loop if name == "uvloop" else None
        with asyncio.Runner(loop_factory=factory) as runner:
            runner.run(use(unity_link.connect, url))
