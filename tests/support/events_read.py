"""Devices that give each event once, to the read that clears it: a queue of numbers, and a register."""

from __future__ import annotations

import itertools
import random
from collections import deque

QUEUE, CLEARED = 0xD0, 0xD4
"""Addresses at which tests attach them."""


class Numbers:
    """A queue that gives each number once."""

    def __init__(self) -> None:
        self._next = itertools.count(1)

    def read(self, offset: int, now: float) -> int:
        return next(self._next)

    def write(self, offset: int, value: int, now: float) -> None:
        raise NotImplementedError


class Cleared:
    """A register that has other events after each read, which clears what it gives."""

    def __init__(self) -> None:
        self._draw = random.Random(5)
        self.made: deque[int] = deque()

    def read(self, offset: int, now: float) -> int:
        given = self._draw.getrandbits(32)
        self.made.append(given)
        return given

    def write(self, offset: int, value: int, now: float) -> None:
        raise NotImplementedError
