"""Messages of ROS as rows of bytes, many at a time: rospy, CycloneDDS and rclpy would serialise them one by one.

A message of ROS 1 follows its length. ROS 2 has plain CDR, lowest byte first, after a header (DDS-RTPS 10.2; DDS-XTypes
7.4.1). All messages of one topic have one length: numbers, and states of always the same joints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from unity_link.bridges.sensor_topics import Field

Rows = np.ndarray[Any, np.dtype[np.void]]
"""Shape (messages,)."""
HEADER = 4
"""Bytes before a message: the header of ROS 2 (DDS-RTPS 10.2), or the length of ROS 1."""
_CDR = np.void(b"\0\1\0\0")


def number_rows(kind: str, values: NDArray[Any], *, cdr: bool) -> Rows:
    """Return messages of a type of ``std_msgs``, such as ``Float64``, with these values; `cdr` is True for ROS 2."""
    return _rows(len(values), [(np.dtype(kind.lower()).newbyteorder("<"), values)], cdr=cdr)


def stamped_rows(
    instants: NDArray[np.float64], fields: Sequence[Field], frame_id: str = "", first: int | None = None
) -> Rows:
    """Return messages that begin with a ``std_msgs/Header``.

    Args:
        instants: times of the samples, in seconds since 1970, shape (samples,).
        fields: all fields after the header.
        frame_id: of the header.
        first: number of the first message, in ROS 1; None for ROS 2, whose messages have no numbers.
    """
    end = b"\0" if first is None else b""
    number = [] if first is None else [("<u4", np.arange(first, first + len(instants)) & 0xFFFF_FFFF)]
    seconds, nanoseconds = np.divmod(np.rint(instants * 1e9).astype(np.int64), 1_000_000_000)
    placed: list[tuple[Any, Any]] = []
    for field in (*number, ("<u4", seconds), ("<u4", nanoseconds), frame_id, *fields):
        text = field.encode() + end if isinstance(field, str) else b""
        placed += [("<u4", len(text)), (f"V{len(text)}", np.void(text))] if isinstance(field, str) else [field]
    return _rows(len(instants), placed, cdr=first is None)


def _rows(count: int, fields: Sequence[tuple[Any, Any]], *, cdr: bool) -> Rows:
    """Return rows of fields, each a type and its value or values; CDR aligns numbers, and arrays that are not empty."""
    placed: dict[str, tuple[np.dtype[Any], int]] = {}
    values = {}
    end = 0
    for number, (kind, value) in enumerate(fields):
        layout = np.dtype(kind)
        if layout.itemsize:
            end += -end % layout.base.itemsize if cdr and layout.base.kind != "V" else 0
            placed[str(number)], values[str(number)] = (layout, HEADER + end), value
            end += layout.itemsize
    placed["before"], values["before"] = (np.dtype("V4" if cdr else "<u4"), 0), _CDR if cdr else end
    formats, offsets = zip(*placed.values(), strict=True)
    names = list(placed)
    rows = np.zeros(count, {"names": names, "formats": formats, "offsets": offsets, "itemsize": HEADER + end})
    for name, value in values.items():
        rows[name] = value
    return rows
