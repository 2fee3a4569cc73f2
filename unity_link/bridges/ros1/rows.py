"""Messages of ROS 1 as rows of bytes, many at a time: what rospy would serialise, each behind its length.

Messages of one topic are all of one length here: numbers, and states of always the same joints.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray


Rows = np.ndarray[Any, np.dtype[np.void]]
"""Shape (messages,)."""
_LENGTH = np.dtype("<u4")


def number_rows(kind: str, values: NDArray[Any]) -> Rows:
    """Return messages of a type of ``std_msgs``, such as ``Float64``, with these values."""
    return _rows(len(values), [("data", np.dtype(kind.lower()).newbyteorder("<"))], data=values)


def joint_rows(
    names: Sequence[str],
    instants: NDArray[np.float64],
    parts: Mapping[str, NDArray[np.float64]],
    first: int,
    frame_id: str = "",
) -> Rows:
    """Return messages of ``sensor_msgs/JointState``.

    Args:
        names: of the joints.
        instants: when the samples were taken, in seconds since 1970, shape (samples,).
        parts: position, velocity and effort, in this order, of shape (samples, joints), or (samples, 0) for none.
        first: the number of the first message.
        frame_id: of the header.
    """
    seconds, nanoseconds = np.divmod(np.rint(instants * 1e9).astype(np.int64), 1_000_000_000)
    texts = _string(frame_id) + struct.pack("<I", len(names)) + b"".join(map(_string, names))
    fields: list[tuple[Any, ...]] = [("seq", "<u4"), ("secs", "<u4"), ("nsecs", "<u4"), ("texts", f"V{len(texts)}")]
    given: dict[str, Any] = {
        "seq": np.arange(first, first + len(instants)) & 0xFFFF_FFFF,
        "secs": seconds,
        "nsecs": nanoseconds,
        "texts": np.void(texts),
    }
    for part, columns in parts.items():
        fields += [(f"{part}_count", "<u4"), (part, "<f8", columns.shape[1:])]
        given |= {f"{part}_count": columns.shape[1], part: columns}
    return _rows(len(instants), fields, **given)


def _string(text: str) -> bytes:
    return struct.pack("<I", len(text.encode())) + text.encode()


def _rows(count: int, fields: list[Any], **values: Any) -> Rows:
    layout = np.dtype([("length", _LENGTH), *fields])
    rows = np.empty(count, layout)
    rows["length"] = layout.itemsize - _LENGTH.itemsize
    for name, value in values.items():
        rows[name] = value
    return rows
