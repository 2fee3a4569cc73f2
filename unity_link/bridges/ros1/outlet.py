"""A topic that is published: many messages at a time, and no subscriber holds up another.

rospy writes to the connection of each subscriber with every message, which costs more than all else. So messages that
come together go as one write: on the wire they are the same.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import rospy

from unity_link.bridges.ros import Outlet

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.ros_rows import Rows

MOST_TOGETHER = 1 << 14
"""Bytes of messages in one write."""
MOST_WRITES = 1024
"""Writes that wait for a subscriber that does not read; after that the oldest are lost to it, and counted."""


class Ros1Outlet(Outlet):
    """A topic that is published.

    Args:
        publisher: of rospy, for the topic; its queue holds `MOST_WRITES` messages.
        report: logs a sentence about slow subscribers.
    """

    def __init__(self, publisher: Any, report: Callable[[str], None]) -> None:
        super().__init__(publisher.resolved_name, report)
        self._publisher = publisher
        self._given: dict[Any, int] = {}
        """Number of writes given to each connection."""

    @property
    def is_wanted(self) -> bool:
        """Return whether the topic has a subscriber."""
        return bool(self._publisher.get_num_connections())

    def send(self, rows: Rows) -> None:
        """Send messages."""
        together = max(1, MOST_TOGETHER // rows.dtype.itemsize)
        for start in range(0, len(rows), together):
            piece = rows[start : start + together]
            self._write(_Several(piece), len(piece))

    def _write(self, messages: _Several, count: int) -> None:
        connections = list(self._publisher.impl.connections)
        self._given = {connection: self._given.get(connection, 0) + 1 for connection in connections}
        # rospy drops the oldest without a word.
        full = [(one, one._queue, one._queue[0]) for one in connections if len(one._queue) == MOST_WRITES]  # noqa: SLF001
        self._publisher.publish(messages)
        self.sent += count
        for connection, queue, oldest in full:
            if queue[0] is not oldest:
                self._given[connection] -= 1
                self.lost += len(oldest) // messages.size
                self._report(f"{connection.endpoint_id} reads {self._name} too slowly: it loses messages")

    def finish(self) -> None:
        """Wait until all messages are on their way to all subscribers, or until the deadline."""
        while any(self._is_behind(*one) for one in self._given.items()) and time.monotonic() < self.deadline:
            time.sleep(0.005)

    @staticmethod
    def _is_behind(connection: Any, given: int) -> bool:
        return not connection.done and (connection._queue or connection.stat_num_msg < given)  # noqa: SLF001


class _Several(rospy.AnyMsg):  # type: ignore[misc]
    """Several messages that are serialised already, as one to rospy."""

    def __init__(self, rows: Rows) -> None:
        super().__init__()
        self.size = rows.dtype.itemsize
        """Bytes of each, with its length."""
        self._rows = rows.tobytes()

    def serialize(self, buff: Any) -> None:
        """Write all; then go back to where the first ends, whose length rospy writes before it sends all there is."""
        start = buff.tell()
        buff.write(self._rows[4:])
        buff.seek(start + self.size - 4)
