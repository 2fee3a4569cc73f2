"""The samples of a link's groups, from the events of the session to the buffer or the callback of a subscription.

1. `Publishing` holds groups for subscriptions, and passes the events of groups to their receivers.
2. A sequence number has two digits. `SampleReceiver` extends it to an endless one, and counts missing samples as lost.
   If the group is periodic, timestamps show if the two digits have wrapped around.
3. A timestamp has 32 bits. `GatewayClock` extends it to an endless time.
4. A receiver buffers samples for a reader, or calls a callback. A full buffer drops the oldest, or ends with an error.
"""

from __future__ import annotations

import contextlib
import logging
import time
from collections import deque
from operator import itemgetter
from typing import TYPE_CHECKING, Any, Literal, assert_never

import msgspec

from unity_link.errors import (
    ANY_ERROR,
    ArgumentError,
    BusTimeoutError,
    LinkLostError,
    Outcome,
    OutOfRangeError,
    SamplesLostError,
    UnityLinkError,
    missing_attribute,
)
from unity_link.link.freshness import Freshness
from unity_link.link.gateway_clock import TICKS_PER_TURN, GatewayClock, steps_between, tolerance_of
from unity_link.link.runtimes.runtime import report
from unity_link.link.runtimes.synchronisation import call_back
from unity_link.protocol import wire
from unity_link.protocol.host.events import (
    GroupBegun,
    GroupEvent,
    Sampled,
    SampledRows,
    SampledTogether,
)
from unity_link.protocol.host.requests import Request
from unity_link.protocol.wire.messages import SAMPLE_HEAD, GroupFlag

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.link.flow import Flow
    from unity_link.link.runtimes.runtime import Runtime, Waiter
    from unity_link.link.samples_together import SamplesTogether
    from unity_link.protocol.host.group_table import HeldGroup
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.arrays import Words
    from unity_link.protocol.wire.configuration import GatewayInfo

log = logging.getLogger("unity_link.link")
Overflow = Literal["drop_oldest", "fail"]
NOT_OPEN = "the subscription is not open: write `async with ...subscribe(...) as samples:`, or `with` in blocking code"
_COUNTED = GroupFlag.PERIODIC | GroupFlag.TRIGGER | GroupFlag.ON_CHANGE
"""Flags that decide when samples are taken. With PERIODIC alone, the time determines their number."""


class Sample(msgspec.Struct, frozen=True, gc=False):
    """The words of one group at one instant."""

    sequence: int
    """Number of the sample since the subscription began, with lost samples counted. It jumps when `epoch` changes."""
    time: float | None
    """Instant of sampling in seconds of the gateway's clock, without wrap-around; None without timestamps."""
    arrived: float
    """Instant of arrival in seconds of this machine's clock (`time.time`)."""
    values: Words
    """The words in the order of the addresses; shape (addresses,)."""
    lost: int
    """Number of samples lost between the previously read sample and this one; those of an interruption do not count."""
    epoch: int = 0
    """Number of the link's session in which it arrived: 0, and one more after each reconnection or reset."""

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __getattr__ = missing_attribute("a sample")


class Schedule(msgspec.Struct, frozen=True):
    """The settings of a group."""

    addresses: tuple[int, ...]
    divisor: int
    """Base ticks from one sample to the next."""
    flags: GroupFlag
    group: int | None = None
    """Number of the group; None for any."""


class Publishing:
    """The groups, the gateway's clock and the counters for all subscriptions of one link.

    Args:
        flow: flow of the link.
        runtime: runtime of the link.
        name: name of the gateway, for the log.
    """

    def __init__(self, flow: Flow, runtime: Runtime, name: str) -> None:
        self.name = name
        self.samples = 0
        self.samples_lost = 0
        self._flow = flow
        self._session = flow.session
        self.runtime = runtime
        self._clock: GatewayClock | None = None
        self._together: type[SamplesTogether] | None = None
        """Imported with the first subscription, because it needs numpy."""

    def take(self, event: GroupEvent) -> None:
        """Pass an event of a group to its receiver."""
        match event:
            case Sampled():
                event.owner.receive(event.body, event.arrived)
            case SampledRows():
                event.owner.receive_rows(event.bodies, event.arrived)
            case SampledTogether():
                self._receive_together(event)
            case GroupBegun():
                event.owner.restart()
            case _:
                assert_never(event)

    def _receive_together(self, event: SampledTogether) -> None:
        """Process samples of several subscriptions that arrived together; the result is that of `receive` for each."""
        owners: list[SampleReceiver] = event.owners
        assert self._together is not None
        now, samples = event.arrived, self._together(len(owners))
        try:
            for places, bodies in event.parts:
                samples.parse(owners, places, bodies, self.info.data_digits)
        except ValueError:
            found = (item for places, bodies in event.parts for item in zip(places.tolist(), bodies, strict=True))
            for place, body in sorted(found, key=itemgetter(0)):
                owners[place].receive(body.tobytes(), now)
            return
        clock = self.clock
        instants, arrived, epoch, corrections = samples.instants(clock, now), time.time(), self.epoch, clock.corrections
        for owner, sequence, instant, words in zip(owners, samples.sequences, instants, samples.words, strict=True):
            if instant is not None and clock.corrections != corrections:
                # A sample of this loop has corrected the clock, after the later instants were guessed: move them, too.
                instant = clock.moved(instant, clock.corrections - corrections)  # noqa: PLW2901  (corrected)
            owner.take_sample(sequence, instant, words, arrived, epoch, now)

    @property
    def epoch(self) -> int:
        """Number of the session, from 0."""
        return self._session.epoch

    @property
    def info(self) -> GatewayInfo:
        """Configuration of the gateway."""
        return self._session.codec.info

    @property
    def clock(self) -> GatewayClock:
        """The gateway's clock; only after the first session has begun."""
        assert self._clock is not None
        return self._clock

    def start(self, codec: HostCodec) -> None:
        """Prepare for the samples of a new session."""
        if self._clock is None:
            self._clock = GatewayClock(codec.info.clock_hz)
        self._clock.resume()

    def end(self, error: LinkLostError) -> None:
        """End all subscriptions with an error."""
        if self._session.epoch >= 0:
            for group in self._session.groups.end():
                group.error = error.about(Outcome.NO_REQUEST)
                group.settle()
                group.owner.fail(group.error)

    async def hold(self, receiver: SampleReceiver) -> Any:
        """Hold a free group, and start it for a subscription; without a session, wait for the next one.

        Args:
            receiver: receiver of the samples.

        Returns:
            The group, as an argument for `release` and `publish`.

        Raises:
            UnsupportedError: if no group is free.
            LinkLostError: if the link ends.
        """
        from unity_link.link.samples_together import SamplesTogether

        self._together = SamplesTogether
        session, schedule = self._session, receiver.schedule
        if session.closed is not None:
            raise session.closed.about(Outcome.NOT_EXECUTED)
        count = len(schedule.addresses)
        layout = session.codec.fields("GS", 0, int(schedule.flags), schedule.divisor, count, schedule.addresses)
        group = session.groups.hold(layout[2:], receiver.length, receiver, schedule.group)
        group.waiter = started = self.runtime.create_future()
        try:
            self._flow.go_on(session.start(group, self.runtime.time()))
            await started
        except BaseException:
            # The gateway may still start the group: stop it.
            if (request := self._stopping(group)) is not None:
                self._flow.submit(request)
            raise
        return group

    async def release(self, group: HeldGroup) -> None:
        """Stop and release a group."""
        if (request := self._stopping(group)) is not None:
            # Ignore these errors: a gateway that was lost or reset has stopped the group anyway.
            with contextlib.suppress(LinkLostError, BusTimeoutError, OutOfRangeError):
                await self._flow.ask(request)

    def _stopping(self, group: HeldGroup) -> Request | None:
        """Release a group; return the request that stops it, or None if it is stopped already."""
        session = self._session
        if not session.groups.release(group) or not session.is_open:
            return None
        return Request(session.codec, "GX", group.text, 0, of_session=True)

    async def publish(self, group: HeldGroup) -> None:
        """Request one sample of a group now."""
        await self._flow.answer(Request(self._session.codec, "GP", group.text, 0))


class SampleReceiver:
    """Counts the samples of one group, and buffers them for a reader or passes them to a callback.

    It is separate from `Subscription` for speed, because that class has a `__getattr__`; see `flow`.

    Args:
        publishing: shared state of the subscriptions of the link.
        schedule: settings of the group.
        buffer: most samples that wait for the reader.
        overflow: reaction to a full buffer.
        callback: called with each sample, or None.
    """

    _is_loss_logged = _is_overflow_logged = False

    def __init__(
        self,
        publishing: Publishing,
        schedule: Schedule,
        buffer: int,
        overflow: Overflow,
        callback: Callable[[Sample], object] | None,
    ) -> None:
        self.schedule = schedule
        """Settings of the group in the gateway."""
        self.lost = 0
        """Number of samples lost so far: in the gateway, on the line, or in the buffer."""
        self.received = 0
        """Number of samples that arrived so far."""
        self.length = 0
        """Characters of the body of a sample."""
        self.words_at = SAMPLE_HEAD
        """Offset of the first word in the body of a sample."""
        self.buffer: deque[Sample] = deque()
        """Samples that wait for the reader."""
        self.error: UnityLinkError | None = None
        """Error that the reader gets after the buffered samples; None while samples may arrive."""
        self.ended = False
        """True after the reader has left the subscription's block."""
        self.holder: object = None
        """The subscription, while its block is open: this reference keeps it alive. None before and after."""
        self._publishing = publishing
        self._buffer_size = buffer
        self._overflow = overflow
        self._callback = callback
        self._reported: set[type[BaseException]] = set()
        """Types of exceptions of the callback that were logged."""
        self._dropped = 0
        """Number of samples lost in the buffer since the last `next`."""
        self._waiter: Waiter | None = None
        self._sequence = -1
        """Number of the last sample."""
        self._sampled_at: float | None = None
        """Instant of the last sample, in seconds of the gateway's clock."""
        self._due_hz: float | None = None
        """Rate of a group that is only periodic; None otherwise."""
        self._tolerance = 0.0
        """Periods by which a sample may be early or late."""
        self._period = 0
        """Period in ticks of the gateway's clock; 0 if `_due_hz` is None."""

    @property
    def rate_hz(self) -> float | None:
        """Rate of the samples in Hz; None if the group is not periodic."""
        if GroupFlag.PERIODIC not in self.schedule.flags:
            return None
        return self._publishing.info.base_frequency_hz / self.schedule.divisor

    # For the reader

    def next(self) -> Sample:
        """Remove the oldest sample from the buffer, and return it."""
        sample = self.buffer.popleft()
        if self._dropped:
            sample = msgspec.structs.replace(sample, lost=sample.lost + self._dropped)
            self._dropped = 0
        return sample

    def give_back(self, samples: Sequence[Sample]) -> None:
        """Put the samples that `next` returned last back into the buffer; the oldest are lost if it overflows."""
        if self._dropped and self.buffer:
            # The dropped samples followed these: add them to `lost` of the first buffered sample.
            self.buffer.appendleft(self.next())
        self.buffer.extendleft(reversed(samples))
        while len(self.buffer) > self._buffer_size and self._overflow == "drop_oldest":
            self._drop_oldest()

    def _drop_oldest(self) -> None:
        self._dropped += self.buffer.popleft().lost + 1
        self._lose(1)

    async def wait(self) -> None:
        """Wait until the buffer has a sample.

        Raises:
            StopAsyncIteration: if no more samples will arrive.
        """
        while not self.buffer:
            if self.error is not None:
                raise self.error
            if self.ended:
                raise StopAsyncIteration
            if self.holder is None:
                raise ArgumentError(NOT_OPEN)
            if self._waiter is not None:
                raise ArgumentError("another task is already waiting for this subscription's next sample")
            self._waiter = self._publishing.runtime.create_future()
            try:
                await self._waiter
            finally:
                self._waiter = None

    # Called for the events of the session

    def restart(self) -> None:
        """Continue with a group that was set up again: its next sequence number is 0."""
        self._sequence = self._sequence | 0xFF
        self._sampled_at = None
        due = self._due_hz = self.rate_hz if self.schedule.flags & _COUNTED == GroupFlag.PERIODIC else None
        if due is not None:
            clock_hz = self._publishing.info.clock_hz
            self._tolerance, self._period = tolerance_of(due, TICKS_PER_TURN / clock_hz), round(clock_hz / due)

    def fail(self, error: UnityLinkError) -> None:
        """End the stream with an error, after the buffered samples."""
        if self.error is None:
            self.error = error
        self.wake()

    def receive(self, body: bytes, now: float) -> None:
        """Process the body of one sample; a malformed one is ignored."""
        if len(body) != self.length:
            return
        try:
            values = wire.arrays.parse_words(body[self.words_at :], self._publishing.info.data_digits)
            sequence = int(body[3:SAMPLE_HEAD], 16)
            timestamp = int(body[SAMPLE_HEAD : self.words_at], 16) if self.words_at != SAMPLE_HEAD else None
        except ValueError:
            return
        instant = None if timestamp is None else self._publishing.clock.seconds(timestamp, now)
        self.take_sample(sequence, instant, values, time.time(), self._publishing.epoch, now)

    def take_sample(
        self, sequence: int, instant: float | None, words: Words, arrived: float, epoch: int, now: float
    ) -> None:
        """Process a decoded sample.

        Args:
            sequence: its sequence number, 0 to 255.
            instant: its instant as the gateway's clock has guessed it, in seconds; None without a timestamp.
            words: its words.
            arrived: instant of arrival (`time.time`).
            epoch: number of the session.
            now: instant of arrival, on the clock of the runtime.
        """
        if instant is None and not (sequence - self._sequence - 1) & 0xFF:
            self._sequence += 1
            sample = Sample(self._sequence, None, arrived, words, 0, epoch)
            if self._callback is not None and self.error is None:
                # The same as in `keep`, inlined because every sample of interleaved groups runs it.
                self.received += 1
                self._publishing.samples += 1
                self._call(self._callback, sample)
            else:
                self.keep(sample)
        elif not self._came_before(sequence, instant):
            lost = self._count_lost(sequence, instant, now)
            self.keep(Sample(self._sequence, self._sampled_at, arrived, words, lost, epoch))

    def receive_rows(self, bodies: NDArray[np.uint8], now: float) -> None:
        """Process consecutive samples of the group; the result is that of `receive` for each.

        Args:
            bodies: their bodies, shape (n, length).
            now: instant of arrival, on the clock of the runtime.
        """
        digits, stamped = self._publishing.info.data_digits, self.words_at != SAMPLE_HEAD
        parse_rows = wire.arrays.parse_rows
        try:
            values = parse_rows(bodies[:, self.words_at :].reshape(-1, digits)).reshape(len(bodies), -1)
            sequences = parse_rows(bodies[:, 3:SAMPLE_HEAD])
            timestamps = parse_rows(bodies[:, SAMPLE_HEAD : self.words_at]) if stamped else None
        except ValueError:
            for body in bodies:
                self.receive(body.tobytes(), now)
            return
        rows = wire.arrays.apart(values)
        ends = [*self._gaps(sequences, timestamps), len(rows)]
        for start, end in zip([0, *ends], ends, strict=False):
            stamps = None if timestamps is None else timestamps[start:end]
            self._receive_run(int(sequences[start]), stamps, rows[start:end], now)

    def _receive_run(
        self, sequence: int, timestamps: NDArray[np.unsignedinteger] | None, rows: list[Words], now: float
    ) -> None:
        """Process samples without a gap between them; `sequence` is the number of the first, 0 to 255."""
        instants: list[Any] = [None] * len(rows)
        if timestamps is not None:
            instants = self._publishing.clock.seconds_of(timestamps, now, self._period).tolist()
        if self._came_before(sequence, instants[0]):
            sequence, instants, rows = sequence + 1, instants[1:], rows[1:]
            if not instants:
                return
        lost, first, arrived = self._count_lost(sequence, instants[0], now), self._sequence, time.time()
        if self._sampled_at is not None and self._sampled_at != instants[0]:
            clock = self._publishing.clock
            turns = round((self._sampled_at - instants[0]) / clock.turn)
            instants = [clock.moved(instant, turns) for instant in instants]
        epoch = self._publishing.epoch
        self._sequence += len(rows) - 1
        self._sampled_at = instants[-1]
        self._keep_all(
            [
                Sample(first + offset, instant, arrived, words, 0 if offset else lost, epoch)
                for offset, (instant, words) in enumerate(zip(instants, rows, strict=True))
            ]
        )

    def _gaps(
        self, sequences: NDArray[np.unsignedinteger], timestamps: NDArray[np.unsignedinteger] | None
    ) -> list[int]:
        """Return the positions of samples before which others may be missing; the first sample does not count."""
        broken = sequences[1:] - sequences[:-1] != 1
        if timestamps is not None and self._due_hz is not None:
            # The timestamps show gaps of a multiple of 256 samples, which the sequence numbers do not.
            steps = steps_between(timestamps, self._period)[1:]
            broken |= abs(steps - self._period) > self._tolerance * self._period
        return [place + 1 for place in broken.nonzero()[0].tolist()]

    def _keep_all(self, samples: list[Sample]) -> None:
        room = self._buffer_size - len(self.buffer)
        if self._callback is None and self.error is None and len(samples) <= room:
            self.keep(samples[0])
            self.received += len(samples) - 1
            self._publishing.samples += len(samples) - 1
            self.buffer.extend(samples[1:])
            return
        for sample in samples:
            self.keep(sample)

    def _came_before(self, sequence: int, at: float | None) -> bool:
        """Return whether a sample repeats the last one. Without timestamps, False: it may be 256 samples later."""
        return at is not None and at == self._sampled_at and not (sequence - self._sequence) & 0xFF

    def _count_lost(self, sequence: int, at: float | None, now: float) -> int:
        """Return the number of samples missing before this one, and update `_sequence` and `_sampled_at`.

        For a periodic group, the timestamp shows how often the sequence number has wrapped around, and the sequence
        number shows how often the timestamp has wrapped around, which may correct the clock.
        """
        advance, last, rate_hz = (sequence - self._sequence) & 0xFF or 0x100, self._sampled_at, self._due_hz
        if at is not None and last is not None and rate_hz is not None:
            due = (at - last) * rate_hz
            if abs(due - advance) > self._tolerance:
                clock = self._publishing.clock
                turns = clock.turns_from(last, at, advance, rate_hz, now)
                if turns:
                    clock.correct(turns)
                    at = clock.moved(at, turns)
                    due = (at - last) * rate_hz
                advance += max(0, round((due - advance) / 0x100)) * 0x100
        self._sampled_at = at
        self._sequence += advance
        return advance - 1

    def keep(self, sample: Sample) -> None:
        """Pass a sample, with the number of samples lost before it, to the buffer or the callback."""
        self.received += 1
        self._publishing.samples += 1
        if sample.lost:
            self._log_loss(sample)
            self._lose(sample.lost)
        if self.error is not None:
            self._lose(1)
            return
        if self._callback is not None:
            self._call(self._callback, sample)
            return
        if len(self.buffer) >= self._buffer_size:
            if self._overflow == "fail":
                self.fail(SamplesLostError(f"the reader is too slow: {len(self.buffer)} samples are waiting for it"))
                self._lose(1)
                return
            if not self._is_overflow_logged:
                self._log_overflow()
            self._drop_oldest()
        self.buffer.append(sample)
        if self._waiter is not None:
            self.wake()

    def _log_loss(self, sample: Sample) -> None:
        """Log a gap in the sequence; only the first of a subscription is a warning, because a bad line has many."""
        level = logging.DEBUG if self._is_loss_logged else logging.WARNING
        self._is_loss_logged = True
        name, group = self._publishing.name, self._called()
        log.log(level, "%s: samples of %s lost: %d, before sample %d", name, group, sample.lost, sample.sequence)

    def _log_overflow(self) -> None:
        """Log once that samples are dropped, because with a slow reader each arriving sample drops one."""
        self._is_overflow_logged = True
        text = "%s: the reader of %s is too slow: its buffer (samples: %d) drops the oldest (logged once)"
        log.warning(text, self._publishing.name, self._called(), self._buffer_size)

    def _called(self) -> str:
        """Return the name of the group for the log: its first address, and the number of other addresses."""
        first, *others = self.schedule.addresses
        return f"the group of 0x{first:02X}{f' and {len(others)} more' if others else ''}"

    def _lose(self, count: int) -> None:
        self.lost += count
        self._publishing.samples_lost += count

    def _call(self, callback: Callable[[Sample], object], sample: Sample) -> None:
        try:
            call_back(callback, sample)
        except ANY_ERROR as error:
            # Log it, because an error of the callback must not stop the link; once for each type, because it may occur
            # for each sample.
            if type(error) not in self._reported:
                self._reported.add(type(error))
                what = f"a subscription's callback raised {type(error).__name__} (told once)"
                report(what, error)

    def wake(self) -> None:
        """Resume the waiting reader, which checks the buffer and the end of the stream."""
        if self._waiter is not None and not self._waiter.done():
            self._waiter.set_result(None)


class LatestSampleReceiver(SampleReceiver):
    """Receiver for a reader that wants only the newest sample; periodic samples from before a pause are dropped.

    It is a class of its own so that other receivers do not compute the ages of samples.
    """

    _is_overflow_logged = True
    """Do not log an overflow, because dropping older samples is intended."""
    _freshness: Freshness | None = None
    """Ages of the samples of a periodic group; None for other groups, whose newest sample may be old."""

    async def wait(self) -> None:
        """Wait until the buffer has a sample that was not taken before a pause.

        Raises:
            StopAsyncIteration: if no more samples will arrive.
        """
        while True:
            self._drop_aged()
            if self.buffer:
                return
            await super().wait()

    def restart(self) -> None:
        """Continue with a group that was set up again: its next sequence number is 0."""
        super().restart()
        if self._due_hz is not None:
            self._freshness = Freshness(self._due_hz)

    def take_sample(
        self, sequence: int, instant: float | None, words: Words, arrived: float, epoch: int, now: float
    ) -> None:
        """Process a decoded sample, as `SampleReceiver.take_sample`."""
        if not self._came_before(sequence, instant):
            lost = self._count_lost(sequence, instant, now)
            self.keep(Sample(self._sequence, self._sampled_at, arrived, words, lost, epoch))

    def _keep_all(self, samples: list[Sample]) -> None:
        for sample in samples:
            self.keep(sample)

    def keep(self, sample: Sample) -> None:
        """Buffer a sample or pass it to the callback; drop it if it was taken before a pause."""
        freshness = self._freshness
        if freshness is None or not freshness.is_old(self._instant_of(sample), self._publishing.runtime.time()):
            super().keep(sample)
            return
        while self.buffer:
            self._drop_oldest()
        self.received += 1
        self._publishing.samples += 1
        self._dropped += sample.lost + 1
        if sample.lost:
            self._log_loss(sample)
        self._lose(sample.lost + 1)

    def _call(self, callback: Callable[[Sample], object], sample: Sample) -> None:
        self.buffer.append(sample)
        super()._call(callback, self.next())

    def _drop_aged(self) -> None:
        freshness = self._freshness
        if freshness is not None and self.buffer:
            now = self._publishing.runtime.time()
            if freshness.has_aged(self._instant_of(self.buffer[-1]), now):
                while self.buffer:
                    self._drop_oldest()

    def _instant_of(self, sample: Sample) -> float:
        if sample.time is not None:
            return sample.time
        assert self._due_hz is not None
        return sample.sequence / self._due_hz
