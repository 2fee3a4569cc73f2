"""The clock of a gateway as a program knows it: bounds of its ticks by this machine's clock, and instants of it."""

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
"""Seconds after which the gateway's clock is read anew: the estimate is off by what quartzes drift apart meanwhile,
2 ms, and by the time that the answer was on its way."""
_LEAST_APART = 0.1
"""Seconds between two readings that tell how fast the gateway's clock is."""
TURN = 1 << 32
"""Ticks after which a timestamp comes again."""
_MOST_TICKS = 1 << 64
"""Ticks of the gateway's clock after which it begins again; no instant is further from 0."""


class Instant(msgspec.Struct, frozen=True, order=True):
    """An instant of a gateway's clock: whole cycles since its reset.

    Raises:
        ArgumentError: for ticks that are no whole number, or are 2 ** 64 or more from 0, and for no frequency.
    """

    ticks: int
    clock_hz: int

    def __post_init__(self) -> None:
        """Check the numbers, and keep those of other types, as numpy's, as `int`."""
        ticks = whole_number(self.ticks, "the ticks of an instant")
        hertz = whole_number(self.clock_hz, "the clock of an instant in Hz")
        if hertz < 1:
            raise ArgumentError(f"the clock of an instant has 1 Hz at least, not {hertz}")
        if type(self.ticks) is not int or type(self.clock_hz) is not int:
            msgspec.structs.force_setattr(self, "ticks", ticks)
            msgspec.structs.force_setattr(self, "clock_hz", hertz)

    @property
    def ns(self) -> int:
        """Nanoseconds since the reset, the nearest whole number."""
        return round(Fraction(self.ticks * 1_000_000_000, self.clock_hz))

    def after(self, seconds: float) -> Instant:
        """Return the instant so much later, in the nearest cycle; earlier, for a number below 0.

        Raises:
            ArgumentError: if `seconds` is no finite number, or the instant is 2 ** 64 ticks or more from 0.
        """
        return Instant(round(ticks_after(self.ticks, seconds, self.clock_hz)), self.clock_hz)

    def __str__(self) -> str:
        """Return the seconds since the reset."""
        return f"{self.ticks / self.clock_hz:.9f} s of the gateway's clock"


def ticks_after(ticks: int | Fraction, seconds: float, hertz: int) -> Fraction:
    """Return the ticks of a clock so many seconds after some ticks, before them for a number below 0.

    Raises:
        ArgumentError: if `seconds` is no finite number, or no clock counts so many ticks.
    """
    passed = real_number(seconds, "instants are a finite number of seconds apart")
    after = ticks + Fraction(passed) * hertz
    if abs(after) >= _MOST_TICKS:
        raise ArgumentError(f"no clock of a gateway counts the ticks of {shown(seconds)} s")
    return after


class TickBounds:
    """Bounds of a gateway's clock, in its ticks, of readings of it and of samples that have come.

    Args:
        hertz: its frequency.
    """

    def __init__(self, hertz: int) -> None:
        self.hertz = hertz
        self.forget()

    def forget(self) -> None:
        """Begin anew, for a clock that was reset."""
        self.read_at: float | None = None
        """Instant of this machine's clock at which the last reading had come; None before the first."""
        self._asked_at = 0.0
        self._ticks = 0
        self._seen, self._seen_at = 0, 0.0
        """Latest that it is known to have been, and the instant at which that was known."""
        self._first: tuple[int, float, float] | None = None
        """Ticks, and the two instants, of the first reading."""

    def read(self, ticks: int, asked: float, now: float) -> None:
        """Take a reading that was asked for at an instant and is there now."""
        if self._first is None or ticks < self._first[0]:
            self._first = ticks, asked, now
            self._seen, self._seen_at = ticks, now
        self._ticks, self._asked_at, self.read_at = ticks, asked, now
        # A clock that is slower than quartzes are, as that of a simulation that is late, is as it says.
        if self.least(now) > self.most(now):
            self._seen, self._seen_at = ticks, now
        self.see(ticks, now)

    def see(self, ticks: int, now: float) -> None:
        """Take an instant that has passed."""
        if ticks > self.least(now):
            self._seen, self._seen_at = ticks, now

    def least(self, now: float) -> int:
        """Return what it is at least: never ahead of the truth."""
        return self._seen + int((now - self._seen_at) * (1 - MOST_DRIFT) * self.hertz)

    def most(self, now: float) -> int:
        """Return what it is at most."""
        return self._ticks + int((now - self._asked_at) * (1 + MOST_DRIFT) * self.hertz) + 1

    def nearest(self, timestamp: int, now: float) -> int:
        """Return what it was at a timestamp of 32 bits, which is the nearest that there is."""
        # To the most that it is: a compiled gateway is ahead by the cycles that an answer takes.
        most = self.most(now)
        return most + (timestamp - most + TURN // 2) % TURN - TURN // 2

    def is_old(self, now: float) -> bool:
        """Return whether it should be read anew."""
        return self.read_at is None or now - self.read_at > READ_AGAIN

    @property
    def drift(self) -> tuple[float, float] | None:
        """Part by which it is faster than this machine's clock, and how far that may be off; None if not known."""
        if self._first is None or self.read_at is None:
            return None
        ticks, asked, came = self._first
        apart = (self._asked_at + self.read_at - asked - came) / 2
        if apart < _LEAST_APART:
            return None
        unsure = (came - asked + self.read_at - self._asked_at) / 2 / apart
        return (self._ticks - ticks) / self.hertz / apart - 1, unsure


class TickClock:
    """The clock of a gateway, by this machine's ``CLOCK_MONOTONIC_RAW`` in seconds.

    All programs of a machine have that clock in common, as ``time.clock_gettime(time.CLOCK_MONOTONIC_RAW)``, and
    nothing adjusts it. Where a system has none it is `time.perf_counter`, and in models of time the modelled one.
    """

    def __init__(self, bounds: TickBounds, link: Link) -> None:
        self._bounds = bounds
        self._link = link
        self.time: Callable[[], float] = running().steady
        """Returns this machine's clock."""

    @property
    def clock_hz(self) -> int:
        """Ticks a second."""
        return self._bounds.hertz

    def now(self) -> Instant:
        """Return the instant that it is now, as near as is known."""
        return self.at(self.time())

    def at(self, time: float) -> Instant:
        """Return the instant at a time of this machine's clock (seconds), as near as is known.

        Raises:
            ArgumentError: if `time` is no number of seconds from 0 to 1e9.
        """
        bounds = self._bounds
        time = seconds_from(time, "a time of this machine's clock is a number of seconds from 0 on", zero=True)
        return Instant((bounds.least(time) + bounds.most(time)) // 2, bounds.hertz)

    def sampled(self, time: float) -> Instant:
        """Return the instant at which a sample was taken.

        Args:
            time: of the sample, which has a timestamp.

        Raises:
            ArgumentError: for a sample without a timestamp, whose time is None, and one of before the last reset.
        """
        timestamp, link = self._link.timestamp_of(time), self._link
        return Instant(self._bounds.nearest(timestamp, self.time() - link.age_of(time)), self.clock_hz)

    def time_of(self, instant: Instant) -> float:
        """Return when an instant is by this machine's clock (seconds).

        Raises:
            ArgumentError: if `instant` is no instant, or one of a clock with another frequency.
        """
        self.check(instant)
        now = self.time()
        return now + (instant.ticks - self.at(now).ticks) / self.clock_hz

    def check(self, instant: Instant) -> Instant:
        """Return an instant of this clock.

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
        """Most seconds by which `now` is off; it grows with the time since the clock was read."""
        now = self.time()
        return (self._bounds.most(now) - self._bounds.least(now)) / 2 / self.clock_hz

    @property
    def drift(self) -> tuple[float, float] | None:
        """Part by which the gateway's clock is faster, and how far that may be off.

        None until the clock was read twice, 0.1 s apart or more.
        """
        return self._bounds.drift

    def __repr__(self) -> str:
        """Return where it is, and how near that is known."""
        return f"<a gateway's clock at {self.now()}, known to {self.error * 1e6:.0f} us>"
