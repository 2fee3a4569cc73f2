"""The event loop with simulated time, on which tests run."""

from __future__ import annotations

import asyncio
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.simulated_time import DeadlockError, ModelledTimeLoop, on_simulated_time, run_simulated


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
    start = loop.time()
    for delay in delays:
        # Two delays may differ by less than the resolution of the clock.
        loop.call_later(delay, fired.append, start + delay)
    await asyncio.sleep(1e4 + 1)
    assert fired == sorted(start + delay for delay in delays)


def test_wait_without_a_due_event_is_an_error() -> None:
    async def wait() -> None:
        await asyncio.get_running_loop().create_future()

    with pytest.raises(DeadlockError, match="no timer is set"):
        run_simulated(wait())


def test_clock_with_host_time_counts_the_work_of_the_program() -> None:
    async def work() -> tuple[float, float]:
        loop = asyncio.get_running_loop()
        processor, began = time.thread_time(), loop.time()
        while loop.time() - began < 0.01:
            pass
        return loop.time() - began, time.thread_time() - processor

    with asyncio.Runner(loop_factory=lambda: ModelledTimeLoop(host_time=True)) as runner:
        counted, spent = runner.run(work())
    assert 0.01 <= counted <= spent


@pytest.mark.parametrize("host_time", [False, True], ids=["modelled", "with host time"])
def test_clock_does_not_advance_while_a_model_computes(host_time: bool) -> None:
    async def compute() -> list[float]:
        loop = asyncio.get_running_loop()
        assert isinstance(loop, ModelledTimeLoop)
        with loop.standing_still():
            began = loop.time()
            with loop.standing_still():
                sum(range(100_000))
            loop.jump(2.0)
            return [began, loop.time()]

    with asyncio.Runner(loop_factory=lambda: ModelledTimeLoop(host_time=host_time)) as runner:
        began, ended = runner.run(compute())
    assert ended - began == pytest.approx(2.0, abs=1e-12)


@on_simulated_time
async def test_timers_of_the_world_run_during_waits_at_their_own_instants() -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    seen: list[float] = []

    def move() -> None:
        seen.append(loop.time())
        if len(seen) < 3:
            loop.call_world_at(move, loop.time() + 1.0, move)

    loop.call_world_at(move, 0.5, move)
    await asyncio.sleep(2.0)
    assert seen == [0.5, 1.5]
    loop.call_world_at(move, 0.0, None)
    await asyncio.sleep(2.0)
    assert seen == [0.5, 1.5]


@on_simulated_time
async def test_each_part_of_the_world_has_a_timer_that_another_part_may_cancel() -> None:
    loop = asyncio.get_running_loop()
    assert isinstance(loop, ModelledTimeLoop)
    seen: list[str] = []

    def first() -> None:
        seen.append("first")
        loop.call_world_at("second", 0.0, None)

    loop.call_world_at("first", 1.0, first)
    loop.call_world_at("second", 1.0, lambda: seen.append("second"))
    loop.call_world_at("third", 0.5, lambda: seen.append("third"))
    await asyncio.sleep(2.0)
    assert seen == ["third", "first"]


@on_simulated_time
async def test_work_for_a_thread_runs_at_once() -> None:
    loop = asyncio.get_running_loop()
    assert await loop.run_in_executor(None, divmod, 7, 2) == (3, 1)
    with pytest.raises(ZeroDivisionError):
        await loop.run_in_executor(None, divmod, 7, 0)
    assert loop.time() == 0.0
