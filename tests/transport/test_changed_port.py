"""A serial port whose settings another program changes while a link uses it, as ``stty sane`` does."""

from __future__ import annotations

import asyncio
import subprocess
import sys
import termios
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import trio
import uvloop

import unity_link
from support.changed_ports import make_sane
from unity_link import blocking
from unity_link.transport import parse_url
from unity_link.transport.serial import PortChannel, open_channel

if TYPE_CHECKING:
    from collections.abc import Iterator

SERVER = Path(__file__).with_name("serve.py")


@pytest.fixture
def url(tmp_path: Path) -> Iterator[str]:
    """Serve a gateway on a pseudo-terminal from another process; yield its URL."""
    command = [sys.executable, str(SERVER), "serial", str(tmp_path), "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip()
        process.kill()


async def go_on(url: str) -> None:
    async with unity_link.connect(url) as link:
        await link.write(0x0A, 42)
        make_sane(url)
        assert await link.read(0x0A) == 42
        await link.write(0x0A, 43)
        assert await link.read(0x0A) == 43


def go_on_blocking(url: str) -> None:
    with blocking.connect(url) as link:
        link.write(0x0A, 42)
        make_sane(url)
        assert link.read(0x0A) == 42
        link.write(0x0A, 43)
        assert link.read(0x0A) == 43


@pytest.mark.parametrize("library", ["", "?library=pyserial-asyncio"])
@pytest.mark.parametrize("face", ["asyncio", "uvloop", "trio", "blocking"])
def test_a_link_restores_the_settings_of_its_port_logs_it_and_goes_on(
    url: str, face: str, library: str, caplog: pytest.LogCaptureFixture
) -> None:
    if face == "trio":
        trio.run(go_on, url + library)
    elif face == "blocking":
        go_on_blocking(url + library)
    else:
        loops = {"asyncio": asyncio.new_event_loop, "uvloop": uvloop.new_event_loop}
        with asyncio.Runner(loop_factory=loops[face]) as runner:
            runner.run(go_on(url + library))
    assert "another program has changed the settings of the port; they are set again" in caplog.text


def test_only_changed_settings_of_a_port_are_restored_and_logged(url: str, caplog: pytest.LogCaptureFixture) -> None:
    channel = open_channel(parse_url(url), None)
    assert isinstance(channel, PortChannel)
    try:
        before = termios.tcgetattr(channel.fileno())
        channel.set_again()
        assert not caplog.text
        make_sane(url)
        assert termios.tcgetattr(channel.fileno()) != before
        channel.set_again()
        assert termios.tcgetattr(channel.fileno()) == before
    finally:
        channel.close()
    channel.set_again()
