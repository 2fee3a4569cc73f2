"""Runs tests on modelled time, so that an hour of time-outs takes a moment, and all runs are equal."""

from __future__ import annotations

import asyncio
import functools
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from unity_link.virtual.modelled_time import DeadlockError, ModelledTimeLoop

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

__all__ = ["DeadlockError", "ModelledTimeLoop", "on_simulated_time", "run_simulated"]

P = ParamSpec("P")
T = TypeVar("T")


def run_simulated(coroutine: Coroutine[Any, Any, T]) -> T:
    """Run a coroutine to its end on simulated time; return its result."""
    with asyncio.Runner(loop_factory=ModelledTimeLoop) as runner:
        return runner.run(coroutine)


def on_simulated_time(test: Callable[P, Coroutine[Any, Any, T]]) -> Callable[P, T]:
    """Return a synchronous test that runs an asynchronous test, or the body of a hypothesis test, on simulated time."""

    @functools.wraps(test)
    def run(*args: P.args, **kwargs: P.kwargs) -> T:
        return run_simulated(test(*args, **kwargs))

    return run
