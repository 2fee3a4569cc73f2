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

MOST_AT_ONCE = 1024
_ANY = SampleState.Any | ViewState.Any | InstanceState.Any


class Inlets:
    """Reads topics until `close`.

    Args:
        participant: reads.
        readers: of CycloneDDS, each with a function that the thread calls with its messages, and that may block.
        report: logs a sentence about messages of another type.
    """

    def __init__(
        self, participant: Any, readers: Sequence[tuple[Any, Callable[[Any], object]]], report: Callable[[str], None]
    ) -> None:
        self._readers = readers
        self._report = report
        self._waiting = WaitSet(participant)
        self._end = GuardCondition(participant)
        self._conditions = [ReadCondition(reader, _ANY) for reader, _ in readers]
        for condition in (self._end, *self._conditions):
            self._waiting.attach(condition)
        self._ended = False
        self._thread = threading.Thread(target=self._read, name="ros2-read", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End; messages that were read are handed over before."""
        self._ended = True
        self._end.set(True)
        self._thread.join()

    def _read(self) -> None:
        while not self._ended:
            self._waiting.wait(dds_infinity)
            for reader, take in self._readers:
                try:
                    messages = reader.take(N=MOST_AT_ONCE)
                except Exception as error:  # noqa: BLE001  (what CycloneDDS cannot read may raise anything)
                    self._report(f"a message on {reader.topic.name} is none of its type ({type(error).__name__})")
                    continue
                for message in messages:
                    if getattr(message, "data", message) is None:
                        self._report(f"a message on {reader.topic.name} is too short for its type")
                    # An instance that appears or disappears has no message.
                    elif hasattr(message, "__idl__"):
                        take(message)
