"""The awaitable of calls where there is no event loop: as much of `asyncio.Future` as links need."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


class Result:
    """A result or an error that comes later. What derives from it is awaitable."""

    __slots__ = ("_done", "_error", "_result", "on_done")

    def __init__(self) -> None:
        self._done = False
        self._result: Any = None
        self._error: BaseException | None = None
        self.on_done: Callable[[], object] | None = None
        """Is called when there is a result or an error."""

    def done(self) -> bool:
        """Return whether there is a result or an error, or it was cancelled."""
        return self._done

    def cancelled(self) -> bool:
        """Return whether it was cancelled."""
        return isinstance(self._error, asyncio.CancelledError)

    def cancel(self) -> bool:
        """Cancel it, and return whether it was not done before."""
        if self._done:
            return False
        self.set_exception(asyncio.CancelledError())
        return True

    def set_result(self, result: object, /) -> None:
        """Resume the awaiting call with a result."""
        self._result = result
        self._end()

    def set_exception(self, exception: BaseException, /) -> None:
        """Resume the awaiting call with an error."""
        self._error = exception
        self._end()

    def exception(self) -> BaseException | None:
        """Return the error of one that is done."""
        return self._error

    def result(self) -> Any:
        """Return the result of one that is done, or raise its error."""
        error = self._error
        if error is not None:
            # The traceback has what waits for this, and the call in which that was: one that is kept would keep them.
            raise asyncio.CancelledError(*error.args) if isinstance(error, asyncio.CancelledError) else error
        return self._result

    def _end(self) -> None:
        self._done = True
        if self.on_done is not None:
            self.on_done()
