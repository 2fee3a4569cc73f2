"""The model clock of a gateway that leaves out time, as compiled gateware does: after a pause, and if it is slow."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

from unity_link.virtual.model_clock import LONGEST_TURN, MOST_LAG, MOST_TURN, ModelClock

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

SLICE = 0.001


class Loop(asyncio.SelectorEventLoop):
    """An event loop whose clock and callbacks the test controls."""

    def __init__(self) -> None:
        super().__init__()
        self.now = self.when = 0.0
        self.callback: Callable[..., object] = lambda: None
        self.args: tuple[Any, ...] = ()

    def time(self) -> float:
        return self.now

    def call_at(  # type: ignore[override]  # it is as wide
        self, when: float, callback: Callable[..., object], *args: Any, **more: Any
    ) -> asyncio.TimerHandle:
        self.when, self.callback, self.args = when, callback, args
        return super().call_at(when, callback, *args, **more)

    def fire(self) -> None:
        self.now = max(self.now, self.when)
        self.callback(*self.args)


class Gateway:
    """Simulates slices of time, each of which takes some time of the event loop."""

    leaves_time_out = True
    waiting = 0
    refusal = ""

    def __init__(self, loop: Loop, takes: float) -> None:
        self.loop, self.takes = loop, takes
        self.wake: Callable[[], None] = lambda: None
        self.time = 0.0
        self.left_out = 0.0
        self.received: list[tuple[float, float]] = []

    @property
    def next_due(self) -> float:
        return self.time + SLICE

    def advance(self, now: float, room: int | None = None) -> bytes:
        self.loop.now += self.takes
        self.left_out += max(0.0, now - self.time - 10 * SLICE)
        self.time = now
        return b""

    def receive(self, data: bytes, now: float) -> bytes:
        self.received.append((self.loop.now, now))
        return b""


@pytest.fixture
def loop() -> Iterator[Loop]:
    made = Loop()
    yield made
    made.close()


@pytest.mark.parametrize("pause", [0.2, 0.9])
def test_all_time_of_a_pause_has_passed_for_a_later_request(loop: Loop, pause: float) -> None:
    gateway = Gateway(loop, 0.4 * SLICE)
    clock = ModelClock(gateway, lambda _: None, loop)
    for _ in range(100):
        loop.fire()
    begun = loop.now
    loop.now += pause
    clock.feed(b"a kick")
    ((_, instant),) = gateway.received
    assert instant == pytest.approx(begun + pause, abs=SLICE)
    assert gateway.time == pytest.approx(begun + pause, abs=2 * SLICE)
    assert gateway.left_out == 0
    clock.close()


def test_a_very_long_pause_does_not_block_the_loop(loop: Loop) -> None:
    gateway = Gateway(loop, 0.4 * SLICE)
    clock = ModelClock(gateway, lambda _: None, loop)
    loop.fire()
    for pause in (5.0, 3600.0):
        loop.now += pause
        begun = loop.now
        clock.feed(b"a kick")
        assert loop.now - begun < LONGEST_TURN + 2 * SLICE
    assert gateway.left_out > 3590
    clock.close()


def test_a_slow_gateway_does_not_block_the_loop(loop: Loop) -> None:
    gateway = Gateway(loop, 2.5 * SLICE)
    clock = ModelClock(gateway, lambda _: None, loop)
    turns = []
    for _ in range(2000):
        begun = max(loop.now, loop.when)
        loop.fire()
        turns.append(loop.now - begun)
    assert max(turns) <= MOST_TURN + 3 * SLICE
    # The gateway runs at its own pace.
    assert gateway.left_out == pytest.approx(0.6 * loop.now, rel=0.1)
    assert loop.now - gateway.time <= MOST_LAG + 0.1
    clock.close()
