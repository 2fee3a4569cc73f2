"""Number of requests that may be under way: half the ring, what a receive FIFO holds, and fewer on a line that loses.

One damaged request costs all those sent behind it. So where the window goes back, fewer are kept in flight: half as
many, and at most four times as many as came through since it went back before; some that are done later it is one more.
"""

from __future__ import annotations

from unity_link.protocol.window.constants import DONE_FOR_ONE_MORE, FEWEST_IN_FLIGHT


class SendLimit:
    """Bounds of what is in flight.

    Args:
        most: requests in flight, at most.
        byte_limit: most unconfirmed request bytes, or None where flow control protects the gateway's receive FIFO.
    """

    __slots__ = ("_after_loss", "_came", "_most", "allowed", "byte_limit", "loses")

    def __init__(self, most: int, byte_limit: int | None) -> None:
        self._most = self.allowed = most
        self.byte_limit = byte_limit
        self.loses = False
        """True if fewer are kept in flight, for the line has lost some."""
        self._after_loss = self._came = 0

    def most_room(self, size: int) -> int:
        """Return for how many requests of `size` characters there is room while nothing is under way."""
        return self.allowed if self.byte_limit is None else min(self.allowed, max(1, self.byte_limit // size))

    def room(self, outstanding: int, outstanding_bytes: int, size: int, *, kept_free: bool) -> int:
        """Return how many more requests of `size` characters may be sent.

        Args:
            outstanding: requests that may still be lost.
            outstanding_bytes: characters of those that are not known to be executed.
            size: of each that may be sent.
            kept_free: whether one more place is left.
        """
        # A window of one has no room for both.
        room = self.allowed - outstanding - (kept_free and self._most > 1)
        if self.byte_limit is not None:
            by_bytes = (self.byte_limit - outstanding_bytes) // size - kept_free
            # A request longer than the whole FIFO goes alone.
            room = min(room, max(by_bytes, 0 if outstanding_bytes else 1))
        return room

    def lose(self) -> None:
        """Allow fewer, because some were lost."""
        if self.loses:
            self.allowed = min(self.allowed, 4 * self._came)
        self.allowed = self._after_loss = max(self.allowed // 2, min(FEWEST_IN_FLIGHT, self._most))
        self.loses = self.allowed < self._most
        self._came = 0

    def came_through(self, count: int) -> None:
        """Record how many more are done since some were lost, and let so many more be in flight."""
        self._came += count
        self.allowed = min(self._most, self._after_loss + self._came // DONE_FOR_ONE_MORE)
        self.loses = self.allowed < self._most
