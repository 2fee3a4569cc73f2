"""Round trips, and the retransmission timeout that follows from them (RFC 6298).

1. One request at a time is timed, and none that was retransmitted (Karn's algorithm).
2. The timeout is the smoothed round trip plus four times its variation, but at least twice the round trip.
3. Messages have very different sizes, unlike the segments of RFC 6298. So the time that the bytes in flight take on the
   wire is added to the timeout.
4. Each timeout doubles the timeout (backoff), up to `LONGEST_TIMEOUT`.
"""

from __future__ import annotations

import math

from unity_link.protocol.window.constants import FIRST_TIMEOUT, LONGEST_TIMEOUT, MEASUREMENT_PAUSE


class RoundTrip:
    """Estimate of the round trips of one session.

    Args:
        byte_time: upper limit of the seconds that one byte takes on the wire; measured round trips lower it.
        first: first measured round trip in seconds, or None.
        shortest_timeout: lower limit of the timeout in seconds, above the delay that the medium may add to an answer.
    """

    __slots__ = (
        "_byte_time",
        "_bytes",
        "_measured_timeout",
        "_reply_byte_time",
        "_reply_bytes",
        "_shortest_timeout",
        "_since",
        "_timeout",
        "_variation",
        "has_backed_off",
        "least",
        "next_measurement",
        "smoothed",
        "timed",
    )

    def __init__(self, byte_time: float, first: float | None, shortest_timeout: float) -> None:
        self._byte_time = self._reply_byte_time = byte_time
        self._shortest_timeout = shortest_timeout
        self._measured_timeout = self._timeout = FIRST_TIMEOUT
        self._variation = 0.0
        self.smoothed: float | None = None
        """Smoothed round trip in seconds (SRTT of RFC 6298), None before the first measurement."""
        self.least = 0.0 if first is None else first
        """Shortest measured round trip in seconds."""
        self.has_backed_off = False
        """True if timeouts have doubled the timeout since the last measurement."""
        self.timed: int | None = None
        """ID of the request that is being timed; None if there is none."""
        self._since = 0.0
        self._bytes = self._reply_bytes = 1
        self.next_measurement = -math.inf
        """Earliest instant at which the next request is timed."""
        if first is not None:
            self._measure(first)

    def begin(self, number: int, now: float, size: int, reply_size: int) -> None:
        """Begin to time a request.

        Args:
            number: its ID.
            now: instant of its transmission.
            size: characters of all requests in flight, this one included.
            reply_size: characters of its answer.
        """
        self.timed, self._since = number, now
        self._bytes, self._reply_bytes = size, reply_size

    def end(self, now: float) -> None:
        """Record the answer to the timed request."""
        round_trip = now - self._since
        self._measure(round_trip)
        self._byte_time = min(self._byte_time, round_trip / self._bytes)
        self._reply_byte_time = min(self._reply_byte_time, round_trip / self._reply_bytes)
        self.timed = None
        self.next_measurement = now + MEASUREMENT_PAUSE

    def back_off(self) -> None:
        """Double the timeout."""
        self._timeout = min(2 * self._timeout, LONGEST_TIMEOUT)
        self.has_backed_off = self._timeout != self._measured_timeout

    def end_backoff(self) -> None:
        """Reset the timeout to the value of the measured round trips."""
        self._timeout = self._measured_timeout
        self.has_backed_off = False

    def time_out(self, size: int, reply_size: int) -> float:
        """Return the timeout of an answer in seconds.

        Args:
            size: characters of all requests in flight.
            reply_size: characters of the answer.
        """
        return self._timeout + self._wire_time(size, reply_size)

    def longest(self, size: int, reply_size: int) -> float:
        """Return the timeout without backoff, in seconds; the arguments are those of `time_out`."""
        return self._measured_timeout + self._wire_time(size, reply_size)

    def _wire_time(self, size: int, reply_size: int) -> float:
        return self._byte_time * size + self._reply_byte_time * reply_size

    def _measure(self, round_trip: float) -> None:
        """Update the smoothed round trip, its variation and the timeout (RFC 6298, section 2)."""
        if self.smoothed is None:
            self.smoothed = round_trip
            self._variation = round_trip / 2
        else:
            self._variation += (abs(self.smoothed - round_trip) - self._variation) / 4
            self.smoothed += (round_trip - self.smoothed) / 8
        self.least = min(self.least, round_trip)
        wanted = self.smoothed + max(4 * self._variation, self.smoothed)
        self._measured_timeout = min(max(wanted, self._shortest_timeout), LONGEST_TIMEOUT)
        self.end_backoff()
