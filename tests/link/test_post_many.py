"""Many posted writes in one call."""

from __future__ import annotations

import asyncio

import numpy as np
import pytest

import unity_link
from support.makers import CRC_32, RTL, Maker, in_flight
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve, cut
from unity_link import ArgumentError, BusError, GatewayInfo, LinkLostError, blocking
from unity_link.errors import Outcome
from unity_link.virtual.faults import Noise, NoisyLine

COUNT = 2 * in_flight(GatewayInfo())
"""More writes than may be in flight at once."""
ADDRESSES = np.arange(COUNT) % 200
VALUES = np.arange(COUNT)
WRITES = list(zip(ADDRESSES.tolist(), VALUES.tolist(), strict=True))


@on_simulated_time
async def test_all_are_written_once_and_in_order_when_the_fence_returns(make_bare: Maker) -> None:
    model = make_bare()
    bus = RecordedBus(model)
    async with unity_link.connect(model) as link:
        await link.post_many(ADDRESSES, VALUES)
        await link.fence()
        assert bus.writes == WRITES


@on_simulated_time
async def test_other_calls_take_turns_with_a_long_batch(make_bare: Maker) -> None:
    model = make_bare()
    bus = RecordedBus(model)
    async with unity_link.connect(model) as link:
        posting = asyncio.ensure_future(link.post_many(ADDRESSES, VALUES))
        await asyncio.sleep(0)
        await link.write(0xC8, 1)
        await posting
    assert (0xC8, 1) in bus.writes[:-1]
    assert [write for write in bus.writes if write != (0xC8, 1)] == WRITES


# Not through a server: retransmissions there are counted only by the server's own link.
@pytest.mark.parametrize("make_bare", ["sim", RTL], indirect=True)
@pytest.mark.parametrize("seed", range(20))
def test_a_line_that_loses_and_damages_bytes_does_not_change_the_result(make_bare: Maker, seed: int) -> None:
    async def run() -> None:
        model = make_bare(**CRC_32, id_digits=2)
        bus = RecordedBus(model)
        noise = [Noise(2 * seed + way, loss=0.001, flip=0.001) for way in range(2)]
        async with unity_link.connect(NoisyLine(model, *noise), timeout=60) as link:
            await link.post_many(ADDRESSES[:1000], VALUES[:1000])
            await link.fence()
            assert link.statistics.repetitions
        assert bus.writes == WRITES[:1000]

    run_simulated(run())


@on_simulated_time
async def test_the_fence_raises_the_first_error_and_counts_the_others(make_bare: Maker) -> None:
    model = make_bare()
    RecordedBus(model, failing=frozenset({3}))
    async with unity_link.connect(model) as link:
        await link.post_many([1, 3, 2, 3], [0, 0, 0, 0])
        with pytest.raises(BusError, match="posted write at 0x03") as caught:
            await link.fence()
    assert caught.value.__notes__ == ["1 more posted writes failed as well"]


@on_simulated_time
async def test_a_cancelled_call_has_written_the_values_that_were_sent(make_bare: Maker) -> None:
    model = make_bare()
    bus, gateway = RecordedBus(model), Valve(model)
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = False
        posting = asyncio.ensure_future(link.post_many(ADDRESSES, VALUES))
        await asyncio.sleep(0)
        posting.cancel()
        gateway.requests_pass = True
        await link.write(0xC8, 1)
    assert 0 < len(bus.writes) - 1 < COUNT
    assert bus.writes == [*WRITES[: len(bus.writes) - 1], (0xC8, 1)]


@on_simulated_time
async def test_the_outcome_is_unknown_if_the_link_is_lost(make_bare: Maker) -> None:
    model = make_bare()
    gateway = Valve(model)
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = False
        posting = asyncio.ensure_future(link.post_many(ADDRESSES, VALUES))
        await asyncio.sleep(0)
        cut(link)
        with pytest.raises(LinkLostError) as caught:
            await posting
        await link.aclose()
    assert caught.value.outcome is Outcome.UNKNOWN


@on_simulated_time
async def test_values_that_do_not_fit_raise_before_any_is_sent(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare()) as link:
        sent = link.statistics.requests
        for addresses, values, words in (([1, 2], [1], "2 addresses"), ([], [], "0"), ([256], [1], "0x100")):
            with pytest.raises(ArgumentError, match=words):
                await link.post_many(addresses, values)
        assert link.statistics.requests == sent


@pytest.mark.parametrize("url", ["sim:", pytest.param("rtl:", marks=pytest.mark.rtl)])
def test_the_blocking_link_has_post_many(url: str) -> None:
    with blocking.connect(url) as link:
        link.post_many([1, 2], [10, 20])
        link.fence()
        assert link.read_many([1, 2]).tolist() == [10, 20]
