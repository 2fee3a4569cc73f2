"""Objects that are alive, and a warning of those that were left open.

Python code that runs where an object is dropped, as a callback of a weak reference or a `__del__`, may run anywhere in
the main thread of a program, and signal handlers with it: what one raises there is lost, a Ctrl-C for example. So an
object that was closed has no such code.
"""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Generic, TypeVar
from weakref import ref

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

T = TypeVar("T")


class Living(Generic[T]):
    """Objects by weak references without callbacks. Any thread may add one."""

    def __init__(self) -> None:
        self._references: list[ref[T]] = []

    def add(self, thing: T) -> None:
        """Add an object, and forget those that were dropped."""
        for reference in self._references.copy():
            if reference() is None:
                # Another thread may forget it at this moment.
                with suppress(ValueError):
                    self._references.remove(reference)
        self._references.append(ref(thing))

    def __iter__(self) -> Iterator[T]:
        for reference in self._references.copy():
            thing = reference()
            if thing is not None:
                yield thing

    def clear(self) -> None:
        """Forget all."""
        self._references.clear()


class LeftOpen:
    """Part of an object while that is open: it warns when it is dropped. An object that is closed drops it by `end`.

    Args:
        warn: is called when it is dropped before `end`.
    """

    __slots__ = ("_warn",)

    def __init__(self, warn: Callable[[], object]) -> None:
        self._warn: Callable[[], object] | None = warn

    def __del__(self) -> None:
        if self._warn is not None:
            self._warn()

    def end(self) -> None:
        """Warn of nothing."""
        self._warn = None
