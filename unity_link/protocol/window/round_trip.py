"""The duration of answers: round trips as they were measured, and the time out that follows from them (RFC 6298).

One request at a time is timed, and none that was sent twice. Messages here are of unlike sizes, which RFC 6298 does not
know: so the time that bytes need on the wire counts beside the time out.
"""

from __future__ import annotations

import math

from unity_link.protocol.window.constants import FIRST_TIMEOUT, LONGEST_TIMEOUT, MEASUREMENT_PAUSE


class RoundTrip:
    """Estimate of the round trips of one session.

    Args:
        byte_time: seconds that one byte may need on the wire, at most; round trips of many bytes show where it is less.
        first: a first measurement in seconds, if there is one.
        shortest_timeout: seconds that the medium may hold an answer back, and some more.
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
        "is_doubled",
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
        """Smoothed round trip in seconds (SRTT of RFC 6298), None before the first."""
        self.least = 0.0 if first is None else first
        """The least in seconds, 0 before the first."""
        self.is_doubled = False
        """True if the time out is longer than the round trips say, for nothing came in time."""
        self.timed: int | None = None
        """ID of the request that is timed."""
        self._since = 0.0
        self._bytes = self._reply_bytes = 1
        self.next_measurement = -math.inf
        """Earliest instant at which the next request is timed."""
        if first is not None:
            self._measure(first)

    def begin(self, number: int, now: float, size: int, reply_size: int) -> None:
        """Time a request that is sent now.

        Args:
            number: its ID.
            now: the time.
            size: characters of all that is under way, the request included.
            reply_size: characters of its answer.
        """
        self.timed, self._since = number, now
        self._bytes, self._reply_bytes = size, reply_size

    def end(self, now: float) -> None:
        """Record the answer to the request that is timed."""
        round_trip = now - self._since
        self._measure(round_trip)
        self._byte_time = min(self._byte_time, round_trip / self._bytes)
        self._reply_byte_time = min(self._reply_byte_time, round_trip / self._reply_bytes)
        self.timed = None
        self.next_measurement = now + MEASUREMENT_PAUSE

    def double(self) -> None:
        """Wait twice as long from now on."""
        self._timeout = min(2 * self._timeout, LONGEST_TIMEOUT)
        self.is_doubled = self._timeout != self._measured_timeout

    def undo_doubling(self) -> None:
        """Wait as long as the round trips say."""
        self._timeout = self._measured_timeout
        self.is_doubled = False

    def time_out(self, size: int, reply_size: int) -> float:
        """Return the seconds after which an answer is late.

        Args:
            size: characters of all that is under way.
            reply_size: characters of the answer.
        """
        return self._timeout + self._wire_time(size, reply_size)

    def longest(self, size: int, reply_size: int) -> float:
        """Return the same with nothing doubled."""
        return self._measured_timeout + self._wire_time(size, reply_size)

    def _wire_time(self, size: int, reply_size: int) -> float:
        return self._byte_time * size + self._reply_byte_time * reply_size

    def _measure(self, round_trip: float) -> None:
        """Adapt the time out (RFC 6298, section 2)."""
        if self.smoothed is None:
            self.smoothed = round_trip
            self._variation = round_trip / 2
        else:
            self._variation += (abs(self.smoothed - round_trip) - self._variation) / 4
            self.smoothed += (round_trip - self.smoothed) / 8
        self.least = min(self.least, round_trip)
        wanted = self.smoothed + max(4 * self._variation, self.smoothed)
        self._measured_timeout = min(max(wanted, self._shortest_timeout), LONGEST_TIMEOUT)
        self.undo_doubling()
