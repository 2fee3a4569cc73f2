"""Samples as publications: many in one, by columns.

At ``PREFIX/samples/GROUP``, as JSON, where all lists have the same length::

    {"sequence": [7, 8], "time": [0.07, 0.08], "arrived": [...], "lost": [0, 0], "signals": {"j1.cpos": [1.5, 1.6]}}

``sequence`` counts lost samples, too, ``lost`` says how many before each; ``time`` is in seconds of the gateway's clock
and null where that gives none; ``arrived`` in seconds since 1970 by the clock of the bridge's machine. What JSON cannot
say, a value that is not a number, is null.
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
"""Samples of each group that wait while the network is slow: five seconds of 25,000 a second."""


class Samples:
    """Publishes the samples of one group.

    Args:
        session: an open session.
        prefix: what all keys begin with.
        sampled: the group.
        every: seconds between publications at least: what comes meanwhile goes together.
        report: is told in a sentence of polled reads that were refused.
    """

    def __init__(
        self, session: zenoh.Session, prefix: str, sampled: SampledGroup, every: float, report: Callable[[str], None]
    ) -> None:
        import zenoh

        self.published = 0
        """Samples that were published: while somebody subscribes."""
        self.messages = 0
        """Publications that they were in."""
        self._every = every
        self._ended = threading.Event()
        self._paths = [proxy.path for proxy in sampled.group.proxies]
        self._publisher = session.declare_publisher(
            f"{prefix}/samples/{sampled.name}",
            encoding="application/json",
            # The thread waits for the network; samples wait for the thread.
            congestion_control=zenoh.CongestionControl.BLOCK,
        )
        self.carrier = Carrier([sampled.group], self._publish, report, buffer=BUFFER)

    async def run(self) -> None:
        """Publish until cancelled.

        Raises:
            LinkLostError: where the link ends.
        """
        thread = ThreadPoolExecutor(1, "zenoh-samples")
        try:
            await self.carrier.run(thread)
        finally:
            self._ended.set()
            thread.shutdown(wait=False)

    def _publish(self, _: int, batch: Batch) -> None:
        # A group without subscribers costs nothing but the way of its samples to here.
        if self._is_wanted():
            self._publisher.put(encode(batch, self._paths))
            self.published += len(batch)
            self.messages += 1
        if self._every:
            self._ended.wait(self._every)

    def _is_wanted(self) -> bool:
        # Declared as a bool, it is an object that has one.
        status: Any = self._publisher.matching_status
        wanted: bool = status.matching
        return wanted


def encode(batch: Batch, paths: list[str]) -> bytes:
    """Return the payload for samples of a group whose signals have these paths, in their order."""
    return msgspec.json.encode(
        {
            "sequence": batch.sequence.tolist(),
            "time": [None] * len(batch) if batch.time is None else batch.time.tolist(),
            "arrived": batch.arrived.tolist(),
            "lost": batch.lost.tolist(),
            "signals": {path: column.tolist() for path, column in zip(paths, batch.columns.values(), strict=True)},
        }
    )
