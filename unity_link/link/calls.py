"""Marks for plain methods that return a coroutine.

Some methods look up their caller before they return a coroutine. `asyncio.wait_for`, `asyncio.gather` and
`asyncio.create_task` run a coroutine in a task of its own, so inside it the current task is not the caller.
"""

from __future__ import annotations

import asyncio
import functools
import inspect
import sys
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

F = TypeVar("F", bound="Callable[..., Any]")

if sys.version_info >= (3, 12):

    def returns_coroutine(function: F) -> F:
        """Mark a function as a coroutine function, for `inspect` and `asyncio`."""
        return inspect.markcoroutinefunction(function)

    def is_asynchronous(function: object) -> bool:
        """Return whether a call of a function returns a coroutine."""
        return inspect.iscoroutinefunction(function)

else:

    def returns_coroutine(function: F) -> F:
        """Mark a function as a coroutine function, for `asyncio`; `inspect` has no mark in Python 3.11."""
        function._is_coroutine = asyncio.coroutines._is_coroutine  # type: ignore[attr-defined]  # noqa: SLF001
        return function

    def is_asynchronous(function: object) -> bool:
        """Return whether a call of a function returns a coroutine."""
        while isinstance(function, functools.partial):
            function = function.func
        return asyncio.iscoroutinefunction(function)
