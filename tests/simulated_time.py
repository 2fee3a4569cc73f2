"""An event loop on simulated time, so that an hour of time-outs takes a moment and every run is the same.

Its clock begins at 0, stands still while there is work, and jumps to the next timer when there is none. Real sockets
and processes have no place on it: nothing but timers and callbacks moves it on. When there is neither, nothing can ever
happen again, and the loop raises `DeadlockError` instead of hanging.
"""

from __future__ import annotations

import asyncio
import functools
import selectors
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

P = ParamSpec("P")
T = TypeVar("T")


class DeadlockError(Exception):
    """Everyone waits, and no timer is set."""


class _JumpingSelector(selectors.DefaultSelector):
    """Does not sleep: it moves the clock instead."""

    now = 0.0

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Give what is ready, or let the time pass."""
        ready: list[tuple[selectors.SelectorKey, int]] = super().select(0)
        if not ready:
            if timeout is None:
                raise DeadlockError(f"nothing is left to happen at {self.now} s of simulated time")
            self.now += max(0.0, timeout)
        return ready


class SimulatedTimeLoop(asyncio.SelectorEventLoop):
    """An event loop whose `time` is simulated."""

    def __init__(self) -> None:
        self._jumping = _JumpingSelector()
        super().__init__(self._jumping)

    def time(self) -> float:
        """Give the simulated time in seconds."""
        return self._jumping.now

    def be_busy(self, seconds: float) -> None:
        """Let time pass during which no timer fires, as when a callback takes long."""
        self._jumping.now += seconds


def run_simulated(coroutine: Coroutine[Any, Any, T]) -> T:
    """Run a coroutine to its end on simulated time."""
    with asyncio.Runner(loop_factory=SimulatedTimeLoop) as runner:
        return runner.run(coroutine)


def on_simulated_time(test: Callable[P, Coroutine[Any, Any, T]]) -> Callable[P, T]:
    """Make an asynchronous test, or the inside of a hypothesis test, one that runs on simulated time."""

    @functools.wraps(test)
    def run(*args: P.args, **kwargs: P.kwargs) -> T:
        return run_simulated(test(*args, **kwargs))

    return run
