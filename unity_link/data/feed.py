"""Samples with several consumers: for any number of loops and callbacks, the gateway sends a group's samples once.

A feed subscribes when its first listener begins, and ends the subscription when the last one has left. Each listener
has a buffer of its own, so a slow one does not affect the others. If the gateway refuses a polled read, or a gateway
behind a server is away, loops end with the error. Callbacks cannot be restarted by a loop, so the feed tries again.
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
"""Seconds between attempts to subscribe if the gateway is away."""


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
        """Samples of each gateway that were dropped since its last batch was taken."""
        self._waiter: Waiter | None = None
        self._error: Exception | None = None
        self._is_overflow_logged = False

    async def next(self) -> Batch:
        """Wait for the next batch.

        Raises:
            SamplesLostError: if more samples arrived than the buffer holds.
            GatewayError: if the gateway refused a polled read; raised after the batches that had arrived before.
            LinkLostError: if the link ends; raised after the batches that had arrived before.
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
        """End the listener: it receives no more samples. May be called twice."""
        self._feed.leave(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.leave()

    # Called by the feed

    def deliver(self, batch: Batch) -> None:
        """Receive a batch."""
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
        """End with an error, which `next` raises after the waiting batches. A callback still receives later batches."""
        if self._error is None:
            self._error = error
        self._wake()

    def hides_errors(self) -> bool:
        """Return whether no caller of `next` would receive an error."""
        return self._callback is not None or not self._buffer

    def _log_overflow(self) -> None:
        """Log once that samples are dropped, unless the listener wants only the newest sample."""
        if self._buffer > 1 and not self._is_overflow_logged:
            self._is_overflow_logged = True
            text = "the reader of %s is too slow: its buffer (samples: %d) drops the oldest (logged once)"
            log.warning(text, self._feed.name, self._buffer)

    def _drop(self, count: int) -> None:
        """Drop the oldest samples. The next sample of their gateway counts them as lost."""
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
    """The samples of one group, for all listeners."""

    def __init__(self, name: str, subscribe: Callable[[], GroupSubscription]) -> None:
        self.name = name
        """Name of the group in messages."""
        self._subscribe = subscribe
        self._listeners: dict[Listener, None] = {}
        self._task: Job | None = None
        self._began = self._is_abandoned = False
        self._starts = 0
        """Number of tasks that were started, plus those cancelled before they began."""
        self._reported: set[type[UnityLinkError]] = set()

    def listen(
        self, callback: Callable[[Batch], object] | None = None, *, buffer: int = 0, overflow: Overflow = "fail"
    ) -> Listener:
        """Add a listener; the first one starts the subscription.

        Args:
            callback: called with each batch.
            buffer: most samples that wait for `Listener.next`; 0 if only the proxies need the values.
            overflow: what to do with more samples.
        """
        listener = Listener(self, callback, buffer, overflow)
        if self._task is None:
            self._start()
        self._listeners[listener] = None
        return listener

    def leave(self, listener: Listener) -> None:
        """Remove a listener; the last one ends the subscription."""
        self._listeners.pop(listener, None)
        if not self._listeners and self._task is not None:
            self._is_abandoned = True
            self._task.cancel()
            if not self._began:
                # Asyncio never runs a task that is cancelled before it begins; other event loops run it up to its first
                # wait. `_starts` makes such a task return at once.
                self._task = None
                self._starts += 1

    def _start(self) -> None:
        self._began = self._is_abandoned = False
        self._reported.clear()
        self._starts += 1
        self._task = running().create_task(self._run(self._starts))

    def _stopped(self) -> None:
        self._task = None
        # A listener that was added while the subscription was ending needs another subscription.
        if self._is_abandoned and self._listeners:
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
                    # The gateway is behind a server and away, or was reset during the subscription.
                    what = f"the samples of {self.name}, which callbacks wait for, do not come yet (told once)"
                    self._refuse(what, error)
                await running().sleep(LOOK_EVERY)
        except StopAsyncIteration:
            self._end(LinkLostError(f"the samples of {self.name} have ended", Outcome.NO_REQUEST))
        except Exception as error:  # noqa: BLE001  (no listener may wait for samples forever)
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
        """Pass on an error after which samples may come again: it ends loops, and is logged once for callbacks."""
        if _fail(self._listeners, error) and type(error) not in self._reported:
            self._reported.add(type(error))
            report(what, error)

    def _end(self, error: Exception) -> None:
        listeners, self._listeners = self._listeners, {}
        if _fail(listeners, error) and not isinstance(error, LinkClosedError):
            report(f"the samples of {self.name}, which callbacks wait for, have ended", error)


def _fail(listeners: Collection[Listener], error: Exception) -> bool:
    """Pass an error to listeners, and return whether one of them has no caller that receives it."""
    for listener in listeners:
        listener.fail(error)
    return any(listener.hides_errors() for listener in listeners)
