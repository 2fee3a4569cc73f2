"""Samples on their way to one browser, in a buffer of limited size."""

from __future__ import annotations

import struct
from collections import deque
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from unity_link.bridges.presence import longest_silence, periodic_rate

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from unity_link.data import Batch, Group

MOST_BYTES = 4 << 20
"""Most bytes kept for a browser that does not read; with more, the oldest samples are dropped and counted."""
HEAD = struct.Struct("<dQ")
"""This machine's clock in seconds since 1970, and the number of samples dropped since the browser connected."""
BATCH_HEAD = struct.Struct("<II")
"""Number of the stream, and number of its samples in the table that follows."""


class Chunk(NamedTuple):
    """A batch in the form for browsers; all browsers share it."""

    stream: int
    table: NDArray[np.float64]
    """Instants, marks of missing samples before each, and values by signal; shape (2 + signals, samples)."""


class Tabulator:
    """Makes tables from the batches of one stream.

    Args:
        stream: number of the stream.
        group: group of the stream.
        rate_hz: rate of its samples; None if they are not periodic.
    """

    def __init__(self, stream: int, group: Group, rate_hz: float | None) -> None:
        self._stream = stream
        self._proxies = group.proxies
        steady = periodic_rate(group, rate_hz)
        self._longest = np.inf if steady is None else longest_silence(steady)
        self._epoch: int | None = None
        self._newest = -np.inf

    def tabulate(self, batch: Batch, instants: NDArray[np.float64]) -> Chunk:
        """Return the table of a batch."""
        table = np.empty((2 + len(self._proxies), len(batch)), "<f8")
        table[0] = instants
        table[1] = self._has_gap_before(batch, instants)
        for row, proxy in enumerate(self._proxies, start=2):
            table[row] = batch.columns[proxy]
        return Chunk(self._stream, table)

    def _has_gap_before(self, batch: Batch, instants: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return whether samples are missing before each sample: lost ones, or those while the gateway was away."""
        epochs = np.concatenate(([batch.epoch[0] if self._epoch is None else self._epoch], batch.epoch))
        times = np.concatenate(([instants[0] if self._epoch is None else self._newest], instants))
        self._epoch, self._newest = int(epochs[-1]), float(times[-1])
        missing: NDArray[np.bool_] = (batch.lost > 0) | (np.diff(epochs) != 0) | (np.diff(times) > self._longest)
        return missing


class Outbox:
    """Samples that one browser has not received yet."""

    def __init__(self, most_bytes: int = MOST_BYTES) -> None:
        self.dropped = 0
        """Number of samples dropped."""
        self.bytes = 0
        """Number of bytes in the buffer."""
        self._most_bytes = most_bytes
        self._chunks: deque[Chunk] = deque()

    def put(self, chunk: Chunk) -> None:
        """Add a batch; drop the oldest batches if there is no room."""
        self._chunks.append(chunk)
        self.bytes += chunk.table.nbytes
        while self.bytes > self._most_bytes and len(self._chunks) > 1:
            oldest = self._chunks.popleft()
            self.bytes -= oldest.table.nbytes
            self.dropped += oldest.table.shape[1]

    def take(self, now: float) -> bytes | None:
        """Return all samples as one message, with one table for each stream; None if there are none."""
        if not self._chunks:
            return None
        tables: dict[int, list[NDArray[np.float64]]] = {}
        for stream, table in self._chunks:
            tables.setdefault(stream, []).append(table)
        self._chunks.clear()
        self.bytes = 0
        parts = [HEAD.pack(now, self.dropped)]
        for stream, several in tables.items():
            whole = np.concatenate(several, axis=1)
            parts += (BATCH_HEAD.pack(stream, whole.shape[1]), whole.tobytes())
        return b"".join(parts)
