"""The runtime of a link in blocking code: its coroutines run in the threads that call it, without an event loop.

1. A call runs its coroutine until that waits. Then the calling thread polls the medium itself.
2. If several threads wait, one of them polls for all. When its own call is done, another thread takes over.
3. While there is a subscription or a background task, a thread of the link ("attendant") polls when no call does. It
   also runs the background tasks, so that each of them stays in one thread and does not delay a Ctrl-C.
4. The thread that runs code of the link holds the lock. It releases the lock to poll, and to wait for another thread.

A medium that needs an event loop gets one in another thread (`loop_thread`).
"""

from __future__ import annotations

import asyncio
import os
import socket
import threading
import time
from _thread import get_ident
from collections import deque
from contextlib import asynccontextmanager, suppress
from typing import TYPE_CHECKING, Any, Never, ParamSpec, TypeVar

from unity_link.errors import ArgumentError
from unity_link.link.connection import forked
from unity_link.link.interrupts import DEFERRED
from unity_link.link.runtimes.loop_thread import Relay, complete, run_in_loop
from unity_link.link.runtimes.runtime import report, unadjusted_time
from unity_link.link.runtimes.synchronisation import CALLING
from unity_link.link.runtimes.timers import Timers
from unity_link.link.runtimes.waiter import Result
from unity_link.transport import DriverUrl, has_channel, load_driver, observed, open_channel
from unity_link.transport import prepare as prepare_medium
from unity_link.transport.channel_transport import make_transport
from unity_link.transport.polling import READABLE, Poller

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Generator

    from unity_link.link.runtimes.runtime import Job
    from unity_link.transport import Medium
    from unity_link.transport.channel import Channel
    from unity_link.transport.stream import Stream

P = ParamSpec("P")
T = TypeVar("T")
LONGEST_WAIT = 1e9
"""Longest timeout of a socket in seconds, about 30 years; a longer time counts as no timeout."""
LONGEST_DEAF_WAIT = 0.1
"""Most seconds that the main thread sleeps at a time. The system does not wake it for a signal that another thread
receives, or that arrives just before it sleeps, and the handler can run only when it is awake."""
SPARE = 1.0
"""Seconds by which the timeout of a driver exceeds that of the call, so that the call raises its own error."""


def _close(channel: Channel) -> None:
    channel.close()


class CallWaiter(Result):
    """Future of a call."""

    __slots__ = ()

    def __await__(self) -> Generator[CallWaiter, None, Any]:
        """Wait until the future is done; return its result or raise its error."""
        if not self._done:
            yield self
        return self.result()


class _Run:
    """The state of a running coroutine."""

    waiter: CallWaiter | None = None
    """Future that the coroutine awaits, or awaited last."""
    deadline: float | None = None
    """Instant at which the innermost `timeout` around it ends; None without one."""


class _Job(_Run):
    """A background task, which runs in the link's own thread."""

    def __init__(self, runtime: CallingThread, coroutine: Coroutine[CallWaiter, None, None]) -> None:
        self._runtime = runtime
        self._coroutine = coroutine
        self._cancelled = False
        self.ended = CallWaiter()

    def step(self) -> None:
        """Run the coroutine until its next wait."""
        try:
            self._runtime.running = self
            waiter = self.waiter = self._coroutine.send(None)
        except (StopIteration, asyncio.CancelledError):
            self._end()
        except Exception as error:  # noqa: BLE001  (no call is there that could raise it)
            self._end()
            report("a background task of a link has failed", error)
        else:
            waiter.on_done = lambda: self._runtime.go_on(self)
            if self._cancelled:
                waiter.cancel()

    def cancel(self) -> None:
        """Cancel the task at its next wait."""
        self._cancelled = True
        if self.waiter is not None:
            self.waiter.cancel()

    def _end(self) -> None:
        self.ended.set_result(None)
        self._runtime.stop_polling()


def _refuse() -> Never:
    raise forked()


def _wake(parked: threading.Lock) -> None:
    # A signal handler may have released it already.
    with suppress(RuntimeError):
        parked.release()


class CallingThread:
    """Runs the coroutines of one link in the threads that call it.

    `run` is for calls; the coroutines of the link use the other methods.
    """

    def __init__(self) -> None:
        self.time = time.monotonic
        self.steady = unadjusted_time
        self.create_future = self.create_inline_future = CallWaiter
        self.ended = ()
        self.caller = threading.current_thread
        self._lock = threading.RLock()
        self.is_running_here: Callable[[], bool] = self._lock._is_owned  # type: ignore[attr-defined]  # noqa: SLF001
        """Returns whether the calling thread runs code of the link now, that is, holds the lock."""
        self._polling = False
        """True while a thread polls."""
        self._poller = Poller()
        self._parked: list[threading.Lock] = []
        """One lock for each thread that waits while another one polls; releasing it wakes the thread."""
        self._ready: deque[Callable[[], object]] = deque()
        self._timers = Timers(self.time, self._stir)
        self.call_at = self._timers.call_at
        self._handlers: dict[int, Callable[[int], None]] = {}
        self.running = _Run()
        """Coroutine that runs now, or ran last."""
        self._relays: list[Relay] = []
        self.is_disowned = False
        """True in a process that was forked from the one that opened the link."""
        self.is_closed = False
        """True after the link has ended."""
        self._attended = 0
        """Number of calls of `start_polling` without a `stop_polling`."""
        self._attendant: threading.Thread | None = None
        """Thread that polls when no call does; None if none is needed."""
        self._resting: threading.Lock | None = None
        """The attendant's lock in `_parked`; None while the attendant does not wait there."""
        self._jobs: deque[_Job] = deque()
        """Background tasks that the attendant is to run until their next wait."""
        self._waking, self._woken = socket.socketpair()
        for end in (self._waking, self._woken):
            end.settimeout(0)
        self.watch(self._woken.fileno(), READABLE, self._empty)
        CALLING.add(self)

    def disown(self) -> None:
        """Refuse all calls in a forked process, in which the polling thread and the lock's holder do not exist."""
        self.is_disowned = True
        self.is_running_here = _refuse

    def is_over(self, caller: threading.Thread, /) -> bool:
        """Return whether a thread has ended."""
        return not caller.is_alive()

    # Calls

    def run(self, function: Callable[P, Coroutine[Any, Any, T]], *arguments: P.args, **options: P.kwargs) -> T:
        """Run a coroutine function of the link in the calling thread, and return its result.

        Raises:
            ArgumentError: if a callback of the link calls it, because that runs within another call.
        """
        if self.is_running_here():
            raise ArgumentError("a callback runs within a call of its link, and must not call the link")
        run = _Run()
        holds = get_ident() == DEFERRED.thread and not DEFERRED.is_held
        try:
            # The holder of the lock may be in a callback that never returns; an exception of a signal handler ends this
            # wait.
            with self._lock:
                if holds:
                    DEFERRED.hold(self)
                try:
                    return self._run(run, function(*arguments, **options))
                finally:
                    try:
                        if self._ready:
                            self._run_ready()
                    finally:
                        if self._parked or self.is_closed:
                            self._hand_over()
        finally:
            if holds:
                DEFERRED.release()

    def _run(self, run: _Run, coroutine: Coroutine[Any, Any, T]) -> T:
        interruption: BaseException | None = None
        step: Callable[[Any], CallWaiter] = coroutine.send
        given: BaseException | None = None
        try:
            while True:
                self.running = run
                waiter = run.waiter = step(given)
                step, given = coroutine.send, None
                try:
                    self._wait(waiter)
                except BaseException as error:  # noqa: BLE001  (it is raised below)
                    # Cancel the coroutine instead of raising the error in it: it could handle the exception of a signal
                    # handler as an error of its own.
                    interruption = error
                    step, given = coroutine.throw, asyncio.CancelledError()
        except StopIteration as end:
            if interruption is None:
                result: T = end.value
                return result
        except BaseException:
            if interruption is None:
                raise
        raise interruption

    def _wait(self, waiter: CallWaiter) -> None:
        """Wait until a future is done: poll, or wait for the thread that polls."""
        if self._ready:
            self._run_ready()
        # Another thread may complete the future while this one polls.
        waiter.on_done = self._stir
        while not waiter.done():
            if DEFERRED.pending and DEFERRED.may_deliver(self):
                self._deliver()
            elif self._polling:
                self._park(waiter)
            else:
                self._poll_once(may_spin=True)
            if self._ready:
                self._run_ready()

    def interrupt(self) -> None:
        """Wake the main thread from its wait; called in a signal handler."""
        self._send_byte()
        for parked in self._parked.copy():
            _wake(parked)

    def _deliver(self) -> None:
        """Run the pending signal handlers without the lock, because they may call the link."""
        run = self.running
        self._hand_over()
        self._lock.release()
        try:
            DEFERRED.deliver()
        finally:
            self._lock.acquire()
            self.running = run

    def _park(self, waiter: CallWaiter | None) -> None:
        """Wait until a future is done (None in the attendant), no thread polls, or a signal may be pending."""
        parked = threading.Lock()
        parked.acquire()
        if waiter is None:
            self._resting = parked
            self._parked.insert(0, parked)
        else:
            self._parked.append(parked)
            waiter.on_done = lambda: _wake(parked)
        self._lock.release()
        # Do not sleep if a signal arrived before the lock was in `_parked`.
        if waiter is None or not DEFERRED.pending or not DEFERRED.may_deliver(self):
            parked.acquire(timeout=LONGEST_DEAF_WAIT if get_ident() == DEFERRED.thread else -1)
        self._lock.acquire()
        self._parked.remove(parked)
        if waiter is None:
            self._resting = None
        else:
            waiter.on_done = self._stir

    def _hand_over(self) -> None:
        """Wake another thread to poll; after the end of the link, close the poller."""
        if self._polling:
            return
        if self._parked:
            _wake(self._parked[0])
        elif self.is_closed and self._attendant is None and self._woken.fileno() in self._handlers:
            self.unwatch(self._woken.fileno())
            self._waking.close()
            self._woken.close()
            self._poller.close()

    def _poll_once(self, *, may_spin: bool) -> None:
        """Run the timers that are due, or wait for the next timer or for a ready descriptor."""
        patience = self._timers.due - self.time()
        if patience <= 0:
            self._timers.run()
            return
        if self._ready:
            patience = 0.0
        elif patience > LONGEST_DEAF_WAIT and get_ident() == DEFERRED.thread:
            patience = LONGEST_DEAF_WAIT
        self._polling = True
        self._lock.release()
        try:
            found = self._poller.wait(patience, may_spin=may_spin)
        finally:
            self._lock.acquire()
            self._polling = False
        for descriptor, event in found:
            handler = self._handlers.get(descriptor)
            if handler is not None:
                handler(event)

    def _run_ready(self) -> None:
        # Leave functions that these add for the next turn, so that the medium is polled in between.
        for _ in range(len(self._ready)):
            self._ready.popleft()()

    def _stir(self) -> None:
        """Wake the thread that polls, because its timers or descriptors have changed."""
        if self._polling:
            self._send_byte()

    def _send_byte(self) -> None:
        # If the socket is full, unread bytes wake the thread.
        with suppress(OSError):
            self._waking.send(b"\0")

    def _empty(self, _: int) -> None:
        with suppress(BlockingIOError):
            self._woken.recv(4096)

    # The methods of a `Runtime`

    def call_soon(self, function: Callable[[], object], /) -> None:
        """Call a function after the current call waits."""
        self._ready.append(function)

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> None:
        """Call a function in the thread that polls; may be called by threads without the lock."""
        self._ready.append(function)
        self._send_byte()

    def create_task(self, coroutine: Coroutine[Any, Any, None], /) -> _Job:
        """Run a coroutine as a background task in the attendant, which polls until the task ends."""
        job = _Job(self, coroutine)
        self.start_polling()
        self.go_on(job)
        return job

    def go_on(self, job: _Job) -> None:
        """Make the attendant run a background task until its next wait."""
        self._jobs.append(job)
        if self._resting is None:
            self._stir()
        else:
            _wake(self._resting)

    def wake(self) -> None:
        """Do nothing, because calls resume when their future is done."""

    async def finish(self, job: Job) -> None:
        """Cancel a background task, and wait until it has ended."""
        assert isinstance(job, _Job)
        job.cancel()
        await job.ended

    async def sleep(self, seconds: float) -> None:
        """Wait for a duration."""
        waiter = CallWaiter()
        timer = self.call_at(self.time() + seconds, lambda: waiter.set_result(None))
        try:
            await waiter
        finally:
            timer.cancel()

    @asynccontextmanager
    async def timeout(self, seconds: float) -> AsyncIterator[None]:
        """Raise `TimeoutError` in the block after `seconds`."""
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

    last_timeout = timeout

    # Media

    def watch(self, descriptor: int, events: int, handler: Callable[[int], None]) -> None:
        """Call a handler whenever a file descriptor is ready for some of `events` (`READABLE`, `WRITABLE`)."""
        self._handlers[descriptor] = handler
        self._poller.register(descriptor, events)
        self._stir()

    def unwatch(self, descriptor: int) -> None:
        """Stop watching a file descriptor."""
        del self._handlers[descriptor]
        self._poller.unregister(descriptor)
        self._stir()

    async def prepare(self, url: DriverUrl) -> None:
        """Run the one-time preparation of a medium's driver, before a medium of this kind is opened."""
        if hasattr(load_driver(url.scheme), "prepare"):
            await self._beside(lambda _: run_in_loop(lambda: prepare_medium(url)), lambda _: None)

    async def open_medium(self, target: DriverUrl | Medium, stream: Stream) -> None:
        """Open a medium, and connect a stream to it."""
        if has_channel(target):
            protocol, left = observed(target, stream), self.running.deadline
            seconds = LONGEST_WAIT if left is None else max(0.0, left - self.time()) + SPARE
            patience = seconds if seconds < LONGEST_WAIT else None
            channel = await self._beside(lambda is_given_up: open_channel(target, patience, is_given_up), _close)
            make_transport(self, channel, protocol)
            return
        relay = Relay(self, target, stream)
        self._relays = [other for other in self._relays if not other.has_ended] + [relay]
        await relay.open()

    async def _beside(self, function: Callable[[Callable[[], bool]], T], undo: Callable[[T], object]) -> T:
        """Call a function that blocks in another thread, and return its result.

        Args:
            function: called with a function that returns True after this call was cancelled.
            undo: called with the result if this call was cancelled.
        """
        waiter, given_up = CallWaiter(), threading.Event()
        results: list[T] = []
        errors: list[BaseException] = []

        def work() -> None:
            try:
                results.append(function(given_up.is_set))
            except BaseException as error:  # noqa: BLE001  (the call raises it)
                errors.append(error)
            if given_up.is_set():
                for result in results:
                    undo(result)
            self.call_soon_threadsafe(lambda: complete(waiter))

        thread = threading.Thread(target=work, name="unity_link.opening", daemon=True)
        thread.start()
        try:
            await waiter
        except BaseException:
            given_up.set()
            for result in results:
                undo(result)
            raise
        thread.join()
        if errors:
            raise errors[0]
        return results[0]

    def end(self) -> None:
        """Stop the attendant, because the link has ended; calls still poll."""
        with self._lock:
            self.is_closed, self._attended = True, 0
            self._stir()
            self._hand_over()

    def close(self, patience: float | None) -> None:
        """End all threads after the end of the link; wait for each at most `patience` seconds, None for no limit."""
        attendant = self._attendant
        self.end()
        for thread in (*self._relays, attendant):
            if thread is not None and thread is not threading.current_thread():
                thread.join(patience)

    # Polling without a call

    def start_polling(self) -> None:
        """Process received bytes also while no call waits, until `stop_polling` is called as often."""
        self._attended += 1
        if self._attendant is None:
            self._attendant = threading.Thread(target=self._attend, name="unity_link.blocking", daemon=True)
            self._attendant.start()

    def stop_polling(self) -> None:
        """End the effect of one call of `start_polling`."""
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
        """Run all functions and background tasks that are ready."""
        while self._ready or self._jobs:
            self._run_ready()
            if self._jobs:
                self._jobs.popleft().step()


def _disown_all() -> None:
    for runtime in CALLING:
        runtime.disown()
    CALLING.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_disown_all)
