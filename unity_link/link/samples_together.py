"""Samples of several subscriptions that arrive together, read as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

from unity_link.protocol.wire import arrays
from unity_link.protocol.wire.messages import SAMPLE_HEAD

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from unity_link.protocol.wire.arrays import Words

_NO_WORDS: Words = np.zeros(0, np.uint8)


class SampleOwner(Protocol):
    """The subscription that takes a sample."""

    words_at: int
    """Place of the first word in the body of its samples."""


class SampleClock(Protocol):
    """The gateway's clock."""

    def seconds_of(self, timestamps: Words, now: float, /) -> NDArray[np.float64]:
        """Return the instants of timestamps, in seconds."""


class SamplesTogether:
    """Samples of several subscriptions, read many at a time.

    Args:
        count: how many.
    """

    def __init__(self, count: int) -> None:
        self.sequences = [0] * count
        """Two digits of each."""
        self.words: list[Words] = [_NO_WORDS] * count
        self._timestamps: list[tuple[NDArray[np.intp], Words]] = []

    def parse(
        self, owners: Sequence[SampleOwner], places: NDArray[np.intp], bodies: NDArray[np.uint8], digits: int
    ) -> None:
        """Read samples of one length.

        Args:
            owners: of all samples.
            places: of those that are meant.
            bodies: shape (n, length).
            digits: of a word.

        Raises:
            ValueError: where a character is no hex digit.
        """
        words_at = {owner.words_at for owner in set(owners)}
        if len(words_at) == 1:
            self._parse_alike(places, bodies, words_at.pop(), digits)
            return
        heads = np.array([owners[place].words_at for place in places.tolist()])
        for head in words_at & {*heads.tolist()}:
            of_head = heads == head
            self._parse_alike(places[of_head], bodies[of_head], head, digits)

    def _parse_alike(self, places: NDArray[np.intp], bodies: NDArray[np.uint8], words_at: int, digits: int) -> None:
        """Read samples that have their words at the same place."""
        values = arrays.apart(arrays.parse_rows(bodies[:, words_at:].reshape(-1, digits)).reshape(len(bodies), -1))
        sequences = arrays.parse_rows(bodies[:, 3:SAMPLE_HEAD]).tolist()
        if words_at != SAMPLE_HEAD:
            self._timestamps.append((places, arrays.parse_rows(bodies[:, SAMPLE_HEAD:words_at])))
        if len(places) == len(self.words):
            self.sequences, self.words = sequences, values
            return
        for place, sequence, words in zip(places.tolist(), sequences, values, strict=True):
            self.sequences[place], self.words[place] = sequence, words

    def instants(self, clock: SampleClock, now: float) -> list[float | None]:
        """Return the instants of all in seconds, None for those without timestamp."""
        instants: list[float | None] = [None] * len(self.words)
        if self._timestamps:
            places, timestamps = (np.concatenate(columns) for columns in zip(*self._timestamps, strict=True))
            order = places.argsort()
            seconds = clock.seconds_of(timestamps[order], now).tolist()
            for place, instant in zip(places[order].tolist(), seconds, strict=True):
                instants[place] = instant
        return instants
