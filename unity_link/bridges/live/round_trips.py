"""Round trips to the gateway: reads of one word, one after another, and a histogram of their durations."""

from __future__ import annotations

import asyncio
import math
import statistics
import time
from collections import deque
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import GatewayError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.data import Proxy

PAUSE = 0.1
"""Seconds between reads."""
RECENT = 600
"""Number of round trips for the median and the 99 % limit: those of a minute."""
SHORTEST = 1e-6
"""Lower end of the first bin of the histogram, in seconds."""
BINS_PER_DECADE = 10
BINS = 7 * BINS_PER_DECADE
"""Number of bins, up to ten seconds."""


class Histogram(msgspec.Struct, frozen=True):
    """Measured round trips, for the page."""

    counts: list[int]
    """Number of round trips in each bin of duration. Bins have equal ratios, `BINS_PER_DECADE` of them for a factor
    of 10, and begin at `SHORTEST`.
    """
    median: float | None
    within: float | None
    """Seconds within which 99 % of the recent round trips ended."""


class RoundTrips:
    """Measures the round trips of a link.

    Args:
        sampled: signals that are read repeatedly anyway. One of them is read again, but no queue, from which a read
            would take a sample's word.
    """

    def __init__(self, sampled: Sequence[Proxy[object]]) -> None:
        self._link = sampled[0].link
        self._read = next((proxy for proxy in sampled if not proxy.signal.fifo), None)
        self._counts = [0] * BINS
        self._recent: deque[float] = deque(maxlen=RECENT)
        self.refusal: str | None = None
        """Error of the last read, if it was refused; a server refuses all reads while its gateway is away."""

    async def run(self) -> None:
        """Measure until this is cancelled; return at once if all signals are queues.

        Raises:
            LinkLostError: if the link ends.
        """
        while self._read is not None:
            await asyncio.sleep(PAUSE)
            sessions = self._link.statistics.reconnections
            began = time.perf_counter()
            # An error is an answer, too, so its round trip counts.
            try:
                await self._read.bus.read(self._read.signal.address)
            except GatewayError as error:
                self.refusal = str(error)
            else:
                self.refusal = None
            # If the link was opened again meanwhile, the time is no round trip.
            if self._link.statistics.reconnections == sessions:
                self.take(time.perf_counter() - began)

    def take(self, seconds: float) -> None:
        """Count the duration of a round trip, in seconds."""
        place = math.floor(math.log10(max(seconds, SHORTEST) / SHORTEST) * BINS_PER_DECADE)
        self._counts[min(max(place, 0), BINS - 1)] += 1
        self._recent.append(seconds)

    def histogram(self) -> Histogram:
        """Return the histogram of all round trips so far."""
        recent = sorted(self._recent)
        median = statistics.median(recent) if recent else None
        within = recent[min(len(recent) - 1, math.ceil(0.99 * len(recent)))] if recent else None
        return Histogram(list(self._counts), median, within)
