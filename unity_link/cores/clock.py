"""Estimates of a gateway's clock: bounds of its ticks at times of this machine's clock, and instants."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError, shown
from unity_link.link.freshness import MOST_DRIFT
from unity_link.link.runtimes.synchronisation import running
from unity_link.protocol.wire.numbers import real_number, seconds_from, whole_number

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.link.link import Link

READ_AGAIN = 10.0
"""Seconds after which the gateway's clock is read again. The error of the estimate is the delay of the answer plus the
drift between both clocks, up to 2 ms in this time."""
_LEAST_APART = 0.1
"""Least time between two readings for an estimate of the drift, in seconds."""
TURN = 1 << 32
"""Ticks after which a timestamp repeats."""
_MOST_TICKS = 1 << 64
"""Ticks after which the gateway's clock wraps around; the absolute value of an instant is below this."""


class Instant(msgspec.Struct, frozen=True, order=True):
    """An instant of a gateway's clock: clock cycles since its reset.

    Raises:
        ArgumentError: if `ticks` is no whole number, or 2 ** 64 or more from 0, or `clock_hz` is below 1.
    """

    ticks: int
    clock_hz: int

    def __post_init__(self) -> None:
        """Check the numbers, and convert those of other types, such as numpy's, to `int`."""
        ticks = whole_number(self.ticks, "the ticks of an instant")
        hertz = whole_number(self.clock_hz, "the clock of an instant in Hz")
        if hertz < 1:
            raise ArgumentError(f"the clock of an instant has 1 Hz at least, not {hertz}")
        if type(self.ticks) is not int or type(self.clock_hz) is not int:
            msgspec.structs.force_setattr(self, "ticks", ticks)
            msgspec.structs.force_setattr(self, "clock_hz", hertz)

    @property
    def ns(self) -> int:
        """Nanoseconds since the reset, rounded to a whole number."""
        return round(Fraction(self.ticks * 1_000_000_000, self.clock_hz))

    def after(self, seconds: float) -> Instant:
        """Return the instant `seconds` later, in the nearest cycle; an earlier one for a negative number.

        Raises:
            ArgumentError: if `seconds` is no finite number, or the instant is 2 ** 64 ticks or more from 0.
        """
        return Instant(round(ticks_after(self.ticks, seconds, self.clock_hz)), self.clock_hz)

    def __str__(self) -> str:
        """Return the seconds since the reset."""
        return f"{self.ticks / self.clock_hz:.9f} s of the gateway's clock"


def ticks_after(ticks: int | Fraction, seconds: float, hertz: int) -> Fraction:
    """Return the ticks of a clock `seconds` after `ticks`; before them for a negative number.

    Raises:
        ArgumentError: if `seconds` is no finite number, or the ticks are beyond the range of a clock.
    """
    passed = real_number(seconds, "instants are a finite number of seconds apart")
    after = ticks + Fraction(passed) * hertz
    if abs(after) >= _MOST_TICKS:
        raise ArgumentError(f"no clock of a gateway counts the ticks of {shown(seconds)} s")
    return after


class TickBounds:
    """Bounds of a gateway's clock in ticks, computed from readings of it and from timestamps that have arrived.

    Args:
        hertz: frequency of the clock.
    """

    def __init__(self, hertz: int) -> None:
        self.hertz = hertz
        self.forget()

    def forget(self) -> None:
        """Start again, for a clock that was reset."""
        self.read_at: float | None = None
        """Time of this machine's clock at which the last reading arrived; None before the first."""
        self._asked_at = 0.0
        self._ticks = 0
        self._seen, self._seen_at = 0, 0.0
        """Latest known lower bound of the clock in ticks, and the time at which it was known."""
        self._first: tuple[int, float, float] | None = None
        """Ticks of the first reading, and the times at which it was requested and arrived."""

    def read(self, ticks: int, asked: float, now: float) -> None:
        """Update the bounds by a reading that was requested at `asked` and has arrived at `now`."""
        if self._first is None or ticks < self._first[0]:
            self._first = ticks, asked, now
            self._seen, self._seen_at = ticks, now
        self._ticks, self._asked_at, self.read_at = ticks, asked, now
        # The bounds contradict each other if the clock is slower than a quartz can be, as in a simulation that lags
        # behind: use the reading itself.
        if self.least(now) > self.most(now):
            self._seen, self._seen_at = ticks, now
        self.see(ticks, now)

    def see(self, ticks: int, now: float) -> None:
        """Update the lower bound by an instant that has passed."""
        if ticks > self.least(now):
            self._seen, self._seen_at = ticks, now

    def least(self, now: float) -> int:
        """Return the lower bound of the clock at a time, in ticks."""
        return self._seen + int((now - self._seen_at) * (1 - MOST_DRIFT) * self.hertz)

    def most(self, now: float) -> int:
        """Return the upper bound of the clock at a time, in ticks."""
        return self._ticks + int((now - self._asked_at) * (1 + MOST_DRIFT) * self.hertz) + 1

    def nearest(self, timestamp: int, now: float) -> int:
        """Return the ticks at a timestamp of 32 bits: those nearest to the upper bound at a time."""
        # Nearest to the upper bound, because the clock of a compiled gateway is ahead by the cycles of an answer.
        most = self.most(now)
        return most + (timestamp - most + TURN // 2) % TURN - TURN // 2

    def is_old(self, now: float) -> bool:
        """Return whether the clock should be read again."""
        return self.read_at is None or now - self.read_at > READ_AGAIN

    @property
    def drift(self) -> tuple[float, float] | None:
        """Relative deviation from this machine's clock, positive if faster, and its uncertainty; None if not known."""
        if self._first is None or self.read_at is None:
            return None
        ticks, asked, came = self._first
        apart = (self._asked_at + self.read_at - asked - came) / 2
        if apart < _LEAST_APART:
            return None
        unsure = (came - asked + self.read_at - self._asked_at) / 2 / apart
        return (self._ticks - ticks) / self.hertz / apart - 1, unsure


class TickClock:
    """The clock of a gateway in terms of this machine's ``CLOCK_MONOTONIC_RAW``, in seconds.

    All programs of a machine share that clock, ``time.clock_gettime(time.CLOCK_MONOTONIC_RAW)``, and no time service
    adjusts it. On systems without it, it is `time.perf_counter`; with simulated time, it is the simulated clock.
    """

    def __init__(self, bounds: TickBounds, link: Link) -> None:
        self._bounds = bounds
        self._link = link
        self.time: Callable[[], float] = running().steady
        """Function that returns the time of this machine's clock in seconds."""

    @property
    def clock_hz(self) -> int:
        """Ticks per second."""
        return self._bounds.hertz

    def now(self) -> Instant:
        """Return the present instant, as an estimate in the middle of the bounds."""
        return self.at(self.time())

    def at(self, time: float) -> Instant:
        """Return the instant at a time of this machine's clock in seconds, as an estimate in the middle of the bounds.

        Raises:
            ArgumentError: if `time` is no number of seconds from 0 to 1e9.
        """
        bounds = self._bounds
        time = seconds_from(time, "a time of this machine's clock is a number of seconds from 0 on", zero=True)
        return Instant((bounds.least(time) + bounds.most(time)) // 2, bounds.hertz)

    def sampled(self, time: float) -> Instant:
        """Return the instant at which a sample was taken.

        Args:
            time: time of the sample, which must have a timestamp.

        Raises:
            ArgumentError: for a sample without a timestamp, whose time is None, or one from before the last reset.
        """
        timestamp, link = self._link.timestamp_of(time), self._link
        return Instant(self._bounds.nearest(timestamp, self.time() - link.age_of(time)), self.clock_hz)

    def time_of(self, instant: Instant) -> float:
        """Return the time of this machine's clock, in seconds, at an instant.

        Raises:
            ArgumentError: if `instant` is no instant, or one of a clock with another frequency.
        """
        self.check(instant)
        now = self.time()
        return now + (instant.ticks - self.at(now).ticks) / self.clock_hz

    def check(self, instant: Instant) -> Instant:
        """Check that an instant is of this clock, and return it.

        Raises:
            ArgumentError: if the argument is no instant, or one of a clock with another frequency.
        """
        given: object = instant
        if not isinstance(given, Instant):
            raise ArgumentError(
                f"an instant of the gateway's clock was expected, as of `clock.now()`, not {shown(instant)}"
            )
        if given.clock_hz != self.clock_hz:
            raise ArgumentError(f"{given!r} is of another clock: this one has {self.clock_hz} Hz")
        return given

    @property
    def offset(self) -> float:
        """This machine's clock at the gateway's instant 0 (seconds)."""
        return self.time_of(Instant(0, self.clock_hz))

    @property
    def error(self) -> float:
        """Largest error of `now` in seconds; it grows with the time since the clock was last read."""
        now = self.time()
        return (self._bounds.most(now) - self._bounds.least(now)) / 2 / self.clock_hz

    @property
    def drift(self) -> tuple[float, float] | None:
        """Relative deviation of the gateway's clock, positive if it is faster than this machine's, and its uncertainty.

        None until the clock was read twice, at least 0.1 s apart.
        """
        return self._bounds.drift

    def __repr__(self) -> str:
        """Return the present instant, and its largest error."""
        return f"<a gateway's clock at {self.now()}, known to {self.error * 1e6:.0f} us>"
