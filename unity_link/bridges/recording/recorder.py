"""From a robot into a file: samples are taken by the event loop and written by a thread, so that neither waits."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

from unity_link.bridges.carrying import Carrier
from unity_link.bridges.recording.files import RecordingFile
from unity_link.bridges.sampled import sampled_groups

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.data import Robot

SYNC_EVERY = 0.5
"""Seconds. What a crash may cost is twice that: a second."""
BUFFER = 1 << 18
"""Samples of each group that wait while the disk is slow: five seconds of 50,000 a second."""


class Recorder:
    """Records all that a robot publishes.

    Args:
        robot: what is recorded, behind an open link.
        path: the file.
        poll_hz: also record, read so often, what nothing publishes.
        overwrite: whether a file of that name may go.

    Raises:
        ArgumentError: where the spec publishes nothing and `poll_hz` is not given, or the file cannot be written.
    """

    def __init__(self, robot: Robot, path: Path, *, poll_hz: float | None = None, overwrite: bool = False) -> None:
        groups = sampled_groups(robot, poll_hz)
        self._file = RecordingFile(path, robot.interface, robot.link.gateway, groups, overwrite=overwrite)
        self._carrier = Carrier([group.group for group in groups], self._file.write, buffer=BUFFER)

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

    async def run(self) -> None:
        """Record until it is cancelled; the file is finished whatever ends it.

        Raises:
            RecordingError: where the disk takes no more.
            LinkLostError: where the link ends.
        """
        loop = asyncio.get_running_loop()
        writer = ThreadPoolExecutor(1, "recorder")
        try:
            await self._carrier.run(writer, self._sync(writer))
        finally:
            # The thread does one thing after another: all that it was given comes first.
            await asyncio.shield(loop.run_in_executor(writer, self._file.close))
            writer.shutdown()

    async def _sync(self, writer: ThreadPoolExecutor) -> None:
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(SYNC_EVERY)
            await loop.run_in_executor(writer, self._file.sync)
