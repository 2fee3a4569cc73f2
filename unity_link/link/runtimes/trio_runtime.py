"""The runtime of a link under trio: its coroutines run in the program's tasks, and its background tasks in a nursery.

The nursery belongs to the ``async with`` block of the link, and ends with it. Its tasks are shielded from cancellation
until the block ends, so that a `finally` in a cancelled block can still write. trio waits for a medium with a file
descriptor; another medium is opened in an event loop of another thread (`loop_thread`).
"""

from __future__ import annotations

import inspect
import math
import sys
from _thread import get_ident
from collections import deque
from contextlib import asynccontextmanager, suppress
from typing import TYPE_CHECKING, Any

import trio

from unity_link.link.interrupts import DEFERRED
from unity_link.link.runtimes.loop_thread import Relay, run_in_loop
from unity_link.link.runtimes.runtime import report, unadjusted_time
from unity_link.link.runtimes.synchronisation import STRUCTURED
from unity_link.link.runtimes.timers import Timers
from unity_link.link.runtimes.waiter import Result
from unity_link.transport import DriverUrl, has_channel, load_driver, observed, open_channel
from unity_link.transport import prepare as prepare_medium
from unity_link.transport.channel_transport import make_transport
from unity_link.transport.polling import READABLE, WRITABLE

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Awaitable, Callable, Coroutine, Generator
    from contextvars import Token
    from types import FrameType

    from unity_link.link.interrupts import Handler
    from unity_link.link.runtimes.runtime import Job, Runtime
    from unity_link.transport import Medium
    from unity_link.transport.stream import Stream


_TRIO = trio.__file__.removesuffix("__init__.py")
"""First characters of the file names of trio's code."""


class TaskWaiter(Result):
    """Future of a call."""

    __slots__ = ("_event",)

    def __init__(self) -> None:
        super().__init__()
        self._event: trio.Event | None = None

    def __await__(self) -> Generator[Any, Any, Any]:
        """Wait until the future is done; return its result or raise its error."""
        if not self._done:
            self._event = self._event or trio.Event()
            self.on_done = self._event.set
            yield from self._event.wait().__await__()
        return self.result()


class _TaskJob:
    """A background task."""

    def __init__(self, runtime: Structured, coroutine: Coroutine[Any, Any, None]) -> None:
        self._coroutine = coroutine
        self.ended = trio.Event()
        self._scope = runtime.new_scope()
        runtime.serve(self._scope, self._run)

    async def _run(self) -> None:
        """Run the coroutine, and log its error."""
        try:
            await self._coroutine
        except Exception as error:  # noqa: BLE001  (no call is there that could raise it)
            report("a background task of a link has failed", error)
        finally:
            self.ended.set()

    def cancel(self) -> None:
        """Cancel the task at its next wait."""
        self._scope.cancel()


class Structured:
    """Runs the coroutines of one link in the tasks of a program, within an ``async with`` block."""

    def __init__(self) -> None:
        # Another clock than trio's SystemClock simulates time.
        is_real = type(trio.lowlevel.current_clock()).__name__ == "SystemClock"
        self.steady = unadjusted_time if is_real else trio.current_time
        self.caller = trio.lowlevel.current_task
        self.create_future = self.create_inline_future = TaskWaiter
        self.ended = ()
        self.sleep = trio.sleep
        self._defers = get_ident() == DEFERRED.thread
        """True if signal handlers run in this thread."""
        self._token = trio.lowlevel.current_trio_token()
        self._ready: deque[Callable[[], object]] = deque()
        self._stirred = trio.Event()
        self._timers = Timers(self.time, self._stir)
        self.call_at = self._timers.call_at
        self._outer: Token[Runtime] | None = None
        self._block = trio.open_nursery()
        self._nursery: trio.Nursery | None = None
        self._services: set[trio.CancelScope] = set()
        """Cancel scopes of the background tasks."""
        self._watches: dict[int, trio.CancelScope] = {}
        self._relays: list[Relay] = []

    async def begin(self) -> None:
        """Begin the block. The caller must call `aclose` even if this raises an error."""
        DEFERRED.begin(self)
        self._outer = STRUCTURED.set(self)
        self._nursery = await self._block.__aenter__()
        self.serve(self.new_scope(), self._run_due)

    async def aclose(self) -> None:
        """End the background tasks and threads, after the link has ended."""
        if self._outer is not None:
            STRUCTURED.reset(self._outer)
        try:
            with trio.CancelScope(shield=True):
                for relay in self._relays:
                    await trio.to_thread.run_sync(relay.join, None)
        finally:
            for scope in self._services:
                scope.cancel()
            try:
                if self._nursery is not None:
                    # Do not pass the error of the block: the nursery would wrap it in an exception group.
                    await self._block.__aexit__(None, None, None)
            except BaseExceptionGroup as group:
                raise _first(group) from None
            finally:
                DEFERRED.end(self)

    def new_scope(self) -> trio.CancelScope:
        """Return a shielded cancel scope for a background task, which is cancelled at the end of the block."""
        scope = trio.CancelScope(shield=True)
        self._services.add(scope)
        return scope

    def serve(self, scope: trio.CancelScope, function: Callable[..., Awaitable[None]], *arguments: Any) -> None:
        """Run a coroutine function as a background task, in a scope of `new_scope`."""
        assert self._nursery is not None
        self._nursery.start_soon(self._run_service, scope, function, arguments)

    async def _run_service(
        self, scope: trio.CancelScope, function: Callable[..., Awaitable[None]], arguments: tuple[object, ...]
    ) -> None:
        with scope:
            await function(*arguments)
        self._services.discard(scope)

    # Signal handlers

    def interrupt(self) -> None:
        """Wake the task that calls the pending signal handlers; called in a signal handler."""
        self._token.run_sync_soon(self._stir, idempotent=True)

    def is_protected(self, frame: FrameType | None, /) -> bool:
        """Return whether a signal interrupted trio's own code, or a function that it has called.

        trio protects its loop, but not its functions that a task calls. An exception within `start_soon`, for example,
        would leave a task that never runs, and its nursery would wait for it without end.
        """
        return trio.lowlevel.currently_ki_protected() or _is_called_by_trio(frame)

    def time(self) -> float:
        """Return the time of trio's clock in seconds; also defer new signal handlers, because each step begins here."""
        if self._defers:
            DEFERRED.replace()
        return trio.current_time()

    def _deliver(self) -> None:
        assert self._nursery is not None
        while DEFERRED.pending:
            # In a task of the nursery, an exception of a handler ends the block but not the background tasks.
            self._nursery.start_soon(_call_handler, *DEFERRED.pending.popitem())

    async def _run_due(self) -> None:
        while True:
            # Leave functions that these add for the next turn, so that other tasks run in between.
            for _ in range(len(self._ready)):
                self._ready.popleft()()
            if self.time() >= self._timers.due:
                self._timers.run()
            if self._defers:
                self._deliver()
            if self._ready:
                await trio.lowlevel.checkpoint()
                continue
            self._stirred = trio.Event()
            with trio.move_on_at(self._timers.due):
                await self._stirred.wait()

    def _stir(self) -> None:
        self._stirred.set()

    # The methods of a `Runtime`

    def is_over(self, caller: trio.lowlevel.Task, /) -> bool:
        """Return whether a task has ended."""
        return inspect.getcoroutinestate(caller.coro) == inspect.CORO_CLOSED

    def call_soon(self, function: Callable[[], object], /) -> None:
        """Call a function after the current task waits."""
        self._ready.append(function)
        self._stir()

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> None:
        """As `call_soon`, from any thread."""
        self._ready.append(function)
        self._token.run_sync_soon(self._stir, idempotent=True)

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> _TaskJob:
        """Run a coroutine as a background task."""
        return _TaskJob(self, coroutine)

    def wake(self) -> None:
        """Do nothing, because tasks resume when their future is done."""

    async def finish(self, job: Job) -> None:
        """Cancel a background task, and wait until it has ended."""
        assert isinstance(job, _TaskJob)
        job.cancel()
        await job.ended.wait()

    @asynccontextmanager
    async def timeout(self, seconds: float) -> AsyncIterator[None]:
        """Raise `TimeoutError` in the block after `seconds`."""
        with trio.move_on_after(seconds) as scope:
            yield
        if scope.cancelled_caught:
            raise TimeoutError

    @asynccontextmanager
    async def last_timeout(self, seconds: float) -> AsyncIterator[None]:
        """As `timeout`, for a block that may wait although its task is cancelled."""
        with trio.CancelScope(shield=True):
            async with self.timeout(seconds):
                yield

    def start_polling(self) -> None:
        """Do nothing, because a background task processes received bytes at any time."""

    def stop_polling(self) -> None:
        """Do nothing."""

    # Media

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler whenever a file descriptor is ready for some of `events` (`READABLE`, `WRITABLE`)."""
        self._cancel_watch(descriptor)
        scope = self._watches[descriptor] = self.new_scope()
        self.serve(scope, self._watch, scope, descriptor, events, handler)

    def unwatch(self, descriptor: int) -> None:
        """Stop watching a file descriptor, because it is about to be closed."""
        self._cancel_watch(descriptor)
        trio.lowlevel.notify_closing(descriptor)

    def _cancel_watch(self, descriptor: int) -> None:
        scope = self._watches.pop(descriptor, None)
        if scope is not None:
            scope.cancel()

    async def _watch(
        self, scope: trio.CancelScope, descriptor: int, events: int, handler: Callable[[int], None]
    ) -> None:
        async with trio.open_nursery() as both:
            for event, wait in ((READABLE, trio.lowlevel.wait_readable), (WRITABLE, trio.lowlevel.wait_writable)):
                if events & event:
                    both.start_soon(_call_when_ready, scope, wait, descriptor, handler, event)

    async def prepare(self, url: DriverUrl) -> None:
        """Run the one-time preparation of a medium's driver, before a medium of this kind is opened."""
        if hasattr(load_driver(url.scheme), "prepare"):
            await trio.to_thread.run_sync(run_in_loop, lambda: prepare_medium(url))

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Open a medium, and connect a stream to it."""
        if has_channel(target):
            protocol = observed(target, stream)
            patience = trio.current_effective_deadline() - self.time()
            timeout = None if patience == math.inf else max(0.001, patience)
            make_transport(self, await trio.to_thread.run_sync(open_channel, target, timeout), protocol)
            return
        relay = Relay(self, target, stream)
        self._relays = [other for other in self._relays if not other.has_ended] + [relay]
        await relay.open()


async def _call_when_ready(
    scope: trio.CancelScope,
    wait: Callable[[int], Awaitable[None]],
    descriptor: int,
    handler: Callable[[int], None],
    event: int,
) -> None:
    with suppress(trio.ClosedResourceError):
        # The handler may close the descriptor and cancel the scope: check before each wait.
        while not scope.cancel_called:
            await wait(descriptor)
            handler(event)


@trio.lowlevel.enable_ki_protection
async def _call_handler(number: int, handler: Handler) -> None:
    """Call a signal handler. trio's handler sees protected code interrupted, so it raises in the main task."""
    handler(number, sys._getframe())  # noqa: SLF001  (documented, and as the interpreter calls handlers)


def _is_called_by_trio(frame: FrameType | None) -> bool:
    """Return whether a frame, or one of its callers up to the innermost coroutine, is trio's code."""
    while frame is not None:
        if frame.f_code.co_filename.startswith(_TRIO):
            return True
        if frame.f_code.co_flags & inspect.CO_COROUTINE:
            return False
        frame = frame.f_back
    return False


def _first(error: BaseException) -> BaseException:
    """Return the first error of an exception group; another error is returned itself."""
    while isinstance(error, BaseExceptionGroup):
        error = error.exceptions[0]
    return error
