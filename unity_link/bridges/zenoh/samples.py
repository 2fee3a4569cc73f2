"""Publications of samples: many samples in one publication, by columns.

The key is ``PREFIX/samples/GROUP``. The payload is JSON with lists of the same length::

    {"sequence": [7, 8], "time": [0.07, 0.08], "arrived": [...], "lost": [0, 0], "signals": {"j1.cpos": [1.5, 1.6]}}

``sequence`` has the numbers of the samples, with lost ones counted, and ``lost`` the number lost before each sample.
``time`` is in seconds of the gateway's clock, null without timestamps. ``arrived`` is in seconds since 1970 by the
clock of the bridge's machine. Values that JSON cannot represent (NaN, infinities) are null.
"""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.bridges.thread_queue import Carrier

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Batch

BUFFER = 1 << 17
"""Samples of each group that may wait while the network is slow: five seconds at 25,000 per second."""


class Samples:
    """Publishes the samples of one group.

    Args:
        session: an open session.
        prefix: prefix of all keys.
        sampled: the group.
        every: least number of seconds between publications; samples that arrive meanwhile are published together.
        report: called with a sentence about refused polled reads.
    """

    def __init__(
        self, session: zenoh.Session, prefix: str, sampled: SampledGroup, every: float, report: Callable[[str], None]
    ) -> None:
        import zenoh

        self.published = 0
        """Number of samples published; samples without subscribers do not count."""
        self.messages = 0
        """Number of publications."""
        self._every = every
        self._ended = threading.Event()
        self._paths = [proxy.path for proxy in sampled.group.proxies]
        self._publisher = session.declare_publisher(
            f"{prefix}/samples/{sampled.name}",
            encoding="application/json",
            # The thread blocks if the network is slow; samples wait for the thread.
            congestion_control=zenoh.CongestionControl.BLOCK,
        )
        self.carrier = Carrier([sampled.group], self._publish, report, buffer=BUFFER)

    async def run(self) -> None:
        """Publish until this is cancelled.

        Raises:
            LinkLostError: if the link ends.
        """
        thread = ThreadPoolExecutor(1, "zenoh-samples")
        try:
            await self.carrier.run(thread)
        finally:
            self._ended.set()
            thread.shutdown(wait=False)

    def _publish(self, _: int, batch: Batch) -> None:
        # Without subscribers the samples are not encoded.
        if self._is_wanted():
            self._publisher.put(encode(batch, self._paths))
            self.published += len(batch)
            self.messages += 1
        if self._every:
            self._ended.wait(self._every)

    def _is_wanted(self) -> bool:
        # Zenoh's stubs declare this attribute as a bool, but it is an object with a bool.
        status: Any = self._publisher.matching_status
        wanted: bool = status.matching
        return wanted


def encode(batch: Batch, paths: list[str]) -> bytes:
    """Return the payload for samples of a group; `paths` has the paths of the group's signals in their order."""
    return msgspec.json.encode(
        {
            "sequence": batch.sequence.tolist(),
            "time": [None] * len(batch) if batch.time is None else batch.time.tolist(),
            "arrived": batch.arrived.tolist(),
            "lost": batch.lost.tolist(),
            "signals": {path: column.tolist() for path, column in zip(paths, batch.columns.values(), strict=True)},
        }
    )
