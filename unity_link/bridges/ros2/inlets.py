"""Topics that are subscribed to: one thread waits for all of them, and takes all that has come together.

A listener of CycloneDDS would be called by the thread that receives, which then waits for Python instead of receiving.
"""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from cyclonedds.core import GuardCondition, InstanceState, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.internal import dds_infinity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from unity_link.bridges.commands import Command

MOST_AT_ONCE = 1024
_ANY = SampleState.Any | ViewState.Any | InstanceState.Any


class Inlets:
    """Reads topics until `close`.

    Args:
        participant: reads.
        readers: of CycloneDDS, each with the signal that its values are for.
        others: of CycloneDDS, each with what takes its messages.
        give: takes the values; called in the thread, it may block.
        report: is told in a sentence of messages that are none.
    """

    def __init__(
        self,
        participant: Any,
        readers: list[tuple[Any, Any]],
        others: Sequence[tuple[Any, Callable[[Any], None]]],
        give: Callable[..., None],
        report: Callable[[str], None],
    ) -> None:
        self._readers = readers
        self._others = others
        self._give = give
        self._report = report
        self._waiting = WaitSet(participant)
        self._end = GuardCondition(participant)
        self._conditions = [ReadCondition(reader, _ANY) for reader, _ in (*readers, *others)]
        for condition in (self._end, *self._conditions):
            self._waiting.attach(condition)
        self._ended = False
        self._thread = threading.Thread(target=self._read, name="ros2-read", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End; what has been taken is given."""
        self._ended = True
        self._end.set(True)
        self._thread.join()

    def _read(self) -> None:
        while not self._ended:
            self._waiting.wait(dds_infinity)
            for reader, proxy in self._readers:
                # What makes an instance come or go has no value.
                messages = [one for one in reader.take(N=MOST_AT_ONCE) if hasattr(one, "data")]
                commands: list[Command] = [(proxy, one.data) for one in messages if one.data is not None]
                if len(commands) != len(messages):
                    self._report(f"a message on {reader.topic.name} is too short for its type")
                if commands:
                    self._give(*commands)
            for reader, take in self._others:
                for message in self._taken(reader):
                    take(message)

    def _taken(self, reader: Any) -> list[Any]:
        try:
            return [one for one in reader.take(N=MOST_AT_ONCE) if hasattr(one, "__idl__")]
        except Exception as error:  # noqa: BLE001  (what CycloneDDS cannot read may raise anything)
            self._report(f"a message on {reader.topic.name} is none of its type ({type(error).__name__})")
            return []
