"""From a robot into a file: samples are taken by the event loop and written by a thread, so that neither waits.

A recording is left alone for hours. So a gateway that goes away does not end it, where its link reconnects: it goes on
when the gateway is back, and the file has a note of each interruption.
"""

from __future__ import annotations

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

from unity_link.bridges.carrying import Carrier
from unity_link.bridges.gateway_time import GatewayTime, SteadyClock
from unity_link.bridges.recording.files import RecordingFile, path_of
from unity_link.bridges.sampled import sampled_groups

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from unity_link.data import Batch, Robot

SYNC_EVERY = 0.5
"""Seconds. What a crash may cost is twice that: a second."""
WATCH_EVERY = 0.1
"""Seconds. So exactly is known when a gateway went away and came back."""
BUFFER = 1 << 18
"""Samples of each group that wait while the disk is slow: five seconds of 50,000 a second."""
REST = 0.02
"""Seconds that the thread rests after each batch: what comes meanwhile is one batch, and costs half as much."""


class Recorder:
    """Records all that a robot publishes.

    Args:
        robot: what is recorded, behind an open link.
        path: the file.
        poll_hz: also record, read so often, what nothing publishes.
        overwrite: whether a file of that name may go.
        report: is told in a sentence when the gateway goes away and when it is back.

    Raises:
        ArgumentError: where the spec publishes nothing and `poll_hz` is not given, or the file cannot be written.
        RecordingError: where the disk is full from the beginning, or mcap is not installed.
    """

    def __init__(
        self,
        robot: Robot,
        path: Path | str,
        *,
        poll_hz: float | None = None,
        overwrite: bool = False,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        groups = sampled_groups(robot, poll_hz)
        self._file = RecordingFile(path_of(path), robot.interface, robot.link.gateway, groups, overwrite=overwrite)
        self._carrier = Carrier([group.group for group in groups], self._write, report, buffer=BUFFER)
        self._link = robot.link
        self._clock = SteadyClock()
        self._time = GatewayTime(robot.link, clock=self._clock)
        self._report = report
        self.interruptions = 0
        """How often the gateway was away."""
        self._away = 0.0
        self._away_since: float | None = None

    @property
    def samples(self) -> int:
        """Samples in the file."""
        return self._file.messages

    @property
    def lost(self) -> int:
        """Samples that the gateway took and that did not arrive, or found the disk too slow."""
        return self._carrier.lost

    @property
    def size(self) -> int:
        """Bytes that are on the disk."""
        return self._file.size

    @property
    def away(self) -> float:
        """Seconds for which the gateway was away."""
        return self._away + (0.0 if self._away_since is None else self._clock.now() - self._away_since)

    async def run(self) -> None:
        """Record until it is cancelled; the file is finished whatever ends it, and removed where it has no samples.

        Raises:
            RecordingError: where the disk takes no more.
            LinkLostError: where the link ends.
        """
        loop = asyncio.get_running_loop()
        writer = ThreadPoolExecutor(1, "recorder")
        try:
            await self._carrier.run(writer, self._sync(writer), self._watch(writer))
        finally:
            # The thread does one thing after another: all that it was given comes first.
            await asyncio.shield(loop.run_in_executor(writer, self._file.close))
            writer.shutdown()
            if not self.samples:
                self._file.path.unlink(missing_ok=True)

    def _write(self, group: int, batch: Batch) -> None:
        self._file.write(group, batch, self._time.instants(group, batch))
        time.sleep(REST)

    async def _sync(self, writer: ThreadPoolExecutor) -> None:
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(SYNC_EVERY)
            await loop.run_in_executor(writer, self._file.sync)

    async def _watch(self, writer: ThreadPoolExecutor) -> None:
        link, loop = self._link, asyncio.get_running_loop()
        before, heard = link.statistics, self._clock.now()
        while True:
            await asyncio.sleep(WATCH_EVERY)
            seen, now = link.statistics, self._clock.now()
            if self._away_since is None and (not link.connected or seen.reconnections != before.reconnections):
                self._away_since = heard
                self.interruptions += 1
                self._report("the gateway has gone away: recording goes on when it is back")
            if link.connected and self._away_since is not None:
                began, self._away_since = self._away_since, None
                self._away += now - began
                self._report(f"the gateway is back after {now - began:.1f} s")
                await loop.run_in_executor(writer, self._file.note_interruption, began, now)
            if seen.bytes_received != before.bytes_received:
                heard = now
            before = seen
