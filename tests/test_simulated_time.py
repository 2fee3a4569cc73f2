"""The event loop that tests of time run on."""

from __future__ import annotations

import asyncio

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simulated_time import DeadlockError, on_simulated_time, run_simulated


@on_simulated_time
async def test_sleeping_moves_the_clock_by_exactly_that() -> None:
    loop = asyncio.get_running_loop()
    await asyncio.sleep(3600.5)
    assert loop.time() == pytest.approx(3600.5, abs=1e-9)


@given(delays=st.lists(st.floats(0, 1e4), max_size=20))
@on_simulated_time
async def test_timers_fire_in_the_order_of_their_times(delays: list[float]) -> None:
    fired: list[float] = []
    loop = asyncio.get_running_loop()
    for delay in delays:
        loop.call_later(delay, fired.append, delay)
    await asyncio.sleep(1e4 + 1)
    assert sorted(delays) == fired


def test_waiting_for_what_never_comes_is_an_error() -> None:
    async def wait() -> None:
        await asyncio.get_running_loop().create_future()

    with pytest.raises(DeadlockError, match="nothing is left"):
        run_simulated(wait())
