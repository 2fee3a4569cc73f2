"""Conversion of many frames of one command and one length to the compact form and back, by numpy.

The results are the same as those of `compact`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from unity_link.protocol.wire.frames import (
    COMPACT_END,
    COMPACT_ESCAPE,
    COMPACT_RESERVED,
    COMPACT_START,
    COMPACT_STUFFED,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

_IS_RESERVED = np.isin(np.arange(256), np.frombuffer(COMPACT_RESERVED, np.uint8))
_DIGITS = np.zeros(256, np.uint8)
_DIGITS[np.frombuffer(b"0123456789ABCDEF", np.uint8)] = np.arange(16)


def pack(frames: bytes, count: int, at: int, head: str) -> bytes:
    """Return frames of one command in compact form.

    Args:
        frames: valid frames of one length, which have an even number of digits in compact form.
        count: number of the frames.
        at: characters before the digits of a frame.
        head: hex digit of the command's number, and the padding digit if there is one.
    """
    rows = np.frombuffer(frames, np.uint8).reshape(count, -1)
    first = np.frombuffer(head.encode(), np.uint8)
    size = len(first) + rows.shape[1] - 1 - at
    digits = np.empty((count, size), np.uint8)
    digits[:, : len(first)] = _DIGITS[first]
    digits[:, len(first) :] = _DIGITS[rows[:, at:-1]]
    packed = np.empty((count, size // 2 + 2), np.uint8)
    packed[:, 0], packed[:, -1] = COMPACT_START[0], COMPACT_END[0]
    packed[:, 1:-1] = digits[:, ::2] << 4 | digits[:, 1::2]
    reserved = _IS_RESERVED[packed]
    reserved[:, 0] = reserved[:, -1] = False
    places = reserved.ravel().nonzero()[0]
    if not len(places):
        return packed.tobytes()
    stuffed = np.repeat(packed.ravel(), 1 + reserved.ravel())
    places += np.arange(len(places))
    stuffed[places] = COMPACT_ESCAPE[0]
    stuffed[places + 1] ^= COMPACT_STUFFED
    return stuffed.tobytes()


def unpack(data: bytes, commands: Sequence[tuple[str, int]]) -> tuple[bytes, int]:
    """Convert the compact frames of one command and one length at the beginning of `data` to text.

    Args:
        data: bytes without line ends, at least one byte.
        commands: by the number of a command, its letters and the number of hex digits that encode them.

    Returns:
        The text and the number of bytes converted; nothing and 0 if `data` is not a sequence of complete frames.
    """
    packed = np.frombuffer(data, np.uint8)
    starts, ends = (packed == COMPACT_START[0]).nonzero()[0], (packed == COMPACT_END[0]).nonzero()[0]
    if not len(starts) or len(starts) != len(ends) or starts[0] != 0 or ends[-1] != len(data) - 1:
        return b"", 0
    if (starts[1:] != ends[:-1] + 1).any():
        return b"", 0
    sizes = ends - starts + 1
    escapes = packed == COMPACT_ESCAPE[0]
    places = escapes.nonzero()[0]
    if len(places):
        escaped = packed[places + 1]
        if (escaped == COMPACT_ESCAPE[0]).any() or (escaped == COMPACT_END[0]).any():
            return b"", 0
        packed = packed.copy()
        packed[places + 1] = escaped ^ COMPACT_STUFFED
        packed = packed[~escapes]
        until = np.searchsorted(places, ends)
        sizes -= until
        sizes[1:] += until[:-1]
    size = int(sizes[0])
    if size <= 2:
        return b"", 0
    count = _equal(sizes)
    rows = packed[: count * size].reshape(count, size)
    count = _equal(rows[:, 1] >> 4)
    command, after = commands[int(rows[0, 1]) >> 4]
    first = np.frombuffer(command.encode(), np.uint8)
    digits = np.frombuffer(rows[:count, 1:-1].tobytes().hex().upper().encode(), np.uint8).reshape(count, -1)
    digits = digits[:, after:]
    text = np.empty((count, len(first) + digits.shape[1] + 1), np.uint8)
    text[:, : len(first)], text[:, len(first) : -1], text[:, -1] = first, digits, ord("\n")
    return text.tobytes(), int(ends[count - 1]) + 1


def _equal(values: npt.NDArray[Any]) -> int:
    """Return how many values at the beginning equal the first."""
    differ = values != values[0]
    return int(differ.argmax()) if differ.any() else len(values)
