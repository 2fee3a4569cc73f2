"""Ages of the samples of a periodic group, for readers that want only the newest sample."""

from __future__ import annotations

import math

MOST_DRIFT = 200e-6
"""Relative difference of two quartz clocks, at most."""
_MOST_PERIODS = 3
"""Periods that a sample may be later than usual without a pause."""
_LEAST_LATE = 0.05
"""Seconds that a sample may be later than usual in any case, because of buffers and schedulers."""
_FORGETTING = 0.1
"""Seconds per second by which the usual age decreases."""
_WINDOW = 0.5
"""Fewest seconds over which the rate of arrival is compared with the rate of sampling."""
_STEADY = 0.25
"""Relative difference of these two rates, at most, if they count as equal."""


class Freshness:
    """Detects samples that were taken before a pause of the program or the line, and arrive after it.

    1. The sample with the shortest delay relates the clocks of the gateway and of this machine. It gives each other
       sample an age.
    2. A sample that is much older than usual shows a pause.
    3. After a pause, samples taken before its end are old, while they arrive faster than they are taken. If they arrive
       as fast as they are taken, no buffer is being emptied, and they are the newest samples available.

    Args:
        rate_hz: rate of the samples.
    """

    def __init__(self, rate_hz: float) -> None:
        self._late = max(_MOST_PERIODS / rate_hz, _LEAST_LATE)
        self._window = max(8 / rate_hz, _WINDOW)
        self.forget()

    def forget(self) -> None:
        """Reset the state, because the samples may have another clock from now on."""
        self._earliest = math.inf
        """Time 0 of the samples' clock, in seconds of this machine's clock, from the sample with the shortest delay."""
        self._newest = -math.inf
        self._arrived = -math.inf
        self._usual = 0.0
        """Age in seconds that does not show a pause."""
        self._fresh_from: float | None = None
        """After a pause: samples taken before this instant are old; None without a pause."""
        self._window_began = (0.0, 0.0)
        """Instants of sampling and of arrival of the first sample of the window in `_is_steady`."""

    def is_old(self, instant: float, now: float) -> bool:
        """Return whether a sample that arrives now was taken before a pause.

        Args:
            instant: instant of sampling, in seconds of the samples' clock.
            now: instant of arrival, in seconds of this machine's clock.
        """
        passed = max(0.0, instant - self._newest) if self._arrived > -math.inf else 0.0
        self._earliest = min(now - instant, self._earliest + MOST_DRIFT * passed)
        self._usual = max(0.0, self._usual - _FORGETTING * passed)
        age = now - instant - self._earliest
        if self._fresh_from is None:
            if age > self._usual + self._late:
                self._pause(instant, now)
        elif now - self._arrived > self._late:
            self._fresh_from = now - self._earliest
        self._newest, self._arrived = instant, now
        if self._fresh_from is not None and instant < self._fresh_from and not self._is_steady(instant, now):
            return True
        self._usual = age if self._fresh_from is not None else max(self._usual, age)
        self._fresh_from = None
        return False

    def has_aged(self, instant: float, now: float) -> bool:
        """Return whether a buffered sample is old now, because its reader has paused."""
        if now - instant - self._earliest <= self._usual + self._late:
            return False
        self._pause(instant, now)
        return True

    def _pause(self, instant: float, now: float) -> None:
        self._fresh_from = now - self._earliest
        self._window_began = (instant, now)

    def _is_steady(self, instant: float, now: float) -> bool:
        """Return whether samples arrived as fast as they were taken in the window, so that no buffer is emptied."""
        taken, passed = instant - self._window_began[0], now - self._window_began[1]
        if passed < self._window:
            return False
        self._window_began = (instant, now)
        return abs(taken - passed) <= _STEADY * passed
