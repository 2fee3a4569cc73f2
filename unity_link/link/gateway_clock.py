"""The gateway's clock: an endless time in seconds from timestamps of 32 bits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.link.freshness import MOST_DRIFT

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

TICKS_PER_TURN = 1 << 32
"""Ticks after which a timestamp comes again."""
_ROUND = 256
"""Samples after which a sequence comes again."""
_LONGEST_BUSY = 200e-6
"""Seconds that a sample waits for the bus, at most."""
_MOST_ROUNDING = 1e-6
"""Part of a rate by which it may be rounded."""
RESET_TOLERANCE = 1
"""Seconds by which the clock of a gateway that was not reset may be off this machine's after an interruption."""


class GatewayClock:
    """Makes an endless time of the 32 bits of a timestamp.

    Of all the instants that a timestamp may mean, `seconds` guesses the one nearest to what this machine's clock says
    has passed since the last. That is wrong where this program stood still, and samples waited for it, for half a turn
    of the counter (43 s at 50 MHz) or longer. So the sequences of periodic groups decide: `turns_from`, `correct`.

    The gateway may have been reset between two sessions, and its counter with it. Where the first timestamp of a
    session is not close to what this machine's clock expects, the time goes on from there, so it never goes back.
    """

    def __init__(self, frequency_hz: int) -> None:
        self.turn = TICKS_PER_TURN / frequency_hz
        """Seconds after which a timestamp comes again."""
        self.corrections = 0
        """Turns of the counter by which guesses were corrected, all together."""
        self._frequency = frequency_hz
        self._ticks: int | None = None
        self._at = 0.0
        self._earliest = self._earliest_before = math.inf
        """Instant of time 0 by this machine's clock, as the sample says that was on its way for the shortest time.

        The other is what those before the last guess say.
        """
        self._offset = 0
        """Ticks that are added to timestamps since a reset of the gateway."""
        self._began = -math.inf
        """Time of the first sample since that reset."""
        self._resumed = False

    def resume(self) -> None:
        """Begin with a new session."""
        self._resumed = self._ticks is not None

    def seconds(self, timestamp: int, now: float) -> float:
        """Return the time of a timestamp that arrived at `now`, in seconds."""
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
        """Return the 32 bits that the gateway sent for a time.

        Raises:
            ArgumentError: for a time of before the last reset of the gateway, whose clock has begun again since.
        """
        if seconds < self._began:
            raise ArgumentError(f"the sample of {seconds:.6f} s was taken before the gateway was reset")
        return (round(seconds * self._frequency) - self._offset) % TICKS_PER_TURN

    def age(self, seconds: float, now: float) -> float:
        """Return how long ago a time was, in seconds; 0 before the first sample."""
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
        """Return the times of timestamps that arrived together, in order.

        Args:
            timestamps: shape (n,).
            now: when they arrived.
            expected: ticks from one to the next.
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
        """Return how many turns of the counter a periodic sample was later than was guessed, as its sequence tells.

        That is the earliest instant that the sequence and the timestamp allow together, or none where they don't.

        Args:
            last: the time of the sample before, in seconds.
            at: what was guessed.
            advance: by how much the sequence has advanced, 1 to 256; it may have gone round, too.
            rate_hz: of the samples.
            now: when the sample arrived.
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
        """Record that the last guess was wrong by turns of the counter."""
        assert self._ticks is not None
        self.corrections += turns
        self._ticks += turns * TICKS_PER_TURN
        self._earliest = min(self._earliest_before, self._at - self._ticks / self._frequency)

    def moved(self, instant: float, turns: int) -> float:
        """Return an instant that is some turns later, to the tick."""
        return (round(instant * self._frequency) + turns * TICKS_PER_TURN) / self._frequency


def steps_between(timestamps: NDArray[np.unsignedinteger], expected: int) -> NDArray[np.int64]:
    """Return the ticks to each timestamp from the one before, nearest to what is expected; shape (n,), first 0."""
    steps = timestamps.astype("int64")
    steps[1:] = (
        (steps[1:] - steps[:-1] - expected + TICKS_PER_TURN // 2) % TICKS_PER_TURN - TICKS_PER_TURN // 2 + expected
    )
    steps[0] = 0
    return steps


def tolerance_of(rate_hz: float, turn: float) -> float:
    """Return by how many periods a sample may be off: the bus may have been busy when it was due.

    Args:
        rate_hz: of the samples.
        turn: seconds after which a timestamp comes again, by which none may be off.
    """
    return min(max(0.5, _LONGEST_BUSY * rate_hz), 0.4 * turn * rate_hz)
