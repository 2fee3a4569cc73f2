"""Transfer of samples from the event loop to a thread that writes or sends them, so that neither blocks the other."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING, Any

from unity_link.bridges.log_once import Faults
from unity_link.bridges.presence import periodic_rate
from unity_link.bridges.waiting import begin_when_there
from unity_link.errors import GatewayError, LinkLostError, first_error

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence
    from concurrent.futures import Executor

    from unity_link.data import Batch, Group, GroupSubscription


class Carrier:
    """Transfers the samples of groups to a thread, as batches of all that have arrived.

    Args:
        groups: groups to sample.
        hand_over: called in the thread with the number of a group and a batch of its samples; it may block.
        report: called with a sentence, once for each kind of fault, if the gateway refuses a polled read (a server
            refuses all while its gateway is away). Such reads count as lost samples.
        buffer: most samples of each group that may wait; if there are more, the oldest are dropped and counted.
    """

    def __init__(
        self,
        groups: Sequence[Group],
        hand_over: Callable[[int, Batch], None],
        report: Callable[[str], None],
        *,
        buffer: int,
    ) -> None:
        self.carried = 0
        """Number of samples handed over."""
        self.begun = asyncio.Event()
        """Set when all groups are being sampled."""
        self._groups = groups
        self._hand_over = hand_over
        self._buffer = buffer
        self._faults = Faults(report)
        self._subscriptions: list[GroupSubscription] = []

    @property
    def lost(self) -> int:
        """Number of samples that the gateway took and that were not handed over."""
        return sum(subscription.lost for subscription in self._subscriptions)

    @property
    def received(self) -> int:
        """Number of samples received."""
        return sum(subscription.received for subscription in self._subscriptions)

    @property
    def rate_hz(self) -> float | None:
        """Samples per second of the fastest periodic group; None if no group is periodic."""
        several = zip(self._groups, self._subscriptions, strict=False)
        rates = [periodic_rate(group, samples.rate_hz) for group, samples in several]
        return max((rate for rate in rates if rate is not None), default=None)

    async def run(self, thread: Executor, *beside: Coroutine[Any, Any, None]) -> None:
        """Transfer samples until this is cancelled or fails. After a cancellation, transfer those that have arrived.

        Args:
            thread: executor with one thread, so that samples keep their order.
            beside: coroutines to run at the same time, and to cancel at the end.

        Raises:
            LinkLostError: if the link ends.
            Exception: the first error of `hand_over` or of a coroutine.
        """
        self._subscriptions = []
        try:
            with first_error():
                async with AsyncExitStack() as stack, asyncio.TaskGroup() as tasks:
                    for coroutine in beside:
                        tasks.create_task(coroutine)
                    for group in self._groups:
                        subscribe = functools.partial(group.subscribe, buffer=self._buffer)
                        self._subscriptions.append(await begin_when_there(subscribe, stack, self._faults.tell))
                    self.begun.set()
                    for number, subscription in enumerate(self._subscriptions):
                        tasks.create_task(self._carry(number, subscription, thread))
        except asyncio.CancelledError:
            for number, subscription in enumerate(self._subscriptions):
                await self._drain(number, subscription, thread)
            raise

    async def _carry(self, number: int, subscription: GroupSubscription, thread: Executor) -> None:
        loop = asyncio.get_running_loop()
        while True:
            try:
                batch = await subscription.take()
            except GatewayError as error:
                self._faults.tell(str(error))
                continue
            # A batch that was taken is handed over, even if this task is cancelled while it waits.
            await asyncio.shield(loop.run_in_executor(thread, self._give, number, batch))

    async def _drain(self, number: int, subscription: GroupSubscription, thread: Executor) -> None:
        """Transfer the samples that wait in an ended subscription, after those that the thread already has."""
        loop = asyncio.get_running_loop()
        with contextlib.suppress(StopAsyncIteration, LinkLostError):
            while True:
                batch = await subscription.take()
                await loop.run_in_executor(thread, self._give, number, batch)
        await loop.run_in_executor(thread, lambda: None)

    def _give(self, number: int, batch: Batch) -> None:
        self._hand_over(number, batch)
        self.carried += len(batch)
