"""A future for runtimes without asyncio: the part of `asyncio.Future` that links use."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


class Result:
    """A result or an error that is set later. Subclasses add `__await__`."""

    __slots__ = ("_done", "_error", "_result", "on_done")

    def __init__(self) -> None:
        self._done = False
        self._result: Any = None
        self._error: BaseException | None = None
        self.on_done: Callable[[], object] | None = None
        """Called when the future is done."""

    def done(self) -> bool:
        """Return whether the future has a result or an error, or was cancelled."""
        return self._done

    def cancelled(self) -> bool:
        """Return whether the future was cancelled."""
        return isinstance(self._error, asyncio.CancelledError)

    def cancel(self) -> bool:
        """Cancel the future; return False if it was done before."""
        if self._done:
            return False
        self.set_exception(asyncio.CancelledError())
        return True

    def set_result(self, result: object, /) -> None:
        """Set the result, and resume the awaiting call."""
        self._result = result
        self._end()

    def set_exception(self, exception: BaseException, /) -> None:
        """Set an error, which the awaiting call raises."""
        self._error = exception
        self._end()

    def exception(self) -> BaseException | None:
        """Return the error of a future that is done, or None."""
        return self._error

    def result(self) -> Any:
        """Return the result of a future that is done, or raise its error."""
        error = self._error
        if error is not None:
            # Raise a new CancelledError: the traceback of the stored one would keep the frames of the awaiting calls.
            raise asyncio.CancelledError(*error.args) if isinstance(error, asyncio.CancelledError) else error
        return self._result

    def _end(self) -> None:
        self._done = True
        if self.on_done is not None:
            self.on_done()
