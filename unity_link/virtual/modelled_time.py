"""An event loop with simulated time, which passes only while all tasks wait, and then without delay.

The clock starts at 0. It is stopped while callbacks run, and jumps to the next timer when none are ready. With
``host_time`` the processor time of the program is added: `time` then shows the duration of the program if its waits
took the simulated time.

Each model of hardware has its own timer, `call_world_at`. The loop calls it while it waits and the clock is stopped,
because a kernel and hardware also work while a program sleeps.

Real sockets do not work in this loop. Threads must not take time; therefore the default executor runs functions at
once.
"""

from __future__ import annotations

import asyncio
import contextlib
import math
import selectors
import time
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


class DeadlockError(Exception):
    """All tasks wait, and no timer is set."""


class _AtOnce(ThreadPoolExecutor):
    """An executor that runs functions at once, in the thread of the event loop."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Run a function, and return a finished future."""
        done: Future[Any] = Future()
        try:
            done.set_result(function(*args, **kwargs))
        except Exception as error:  # noqa: BLE001  (the future has it)
            done.set_exception(error)
        return done


class _JumpingSelector(selectors.DefaultSelector):
    """A selector that does not sleep: it advances the clock and the models instead."""

    def __init__(self, host_time: Callable[[], float]) -> None:
        super().__init__()
        self._host_time = host_time
        self._offset = -host_time()
        self._frozen: float | None = None
        """The time while the clock is stopped; None while it runs."""
        self._world: dict[object, tuple[float, Callable[[], object]]] = {}
        """Timer of each model: time, and function to call."""

    @property
    def now(self) -> float:
        """The simulated time in seconds."""
        return self._host_time() + self._offset if self._frozen is None else self._frozen

    def jump(self, seconds: float) -> None:
        """Advance the clock."""
        with self.standing_still():
            assert self._frozen is not None
            self._frozen += seconds

    @contextlib.contextmanager
    def standing_still(self) -> Iterator[None]:
        """Stop the clock in the block."""
        if self._frozen is not None:
            yield
            return
        self._frozen = self.now
        try:
            yield
        finally:
            self._offset = self._frozen - self._host_time()
            self._frozen = None

    def set_world(self, owner: object, when: float, callback: Callable[[], object] | None) -> None:
        """Set the timer of one model; without a callback, cancel it."""
        self._world.pop(owner, None)
        if callback is not None:
            self._world[owner] = when, callback

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Return the ready descriptors, or advance the time until a descriptor or a timer is ready."""
        with self.standing_still():
            until = None if timeout is None else self.now + max(0.0, timeout)
            self._move_world()
            while not super().select(0):
                due = min((when for when, _ in self._world.values()), default=math.inf)
                if due < math.inf and (until is None or due <= until):
                    self._frozen = due
                    self._move_world()
                elif until is not None:
                    self._frozen = until
                    break
                else:
                    raise DeadlockError(f"all tasks wait, and no timer is set, at {self.now} s of simulated time")
        # Select once more with the clock running, so that `host_time` includes the time of a system call.
        return super().select(0)

    def _move_world(self) -> None:
        """Call the timers of models that are due."""
        while due := [owner for owner, (when, _) in self._world.items() if when <= self.now]:
            # Call one at a time, because it may cancel the others.
            self._world.pop(due[0])[1]()


class ModelledTimeLoop(asyncio.SelectorEventLoop):
    """An event loop with simulated time.

    Args:
        host_time: True to add the processor time of this thread.
    """

    def __init__(self, *, host_time: bool = False) -> None:
        self._jumping = _JumpingSelector(time.thread_time if host_time else lambda: 0.0)
        super().__init__(self._jumping)
        self.set_default_executor(_AtOnce())

    async def shutdown_default_executor(self, timeout: float | None = None) -> None:
        """Do nothing: the executor has no pending work, and asyncio would shut it down in a thread."""

    def time(self) -> float:
        """Return the simulated time in seconds."""
        return self._jumping.now

    def jump(self, seconds: float) -> None:
        """Advance the clock without calling timers, as if a callback took that long."""
        self._jumping.jump(seconds)

    def standing_still(self) -> contextlib.AbstractContextManager[None]:
        """Stop the clock in a block, while a model computes."""
        return self._jumping.standing_still()

    def call_world_at(self, owner: object, when: float, callback: Callable[[], object] | None) -> None:
        """Set the timer of a model, `owner`: call `callback` at the time `when`; None cancels the timer."""
        self._jumping.set_world(owner, when, callback)
