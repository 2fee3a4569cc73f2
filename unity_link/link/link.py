"""Layer 2, message link: what a program holds of one gateway.

`Link` checks what it is asked for, makes requests of it, and waits for their futures. `connection` is its life,
`flow` moves the requests, `subscription` the publishes; this module joins them.
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
from unity_link.link.runtimes.runtime import told_now
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
"""Words that one call reads from a queue, whose length no address bounds."""
SendImmediate = Literal["off", "always", "adaptive"]
_SEND_IMMEDIATE: dict[str, int] = {"off": 0, "always": 1, "adaptive": 2}


class Statistics(msgspec.Struct, frozen=True, kw_only=True):
    """Counters of a link since it was opened."""

    requests: int
    """Requests sent, repetitions not counted."""
    responses: int
    """Responses that a request waited for."""
    in_flight: int
    """Requests sent and not answered yet."""
    repetitions: int
    """Requests sent again."""
    timeouts: int
    """Number of repetitions that were due to silence."""
    errors: int
    """Responses that were errors of the bus or out of range."""
    damaged_frames: int
    """Frames that arrived with a wrong CRC."""
    stray_frames: int
    """Sound frames that nothing waited for."""
    bytes_sent: int
    """Bytes handed to the medium."""
    bytes_received: int
    """Bytes that came from the medium."""
    samples: int
    """Samples that arrived."""
    samples_lost: int
    """Samples that the gateway took and that did not arrive, or that no reader was quick enough for."""
    reconnections: int
    """Connections that were opened again."""
    round_trip: float | None
    """Smoothed round trip in seconds."""

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __getattr__ = missing_attribute("the statistics of a link")

    def _repr_html_(self) -> str:
        """Return the numbers as a table."""
        from unity_link.link import html

        return html.table("statistics of a link", html.statistics_rows(self))


class Link(OfLink, Connection):
    """A connection to one gateway; made by `connect`.

    Any number of tasks may use it at once. Requests are executed exactly once, and in the order of the calls; blocks
    and batches of several tasks take turns. Cancelling a call leaves all others as they are; a write that was cancelled
    may or may not have been executed.

    Every call may raise `UnansweredError`, most often a `LinkLostError`, and `BusError` and `BusTimeoutError`.
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
        """Failed posts that nobody was told of, the oldest first: of each task, and under None of those that are over.
        """
        self._guards: dict[int, Guard] = {}
        """Leases under which the program writes, by the addresses that they guard."""
        self._explanations: dict[int, Callable[[BusError], Awaitable[BusError]]] = {}
        """Functions that return the error with the reason for a refused posted write, by the addresses of signals."""
        self.told_by_fence: dict[int, Any] = {}
        """Writers in the gateway's own time, each with `see` and `drop_answers`, by their addresses.

        A fence raises their errors.
        """

    # Life

    def _happened(self, event: UnsolicitedEvent) -> None:
        if isinstance(event, GroupEvent):
            self._publishing.take(event)
        elif isinstance(event, PostedFailure):
            self._note_posted(event)
        else:
            self._take_change(event)

    def _begin(self, codec: HostCodec) -> None:
        # Where both sides share a pair of wires, each must know when its turn is.
        self._takes_turns = Feature.HALF_DUPLEX in codec.info.features
        self._publishing.start(codec)
        self._left_open = self._left_open or LeftOpen(self._warn_of_left_open)
        codec.refusal = self._refusal

    def _refusal(self) -> str:
        stream = self._flow.stream
        return "" if stream is None else stream.refusal

    def name_addresses(self, names: Mapping[int, str]) -> None:
        """Name addresses, for errors to call them by; a robot does so for its signals."""
        self._session.codec.names.update(names)

    def explain_refusals(self, explanations: Mapping[int, Callable[[BusError], Awaitable[BusError]]]) -> None:
        """Register what explains bus errors of posted writes, by addresses; a robot registers signals under leases."""
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
        """Close; where the block ended well, not before the posted writes are executed, and with their errors.

        A gateway that is away is not waited for: what is not known of posted writes is then one of their errors. The
        first error is raised, and has those behind it as notes: nobody is told of them later.
        """
        try:
            if error is None and (self._posted or self._posted_failures or self.told_by_fence):
                if self.connected:
                    with contextlib.suppress(LinkLostError):
                        await self._fence(leaving=True)
                # A program that closes its link in the block knows that it gives up what is under way.
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
        """Return where it leads, and whether there is a connection now."""
        state = "connected" if self.connected else "closed" if self._closed else "not connected"
        return f"<link to {self._name}, {state}>"

    def _repr_html_(self) -> str:
        """Return the same, what the gateway is, and the statistics, as a table."""
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
        # Also a number that is no `int`, as numpy's, may be right.
        if type(address) is not int or not 0 <= address <= codec.highest_address:
            address = self._whole_address(address)
        request = Request(codec, "R", codec.fields("R", address), codec.data_digits)
        # As `answer` would: this is the most frequent call.
        waiter = flow.ask(request)
        try:
            word: int = await waiter
        except BaseException:
            request.cancel()
            raise
        return word

    async def write(self, address: int, value: int) -> None:
        """Write `value` to `address`; when this returns it is on the bus."""
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
        """Replace the bits of a word that are 1 in `mask` by those of `value`, atomically.

        Returns:
            The whole word as it was before.

        Raises:
            UnsupportedError: where the gateway was built without masked write.
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
        """Send a write without waiting for its execution; waits only while too many requests are under way.

        It is executed exactly once and in order all the same. Its errors are raised by the next `fence` of the task
        that calls `post`, or where the ``async with`` block of the link ends. On a half-duplex medium each write is
        answered, and this returns then.
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
        """Wait until everything that was asked for before has been executed.

        It raises the errors of writes that the task which calls `fence` has posted (on blocking links: the thread), and
        those of tasks that are over; under `asyncio.wait_for` and `asyncio.gather`, too, which run the coroutine in a
        task of its own. What other tasks have posted is left to their fences, and to the end of the block.

        Raises:
            UnityLinkError: the first error of these writes that nobody was told of; or, of their writes at instants
                that are not awaited, the one of the first that is known not to have acted. Those to come are not waited
                for.
        """
        return self._fence_for(self._caller())

    async def _fence_for(self, caller: object) -> None:
        self._posted = False
        is_told = told_now(self._runtime, caller)
        try:
            await self._fence(leaving=False)
        except LinkLostError as lost:
            # What is known of the posted writes says more than what is known of the fence.
            raise self._take_posted(is_told) or lost from None
        except BaseException:
            self._posted = True
            raise
        await self._raise_errors(is_told)

    async def _fence(self, *, leaving: bool) -> None:
        await self._flow.answer(Fence(self._session.codec, of_session=leaving))

    async def _ping(self) -> None:
        """Ask the gateway for an answer, which changes nothing.

        Raises:
            BusTimeoutError: where a server answers, whose gateway is away.
        """
        await self._flow.answer(Confirmation(self._session.codec, of_session=True))

    async def _raise_errors(self, is_told: Callable[[object], bool]) -> None:
        if self._posted_failures:
            await self._raise_posted(is_told)
        for writer in tuple(self.told_by_fence.values()):
            await writer.see(is_told, is_connected=self.connected)

    async def _raise_all(self) -> None:
        """Raise the first error of all, with the others as notes."""
        errors: list[UnityLinkError] = []

        def told(_: object) -> bool:
            return True

        try:
            await self._raise_posted(told)
        except UnityLinkError as error:
            errors.append(error)
        for writer in tuple(self.told_by_fence.values()):
            try:
                await writer.see(told, is_connected=self.connected)
            except UnityLinkError as error:
                errors.append(error)
        if errors:
            first, *others = errors
            for other in others:
                first.add_note(str(other))
            raise first

    async def _raise_posted(self, is_told: Callable[[object], bool]) -> None:
        """Raise the first error of the posted writes of those who are told now, and why a lease has it refused."""
        error = self._take_posted(is_told)
        if error is None:
            return
        if isinstance(error, BusError) and error.address in self._explanations:
            with contextlib.suppress(UnityLinkError):
                explained = await self._explanations[error.address](error)
                explained.__notes__ = getattr(error, "__notes__", [])
                error = explained
        raise error

    def _take_posted(self, is_told: Callable[[object], bool]) -> UnityLinkError | None:
        """Return the first error of the posted writes of those who are told now, and forget it; None without one."""
        failures = self._posted_failures
        told = [failures.pop(poster) for poster in tuple(failures) if is_told(poster)]
        if not told:
            return None
        first, count = told[0].error, sum(failure.writes for failure in told)
        if count > 1:
            first.add_note(f"{count - 1} more posted writes failed as well")
        return first

    def _note_posted(self, failure: PostedFailure) -> None:
        """Keep the first error of the writes that a task has posted since it was told, and count how many failed."""
        if failure.poster not in self._posted_failures:
            # Tasks come and go: all that are over count as one.
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

        The gateway reads at most ``gateway.block_words`` words in one atomic bus transaction, over UDP at most as many
        as a datagram holds; a longer block is read in several, each atomic, in the order of the addresses.

        Returns:
            The words, shape (count,), as the smallest unsigned type that holds one.
        """
        where, size = self._whole_block(address, count)
        return await self._read_words("RM", where, size, step=1)

    async def read_queue(self, address: int, count: int) -> Words:
        """Read the same address `count` times, 2 ** 24 at most: a FIFO port. Like `read_block` otherwise."""
        self._require(Feature.QUEUE_COMMANDS)
        where, size = self._whole_address(address), self._whole_count(count)
        if size > MOST_QUEUE_WORDS:
            raise ArgumentError(f"{size} words of a queue were asked for, one call reads {MOST_QUEUE_WORDS} at most")
        return await self._read_words("RQ", where, size, step=0)

    async def write_block(self, address: int, values: ArrayLike) -> None:
        """Write consecutive words from `address` on, in atomic transactions as large as those of `read_block`."""
        words = self._words(values)
        where, _ = self._whole_block(address, len(words))
        await self._write_words("WM", where, words, step=1)

    async def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write all `values` to the same address: a FIFO port. Like `write_block` otherwise."""
        self._require(Feature.QUEUE_COMMANDS)
        words = self._words(values)
        where = self._whole_address(address)
        self._whole_count(len(words))
        await self._write_words("WQ", where, words, step=0)

    # Batches

    async def read_many(self, addresses: ArrayLike) -> Words:
        """Read many words in one pipelined batch, each a request of its own.

        Returns:
            The words in the order of `addresses`, as the smallest unsigned type that holds one.

        Raises:
            GatewayError: the first error; the other reads are done all the same.
        """
        where = self._addresses(addresses)
        return await self._batch("R", (where, self.gateway.address_digits))

    async def write_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write one word to each of many addresses, in order, in one pipelined batch.

        Raises:
            GatewayError: the first error; the other writes are done all the same.
        """
        where, what = self._write_arguments(addresses, values)
        info = self.gateway
        await self._batch("W", (where, info.address_digits), (what, info.data_digits), written=where)

    @returns_coroutine
    def post_many(self, addresses: ArrayLike, values: ArrayLike) -> Coroutine[Any, Any, None]:
        """Send many writes as `post` does; returns when the last one is sent.

        The quickest way to write words that lie apart: nothing but the requests is on the line.
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
        """Return the gateway's own timestamp of a sample's time, in ticks of ``gateway.clock_hz`` modulo 2 ** 32.

        Raises:
            ArgumentError: for what is no finite number of seconds, or a time of before the last reset of the gateway.
        """
        return self._publishing.clock.timestamp(_sample_time(time))

    def age_of(self, time: float) -> float:
        """Return how long ago a sample's time was, in seconds, from 0 on; exact to the jitter of the line.

        Raises:
            ArgumentError: for what is no finite number of seconds.
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
        """Subscribe to addresses that the gateway samples by itself, all in one atomic bus transaction.

        Args:
            addresses: one address, or up to ``gateway.group_words``.
            rate_hz: samples a second; the nearest rate that the gateway has is `Subscription.rate_hz`.
            divisor: the same as a division of ``gateway.base_frequency_hz``, 1 to 65535.
            trigger: sample on the group's external trigger; ``group`` says which.
            on_change: publish only samples in which a word has changed.
            immediate: have the gateway send each sample at once instead of filling packets.
            timestamps: have the instant of sampling sent along; None: where the gateway can.
            group: number of the group, for each has a trigger of its own; None: one that is free.
            buffer: most samples that wait for the reader. The default holds all that one read of a socket can bring.
            latest: keep the newest sample alone, for a controller. Of samples at a rate, those of before a pause of the
                program or the line are lost, and counted.
            overflow: what happens when they are more: ``"drop_oldest"`` and count, or ``"fail"``.
            callback: is called with each sample as it arrives, in place of iteration. What it raises is logged under
                ``unity_link.link`` and stops nothing: the first exception of each type.

        Without a rate, a divisor or a trigger, samples come when `Subscription.publish` asks for them.

        Raises:
            ArgumentError: for rates, addresses or sizes that the gateway does not have.
            UnsupportedError: where the gateway was built without what is asked for, or the group, or all, are in use.
            OutOfRangeError: when the block is entered, where the gateway refuses the group: for a rate on a half-duplex
                medium, or while other programs have all groups of a shared gateway.
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
            mode: ``"off"``; ``"always"``, after every response; or ``"adaptive"``, when nothing more is waiting.

        Raises:
            UnsupportedError: where the gateway was built without it.
        """
        check_mode(mode)
        self._require(Feature.SEND_IMMEDIATE)
        await self._ask("I", _SEND_IMMEDIATE[mode])
        if self._flow.stream is not None:
            await self._flow.stream.choose_send_immediate(mode)

    # The inside

    async def _ask(self, command: str, *values: object) -> None:
        """Execute a request that is answered by an acknowledgement."""
        codec = self._session.codec
        await self._flow.answer(Request(codec, command, codec.fields(command, *values), 0))

    async def _sent(self, posted: Request | WordBatch) -> None:
        """Wait until posted writes have found room."""
        posted.waiter = waiter = self._flow.create_future()
        if posted.done:
            posted.settle()
        try:
            await waiter
        except BaseException:
            posted.cancel()
            raise

    async def _post_answered(self, posted: Request | WordBatch, poster: object) -> None:
        """Execute writes that are answered, and keep their errors as those of posted ones."""
        try:
            await self._flow.answer(posted)
        except UnityLinkError as error:
            self._note_posted(PostedFailure(error, 1, poster))

    async def _read_words(self, command: str, address: int, count: int, step: int) -> Words:
        # Imported here, not in the callback that takes the answer.
        arrays = wire.arrays
        codec, info = self._session.codec, self.gateway
        requests: list[Request] = []
        most = self._flow.block_words
        for start in range(0, count, most):
            part = min(most, count - start)
            fields = codec.fields(command, address + step * start, part)
            if command == "RQ":
                requests.append(DestructiveRead(codec, command, fields, part))
            else:
                requests.append(Request(codec, command, fields, part * info.data_digits))
        return arrays.joined(await self._all(requests))

    async def _read_blocks(self, blocks: Sequence[range]) -> Words:
        """Return the words of blocks of addresses, each read in one bus transaction, in one array."""
        arrays = wire.arrays
        codec, digits = self._session.codec, self.gateway.data_digits
        requests = [
            Request(codec, "RM", codec.fields("RM", block.start, len(block)), len(block) * digits) for block in blocks
        ]
        return arrays.joined(await self._all(requests))

    def _begin_block(
        self, address: int, count: int, write: Sequence[int], *, to_queue: bool
    ) -> tuple[Waiter, Callable[[], None]]:
        """Ask for a read, or a write, of one transaction; return its answer, and what gives it up.

        A write ends with its session: it belongs to something that a reset ends, as a lease.
        """
        codec = self._session.codec
        if write:
            command = "WQ" if to_queue else "WM"
            if to_queue:
                self._require(Feature.QUEUE_COMMANDS)
            request = Request(codec, command, codec.fields(command, address, self._words(write)), 0, of_session=True)
            self._bind(request, (address,) if to_queue else range(address, address + len(write)))
        else:
            # Imported here, not in the callback that takes the answer.
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
        """Execute requests in order, and return their answers; if one fails, the rest is not waited for."""
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
        """End a write to a guarded address with the session under way.

        Raises:
            NotArmedError: if the lease is over for the program.
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
    """Raise ArgumentError for a mode of send-immediate that is none."""
    given: object = mode
    if not (isinstance(given, str) and given in _SEND_IMMEDIATE):
        raise ArgumentError(f"send-immediate is one of {', '.join(_SEND_IMMEDIATE)}, not {mode!r}")
