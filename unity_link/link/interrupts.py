"""Signal handlers of the program, deferred while code of a link runs in the main thread.

CPython calls the handlers of `signal.signal` in the main thread, between any two bytecodes, and a handler may raise:
KeyboardInterrupt at Ctrl-C, SystemExit, the time-out of a test. An exception in the middle of a change of state would
break the session. So a handler that is due in code of a link is called at the next safe point instead.

Blocking code: a call holds the handlers from its beginning to its end. Safe points are its waits and its end. In the
block of a lease they are deferred in all code of links, so that its end is reached. trio: links defer the handlers
while they are open. The safe point is a task in the block of the link.
"""

from __future__ import annotations

import functools
import os
import signal
import sys
import threading
import time

# Every call asks: these are quicker than the functions of `signal`, which make enumerations of numbers.
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
"""Number in place of a signal's, for what is raised in a callback."""
_SOON = 0.001
"""Seconds after which a signal is tripped again."""
_NUMBERS = tuple(
    int(number)
    for number in sorted(signal.valid_signals())
    if getattr(number, "name", None) not in {"SIGKILL", "SIGSTOP"}
)


class Interruptible(Protocol):
    """Call or block of a link that has safe points."""

    def interrupt(self) -> None:
        """Come to a safe point soon; called in the main thread, between any two bytecodes."""


class Block(Interruptible, Protocol):
    """Block of a program in which handlers are deferred in all code of links, and not in calls alone."""

    def is_protected(self, frame: FrameType | None, /) -> bool:
        """Return whether a frame that was interrupted runs code that no handler may interrupt, as trio's own."""


class _Deferring:
    """Handler of a signal that defers another handler in code of a link, and calls it at once elsewhere."""

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
    """Signals whose handlers are to be called at a safe point; all methods are for the main thread."""

    def __init__(self) -> None:
        self.thread = threading.main_thread().ident
        """The main thread, which is the only one that runs handlers."""
        self.is_held = False
        """True in a call of blocking code: all handlers are deferred."""
        self.pending: dict[int, Handler] = {}
        """Handlers to be called, by the numbers of their signals."""
        self._caller: Interruptible | None = None
        """Call that holds the handlers."""
        self._finalizing = 0
        """Number of finalizers that run now, one within another."""
        self._delivering = 0
        """Calls that have stopped at a safe point, for handlers to run."""
        self.is_in_callback = False
        """True in a callback of the program: handlers are called at once."""
        self.raised: BaseException | None = None
        """Error that a handler has raised in a callback."""
        self._blocks: list[Block] = []
        self.exits = 0
        """Calls of an `__aexit__` that are not awaited yet: no handler runs between the call and the `await`."""
        self._seen: tuple[object, ...] = ()
        """Handlers of all signals before they were last replaced, in the order of `_NUMBERS`."""
        self._replaced: tuple[object, ...] = ()
        """Handlers of all signals after that."""
        self._handlers: list[tuple[int, Handler, _Deferring]] = []

    def add(self, number: int, handler: Handler, frame: FrameType | None) -> bool:
        """Defer a handler if the signal has interrupted code of a link, and return whether it did."""
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
        """Defer all handlers, until `release`. A handler may still raise in here: then none is deferred."""
        seen = tuple(map(getsignal, _NUMBERS))
        if seen == self._seen:
            for number, _, deferring in self._handlers:
                set_handler(number, deferring)
        elif seen != self._replaced:
            self.replace()
        self._caller = caller
        # Last of all: up to here handlers are called at once, and may raise.
        self.is_held = True

    def release(self) -> None:
        """Call the handlers that are pending, and defer none from now on; raises what they raise."""
        # First of all: from here on handlers are called at once, and may raise.
        self.is_held, self._caller = False, None
        try:
            if not (self._delivering or self._blocks):
                for number, handler, deferring in self._handlers:
                    # A callback may have installed another one.
                    if getsignal(number) is deferring:
                        set_handler(number, handler)
        finally:
            if self.pending and not self._finalizing:
                self._call_pending()

    def held(self, function: Callable[[], object]) -> None:
        """Call a function that does not wait, and defer all handlers meanwhile; for any thread."""
        holds = get_ident() == self.thread and not self.is_held
        try:
            if holds:
                self.hold(None)
            function()
        finally:
            if holds:
                self.release()

    def finalize(self, function: Callable[[], object]) -> None:
        """Call a function in the finalizer of an object, and defer handlers until a moment after it.

        The interpreter drops what a handler raises in a finalizer.
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
        """Trip the signals of the pending handlers again a moment later."""
        numbers = tuple(number for number in self.pending if number != _OF_CALLBACK)
        self.pending.clear()
        # At the end of the program there are no new threads.
        with suppress(RuntimeError):
            start_new_thread(_raise_again, (numbers,))

    def may_deliver(self, caller: Interruptible) -> bool:
        """Return whether this is the call that holds the handlers, in its thread, and may call them."""
        return self._caller is caller and get_ident() == self.thread and not self._finalizing

    def deliver(self) -> None:
        """Call the handlers that are pending, at a safe point of the call that holds them; raises what they raise."""
        self._outside(self._call_pending, is_in_callback=False)

    def call(self, function: Callable[[T], object], value: T) -> object:
        """Call a callback of the program, from code of a link.

        In the main thread handlers are called at once meanwhile, for it may never return. What they raise, and
        SystemExit of the callback itself, is raised at the next safe point.
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
        """Call a function, and handlers at once meanwhile."""
        before = self.is_held, self._caller, self.is_in_callback, self._delivering
        self._delivering += 1
        try:
            self.is_held, self.is_in_callback = False, is_in_callback
            return function()
        finally:
            self.is_held, self._caller, self.is_in_callback, self._delivering = before
            # Those that were installed meanwhile.
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
        """Defer handlers in code of links, until `end`; where the block is protected, too."""
        if get_ident() == self.thread:
            self._blocks.append(block)
            self.replace()

    def end(self, block: Block) -> None:
        """End a block. If it was the last one, handlers that are pending are called, and may raise."""
        if get_ident() != self.thread or block not in self._blocks:
            return
        self._blocks.remove(block)
        if not (self._blocks or self.is_held):
            self.release()
        elif self._blocks and self.pending:
            self._blocks[-1].interrupt()

    def defers_in_blocks(self) -> bool:
        """Return whether this thread runs handlers, and a block is open."""
        return bool(self._blocks) and get_ident() == self.thread

    # Replacing

    def replace(self) -> None:
        """Replace the handlers of the program, and those that it has installed since, by handlers that defer them."""
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
            # One that defers is left where a handler has raised while others were restored.
            own: Any = handler.handler if isinstance(handler, _Deferring) else handler
            if callable(own):
                replaced[index] = deferring = _Deferring(own)
                handlers.append((_NUMBERS[index], own, deferring))
        self._handlers, self._replaced, self._seen = handlers, tuple(replaced), seen

    def leave_to_child(self) -> None:
        """Begin anew in a process that was forked, whose main thread may be another."""
        self.thread = get_ident()
        self.is_held, self._caller, self.is_in_callback = False, None, False
        self._delivering = self._finalizing = self.exits = 0
        self.pending.clear()
        self._blocks.clear()
        self.release()


def _raise_again(numbers: tuple[int, ...]) -> None:
    """Trip signals again, when the main thread has left the code in which their handlers could not be called."""
    time.sleep(_SOON)
    for number in numbers:
        interrupt_main(number)  # type: ignore[arg-type]  # real-time signals are none of `signal.Signals`


PACKAGE = _raise_again.__code__.co_filename.removesuffix("interrupts.py").removesuffix(f"link{os.sep}")
"""Beginning of the file names of the code of this package."""


def _is_inside(frame: FrameType | None) -> bool:
    """Return whether code of this package runs in a frame, or has called it."""
    while frame is not None:
        if frame.f_code.co_filename.startswith(PACKAGE):
            return True
        frame = frame.f_back
    return False


class BlockingBlock:
    """A block of blocking code that is left by a call, which no handler may keep from being made."""

    def interrupt(self) -> None:
        """Trip the signals again a moment later, because no safe point may follow."""
        DEFERRED.raise_again()

    def is_protected(self, _: FrameType | None, /) -> bool:
        """Return False."""
        return False


class _Exit:
    """Coroutine of an `__aexit__` that has been called. Handlers are deferred until it is awaited, or dropped."""

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
    """Return an `__aexit__` that runs even if a signal comes between its call and the `await` of its coroutine.

    CPython may run a handler there, in the code of the program. If the handler raises, the coroutine never runs.
    """

    @functools.wraps(exit_block)
    def called(*arguments: P.args, **named: P.kwargs) -> Coroutine[Any, Any, T]:
        coroutine = exit_block(*arguments, **named)
        return cast("Coroutine[Any, Any, T]", _Exit(coroutine)) if DEFERRED.defers_in_blocks() else coroutine

    return called


DEFERRED = Deferred()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=DEFERRED.leave_to_child)
