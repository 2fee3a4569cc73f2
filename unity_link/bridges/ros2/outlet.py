"""A topic that is published: many messages at a time, and a reader that is stuck holds up no other for long."""

from __future__ import annotations

import abc
import math
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class Ros2Outlet(abc.ABC):
    """A topic that is published.

    Args:
        name: full name of the topic.
        report: logs a sentence about readers that are stuck.
    """

    def __init__(self, name: str, report: Callable[[str], None]) -> None:
        self.sent = 0
        """Messages that were sent, while somebody read."""
        self.lost = 0
        """Messages that a reader asked for and did not take."""
        self.deadline = math.inf
        """Instant of `time.monotonic` until which messages are sent and confirmed."""
        self._name = name
        self._report = report
        self._stuck = False

    @property
    @abc.abstractmethod
    def is_wanted(self) -> bool:
        """Return whether the topic has a reader."""

    @abc.abstractmethod
    def _write(self, row: bytes) -> bool:
        """Write a message; return False if there is no room for it."""

    @abc.abstractmethod
    def _is_confirmed(self, patience: float) -> bool:
        """Return whether the readers have all messages within so many seconds."""

    @abc.abstractmethod
    def _flush(self) -> None:
        """Send the messages that were written."""

    def send(self, rows: list[bytes]) -> None:
        """Send serialised messages. If a reader is stuck, send none until all readers have the earlier ones."""
        if self._stuck and not self._is_confirmed(0):
            self.lost += len(rows)
            return
        self._stuck = False
        # A slow reader may take each message just in time.
        failed = (n for n, row in enumerate(rows) if time.monotonic() > self.deadline or not self._write(row))
        sent = next(failed, len(rows))
        self._flush()
        self.sent += sent
        if sent < len(rows):
            self._stuck = True
            self.lost += len(rows) - sent
            self._report(f"a reader of {self._name} takes nothing: messages are lost")

    def finish(self) -> None:
        """Wait until the readers have all messages, or until the deadline."""
        if not self._is_confirmed(max(0.0, self.deadline - time.monotonic())):
            self._report(f"a reader of {self._name} has not confirmed all messages: the last ones may be lost")
