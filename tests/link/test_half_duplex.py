"""A medium on which both sides share one pair of wires: only one of them may send at a time."""

from __future__ import annotations

import asyncio

import pytest

import unity_link
from support.recorded_bus import RecordedBus
from support.shared_pair import PAIR, SharedPair
from support.simulated_time import on_simulated_time
from unity_link import BusError
from unity_link.virtual import VirtualGateway

FAILING = 0x44


@on_simulated_time
async def test_no_request_is_sent_while_an_answer_is_pending() -> None:
    gateway = VirtualGateway(PAIR)
    bus = RecordedBus(gateway, failing=frozenset({FAILING}))
    pair = SharedPair(gateway)
    async with unity_link.connect(pair) as link:
        await asyncio.gather(
            *[link.write(1, value) for value in range(20)],
            *[link.post(2, value) for value in range(20)],
            *[link.read(1) for _ in range(20)],
            link.write_many([3] * 40, range(40)),
            link.post_many([4] * 40, range(40)),
            link.read_many([1] * 40),
            link.read_block(1, 40),
            link.fence(),
        )
        async with link.subscribe([1]) as subscription:
            for _ in range(3):
                await subscription.publish()
                await anext(subscription)
        assert link.statistics.repetitions == 0
    assert pair.collisions == []
    for address, count in ((1, 20), (2, 20), (3, 40), (4, 40)):
        assert [value for where, value in bus.writes if where == address] == list(range(count))


@on_simulated_time
async def test_the_fence_reports_an_error_of_a_posted_write() -> None:
    gateway = VirtualGateway(PAIR)
    RecordedBus(gateway, failing=frozenset({FAILING}))
    async with unity_link.connect(gateway) as link:
        await link.post(FAILING, 1)
        await link.post_many([1, FAILING, 2], [1, 2, 3])
        assert (gateway.memory[1], await link.read(2)) == (0, 3)
        with pytest.raises(BusError):
            await link.fence()
        await link.fence()
