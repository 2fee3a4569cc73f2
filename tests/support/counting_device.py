"""A device behind a virtual gateway whose every sample is another one, so that none can be taken for the next."""

from __future__ import annotations


class CountingDevice:
    """A device that counts its reads, so that no two samples are the same."""

    def __init__(self) -> None:
        self.count = 0

    def read(self, offset: int, now: float) -> int:
        self.count += 1
        return self.count

    def write(self, offset: int, value: int, now: float) -> None:
        self.count = value
