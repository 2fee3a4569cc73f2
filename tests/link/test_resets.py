"""A gateway is reset while its line stays open: no unexecuted request is reported as done, and the link continues."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.makers import SLOW
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import LinkLostError, Outcome
from unity_link.errors import GatewayResetError
from unity_link.link import connection
from unity_link.protocol.window.constants import KEEP_ALIVE, LONGEST_SILENCE, LONGEST_TIMEOUT

if TYPE_CHECKING:
    from support.makers import Maker
    from unity_link import Subscription


@on_simulated_time
async def test_a_write_after_a_reset_is_reported_as_not_executed(make_direct: Maker) -> None:
    gateway = make_direct(**SLOW)
    async with unity_link.connect(gateway) as link:
        for value in range(200):
            await link.write(1, value)
        gateway.reset()
        with pytest.raises(GatewayResetError, match="the gateway was reset; the request is known not to be executed"):
            await link.write(1, 0xBAD)
        assert gateway.memory[1] == 199
        await link.write(1, 7)
        assert await link.read(1) == 7


@pytest.mark.parametrize("reconnect", [True, False])
@on_simulated_time
async def test_the_reported_outcome_of_each_write_at_a_reset_is_true(make_direct: Maker, *, reconnect: bool) -> None:
    gateway = make_direct(**SLOW)
    bus, valve = RecordedBus(gateway), Valve(gateway)
    async with unity_link.connect(valve, reconnect=reconnect) as link:
        tasks = [asyncio.ensure_future(link.write(1, value)) for value in range(20)]
        await asyncio.sleep(0)
        # The answers are lost, and the gateway is reset before the retransmissions.
        valve.answers_pass = False
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        gateway.reset()
        tasks += [asyncio.ensure_future(link.write(1, value)) for value in range(20, 40)]
        valve.answers_pass = True
        told = await asyncio.gather(*tasks, return_exceptions=True)
        written = {value for address, value in bus.writes if address == 1}
        for value, outcome in enumerate(told):
            if outcome is None:
                assert value in written
            else:
                assert isinstance(outcome, LinkLostError)
                assert outcome.outcome is Outcome.UNKNOWN or (outcome.outcome is Outcome.EXECUTED) == (value in written)
        assert len([value for address, value in bus.writes if address == 1]) == len(written)
        await link.write(2, 3)
        assert await link.read(2) == 3


@on_simulated_time
async def test_the_next_fence_raises_for_posted_writes_lost_in_a_reset(make_direct: Maker) -> None:
    gateway = make_direct(**SLOW)
    async with unity_link.connect(gateway) as link:
        await link.fence()
        gateway.reset()
        await link.post(1, 5)
        await link.post(2, 5)
        with pytest.raises(LinkLostError, match="the gateway was reset"):
            await link.fence()
        assert (gateway.memory[1], gateway.memory[2]) == (0, 0)
        await link.fence()


@on_simulated_time
async def test_subscriptions_continue_in_the_next_session(make_direct: Maker) -> None:
    gateway = make_direct(**SLOW)
    gateway.memory[1], gateway.memory[2] = 11, 22
    async with (
        unity_link.connect(gateway) as link,
        link.subscribe([1], rate_hz=100) as first,
        link.subscribe([2], rate_hz=50) as second,
    ):
        before = [await anext(first), await anext(second)]
        gateway.reset()
        with pytest.raises(GatewayResetError):
            await link.write(3, 1)
        while (sample := await anext(first)).epoch == 0:
            pass
        assert (sample.values.tolist(), sample.epoch) == ([11], 1)
        while (sample := await anext(second)).epoch == 0:
            pass
        assert (sample.values.tolist(), sample.epoch) == ([22], 1)
        assert sample.time is not None
        assert before[1].time is not None
        assert sample.time > before[1].time
        assert link.statistics.reconnections == 1


@on_simulated_time
async def test_a_program_that_only_reads_samples_gets_those_of_the_next_session(make_direct: Maker) -> None:
    gateway = make_direct(**SLOW)
    gateway.memory[1] = 11
    async with unity_link.connect(gateway) as link, link.subscribe([1], rate_hz=100) as subscription:
        before = await anext(subscription)
        gateway.reset()
        async with asyncio.timeout(2):
            while (sample := await anext(subscription)).epoch == 0:
                pass
        assert (sample.values.tolist(), sample.epoch) == ([11], 1)
        assert sample.time is not None
        assert before.time is not None
        assert sample.time > before.time


async def _last_words(subscription: Subscription) -> str:
    try:
        async for _ in subscription:
            pass
    except LinkLostError as error:
        return error.reason
    return ""


@on_simulated_time
async def test_a_link_on_which_only_samples_get_through_is_lost_soon(make_direct: Maker) -> None:
    valve = Valve(make_direct(**SLOW))
    async with unity_link.connect(valve) as link, link.subscribe([1], rate_hz=100) as subscription:
        await anext(subscription)
        valve.requests_pass = False
        last_words = asyncio.create_task(_last_words(subscription))
        async with asyncio.timeout(KEEP_ALIVE + LONGEST_SILENCE + LONGEST_TIMEOUT):
            assert (await last_words).startswith("the gateway does not answer any more: ")


@on_simulated_time
async def test_a_link_without_groups_sends_no_probes(make_direct: Maker) -> None:
    valve = Valve(make_direct(**SLOW))
    async with unity_link.connect(valve) as link:
        async with link.subscribe([1], rate_hz=100) as subscription:
            await anext(subscription)
        heard = len(valve.heard)
        await asyncio.sleep(5 * KEEP_ALIVE)
        assert len(valve.heard) == heard


@on_simulated_time
async def test_the_next_session_of_a_reconnecting_link_answers_reads(make_direct: Maker) -> None:
    gateway = make_direct(**SLOW)
    gateway.memory[5] = 55
    async with unity_link.connect(gateway, reconnect=True) as link:
        gateway.reset()
        assert await link.read(5) == 55
        assert (await link.read_many([5] * 500)).tolist() == [55] * 500


@on_simulated_time
async def test_a_gateway_that_is_silent_after_its_reset_ends_the_link(make_direct: Maker) -> None:
    valve = Valve(gateway := make_direct(**SLOW))
    async with unity_link.connect(valve) as link:
        gateway.reset()
        asking = asyncio.ensure_future(link.write(1, 1))
        with pytest.raises(GatewayResetError):
            await asking
        valve.answers_pass = False
        waiting = asyncio.ensure_future(link.write(1, 1))
        with pytest.raises(LinkLostError):
            async with asyncio.timeout(60):
                await waiting


@on_simulated_time
async def test_each_session_has_a_number_and_a_first_id_of_its_own(
    make_direct: Maker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(connection, "choose_seed", iter([0x1234, 0x4320, 0xFFFF, 0x4321]).__next__)
    valve = Valve(gateway := make_direct(**SLOW))
    async with unity_link.connect(valve) as link:
        await link.write(1, 1)
        gateway.reset()
        with pytest.raises(GatewayResetError):
            await link.write(1, 2)
        for value in range(5):
            await link.write(1, value)
        assert gateway.memory[1] == 4
    assert b"K2344321" in valve.heard
    assert b"w234" in valve.heard
    assert b"KFFF4322" in valve.heard
    assert b"wFFF" in valve.heard
