"""Values of signals with WRAPS, which count on when their registers wrap around.

The register determines a value except for a multiple of its range (a round). Of these values, a program gets the one
nearest to the last value seen. So the true value may change by less than half a round between two values that a program
sees, even if samples in between are lost. In a new session the first value is that of the register itself, because the
gateway may have been reset.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from unity_link.errors import ArgumentError
from unity_link.spec.columns import Columns

if TYPE_CHECKING:
    from collections.abc import Hashable, Mapping, Sequence

    from numpy.typing import NDArray

    from unity_link.protocol.wire.arrays import Words
    from unity_link.spec.model import Signal


class Laps:
    """Counts the rounds of one signal.

    Args:
        signal: a signal with WRAPS that counts its own rounds.
    """

    __slots__ = ("_span", "_was", "at", "signal")

    def __init__(self, signal: Signal) -> None:
        self.signal = signal
        self.at = -math.inf
        """Instant of `time.monotonic` of the last value."""
        self._span = signal.kind.span
        self._was: tuple[int, Any] | None = None
        """Session and value that were seen last."""

    def last(self, epoch: int) -> Any:
        """Return the last value seen in a session; None if there was none."""
        return None if self._was is None or self._was[0] != epoch else self._was[1]

    def begin(self, other: Laps) -> None:
        """Continue from the last value that another object saw of the same signal."""
        self._was, self.at = other._was, other.at

    def see(self, value: Any, epoch: int, at: float) -> None:
        """Store a value as the last one, unless a later one was seen."""
        if at >= self.at:
            self._was, self.at = (epoch, value), at

    def near(self, value: Any, epoch: int) -> Any:
        """Return a value plus the whole rounds that bring it nearest to the last one of the session."""
        last = self.last(epoch)
        return value if last is None else value + self._span * round((last - value) / self._span)

    def count(self, values: NDArray[Any], epochs: NDArray[np.int64], at: float) -> NDArray[Any]:
        """Return consecutive values with their rounds counted, and store the last one.

        Args:
            values: values of the register, shape (n,).
            epochs: their sessions, shape (n,).
            at: instant of `time.monotonic` of the last one.
        """
        if not len(values):
            return values
        first = self.near(values[0].item(), int(epochs[0])) - values[0].item()
        rounds = np.concatenate(([round(first / self._span)], -np.rint(np.diff(values) / self._span)))
        rounds = rounds.cumsum()
        for restart in np.flatnonzero(np.diff(epochs)) + 1:
            rounds[restart:] -= rounds[restart]
        counted: NDArray[Any] = values + rounds.astype(values.dtype) * values.dtype.type(self._span)
        self.see(counted[-1].item(), int(epochs[-1]), at)
        return counted

    def near_each(self, values: NDArray[Any], others: NDArray[Any]) -> NDArray[Any]:
        """Return values, each plus the whole rounds that bring it nearest to that of another signal; shape (n,)."""
        rounds = np.rint((others - values) / self._span).astype(values.dtype)
        nearest: NDArray[Any] = values + rounds * values.dtype.type(self._span)
        return nearest

    def check_near(self, value: float, epoch: int, name: str) -> None:
        """Check that a value is less than half a round away from the last one that was read.

        Args:
            value: a finite number.
            epoch: number of the current session.
            name: name, in the error, of the signal that the value is for.

        Raises:
            ArgumentError: for a value farther away.
        """
        last = self.last(epoch)
        if last is not None and abs(value - last) >= self._span / 2:
            away = f"is half a round, {self._span / 2:.12g}, or more away from {self.signal.path}"
            raise ArgumentError(f"{name}: {value} {away}, which was {last:.12g} when read last")

    def register_value(self, value: Any, epoch: int, name: str) -> Any:
        """Return the value of the register for a value that counts rounds.

        A value within the register's range is returned unchanged if no value was read yet, or the last one read is
        within the range, too. The distance is not checked then, because the last read may be long ago.

        Args:
            value: a finite number.
            epoch: number of the current session.
            name: name of the signal that is written.

        Raises:
            ArgumentError: for any other value if no value was read yet, or the last one is half a round or more away.
        """
        low, high = self.signal.kind.range
        last = self.last(epoch)
        if low <= value <= high and (last is None or low <= last <= high):
            return value
        if last is None:
            beyond = f"is outside of {low:.12g} to {high:.12g}, the range of the register"
            raise ArgumentError(f"{name}: {value} {beyond}, and {self.signal.path} was not read yet")
        self.check_near(value, epoch, name)
        return self.signal.kind.wrapped(value)


class ColumnLaps:
    """Counts the rounds of those signals of a stream of samples that have WRAPS.

    Args:
        signals: signals of the samples.
        addresses: addresses of the words of a sample.
        keys: key of each signal in `bases` and `known`; None for the paths.
        bases: for each signal, the key of the signal whose rounds it follows; None for those in the spec.
        known: last values of signals by their keys. The stream continues from them, and updates them.
    """

    def __init__(
        self,
        signals: Sequence[Signal],
        addresses: Sequence[int],
        keys: Sequence[Hashable] | None = None,
        bases: Sequence[Hashable] | None = None,
        known: Mapping[Hashable, Laps] | None = None,
    ) -> None:
        keys = [signal.path for signal in signals] if keys is None else keys
        bases = [signal.laps_of for signal in signals] if bases is None else bases
        self._known = {} if known is None else known
        # Signals that other signals follow come first.
        places = [place for place, signal in enumerate(signals) if signal.laps_of is not None]
        self._places = sorted(places, key=lambda place: bases[place] != keys[place])
        self._keys = [(keys[place], bases[place]) for place in self._places]
        self._columns = Columns([signals[place] for place in self._places], addresses)
        self._laps = [Laps(signals[place]) for place in self._places]
        self._has_begun = False

    def count(self, words: Words, epochs: NDArray[np.int64], at: float = 0.0) -> dict[int, NDArray[Any]]:
        """Return the values of consecutive samples, by the places of their signals, for signals with WRAPS only.

        Args:
            words: shape (samples, addresses).
            epochs: sessions of the samples, shape (samples,).
            at: instant of `time.monotonic` at which the last sample arrived.
        """
        if not self._places or not len(words):
            return {}
        counted: dict[Hashable, NDArray[Any]] = {}
        for (key, base), laps, column in zip(self._keys, self._laps, self._columns.columns(words), strict=True):
            if base != key and base in counted:
                counted[key] = laps.near_each(column, counted[base])
                continue
            # A signal whose base is not in the samples continues from the base's last value, which was read elsewhere.
            if base in self._known and (base != key or not self._has_begun):
                laps.begin(self._known[base])
            counted[key] = laps.count(column, epochs, at)
            if base == key and base in self._known:
                self._known[base].see(counted[key][-1].item(), int(epochs[-1]), at)
        self._has_begun = True
        return dict(zip(self._places, counted.values(), strict=True))
