"""The pace at which a machine works out clock cycles, compared with that of time."""

from __future__ import annotations

import logging

_LOG = logging.getLogger("unity_link.rtl")
WINDOW = 2.0
"""Seconds over which both are compared."""
MOST_LEFT_OUT = 0.05
"""Part of these that may be left out: a busy machine is late at times."""
LEAST_WORKED = 0.5
"""Part of these that was spent on cycles where they are what takes too long."""


class ClockPace:
    """Watches a gateway that leaves time out, and says once that it is too slow for its clock.

    Args:
        name: of the gateway.
        clock_hz: its frequency.
        is_free: whether a URL can name another clock.
    """

    def __init__(self, name: str, clock_hz: int, *, is_free: bool) -> None:
        self._name, self._clock_hz, self._is_free = name, clock_hz, is_free
        self._is_told = False
        self._began: float | None = None
        self._cycles, self._worked, self._left_out = 0, 0.0, 0.0

    def add(self, now: float, cycles: int, worked: float, left_out: float) -> None:
        """Take a turn of the gateway.

        Args:
            now: the instant in seconds up to which time has passed.
            cycles: that were worked out.
            worked: seconds which that took.
            left_out: seconds that were left out.
        """
        if self._is_told:
            return
        if self._began is None or now < self._began:
            self._began, self._cycles, self._worked, self._left_out = now, 0, 0.0, 0.0
            return
        self._cycles += cycles
        self._worked += worked
        self._left_out += left_out
        passed = now - self._began
        if passed >= WINDOW:
            if self._left_out > MOST_LEFT_OUT * passed and self._worked > LEAST_WORKED * passed:
                self._tell(1 - self._left_out / passed)
            self._began = None

    def _tell(self, pace: float) -> None:
        self._is_told = True
        advice = ""
        if self._is_free:
            # Half of what it does, so that the rest of the program has its time.
            wanted = f"{self._cycles / self._worked / 2:.0e}"
            advice = f"; clock_hz={float(wanted):.0f} in the URL gives it a clock that this machine keeps pace with"
        _LOG.warning(
            "the gateware of %s is slower than time: its clock of %s Hz runs at %.2g of its rate here, and seconds of "
            "its groups, leases and models last as much longer (told once)%s",
            self._name,
            f"{self._clock_hz:,}",
            pace,
            advice,
        )
