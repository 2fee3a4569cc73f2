"""Deferred signal handlers: the program's handlers do not run within code of a link in the main thread.

CPython calls the handlers of `signal.signal` in the main thread, between any two bytecodes. A handler may raise an
exception: KeyboardInterrupt at Ctrl-C, SystemExit, the timeout of a test. In the middle of a change of state it would
break the session. So a handler for a signal that arrives in code of a link is called at the next safe point instead.

- Blocking code: a call holds the handlers from its beginning to its end. Safe points are its waits and its end. In the
  block of a lease, handlers are deferred in all code of links, so that the end of the block is reached.
- trio: a link defers the handlers while it is open. The safe point is a task of its nursery.
- asyncio: handlers are not deferred. `asyncio.run` turns Ctrl-C into a cancellation.
"""

from __future__ import annotations

import functools
import os
import signal
import sys
import threading
import time

# Every call uses these functions. They are faster than those of `signal`, which convert numbers to enumerations.
from _signal import getsignal  # type: ignore[import-not-found]
from _signal import signal as set_handler
from _thread import get_ident, interrupt_main, start_new_thread
from contextlib import suppress
from typing import TYPE_CHECKING, Any, ParamSpec, Protocol, TypeVar, cast

from unity_link.errors import ANY_ERROR

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator
    from types import FrameType

    Handler = Callable[[int, FrameType | None], Any]

T = TypeVar("T")
P = ParamSpec("P")
_OF_CALLBACK = 0
"""Key in `Deferred.pending` for an exception of a callback, instead of the number of a signal."""
_SOON = 0.001
"""Seconds after which a signal is raised again."""
_NUMBERS = tuple(
    int(number)
    for number in sorted(signal.valid_signals())
    if getattr(number, "name", None) not in {"SIGKILL", "SIGSTOP"}
)


class Interruptible(Protocol):
    """A call or block of a link with safe points."""

    def interrupt(self) -> None:
        """Reach a safe point soon. Called in the main thread, between any two bytecodes."""


class Block(Interruptible, Protocol):
    """A block of a program in which handlers are deferred in all code of links, not only in calls."""

    def is_protected(self, frame: FrameType | None, /) -> bool:
        """Return whether an interrupted frame runs other code that no handler may interrupt, such as trio's own."""


class _Deferring:
    """A signal handler that defers the program's handler within code of a link, and calls it at once elsewhere."""

    __slots__ = ("handler",)

    def __init__(self, handler: Handler) -> None:
        self.handler = handler

    def __call__(self, number: int, frame: FrameType | None) -> None:
        if DEFERRED.add(number, self.handler, frame):
            return
        try:
            self.handler(number, frame)
        except BaseException as error:
            if DEFERRED.is_in_callback:
                DEFERRED.raised = error
            raise


class Deferred:
    """The state of deferred signal handlers. Its methods are for the main thread, unless they say otherwise."""

    def __init__(self) -> None:
        self.thread = threading.main_thread().ident
        """Identifier of the main thread, the only one that runs handlers."""
        self.is_held = False
        """True in a call of blocking code, in which all handlers are deferred."""
        self.pending: dict[int, Handler] = {}
        """Handlers to call at a safe point, by the numbers of their signals."""
        self._caller: Interruptible | None = None
        """Call that holds the handlers; None without one."""
        self._finalizing = 0
        """Number of nested finalizers that run now."""
        self._delivering = 0
        """Number of nested calls that are at a safe point, so that handlers may run."""
        self.is_in_callback = False
        """True in a callback of the program, in which handlers are called at once."""
        self.raised: BaseException | None = None
        """Exception that a handler raised within a callback; None without one."""
        self._blocks: list[Block] = []
        """Open blocks, the innermost last."""
        self.exits = 0
        """Number of calls of an `__aexit__` that are not awaited yet; handlers are deferred until the `await`."""
        self._seen: tuple[object, ...] = ()
        """Handlers of all signals before the last replacement, in the order of `_NUMBERS`."""
        self._replaced: tuple[object, ...] = ()
        """Handlers of all signals after the last replacement, in the order of `_NUMBERS`."""
        self._handlers: list[tuple[int, Handler, _Deferring]] = []
        """Number of each replaced signal, the program's handler, and the deferring one."""

    def add(self, number: int, handler: Handler, frame: FrameType | None) -> bool:
        """Defer a handler if its signal interrupted code of a link; return whether it is deferred."""
        if not self.is_held and (
            self.is_in_callback
            or not self._blocks
            or not (self.exits or _is_inside(frame) or self._blocks[-1].is_protected(frame))
        ):
            return False
        self._add(number, handler)
        return True

    def _add(self, number: int, handler: Handler) -> None:
        self.pending.setdefault(number, handler)
        by = self._caller if self.is_held else self._blocks[-1]
        if by is not None:
            by.interrupt()

    # Blocking code

    def hold(self, caller: Interruptible | None) -> None:
        """Defer all handlers until `release`. If a handler raises within this method, no handler is deferred."""
        seen = tuple(map(getsignal, _NUMBERS))
        if seen == self._seen:
            for number, _, deferring in self._handlers:
                set_handler(number, deferring)
        elif seen != self._replaced:
            self.replace()
        self._caller = caller
        # Set this last: until here handlers are called at once, and may raise.
        self.is_held = True

    def release(self) -> None:
        """Stop deferring handlers, and call the pending ones; their exceptions are raised."""
        # Set this first: from here on handlers are called at once, and may raise.
        self.is_held, self._caller = False, None
        try:
            if not (self._delivering or self._blocks):
                for number, handler, deferring in self._handlers:
                    # Do not replace a handler that a callback has installed.
                    if getsignal(number) is deferring:
                        set_handler(number, handler)
        finally:
            if self.pending and not self._finalizing:
                self._call_pending()

    def held(self, function: Callable[[], object]) -> None:
        """Call a function that does not wait, with all handlers deferred; for any thread."""
        holds = get_ident() == self.thread and not self.is_held
        try:
            if holds:
                self.hold(None)
            function()
        finally:
            if holds:
                self.release()

    def finalize(self, function: Callable[[], object]) -> None:
        """Call a function within the finalizer of an object, and raise pending signals again shortly after it.

        The interpreter would drop an exception of a handler within a finalizer. For any thread.
        """
        if get_ident() != self.thread:
            function()
            return
        self._finalizing += 1
        try:
            function()
        finally:
            self._finalizing -= 1
            if self.pending and not (self.is_held or self._finalizing):
                self.raise_again()

    def raise_again(self) -> None:
        """Raise the signals of the pending handlers again, after `_SOON`."""
        numbers = tuple(number for number in self.pending if number != _OF_CALLBACK)
        self.pending.clear()
        # A thread cannot be started at the end of the program.
        with suppress(RuntimeError):
            start_new_thread(_raise_again, (numbers,))

    def may_deliver(self, caller: Interruptible) -> bool:
        """Return whether a call holds the handlers and may call them now: in the main thread, not in a finalizer."""
        return self._caller is caller and get_ident() == self.thread and not self._finalizing

    def deliver(self) -> None:
        """Call the pending handlers at a safe point of the call that holds them; their exceptions are raised."""
        self._outside(self._call_pending, is_in_callback=False)

    def call(self, function: Callable[[T], object], value: T) -> object:
        """Call a callback of the program from code of a link; for any thread.

        In the main thread, handlers are called at once during the callback, because it may never return. Their
        exceptions, and a SystemExit of the callback itself, are raised at the next safe point.
        """
        if get_ident() != self.thread or not (self.is_held or self._blocks):
            return function(value)
        failure: BaseException
        try:
            return self._outside(functools.partial(function, value), is_in_callback=True)
        except BaseException as error:
            if isinstance(error, ANY_ERROR) and error is not self.raised:
                raise
            failure = error
        self.raised = None

        def raise_again(*_: object) -> None:
            raise failure

        self._add(_OF_CALLBACK, raise_again)
        return None

    def _outside(self, function: Callable[[], T], *, is_in_callback: bool) -> T:
        """Call a function during which handlers are called at once."""
        before = self.is_held, self._caller, self.is_in_callback, self._delivering
        self._delivering += 1
        try:
            self.is_held, self.is_in_callback = False, is_in_callback
            return function()
        finally:
            self.is_held, self._caller, self.is_in_callback, self._delivering = before
            # Replace handlers that the function has installed.
            self.replace()

    def _call_pending(self) -> None:
        try:
            number, handler = self.pending.popitem()
            handler(number, sys._getframe())  # noqa: SLF001  (documented, and as the interpreter calls handlers)
        finally:
            if self.pending:
                self._call_pending()

    # Blocks

    def begin(self, block: Block) -> None:
        """Begin a block: until `end`, defer handlers in code of links, and in code that the block protects."""
        if get_ident() == self.thread:
            self._blocks.append(block)
            self.replace()

    def end(self, block: Block) -> None:
        """End a block. After the last one, the pending handlers are called, and may raise."""
        if get_ident() != self.thread or block not in self._blocks:
            return
        self._blocks.remove(block)
        if not (self._blocks or self.is_held):
            self.release()
        elif self._blocks and self.pending:
            self._blocks[-1].interrupt()

    def defers_in_blocks(self) -> bool:
        """Return whether a block is open and this is the main thread."""
        return bool(self._blocks) and get_ident() == self.thread

    # Replacing handlers

    def replace(self) -> None:
        """Replace the program's signal handlers, also newly installed ones, by handlers that defer them."""
        seen = tuple(map(getsignal, _NUMBERS))
        if seen != self._seen:
            if seen == self._replaced:
                return
            self._look(seen)
        for number, _, deferring in self._handlers:
            set_handler(number, deferring)

    def _look(self, seen: tuple[object, ...]) -> None:
        handlers: list[tuple[int, Handler, _Deferring]] = []
        replaced = list(seen)
        for index, handler in enumerate(seen):
            # A deferring handler may be left: another handler raised while `release` restored the handlers.
            own: Any = handler.handler if isinstance(handler, _Deferring) else handler
            if callable(own):
                replaced[index] = deferring = _Deferring(own)
                handlers.append((_NUMBERS[index], own, deferring))
        self._handlers, self._replaced, self._seen = handlers, tuple(replaced), seen

    def leave_to_child(self) -> None:
        """Reset the state in a forked process, in which the forking thread is the main thread."""
        self.thread = get_ident()
        self.is_held, self._caller, self.is_in_callback = False, None, False
        self._delivering = self._finalizing = self.exits = 0
        self.pending.clear()
        self._blocks.clear()
        self.release()


def _raise_again(numbers: tuple[int, ...]) -> None:
    """Raise signals again after `_SOON`, when the main thread has probably left the protected code."""
    time.sleep(_SOON)
    for number in numbers:
        interrupt_main(number)  # type: ignore[arg-type]  # real-time signals are not in `signal.Signals`


PACKAGE = _raise_again.__code__.co_filename.removesuffix("interrupts.py").removesuffix(f"link{os.sep}")
"""First characters of the file names of this package."""


def _is_inside(frame: FrameType | None) -> bool:
    """Return whether a frame, or one of its callers, runs code of this package."""
    while frame is not None:
        if frame.f_code.co_filename.startswith(PACKAGE):
            return True
        frame = frame.f_back
    return False


class BlockingBlock:
    """A block of blocking code whose end must be reached, so that no handler may raise before its last call."""

    def interrupt(self) -> None:
        """Raise the signals again shortly, because no safe point may follow."""
        DEFERRED.raise_again()

    def is_protected(self, _: FrameType | None, /) -> bool:
        """Return False, because the block protects only code of links."""
        return False


class _Exit:
    """The coroutine of an `__aexit__` that was called. Handlers are deferred until it is awaited or deleted."""

    __slots__ = ("_coroutine", "_is_awaited")

    def __init__(self, coroutine: Coroutine[Any, Any, Any]) -> None:
        self._coroutine = coroutine
        self._is_awaited = False
        DEFERRED.exits += 1

    def __await__(self) -> Generator[Any, Any, Any]:
        self.__del__()
        return self._coroutine.__await__()

    def __del__(self) -> None:
        if not self._is_awaited:
            self._is_awaited = True
            DEFERRED.exits -= 1


def whole_exit(exit_block: Callable[P, Coroutine[Any, Any, T]]) -> Callable[P, Coroutine[Any, Any, T]]:
    """Decorate an `__aexit__` so that it runs even if a signal arrives between its call and its `await`.

    Without the decorator, CPython may run a handler there. If the handler raises, the coroutine never runs.
    """

    @functools.wraps(exit_block)
    def called(*arguments: P.args, **named: P.kwargs) -> Coroutine[Any, Any, T]:
        coroutine = exit_block(*arguments, **named)
        return cast("Coroutine[Any, Any, T]", _Exit(coroutine)) if DEFERRED.defers_in_blocks() else coroutine

    return called


DEFERRED = Deferred()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=DEFERRED.leave_to_child)
