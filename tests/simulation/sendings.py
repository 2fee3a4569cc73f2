"""Transmissions of each request, counted at the windows of all links and servers of a scenario."""

from __future__ import annotations

import contextlib
from collections import Counter
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

from unity_link.protocol.window.window import Window

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.protocol.window.sequence_space import Part

_repeat = Window.repeat


class Sendings:
    """Retransmissions of windows, counted for each request."""

    def __init__(self) -> None:
        self._runs: dict[int, Any] = {}
        """Retransmitted sources, stored so that no other object gets their `id`."""
        self._by_signs: Counter[tuple[int, int]] = Counter()
        self._by_time: Counter[tuple[int, int]] = Counter()

    @property
    def most(self) -> int:
        """Largest number of transmissions of a request."""
        return 1 + max((self._by_signs + self._by_time).values(), default=0)

    @property
    def most_by_signs(self) -> int:
        """Largest number of transmissions of a request, without those after a time-out."""
        return 1 + max(self._by_signs.values(), default=0)

    def repeat(self, window: Window[Any]) -> list[Part[Any]]:
        """Return the parts that a window retransmits, and count them."""
        counted = self._by_time if window.loss.timed_out else self._by_signs
        parts = _repeat(window)
        for _, run, offset, count in parts:
            self._runs[id(run)] = run
            counted.update((id(run), place) for place in range(offset, offset + count))
        return parts


@contextlib.contextmanager
def watched() -> Iterator[Sendings]:
    """Count at all windows."""
    sendings = Sendings()

    def repeat(window: Window[Any]) -> list[Part[Any]]:
        return sendings.repeat(window)

    with patch.object(Window, "repeat", repeat):
        yield sendings
