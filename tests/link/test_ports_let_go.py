"""A port is closed when its link is left, however that link ended; it can be opened again at once."""

from __future__ import annotations

import asyncio
import logging

import pytest

import unity_link
from unity_link import LinkLostError, Reconnect
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_pty

ANOTHER = "another program has begun a session"


async def write_in_a_lost_session(gateway: VirtualGateway, url: str, *, blocking: bool) -> None:
    if blocking:
        await asyncio.to_thread(write_in_a_lost_session_blocking, gateway, url)
        return
    async with unity_link.connect(url) as link:
        gateway.begin(gateway.session % 100 + 1, 0)
        await link.write(1, 2)


def write_in_a_lost_session_blocking(gateway: VirtualGateway, url: str) -> None:
    with unity_link.blocking.connect(url) as link:
        gateway.begin(gateway.session % 100 + 1, 0)
        link.write(1, 2)


async def lose_and_connect(*, blocking: bool) -> int:
    """Leave a link that another program has ended, then connect and write at once; return the word."""
    gateway = VirtualGateway()
    async with serve_pty(gateway) as url:
        with pytest.raises(LinkLostError, match=ANOTHER):
            await write_in_a_lost_session(gateway, url, blocking=blocking)
        async with unity_link.connect(url) as link:
            await link.write(1, 3)
    return gateway.memory[1]


@pytest.mark.parametrize("blocking", [False, True])
def test_a_port_is_free_when_a_link_that_another_program_ended_is_left(*, blocking: bool) -> None:
    assert asyncio.run(lose_and_connect(blocking=blocking)) == 3


def test_a_lost_port_is_opened_again_by_the_first_attempt(caplog: pytest.LogCaptureFixture) -> None:
    async def lose() -> int:
        async with serve_pty(VirtualGateway()) as url, unity_link.connect(url, reconnect=Reconnect()) as link:
            link._lose("the test ends the connection")
            await link.write(1, 2)
            return await link.read(1)

    caplog.set_level(logging.INFO, "unity_link.link")
    assert asyncio.run(lose()) == 2
    assert "not connected" not in caplog.text
