"""A connection that is lost again while the link is setting up a new session."""

from __future__ import annotations

import asyncio
import re
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.sharing import until
from support.simulated_time import on_simulated_time
from support.valve import Valve, as_gateway, cut, numbers_in
from unity_link import LinkClosedError, LinkLostError, Reconnect
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link import Link


OPENING = re.compile(rb"^K(?=[0-9A-F]{7})", re.MULTILINE)
"""A `K` that opens a session: it has the fields i and s."""


class CutInSecondSession(Valve):
    """Cuts its link when the first reads of the second session arrive."""

    link: Link
    sessions = 0

    def receive(self, data: bytes, now: float) -> bytes:
        self.sessions += len(OPENING.findall(data))
        if self.sessions == 2 and data.startswith(b"r"):
            self.sessions = 3
            cut(self.link)
            return b""
        return super().receive(data, now)


QUICK = Reconnect(first_pause=0.01, longest_pause=0.1)


@on_simulated_time
async def test_a_link_cut_again_while_its_groups_wait_for_space_reconnects() -> None:
    gateway = CutInSecondSession(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
    gateway.memory[1] = 7
    quick = Reconnect(first_pause=0.01, longest_pause=0.1)
    async with unity_link.connect(gateway, reconnect=quick) as link, link.subscribe([1], rate_hz=10) as samples:
        gateway.link = link
        # The reads fill more than a window, so the requests that set up the group wait for space.
        reads = [asyncio.create_task(link.read(1)) for _ in range(200)]
        await asyncio.sleep(0)
        cut(link)
        assert await asyncio.gather(*reads) == [7] * 200
        assert [int(value) for value in (await anext(samples)).values] == [7]
        assert link.statistics.reconnections == 2


@on_simulated_time
async def test_a_subscription_that_begins_while_the_gateway_is_away_is_set_up_once() -> None:
    gateway = Valve(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
    async with unity_link.connect(gateway, reconnect=QUICK) as link:
        gateway.answers_pass = False
        cut(link)
        await until(lambda: not link.connected)
        asyncio.get_running_loop().call_later(0.5, setattr, gateway, "answers_pass", True)
        async with link.subscribe([1], rate_hz=10) as samples:
            taken = [await anext(samples) for _ in range(30)]
        assert [sample.lost for sample in taken] == [0] * 30
        assert gateway.heard.count(b"gs") == gateway.heard.count(b"gn") == 1


@on_simulated_time
async def test_a_subscription_that_waits_for_the_gateway_ends_with_the_link() -> None:
    gateway = Valve(VirtualGateway())
    link = await unity_link.connect(gateway, reconnect=QUICK)
    gateway.answers_pass = False
    cut(link)
    await until(lambda: not link.connected)
    waiting = asyncio.create_task(link.subscribe([1], rate_hz=10).__aenter__())
    await asyncio.sleep(1)
    await link.aclose()
    with pytest.raises(LinkClosedError):
        await waiting


@on_simulated_time
async def test_a_group_refused_at_a_reconnection_is_set_up_again() -> None:
    class Busy(Valve):
        refusals = 0

        def receive(self, data: bytes, now: float) -> bytes:
            if b"gs" in data and self.refusals:
                self.refusals -= 1
                self.gateway.receive(data, now)
                codec = link._session.codec
                return as_gateway(codec, codec.error(ErrorCode.OUT_OF_RANGE, *numbers_in(data, self.info)))
            return super().receive(data, now)

    gateway = Busy(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
    async with unity_link.connect(gateway, reconnect=QUICK) as link, link.subscribe([1], rate_hz=10) as samples:
        gateway.refusals = 2
        cut(link)
        await until(lambda: not link.connected)
        while (await anext(samples)).epoch < 3:
            pass
    assert link.statistics.reconnections == 3


@pytest.mark.parametrize("many", [False, True])
@on_simulated_time
async def test_leaving_a_lost_link_raises_the_errors_of_posted_writes(*, many: bool) -> None:
    async def post_and_lose() -> None:
        gateway = Valve(VirtualGateway())
        async with unity_link.connect(gateway) as link:
            gateway.answers_pass = False
            if many:
                await link.post_many([1, 2, 3], [4, 5, 6])
            else:
                await link.post(1, 2)
            await asyncio.sleep(0.001)
            cut(link)
            await until(lambda: not link.connected)

    with pytest.raises(LinkLostError) as caught:
        await post_and_lose()
    assert getattr(caught.value, "__notes__", []) == (["2 more posted writes failed as well"] if many else [])


@on_simulated_time
async def test_closing_a_link_drops_posted_writes_without_an_error() -> None:
    gateway = Valve(VirtualGateway())
    async with unity_link.connect(gateway) as link:
        gateway.answers_pass = False
        await link.post(1, 2)
        await link.aclose()
