"""Devices that return each event once, to the read that clears it: a queue of numbers, and a register.

Writes to these devices fail.
"""

from __future__ import annotations

import itertools
import random
from collections import deque

from unity_link.virtual.faults import Failing

QUEUE, CLEARED = 0xD0, 0xD4
"""Addresses at which tests attach the two devices."""


class Numbers(Failing):
    """A queue that returns each number once."""

    def __init__(self) -> None:
        super().__init__()
        self._next = itertools.count(1)

    def read(self, offset: int, now: float) -> int:
        return next(self._next)


class Cleared(Failing):
    """A register with random events. A read returns and clears them, and sets new ones."""

    def __init__(self) -> None:
        super().__init__()
        self._draw = random.Random(5)
        self.made: deque[int] = deque()

    def read(self, offset: int, now: float) -> int:
        given = self._draw.getrandbits(32)
        self.made.append(given)
        return given
