"""Synchronisation primitives behave alike in asyncio, under trio and in blocking code."""

from __future__ import annotations

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import pytest
import trio
import trio.testing

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import blocking
from unity_link.link.runtimes.synchronisation import Event, Lock, gather, running

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from unity_link import Link

TASKS, TIMES = 4, 25
ADDRESS = 0x10


async def count(link: Link, lock: Lock) -> None:
    """Increment a word of the gateway, by a read and a write between which no other task may write."""
    for _ in range(TIMES):
        async with lock:
            await link.write(ADDRESS, await link.read(ADDRESS) + 1)


def in_asyncio(program: Callable[[Link], Coroutine[Any, Any, object]], times: int) -> int:
    async def main() -> int:
        async with unity_link.connect("sim:") as link:
            await asyncio.gather(*(program(link) for _ in range(times)))
            return await link.read(ADDRESS)

    return asyncio.run(main())


def under_trio(program: Callable[[Link], Coroutine[Any, Any, object]], times: int) -> int:
    async def main() -> int:
        async with unity_link.connect("sim:") as link:
            async with trio.open_nursery() as nursery:
                for _ in range(times):
                    nursery.start_soon(program, link)
            return await link.read(ADDRESS)

    return trio.run(main)


def in_threads(program: Callable[[Link], Coroutine[Any, Any, object]], times: int) -> int:
    with blocking.connect("sim:") as link:
        with ThreadPoolExecutor(times) as threads:
            for done in [threads.submit(lambda: link._call(program, link._link)) for _ in range(times)]:
                done.result(60)
        return link.read(ADDRESS)


WAYS = [in_asyncio, under_trio, in_threads]


@pytest.mark.parametrize("way", WAYS)
def test_a_lock_admits_one_task_at_a_time(way: Callable[..., int]) -> None:
    lock = Lock()
    assert way(lambda link: count(link, lock), TASKS) == TASKS * TIMES


@pytest.mark.parametrize("way", WAYS)
def test_gather_completes_all_calls_and_raises_the_first_error(way: Callable[..., int]) -> None:
    async def program(link: Link) -> None:
        assert await gather(link.read(1), link.read(2)) == [0, 0]
        with pytest.raises(unity_link.ArgumentError, match="0x1000"):
            await gather(link.read(0x1000), link.write(ADDRESS, 5))
        # In asyncio the other calls continue after the error.
        await link.fence()

    assert way(program, 1) == 5


@pytest.mark.parametrize("way", WAYS)
def test_all_tasks_may_wait_for_an_event(way: Callable[..., int]) -> None:
    event = Event()

    async def program(link: Link) -> None:
        if await link.write_masked(ADDRESS, 1, 1) == 0:
            await link.write(ADDRESS, 3)
            event.set()
        await event.wait()

    assert way(program, 3) & 1


# The steady clock (CLOCK_MONOTONIC_RAW)


async def _steady() -> float:
    return running().steady()


def _under_asyncio() -> float:
    return asyncio.run(_steady())


def _under_trio(clock: trio.abc.Clock | None = None) -> float:
    async def program() -> float:
        async with unity_link.connect("sim:"):
            return await _steady()

    return trio.run(program, clock=clock)


def _in_blocking_code() -> float:
    with blocking.connect("sim:") as link:
        seconds: float = link._call(_steady)
        return seconds


@pytest.mark.parametrize("read", [_under_asyncio, _under_trio, _in_blocking_code])
def test_the_steady_clock_is_the_raw_monotonic_clock_of_the_system(read: Callable[[], float]) -> None:
    before = time.clock_gettime(time.CLOCK_MONOTONIC_RAW)
    seconds = read()
    assert before <= seconds <= time.clock_gettime(time.CLOCK_MONOTONIC_RAW)


@on_simulated_time
async def test_the_steady_clock_of_a_simulated_loop_is_its_own() -> None:
    await asyncio.sleep(1000)
    assert running().steady() == asyncio.get_running_loop().time()


def test_the_steady_clock_under_a_mock_clock_of_trio_is_the_mock_clock() -> None:
    clock = trio.testing.MockClock(rate=1)
    clock.jump(1e9)
    assert _under_trio(clock) == pytest.approx(1e9, abs=1e6)
