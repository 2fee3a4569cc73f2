"""Messages of ROS 2 as rows of bytes, many at a time: what CycloneDDS or rclpy would serialise one by one.

That is plain CDR, lowest bytes first, with its header (DDS-RTPS 10.2; DDS-XTypes 7.4.1). Messages of one topic are all
of one length here: numbers, and states of always the same joints.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray


HEADER = 4
"""Bytes that say how the others are to be read (DDS-RTPS, 10.2)."""
_HEADER = np.void(b"\0\1\0\0")


def number_rows(kind: str, values: NDArray[Any]) -> list[bytes]:
    """Return messages of a type of ``std_msgs``, such as ``Float64``, with these values."""
    layout = np.dtype([("header", f"V{HEADER}"), ("data", np.dtype(kind.lower()).newbyteorder("<"))])
    return _rows(len(values), layout, data=values)


def joint_rows(
    names: Sequence[str],
    instants: NDArray[np.float64],
    parts: Mapping[str, NDArray[np.float64]],
    frame_id: str = "",
) -> list[bytes]:
    """Return messages of ``sensor_msgs/JointState``.

    Args:
        names: of the joints.
        instants: when the samples were taken, in seconds since 1970, shape (samples,).
        parts: position, velocity and effort, in this order, of shape (samples, joints), or (samples, 0) for none.
        frame_id: of the header.
    """
    seconds, nanoseconds = np.divmod(np.rint(instants * 1e9).astype(np.int64), 1_000_000_000)
    texts = _string(frame_id.encode(), 8)
    texts += _padding(8 + len(texts), 4) + struct.pack("<I", len(names))
    for name in names:
        texts += _string(name.encode(), 8 + len(texts))
    fields: list[tuple[Any, ...]] = [
        ("header", f"V{HEADER}"),
        ("sec", "<i4"),
        ("nanosec", "<u4"),
        ("texts", f"V{len(texts)}"),
    ]
    given: dict[str, Any] = {"sec": seconds, "nanosec": nanoseconds, "texts": np.void(texts)}
    end = 8 + len(texts)
    for part, columns in parts.items():
        count = columns.shape[1]
        before = _padding(end, 4)
        between = _padding(end + len(before) + 4, 8) if count else b""
        fields += [
            (f"{part}_before", f"V{len(before)}"),
            (f"{part}_count", "<u4"),
            (f"{part}_between", f"V{len(between)}"),
        ]
        fields += [(part, "<f8", (count,))]
        given |= {f"{part}_count": count, part: columns}
        end += len(before) + 4 + len(between) + 8 * count
    return _rows(len(instants), np.dtype(fields), **given)


def _string(text: bytes, at: int) -> bytes:
    return _padding(at, 4) + struct.pack("<I", len(text) + 1) + text + b"\0"


def _padding(at: int, to: int) -> bytes:
    return bytes(-at % to)


def _rows(count: int, layout: np.dtype[np.void], **values: Any) -> list[bytes]:
    rows = np.zeros(count, layout)
    rows["header"] = _HEADER
    for name, value in values.items():
        rows[name] = value
    whole, size = rows.tobytes(), layout.itemsize
    return [whole[start : start + size] for start in range(0, len(whole), size)]
