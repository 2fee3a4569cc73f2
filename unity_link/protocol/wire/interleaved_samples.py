"""Samples of several groups that stand side by side in any order, checked many at a time.

Frames of one size are looked at together, whatever groups they are of.
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
"""Frames of one size that are worth a turn of numpy."""


_Parts: TypeAlias = list[tuple["NDArray[np.intp]", "NDArray[np.uint8]"]]


class SampleGroup(Protocol):
    """The part of a `group_table.HeldGroup` by which its samples are known."""

    length: int
    """Characters of the body of a sample."""
    owner: Any


class InterleavedSamples(NamedTuple):
    """Sound samples, side by side."""

    owners: list[Any]
    """Owners of the groups, in the order of the samples."""
    parts: _Parts
    """Samples of each size: the places of its samples among all, and their bodies, shape (n, length)."""
    size: int
    """Characters of all frames."""


def find_interleaved(
    data: bytes, start: int, framing: Framing, groups: Mapping[bytes, SampleGroup], seed: int
) -> InterleavedSamples | None:
    """Return the samples from `start` on, up to the first line that is none of these groups; None where there is none.

    Args:
        data: what was received.
        start: where a line begins.
        framing: of the gateway.
        groups: whose samples are wanted, by their two digits.
        seed: of what the gateway sends in the session.
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
        # Two digits as one number: many of those are quicker at hand than texts.
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
    """Return the first owners of all samples, told those of each size."""
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
    """Return the sound frames with this head, how many stand before the first other line, and where lines end."""
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
