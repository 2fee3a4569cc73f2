"""Gateways and snoops on uvloop, whose transports and timers are not classes of asyncio.

Links on uvloop are tested in test_faces.py.
"""

from __future__ import annotations

import asyncio
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import uvloop

import unity_link
from support.faces import use
from unity_link.transport.snoop import Passed, read
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_tcp, serve_unix

if TYPE_CHECKING:
    from collections.abc import Coroutine, Iterator

SERVER = Path(__file__).with_name("serve.py")


def run(coroutine: Coroutine[object, object, None]) -> None:
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(coroutine)


@pytest.fixture(params=["tcp", "unix", "udp", "serial", "serial?library=pyserial-asyncio"])
def url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """Serve a gateway from another process; yield its URL."""
    medium, mark, options = request.param.partition("?")
    command = [sys.executable, str(SERVER), medium, str(tmp_path / "gateway"), "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip() + mark + options
        process.kill()


@pytest.mark.parametrize("medium", ["sim", "tcp", "unix"])
def test_a_gateway_is_served_on_uvloop(medium: str, tmp_path: Path) -> None:
    async def serve_and_use() -> None:
        if medium == "sim":
            await use(unity_link.connect, "sim:")
            return
        gateway = VirtualGateway()
        async with serve_tcp(gateway) if medium == "tcp" else serve_unix(gateway, tmp_path / "gateway") as url:
            await use(unity_link.connect, url)

    run(serve_and_use())


def test_a_snoop_has_the_bytes_of_both_directions_and_their_times(url: str, tmp_path: Path) -> None:
    path, joint = tmp_path / "a.snoop", "&" if "?" in url else "?"

    async def two_reads() -> None:
        async with unity_link.connect(f"{url}{joint}snoop={path}") as link:
            assert await link.read(0x0A) == 0
            await asyncio.sleep(0.01)
            assert await link.read(0x0A) == 0

    run(two_reads())
    passed = [event for event in read(path, print) if isinstance(event, Passed)]
    asked = [event.time_ns for event in passed if event.sent and event.data.startswith((b"r000", b"r001"))]
    answered = [event.time_ns for event in passed if not event.sent and event.data.startswith((b"r000", b"r001"))]
    # In the whole milliseconds of the loop's clock a round trip would take 0 or 1 ms.
    assert asked[0] < answered[0] < asked[1] < answered[1]
    assert any(time % 1_000_000 for time in asked + answered)
