"""Sources of the samples of a group: subscriptions to the gateway, or reads that the host repeats.

`take` of both returns lists of `Sample`. A group of several gateways has one source for each.
"""

from __future__ import annotations

import asyncio
import time
from collections import deque
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING, Protocol, Self

import numpy as np

from unity_link.data.batch import Batch
from unity_link.errors import (
    ArgumentError,
    GatewayError,
    GatewayResetError,
    SamplesLostError,
    Sealed,
    UnsupportedError,
    missing_attribute,
    refusing,
)
from unity_link.link.interrupts import whole_exit
from unity_link.link.publishing import NOT_OPEN, Sample
from unity_link.link.runtimes.runtime import AsyncioRuntime
from unity_link.link.runtimes.synchronisation import Event, gather, running
from unity_link.link.subscription import INSTEAD, so_many
from unity_link.protocol.wire.numbers import RATE

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import TracebackType

    from unity_link.data.batch import GroupSample
    from unity_link.data.layout import GroupLayout
    from unity_link.link.publishing import Overflow
    from unity_link.protocol.wire.arrays import Words


class SampleSource(Protocol):
    """A stream of samples of one gateway, such as `unity_link.Subscription`."""

    @property
    def lost(self) -> int:
        """Number of samples lost so far."""

    @property
    def received(self) -> int:
        """Number of samples that have arrived so far."""

    @property
    def rate_hz(self) -> float | None:
        """Samples per second; None if they are not periodic."""

    async def take(self, count: int | None = None) -> list[Sample]:
        """Wait for a sample, and return all that have arrived; or wait for `count` samples, and return these."""

    def give_back(self, samples: Sequence[Sample]) -> None:
        """Put the samples taken last back, in front; `take` returns them again."""

    async def publish(self) -> None:
        """Request one sample now."""

    async def __aenter__(self) -> Self: ...

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...


class Poll:
    """Reads that the host repeats at a rate, one for each requested sample. Missed turns count as lost samples."""

    def __init__(self, layout: GroupLayout, rate_hz: float, *, on_change: bool, overflow: Overflow) -> None:
        low, high = RATE
        if not low <= rate_hz <= high:
            raise ArgumentError(f"a rate of {rate_hz:g} Hz was asked for, expected {low:g} to {high:g} Hz")
        self.lost = 0
        self.received = 0
        self._layout = layout
        self._rate_hz = rate_hz
        self._on_change = on_change
        self._overflow = overflow
        self._turn = 0
        self._sequence = 0
        self._began: float | None = None
        self._asked = Event()
        self._last: Words | None = None
        self._waiting: deque[Sample] = deque()
        """Samples that were given back."""
        self._lost = 0
        self._cut_off = 0
        """Number of cancelled reads. They count as lost only if another read follows."""
        self._ended = False

    @property
    def rate_hz(self) -> float | None:
        """Samples per second."""
        return self._rate_hz

    async def take(self, count: int | None = None) -> list[Sample]:
        """Wait for the next turn, or for `count` turns, and read in each.

        Raises:
            StopAsyncIteration: if the ``async with`` block has ended. Turns after the end do not count as missed.
            SamplesLostError: if turns were missed and the overflow is ``"fail"``.
            GatewayError: if the gateway refused the read. The sample is lost; later reads may succeed.
        """
        return [await self._next()] if count is None else await so_many(self._next, count, self.give_back)

    def give_back(self, samples: Sequence[Sample]) -> None:
        """Put samples back; `take` returns them again."""
        self._waiting.extendleft(reversed(samples))

    async def _next(self) -> Sample:
        if self._waiting:
            return self._waiting.popleft()
        while not self._ended:
            self._miss(self._cut_off)
            self._cut_off = 0
            self._turn += await self._wait_for_turn()
            try:
                words = await self._layout.read()
            except GatewayResetError:
                # The link and its other subscriptions continue after a reset, so this one does, too.
                self._miss(1)
                continue
            except GatewayError:
                self._miss(1)
                raise
            except BaseException:
                self._cut_off += 1
                raise
            if not self._on_change or self._last is None or not np.array_equal(words, self._last):
                return self._sample(words)
        raise StopAsyncIteration

    async def publish(self) -> None:
        """Make the pending `take` read now, in addition to the turns."""
        self._asked.set()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._ended = True

    async def _wait_for_turn(self) -> int:
        """Wait for the next turn, and return the turns passed; return 0 at once if `publish` is called before it."""
        now = running().time()
        if self._began is None:
            self._began = now
        late = (now - self._began) * self._rate_hz - self._turn
        if late < 0:
            try:
                async with running().timeout(-late / self._rate_hz):
                    await self._asked.wait()
            except TimeoutError:
                return 1
            self._asked.clear()
            return 0
        missed = int(late)
        self._miss(missed)
        if missed and self._overflow == "fail":
            raise SamplesLostError(f"the reader is too slow: {missed} turns of {self._rate_hz:g} Hz were missed")
        return missed + 1

    def _miss(self, turns: int) -> None:
        self._lost += turns
        self.lost += turns

    def _sample(self, words: Words) -> Sample:
        self._last = words
        self._sequence += self._lost
        sample = Sample(self._sequence, None, time.time(), words, self._lost, self._layout.link.epoch)
        self._sequence += 1
        self._lost = 0
        self.received += 1
        return sample


class GroupSubscription(Sealed):
    """A stream of samples of a group; made by `Group.subscribe`, to be used in an ``async with`` block.

    Iteration yields each `GroupSample`. For a group of several gateways, a sample has the values of one gateway.
    Iteration ends with `LinkLostError` if a link ends, after the samples that arrived before.
    """

    def __init__(self, sources: Sequence[tuple[GroupLayout, SampleSource]]) -> None:
        self._sources = sources
        self._stack = AsyncExitStack()
        self._entered = self._is_over = False
        self._waiting: dict[asyncio.Task[Batch], int] = {}
        self._read = [(layout, source, [-1]) for layout, source in sources]
        """The sources, each with the number of the last sample that the signals have seen."""
        self._laps = [layout.laps() for layout, _ in sources]
        self._batch: Batch | None = None
        """Batch that the iteration has taken last."""
        self._rest: list[GroupSample] = []
        """Samples of that batch that the iteration has not yielded yet, last one first."""

    @property
    def rate_hz(self) -> float | None:
        """Samples per second of the first gateway; None if they are not periodic."""
        return self._sources[0][1].rate_hz

    @property
    def lost(self) -> int:
        """Number of samples lost so far."""
        return sum(source.lost for _, source in self._sources)

    @property
    def received(self) -> int:
        """Number of samples that have arrived so far."""
        return sum(source.received for _, source in self._sources)

    async def publish(self) -> None:
        """Request one sample from each gateway now, in addition to the periodic ones."""
        await gather(*(source.publish() for _, source in self._sources))

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __await__ = refusing(NOT_OPEN)
        __enter__ = __exit__ = refusing("write `async with` before this subscription: its link is not a blocking one")
        __iter__ = refusing("write `async for` over the samples: their link is not a blocking one")

        __getattr__ = missing_attribute("a subscription of a group", **INSTEAD)

    def _called(self) -> str:
        return "a subscription of a group"

    def __repr__(self) -> str:
        """Return the state, and the numbers of samples received and lost."""
        state = "over" if self._is_over else "open" if self._entered else "not open"
        return f"<subscription of a group, {state}: {self.received} samples, {self.lost} lost>"

    async def take(self, count: int | None = None) -> Batch:
        """Wait for at least one sample, and return all that have arrived as one batch.

        Args:
            count: wait for this number of samples, and return no more, fewer only at their end; for one gateway only.

        Raises:
            ArgumentError: if the ``async with`` block has not begun.
            StopAsyncIteration: if it has ended.
        """
        if not self._entered:
            raise ArgumentError(NOT_OPEN)
        self._give_back_rest()
        if len(self._sources) == 1:
            return await self._take(0, count)
        if count is not None:
            raise ArgumentError("samples of several gateways cannot be counted together: take without a count")
        for number in set(range(len(self._sources))) - set(self._waiting.values()):
            task = asyncio.create_task(self._take(number))
            # Retrieve the exception, if any: possibly no later call of `take` gets the result of the task.
            task.add_done_callback(lambda done: done.cancelled() or done.exception())
            self._waiting[task] = number
        done, _ = await asyncio.wait(self._waiting, return_when=asyncio.FIRST_COMPLETED)
        # Take the oldest of the finished tasks first, so that a busy gateway does not starve the others.
        first = next(task for task in self._waiting if task in done)
        del self._waiting[first]
        return first.result()

    def _give_back_rest(self) -> None:
        """Put back the samples that the iteration has not yielded, so that the next batch begins with them."""
        if self._rest and self._batch is not None:
            samples = self._batch.samples[-len(self._rest) :]
            self._rest = []
            next(source for layout, source in self._sources if layout is self._batch.layout).give_back(samples)

    async def _take(self, number: int, count: int | None = None) -> Batch:
        layout, source, seen = self._read[number]
        asked = time.monotonic()
        samples = await source.take(count)
        laps = self._laps[number]
        batch = Batch(layout, samples)
        batch = fresh = batch if laps is None else batch.with_rounds(laps)
        if samples[0].sequence <= seen[0]:
            # These samples were given back: report no change twice.
            again = sum(sample.sequence <= seen[0] for sample in samples)
            if again == len(samples):
                return batch
            fresh = batch.behind(again)
        fresh.see(asked)
        seen[0] = samples[-1].sequence
        return batch

    async def __aenter__(self) -> Self:
        if len(self._sources) > 1 and not isinstance(running(), AsyncioRuntime):
            raise UnsupportedError("samples of several gateways need asyncio")
        async with AsyncExitStack() as stack:
            for _, source in self._sources:
                await stack.enter_async_context(source)
            self._stack = stack.pop_all()
        self._entered = True
        return self

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._is_over = True
        waiting, self._waiting = self._waiting, {}
        for task in waiting:
            task.cancel()
        if waiting:
            await asyncio.gather(*waiting, return_exceptions=True)
        await self._stack.aclose()

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> GroupSample:
        if not self._rest:
            self._batch = await self.take()
            self._rest = list(self._batch)[::-1]
        return self._rest.pop()
