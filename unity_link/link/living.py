"""Weak lists of objects, and warnings about objects that were not closed.

A callback of a weak reference, or a `__del__`, may run anywhere in the main thread. If a signal handler runs during
such code, Python drops the exception of the handler, such as the `KeyboardInterrupt` of a Ctrl-C. So `Living` uses no
callbacks, and a closed object has no `__del__` left.
"""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Generic, TypeVar
from weakref import ref

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

T = TypeVar("T")


class Living(Generic[T]):
    """A list of weak references without callbacks. Any thread may add an object."""

    def __init__(self) -> None:
        self._references: list[ref[T]] = []

    def add(self, thing: T) -> None:
        """Add an object, and remove references to objects that no longer exist."""
        for reference in self._references.copy():
            if reference() is None:
                # Another thread may remove it at the same time.
                with suppress(ValueError):
                    self._references.remove(reference)
        self._references.append(ref(thing))

    def __iter__(self) -> Iterator[T]:
        for reference in self._references.copy():
            thing = reference()
            if thing is not None:
                yield thing

    def clear(self) -> None:
        """Remove all references."""
        self._references.clear()


class LeftOpen:
    """An attribute of an open object that warns if the object is deleted before `end` was called.

    Args:
        warn: called in that case.
    """

    __slots__ = ("_warn",)

    def __init__(self, warn: Callable[[], object]) -> None:
        self._warn: Callable[[], object] | None = warn

    def __del__(self) -> None:
        if self._warn is not None:
            self._warn()

    def end(self) -> None:
        """Disable the warning, because the object was closed."""
        self._warn = None
