"""A connection that is lost again while a new session is being set up."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import unity_link
from simulated_time import on_simulated_time
from unity_link import Reconnect
from unity_link.protocol.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway
from valve import Valve, cut

if TYPE_CHECKING:
    from unity_link import Link


class CutInSecondSession(Valve):
    """Cuts its link when the first reads of the second session arrive."""

    link: Link
    sessions = 0

    def receive(self, data: bytes, now: float) -> bytes:
        self.sessions += data.count(b"K")
        if self.sessions == 2 and data.startswith(b"r"):
            self.sessions = 3
            cut(self.link)
            return b""
        return super().receive(data, now)


@on_simulated_time
async def test_a_link_that_is_cut_again_while_its_groups_wait_for_room_comes_back() -> None:
    gateway = CutInSecondSession(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
    gateway.memory[1] = 7
    quick = Reconnect(first_pause=0.01, longest_pause=0.1)
    async with unity_link.connect(gateway, reconnect=quick) as link, link.subscribe([1], rate_hz=10) as samples:
        gateway.link = link
        # More than a window: what sets the group up again waits behind them.
        reads = [asyncio.create_task(link.read(1)) for _ in range(200)]
        await asyncio.sleep(0)
        cut(link)
        assert await asyncio.gather(*reads) == [7] * 200
        assert [int(value) for value in (await anext(samples)).values] == [7]
        assert link.statistics.reconnections == 2
