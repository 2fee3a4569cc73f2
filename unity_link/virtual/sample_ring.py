"""Samples of the virtual gateway that wait in a ring buffer until the line has room.

The ring has the depth of the gateware's, in words; the head and the timestamp of a sample take one word each. Samples
are sent in order as soon as the line has room, alternating with responses. Before the response to a request that no
earlier sample may follow, all samples are sent.
"""

from __future__ import annotations

import math
from collections import deque

_DEFAULT_DEPTH = 256
"""Default depth of the gateware's ring, in words."""
_BESIDE_WORDS = 2
"""Number of words for the head and the timestamp of a sample."""


class SampleRing:
    """Ring buffer of samples that wait for the line.

    Args:
        group_words: largest number of words in a group; the ring holds at least one such sample.
    """

    def __init__(self, group_words: int) -> None:
        self.waiting: deque[tuple[bytes, int, bool]] = deque()
        """Frame, number of words, and whether the sample requests a flush."""
        self.flush_wanted = False
        """True after a sample that requests a flush was sent; the medium clears it at the flush."""
        self._depth = max(_DEFAULT_DEPTH, 1 << (group_words + _BESIDE_WORDS - 1).bit_length())
        self._left: list[bytes] = []
        self.reset()

    def reset(self) -> None:
        """Restore the state after power-up."""
        self.clear()
        self._left.clear()
        self._room = math.inf

    def clear(self) -> None:
        """Drop all waiting samples."""
        self.waiting.clear()
        self._free = self._depth

    @staticmethod
    def words_of(addresses: int, *, stamped: bool) -> int:
        """Return the number of words that a sample takes in the ring."""
        return addresses + 1 + stamped

    def open(self, room: float) -> None:
        """Set the room on the line in bytes, and send waiting samples until `room` bytes are sent."""
        self._room = room
        while self.waiting and self._room > 0:
            self._room -= self.send_one()

    def takes(self, words: int) -> bool:
        """Return True if there is room for a sample, on the line or in the ring."""
        return self._room > 0 or words <= self._free

    def put(self, frame: bytes, words: int, *, immediate: bool) -> None:
        """Send a sample, or store it in the ring; call this only after `takes` has returned True."""
        self.waiting.append((frame, words, immediate))
        self._free -= words
        if self._room > 0:
            self._room -= self.send_one()

    def send_one(self) -> int:
        """Send the oldest waiting sample, and return its length in bytes."""
        frame, words, immediate = self.waiting.popleft()
        self._free += words
        self.flush_wanted |= immediate
        self._left.append(frame)
        return len(frame)

    def send_all(self) -> None:
        """Send all waiting samples."""
        while self.waiting:
            self.send_one()

    def take(self) -> bytes:
        """Return the frames of all samples sent since the last call."""
        frames = b"".join(self._left)
        self._left.clear()
        return frames
