"""The samples of the virtual gateway on their way out: what finds room on the line leaves, the rest waits in a ring.

The ring is as deep as that of the gateware, and counted as there: in words, the head and the timestamp of a sample one
each. What waits leaves in its order as soon as there is room again, in turns with responses, or all at once before the
response to a request after which none of it may come.
"""

from __future__ import annotations

import math
from collections import deque

_DEFAULT_DEPTH = 256
"""Words, as the gateware has by default."""
_BESIDE_WORDS = 2
"""Words of a sample that are not those of its group."""


class SampleRing:
    """Ring of samples that wait for the line.

    Args:
        group_words: the most words in a group, of which at least one sample must fit.
    """

    def __init__(self, group_words: int) -> None:
        self.waiting: deque[tuple[bytes, int, bool]] = deque()
        """Frame, words, and whether it is to be sent immediately."""
        self.flush_wanted = False
        """A sample that is to be sent immediately has left; cleared by the one who flushes."""
        self._depth = max(_DEFAULT_DEPTH, 1 << (group_words + _BESIDE_WORDS - 1).bit_length())
        self._left: list[bytes] = []
        self.reset()

    def reset(self) -> None:
        """Go back to the state after power-up."""
        self.clear()
        self._left.clear()
        self._room = math.inf

    def clear(self) -> None:
        """Forget what waits."""
        self.waiting.clear()
        self._free = self._depth

    @staticmethod
    def words_of(addresses: int, *, stamped: bool) -> int:
        """Return how many words of the ring a sample takes."""
        return addresses + 1 + stamped

    def open(self, room: float) -> None:
        """Let samples leave as long as fewer than `room` bytes have left, those that wait first."""
        self._room = room
        while self.waiting and self._room > 0:
            self._room -= self.send_one()

    def takes(self, words: int) -> bool:
        """Return whether there is room for a sample, on the line or in the ring."""
        return self._room > 0 or words <= self._free

    def put(self, frame: bytes, words: int, *, immediate: bool) -> None:
        """Send a sample that the ring takes, or have it wait."""
        self.waiting.append((frame, words, immediate))
        self._free -= words
        if self._room > 0:
            self._room -= self.send_one()

    def send_one(self) -> int:
        """Remove the first of those that wait, and return its length."""
        frame, words, immediate = self.waiting.popleft()
        self._free += words
        self.flush_wanted |= immediate
        self._left.append(frame)
        return len(frame)

    def send_all(self) -> None:
        """Remove all that wait."""
        while self.waiting:
            self.send_one()

    def take(self) -> bytes:
        """Return the frames that have left since the last call."""
        frames = b"".join(self._left)
        self._left.clear()
        return frames
