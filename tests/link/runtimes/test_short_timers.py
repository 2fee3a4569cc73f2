"""An event loop sleeps whole milliseconds; calls of a link that are due sooner are made on time."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

from support.simulated_time import on_simulated_time
from unity_link.link.runtimes.runtime import SHORTEST_SLEEP, AsyncioRuntime

if TYPE_CHECKING:
    from collections.abc import Callable

TURN = SHORTEST_SLEEP / 10


class Handle:
    """A planned call."""

    def __init__(self, function: Callable[[], object]) -> None:
        self.function: Callable[[], object] | None = function

    def cancel(self) -> None:
        self.function = None


class Loop:
    """An event loop with turns that take some time; it records the times until which it would sleep."""

    def __init__(self) -> None:
        self.now = 100.0
        self.ready: list[Handle] = []
        self.slept_until: list[float] = []

    def time(self) -> float:
        return self.now

    def call_soon(self, function: Callable[[], object]) -> Handle:
        self.ready.append(Handle(function))
        return self.ready[-1]

    def call_at(self, when: float, function: Callable[[], object]) -> Handle:
        self.slept_until.append(when)
        return Handle(function)

    def turn(self) -> None:
        self.now += TURN
        ready, self.ready = self.ready, []
        for handle in ready:
            if handle.function is not None:
                handle.function()

    def __getattr__(self, name: str) -> Any:
        return None


@pytest.fixture
def loop(monkeypatch: pytest.MonkeyPatch) -> Loop:
    made = Loop()
    monkeypatch.setattr(asyncio, "get_running_loop", lambda: made)
    return made


def test_a_call_due_soon_is_made_in_the_first_turn_after_its_time(loop: Loop) -> None:
    called: list[float] = []
    AsyncioRuntime().call_at(loop.now + 4.5 * TURN, lambda: called.append(loop.now))
    for _ in range(20):
        loop.turn()
    assert called == [pytest.approx(100 + 5 * TURN)]
    assert (loop.ready, loop.slept_until) == ([], [])


def test_the_loop_sleeps_until_a_call_that_is_due_later(loop: Loop) -> None:
    AsyncioRuntime().call_at(loop.now + 2 * SHORTEST_SLEEP, lambda: None)
    assert (loop.ready, loop.slept_until) == ([], [100 + 2 * SHORTEST_SLEEP])


@pytest.mark.parametrize("turns", [0, 2])
def test_a_cancelled_call_is_not_made(loop: Loop, turns: int) -> None:
    called: list[float] = []
    timer = AsyncioRuntime().call_at(loop.now + 5 * TURN, lambda: called.append(loop.now))
    for _ in range(turns):
        loop.turn()
    timer.cancel()
    for _ in range(20):
        loop.turn()
    assert (called, loop.ready) == ([], [])


@on_simulated_time
async def test_a_short_timer_works_on_simulated_time() -> None:
    loop, called = asyncio.get_running_loop(), []
    AsyncioRuntime().call_at(loop.time() + TURN, lambda: called.append(loop.time()))
    await asyncio.sleep(1.0)
    assert called == [TURN]
