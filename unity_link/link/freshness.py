"""Ages of the samples of one periodic group, for readers that want the newest alone."""

from __future__ import annotations

import math

MOST_DRIFT = 200e-6
"""Seconds a second by which two quartzes may differ."""
_MOST_PERIODS = 3
"""Periods by which a sample may be later than usual."""
_LEAST_LATE = 0.05
"""Seconds by which it may be later in any case: buffers and schedulers hold it back for so long."""
_FORGETTING = 0.1
"""Seconds a second by which a lateness that was usual is forgotten."""
_WINDOW = 0.5
"""Seconds over which samples tell that they come as fast as they are taken; for slow ones, more."""
_STEADY = 0.25
"""Part by which that speed may be off."""


class Freshness:
    """Tells samples of before a pause from others.

    The sample that was on its way for the shortest time says how the clocks of the gateway and of this machine go
    together, so the others have ages. One that is much older than usual shows that the program or the line has paused.
    From then on samples are old that were taken before it came, as long as they come faster than they are taken: others
    are the newest that there are.

    Args:
        rate_hz: of the samples.
    """

    def __init__(self, rate_hz: float) -> None:
        self._late = max(_MOST_PERIODS / rate_hz, _LEAST_LATE)
        self._window = max(8 / rate_hz, _WINDOW)
        self.forget()

    def forget(self) -> None:
        """Begin anew: the clock of the samples may be another one."""
        self._earliest = math.inf
        """Instant of time 0 of the samples' clock on this machine's, as the quickest sample says."""
        self._newest = -math.inf
        self._arrived = -math.inf
        self._usual = 0.0
        """Age that is no sign of a pause."""
        self._fresh_from: float | None = None
        """During and behind a pause: samples that were taken earlier are old."""
        self._window_began = (0.0, 0.0)
        """The instant of a sample, and of its arrival."""

    def is_old(self, instant: float, now: float) -> bool:
        """Return whether a sample that has arrived was taken before a pause.

        Args:
            instant: of sampling, in seconds of the samples' clock.
            now: in seconds of this machine's clock.
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
        """Return whether a sample that was fresh has waited over a pause."""
        if now - instant - self._earliest <= self._usual + self._late:
            return False
        self._pause(instant, now)
        return True

    def _pause(self, instant: float, now: float) -> None:
        self._fresh_from = now - self._earliest
        self._window_began = (instant, now)

    def _is_steady(self, instant: float, now: float) -> bool:
        """Return whether samples have come as fast as they are taken: nothing drains, so no newer one is near."""
        taken, passed = instant - self._window_began[0], now - self._window_began[1]
        if passed < self._window:
            return False
        self._window_began = (instant, now)
        return abs(taken - passed) <= _STEADY * passed
