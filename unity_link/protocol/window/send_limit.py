"""The send limit: the most requests and bytes in flight (the congestion window of RFC 5681).

1. At most half of the sequence space is in flight, and without flow control at most the bytes of the receive FIFO.
2. A lost request costs the retransmission of all requests after it. So each loss halves the number of requests, to at
   least `FEWEST_IN_FLIGHT`. From the second loss on it is also at most four times the requests done since the last one.
3. Every `DONE_FOR_ONE_MORE` requests that are done raise the limit by one.
"""

from __future__ import annotations

from unity_link.protocol.window.constants import DONE_FOR_ONE_MORE, FEWEST_IN_FLIGHT


class SendLimit:
    """Limits of the requests in flight.

    Args:
        most: most requests in flight on a line without loss.
        byte_limit: most unconfirmed request bytes; None if flow control protects the gateway's receive FIFO.
    """

    __slots__ = ("_after_loss", "_came", "_most", "allowed", "byte_limit", "loses")

    def __init__(self, most: int, byte_limit: int | None) -> None:
        self._most = self.allowed = most
        self.byte_limit = byte_limit
        self.loses = False
        """True if losses have lowered the limit, and it is not at its maximum again."""
        self._after_loss = self._came = 0
        """The limit right after the last loss, and the number of requests done since."""

    def most_room(self, size: int) -> int:
        """Return how many requests of `size` characters may be sent while none is in flight."""
        return self.allowed if self.byte_limit is None else min(self.allowed, max(1, self.byte_limit // size))

    def room(self, outstanding: int, outstanding_bytes: int, size: int, *, kept_free: bool) -> int:
        """Return how many more requests of `size` characters may be sent.

        Args:
            outstanding: number of requests in flight that may have to be retransmitted.
            outstanding_bytes: characters of the requests whose execution is not confirmed.
            size: characters of each request to send.
            kept_free: reserve one place for an ``h``.
        """
        # A window of one request has no place to reserve.
        room = self.allowed - outstanding - (kept_free and self._most > 1)
        if self.byte_limit is not None:
            by_bytes = (self.byte_limit - outstanding_bytes) // size - kept_free
            # A request longer than the whole FIFO is sent while no other is in flight.
            room = min(room, max(by_bytes, 0 if outstanding_bytes else 1))
        return room

    def lose(self) -> None:
        """Lower the limit after a loss."""
        if self.loses:
            self.allowed = min(self.allowed, 4 * self._came)
        self.allowed = self._after_loss = max(self.allowed // 2, min(FEWEST_IN_FLIGHT, self._most))
        self.loses = self.allowed < self._most
        self._came = 0

    def came_through(self, count: int) -> None:
        """Record `count` requests as done since the last loss, and raise the limit."""
        self._came += count
        self.allowed = min(self._most, self._after_loss + self._came // DONE_FOR_ONE_MORE)
        self.loses = self.allowed < self._most
