"""A minimal program that reads one word, as a user might write it: pyserial, the frames of a read, and a lock."""

from __future__ import annotations

import threading

import serial

from benchmarks.expected import ADDRESS, expect
from benchmarks.peers.race import median_of, seconds_of
from benchmarks.responder import GATEWAY, exchange


class ByHand:
    """Reads from a pseudo-terminal, one word after the other.

    Args:
        path: of the pseudo-terminal.
    """

    def __init__(self, path: str) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._request, response = exchange(GATEWAY, "R", ADDRESS, reads=0)
        self._length = len(response)
        begin = 1 + GATEWAY.id_digits
        self._word = slice(begin, begin + GATEWAY.data_bits // 4)

    def seconds_of_a_read(self, count: int) -> float:
        """Return the median of `count` reads, in seconds."""
        with serial.Serial(self._path) as port:
            expect(self._read(port))
            return median_of(lambda: self._read(port), count)

    def seconds_of_reads(self, count: int) -> float:
        """Return the seconds per read of `count` consecutive reads."""
        with serial.Serial(self._path) as port:

            def work() -> None:
                for _ in range(count):
                    self._read(port)

            return seconds_of(work) / count

    def _read(self, port: serial.Serial) -> int:
        with self._lock:
            port.write(self._request)
            return int(port.read(self._length)[self._word], 16)
