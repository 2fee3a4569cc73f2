"""Values that count on where their registers go round: signals with WRAPS.

A value is the one nearest to the last value that was seen, of all that its bits may mean. So less than half a round may
pass between two values that a program sees, whatever is lost between them. A new session begins with the value of the
register, since the gateway may have been reset.
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
    """The rounds of one signal.

    Args:
        signal: with WRAPS, of its own.
    """

    __slots__ = ("_span", "_was", "at", "signal")

    def __init__(self, signal: Signal) -> None:
        self.signal = signal
        self.at = -math.inf
        """Instant by `time.monotonic` of the last value."""
        self._span = signal.kind.span
        self._was: tuple[int, Any] | None = None
        """Session and value that were seen last."""

    def last(self, epoch: int) -> Any:
        """Return the last value of a session; None before the first one."""
        return None if self._was is None or self._was[0] != epoch else self._was[1]

    def begin(self, other: Laps) -> None:
        """Go on from the last value of the same signal elsewhere."""
        self._was, self.at = other._was, other.at

    def see(self, value: Any, epoch: int, at: float) -> None:
        """Keep a value as the last one, unless a later one was seen."""
        if at >= self.at:
            self._was, self.at = (epoch, value), at

    def near(self, value: Any, epoch: int) -> Any:
        """Return the value nearest to the last one of a session that is whole rounds from a value."""
        last = self.last(epoch)
        return value if last is None else value + self._span * round((last - value) / self._span)

    def count(self, values: NDArray[Any], epochs: NDArray[np.int64], at: float) -> NDArray[Any]:
        """Return values that follow one another with their rounds; the last one is kept.

        Args:
            values: as the register has them, shape (n,).
            epochs: their sessions, shape (n,).
            at: instant by `time.monotonic` of the last one.
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
        """Return the values nearest to those of another signal that are whole rounds from some; each of shape (n,)."""
        rounds = np.rint((others - values) / self._span).astype(values.dtype)
        nearest: NDArray[Any] = values + rounds * values.dtype.type(self._span)
        return nearest

    def check_near(self, value: float, epoch: int, name: str) -> None:
        """Check that a value is less than half a round away from the last one that was read.

        Args:
            value: a finite number.
            epoch: the session.
            name: of the signal that the value is for, in the error.

        Raises:
            ArgumentError: for a value farther away.
        """
        last = self.last(epoch)
        if last is not None and abs(value - last) >= self._span / 2:
            away = f"is half a round, {self._span / 2:.12g}, or more away from {self.signal.path}"
            raise ArgumentError(f"{name}: {value} {away}, which was {last:.12g} when read last")

    def register_value(self, value: Any, epoch: int, name: str) -> Any:
        """Return the value of the register for one that counts rounds.

        In the range of the register a value stays as it is while the last one that was read is in it, too: that may be
        long ago.

        Args:
            value: a finite number.
            epoch: the session.
            name: of the signal that is written.

        Raises:
            ArgumentError: for another value, unless it is less than half a round from the last one that was read.
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
    """The rounds of those signals of a stream of samples that have WRAPS.

    Args:
        signals: of the samples.
        addresses: of the words of a sample.
        keys: the key of each signal in `bases` and `known`; its path without them.
        bases: keys of the signals whose rounds are counted for each; by the paths of the spec without them.
        known: laps of signals by their keys, which the stream goes on from and keeps up to date.
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
        # Those that count for others first.
        places = [place for place, signal in enumerate(signals) if signal.laps_of is not None]
        self._places = sorted(places, key=lambda place: bases[place] != keys[place])
        self._keys = [(keys[place], bases[place]) for place in self._places]
        self._columns = Columns([signals[place] for place in self._places], addresses)
        self._laps = [Laps(signals[place]) for place in self._places]
        self._has_begun = False

    def count(self, words: Words, epochs: NDArray[np.int64], at: float = 0.0) -> dict[int, NDArray[Any]]:
        """Return the values of samples that follow one another, by the places of their signals; of these alone.

        Args:
            words: shape (samples, addresses).
            epochs: sessions of the samples, shape (samples,).
            at: instant by `time.monotonic` at which the last sample arrived.
        """
        if not self._places or not len(words):
            return {}
        counted: dict[Hashable, NDArray[Any]] = {}
        for (key, base), laps, column in zip(self._keys, self._laps, self._columns.columns(words), strict=True):
            if base != key and base in counted:
                counted[key] = laps.near_each(column, counted[base])
                continue
            # A signal whose base is not in the samples goes on from the last value of the base that was read elsewhere.
            if base in self._known and (base != key or not self._has_begun):
                laps.begin(self._known[base])
            counted[key] = laps.count(column, epochs, at)
            if base == key and base in self._known:
                self._known[base].see(counted[key][-1].item(), int(epochs[-1]), at)
        self._has_begun = True
        return dict(zip(self._places, counted.values(), strict=True))
