"""The gateway's clock: a time in seconds without wrap-around, from timestamps of 32 bits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.link.freshness import MOST_DRIFT

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

TICKS_PER_TURN = 1 << 32
"""Ticks after which a timestamp wraps around; a *turn* of the counter."""
_ROUND = 256
"""Samples after which a sequence number wraps around."""
_LONGEST_BUSY = 200e-6
"""Most seconds that a due sample waits for the bus."""
_MOST_ROUNDING = 1e-6
"""Relative rounding error of a rate, at most."""
RESET_TOLERANCE = 1
"""Most seconds between the expected and the received time after an interruption, if the gateway was not reset."""


class GatewayClock:
    """Extends timestamps of 32 bits to a time without wrap-around.

    1. A timestamp may mean several instants, one turn of the counter apart. `seconds` guesses the one nearest to the
       time that has passed on this machine since the last timestamp.
    2. The guess is wrong if the program paused for half a turn or longer (43 s at 50 MHz) while samples waited. Then
       the sequence numbers of periodic groups decide: `turns_from` and `correct`.
    3. A reset of the gateway also resets its counter. If the first timestamp of a session is not within
       `RESET_TOLERANCE` of the expected time, the time continues at the expected one, so that it never goes back.

    Args:
        frequency_hz: frequency of the gateway's clock.
    """

    def __init__(self, frequency_hz: int) -> None:
        self.turn = TICKS_PER_TURN / frequency_hz
        """Seconds after which a timestamp wraps around."""
        self.corrections = 0
        """Sum of all corrections of guesses, in turns of the counter."""
        self._frequency = frequency_hz
        self._ticks: int | None = None
        """The last timestamp without wrap-around, in ticks; None before the first."""
        self._at = 0.0
        """Instant of its arrival on this machine."""
        self._earliest = self._earliest_before = math.inf
        """Time 0 of the gateway's clock in seconds of this machine's clock, from the sample with the shortest delay.
        The second is the value before the last guess."""
        self._offset = 0
        """Ticks that are added to timestamps since the last reset of the gateway."""
        self._began = -math.inf
        """Time of the first sample since that reset."""
        self._resumed = False
        """True if the next timestamp is the first of a session after the first session."""

    def resume(self) -> None:
        """Prepare for the first timestamp of a new session."""
        self._resumed = self._ticks is not None

    def seconds(self, timestamp: int, now: float) -> float:
        """Return the time of a timestamp in seconds; `now` is the instant of its arrival on this machine."""
        if self._ticks is None:
            ticks = timestamp
        elif self._resumed:
            ticks = self._first_of_session(timestamp, int((now - self._earliest) * self._frequency))
        else:
            ticks = self._nearest(timestamp, self._ticks + int((now - self._at) * self._frequency))
        self._resumed = False
        seconds = ticks / self._frequency
        self._earliest_before = self._earliest + MOST_DRIFT * (now - self._at)
        self._earliest = min(now - seconds, self._earliest_before)
        self._ticks, self._at = ticks, now
        return seconds

    def timestamp(self, seconds: float) -> int:
        """Return the gateway's timestamp for a time in seconds.

        Raises:
            ArgumentError: if the time is before the gateway's last reset, since when its counter has begun again.
        """
        if seconds < self._began:
            raise ArgumentError(f"the sample of {seconds:.6f} s was taken before the gateway was reset")
        return (round(seconds * self._frequency) - self._offset) % TICKS_PER_TURN

    def age(self, seconds: float, now: float) -> float:
        """Return the seconds from a time of the gateway's clock to `now`; 0 before the first sample."""
        return max(0.0, now - self._earliest - seconds) if self._earliest < math.inf else 0.0

    def _first_of_session(self, timestamp: int, estimate: int) -> int:
        ticks, last = self._nearest(timestamp, estimate), self._ticks or 0
        if last < ticks and abs(ticks - estimate) < RESET_TOLERANCE * self._frequency:
            return ticks
        first = max(estimate, last + 1)
        self._offset += first - ticks
        self._began = first / self._frequency
        return first

    def _nearest(self, timestamp: int, estimate: int) -> int:
        return (
            estimate
            + ((timestamp + self._offset - estimate + TICKS_PER_TURN // 2) % TICKS_PER_TURN)
            - TICKS_PER_TURN // 2
        )

    def seconds_of(self, timestamps: NDArray[np.unsignedinteger], now: float, expected: int = 0) -> NDArray[np.float64]:
        """Return the times of timestamps that arrived together, in seconds; shape (n,).

        Args:
            timestamps: the timestamps in order, shape (n,).
            now: instant of their arrival.
            expected: expected ticks from each timestamp to the next.
        """
        self.seconds(int(timestamps[0]), now)
        assert self._ticks is not None
        ticks = steps_between(timestamps, expected)
        ticks[0] = self._ticks
        ticks = ticks.cumsum()
        self._ticks = int(ticks[-1])
        self._earliest = min(self._earliest, now - self._ticks / self._frequency)
        return ticks / self._frequency

    def turns_from(self, last: float, at: float, advance: int, rate_hz: float, now: float) -> int:
        """Return by how many turns of the counter the guessed time of a periodic sample is too early.

        The result gives the earliest instant that fits both the sequence number and the timestamp; 0 if none fits.

        Args:
            last: time of the previous sample, in seconds.
            at: guessed time of the sample, in seconds.
            advance: difference of the sequence numbers, 1 to 256; further multiples of 256 are possible.
            rate_hz: rate of the samples.
            now: instant of the sample's arrival.
        """
        turn, guessed = self.turn, at - last
        first, most = guessed % turn, now - self._earliest - last + self.turn / 2
        step = max(turn, _ROUND / rate_hz)
        for number in range(1 + max(0, int(most / step))):
            if step == turn:
                after = first + number * turn
                periods = after * rate_hz
                off = (periods - advance + _ROUND / 2) % _ROUND - _ROUND / 2
            else:
                periods = advance + number * _ROUND
                after = first + round((periods / rate_hz - first) / turn) * turn
                off = after * rate_hz - periods
            if abs(off) <= tolerance_of(rate_hz, turn) + _MOST_ROUNDING * periods or turn * rate_hz < 1:
                return round((after - guessed) / turn)
        return 0

    def correct(self, turns: int) -> None:
        """Correct the last guess by turns of the counter."""
        assert self._ticks is not None
        self.corrections += turns
        self._ticks += turns * TICKS_PER_TURN
        self._earliest = min(self._earliest_before, self._at - self._ticks / self._frequency)

    def moved(self, instant: float, turns: int) -> float:
        """Return an instant that is `turns` turns of the counter later, rounded to a tick."""
        return (round(instant * self._frequency) + turns * TICKS_PER_TURN) / self._frequency


def steps_between(timestamps: NDArray[np.unsignedinteger], expected: int) -> NDArray[np.int64]:
    """Return the ticks between successive timestamps, unwrapped to the values nearest `expected`; shape (n,).

    The first is 0.
    """
    steps = timestamps.astype("int64")
    steps[1:] = (
        (steps[1:] - steps[:-1] - expected + TICKS_PER_TURN // 2) % TICKS_PER_TURN - TICKS_PER_TURN // 2 + expected
    )
    steps[0] = 0
    return steps


def tolerance_of(rate_hz: float, turn: float) -> float:
    """Return the most periods by which a sample may be late, because the bus was busy when it was due.

    Args:
        rate_hz: rate of the samples.
        turn: seconds after which a timestamp wraps around; the result is always shorter.
    """
    return min(max(0.5, _LONGEST_BUSY * rate_hz), 0.4 * turn * rate_hz)
