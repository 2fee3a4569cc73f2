"""Waiting primitives of code that is built on links, for every kind of program.

In asyncio it is asyncio's own; elsewhere what runs the link has it.
"""

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
    """Returns whether the calling thread runs a coroutine by it."""

    def disown(self) -> None:
        """Refuse all calls, in a process that was forked."""


STRUCTURED: ContextVar[Runtime] = ContextVar("STRUCTURED")
"""Runtime of the links of the innermost block, under trio."""
CALLING: Living[BlockingRuntime] = Living()
"""Runtimes of the links of blocking code."""


def running() -> Runtime:
    """Return what runs the calling coroutine.

    Raises:
        ArgumentError: where nothing does.
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
    """Call a callback of the program, from code of a link; return what it returns.

    Raises:
        Exception: what it raises. In blocking code SystemExit and the like are logged: they would end the wrong thread.
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
    """Await all, together where that can be and in turn otherwise, and return their results.

    Raises:
        Exception: the first error; the others are done all the same.
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
        # Where this is cancelled, some have not begun.
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
        """Wake those who wait."""
        self._set = True
        for waiter in self._waiters:
            if not waiter.done():
                waiter.set_result(None)

    def clear(self) -> None:
        """Take the flag back."""
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
    """Has one coroutine at a time in its ``async with`` blocks, in turn."""

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
                # Its turn goes to the next.
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
