"""Layer 2: the link of a program to one gateway.

`Link` checks the arguments of calls, makes requests of them, and waits for their futures. It is a `Connection`; its
`flow` carries requests and answers, and `subscription` handles samples.
"""

from __future__ import annotations

import contextlib
import warnings
from numbers import Integral
from typing import TYPE_CHECKING, Any, Literal, Self

import msgspec

from unity_link.errors import (
    ArgumentError,
    BusError,
    LinkLostError,
    NotArmedError,
    OfLink,
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
    missing,
    missing_attribute,
    refusing,
)
from unity_link.link.calls import returns_coroutine
from unity_link.link.connection import Connection, Reconnect
from unity_link.link.interrupts import whole_exit
from unity_link.link.living import LeftOpen
from unity_link.link.publishing import Overflow, Publishing, Sample, Schedule
from unity_link.link.runtimes.runtime import raises_now
from unity_link.link.subscription import LARGEST_DIVISOR, Subscription, asked_rate, check_addresses
from unity_link.protocol import wire
from unity_link.protocol.host.batches import RequestBlock, WordBatch, common_outcome
from unity_link.protocol.host.events import GroupEvent, PostedFailure, UnsolicitedEvent
from unity_link.protocol.host.requests import Confirmation, DestructiveRead, Fence, Request
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.protocol.wire.numbers import seconds_from, whole_number

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Coroutine, Iterable, Mapping, Sequence
    from types import TracebackType

    from numpy.typing import ArrayLike, NDArray

    from unity_link.link.guards import Guard
    from unity_link.link.runtimes.runtime import Runtime, Waiter
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.arrays import Words
    from unity_link.transport import DriverUrl, Medium

NOT_CONNECTED = "write `async with unity_link.connect(...) as link:`, or `link = await unity_link.connect(...)`"
MOST_QUEUE_WORDS = 1 << 24
"""Most words that one call reads from a queue; no address limits this number."""
SendImmediate = Literal["off", "always", "adaptive"]
_SEND_IMMEDIATE: dict[str, int] = {"off": 0, "always": 1, "adaptive": 2}


class Statistics(msgspec.Struct, frozen=True, kw_only=True):
    """Counters of a link since it was opened."""

    requests: int
    """Requests sent, without retransmissions."""
    responses: int
    """Responses to requests."""
    in_flight: int
    """Requests sent and not answered yet."""
    repetitions: int
    """Requests retransmitted."""
    timeouts: int
    """Number of times that requests were retransmitted because of a timeout."""
    errors: int
    """Error responses: the bus refused an access or did not answer, or a value was out of range."""
    damaged_frames: int
    """Frames that arrived with a wrong CRC."""
    stray_frames: int
    """Undamaged frames that no request or subscription expected."""
    bytes_sent: int
    """Bytes written to the medium."""
    bytes_received: int
    """Bytes read from the medium."""
    samples: int
    """Samples that arrived."""
    samples_lost: int
    """Samples that were lost in the gateway, on the line, or because their reader was too slow."""
    reconnections: int
    """Number of sessions after the first one, each on a new connection or after a reset of the gateway."""
    round_trip: float | None
    """Smoothed round trip in seconds; None before the first measurement."""

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __getattr__ = missing_attribute("the statistics of a link")

    def _repr_html_(self) -> str:
        """Return the counters as an HTML table."""
        from unity_link.link import html

        return html.table("statistics of a link", html.statistics_rows(self))


class Link(OfLink, Connection):
    """A connection to one gateway, made by `connect`.

    Any number of tasks may use it at once. Requests are executed exactly once, in the order of the calls; blocks and
    batches of several tasks take turns. The cancellation of a call does not disturb other calls. A cancelled write may
    or may not have been executed.

    Every call may raise `BusError`, `BusTimeoutError` and `UnansweredError`, most often its subclass `LinkLostError`.
    """

    def __init__(
        self,
        target: DriverUrl | Medium,
        reconnect: Reconnect | None,
        *,
        resumes: bool = False,
        runtime: Runtime | None = None,
    ) -> None:
        super().__init__(target, reconnect, resumes=resumes, runtime=runtime)
        self._publishing = Publishing(self._flow, self._runtime, self._name)
        self._left_open: LeftOpen | None = None
        self._posted = False
        self._caller = self._runtime.caller
        self._posted_failures: dict[object, PostedFailure] = {}
        """Failures of posted writes that no call has raised yet, oldest first: by task; under None for tasks that have
        ended."""
        self._guards: dict[int, Guard] = {}
        """Leases under which the program writes, by the addresses that they guard."""
        self._explanations: dict[int, Callable[[BusError], Awaitable[BusError]]] = {}
        """By the address of a signal: a function that adds the reason to the error of a refused posted write."""
        self.told_by_fence: dict[int, Any] = {}
        """Writers of scheduled writes, by address. A fence calls `see`, which raises their errors, and the end of the
        link calls `drop_answers`."""

    # Events of the connection

    def _happened(self, event: UnsolicitedEvent) -> None:
        if isinstance(event, GroupEvent):
            self._publishing.take(event)
        elif isinstance(event, PostedFailure):
            self._note_posted(event)
        else:
            self._take_change(event)

    def _begin(self, codec: HostCodec) -> None:
        # On a half-duplex line a posted write has an answer, because the host must know when it may send again.
        self._takes_turns = Feature.HALF_DUPLEX in codec.info.features
        self._publishing.start(codec)
        self._left_open = self._left_open or LeftOpen(self._warn_of_left_open)
        codec.refusal = self._refusal

    def _refusal(self) -> str:
        stream = self._flow.stream
        return "" if stream is None else stream.refusal

    def name_addresses(self, names: Mapping[int, str]) -> None:
        """Set the names of addresses in error texts; a robot sets those of its signals."""
        self._session.codec.names.update(names)

    def explain_refusals(self, explanations: Mapping[int, Callable[[BusError], Awaitable[BusError]]]) -> None:
        """Register functions that add the reason to bus errors of posted writes, by address.

        A robot registers the signals that a lease guards.
        """
        self._explanations.update(explanations)

    def _ended(self, error: LinkLostError) -> None:
        self._publishing.end(error)
        for writer in self.told_by_fence.values():
            writer.drop_answers()
        if self._left_open is not None:
            self._left_open.end()
            self._left_open = None

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __enter__ = __exit__ = refusing("write `async with` before a link, or connect by `unity_link.blocking`")

        def __getattr__(self, name: str) -> Any:
            raise missing(self, name, "a link", close="it is closed where its `async with` block ends, or by `aclose`")

    async def __aenter__(self) -> Self:
        return self

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the link. After a block without an error, wait for the posted writes first, and raise their errors.

        If the gateway is away, do not wait: posted writes whose outcome is unknown are then errors, too. The first
        error is raised, with the others as its notes.
        """
        try:
            if error is None and (self._posted or self._posted_failures or self.told_by_fence):
                if self.connected:
                    with contextlib.suppress(LinkLostError):
                        await self._fence(leaving=True)
                # A program that calls `aclose` in the block abandons the requests in flight knowingly.
                if not self._closed_by_program:
                    await self._raise_all()
        finally:
            await self.aclose()

    def _warn_of_left_open(self) -> None:
        if self._flow.stream is not None:
            warnings.warn(
                f"{self!r} was not closed: use `async with`, or `aclose`", ResourceWarning, stacklevel=1, source=self
            )

    def _called(self) -> str:
        return "a link"

    def __repr__(self) -> str:
        """Return the URL of the gateway and the state of the connection."""
        state = "connected" if self.connected else "closed" if self._closed else "not connected"
        return f"<link to {self._name}, {state}>"

    def _repr_html_(self) -> str:
        """Return the URL, the gateway and the statistics as an HTML table."""
        from unity_link.link import html

        return html.link_table(self)

    @property
    def statistics(self) -> Statistics:
        """Counters of the link since it was opened."""
        counters = self._session.counters
        return Statistics(
            requests=counters.requests,
            responses=counters.responses,
            in_flight=self._session.window.in_flight,
            repetitions=counters.repetitions,
            timeouts=counters.timeouts,
            errors=counters.errors,
            damaged_frames=counters.damaged,
            stray_frames=counters.stray,
            bytes_sent=self._flow.bytes_sent,
            bytes_received=self._flow.bytes_received,
            samples=self._publishing.samples,
            samples_lost=self._publishing.samples_lost,
            reconnections=max(0, self._session.epoch),
            round_trip=self._session.window.round_trip.smoothed,
        )

    # Words

    async def read(self, address: int) -> int:
        """Read the word at `address`."""
        flow = self._flow
        codec = flow.session.codec
        # A number of another type, such as an integer of numpy, may be valid: `_whole_address` decides.
        if type(address) is not int or not 0 <= address <= codec.highest_address:
            address = self._whole_address(address)
        request = Request(codec, "R", codec.fields("R", address), codec.data_digits)
        # The same as `Flow.answer`, inlined because this is the most frequent call.
        waiter = flow.ask(request)
        try:
            word: int = await waiter
        except BaseException:
            request.cancel()
            raise
        return word

    async def write(self, address: int, value: int) -> None:
        """Write `value` to `address`; returns when the gateway has executed the write."""
        flow = self._flow
        codec = flow.session.codec
        if type(address) is not int or not 0 <= address <= codec.highest_address:
            address = self._whole_address(address)
        if type(value) is not int or not 0 <= value <= codec.highest_word:
            value = self._whole_word(value)
        request = Request(codec, "W", codec.write_fields(address, value), 0)
        if self._guards:
            self._bind(request, (address,))
        await flow.answer(request)

    async def write_masked(self, address: int, value: int, mask: int) -> int:
        """Replace the bits of a word that are 1 in `mask` by those of `value`, in one bus transaction.

        Returns:
            The whole word before the write.

        Raises:
            UnsupportedError: if the gateway was built without masked write.
        """
        self._require(Feature.MASKED_WRITE)
        where, what, bits = self._whole_address(address), self._whole_word(value), self._whole_word(mask)
        codec = self._session.codec
        request = DestructiveRead(codec, "WK", codec.fields("WK", where, bits, what), 1)
        self._bind(request, (where,))
        word: int = await self._flow.answer(request)
        return word

    @returns_coroutine
    def post(self, address: int, value: int) -> Coroutine[Any, Any, None]:
        """Send a write without waiting for its execution. It waits only while too many requests are in flight.

        The write is executed exactly once and in order. Its error is raised by the next `fence` of the task that calls
        `post`, or at the end of the ``async with`` block of the link. On a half-duplex medium each write is answered,
        and `post` waits for the answer.
        """
        return self._post_for(self._caller(), address, value)

    async def _post_for(self, poster: object, address: int, value: int, *, of_session: bool = False) -> None:
        flow = self._flow
        codec = flow.session.codec
        if type(address) is not int or not 0 <= address <= codec.highest_address:
            address = self._whole_address(address)
        if type(value) is not int or not 0 <= value <= codec.highest_word:
            value = self._whole_word(value)
        fields = codec.write_fields(address, value)
        answered = self._takes_turns
        request = Request(codec, "W" if answered else "WS", fields, 0 if answered else None, of_session=of_session)
        if self._guards:
            self._bind(request, (address,))
        self._posted = True
        if answered:
            await self._post_answered(request, poster)
            return
        request.poster = poster
        flow.submit(request)
        if not request.sent:
            await self._sent(request)

    @returns_coroutine
    def fence(self) -> Coroutine[Any, Any, None]:
        """Wait until all requests that were submitted before are executed.

        It raises the errors of writes that the calling task has posted (on blocking links: the calling thread), and of
        writes of tasks that have ended. It finds the calling task also under `asyncio.wait_for` and `asyncio.gather`,
        which run the coroutine in another task. Errors of other tasks are raised by their fences, and at the end of the
        block.

        Raises:
            UnityLinkError: the first error of these posted writes that was not raised before; or that of the first of
                their scheduled writes which has failed. Scheduled writes that are still to come are not awaited.
        """
        return self._fence_for(self._caller())

    async def _fence_for(self, caller: object) -> None:
        self._posted = False
        is_raised = raises_now(self._runtime, caller)
        try:
            await self._fence(leaving=False)
        except LinkLostError as lost:
            # Prefer the error of the posted writes, because it contains their outcome.
            raise self._take_posted(is_raised) or lost from None
        except BaseException:
            self._posted = True
            raise
        await self._raise_errors(is_raised)

    async def _fence(self, *, leaving: bool) -> None:
        await self._flow.answer(Fence(self._session.codec, of_session=leaving))

    async def _ping(self) -> None:
        """Wait for an answer of the gateway to a request that changes nothing.

        Raises:
            BusTimeoutError: if a server answers whose gateway is away.
        """
        await self._flow.answer(Confirmation(self._session.codec, of_session=True))

    async def _raise_errors(self, is_raised: Callable[[object], bool]) -> None:
        if self._posted_failures:
            await self._raise_posted(is_raised)
        for writer in tuple(self.told_by_fence.values()):
            await writer.see(is_raised, is_connected=self.connected)

    async def _raise_all(self) -> None:
        """Raise the first error of all tasks' writes, with the others as notes."""
        errors: list[UnityLinkError] = []

        def of_any_task(_: object) -> bool:
            return True

        try:
            await self._raise_posted(of_any_task)
        except UnityLinkError as error:
            errors.append(error)
        for writer in tuple(self.told_by_fence.values()):
            try:
                await writer.see(of_any_task, is_connected=self.connected)
            except UnityLinkError as error:
                errors.append(error)
        if errors:
            first, *others = errors
            for other in others:
                first.add_note(str(other))
            raise first

    async def _raise_posted(self, is_raised: Callable[[object], bool]) -> None:
        """Raise the first error of the posted writes for which `is_raised` is true.

        If a lease refused the write, the error contains its reason.

        Args:
            is_raised: takes the task or thread that posted a write, or None.
        """
        error = self._take_posted(is_raised)
        if error is None:
            return
        if isinstance(error, BusError) and error.address in self._explanations:
            with contextlib.suppress(UnityLinkError):
                explained = await self._explanations[error.address](error)
                explained.__notes__ = getattr(error, "__notes__", [])
                error = explained
        raise error

    def _take_posted(self, is_raised: Callable[[object], bool]) -> UnityLinkError | None:
        """Remove the errors of the posted writes for which `is_raised` is true; return the first, or None."""
        failures = self._posted_failures
        taken = [failures.pop(poster) for poster in tuple(failures) if is_raised(poster)]
        if not taken:
            return None
        first, count = taken[0].error, sum(failure.writes for failure in taken)
        if count > 1:
            first.add_note(f"{count - 1} more posted writes failed as well")
        return first

    def _note_posted(self, failure: PostedFailure) -> None:
        """Store the first error of each task's posted writes since its last fence, and count the failed writes."""
        if failure.poster not in self._posted_failures:
            # Merge the failures of tasks that have ended, so that their number does not grow.
            before, self._posted_failures = self._posted_failures, {}
            for poster, other in before.items():
                self._add_failure(None if poster is None or self._runtime.is_over(poster) else poster, other)
        self._add_failure(failure.poster, failure)

    def _add_failure(self, poster: object, failure: PostedFailure) -> None:
        first = self._posted_failures.get(poster)
        added = failure if first is None else first._replace(writes=first.writes + failure.writes)
        self._posted_failures[poster] = added

    # Blocks

    async def read_block(self, address: int, count: int) -> Words:
        """Read `count` consecutive words from `address` on.

        The gateway reads at most ``gateway.block_words`` words in one bus transaction, over UDP at most as many as a
        datagram holds. A longer block is read in several transactions, in the order of the addresses.

        Returns:
            The words, shape (count,), in the smallest unsigned type for a word.
        """
        where, size = self._whole_block(address, count)
        end, most = where + size, self._flow.block_words
        return await self._read_blocks([range(start, min(start + most, end)) for start in range(where, end, most)])

    async def read_queue(self, address: int, count: int) -> Words:
        """Read the same address, the port of a FIFO, `count` times, at most 2 ** 24; otherwise as `read_block`."""
        self._require(Feature.QUEUE_COMMANDS)
        where, size = self._whole_address(address), self._whole_count(count)
        if size > MOST_QUEUE_WORDS:
            raise ArgumentError(f"{size} words of a queue were asked for, one call reads {MOST_QUEUE_WORDS} at most")
        arrays, codec, most = wire.arrays, self._session.codec, self._flow.block_words
        counts = (min(most, size - start) for start in range(0, size, most))
        requests: list[Request] = [
            DestructiveRead(codec, "RQ", codec.fields("RQ", where, count), count) for count in counts
        ]
        return arrays.joined(await self._all(requests))

    async def write_block(self, address: int, values: ArrayLike) -> None:
        """Write consecutive words from `address` on, in bus transactions as large as those of `read_block`."""
        words = self._words(values)
        where, _ = self._whole_block(address, len(words))
        await self._write_words("WM", where, words, step=1)

    async def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write all `values` to the same address, the port of a FIFO; otherwise as `write_block`."""
        self._require(Feature.QUEUE_COMMANDS)
        words = self._words(values)
        where = self._whole_address(address)
        self._whole_count(len(words))
        await self._write_words("WQ", where, words, step=0)

    # Batches

    async def read_many(self, addresses: ArrayLike) -> Words:
        """Read many words in one pipelined batch, with one request for each.

        Returns:
            The words in the order of `addresses`, in the smallest unsigned type for a word.

        Raises:
            GatewayError: the first error; the other reads are executed nevertheless.
        """
        where = self._addresses(addresses)
        return await self._batch("R", (where, self.gateway.address_digits))

    async def write_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write one word to each of many addresses, in order, in one pipelined batch.

        Raises:
            GatewayError: the first error; the other writes are executed nevertheless.
        """
        where, what = self._write_arguments(addresses, values)
        info = self.gateway
        await self._batch("W", (where, info.address_digits), (what, info.data_digits), written=where)

    @returns_coroutine
    def post_many(self, addresses: ArrayLike, values: ArrayLike) -> Coroutine[Any, Any, None]:
        """Send many writes as `post` does; returns when the last one is sent.

        This is the fastest way to write words at separate addresses, because the writes have no answers.
        """
        return self._post_many_for(self._caller(), addresses, values)

    async def _post_many_for(self, poster: object, addresses: ArrayLike, values: ArrayLike) -> None:
        where, what = self._write_arguments(addresses, values)
        self._whole_count(len(where))
        fields = [(where, self.gateway.address_digits), (what, self.gateway.data_digits)]
        batch = WordBatch(self._session.codec, "W" if self._takes_turns else "WS", fields)
        self._bind(batch, where)
        self._posted = True
        if self._takes_turns:
            await self._post_answered(batch, poster)
        else:
            batch.poster = poster
            self._flow.submit(batch)
            if batch.sent != batch.count:
                await self._sent(batch)

    # Publishing

    def timestamp_of(self, time: float) -> int:
        """Return the gateway's timestamp for the time of a sample, in ticks of ``gateway.clock_hz`` modulo 2 ** 32.

        Raises:
            ArgumentError: if `time` is no finite number of seconds, or is before the gateway's last reset.
        """
        return self._publishing.clock.timestamp(_sample_time(time))

    def age_of(self, time: float) -> float:
        """Return the seconds since the time of a sample, 0 or more; the error is the jitter of the line.

        Raises:
            ArgumentError: if `time` is no finite number of seconds.
        """
        return self._publishing.clock.age(_sample_time(time), self._runtime.time())

    def subscribe(  # noqa: PLR0913  (each is a choice of its own, by keyword)
        self,
        addresses: int | ArrayLike,
        *,
        rate_hz: float | None = None,
        divisor: int | None = None,
        trigger: bool = False,
        on_change: bool = False,
        immediate: bool = False,
        timestamps: bool | None = None,
        group: int | None = None,
        buffer: int = 16_384,
        latest: bool = False,
        overflow: Overflow = "drop_oldest",
        callback: Callable[[Sample], object] | None = None,
    ) -> Subscription:
        """Subscribe to addresses that the gateway samples by itself, all in one bus transaction.

        Args:
            addresses: one address, or up to ``gateway.group_words`` addresses.
            rate_hz: samples per second; `Subscription.rate_hz` is the nearest rate that the gateway has.
            divisor: the rate as a divisor of ``gateway.base_frequency_hz``, 1 to 65535.
            trigger: sample on the external trigger of ``group``.
            on_change: publish only samples in which a word has changed.
            immediate: send each sample at once instead of filling packets.
            timestamps: add the instant of sampling; None: if the gateway supports it.
            group: number of the group, which decides its external trigger; None: any free group.
            buffer: most samples that wait for the reader. The default holds all samples of one read of a socket.
            latest: keep only the newest sample, for a controller. Periodic samples from before a pause of the program
                or the line are dropped and counted as lost.
            overflow: reaction to a full buffer: ``"drop_oldest"`` drops and counts samples, ``"fail"`` ends the
                subscription.
            callback: called with each sample as it arrives, instead of iteration. The first exception of each type that
                it raises is logged under ``unity_link.link``; the subscription continues.

        Without a rate, a divisor or a trigger, samples are taken when `Subscription.publish` is called.

        Raises:
            ArgumentError: for a rate, an address or a size that the gateway does not have.
            UnsupportedError: if the gateway was built without a requested feature, or the group, or all groups, are in
                use.
            OutOfRangeError: when the block is entered, if the gateway refuses the group: for a rate on a half-duplex
                medium, or while other programs use all groups of a shared gateway.
        """
        self._require(Feature.GROUPS)
        if timestamps is None:
            timestamps = Feature.TIMESTAMPS in self.gateway.features
        needs = (
            (trigger, Feature.EXTERNAL_TRIGGERS),
            (timestamps, Feature.TIMESTAMPS),
            (immediate, Feature.SEND_IMMEDIATE),
        )
        for wanted, feature in needs:
            if wanted:
                self._require(feature)
        flags = GroupFlag(0)
        if rate_hz is not None or divisor is not None:
            flags |= GroupFlag.PERIODIC
        for wanted, flag in (
            (trigger, GroupFlag.TRIGGER),
            (immediate, GroupFlag.IMMEDIATE),
            (timestamps, GroupFlag.TIMESTAMP),
            (on_change, GroupFlag.ON_CHANGE),
        ):
            flags |= flag if wanted else GroupFlag(0)
        given: object = addresses
        several: ArrayLike = [int(given)] if not isinstance(given, bool) and isinstance(given, Integral) else addresses
        where = check_addresses(self._addresses(several), self.gateway.group_words)
        number = None if group is None else whole_number(group, "a group")
        schedule = Schedule(where, self._divisor(rate_hz, divisor), flags, number)
        return Subscription(
            self._publishing, schedule, buffer=buffer, overflow=overflow, callback=callback, latest=latest
        )

    async def send_immediate(self, mode: SendImmediate) -> None:
        """Choose when an FT232H sends a short packet at once (docs/protocol.md, "Send-immediate").

        The gateway pulses SIWU# as the mode says, and the driver sets the chip's latency timer.

        Args:
            mode: ``"off"``; ``"always"``, after every response; or ``"adaptive"``, if no further output is waiting.

        Raises:
            UnsupportedError: if the gateway was built without send-immediate.
        """
        check_mode(mode)
        self._require(Feature.SEND_IMMEDIATE)
        await self._ask("I", _SEND_IMMEDIATE[mode])
        if self._flow.stream is not None:
            await self._flow.stream.choose_send_immediate(mode)

    # Private methods

    async def _ask(self, command: str, *values: object) -> None:
        """Execute a request that is answered by an acknowledgement."""
        codec = self._session.codec
        await self._flow.answer(Request(codec, command, codec.fields(command, *values), 0))

    async def _sent(self, posted: Request | WordBatch) -> None:
        """Wait until posted writes that were queued are sent."""
        posted.waiter = waiter = self._flow.create_future()
        if posted.done:
            posted.settle()
        try:
            await waiter
        except BaseException:
            posted.cancel()
            raise

    async def _post_answered(self, posted: Request | WordBatch, poster: object) -> None:
        """Execute writes that have answers, and store their errors as those of posted writes."""
        try:
            await self._flow.answer(posted)
        except UnityLinkError as error:
            self._note_posted(PostedFailure(error, 1, poster))

    async def _read_blocks(self, blocks: Sequence[range]) -> Words:
        """Return the words of blocks of addresses, each read in one bus transaction, in one array."""
        # Import numpy now, not in the callback that decodes the answer.
        arrays = wire.arrays
        codec, digits = self._session.codec, self.gateway.data_digits
        requests = [
            Request(codec, "RM", codec.fields("RM", block.start, len(block)), len(block) * digits) for block in blocks
        ]
        return arrays.joined(await self._all(requests))

    def _begin_block(
        self, address: int, count: int, write: Sequence[int], *, to_queue: bool
    ) -> tuple[Waiter, Callable[[], None]]:
        """Submit a read or write of one bus transaction; return its future, and a function that cancels it.

        A write ends with its session, because it belongs to a lease or a schedule, which a reset ends.
        """
        codec = self._session.codec
        if write:
            command = "WQ" if to_queue else "WM"
            if to_queue:
                self._require(Feature.QUEUE_COMMANDS)
            request = Request(codec, command, codec.fields(command, address, self._words(write)), 0, of_session=True)
            self._bind(request, (address,) if to_queue else range(address, address + len(write)))
        else:
            # Import numpy now, not in the callback that decodes the answer.
            _ = wire.arrays
            digits = count * self.gateway.data_digits
            request = Request(codec, "RM", codec.fields("RM", address, count), digits)
        request.waiter = waiter = self._flow.create_future()
        self._flow.submit(request)
        return waiter, request.cancel

    async def _write_words(self, command: str, address: int, words: Words, step: int) -> None:
        codec, most = self._session.codec, self._flow.block_words
        requests = [
            Request(codec, command, codec.fields(command, address + step * start, words[start : start + most]), 0)
            for start in range(0, len(words), most)
        ]
        for request in requests if self._guards else ():
            self._bind(request, range(address, address + step * (len(words) - 1) + 1))
        await self._all(requests)

    async def _all(self, requests: list[Request]) -> list[Any]:
        """Execute requests in order, and return their answers; after a failure, do not wait for the others."""
        if len(requests) == 1:
            return [await self._flow.answer(requests[0])]
        waiters = []
        for request in requests:
            request.waiter = self._flow.create_future()
            waiters.append(request.waiter)
        self._flow.submit(RequestBlock(requests))
        try:
            return [await waiter for waiter in waiters]
        except UnansweredError as error:
            raise error.about(common_outcome(requests)) from None
        finally:
            for request, waiter in zip(requests, waiters, strict=True):
                request.cancel()
                if not waiter.cancel() and not waiter.cancelled():
                    waiter.exception()

    def _write_arguments(self, addresses: ArrayLike, values: ArrayLike) -> tuple[Words, Words]:
        where, what = self._addresses(addresses), self._words(values)
        if len(where) != len(what):
            raise ArgumentError(f"{len(where)} addresses were given, and {len(what)} values")
        return where, what

    async def _batch(
        self, command: str, *columns: tuple[NDArray[Any], int], written: NDArray[Any] | None = None
    ) -> Words:
        self._whole_count(len(columns[0][0]))
        batch = WordBatch(self._session.codec, command, columns)
        if written is not None:
            self._bind(batch, written)
        words: Words = await self._flow.answer(batch)
        return words

    def _bind(self, source: Request | WordBatch, addresses: Iterable[int] | NDArray[Any]) -> None:
        """Bind a write to a guarded address to the current session, so that it ends with it.

        Raises:
            NotArmedError: if the program does not hold the lease any more.
        """
        if not self._guards:
            return
        for address in self._guards.keys() & {int(address) for address in addresses}:
            source.of_session = True
            refusal = self._guards[address].refusal(address)
            if refusal is not None:
                name = self._session.codec.names.get(address, "a word")
                where = f"write of {name} at 0x{address:0{self.gateway.address_digits}X}"
                raise NotArmedError(f"{where}: {refusal}", refusal.reason, refusal.instant)

    def _divisor(self, rate_hz: float | None, divisor: int | None) -> int:
        base = self.gateway.base_frequency_hz
        if rate_hz is None and divisor is None:
            return 1
        rate, lowest = asked_rate(rate_hz, divisor, base), base / LARGEST_DIVISOR
        if not lowest <= rate <= base:
            raise ArgumentError(f"a rate of {rate:g} Hz was asked for, expected {lowest:.3g} to {base:g} Hz")
        return round(base / rate)

    def _require(self, feature: Feature) -> None:
        if feature not in self.gateway.features:
            raise UnsupportedError(f"the gateway was built without {feature.words}")

    def _whole_address(self, address: int) -> int:
        where, highest = whole_number(address, "an address"), self._session.codec.highest_address
        if not 0 <= where <= highest:
            raise ArgumentError(f"address {where:#x} is not from 0 to {highest:#x}")
        return where

    def _whole_word(self, value: int) -> int:
        word, highest = whole_number(value, "a word"), self._session.codec.highest_word
        if not 0 <= word <= highest:
            raise ArgumentError(f"{word} does not fit in a word of {self.gateway.data_bits} bits (0 to {highest:#x})")
        return word

    def _whole_count(self, count: int) -> int:
        size = whole_number(count, "a number of words")
        if size < 1:
            raise ArgumentError(f"{size} words were asked for, at least 1 is needed")
        return size

    def _whole_block(self, address: int, count: int) -> tuple[int, int]:
        size, where = self._whole_count(count), self._whole_address(address)
        highest = self._session.codec.highest_address
        if where + size - 1 > highest:
            raise ArgumentError(f"{size} words from {where:#x} on would pass the last address, {highest:#x}")
        return where, size

    def _addresses(self, addresses: ArrayLike) -> NDArray[Any]:
        return wire.arrays.in_range(addresses, self._session.codec.highest_address, "address")

    def _words(self, values: ArrayLike) -> Words:
        arrays = wire.arrays
        words = arrays.in_range(values, self._session.codec.highest_word, "value")
        return words.astype(arrays.word_type(self._session.codec.info.data_digits))


def _sample_time(time: float) -> float:
    what = "the time of a sample with a timestamp is a number of seconds"
    return seconds_from(time, what, zero=True)


def check_mode(mode: SendImmediate) -> None:
    """Raise `ArgumentError` if `mode` is not a mode of send-immediate."""
    given: object = mode
    if not (isinstance(given, str) and given in _SEND_IMMEDIATE):
        raise ArgumentError(f"send-immediate is one of {', '.join(_SEND_IMMEDIATE)}, not {mode!r}")
