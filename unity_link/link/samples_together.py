"""Samples of several subscriptions that arrive together, decoded by numpy."""

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
    """The part of `SampleReceiver` that this module uses."""

    words_at: int
    """Offset of the first word in the body of its samples."""


class SampleClock(Protocol):
    """The part of `GatewayClock` that this module uses."""

    def seconds_of(self, timestamps: Words, now: float, /) -> NDArray[np.float64]:
        """Return the instants of timestamps in seconds of the gateway's clock."""


class SamplesTogether:
    """Decodes consecutive samples of several subscriptions.

    Args:
        count: number of samples.
    """

    def __init__(self, count: int) -> None:
        self.sequences = [0] * count
        """Sequence number of each sample, 0 to 255."""
        self.words: list[Words] = [_NO_WORDS] * count
        """Words of each sample."""
        self._timestamps: list[tuple[NDArray[np.intp], Words]] = []

    def parse(
        self, owners: Sequence[SampleOwner], places: NDArray[np.intp], bodies: NDArray[np.uint8], digits: int
    ) -> None:
        """Decode the samples of one length.

        Args:
            owners: receiver of each sample, for all lengths.
            places: positions of the samples of this length in `owners`.
            bodies: their bodies, shape (n, length).
            digits: hex digits of a word.

        Raises:
            ValueError: if a character is no hex digit.
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
        """Decode samples whose words begin at the same offset."""
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
        """Return the instant of each sample in seconds of the gateway's clock, None without a timestamp."""
        instants: list[float | None] = [None] * len(self.words)
        if self._timestamps:
            places, timestamps = (np.concatenate(columns) for columns in zip(*self._timestamps, strict=True))
            order = places.argsort()
            seconds = clock.seconds_of(timestamps[order], now).tolist()
            for place, instant in zip(places[order].tolist(), seconds, strict=True):
                instants[place] = instant
        return instants
