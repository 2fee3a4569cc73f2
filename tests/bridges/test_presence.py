"""The state of a gateway, away or present, if a server between keeps the connection."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import pytest

from support.sharing import PipedLink, sharing
from support.simulated_time import ModelledTimeLoop, on_simulated_time
from support.valve import Valve
from unity_link import GatewayInfo
from unity_link.bridges.presence import SILENCE, Interruption, Presence
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link import Subscription

STEP = 0.05


async def watch(presence: Presence, samples: Subscription, seconds: float) -> list[Interruption]:
    """Check the gateway for some seconds; return the interruptions that ended meanwhile."""
    loop = asyncio.get_running_loop()
    found, end = [], loop.time() + seconds
    while loop.time() < end:
        await asyncio.sleep(STEP)
        over = presence.look(loop.time(), samples.received, samples.rate_hz)
        if over is not None:
            found.append(over)
    return found


@on_simulated_time
@pytest.mark.parametrize("rate_hz", [100, 2])
async def test_gateway_behind_a_server_is_away_while_its_samples_stop(rate_hz: float) -> None:
    gateway = Valve(VirtualGateway())
    now = asyncio.get_running_loop().time
    async with (
        sharing(gateway) as shared,
        PipedLink(shared) as link,
        link.subscribe([0], rate_hz=rate_hz) as samples,
    ):
        presence = Presence(link, now())
        assert await watch(presence, samples, 10) == []
        before = now()
        gateway.go_away(shared)
        assert await watch(presence, samples, 6) == []
        assert link.connected
        assert presence.away_since == pytest.approx(before, abs=1 / rate_hz + 2 * STEP)
        gateway.come_back()
        (over,) = await watch(presence, samples, 20)
        assert over.began == pytest.approx(before, abs=1 / rate_hz + 2 * STEP)
        assert over.ended > before + 6
        assert presence.away_since is None


@on_simulated_time
async def test_gateway_is_present_between_two_samples_of_a_slow_group() -> None:
    now = asyncio.get_running_loop().time
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=1000))
    async with (
        sharing(gateway) as shared,
        PipedLink(shared) as link,
        link.subscribe([0], rate_hz=0.25) as samples,
    ):
        presence = Presence(link, now())
        assert await watch(presence, samples, 60) == []
        assert presence.away_since is None
        assert samples.received > 10


@on_simulated_time
async def test_silence_of_samples_on_request_is_no_sign_of_absence() -> None:
    now = asyncio.get_running_loop().time
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as link, link.subscribe([0]) as samples:
        presence = Presence(link, now())
        assert await watch(presence, samples, 10) == []
        assert presence.away_since is None


@on_simulated_time
async def test_program_that_was_suspended_does_not_take_that_for_silence() -> None:
    now = asyncio.get_running_loop().time
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as link:
        async with link.subscribe([0], rate_hz=100) as samples:
            presence = Presence(link, now())
            assert await watch(presence, samples, 1) == []
            received = samples.received
        # In a program that was suspended, the first check runs before the received samples are taken.
        later = now() + 10 * SILENCE
        assert presence.look(later, received, 100) is None
        assert presence.look(later + STEP, received + 1000, 100) is None
        assert presence.away_since is None


@on_simulated_time
@pytest.mark.parametrize("rate_hz", [20, 5, 2, 0.2])
@pytest.mark.parametrize("seconds", [0.4, 1, 3, 30])
async def test_suspended_program_does_not_take_its_own_pause_for_a_lost_gateway(rate_hz: float, seconds: float) -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as link:
        presence = Presence(link, loop.time())
        for samples in range(20):
            # A pause of the program also delays the samples that it polls itself.
            loop.jump(seconds)
            for _ in range(int(1.5 / rate_hz / STEP)):
                assert presence.look(loop.time(), samples, rate_hz) is None
                assert presence.away_since is None
                await asyncio.sleep(STEP)
            assert presence.look(loop.time(), samples + 1, rate_hz) is None


@on_simulated_time
async def test_gateway_lost_during_a_suspension_is_noticed_afterwards() -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    gateway = Valve(VirtualGateway())
    async with (
        sharing(gateway) as shared,
        PipedLink(shared) as link,
        link.subscribe([0], rate_hz=100) as samples,
    ):
        presence = Presence(link, loop.time())
        assert await watch(presence, samples, 1) == []
        gateway.go_away(shared)
        before = loop.time()
        loop.jump(10)
        assert await watch(presence, samples, 3) == []
        assert presence.away_since == pytest.approx(before, abs=2 * STEP)
        gateway.come_back()
        (over,) = await watch(presence, samples, 20)
        assert over.ended - over.began > 10


@on_simulated_time
async def test_program_that_checks_rarely_still_notices_an_absent_gateway() -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    async with sharing(VirtualGateway()) as shared, PipedLink(shared) as link:
        presence = Presence(link, loop.time())
        for _ in range(10):
            loop.jump(2)
            presence.look(loop.time(), 0, 100)
        assert presence.away_since is not None
