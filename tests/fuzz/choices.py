"""The bytes of an input, which choose the next events."""

from __future__ import annotations


class Choices:
    """The bytes of an input, taken one after another."""

    def __init__(self, data: bytes) -> None:
        self._data = data

    def __bool__(self) -> bool:
        return bool(self._data)

    def take(self, count: int = 1) -> bytes:
        """Return the next bytes, fewer at the end."""
        taken, self._data = self._data[:count], self._data[count:]
        return taken

    def number(self) -> int:
        """Return the next byte, 0 at the end."""
        return self.take()[0] if self._data else 0
