"""The recorder of a robot: the event loop receives samples and a thread writes them, so that neither waits.

A recording may run for hours without supervision. So if the gateway goes away and the link reconnects, the recording
continues when the gateway is back, and the file has a note of each interruption.
"""

from __future__ import annotations

import asyncio
import time
import warnings
from concurrent.futures import ThreadPoolExecutor
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING, Self

from unity_link.bridges.gateway_time import GatewayTime, SteadyClock
from unity_link.bridges.presence import Presence
from unity_link.bridges.recording.files import RecordingFile, path_of
from unity_link.bridges.sampled import sampled_groups
from unity_link.bridges.thread_queue import Carrier
from unity_link.errors import ArgumentError, first_error, refusing

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path
    from types import TracebackType

    from unity_link.data import Batch, Robot

SYNC_EVERY = 0.5
"""Seconds between writes to the disk. A crash may lose the samples of twice that time: a second."""
WATCH_EVERY = 0.1
"""Seconds between checks whether the gateway is away; the instants of interruptions are as exact as this."""
BUFFER = 1 << 18
"""Samples of each group that may wait while the disk is slow: five seconds at 50,000 per second."""
REST = 0.02
"""Seconds that the thread sleeps after each batch: later samples then form one batch, which costs half as much."""


class Recorder:
    """Records all samples that a robot publishes, while its ``async with`` block runs.

    ::

        async with Recorder(Scara(link), "run.mcap") as recorder:
            await asyncio.sleep(10)
        print(recorder.samples, "samples")

    When the block begins, all groups are being sampled. When it ends, in any way, the file is finished, or removed if
    it has no samples. An error that ends the recording earlier ends the block at once, and the block raises it.

    Args:
        robot: robot to record, on an open link.
        path: path of the file.
        poll_hz: rate at which readable registers that nothing publishes are polled and recorded; None not to do so.
        overwrite: whether an existing file is replaced.
        report: called with a sentence if the gateway goes away, and when it is back.

    Raises:
        ArgumentError: if the spec publishes nothing and `poll_hz` is not given, or the file cannot be written.
        RecordingError: if the disk is full from the beginning, or mcap is not installed.
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
        self._clock = SteadyClock()
        self._time = GatewayTime(robot.link, clock=self._clock)
        self._report = report
        self.interruptions = 0
        """Number of times the gateway was away."""
        self._away = 0.0
        self._presence = Presence(robot.link, self._clock.now())
        self._block = AsyncExitStack()
        self._is_idle = True

    _is_idle = False
    """True while the file waits for `run`."""

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __enter__ = __exit__ = refusing("write `async with` before a recorder")

    def __del__(self) -> None:
        """Warn if the recorder has never run, and remove its file."""
        if self._is_idle:
            self._file.discard()
            warnings.warn(
                f"the recorder of {self._file.path} was never run: use `async with`",
                ResourceWarning,
                stacklevel=1,
                source=self,
            )

    def __repr__(self) -> str:
        """Return the path of the file, and the numbers of samples written and lost."""
        return f"<recorder of {self._file.path}: {self.samples} samples, {self.lost} lost>"

    @property
    def samples(self) -> int:
        """Number of samples in the file."""
        return self._file.messages

    @property
    def lost(self) -> int:
        """Number of samples that the gateway took and that did not arrive, or were dropped because the disk is slow."""
        return self._carrier.lost

    @property
    def size(self) -> int:
        """Number of bytes that are on the disk."""
        return self._file.size

    @property
    def away(self) -> float:
        """Seconds for which the gateway was away, in total."""
        since = self._presence.away_since
        return self._away + (0.0 if since is None else self._clock.now() - since)

    async def __aenter__(self) -> Self:
        self._check_idle()
        try:
            async with AsyncExitStack() as block:
                block.enter_context(first_error())
                tasks = await block.enter_async_context(asyncio.TaskGroup())
                block.callback(tasks.create_task(self.run()).cancel)
                await self._carrier.begun.wait()
                self._block = block.pop_all()
        finally:
            # A task that is cancelled before it begins runs no code, not even a `finally`.
            if self._is_idle:
                self._is_idle = False
                self._file.discard()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._block.__aexit__(kind, error, trace)

    async def run(self) -> None:
        """Record until this is cancelled. At the end, in any way, the file is finished, or removed if it is empty.

        Raises:
            ArgumentError: if the recorder has run before.
            RecordingError: if the disk fails or is full.
            LinkLostError: if the link ends.
        """
        self._check_idle()
        self._is_idle = False
        loop = asyncio.get_running_loop()
        writer = ThreadPoolExecutor(1, "recorder")
        try:
            await self._carrier.run(writer, self._sync(writer), self._watch(writer), self._ask())
        finally:
            try:
                # The thread runs its calls in order: all batches that it was given are written before this.
                await asyncio.shield(loop.run_in_executor(writer, self._file.close))
            finally:
                writer.shutdown()
                if not self.samples:
                    self._file.discard()

    def _check_idle(self) -> None:
        if not self._is_idle:
            raise ArgumentError(f"the recorder of {self._file.path} has run before: make another one")

    def _write(self, group: int, batch: Batch) -> None:
        self._file.write(group, batch, self._time.instants(group, batch))
        time.sleep(REST)

    async def _sync(self, writer: ThreadPoolExecutor) -> None:
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(SYNC_EVERY)
            await loop.run_in_executor(writer, self._file.sync)

    async def _ask(self) -> None:
        # Before all groups are sampled, an absence of the gateway is no interruption.
        await self._carrier.begun.wait()
        await self._presence.ask()

    async def _watch(self, writer: ThreadPoolExecutor) -> None:
        presence, carrier, loop = self._presence, self._carrier, asyncio.get_running_loop()
        while True:
            await asyncio.sleep(WATCH_EVERY)
            was_there = presence.away_since is None
            over = presence.look(self._clock.now(), carrier.received, carrier.rate_hz)
            if was_there and (over is not None or presence.away_since is not None):
                self.interruptions += 1
                self._report("the gateway has gone away: recording goes on when it is back")
            if over is not None:
                seconds = over.ended - over.began
                self._away += seconds
                self._report(f"the gateway is back after {seconds:.1f} s")
                await loop.run_in_executor(writer, self._file.note_interruption, *over)
