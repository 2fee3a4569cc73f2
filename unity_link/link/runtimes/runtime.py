"""The runtime of a link: the clock, the timers and the futures that `Connection` and `Link` wait by.

Their coroutines are the same in every kind of program. `AsyncioRuntime` is the event loop that they were called in;
`calling_thread` runs them in the threads of blocking code, and `trio_runtime` in tasks of trio.
"""

from __future__ import annotations

import asyncio
import logging
import sys
import time
from typing import TYPE_CHECKING, Any, Never, Protocol, cast
from weakref import WeakKeyDictionary

from unity_link.link.runtimes.waiter import Result
from unity_link.transport import open_medium, prepare
from unity_link.transport.polling import SPIN, Spinning

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator, Sequence
    from contextlib import AbstractAsyncContextManager
    from contextvars import Context

    from unity_link.transport import DriverUrl, Medium
    from unity_link.transport.stream import Stream

log = logging.getLogger("unity_link.link")
SHORTEST_SLEEP = 0.0002
"""Seconds that are not slept: an event loop sleeps whole milliseconds, and a sign of loss may be due much sooner."""


_UNADJUSTED = getattr(time, "CLOCK_MONOTONIC_RAW", None)


def unadjusted_time() -> float:
    """Return ``CLOCK_MONOTONIC_RAW`` in seconds; `time.perf_counter`, where a system has none.

    It goes as the machine's quartz does. Other clocks are made quicker and slower by what sets the time by a network,
    some by a part in ten.
    """
    return time.perf_counter() if _UNADJUSTED is None else time.clock_gettime(_UNADJUSTED)


def report(message: str, error: BaseException) -> None:
    """Log an error that no call can raise: of a program's own callback, or of what runs beside the calls."""
    log.error(message, exc_info=error)


class Waiter(Protocol):
    """Awaitable of a call: as much of `asyncio.Future` as links need."""

    def done(self) -> bool:
        """Return whether there is a result or an error, or it was cancelled."""

    def cancelled(self) -> bool:
        """Return whether it was cancelled."""

    def cancel(self) -> bool:
        """Cancel it, and return whether it was not done before."""

    def set_result(self, result: object, /) -> None:
        """Resume the awaiting call with a result."""

    def set_exception(self, exception: BaseException, /) -> None:
        """Resume the awaiting call with an error."""

    def exception(self) -> BaseException | None:
        """Return the error of one that is done."""

    def __await__(self) -> Generator[Any, Any, Any]:
        """Wait, and return the result or raise the error."""


class Timer(Protocol):
    """Call that is due at a time."""

    def cancel(self) -> None:
        """Cancel the call."""


class Job(Protocol):
    """A coroutine that runs beside the calls."""

    def cancel(self) -> object:
        """End it at its next wait."""


class Runtime(Protocol):
    """Runtime of a link."""

    @property
    def ended(self) -> Sequence[object]:
        """The futures of lone requests that are done, until `wake`."""

    def time(self) -> float:
        """Return the time in seconds, from any origin."""

    def steady(self) -> float:
        """Return the time in seconds of an unadjusted clock: `unadjusted_time`, in models of time the modelled one."""

    def caller(self) -> object:
        """Return the task or thread that runs now; None if neither does."""

    def is_over(self, caller: Any, /) -> bool:
        """Return whether a task or thread has ended, so that it will never call again."""

    def create_future(self) -> Waiter:
        """Return what a coroutine can await."""

    def create_lone_future(self) -> Waiter:
        """Return the same for a request that is alone in flight; it goes on at `wake`."""

    def wake(self) -> None:
        """Resume those who await the futures of lone requests that are done."""

    def call_soon(self, function: Callable[[], object], /) -> object:
        """Call a function when what runs now waits."""

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> object:
        """Call a function soon; may be called by other threads."""

    def call_at(self, when: float, function: Callable[[], object], /) -> Timer:
        """Call a function at a time of `time`."""

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> Job:
        """Run a coroutine beside the calls."""

    async def finish(self, job: Job) -> None:
        """Cancel a job, and wait until it has ended."""

    async def sleep(self, seconds: float) -> None:
        """Wait."""

    def timeout(self, seconds: float) -> AbstractAsyncContextManager[object]:
        """Return a context manager that has the block raise TimeoutError after some time."""

    def last_timeout(self, seconds: float) -> AbstractAsyncContextManager[object]:
        """Return the same for what is done after a cancellation; the block may wait though its task is cancelled."""

    async def prepare(self, url: DriverUrl) -> None:
        """Do what must be done once before a medium of this kind can be opened."""

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Connect a stream to a medium."""

    def attend(self) -> None:
        """See that what arrives is taken also while no call waits, until `leave` is called as often."""

    def leave(self) -> None:
        """End what one call of `attend` has begun."""


def told_now(runtime: Runtime, caller: object) -> Callable[[object], bool]:
    """Return a function that returns whether the errors of a task's writes are raised now, where `caller` asks.

    A task gets the errors of its own writes, and those of tasks that are over, which the function gets as None too.
    """
    is_over = runtime.is_over
    return lambda poster: poster is None or poster is caller or is_over(poster)


class _ShortTimer:
    """A timer that an event loop waits for turn by turn, as it cannot sleep for so short a time.

    Args:
        loop: the event loop.
        when: when the function is to be called.
        function: is called then.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop, when: float, function: Callable[[], object]) -> None:
        self._loop = loop
        self._when = when
        self._function = function
        self._before = loop.time()
        self._handle: asyncio.Handle = loop.call_soon(self._turn)

    def cancel(self) -> None:
        """Cancel the call."""
        self._handle.cancel()

    def _turn(self) -> None:
        now = self._loop.time()
        if now >= self._when:
            self._function()
        elif now > self._before:
            self._before = now
            self._handle = self._loop.call_soon(self._turn)
        else:
            # A modelled clock: it stands still until all wait.
            self._handle = self._loop.call_at(self._when, self._function)


class LoneFuture(Result):
    """Future of a request that is alone in flight: where it is woken, the task goes on at once.

    With asyncio's own future it would go on in the next turn of the event loop: two turns, and two polls, for each
    answer. To the task it is one; this is all that tasks ask of a future (`asyncio.isfuture`). Where many are under
    way, they share the turns, and asyncio's is the quicker.

    Args:
        loop: of the task.
        spinner: of the loop.
        ended: those that have a result or an error, and are to be woken.
    """

    __slots__ = ("_asyncio_future_blocking", "_context", "_ended", "_loop", "_spinner", "_step")

    def __init__(self, loop: asyncio.AbstractEventLoop, spinner: _LoopSpinner, ended: list[LoneFuture]) -> None:
        # As `Result` would: this is on the way of every read.
        self._done = self._asyncio_future_blocking = False
        self._result = self._error = None
        self._loop = loop
        self._spinner = spinner
        spinner.awaited += 1
        self._ended = ended
        self._step: Callable[[LoneFuture], object] | None = None
        """Has the task that awaits it go on."""
        self._context: Context | None = None

    def __await__(self) -> Generator[LoneFuture, None, Any]:
        """Wait, and return the result or raise the error."""
        if not self._done:
            self._asyncio_future_blocking = True
            yield self
        return self.result()

    def _end(self) -> None:
        self._done = True
        self._spinner.awaited -= 1
        self._ended.append(self)

    def wake(self) -> None:
        """Resume the task now; in the next turn of the loop where another runs at this moment."""
        step, context = self._step, self._context
        if step is None or context is None:
            # The task has not come to wait yet.
            return
        try:
            context.run(step, self)
        except RuntimeError:
            self._wake_soon()
        except BaseException as error:  # noqa: BLE001  (a task raises KeyboardInterrupt and SystemExit, for the loop)
            self._loop.call_soon(_raise, error)

    def _wake_soon(self) -> None:
        if self._step is not None:
            self._loop.call_soon(self._step, self, context=self._context)

    # What tasks call

    def get_loop(self) -> asyncio.AbstractEventLoop:
        """Return the event loop of the task."""
        return self._loop

    def add_done_callback(self, function: Callable[[LoneFuture], object], /, *, context: Context) -> None:
        """Take what has the task go on."""
        self._step, self._context = function, context

    def cancel(self, msg: str | None = None) -> bool:
        """Cancel it, as the task was cancelled, and return whether it was not done before."""
        if self._done:
            return False
        self._error = asyncio.CancelledError() if msg is None else asyncio.CancelledError(msg)
        self._done = True
        self._spinner.awaited -= 1
        self._wake_soon()
        return True


def _raise(error: BaseException) -> Never:
    raise error


class _LoopSpinner:
    """Keeps an event loop from sleeping while the answer to a lone request may come soon (see `transport.polling`).

    There is one for all links on a loop: where several have asked, there is enough to do without it. It is given the
    loop each time, for it lives as long as that does.
    """

    def __init__(self) -> None:
        self._spinning = Spinning()
        self.awaited = 0
        """Number of answers to lone requests that are awaited."""
        self._is_planned = False
        """True if the loop looks again in its next turn."""
        self._until = self._looked_at = 0.0

    def begin(self, loop: asyncio.AbstractEventLoop) -> float:
        """Record that a lone request is sent now, and return the time, for `end`."""
        self._looked_at = now = _time_of(loop)
        self._until = now + SPIN
        if self._spinning.left and self.awaited == 1 and not self._is_planned:
            self._is_planned = True
            loop.call_soon(self._look, loop)
        return now

    def end(self, loop: asyncio.AbstractEventLoop, began: float) -> None:
        """Record that the answer has come to a request which was sent at some time."""
        self._spinning.record(_time_of(loop) - began)

    def _look(self, loop: asyncio.AbstractEventLoop) -> None:
        now = _time_of(loop)
        # A modelled clock stands still until all wait.
        self._is_planned = self.awaited == 1 and self._looked_at < now < self._until
        if self._is_planned:
            self._looked_at = now
            loop.call_soon(self._look, loop)


def _caller_of(loop: asyncio.AbstractEventLoop) -> Callable[[], asyncio.Task[Any] | None]:
    """Return a function that returns the task of a loop that calls it; None in another thread, and outside of tasks.

    A program may call a link's method in another thread, for `asyncio.run_coroutine_threadsafe`. The task that the loop
    runs at that moment is not the caller.
    """
    current: Any = asyncio.current_task
    if sys.version_info < (3, 12):
        # `current_task` is written in Python there, and takes a tenth of the time of a post.
        current = asyncio.tasks._current_tasks.get  # type: ignore[attr-defined]  # noqa: SLF001
    running = asyncio._get_running_loop  # noqa: SLF001
    return lambda: current(loop) if running() is loop else None


def _time_of(loop: asyncio.AbstractEventLoop) -> float:
    """Return the time in seconds. The clock of uvloop has whole milliseconds; loops that model time are asyncio's."""
    return loop.time() if isinstance(loop, asyncio.BaseEventLoop) else time.monotonic()


_spinners: WeakKeyDictionary[asyncio.AbstractEventLoop, _LoopSpinner] = WeakKeyDictionary()


class AsyncioRuntime:
    """The event loop that is running."""

    def __init__(self) -> None:
        loop = asyncio.get_running_loop()
        # The loop's own methods: nothing stands between them and the calls, nor between the calls and its clock.
        is_monotonic = getattr(loop.time, "__func__", None) is asyncio.BaseEventLoop.time
        self.time = time.monotonic if is_monotonic else loop.time
        # A loop of asyncio that has a clock of its own models time.
        models_time = isinstance(loop, asyncio.BaseEventLoop) and not is_monotonic
        self.steady = loop.time if models_time else unadjusted_time
        self.create_future = loop.create_future
        self.call_soon = loop.call_soon
        self.call_soon_threadsafe = loop.call_soon_threadsafe
        self._loop = loop
        self.ended: list[LoneFuture] = []
        """Futures of lone requests that are done, and whose tasks are to be resumed."""
        self._spinner = _spinners.setdefault(loop, _LoopSpinner())
        self._asked_at = 0.0
        """Instant at which the last lone request was sent."""
        self.create_task = loop.create_task
        self.caller = _caller_of(loop)
        self.timeout = self.last_timeout = asyncio.timeout
        self.sleep = asyncio.sleep
        self.prepare = prepare

    def is_over(self, caller: asyncio.Task[Any], /) -> bool:
        """Return whether a task has ended."""
        return caller.done()

    def create_lone_future(self) -> LoneFuture:
        """Return what a call can await whose request is alone in flight."""
        future = LoneFuture(self._loop, self._spinner, self.ended)
        self._asked_at = self._spinner.begin(self._loop)
        return future

    def wake(self) -> None:
        """Resume the tasks whose lone requests are done."""
        ended = self.ended
        self._spinner.end(self._loop, self._asked_at)
        while ended:
            ended.pop(0).wake()

    def call_at(self, when: float, function: Callable[[], object], /) -> Timer:
        """Call a function at a time of the loop's clock."""
        short = when < self._loop.time() + SHORTEST_SLEEP
        return _ShortTimer(self._loop, when, function) if short else self._loop.call_at(when, function)

    async def finish(self, job: Job) -> None:
        """Cancel a task, and wait until it has ended."""
        job.cancel()
        await asyncio.wait([cast("asyncio.Task[None]", job)])

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Connect a stream to a medium."""
        await open_medium(target, stream)

    def attend(self) -> None:
        """Do nothing: an event loop takes what arrives."""

    def leave(self) -> None:
        """Do nothing."""
