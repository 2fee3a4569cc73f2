"""The interface between a link and the program's kind of concurrency: clock, timers, futures and tasks.

The coroutines of `Connection` and `Link` are the same in every kind of program. `AsyncioRuntime` runs them in the event
loop of the caller, `calling_thread` in the threads of blocking code, and `trio_runtime` in tasks of trio.
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
"""Timers due in less than this many seconds are polled, because an event loop sleeps whole milliseconds."""


_UNADJUSTED = getattr(time, "CLOCK_MONOTONIC_RAW", None)


def unadjusted_time() -> float:
    """Return ``CLOCK_MONOTONIC_RAW`` in seconds, or `time.perf_counter` if the system does not have that clock.

    Its rate is that of the machine's quartz. Network time services change the rates of other clocks, by up to 10 %.
    """
    return time.perf_counter() if _UNADJUSTED is None else time.clock_gettime(_UNADJUSTED)


def report(message: str, error: BaseException) -> None:
    """Log an error that no call can raise: from a callback of the program, or from a background task of the link."""
    log.error(message, exc_info=error)


class Waiter(Protocol):
    """Future of a call: the part of `asyncio.Future` that links use."""

    def done(self) -> bool:
        """Return whether the future has a result or an error, or was cancelled."""

    def cancelled(self) -> bool:
        """Return whether the future was cancelled."""

    def cancel(self) -> bool:
        """Cancel the future; return False if it was done before."""

    def set_result(self, result: object, /) -> None:
        """Set the result, and resume the awaiting call."""

    def set_exception(self, exception: BaseException, /) -> None:
        """Set an error, which the awaiting call raises."""

    def exception(self) -> BaseException | None:
        """Return the error of a future that is done, or None."""

    def __await__(self) -> Generator[Any, Any, Any]:
        """Wait until the future is done; return its result or raise its error."""


class Timer(Protocol):
    """A call that is scheduled for an instant."""

    def cancel(self) -> None:
        """Cancel the call."""


class Job(Protocol):
    """A background task of a link."""

    def cancel(self) -> object:
        """Cancel the task at its next wait."""


class Runtime(Protocol):
    """The interface of a runtime."""

    @property
    def ended(self) -> Sequence[object]:
        """Inline futures that are done, and whose tasks `wake` will resume."""

    def time(self) -> float:
        """Return the time in seconds, from any origin."""

    def steady(self) -> float:
        """Return the time in seconds of a clock that no time service adjusts; on simulated time, the simulated time."""

    def caller(self) -> object:
        """Return the current task or thread; None outside of both."""

    def is_over(self, caller: Any, /) -> bool:
        """Return whether a task or thread has ended."""

    def create_future(self) -> Waiter:
        """Return a new future."""

    def create_inline_future(self) -> Waiter:
        """Return a new future for a single outstanding request, whose task `wake` resumes."""

    def wake(self) -> None:
        """Resume the tasks that await inline futures which are done."""

    def call_soon(self, function: Callable[[], object], /) -> object:
        """Call a function after the current task or call waits."""

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> object:
        """As `call_soon`, from any thread."""

    def call_at(self, when: float, function: Callable[[], object], /) -> Timer:
        """Call a function at an instant of the clock `time`."""

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> Job:
        """Run a coroutine as a background task."""

    async def finish(self, job: Job) -> None:
        """Cancel a background task, and wait until it has ended."""

    async def sleep(self, seconds: float) -> None:
        """Wait for a duration."""

    def timeout(self, seconds: float) -> AbstractAsyncContextManager[object]:
        """Return a context manager whose block raises `TimeoutError` after `seconds`."""

    def last_timeout(self, seconds: float) -> AbstractAsyncContextManager[object]:
        """As `timeout`, for cleaning up after a cancellation: the block may wait although its task is cancelled."""

    async def prepare(self, url: DriverUrl) -> None:
        """Run the one-time preparation of a medium's driver, before a medium of this kind is opened."""

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Open a medium, and connect a stream to it."""

    def start_polling(self) -> None:
        """Process received bytes also while no call waits, until `stop_polling` is called as often."""

    def stop_polling(self) -> None:
        """End the effect of one call of `start_polling`."""


def raises_now(runtime: Runtime, caller: object) -> Callable[[object], bool]:
    """Return a function that decides if the error of a posted write is raised in a call of `caller`.

    The function takes the task or thread that posted the write, or None. A task gets the errors of its own posted
    writes, and those of tasks that have ended.
    """
    is_over = runtime.is_over
    return lambda poster: poster is None or poster is caller or is_over(poster)


class _ShortTimer:
    """A timer that is checked in each turn of the event loop, for times shorter than the loop can sleep.

    Args:
        loop: the event loop.
        when: instant of the call.
        function: the function to call.
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
            # The clock is simulated: it advances only while all tasks wait, so use a timer of the loop.
            self._handle = self._loop.call_at(self._when, self._function)


class InlineFuture(Result):
    """Future of a single outstanding request. `wake` resumes its task at once, without a turn of the event loop.

    A future of asyncio resumes its task in the next turn, which costs a second poll for each answer. This class has all
    that tasks use of a future (`asyncio.isfuture`). If many requests are in flight, their answers share the turns, and
    asyncio's futures are faster.

    Args:
        loop: event loop of the task.
        spinner: spinner of the loop.
        ended: list to which the future appends itself when it is done.
    """

    __slots__ = ("_asyncio_future_blocking", "_context", "_ended", "_loop", "_spinner", "_step")

    def __init__(self, loop: asyncio.AbstractEventLoop, spinner: _LoopSpinner, ended: list[InlineFuture]) -> None:
        # The same as in `Result.__init__`, inlined because every read runs it.
        self._done = self._asyncio_future_blocking = False
        self._result = self._error = None
        self._loop = loop
        self._spinner = spinner
        spinner.awaited += 1
        self._ended = ended
        self._step: Callable[[InlineFuture], object] | None = None
        """Resumes the awaiting task; None before it awaits."""
        self._context: Context | None = None

    def __await__(self) -> Generator[InlineFuture, None, Any]:
        """Wait until the future is done; return its result or raise its error."""
        if not self._done:
            self._asyncio_future_blocking = True
            yield self
        return self.result()

    def _end(self) -> None:
        self._done = True
        self._spinner.awaited -= 1
        self._ended.append(self)

    def wake(self) -> None:
        """Resume the task now, or in the next turn of the loop if another task is running."""
        step, context = self._step, self._context
        if step is None or context is None:
            # The task does not await the future yet, and will find it done.
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

    # Called by tasks

    def get_loop(self) -> asyncio.AbstractEventLoop:
        """Return the event loop of the task."""
        return self._loop

    def add_done_callback(self, function: Callable[[InlineFuture], object], /, *, context: Context) -> None:
        """Store the function that resumes the task."""
        self._step, self._context = function, context

    def cancel(self, msg: str | None = None) -> bool:
        """Cancel the future, because its task was cancelled; return False if it was done before."""
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
    """Keeps an event loop awake while the answer to a single outstanding request may arrive soon (`transport.polling`).

    All links of a loop share one spinner. If several requests are outstanding, it does nothing, because the loop is
    busy anyway. The loop is an argument of its methods, so that the spinner does not keep it alive.
    """

    def __init__(self) -> None:
        self._spinning = Spinning()
        self.awaited = 0
        """Number of outstanding inline futures on the loop."""
        self._is_planned = False
        """True if `_look` is scheduled for the next turn."""
        self._until = self._looked_at = 0.0

    def begin(self, loop: asyncio.AbstractEventLoop) -> float:
        """Begin to spin for a request that is sent now; return the time, for `end`."""
        self._looked_at = now = _time_of(loop)
        self._until = now + SPIN
        if self._spinning.left and self.awaited == 1 and not self._is_planned:
            self._is_planned = True
            loop.call_soon(self._look, loop)
        return now

    def end(self, loop: asyncio.AbstractEventLoop, began: float) -> None:
        """Record the arrival of the answer to a request that was sent at the instant `began`."""
        self._spinning.record(_time_of(loop) - began)

    def _look(self, loop: asyncio.AbstractEventLoop) -> None:
        now = _time_of(loop)
        # Stop if the time has not advanced: a simulated clock advances only while all tasks wait.
        self._is_planned = self.awaited == 1 and self._looked_at < now < self._until
        if self._is_planned:
            self._looked_at = now
            loop.call_soon(self._look, loop)


def _caller_of(loop: asyncio.AbstractEventLoop) -> Callable[[], asyncio.Task[Any] | None]:
    """Return a function that returns the current task of a loop, or None outside of tasks and in other threads.

    A program may call a link's method in another thread, for `asyncio.run_coroutine_threadsafe`. The task that the loop
    runs at that moment is not the caller.
    """
    current: Any = asyncio.current_task
    if sys.version_info < (3, 12):
        # There `current_task` is written in Python, and would take a tenth of the time of a posted write.
        current = asyncio.tasks._current_tasks.get  # type: ignore[attr-defined]  # noqa: SLF001
    running = asyncio._get_running_loop  # noqa: SLF001
    return lambda: current(loop) if running() is loop else None


def _time_of(loop: asyncio.AbstractEventLoop) -> float:
    """Return the time of a loop in seconds, more precisely than uvloop, whose clock has a resolution of 1 ms."""
    return loop.time() if isinstance(loop, asyncio.BaseEventLoop) else time.monotonic()


_spinners: WeakKeyDictionary[asyncio.AbstractEventLoop, _LoopSpinner] = WeakKeyDictionary()


class AsyncioRuntime:
    """Runtime of a link in the running event loop of asyncio."""

    def __init__(self) -> None:
        loop = asyncio.get_running_loop()
        # Use the loop's methods directly, so that no further call is needed for each of them.
        is_monotonic = getattr(loop.time, "__func__", None) is asyncio.BaseEventLoop.time
        self.time = time.monotonic if is_monotonic else loop.time
        # A loop of asyncio with another clock simulates time.
        models_time = isinstance(loop, asyncio.BaseEventLoop) and not is_monotonic
        self.steady = loop.time if models_time else unadjusted_time
        self.create_future = loop.create_future
        self.call_soon = loop.call_soon
        self.call_soon_threadsafe = loop.call_soon_threadsafe
        self._loop = loop
        self.ended: list[InlineFuture] = []
        """Inline futures that are done, and whose tasks `wake` will resume."""
        self._spinner = _spinners.setdefault(loop, _LoopSpinner())
        self._asked_at = 0.0
        """Instant at which the last single outstanding request was sent."""
        self.create_task = loop.create_task
        self.caller = _caller_of(loop)
        self.timeout = self.last_timeout = asyncio.timeout
        self.sleep = asyncio.sleep
        self.prepare = prepare

    def is_over(self, caller: asyncio.Task[Any], /) -> bool:
        """Return whether a task has ended."""
        return caller.done()

    def create_inline_future(self) -> InlineFuture:
        """Return a new future for a single outstanding request, whose task `wake` resumes."""
        future = InlineFuture(self._loop, self._spinner, self.ended)
        self._asked_at = self._spinner.begin(self._loop)
        return future

    def wake(self) -> None:
        """Resume the tasks that await inline futures which are done."""
        ended = self.ended
        self._spinner.end(self._loop, self._asked_at)
        while ended:
            ended.pop(0).wake()

    def call_at(self, when: float, function: Callable[[], object], /) -> Timer:
        """Call a function at an instant of the loop's clock."""
        short = when < self._loop.time() + SHORTEST_SLEEP
        return _ShortTimer(self._loop, when, function) if short else self._loop.call_at(when, function)

    async def finish(self, job: Job) -> None:
        """Cancel a task, and wait until it has ended."""
        job.cancel()
        await asyncio.wait([cast("asyncio.Task[None]", job)])

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Open a medium, and connect a stream to it."""
        await open_medium(target, stream)

    def start_polling(self) -> None:
        """Do nothing, because an event loop processes received bytes at any time."""

    def stop_polling(self) -> None:
        """Do nothing."""
