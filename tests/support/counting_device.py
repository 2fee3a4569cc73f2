"""A device of which each read, and so each sample, has another value."""

from __future__ import annotations


class CountingDevice:
    """A device that counts its reads, so that no two samples are equal."""

    def __init__(self) -> None:
        self.count = 0

    def read(self, offset: int, now: float) -> int:
        self.count += 1
        return self.count

    def write(self, offset: int, value: int, now: float) -> None:
        self.count = value
