"""Functions of a program that are called with values or samples, and may raise what they like."""

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

    What it raises is logged under ``unity_link.link`` and stops nothing: the first exception of each type, since one
    that is raised with each sample would be told thousands of times a second.
    """

    def __init__(self, function: Callable[[T], object], what: str) -> None:
        """Wrap a function.

        Args:
            function: takes a value or samples.
            what: how messages call it.

        Raises:
            ArgumentError: where it is none, or an asynchronous one.
        """
        if not callable(function):
            raise ArgumentError(f"{what} is {function!r}: a function was expected")
        if is_asynchronous(function) or is_asynchronous(type(function).__call__):
            raise _asynchronous(what)
        self._function = function
        self._what = what
        self._told: set[type[BaseException]] = set()

    def __call__(self, value: T) -> None:
        """Call the function."""
        try:
            result = call_back(self._function, value)
        except ANY_ERROR as error:
            self._tell(error)
            return
        if inspect.iscoroutine(result):
            result.close()
            self._tell(_asynchronous(self._what))

    def cancel(self) -> None:
        """Call it no more, also where this is while others are called with the same value."""
        self._function = _ignore

    def _tell(self, error: BaseException) -> None:
        if type(error) in self._told:
            return
        self._told.add(type(error))
        report(f"{self._what} raised {type(error).__name__} (told once)", error)


class Registration:
    """A callback that is called until `cancel`, or until the ``with`` block of this ends."""

    def __init__(self, *ends: Callable[[], None]) -> None:
        self._ends = ends

    def cancel(self) -> None:
        """Call it no more. May be called twice."""
        for end in self._ends:
            end()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.cancel()


def _ignore(_: object) -> None:
    """Take the place of a function that is not to be called: to look at each call would cost each."""


def _asynchronous(what: str) -> ArgumentError:
    return ArgumentError(
        f"{what} is an asynchronous function, which would never be awaited: a plain function was expected, which may "
        "start a task"
    )
