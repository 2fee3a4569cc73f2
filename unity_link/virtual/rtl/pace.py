"""Compares the rate at which a machine computes clock cycles with real time."""

from __future__ import annotations

import logging

_LOG = logging.getLogger("unity_link.rtl")
WINDOW = 2.0
"""Length of a comparison in seconds."""
MOST_LEFT_OUT = 0.05
"""Fraction of the time that may be skipped without a warning, because a busy machine is sometimes late."""
LEAST_WORKED = 0.5
"""Fraction of the time that must be spent on cycles for a warning; otherwise other work is the reason for the delay."""


class ClockPace:
    """Logs one warning if a gateway that skips time is too slow for its clock.

    Args:
        name: name of the gateway.
        clock_hz: clock frequency of the gateway in Hz.
        is_free: True if a URL can select another clock frequency.
    """

    def __init__(self, name: str, clock_hz: int, *, is_free: bool) -> None:
        self._name, self._clock_hz, self._is_free = name, clock_hz, is_free
        self._is_told = False
        self._began: float | None = None
        self._cycles, self._worked, self._left_out = 0, 0.0, 0.0

    def add(self, now: float, cycles: int, worked: float, left_out: float) -> None:
        """Record a turn of the gateway.

        Args:
            now: time in seconds at the end of the turn.
            cycles: number of computed cycles.
            worked: seconds of real time for these cycles.
            left_out: skipped seconds.
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
            # Advise half of the possible clock frequency, so that the program has time for other work.
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
