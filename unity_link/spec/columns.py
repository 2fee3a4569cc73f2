"""Converts many signals at once: words of a group to arrays of values and back, with a few numpy operations a kind.

`Signal.decode` converts one value; this module is for samples, of which a group may have a hundred thousand a second.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import ArrayLike, NDArray

    from unity_link.spec.kinds import Kind, Value
    from unity_link.spec.model import Signal

    Words = NDArray[np.uint64]

_NONE: NDArray[Any] = np.empty(0)


class _Block(NamedTuple):
    """Signals of one kind; `columns[part]` has the column of word `part` of each signal."""

    kind: Kind
    places: list[int]
    """Indices of these signals in the list of all signals."""
    columns: NDArray[np.intp]
    shifts: NDArray[np.uint64]
    mask: np.uint64
    is_whole: bool
    """True if each signal fills its words, so that no shift and no mask is needed."""


class Columns:
    """The signals in the words at given addresses."""

    def __init__(self, signals: Sequence[Signal], addresses: Sequence[int]) -> None:
        """Prepare for words in the order of `addresses`, which must contain every word of `signals`."""
        self._width = len(addresses)
        self._word_bits = signals[0].word_bits if signals else 0
        column = {address: index for index, address in enumerate(addresses)}
        self._paths = [signal.path for signal in signals]
        alike: dict[tuple[Kind, int], list[int]] = {}
        for place, signal in enumerate(signals):
            missing = next((address for address in signal.addresses if address not in column), None)
            if missing is not None:
                raise ArgumentError(f"{signal.path} has a word at {missing:#x}, which is not among the addresses")
            alike.setdefault((signal.kind, signal.words), []).append(place)
        self._blocks = [
            _Block(
                kind,
                places,
                np.array([[column[signals[place].address + part] for place in places] for part in range(words)]),
                np.array([signals[place].lowest_bit for place in places], np.uint64),
                np.uint64((1 << kind.width) - 1),
                all(signals[place].width == signals[place].words * signals[place].word_bits for place in places),
            )
            for (kind, words), places in alike.items()
        ]

    def decode(self, words: ArrayLike) -> dict[str, NDArray[Any]]:
        """Return the values of each signal by path.

        Args:
            words: shape (..., addresses); the last axis is in the order of the addresses.

        Returns:
            Arrays of shape (...), with the dtype of the signal's kind.
        """
        return dict(zip(self._paths, self.columns(words), strict=True))

    def columns(self, words: ArrayLike) -> list[NDArray[Any]]:
        """Return the values as in `decode`, as a list in the order of the signals."""
        values: list[NDArray[Any]] = [_NONE] * len(self._paths)
        for block in self._blocks:
            decoded = self._decode_block(block, words)
            for index, place in enumerate(block.places):
                values[place] = decoded[..., index]
        return values

    def row(self, words: ArrayLike) -> list[Value]:
        """Return the values of one sample in the order of the signals, as Python objects; enumerations as numbers.

        Args:
            words: shape (addresses,).
        """
        values: list[Value] = [0] * len(self._paths)
        for block in self._blocks:
            for place, value in zip(block.places, self._decode_block(block, words).tolist(), strict=True):
                values[place] = value
        return values

    def _decode_block(self, block: _Block, words: ArrayLike) -> NDArray[Any]:
        given = np.asarray(words)
        if given.shape[-1:] != (self._width,):
            raise ArgumentError(f"{self._width} words a sample were expected, and the words have shape {given.shape}")
        if given.dtype.kind != "u":
            given = given.astype(np.uint64)
        raw = given.take(block.columns[0], axis=-1)
        for part in range(1, len(block.columns)):
            raw = raw | given.take(block.columns[part], axis=-1) << np.uint64(part * self._word_bits)
        return block.kind.decode_array(raw if block.is_whole else raw >> block.shifts & block.mask)

    def encode(self, values: Mapping[str, ArrayLike]) -> Words:
        """Return the words for values of all signals; bits outside of the signals are 0.

        Args:
            values: by path, arrays of one shape (...).

        Returns:
            Shape (..., addresses).

        Raises:
            ArgumentError: for a value that a kind cannot represent. Limits are not checked.
        """
        shape = np.broadcast_shapes(*(np.shape(value) for value in values.values()))
        words = np.zeros((*shape, self._width), np.uint64)
        word_mask = np.uint64((1 << self._word_bits) - 1)
        for block in self._blocks:
            for index, place in enumerate(block.places):
                raw = block.kind.encode_array(values[self._paths[place]]) << block.shifts[index]
                for part in range(len(block.columns)):
                    words[..., block.columns[part, index]] |= raw >> np.uint64(part * self._word_bits) & word_mask
        return words
