"""Interleaved samples: consecutive samples of several groups in any order, checked by numpy.

All frames of one size are checked together, even if they belong to several groups.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeAlias

import numpy as np

from unity_link.protocol.wire.arrays import open_rows
from unity_link.protocol.wire.frames import LF

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from unity_link.protocol.wire.frames import Framing

FEWEST_OF_A_SIZE = 8
"""Fewest frames of one size for which numpy is faster than a loop."""


_Parts: TypeAlias = list[tuple["NDArray[np.intp]", "NDArray[np.uint8]"]]


class SampleGroup(Protocol):
    """The part of `group_table.HeldGroup` that this module uses."""

    length: int
    """Characters of the body of a sample."""
    owner: Any
    """Receiver of the samples."""


class InterleavedSamples(NamedTuple):
    """Consecutive samples without an error."""

    owners: list[Any]
    """Owner of the group of each sample, in order of arrival."""
    parts: _Parts
    """For each size of frames: the positions of its samples in `owners`, and their bodies, shape (n, length)."""
    size: int
    """Characters of all frames together."""


def find_interleaved(
    data: bytes, start: int, framing: Framing, groups: Mapping[bytes, SampleGroup], seed: int
) -> InterleavedSamples | None:
    """Return the samples from `start` on, before the first line that is no sample of `groups`; None if there is none.

    Args:
        data: received bytes.
        start: offset of the beginning of a line.
        framing: framing of the gateway.
        groups: the groups, by their number as two hex digits.
        seed: seed of the session, for frames of the gateway.
    """
    view = np.frombuffer(data, np.uint8, offset=start)
    size = data.find(LF, start) + 1 - start
    if size <= framing.overhead:
        return None
    rows = view[: len(view) // size * size].reshape(-1, size)
    head = framing.prefix + b"P"
    if (rows[:, -1] == LF[0]).all():
        bodies = open_rows(framing, rows, head, seed)
        found, count, ends = [(np.arange(len(bodies)), bodies)], len(bodies), None
    else:
        found, count, ends = _of_unlike_sizes(view, framing, head, seed)
    known: list[tuple[NDArray[np.intp], list[Any]]] = []
    for places, bodies in found:
        # Compare the two digits of a group as one number of 16 bits, which is faster than as text.
        numbers = np.frombuffer(bodies[:, 1:3].tobytes(), np.uint16).tolist()
        owners = {}
        for number in set(numbers):
            group = groups.get(number.to_bytes(2, sys.byteorder))
            if group is not None and group.length == bodies.shape[1]:
                owners[number] = group.owner
            else:
                count = min(count, int(places[numbers.index(number)]))
        known.append((places, [*map(owners.get, numbers)]))
    if not count:
        return None
    parts = [(places[places < count], bodies[: int(places.searchsorted(count))]) for places, bodies in found]
    size = count * size if ends is None else int(ends[count - 1])
    return InterleavedSamples(_in_order(known, count), [part for part in parts if len(part[0])], size)


def _in_order(known: list[tuple[NDArray[np.intp], list[Any]]], count: int) -> list[Any]:
    """Return the owners of the first `count` samples in order of arrival, given the owners for each frame size."""
    if len(known) == 1:
        return known[0][1][:count]
    owners = [None] * count
    for places, some in known:
        for place, owner in zip(places[places < count].tolist(), some, strict=False):
            owners[place] = owner
    return owners


def _of_unlike_sizes(
    view: NDArray[np.uint8], framing: Framing, head: bytes, seed: int
) -> tuple[_Parts, int, NDArray[np.intp] | None]:
    """Check frames of several sizes.

    Returns:
        The positions and bodies of undamaged frames that begin with `head`, for each size; the number of lines before
        the first other line; and the end of each line.
    """
    ends = np.flatnonzero(view == LF[0]) + 1
    begins = np.concatenate((np.zeros(1, ends.dtype), ends[:-1]))
    sizes = ends - begins
    kinds, counts = np.unique(sizes, return_counts=True)
    sound = np.zeros(len(ends), bool)
    found = []
    for size in kinds[(counts >= FEWEST_OF_A_SIZE) & (kinds > framing.overhead)].tolist():
        places = np.flatnonzero(sizes == size)
        bodies = open_rows(framing, view[begins[places][:, None] + np.arange(size)], head, seed)
        sound[places[: len(bodies)]] = True
        found.append((places[: len(bodies)], bodies))
    return found, len(sound) if sound.all() else int(sound.argmin()), ends
