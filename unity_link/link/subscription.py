"""Layer 2: subscriptions to addresses that the gateway samples by itself.

A `Subscription` holds one group of the gateway while its ``async with`` block is open. Samples wait in a buffer of a
fixed size. If the reader is too slow, the oldest samples are dropped and counted, or the subscription ends with an
error.
"""

from __future__ import annotations

import warnings
from numbers import Integral
from typing import TYPE_CHECKING, Any, Self

from unity_link.errors import (
    ArgumentError,
    LinkClosedError,
    OfLink,
    UnityLinkError,
    missing_attribute,
    refusing,
    shown,
)
from unity_link.link.calls import is_asynchronous
from unity_link.link.interrupts import whole_exit
from unity_link.link.living import LeftOpen
from unity_link.link.publishing import NOT_OPEN, LatestSampleReceiver, SampleReceiver
from unity_link.protocol.wire.messages import SAMPLE_HEAD, TIMESTAMP_DIGITS, GroupFlag
from unity_link.protocol.wire.numbers import real_number, whole_number

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence
    from types import TracebackType

    from numpy.typing import NDArray

    from unity_link.link.publishing import Overflow, Publishing, Sample, Schedule

INSTEAD = {"next": "`await anext(samples)` waits for one sample, and `take` for all that are there"}
"""Advice for attribute names that users of other libraries may try on a subscription."""
LARGEST_DIVISOR = 0xFFFF


class Subscription(OfLink):
    """A stream of samples, made by `Link.subscribe`.

    ::

        async with link.subscribe([0x88, 0x89], rate_hz=100) as samples:
            async for sample in samples:
                print(sample.time, sample.values)

    When the link ends, iteration raises `LinkLostError` after the samples that arrived before.
    """

    def __init__(
        self,
        publishing: Publishing,
        schedule: Schedule,
        *,
        buffer: int,
        overflow: Overflow,
        callback: Callable[[Sample], object] | None,
        latest: bool = False,
    ) -> None:
        size = check_buffer(1 if latest else buffer, overflow)
        if callback is not None and not callable(callback):
            raise ArgumentError(f"a callback is a function, not {callback!r:.80}")
        if is_asynchronous(callback):
            raise ArgumentError("a callback is a plain function, which may start a task: an async one is never awaited")
        self.schedule = schedule
        """Settings of the group in the gateway."""
        self._publishing = publishing
        self._latest = latest and overflow == "drop_oldest"
        kind = LatestSampleReceiver if self._latest else SampleReceiver
        self._receiver = kind(publishing, schedule, size, overflow, callback)
        self._entered = False
        self._group = None
        # Warn of a subscription that was never entered only if it has a callback: iteration raises an error anyway.
        self._left_open = None if callback is None else LeftOpen(_warn_of_callback)

    _group: Any = None

    def _warn_of_left_open(self) -> None:
        # Do not warn if the subscription has ended because the link was lost.
        if self._group is not None and isinstance(self._receiver.error, LinkClosedError | None):
            warnings.warn(f"{self!r} was not closed: use `async with`", ResourceWarning, stacklevel=1, source=self)

    def _end_left_open(self) -> None:
        if self._left_open is not None:
            self._left_open.end()
            self._left_open = None

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __await__ = refusing(NOT_OPEN)
        __enter__ = __exit__ = refusing("write `async with` before this subscription: its link is not a blocking one")
        __iter__ = refusing("write `async for` over the samples: their link is not a blocking one")
        __getattr__ = missing_attribute("a subscription", **INSTEAD)

    def _called(self) -> str:
        return "a subscription"

    def __repr__(self) -> str:
        """Return the number of addresses, the state, and the numbers of received and lost samples."""
        count = len(self.schedule.addresses)
        over = self._receiver.ended or self._receiver.error is not None
        state = "over" if over else "open" if self._group is not None else "not open"
        return f"<subscription of {count} addresses, {state}: {self.received} samples, {self.lost} lost>"

    @property
    def rate_hz(self) -> float | None:
        """Rate of the samples in Hz; None for a subscription that is not periodic."""
        return self._receiver.rate_hz

    @property
    def received(self) -> int:
        """Number of samples that arrived so far."""
        return self._receiver.received

    @property
    def lost(self) -> int:
        """Number of samples lost so far: in the gateway, on the line, or in the buffer."""
        return self._receiver.lost

    async def publish(self) -> None:
        """Request one sample now, in addition to scheduled ones."""
        if self._group is None:
            raise ArgumentError(NOT_OPEN)
        await self._publishing.publish(self._group)

    async def __aenter__(self) -> Self:
        if self._entered:
            raise ArgumentError("this subscription has been entered before: make another one by `subscribe`")
        self._entered = True
        self._end_left_open()
        receiver = self._receiver
        timestamped = GroupFlag.TIMESTAMP in self.schedule.flags
        receiver.words_at = SAMPLE_HEAD + (TIMESTAMP_DIGITS if timestamped else 0)
        receiver.length = receiver.words_at + self._publishing.info.data_digits * len(self.schedule.addresses)
        try:
            self._group = await self._publishing.hold(receiver)
        except BaseException:
            self._entered = False
            raise
        receiver.holder = self
        self._left_open = LeftOpen(self._warn_of_left_open)
        self._publishing.runtime.start_polling()
        return self

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._receiver.ended = True
        self._receiver.wake()
        self._end_left_open()
        if self._group is not None:
            group, self._group = self._group, None
            self._receiver.holder = None
            self._publishing.runtime.stop_polling()
            await self._publishing.release(group)

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Sample:
        receiver = self._receiver
        if self._latest or not receiver.buffer:
            await receiver.wait()
        return receiver.next()

    async def take(self, count: int | None = None) -> list[Sample]:
        """Wait for a sample, and return all buffered samples, for readers that process many at once.

        Args:
            count: wait for this number of samples, and return no more; fewer only if the samples end. None: wait for
                one, and return all.

        Raises:
            StopAsyncIteration: if the ``async with`` block has ended.
        """
        receiver = self._receiver
        if count is not None:
            return await so_many(self.__anext__, count, receiver.give_back)
        await receiver.wait()
        return [receiver.next() for _ in range(len(receiver.buffer))]

    def give_back(self, samples: Sequence[Sample]) -> None:
        """Put the samples that were returned last back into the buffer; if it overflows, the oldest are lost."""
        self._receiver.give_back(samples)


def _warn_of_callback() -> None:
    warnings.warn(f"no callback was called: {NOT_OPEN}", RuntimeWarning, stacklevel=1)


async def so_many(
    following: Callable[[], Coroutine[Any, Any, Sample]], count: int, give_back: Callable[[Sequence[Sample]], None]
) -> list[Sample]:
    """Return `count` samples; fewer if an error ends them, which the next call raises.

    Args:
        following: waits for the next sample, and returns it.
        count: number of samples.
        give_back: called with the collected samples if this call is cancelled, so that the next call returns them.

    Raises:
        ArgumentError: if `count` is no whole number from 1 on.
    """
    count = check_count(count)
    taken: list[Sample] = []
    try:
        while len(taken) < count:
            taken.append(await following())
    except (StopAsyncIteration, UnityLinkError):
        if not taken:
            raise
    except BaseException:
        give_back(taken)
        raise
    return taken


def check_count(count: int) -> int:
    """Return a number of samples of any integer type as an `int`.

    Raises:
        ArgumentError: if it is no whole number from 1 on.
    """
    given: object = count
    if isinstance(given, bool) or not isinstance(given, Integral) or count < 1:
        raise ArgumentError(f"a number of samples from 1 on was expected, not {shown(count)}")
    return whole_number(count, "a number of samples")


def check_buffer(buffer: int, overflow: Overflow) -> int:
    """Return the size of a buffer, of any integer type, as an `int`.

    Raises:
        ArgumentError: if it is no whole number from 1 on, or `overflow` is unknown.
    """
    given: object = buffer
    if isinstance(given, bool) or not isinstance(given, Integral):
        raise ArgumentError(f"a buffer is a number of samples, not {shown(buffer)}")
    size = whole_number(buffer, "a buffer")
    if size < 1:
        raise ArgumentError(f"a buffer of {size} samples was asked for, at least 1 is needed")
    if overflow not in ("drop_oldest", "fail"):
        raise ArgumentError(f'overflow is "drop_oldest" or "fail", not {overflow!r}')
    return size


def asked_rate(rate_hz: float | None, divisor: int | None, base_hz: float) -> float:
    """Return the requested samples per second: `rate_hz`, or `base_hz` divided by `divisor`, or `base_hz` without both.

    Raises:
        ArgumentError: if both are given, one is no number, or the divisor is not from 1 to `LARGEST_DIVISOR`.
    """
    if rate_hz is not None:
        if divisor is not None:
            raise ArgumentError("a rate and a divisor were given, expected one of them")
        return real_number(rate_hz, "a rate is a number of Hz")
    if divisor is None:
        return base_hz
    whole = whole_number(divisor, "a divisor")
    if not 1 <= whole <= LARGEST_DIVISOR:
        raise ArgumentError(f"a divisor of {whole} was asked for, expected 1 to {LARGEST_DIVISOR}")
    return base_hz / whole


def check_addresses(addresses: NDArray[Any], most: int) -> tuple[int, ...]:
    """Return the addresses of a group as a tuple.

    Raises:
        ArgumentError: if there are none, or more than `most`, the limit of the gateway.
    """
    if not 1 <= len(addresses) <= most:
        raise ArgumentError(f"a subscription of {len(addresses)} addresses was asked for, expected 1 to {most}")
    return tuple(int(address) for address in addresses)
