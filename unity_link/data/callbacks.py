"""Functions of a program that are called with values or samples. Their exceptions are logged."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Generic, Self, TypeVar

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.link.calls import is_asynchronous
from unity_link.link.runtimes.runtime import report
from unity_link.link.runtimes.synchronisation import call_back

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

T = TypeVar("T")


class Callback(Generic[T]):
    """A function that is called from the event loop.

    An exception of the function is logged under ``unity_link.link``; later values still arrive. Only the first
    exception of each type is logged, because a fault in each sample would be logged thousands of times per second.
    """

    def __init__(self, function: Callable[[T], object], what: str) -> None:
        """Wrap a function.

        Args:
            function: takes a value or samples.
            what: name of the function in messages.

        Raises:
            ArgumentError: if it is no function, or an asynchronous one.
        """
        if not callable(function):
            raise ArgumentError(f"{what} is {function!r}: a function was expected")
        if is_asynchronous(function) or is_asynchronous(type(function).__call__):
            raise _asynchronous(what)
        self._function = function
        self._what = what
        self._reported: set[type[BaseException]] = set()

    def __call__(self, value: T) -> None:
        """Call the function."""
        try:
            result = call_back(self._function, value)
        except ANY_ERROR as error:
            self._report(error)
            return
        if inspect.iscoroutine(result):
            result.close()
            self._report(_asynchronous(self._what))

    def cancel(self) -> None:
        """End the calls, even if this is called while a value is being passed to several callbacks."""
        self._function = _ignore

    def _report(self, error: BaseException) -> None:
        if type(error) in self._reported:
            return
        self._reported.add(type(error))
        report(f"{self._what} raised {type(error).__name__} (told once)", error)


class Registration:
    """A callback that is called until `cancel` is called, or until the ``with`` block of the registration ends."""

    def __init__(self, *ends: Callable[[], None]) -> None:
        self._ends = ends

    def cancel(self) -> None:
        """End the calls. May be called twice."""
        for end in self._ends:
            end()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.cancel()


def _ignore(_: object) -> None:
    """Do nothing. Replaces the function of a cancelled callback, so that calls need no check."""


def _asynchronous(what: str) -> ArgumentError:
    return ArgumentError(
        f"{what} is an asynchronous function, which would never be awaited: a plain function was expected, which may "
        "start a task"
    )
