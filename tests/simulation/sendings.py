"""Sendings of each request: watched at the windows of all links and servers of a world."""

from __future__ import annotations

import contextlib
from collections import Counter
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

from unity_link.protocol.window import Window

if TYPE_CHECKING:
    from collections.abc import Iterator

_repetition = Window.repetition


class Sendings:
    """Repetitions of windows, counted for each request."""

    def __init__(self) -> None:
        self._runs: dict[int, Any] = {}
        """Sources that were sent again, kept so that no other gets their identity."""
        self._by_signs: Counter[tuple[int, int]] = Counter()
        self._by_time: Counter[tuple[int, int]] = Counter()

    @property
    def most(self) -> int:
        """Most sendings of a request."""
        return 1 + max((self._by_signs + self._by_time).values(), default=0)

    @property
    def most_by_signs(self) -> int:
        """Most sendings of a request, but for those because nothing had come in time."""
        return 1 + max(self._by_signs.values(), default=0)

    def repetition(self, window: Window[Any]) -> Iterator[tuple[int, Any, int, int]]:
        """Return what a window repeats, and count it."""
        counted = self._by_time if window.timed_out else self._by_signs
        for part in _repetition(window):
            _, run, offset, count = part
            self._runs[id(run)] = run
            counted.update((id(run), place) for place in range(offset, offset + count))
            yield part


@contextlib.contextmanager
def watched() -> Iterator[Sendings]:
    """Watch all windows."""
    sendings = Sendings()

    def repetition(window: Window[Any]) -> Iterator[tuple[int, Any, int, int]]:
        return sendings.repetition(window)

    with patch.object(Window, "repetition", repetition):
        yield sendings
