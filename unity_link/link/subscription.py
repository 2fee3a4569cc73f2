"""Layer 2, publish streams: groups of addresses that the gateway samples by itself.

A `Subscription` holds one group of the gateway as long as its ``async with`` block runs. Samples wait in a buffer of a
stated size; a reader that is too slow loses the oldest, and is told how many, or fails, as it chose.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections import deque
from typing import TYPE_CHECKING, Any, Literal, Self

import msgspec
import numpy as np

from unity_link.errors import (
    ArgumentError,
    BusTimeoutError,
    LinkLostError,
    OutOfRangeError,
    SamplesLostError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.link.exchange import PublishRows
from unity_link.link.requests import OfSession, Request, Unawaited
from unity_link.protocol.messages import Codec, GroupFlag, Words, parse_rows, parse_words

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

    from numpy.typing import NDArray

    from unity_link.link.exchange import Exchange

Overflow = Literal["drop_oldest", "fail"]
NOT_OPEN = "the subscription is not open: write `async with ...subscribe(...) as samples:`, or `with` in blocking code"
_HEAD = 5
"""Characters before the fields of a publish: the letter, the group and the sequence."""
_TIMESTAMP_DIGITS = 8
RESET_TOLERANCE = 1
"""Seconds by which the clock of a gateway that was not reset may be off this machine's after an interruption."""


class Sample(msgspec.Struct, frozen=True, gc=False):
    """The words of one group at one instant."""

    sequence: int
    """Number of the sample since the subscription began, lost ones counted."""
    time: float | None
    """Instant of sampling in seconds of the gateway's clock, unwrapped; None without timestamps."""
    arrived: float
    """Instant of arrival in seconds of this machine's clock (`time.time`)."""
    values: Words
    """The words, in the order of the addresses; shape (addresses,)."""
    lost: int
    """How many samples were lost between the one that was read before and this one."""
    epoch: int = 0
    """Number of the link's session that it came in: 0, and one more after each reconnection."""


class GatewayClock:
    """Makes an endless time of the 32 bits of a timestamp.

    Of all the instants that a timestamp may mean, it takes the one nearest to what this machine's clock says has passed
    since the last: right as long as samples are less than half a turn of the counter late (43 s at 50 MHz).

    The gateway may have been reset between two sessions, and its counter with it. Where the first timestamp of a
    session is not close to what this machine's clock expects, the time goes on from there, so it never goes back.
    """

    def __init__(self, frequency_hz: int) -> None:
        self._frequency = frequency_hz
        self._ticks: int | None = None
        self._at = 0.0
        self._offset = 0
        """What is added to timestamps since a reset of the gateway, in ticks."""
        self._resumed = False

    def resume(self) -> None:
        """Begin with a new session."""
        self._resumed = self._ticks is not None

    def seconds(self, timestamp: int, now: float) -> float:
        """Return the time of a timestamp that arrived at `now`, in seconds."""
        if self._ticks is None:
            ticks = timestamp
        else:
            estimate = self._ticks + int((now - self._at) * self._frequency)
            ticks = self._nearest(timestamp, estimate)
            tolerance = RESET_TOLERANCE * self._frequency
            if self._resumed and not (self._ticks < ticks and abs(ticks - estimate) < tolerance):
                self._offset += max(estimate, self._ticks + 1) - ticks
                ticks = max(estimate, self._ticks + 1)
        self._resumed = False
        self._ticks, self._at = ticks, now
        return ticks / self._frequency

    def _nearest(self, timestamp: int, estimate: int) -> int:
        return estimate + ((timestamp + self._offset - estimate + 0x8000_0000) & 0xFFFF_FFFF) - 0x8000_0000

    def seconds_of(self, timestamps: NDArray[np.unsignedinteger], now: float) -> NDArray[np.float64]:
        """Return the times of timestamps that arrived together, in order."""
        self.seconds(int(timestamps[0]), now)
        assert self._ticks is not None
        wide = timestamps.astype(np.int64)
        steps = (wide[1:] - wide[:-1] + 0x8000_0000 & 0xFFFF_FFFF) - 0x8000_0000
        ticks = self._ticks + np.concatenate([[0], np.cumsum(steps)])
        self._ticks = int(ticks[-1])
        return ticks / self._frequency


class Schedule(msgspec.Struct, frozen=True):
    """When and what a group publishes."""

    addresses: tuple[int, ...]
    divisor: int
    flags: GroupFlag


class HeldGroups:
    """The groups of one gateway, and the subscription that holds each.

    A group that was given back longest ago is taken first, so that samples still under way find no new holder.
    """

    def __init__(self, exchange: Exchange) -> None:
        self._exchange = exchange
        self._held: dict[int, Subscription] = {}
        self._stopping: set[Request] = set()
        self._free: deque[int] | None = None
        self._awaited: dict[int, asyncio.Future[None]] = {}
        """Groups that the next session sets up, with what waits for that."""
        self.epoch = -1
        """Number of the session."""
        self.samples = 0
        self.samples_lost = 0

    def start(self, codec: Codec) -> None:
        """Begin with a new session: all groups are stopped."""
        self.codec = codec
        self.epoch += 1
        if self._free is None:
            self._free = deque(range(codec.info.groups))
            self.clock = GatewayClock(codec.info.clock_hz)
        self.clock.resume()

    async def restore(self) -> None:
        """Set up all subscriptions again in a new session."""
        for group, subscription in list(self._held.items()):
            await self._set_up(group, subscription)
            awaited = self._awaited.pop(group, None) if self._held.get(group) is subscription else None
            if awaited is not None and not awaited.done():
                awaited.set_result(None)

    def interrupted(self, error: LinkLostError) -> None:
        """Record that the session has ended, and with it every request to stop a group."""
        for request in list(self._stopping):
            request.given_up = True
            request.fail(error)

    def end(self, error: LinkLostError) -> None:
        """End all subscriptions."""
        for subscription in list(self._held.values()):
            subscription.fail(error)
        for awaited in self._awaited.values():
            if not awaited.done():
                awaited.set_exception(error)

    async def hold(self, subscription: Subscription) -> int:
        """Take a free group and start it for a subscription; while the connection is being opened again, wait for it.

        Raises:
            UnsupportedError: where no group is free.
            LinkLostError: where the link ends.
        """
        if self._free is None or not self._free:
            raise UnsupportedError(
                f"all {self.codec.info.groups} groups of the gateway are in use: end a subscription first, "
                "or put its addresses into one"
            )
        group = self._free.popleft()
        self._held[group] = subscription
        try:
            await self._set_up_in_any_session(group, subscription)
        except BaseException:
            self._forget(group)
            self._free.append(group)
            # Whatever of it was sent may still be executed.
            with contextlib.suppress(LinkLostError):
                self._exchange.submit(self._request(Unawaited, "GX", group))
            raise
        return group

    async def release(self, group: int) -> None:
        """Stop a group and give it back."""
        assert self._free is not None
        self._forget(group)
        try:
            # A gateway that is gone has stopped it, also one behind a server, and one that was reset knows it no more.
            with contextlib.suppress(LinkLostError, BusTimeoutError, OutOfRangeError):
                if not self._exchange.suspended:
                    await self._stop(group)
        finally:
            self._free.append(group)

    async def _stop(self, group: int) -> None:
        request = self._request(Request, "GX", group)
        self._stopping.add(request)
        request.future.add_done_callback(lambda _: self._stopping.discard(request))
        self._exchange.submit(request)
        await asyncio.shield(request.future)

    async def publish(self, group: int) -> None:
        """Have a group published once, now."""
        await self._submit("GP", group)

    async def _set_up_in_any_session(self, group: int, subscription: Subscription) -> None:
        while True:
            if self._exchange.suspended and not self._exchange.ended:
                # A new session sets up every group that is held, and this one must not be set up twice.
                self._awaited[group] = asyncio.get_running_loop().create_future()
                await self._awaited[group]
                return
            try:
                await self._set_up(group, subscription)
            except LinkLostError:
                # A new session stops all groups, so whatever was executed before is undone: it can be asked again.
                if self._exchange.ended:
                    raise
            else:
                return

    async def _set_up(self, group: int, subscription: Subscription) -> None:
        if self._held.get(group) is not subscription:
            # It has ended while those before it were set up, and the group may be another's.
            return
        schedule = subscription.schedule
        addresses = np.array(schedule.addresses, np.uint64)
        await self._submit(
            "GS", group, int(schedule.flags), schedule.divisor, len(addresses), addresses, kind=OfSession
        )
        if self._held.get(group) is subscription:
            subscription.restart()
            self._exchange.publishes[b"%02X" % group] = subscription.receive
            self._exchange.publish_rows[b"P%02X" % group] = PublishRows(subscription.length, subscription.receive_rows)
            await self._submit("GN", group, kind=OfSession)

    def _submit(self, command: str, *values: Any, kind: type[Request] = Request) -> asyncio.Future[None]:
        request = self._request(kind, command, *values)
        self._exchange.submit(request)
        return request.future

    def _request(self, kind: type[Request], command: str, *values: Any) -> Request:
        return kind(self.codec, command, self.codec.fields(command, *values), 0, asyncio.get_running_loop())

    def _forget(self, group: int) -> None:
        self._exchange.publishes.pop(b"%02X" % group, None)
        self._exchange.publish_rows.pop(b"P%02X" % group, None)
        self._held.pop(group, None)
        self._awaited.pop(group, None)


class Subscription:
    """A stream of samples; made by `Link.subscribe`.

    ::

        async with link.subscribe([0x88, 0x89], rate_hz=100) as samples:
            async for sample in samples:
                print(sample.time, sample.values)

    Iteration ends with `LinkLostError` when the link ends, after the samples that had come before it.
    """

    def __init__(
        self,
        groups: HeldGroups,
        schedule: Schedule,
        *,
        buffer: int,
        overflow: Overflow,
        callback: Callable[[Sample], object] | None,
    ) -> None:
        if not isinstance(buffer, int):
            raise ArgumentError(f"a buffer is a number of samples, not {buffer!r:.80}")
        if callback is not None and not callable(callback):
            raise ArgumentError(f"a callback is a function, not {callback!r:.80}")
        if buffer < 1:
            raise ArgumentError(f"a buffer of {buffer} samples was asked for, at least 1 is needed")
        if overflow not in ("drop_oldest", "fail"):
            raise ArgumentError(f'overflow is "drop_oldest" or "fail", not {overflow!r}')
        self.schedule = schedule
        self.lost = 0
        """Samples lost so far: on the way, in the gateway, or in the buffer."""
        self.received = 0
        """Samples that arrived so far."""
        self.length = 0
        """Characters of a publish."""
        self._groups = groups
        self._buffer: deque[Sample] = deque()
        self._buffer_size = buffer
        self._overflow = overflow
        self._callback = callback
        self._dropped = 0
        self._waiter: asyncio.Future[None] | None = None
        self._entered = False
        self._group: int | None = None
        self._error: UnityLinkError | None = None
        self._ended = False
        self._sequence = -1
        self._sampled_at: float | None = None
        self._due_hz: float | None = None
        """The rate, where time alone says how many samples are due."""

    @property
    def rate_hz(self) -> float | None:
        """The rate that the gateway publishes at, in Hz; None for a subscription that is not periodic."""
        if GroupFlag.PERIODIC not in self.schedule.flags:
            return None
        return self._groups.codec.info.base_frequency_hz / self.schedule.divisor

    async def publish(self) -> None:
        """Have one sample taken now, besides those that are due by themselves."""
        if self._group is None:
            raise ArgumentError(NOT_OPEN)
        await self._groups.publish(self._group)

    async def __aenter__(self) -> Self:
        if self._entered:
            raise ArgumentError("this subscription has been entered before: make another one by `subscribe`")
        self._entered = True
        codec = self._groups.codec
        timestamped = GroupFlag.TIMESTAMP in self.schedule.flags
        self._words_at = _HEAD + (_TIMESTAMP_DIGITS if timestamped else 0)
        self.length = self._words_at + codec.info.data_digits * len(self.schedule.addresses)
        try:
            self._group = await self._groups.hold(self)
        except BaseException:
            self._entered = False
            raise
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._ended = True
        self._wake()
        if self._group is not None:
            group, self._group = self._group, None
            await self._groups.release(group)

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Sample:
        await self._wait()
        return self._next()

    async def take(self) -> list[Sample]:
        """Wait until there is a sample, and return all that wait; for readers that work on many at once.

        Raises:
            StopAsyncIteration: when the ``async with`` block has ended.
        """
        await self._wait()
        return [self._next() for _ in range(len(self._buffer))]

    def _next(self) -> Sample:
        sample = self._buffer.popleft()
        if self._dropped:
            sample = msgspec.structs.replace(sample, lost=sample.lost + self._dropped)
            self._dropped = 0
        return sample

    async def _wait(self) -> None:
        while not self._buffer:
            if self._error is not None:
                raise self._error
            if self._ended:
                raise StopAsyncIteration
            if self._group is None:
                raise ArgumentError(NOT_OPEN)
            if self._waiter is not None:
                raise ArgumentError("another task is already waiting for this subscription's next sample")
            self._waiter = asyncio.get_running_loop().create_future()
            try:
                await self._waiter
            finally:
                self._waiter = None

    # Called by the groups and the exchange

    def restart(self) -> None:
        """Begin to count anew: the gateway's sequence stands at 0."""
        self._sequence = self._sequence | 0xFF
        self._sampled_at = None
        self._due_hz = self.rate_hz if self.schedule.flags & _COUNTED == GroupFlag.PERIODIC else None

    def fail(self, error: UnityLinkError) -> None:
        """End the stream with an error, behind the samples that wait."""
        if self._error is None:
            self._error = error
        self._wake()

    def receive(self, body: bytes, now: float) -> None:
        """Take a publish of the group."""
        if len(body) != self.length:
            return
        try:
            values = parse_words(body[self._words_at :], self._groups.codec.info.data_digits)
            sequence = int(body[3:_HEAD], 16)
            timestamp = int(body[_HEAD : self._words_at], 16) if self._words_at != _HEAD else None
        except ValueError:
            return
        instant = None if timestamp is None else self._groups.clock.seconds(timestamp, now)
        lost = self._count_lost(sequence, instant)
        self._keep(Sample(self._sequence, instant, time.time(), values, lost, self._groups.epoch))

    def receive_rows(self, bodies: NDArray[np.uint8], now: float) -> int:
        """Take publishes of the group that arrived together, as long as none is missing between them.

        Args:
            bodies: shape (n, length).
            now: when they arrived, on the loop's clock.

        Returns:
            How many of the first ones were taken.
        """
        digits, stamped = self._groups.codec.info.data_digits, self._words_at != _HEAD
        try:
            values = parse_rows(bodies[:, self._words_at :].reshape(-1, digits)).reshape(len(bodies), -1)
            sequences = parse_rows(bodies[:, 3:_HEAD])
            timestamps = parse_rows(bodies[:, _HEAD : self._words_at]) if stamped else None
        except ValueError:
            return 0
        count = self._side_by_side(sequences, timestamps)
        instants: list[float] | list[None] = [None] * count
        if timestamps is not None:
            instants = self._groups.clock.seconds_of(timestamps[:count], now).tolist()
        lost, first, arrived = self._count_lost(int(sequences[0]), instants[0]), self._sequence, time.time()
        epoch = self._groups.epoch
        self._sequence += count - 1
        self._sampled_at = instants[-1]
        samples = [
            Sample(first + offset, instant, arrived, words.copy(), 0 if offset else lost, epoch)
            for offset, (instant, words) in enumerate(zip(instants, values[:count], strict=True))
        ]
        self._keep_all(samples)
        return count

    def _side_by_side(
        self, sequences: NDArray[np.unsignedinteger], timestamps: NDArray[np.unsignedinteger] | None
    ) -> int:
        """Return how many of the first samples follow each other with none missing."""
        steady = np.diff(sequences) == 1
        if timestamps is not None and self._due_hz is not None:
            # Two digits may also have gone round.
            due = np.diff(timestamps) * (self._due_hz / self._groups.codec.info.clock_hz)
            steady &= due < 0x80
        return len(sequences) if steady.all() else int(steady.argmin()) + 1

    def _keep_all(self, samples: list[Sample]) -> None:
        room = self._buffer_size - len(self._buffer)
        if self._callback is None and self._error is None and len(samples) <= room:
            self._keep(samples[0])
            self.received += len(samples) - 1
            self._groups.samples += len(samples) - 1
            self._buffer.extend(samples[1:])
            return
        for sample in samples:
            self._keep(sample)

    def _count_lost(self, sequence: int, at: float | None) -> int:
        """Return how many samples are missing before this one; a timestamp tells how often two digits went round."""
        advance = (sequence - self._sequence) & 0xFF or 0x100
        if at is not None and self._sampled_at is not None and self._due_hz is not None:
            due = (at - self._sampled_at) * self._due_hz
            advance += max(0, round((due - advance) / 0x100)) * 0x100
        self._sampled_at = at
        self._sequence += advance
        return advance - 1

    def _keep(self, sample: Sample) -> None:
        self.received += 1
        self._groups.samples += 1
        if sample.lost:
            self._lose(sample.lost)
        if self._error is not None:
            self._lose(1)
            return
        if self._callback is not None:
            self._call(self._callback, sample)
            return
        if len(self._buffer) == self._buffer_size:
            if self._overflow == "fail":
                self.fail(SamplesLostError(f"the reader is too slow: {self._buffer_size} samples are waiting for it"))
                self._lose(1)
                return
            self._dropped += self._buffer.popleft().lost + 1
            self._lose(1)
        self._buffer.append(sample)
        if self._waiter is not None:
            self._wake()

    def _lose(self, count: int) -> None:
        self.lost += count
        self._groups.samples_lost += count

    def _call(self, callback: Callable[[Sample], object], sample: Sample) -> None:
        try:
            callback(sample)
        except Exception as error:  # noqa: BLE001  (it is the caller's own, and must not stop the link)
            asyncio.get_running_loop().call_exception_handler(
                {"message": "a subscription's callback raised", "exception": error}
            )

    def _wake(self) -> None:
        if self._waiter is not None and not self._waiter.done():
            self._waiter.set_result(None)


_COUNTED = GroupFlag.PERIODIC | GroupFlag.TRIGGER | GroupFlag.ON_CHANGE


def check_addresses(addresses: NDArray[Any], most: int) -> tuple[int, ...]:
    """Return the addresses of a group.

    Raises:
        ArgumentError: where there are none, or more than a group of the gateway holds.
    """
    if not 1 <= len(addresses) <= most:
        raise ArgumentError(f"a subscription of {len(addresses)} addresses was asked for, expected 1 to {most}")
    return tuple(int(address) for address in addresses)
