"""A link under trio: its coroutines run in the program's tasks, and what goes on beside them in a task group of anyio.

The task group is that of the ``async with`` block of the link, and ends with it. A medium with a file descriptor is
waited for by anyio; another one is opened in the thread of an event loop (`loop_thread`).
"""

from __future__ import annotations

import inspect
import math
from collections import deque
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from typing import TYPE_CHECKING, Any, Self

import anyio
import anyio.lowlevel
from anyio.from_thread import BlockingPortal

from unity_link.link.loop_thread import Relay, run_in_loop
from unity_link.link.runtime import report, unadjusted_time
from unity_link.link.synchronisation import STRUCTURED
from unity_link.link.timers import Timers
from unity_link.link.waiter import Result
from unity_link.transport import DriverUrl, has_channel, load_driver, observed, open_channel
from unity_link.transport import prepare as prepare_medium
from unity_link.transport.channel_transport import make_transport
from unity_link.transport.polling import READABLE, WRITABLE

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Awaitable, Callable, Coroutine, Generator

    import trio

    from unity_link.link.runtime import Job
    from unity_link.transport import Medium
    from unity_link.transport.stream import Stream


class TaskWaiter(Result):
    """Awaitable of a call."""

    __slots__ = ("_event",)

    def __init__(self) -> None:
        super().__init__()
        self._event: anyio.Event | None = None

    def __await__(self) -> Generator[Any, Any, Any]:
        """Wait, and return the result or raise the error."""
        if not self._done:
            self._event = self._event or anyio.Event()
            self.on_done = self._event.set
            yield from self._event.wait().__await__()
        return self.result()


class _TaskJob:
    """A coroutine that runs beside the calls."""

    def __init__(self, runtime: Structured, coroutine: Coroutine[Any, Any, None]) -> None:
        self._runtime = runtime
        self._coroutine = coroutine
        self._scope = anyio.CancelScope()
        self.ended = anyio.Event()

    async def run(self) -> None:
        """Run until the end."""
        try:
            with self._scope:
                await self._coroutine
        except Exception as error:  # noqa: BLE001  (no call is there that could raise it)
            report("what runs beside the calls of a link has failed", error)
        finally:
            self.ended.set()

    def cancel(self) -> None:
        """End it at its next wait."""
        self._scope.cancel()


class Structured:
    """Runs the coroutines of one link in the tasks of a program, within an ``async with`` block."""

    def __init__(self) -> None:
        self.time = anyio.current_time
        # Only a program that runs under trio has it for sure.
        import trio

        # Another clock than the system's models time.
        is_real = type(trio.lowlevel.current_clock()).__name__ == "SystemClock"
        self.steady = unadjusted_time if is_real else anyio.current_time
        self.caller = trio.lowlevel.current_task
        self.create_future = self.create_lone_future = TaskWaiter
        self.ended = ()
        self.sleep = anyio.sleep
        self._ready: deque[Callable[[], object]] = deque()
        self._stirred = anyio.Event()
        self._timers = Timers(self.time, self._stir)
        self.call_at = self._timers.call_at
        self._tasks = anyio.create_task_group()
        self._portal = BlockingPortal()
        self._exits = AsyncExitStack()
        self._watches: dict[int, anyio.CancelScope] = {}
        self._relays: list[Relay] = []

    async def __aenter__(self) -> Self:
        await self._exits.enter_async_context(self._portal)
        await self._exits.enter_async_context(self._tasks)
        self._tasks.start_soon(self._run_due)
        self._outer = STRUCTURED.set(self)
        return self

    async def aclose(self) -> None:
        """End what runs beside the program's tasks, when the link has ended."""
        STRUCTURED.reset(self._outer)
        with anyio.CancelScope(shield=True):
            for relay in self._relays:
                await anyio.to_thread.run_sync(relay.join, None)
        self._tasks.cancel_scope.cancel()
        # They do not get to know an error that the block has raised: they would make a group of it.
        await self._exits.aclose()

    async def _run_due(self) -> None:
        while True:
            # Not what these have called soon: other tasks have their turns before.
            for _ in range(len(self._ready)):
                self._ready.popleft()()
            if self.time() >= self._timers.due:
                self._timers.run()
            if self._ready:
                await anyio.lowlevel.checkpoint()
                continue
            self._stirred = anyio.Event()
            with anyio.move_on_at(self._timers.due):
                await self._stirred.wait()

    def _stir(self) -> None:
        self._stirred.set()

    # What coroutines of the link need

    def is_over(self, caller: trio.lowlevel.Task, /) -> bool:
        """Return whether a task has ended."""
        return inspect.getcoroutinestate(caller.coro) == inspect.CORO_CLOSED

    def call_soon(self, function: Callable[[], object], /) -> None:
        """Call a function when what runs now waits."""
        self._ready.append(function)
        self._stir()

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> None:
        """Call a function soon; may be called by other threads."""
        self._ready.append(function)
        self._portal.start_task_soon(self._stir)

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> _TaskJob:
        """Run a coroutine beside the calls."""
        job = _TaskJob(self, coroutine)
        self._tasks.start_soon(job.run)
        return job

    def wake(self) -> None:
        """Do nothing: who awaits something goes on by itself."""

    async def finish(self, job: Job) -> None:
        """Cancel a job, and wait until it has ended."""
        assert isinstance(job, _TaskJob)
        job.cancel()
        await job.ended.wait()

    @asynccontextmanager
    async def timeout(self, seconds: float) -> AsyncIterator[None]:
        """Raise TimeoutError in the block after some time."""
        with anyio.fail_after(seconds):
            yield

    def attend(self) -> None:
        """Do nothing: a task takes what arrives."""

    def leave(self) -> None:
        """Do nothing."""

    # Media

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler where a file descriptor is ready for some of `READABLE` and `WRITABLE`."""
        self._cancel_watch(descriptor)
        scope = self._watches[descriptor] = anyio.CancelScope()
        self._tasks.start_soon(self._watch, scope, descriptor, events, handler)

    def unwatch(self, descriptor: int) -> None:
        """Call no handler any more, for it is to be closed."""
        self._cancel_watch(descriptor)
        anyio.notify_closing(descriptor)

    def _cancel_watch(self, descriptor: int) -> None:
        scope = self._watches.pop(descriptor, None)
        if scope is not None:
            scope.cancel()

    async def _watch(
        self, scope: anyio.CancelScope, descriptor: int, events: int, handler: Callable[[int], None]
    ) -> None:
        with scope:
            async with anyio.create_task_group() as both:
                for event, wait in ((READABLE, anyio.wait_readable), (WRITABLE, anyio.wait_writable)):
                    if events & event:
                        both.start_soon(_call_when_ready, scope, wait, descriptor, handler, event)

    async def prepare(self, url: DriverUrl) -> None:
        """Do what must be done once before a medium of this kind can be opened."""
        if hasattr(load_driver(url.scheme), "prepare"):
            await anyio.to_thread.run_sync(run_in_loop, lambda: prepare_medium(url))

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Connect a stream to a medium."""
        if has_channel(target):
            protocol = observed(target, stream)
            patience = anyio.current_effective_deadline() - self.time()
            timeout = None if patience == math.inf else max(0.001, patience)
            make_transport(self, await anyio.to_thread.run_sync(open_channel, target, timeout), protocol)
            return
        relay = Relay(self, target, stream)
        self._relays = [other for other in self._relays if not other.has_ended] + [relay]
        await relay.open()


async def _call_when_ready(
    scope: anyio.CancelScope,
    wait: Callable[[int], Awaitable[None]],
    descriptor: int,
    handler: Callable[[int], None],
    event: int,
) -> None:
    with suppress(anyio.ClosedResourceError):
        # A descriptor that the handler has closed cannot be waited for.
        while not scope.cancel_called:
            await wait(descriptor)
            handler(event)
