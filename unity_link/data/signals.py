"""Signals that can be read, written, or both. Readable signals are sampled with their group."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, Protocol, overload

from unity_link.data.proxies import BUFFER, Owner, Proxy, S, T, nothing_publishes, refusal
from unity_link.errors import BusError, UnsupportedError, refusing
from unity_link.link.calls import returns_coroutine
from unity_link.link.subscription import check_buffer
from unity_link.modules import caller_on, post_for
from unity_link.protocol.wire.configuration import Feature
from unity_link.spec import Effect

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine
    from typing import Any

    from unity_link.cores.clock import Instant
    from unity_link.cores.timeline import Done
    from unity_link.data.feed import Feed
    from unity_link.data.groups import Group
    from unity_link.link.publishing import Overflow


class SamplingOwner(Owner, Protocol):
    """A robot that can have its signals sampled."""

    def publishing_group(self, proxy: Proxy[Any]) -> Group | None:
        """Return the group with which the gateway or the host samples a signal; None if the spec has it in none."""


class SampledSignal(Proxy[T]):
    """A readable signal, which has samples if a group publishes it or the host polls it."""

    __slots__ = ()
    robot: SamplingOwner

    if not TYPE_CHECKING:  # A type checker reports this by itself.
        __iter__ = refusing("write `async for` over the samples of a signal, or make a blocking robot by `put`")

    def feed(self) -> Feed | None:
        """Return the feed of the group that publishes or polls the signal; None if the spec has it in none."""
        group = self.robot.publishing_group(self)
        return None if group is None else group.feed

    def _listen(self) -> tuple[Callable[[], None], ...]:
        feed = self.feed()
        return () if feed is None else (feed.listen().leave,)

    def __aiter__(self) -> AsyncIterator[T]:
        """Iterate over the signal's samples; see `samples`."""
        return self.samples()

    async def samples(self, *, buffer: int = BUFFER, overflow: Overflow = "fail") -> AsyncIterator[T]:
        """Iterate over the values that the signal's group publishes, or that the host polls.

        Args:
            buffer: most samples that wait for the loop's body.
            overflow: what to do with more samples: ``"fail"``, or ``"drop_oldest"``. Values alone do not show losses,
                so the default differs from that of `Group.subscribe`.

        Raises:
            ArgumentError: if the spec neither publishes nor polls the signal.
            SamplesLostError: if the loop's body is too slow.
            GatewayError: if the gateway refused a polled read, or is behind a server and away at the beginning. A new
                loop begins again.
            LinkLostError: if the link ends.
        """
        feed = self.feed()
        if feed is None:
            raise nothing_publishes([self])
        with feed.listen(buffer=check_buffer(buffer, overflow), overflow=overflow) as listener:
            while True:
                for value in self.scalars((await listener.next())[self]):
                    yield value


class Readable(SampledSignal[T]):
    """A signal that can be read."""

    __slots__ = ()

    async def get(self) -> T:
        """Read the signal; if it has several words, in one bus transaction.

        A signal that each read clears is read exactly once, whatever the line loses, so no event is lost with an
        answer.

        Raises:
            UnsupportedError: for a signal that each read clears, if the gateway was built without queue commands.
        """
        signal = self.signal
        words = signal.words
        if signal.effect is Effect.CLEAR_ON_READ:
            if Feature.QUEUE_COMMANDS not in self.bus.gateway.features:
                message = "is cleared by each read, which takes the queue commands that the gateway was built without"
                raise UnsupportedError(f"{signal.path} {message}")
            value = self.scalar(signal.decode(int((await self.bus.read_queue(signal.address, 1))[0])))
        elif words == 1:
            value = self.decode(await self.bus.read(signal.address))
        else:
            block = await self.bus.read_block(signal.address, words)
            value = self.decode(block.tolist())
        self.see(value)
        return value


class Writable(Proxy[T], Generic[T, S]):
    """A signal of values of type `T` that can be written; writes accept the type `S`, by default the same."""

    __slots__ = ()

    @overload
    def set(self, value: S) -> Coroutine[Any, Any, None]: ...
    @overload
    def set(self, value: S, *, at: Instant) -> Coroutine[Any, Any, Done]: ...
    @returns_coroutine
    def set(self, value: S, *, at: Instant | None = None) -> Coroutine[Any, Any, Done | None]:
        """Write a value, and wait until the write has been executed on the bus. With `at`, schedule the write.

        A value of several words is written in one bus transaction. Writing a field does not change the other bits of
        its word. Writing a signal that is cleared by ones clears the bits that are 1.

        Args:
            value: in the signal's unit, rounded to the nearest value possible; an enumeration accepts names, too.
            at: instant of the gateway's clock for the write, later than those given before; only for `TIMED` signals.

        Returns:
            With `at`, an object that can be awaited until the write has been executed: it returns the instant, or
            raises `LateError`. If it is not awaited, the next such `set` of the same task, or its next `fence`, raises
            the error.

        Raises:
            ArgumentError: for a value outside of the limits, or one that the kind cannot represent; nothing was sent.
                With `at`, also for a signal that is not timed, and while a timeline feeds its schedule.
            NotArmedError: if a lease guards the signal and is not armed; nothing was written.
            UnsupportedError: for a field, if the gateway was built without masked writes.
        """
        if at is not None:
            from unity_link.cores.timeline import set_at

            return set_at(caller_on(self.link), self, value, at)
        return self._set(value)

    async def _set(self, value: S) -> None:
        words = self.encode(value)
        try:
            await self._write(words)
        except BusError as error:
            raise await refusal(error, [self]) from None
        self.see_written(words)

    async def _write(self, words: tuple[int, ...]) -> None:
        signal = self.signal
        if signal.is_field:
            for index, word in enumerate(words):
                mask = signal.mask >> (index * signal.word_bits) & ((1 << signal.word_bits) - 1)
                await self.bus.write_masked(signal.address + index, word, mask)
        elif len(words) == 1:
            await self.bus.write(signal.address, words[0])
        else:
            await self.bus.write_block(signal.address, words)

    @returns_coroutine
    def post(self, value: S) -> Coroutine[Any, Any, None]:
        """Write a value without waiting for its execution. The next `fence` of the calling task raises errors.

        A field, and a value of several words, need an answer: they are written as by `set`.

        Raises:
            ArgumentError: as by `set`.
        """
        signal = self.signal
        return self._set(value) if signal.is_field or signal.words > 1 else self._post(caller_on(self.link), value)

    async def _post(self, poster: object, value: S) -> None:
        (word,) = self.encode(value)
        await post_for(poster, self.bus, self.signal.address, word)
        self.see_written((word,))

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest value that writes accept, in the signal's unit."""
        return self.signal.limits


class ReadWrite(Readable[T], Writable[T, S]):
    """A signal that can be read and written."""

    __slots__ = ()
