"""Round trips of the gateway: reads of one word, one after the other, and how often each duration came."""

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
"""Round trips that the median and the 99 % are of: a minute."""
SHORTEST = 1e-6
"""Seconds; the lower end of the first bin."""
BINS_PER_DECADE = 10
BINS = 7 * BINS_PER_DECADE
"""Up to ten seconds."""


class Histogram(msgspec.Struct, frozen=True):
    """Round trips measured, for the page."""

    counts: list[int]
    """Number of round trips of each duration: bins of equal ratio from `SHORTEST` on, `BINS_PER_DECADE` for a factor of
    10.
    """
    median: float | None
    within: float | None
    """Seconds within which 99 % of the recent round trips were."""


class RoundTrips:
    """Measures the round trips of a link.

    Args:
        sampled: signals that are read all the time anyway, so that another read of one changes nothing; but of a queue
            it would take what is to be sampled.
    """

    def __init__(self, sampled: Sequence[Proxy[object]]) -> None:
        self._link = sampled[0].link
        self._read = next((proxy for proxy in sampled if not proxy.signal.fifo), None)
        self._counts = [0] * BINS
        self._recent: deque[float] = deque(maxlen=RECENT)
        self.refusal: str | None = None
        """Why the last read was refused; a shared gateway that is away refuses all."""

    async def run(self) -> None:
        """Measure until it is cancelled, where there is something to read.

        Raises:
            LinkLostError: where the link ends.
        """
        while self._read is not None:
            await asyncio.sleep(PAUSE)
            sessions = self._link.statistics.reconnections
            began = time.perf_counter()
            # An error is an answer, too.
            try:
                await self._read.bus.read(self._read.signal.address)
            except GatewayError as error:
                self.refusal = str(error)
            else:
                self.refusal = None
            # How long a link was away is no round trip.
            if self._link.statistics.reconnections == sessions:
                self.take(time.perf_counter() - began)

    def take(self, seconds: float) -> None:
        """Count a round trip."""
        place = math.floor(math.log10(max(seconds, SHORTEST) / SHORTEST) * BINS_PER_DECADE)
        self._counts[min(max(place, 0), BINS - 1)] += 1
        self._recent.append(seconds)

    def histogram(self) -> Histogram:
        """Return what was measured so far."""
        recent = sorted(self._recent)
        median = statistics.median(recent) if recent else None
        within = recent[min(len(recent) - 1, math.ceil(0.99 * len(recent)))] if recent else None
        return Histogram(list(self._counts), median, within)
