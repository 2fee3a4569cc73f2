"""Samples on their way to one browser: bounded, whatever the browser does."""

from __future__ import annotations

import struct
from collections import deque
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from unity_link.data import Batch, Proxy

MOST_BYTES = 4 << 20
"""What waits for a browser that does not read; then the oldest samples are dropped, and counted."""
HEAD = struct.Struct("<dQ")
"""This machine's clock in seconds since 1970, and the samples that were dropped since the browser came."""
BATCH_HEAD = struct.Struct("<II")
"""Number of the stream, and of its samples that follow."""


class Chunk(NamedTuple):
    """A batch as the browser gets it; all browsers share it."""

    stream: int
    table: NDArray[np.float64]
    """Instants, samples lost before each, and the values of each signal; shape (2 + signals, samples)."""


def tabulate(stream: int, batch: Batch, instants: NDArray[np.float64], proxies: tuple[Proxy[object], ...]) -> Chunk:
    """Make a table of a batch of the stream of that number."""
    table = np.empty((2 + len(proxies), len(batch)), "<f8")
    table[0] = instants
    table[1] = batch.lost
    for row, proxy in enumerate(proxies, start=2):
        table[row] = batch.columns[proxy]
    return Chunk(stream, table)


class Outbox:
    """What one browser has not got yet."""

    def __init__(self, most_bytes: int = MOST_BYTES) -> None:
        self.dropped = 0
        """Samples that were dropped."""
        self.bytes = 0
        """Bytes that wait."""
        self._most_bytes = most_bytes
        self._chunks: deque[Chunk] = deque()

    def put(self, chunk: Chunk) -> None:
        """Add a batch; the oldest go where there is no room."""
        self._chunks.append(chunk)
        self.bytes += chunk.table.nbytes
        while self.bytes > self._most_bytes and len(self._chunks) > 1:
            oldest = self._chunks.popleft()
            self.bytes -= oldest.table.nbytes
            self.dropped += oldest.table.shape[1]

    def take(self, now: float) -> bytes | None:
        """Return all that waits as one message, one table for each stream; None where nothing does."""
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
