"""Samples that several share: however many loops and callbacks want a group's samples, the gateway sends them once.

A feed subscribes when the first one listens, and ends when the last one has left. Each listener has a buffer of its
own, so a slow one takes nothing from the others. A polled read that the gateway refuses ends loops with its error, as
does a shared gateway that is away; callbacks, which have no way to begin again, wait for the next turn.
"""

from __future__ import annotations

import logging
from collections import Counter, deque
from typing import TYPE_CHECKING, Self

from unity_link.errors import (
    BusTimeoutError,
    GatewayError,
    GatewayResetError,
    LinkClosedError,
    LinkLostError,
    Outcome,
    SamplesLostError,
    UnityLinkError,
)
from unity_link.link.runtimes.runtime import report
from unity_link.link.runtimes.synchronisation import running

if TYPE_CHECKING:
    from collections.abc import Callable, Collection
    from types import TracebackType

    from unity_link.data.batch import Batch
    from unity_link.data.layout import GroupLayout
    from unity_link.data.sampling import GroupSubscription
    from unity_link.link.publishing import Overflow
    from unity_link.link.runtimes.runtime import Job, Waiter

log = logging.getLogger("unity_link.data")
LOOK_EVERY = 1.0
"""Seconds between looks whether a gateway is there that was away when the samples were to begin."""


class Listener:
    """A consumer of the samples of a feed, in batches, until its ``with`` block ends."""

    def __init__(self, feed: Feed, callback: Callable[[Batch], object] | None, buffer: int, overflow: Overflow) -> None:
        self._feed = feed
        self._callback = callback
        self._buffer = buffer
        self._overflow = overflow
        self._batches: deque[Batch] = deque()
        self._waiting = 0
        self._lost: Counter[GroupLayout] = Counter()
        """Samples of each gateway that were dropped since the last batch of it was taken."""
        self._waiter: Waiter | None = None
        self._error: Exception | None = None
        self._is_overflow_logged = False

    async def next(self) -> Batch:
        """Wait for the next batch.

        Raises:
            SamplesLostError: where more samples came than the buffer holds.
            GatewayError: where the gateway refused a polled read, after the batches that had come before.
            LinkLostError: when the link ends, after the batches that had come before.
        """
        while not self._batches:
            if self._error is not None:
                raise self._error
            self._waiter = running().create_future()
            try:
                await self._waiter
            finally:
                self._waiter = None
        batch = self._batches.popleft()
        self._waiting -= len(batch)
        return batch.behind(0, self._lost.pop(batch.layout, 0))

    def leave(self) -> None:
        """Want no more samples. May be called twice."""
        self._feed.leave(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.leave()

    # Called by the feed

    def deliver(self, batch: Batch) -> None:
        """Take a batch."""
        if self._callback is not None:
            self._callback(batch)
            return
        if self._error is not None or not self._buffer:
            return
        self._batches.append(batch)
        self._waiting += len(batch)
        if self._waiting > self._buffer:
            if self._overflow == "fail":
                self.fail(SamplesLostError(f"the reader is too slow: {self._buffer} samples are waiting for it"))
                return
            self._log_overflow()
            self._drop(self._waiting - self._buffer)
        self._wake()

    def fail(self, error: Exception) -> None:
        """End with an error, behind the batches that wait; a callback is called on, where there are more."""
        if self._error is None:
            self._error = error
        self._wake()

    def is_deaf(self) -> bool:
        """Return whether an error would reach no listener."""
        return self._callback is not None or not self._buffer

    def _log_overflow(self) -> None:
        """Log that samples are dropped, once, unless the listener wants only the newest one."""
        if self._buffer > 1 and not self._is_overflow_logged:
            self._is_overflow_logged = True
            text = "the reader of %s is too slow: its buffer (samples: %d) drops the oldest (logged once)"
            log.warning(text, self._feed.name, self._buffer)

    def _drop(self, count: int) -> None:
        """Drop the oldest samples; the first that is left of their gateway tells how many."""
        self._waiting -= count
        while count:
            batch = self._batches.popleft()
            dropped = min(count, len(batch))
            count -= dropped
            if dropped < len(batch):
                self._batches.appendleft(batch.behind(dropped))
            else:
                self._lost[batch.layout] += dropped + int(batch.lost.sum())

    def _wake(self) -> None:
        if self._waiter is not None and not self._waiter.done():
            self._waiter.set_result(None)


class Feed:
    """The samples of one group, for all who listen."""

    def __init__(self, name: str, subscribe: Callable[[], GroupSubscription]) -> None:
        self.name = name
        """Name of the group in messages."""
        self._subscribe = subscribe
        self._listeners: dict[Listener, None] = {}
        self._task: Job | None = None
        self._began = self._deserted = False
        self._starts = 0
        """Number of times a task was begun, or cancelled before it began."""
        self._told: set[type[UnityLinkError]] = set()

    def listen(
        self, callback: Callable[[Batch], object] | None = None, *, buffer: int = 0, overflow: Overflow = "fail"
    ) -> Listener:
        """Begin to listen.

        Args:
            callback: is called with each batch.
            buffer: most samples that wait for `Listener.next`; 0 for one who only wants proxies to see them.
            overflow: what happens when they are more.
        """
        listener = Listener(self, callback, buffer, overflow)
        if self._task is None:
            self._start()
        self._listeners[listener] = None
        return listener

    def leave(self, listener: Listener) -> None:
        """Take a listener's name off; the last one ends the subscription."""
        self._listeners.pop(listener, None)
        if not self._listeners and self._task is not None:
            self._deserted = True
            self._task.cancel()
            if not self._began:
                # What is cancelled before it begins does not run in asyncio, and runs to its first wait elsewhere.
                self._task = None
                self._starts += 1

    def _start(self) -> None:
        self._began = self._deserted = False
        self._told.clear()
        self._starts += 1
        self._task = running().create_task(self._run(self._starts))

    def _stopped(self) -> None:
        self._task = None
        # A listener that came while the subscription was being ended needs another one.
        if self._deserted and self._listeners:
            self._start()

    async def _run(self, start: int) -> None:
        if start != self._starts:
            return
        self._began = True
        try:
            await self._deliver()
        finally:
            self._stopped()

    async def _deliver(self) -> None:
        try:
            while True:
                try:
                    async with self._subscribe() as subscription:
                        await self._deliver_all(subscription)
                except (BusTimeoutError, GatewayResetError) as error:
                    # Of a gateway behind a server that is away, or was reset just then.
                    what = f"the samples of {self.name}, which callbacks wait for, do not come yet (told once)"
                    self._refuse(what, error)
                await running().sleep(LOOK_EVERY)
        except StopAsyncIteration:
            self._end(LinkLostError(f"the samples of {self.name} have ended", Outcome.NO_REQUEST))
        except Exception as error:  # noqa: BLE001  (whatever it is, no listener may wait for samples that don't come)
            self._end(error)

    async def _deliver_all(self, subscription: GroupSubscription) -> None:
        while True:
            try:
                batch = await subscription.take()
            except GatewayError as error:
                self._refuse(f"a read of {self.name}, which callbacks wait for, was refused (told once)", error)
                continue
            for listener in tuple(self._listeners):
                listener.deliver(batch)

    def _refuse(self, what: str, error: UnityLinkError) -> None:
        """Pass on what keeps samples from coming that may come later."""
        if _fail(self._listeners, error) and type(error) not in self._told:
            self._told.add(type(error))
            report(what, error)

    def _end(self, error: Exception) -> None:
        listeners, self._listeners = self._listeners, {}
        if _fail(listeners, error) and not isinstance(error, LinkClosedError):
            report(f"the samples of {self.name}, which callbacks wait for, have ended", error)


def _fail(listeners: Collection[Listener], error: Exception) -> bool:
    """End listeners with an error, and return whether there is one that it does not reach."""
    for listener in listeners:
        listener.fail(error)
    return any(listener.is_deaf() for listener in listeners)
