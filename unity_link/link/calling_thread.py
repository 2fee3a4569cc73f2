"""A link without an event loop: its coroutines run in the threads that call it.

A call runs until it has to wait, and then polls the medium itself. Where several threads wait, one of them polls for
all, and hands over to another when its own call is done. While there is a subscription, or a lost connection is being
opened again, a thread of the link's own polls, and runs the coroutine that opens it: so none changes threads, and none
is in the way of a Ctrl-C. A medium that only an event loop can open is opened in the thread of one (`loop_thread`).
"""

from __future__ import annotations

import asyncio
import inspect
import os
import socket
import threading
import time
from collections import deque
from contextlib import asynccontextmanager, suppress
from typing import TYPE_CHECKING, Any, Never, ParamSpec, TypeVar

from unity_link.errors import ArgumentError
from unity_link.link.connection import forked
from unity_link.link.loop_thread import Relay, run_in_loop
from unity_link.link.runtime import report, unadjusted_time
from unity_link.link.synchronisation import CALLING
from unity_link.link.timers import Timers
from unity_link.link.waiter import Result
from unity_link.transport import DriverUrl, has_channel, load_driver, observed, open_channel
from unity_link.transport import prepare as prepare_medium
from unity_link.transport.channel_transport import make_transport
from unity_link.transport.polling import READABLE, Poller

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Generator

    from unity_link.link.runtime import Job
    from unity_link.transport import Medium
    from unity_link.transport.stream import Stream

P = ParamSpec("P")
T = TypeVar("T")
LONGEST_WAIT = 1e9
"""Seconds that a socket can be told to wait, at most; some thirty years, so a longer time is none."""


class CallWaiter(Result):
    """Awaitable of a call."""

    __slots__ = ()

    def __await__(self) -> Generator[CallWaiter, None, Any]:
        """Wait, and return the result or raise the error."""
        if not self._done:
            yield self
        return self.result()


class _Run:
    """A coroutine under way."""

    __slots__ = ("deadline", "waiter")

    def __init__(self) -> None:
        self.waiter: CallWaiter | None = None
        """Waiter that it waits for, or waited for last."""
        self.deadline: float | None = None
        """Instant at which the innermost `timeout` around it ends."""


class _Job(_Run):
    """A coroutine that runs beside the calls, in the link's own thread."""

    __slots__ = ("_cancelled", "_coroutine", "_runtime", "ended")

    def __init__(self, runtime: CallingThread, coroutine: Coroutine[CallWaiter, None, None]) -> None:
        super().__init__()
        self._runtime = runtime
        self._coroutine = coroutine
        self._cancelled = False
        self.ended = CallWaiter()

    def step(self) -> None:
        """Run until the next wait."""
        try:
            self._runtime.running = self
            waiter = self.waiter = self._coroutine.send(None)
        except (StopIteration, asyncio.CancelledError):
            self._end()
        except Exception as error:  # noqa: BLE001  (no call is there that could raise it)
            self._end()
            report("what runs beside the calls of a link has failed", error)
        else:
            waiter.on_done = lambda: self._runtime.go_on(self)
            if self._cancelled:
                waiter.cancel()

    def cancel(self) -> None:
        """End it at its next wait."""
        self._cancelled = True
        if self.waiter is not None:
            self.waiter.cancel()

    def _end(self) -> None:
        self.ended.set_result(None)
        self._runtime.leave()


def _refuse() -> Never:
    raise forked()


def _wake(parked: threading.Lock) -> None:
    if parked.locked():
        parked.release()


class CallingThread:
    """Runs the coroutines of one link in the threads that call it. All its methods but `run` are for these coroutines.

    Whoever runs holds the lock, and gives it away to poll or to wait for another thread that polls.
    """

    def __init__(self) -> None:
        self.time = time.monotonic
        self.steady = unadjusted_time
        self.create_future = self.create_lone_future = CallWaiter
        self.ended = ()
        self.caller = threading.current_thread
        self._lock = threading.RLock()
        self.is_running_here: Callable[[], bool] = self._lock._is_owned  # type: ignore[attr-defined]  # noqa: SLF001
        """True if this thread runs something of the link now."""
        self._polling = False
        """True if a thread polls, for all."""
        self._poller = Poller()
        self._parked: list[threading.Lock] = []
        """One for each thread that waits for another; to release it wakes the thread."""
        self._ready: deque[Callable[[], object]] = deque()
        self._timers = Timers(self.time, self._stir)
        self.call_at = self._timers.call_at
        self._handlers: dict[int, Callable[[int], None]] = {}
        self.running = _Run()
        """Call that runs now."""
        self._relays: list[Relay] = []
        self.is_disowned = False
        """True if this process was forked from the one that the link is of."""
        self._closed = False
        self._attended = 0
        self._attendant: threading.Thread | None = None
        self._resting: threading.Lock | None = None
        """Lock in `_parked` that the attendant waits for."""
        self._jobs: deque[_Job] = deque()
        """Those that the attendant is to run until their next wait."""
        self._waking, self._woken = socket.socketpair()
        for end in (self._waking, self._woken):
            end.setblocking(False)  # noqa: FBT003  (it has no name)
        self.watch(self._woken.fileno(), READABLE, self._empty)
        CALLING.add(self)

    def disown(self) -> None:
        """Refuse all calls: what polls, and who holds the lock, is in the process from which this one was forked."""
        self.is_disowned = True
        self.is_running_here = _refuse

    def is_over(self, caller: threading.Thread, /) -> bool:
        """Return whether a thread has ended."""
        return not caller.is_alive()

    # Calls

    def run(self, function: Callable[P, Coroutine[Any, Any, T]], *arguments: P.args, **options: P.kwargs) -> T:
        """Run a coroutine function of the link in this thread, and return its result.

        Raises:
            ArgumentError: in a callback of the link, which runs within another call.
        """
        if self.is_running_here():
            raise ArgumentError("a callback runs within a call of its link, and must not call the link")
        run = _Run()
        error: BaseException | None = None
        with self._lock:
            coroutine = function(*arguments, **options)
            try:
                while True:
                    try:
                        self.running = run
                        waiter = run.waiter = coroutine.send(None) if error is None else coroutine.throw(error)
                        error = None
                        self._wait(waiter)
                    except StopIteration as end:
                        result: T = end.value
                        return result
                    except BaseException as interruption:
                        if inspect.getcoroutinestate(coroutine) == inspect.CORO_CLOSED:
                            # The coroutine itself has raised it.
                            raise
                        error = interruption
                        self._take_lock()
            finally:
                try:
                    if self._ready:
                        self._run_ready()
                finally:
                    if self._parked or self._closed:
                        self._hand_over()

    def _wait(self, waiter: CallWaiter) -> None:
        """Poll, or have another thread poll, until there is a result."""
        if self._ready:
            self._run_ready()
        # Another thread may end what this one polls for.
        waiter.on_done = self._stir
        while not waiter.done():
            if self._polling:
                self._park(waiter)
            else:
                self._poll_once(may_spin=True)
            if self._ready:
                self._run_ready()

    def _park(self, waiter: CallWaiter | None) -> None:
        """Wait until another thread has polled a result, or none polls."""
        parked = threading.Lock()
        parked.acquire()
        if waiter is None:
            self._resting = parked
            self._parked.insert(0, parked)
        else:
            self._parked.append(parked)
            waiter.on_done = lambda: _wake(parked)
        try:
            self._lock.release()
            parked.acquire()
        finally:
            try:
                self._take_lock()
            finally:
                self._parked.remove(parked)
                if waiter is None:
                    self._resting = None
                else:
                    waiter.on_done = self._stir

    def _hand_over(self) -> None:
        """Wake another thread, to poll in place of this one."""
        if self._polling:
            return
        if self._parked:
            _wake(self._parked[0])
        elif self._closed and self._attendant is None and self._woken.fileno() in self._handlers:
            self.unwatch(self._woken.fileno())
            self._waking.close()
            self._woken.close()
            self._poller.close()

    def _poll_once(self, *, may_spin: bool) -> None:
        """Make the calls that are due, or wait for the next or for what can be read or written."""
        patience = self._timers.due - self.time()
        if patience <= 0:
            self._timers.run()
            return
        if self._ready:
            patience = 0.0
        for descriptor, event in self._outside(self._poller.wait, patience, may_spin=may_spin):
            handler = self._handlers.get(descriptor)
            if handler is not None:
                handler(event)

    def _run_ready(self) -> None:
        # Not what these have called soon: the medium has its turn before.
        for _ in range(len(self._ready)):
            self._ready.popleft()()

    def _take_lock(self) -> None:
        """Take the lock, if this thread has not got it; a Ctrl-C comes between any two steps of a thread."""
        interruption: BaseException | None = None
        while not self.is_running_here():
            try:
                self._lock.acquire()
                break
            except BaseException as error:  # noqa: BLE001  (it is raised again)
                interruption = error
        if interruption is not None:
            raise interruption

    def _stir(self) -> None:
        """Wake the thread that polls, so that it looks again at what there is to wait for."""
        if self._polling:
            self._send_byte()

    def _send_byte(self) -> None:
        # A full socket wakes as well.
        with suppress(OSError):
            self._waking.send(b"\0")

    def _empty(self, _: int) -> None:
        with suppress(BlockingIOError):
            self._woken.recv(4096)

    # What coroutines of the link need

    def call_soon(self, function: Callable[[], object], /) -> None:
        """Call a function when what runs now waits."""
        self._ready.append(function)

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> None:
        """Call a function in the thread that polls next; may be called by threads that do not run here."""
        self._ready.append(function)
        self._send_byte()

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> _Job:
        """Run a coroutine beside the calls, in the link's own thread, which polls until it ends."""
        job = _Job(self, coroutine)
        self.attend()
        self.go_on(job)
        return job

    def go_on(self, job: _Job) -> None:
        """Make the link's own thread run a job until its next wait."""
        self._jobs.append(job)
        if self._resting is None:
            self._stir()
        else:
            _wake(self._resting)

    def wake(self) -> None:
        """Do nothing: who awaits something goes on by itself."""

    async def finish(self, job: Job) -> None:
        """Cancel a job, and wait until it has ended."""
        assert isinstance(job, _Job)
        job.cancel()
        await job.ended

    async def sleep(self, seconds: float) -> None:
        """Wait."""
        waiter = CallWaiter()
        timer = self.call_at(self.time() + seconds, lambda: waiter.set_result(None))
        try:
            await waiter
        finally:
            timer.cancel()

    @asynccontextmanager
    async def timeout(self, seconds: float) -> AsyncIterator[None]:
        """Raise TimeoutError in the block after some time."""
        run, expired = self.running, False

        def expire() -> None:
            nonlocal expired
            expired = run.waiter is None or run.waiter.cancel()

        run.deadline = self.time() + seconds
        timer = self.call_at(run.deadline, expire)
        try:
            yield
        except asyncio.CancelledError:
            if expired:
                raise TimeoutError from None
            raise
        finally:
            run.deadline = None
            timer.cancel()

    # Media

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler where a file descriptor is ready for some of `READABLE` and `WRITABLE`."""
        self._handlers[descriptor] = handler
        self._poller.register(descriptor, events)
        self._stir()

    def unwatch(self, descriptor: int) -> None:
        """Call no handler any more."""
        del self._handlers[descriptor]
        self._poller.unregister(descriptor)
        self._stir()

    async def prepare(self, url: DriverUrl) -> None:
        """Do what must be done once before a medium of this kind can be opened."""
        if hasattr(load_driver(url.scheme), "prepare"):
            self._aside(run_in_loop, lambda: prepare_medium(url))

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Connect a stream to a medium."""
        if has_channel(target):
            protocol, left = observed(target, stream), self.running.deadline
            seconds = LONGEST_WAIT if left is None else max(0.001, left - self.time())
            patience = seconds if seconds < LONGEST_WAIT else None
            channel = self._aside(open_channel, target, patience)
            make_transport(self, channel, protocol)
            return
        relay = Relay(self, target, stream)
        self._relays = [other for other in self._relays if not other.has_ended] + [relay]
        await relay.open()

    def _aside(self, function: Callable[P, T], *arguments: P.args, **options: P.kwargs) -> T:
        """Call a function that waits, without the lock, while other threads run and poll."""
        run = self.running
        try:
            self._lock.release()
            return function(*arguments, **options)
        finally:
            self._take_lock()
            self.running = run

    def _outside(self, function: Callable[P, T], *arguments: P.args, **options: P.kwargs) -> T:
        """Call a function that waits, without the lock; other threads wait for this one meanwhile."""
        try:
            self._polling = True
            self._lock.release()
            return function(*arguments, **options)
        finally:
            try:
                self._take_lock()
            finally:
                self._polling = False

    def end(self) -> None:
        """Stop polling but for calls, when the link has ended."""
        with self._lock:
            self._closed, self._attended = True, 0
            self._stir()
            self._hand_over()

    def close(self, patience: float | None) -> None:
        """End all threads, when the link has ended; wait for each at most so many seconds."""
        attendant = self._attendant
        self.end()
        for thread in (*self._relays, attendant):
            if thread is not None and thread is not threading.current_thread():
                thread.join(patience)

    # Polling without a call

    def attend(self) -> None:
        """Poll in a thread while no call does, until `leave` is called as often."""
        self._attended += 1
        if self._attendant is None:
            self._attendant = threading.Thread(target=self._attend, name="unity_link.blocking", daemon=True)
            self._attendant.start()

    def leave(self) -> None:
        """End what one call of `attend` has begun."""
        self._attended = max(0, self._attended - 1)
        self._stir()

    def _attend(self) -> None:
        with self._lock:
            self._run_all()
            while self._attended:
                if self._polling:
                    self._park(None)
                else:
                    self._poll_once(may_spin=False)
                self._run_all()
            self._attendant = None
            self._hand_over()

    def _run_all(self) -> None:
        """Run all that need not wait."""
        while self._ready or self._jobs:
            self._run_ready()
            if self._jobs:
                self._jobs.popleft().step()


def _disown_all() -> None:
    for runtime in list(CALLING):
        runtime.disown()
    CALLING.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_disown_all)
