"""Locks, events and callbacks for code that is built on links, in every kind of program."""

from __future__ import annotations

import asyncio
from collections import deque
from contextlib import suppress
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.link.interrupts import DEFERRED
from unity_link.link.living import Living
from unity_link.link.runtimes.runtime import AsyncioRuntime, Runtime, report

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine
    from types import TracebackType

    from unity_link.link.runtimes.runtime import Waiter


T = TypeVar("T")


class BlockingRuntime(Runtime, Protocol):
    """A runtime of blocking code."""

    is_running_here: Callable[[], bool]
    """Returns whether the calling thread is running a coroutine of this runtime."""

    def disown(self) -> None:
        """Refuse all calls from now on, in a forked process."""


STRUCTURED: ContextVar[Runtime] = ContextVar("STRUCTURED")
"""Under trio: runtime of the innermost ``async with`` block of a link."""
CALLING: Living[BlockingRuntime] = Living()
"""Runtimes of all links of blocking code."""


def running() -> Runtime:
    """Return the runtime of the calling coroutine.

    Raises:
        ArgumentError: if no runtime runs the caller.
    """
    for runtime in CALLING:
        if runtime.is_running_here():
            return runtime
    with suppress(RuntimeError):
        return AsyncioRuntime()
    structured = STRUCTURED.get(None)
    if structured is None:
        raise ArgumentError("no event loop runs here: call this in a coroutine, or in a callback of its loop")
    return structured


def call_back(function: Callable[[T], object], value: T) -> object:
    """Call a callback of the program from code of a link, and return its result.

    Raises:
        Exception: the exception of the callback. In blocking code, exceptions such as `SystemExit` are logged instead,
            because they would end a thread of the link.
    """
    try:
        return DEFERRED.call(function, value)
    except ANY_ERROR:
        raise
    except BaseException as error:
        if not any(runtime.is_running_here() for runtime in CALLING):
            raise
        report(f"a callback raised {type(error).__name__}, which ends nothing here", error)
        return None


async def gather(*coroutines: Coroutine[Any, Any, Any]) -> list[Any]:
    """Await all coroutines, concurrently in asyncio and one after the other otherwise, and return their results.

    Raises:
        Exception: the first error, after all coroutines have ended.
    """
    if isinstance(running(), AsyncioRuntime):
        return await asyncio.gather(*coroutines)
    results: list[Any] = []
    first: Exception | None = None
    try:
        for coroutine in coroutines:
            try:
                results.append(await coroutine)
            except Exception as error:  # noqa: BLE001  (it is raised below)
                first = first or error
    finally:
        # After a cancellation, some coroutines have not begun.
        for coroutine in coroutines:
            coroutine.close()
    if first is not None:
        raise first
    return results


class Event:
    """A flag that can be waited for."""

    def __init__(self) -> None:
        self._set = False
        self._waiters: list[Waiter] = []

    def set(self) -> None:
        """Set the flag, and resume all callers of `wait`."""
        self._set = True
        for waiter in self._waiters:
            if not waiter.done():
                waiter.set_result(None)

    def clear(self) -> None:
        """Clear the flag."""
        self._set = False

    async def wait(self) -> None:
        """Wait until the flag is set."""
        while not self._set:
            waiter = running().create_future()
            self._waiters.append(waiter)
            try:
                await waiter
            finally:
                self._waiters.remove(waiter)


class Lock:
    """A lock for ``async with``; waiting coroutines get it in their order."""

    def __init__(self) -> None:
        self._held = False
        self._waiters: deque[Waiter] = deque()

    async def __aenter__(self) -> None:
        while self._held:
            waiter = running().create_future()
            self._waiters.append(waiter)
            try:
                await waiter
            except BaseException:
                # The lock was already passed to this cancelled coroutine: pass it to the next one.
                if waiter.done() and not waiter.cancelled():
                    self._wake_next()
                raise
            finally:
                with suppress(ValueError):
                    self._waiters.remove(waiter)
        self._held = True

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._held = False
        self._wake_next()

    def _wake_next(self) -> None:
        for waiter in self._waiters:
            if not waiter.done():
                waiter.set_result(None)
                return
