"""Samples carried from the event loop to a thread that writes or sends them, so that neither waits for the other."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING, Any

from unity_link.bridges.log_once import Faults
from unity_link.bridges.presence import rate_whatever_happens
from unity_link.bridges.waiting import begin_when_there
from unity_link.errors import GatewayError, LinkLostError, first_error

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence
    from concurrent.futures import Executor

    from unity_link.data import Batch, Group, GroupSubscription


class Carrier:
    """Carries the samples of groups, all that have come together at a time.

    Args:
        groups: what is sampled.
        hand_over: takes the number of a group and samples of it; called in the thread, it may block.
        report: is told in a sentence, once for each kind of fault, of polled reads that the gateway refused, as a
            shared one refuses all while it is away; they are lost samples.
        buffer: most samples of each group that wait meanwhile; then the oldest are lost, and counted.
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
        """Samples that were handed over."""
        self.begun = asyncio.Event()
        """Set when all groups are sampled."""
        self._groups = groups
        self._hand_over = hand_over
        self._buffer = buffer
        self._faults = Faults(report)
        self._subscriptions: list[GroupSubscription] = []

    @property
    def lost(self) -> int:
        """Samples that the gateway took and that were not handed over."""
        return sum(subscription.lost for subscription in self._subscriptions)

    @property
    def received(self) -> int:
        """Samples that have come."""
        return sum(subscription.received for subscription in self._subscriptions)

    @property
    def rate_hz(self) -> float | None:
        """Samples a second of the quickest group that gives some whatever happens; None where none does."""
        several = zip(self._groups, self._subscriptions, strict=False)
        rates = [rate_whatever_happens(group, samples.rate_hz) for group, samples in several]
        return max((rate for rate in rates if rate is not None), default=None)

    async def run(self, thread: Executor, *beside: Coroutine[Any, Any, None]) -> None:
        """Carry until it is cancelled or something fails; where it is cancelled, all that has come by then is carried.

        Args:
            thread: where samples are handed over; of one thread, so that they keep their order.
            beside: what runs, and ends, at the same time.

        Raises:
            LinkLostError: where the link ends.
            Exception: whatever `hand_over` or one beside raised first.
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
            # What was taken is handed over, also where the waiting task was cancelled.
            await asyncio.shield(loop.run_in_executor(thread, self._give, number, batch))

    async def _drain(self, number: int, subscription: GroupSubscription, thread: Executor) -> None:
        """Carry what waits in a subscription that has ended, behind what the thread was given before."""
        loop = asyncio.get_running_loop()
        with contextlib.suppress(StopAsyncIteration, LinkLostError):
            while True:
                batch = await subscription.take()
                await loop.run_in_executor(thread, self._give, number, batch)
        await loop.run_in_executor(thread, lambda: None)

    def _give(self, number: int, batch: Batch) -> None:
        self._hand_over(number, batch)
        self.carried += len(batch)
