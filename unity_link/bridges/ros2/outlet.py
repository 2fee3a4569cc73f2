"""A topic that is published: many messages at a time, and a reader that is stuck holds up no other for long.

CycloneDDS sends a packet for each message, unless it is to gather them until they are flushed: a function of its C
library that its Python package does not name.
"""

from __future__ import annotations

import ctypes
import time
from typing import TYPE_CHECKING, Any

from cyclonedds.core import DDSException
from cyclonedds.internal import DDS
from cyclonedds.pub import DataWriter

if TYPE_CHECKING:
    from collections.abc import Callable


_library = ctypes.CDLL(DDS._dll_handle._name)  # noqa: SLF001
_library.dds_write_set_batch.argtypes = [ctypes.c_bool]
_library.dds_write_flush.argtypes = [ctypes.c_int32]
_library.dds_wait_for_acks.argtypes = [ctypes.c_int32, ctypes.c_int64]


class Ros2Outlet:
    """A topic that is published.

    Args:
        participant: who publishes.
        topic: where.
        quality: its quality of service.
        report: is told in a sentence of readers that are stuck.
    """

    def __init__(self, participant: Any, topic: Any, quality: Any, report: Callable[[str], None]) -> None:
        self.sent = 0
        """Messages that were sent, while somebody read."""
        self.lost = 0
        """Messages that a reader asked for and did not take."""
        # It is for all writers that are made from now on.
        _library.dds_write_set_batch(True)  # noqa: FBT003
        self._writer = DataWriter(participant, topic, qos=quality)
        _library.dds_write_set_batch(False)  # noqa: FBT003
        self._topic = topic
        self._report = report
        self._stuck = False

    @property
    def is_wanted(self) -> bool:
        """Return whether the topic has a reader."""
        return bool(self._writer.get_matched_subscriptions())

    def send(self, rows: list[bytes]) -> None:
        """Send messages that are serialised already; where readers are stuck, none until they have taken the others."""
        if self._stuck and not self._is_confirmed(0):
            self.lost += len(rows)
            return
        self._stuck = False
        sent = self._write(rows)
        _library.dds_write_flush(self._writer._ref)  # noqa: SLF001
        self.sent += sent
        if sent < len(rows):
            self._stuck = True
            self.lost += len(rows) - sent
            self._report(f"a reader of {self._topic.name} takes nothing: messages are lost")

    def _write(self, rows: list[bytes]) -> int:
        """Write messages as long as there is room for them; return how many."""
        message = self._topic.data_type.__new__(self._topic.data_type)
        write = self._writer.write
        for number, row in enumerate(rows):
            message.packed = row
            try:
                write(message)
            except DDSException:
                return number
        return len(rows)

    def finish(self, deadline: float) -> None:
        """End, when all who read have what was sent, or at an instant of `time.monotonic`."""
        self._is_confirmed(max(0.0, deadline - time.monotonic()))
        del self._writer, self._topic

    def _is_confirmed(self, patience: float) -> bool:
        """Return whether readers have all, or have it within so many seconds."""
        return int(_library.dds_wait_for_acks(self._writer._ref, round(patience * 1e9))) == 0  # noqa: SLF001
