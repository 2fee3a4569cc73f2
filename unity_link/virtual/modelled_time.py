"""An event loop on modelled time: it passes where everyone waits, at once, and in no other place.

Its clock begins at 0, stands still while there is work, and jumps to the next timer when there is none. With
``host_time``, the processor time that the program itself takes counts as well: then `time` is what a program would see
that works as long as this one does, and waits as long as the model says.

Each model that stands for a part of the world has a timer of its own, `call_world_at`. It is called inside the loop's
waiting, with the clock standing still, as a kernel and what is behind it work while a program sleeps.

Real sockets have no place here, and no thread may take time: the default executor works at once.
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
    """Everyone waits, and no timer is set."""


class _AtOnce(ThreadPoolExecutor):
    """Does at once, in the loop's own thread, what is given to it."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Do it."""
        done: Future[Any] = Future()
        try:
            done.set_result(function(*args, **kwargs))
        except Exception as error:  # noqa: BLE001  (the future has it)
            done.set_exception(error)
        return done


class _JumpingSelector(selectors.DefaultSelector):
    """Does not sleep: it moves the clock, and the world, instead."""

    def __init__(self, host_time: Callable[[], float]) -> None:
        super().__init__()
        self._host_time = host_time
        self._offset = -host_time()
        self._frozen: float | None = None
        """The time while it stands still."""
        self._world: dict[object, tuple[float, Callable[[], object]]] = {}
        """Timers by owner: the instant, and the function to call."""

    @property
    def now(self) -> float:
        """The modelled time in seconds."""
        return self._host_time() + self._offset if self._frozen is None else self._frozen

    def jump(self, seconds: float) -> None:
        """Let time pass."""
        with self.standing_still():
            assert self._frozen is not None
            self._frozen += seconds

    @contextlib.contextmanager
    def standing_still(self) -> Iterator[None]:
        """Keep the clock where it is."""
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
        """Set the timer of one part of the world, or none."""
        self._world.pop(owner, None)
        if callback is not None:
            self._world[owner] = when, callback

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Return what is ready, or let the time pass until something is."""
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
                    raise DeadlockError(f"nothing is left to happen at {self.now} s of simulated time")
        # Once more, so that what a program pays for it is in the time.
        return super().select(0)

    def _move_world(self) -> None:
        """Call the world as often as it wants until now."""
        while due := [owner for owner, (when, _) in self._world.items() if when <= self.now]:
            # One at a time: what it does may take another one's timer away.
            self._world.pop(due[0])[1]()


class ModelledTimeLoop(asyncio.SelectorEventLoop):
    """An event loop whose `time` is modelled.

    Args:
        host_time: count the processor time of this thread, too.
    """

    def __init__(self, *, host_time: bool = False) -> None:
        self._jumping = _JumpingSelector(time.thread_time if host_time else lambda: 0.0)
        super().__init__(self._jumping)
        self.set_default_executor(_AtOnce())

    async def shutdown_default_executor(self, timeout: float | None = None) -> None:
        """Do nothing: what works at once has nothing left to do, and asyncio would ask it in a thread."""

    def time(self) -> float:
        """Return the modelled time in seconds."""
        return self._jumping.now

    def jump(self, seconds: float) -> None:
        """Let time pass during which no timer fires, as when a callback takes long."""
        self._jumping.jump(seconds)

    def standing_still(self) -> contextlib.AbstractContextManager[None]:
        """Keep the clock where it is while a model computes."""
        return self._jumping.standing_still()

    def call_world_at(self, owner: object, when: float, callback: Callable[[], object] | None) -> None:
        """Set the timer of `owner`, a part of the world, to call at `when` and not before; None for no call."""
        self._jumping.set_world(owner, when, callback)
