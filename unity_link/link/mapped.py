"""Layer 2 without frames: a link to a bus that is mapped into memory.

Each word of a call is one bus access, made within the call. There are no requests in flight, so there are no
retransmissions and no answers. Subscriptions are polled by timers of the host.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from unity_link.errors import ConnectError, LinkClosedError, LinkLostError, Outcome, UnsupportedError
from unity_link.link.link import Link, SendImmediate, check_mode
from unity_link.link.publishing import Publishing, Sample, SampleReceiver
from unity_link.protocol import wire
from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.transport import name_of, open_bus

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike

    from unity_link.link.runtimes.runtime import Runtime, Timer, Waiter
    from unity_link.protocol.wire.arrays import Words
    from unity_link.protocol.wire.configuration import Feature, GatewayInfo
    from unity_link.transport import DriverUrl, MemoryBus, WordsByAddress

TURN = 256
"""Number of accesses after which a call lets other tasks run; the accesses themselves do not wait."""
_EARLY = 1e-6
"""Fraction of a period by which a timer may fire early."""


class MappedLink(Link):
    """A link to a bus that is mapped into memory, made by `connect`.

    Calls and arguments are those of `Link`, with these differences: the words of a block are accessed one by one; a
    masked write is a read and a write; an access that the bus refuses ends the program with a signal of the system.
    """

    def __init__(self, target: DriverUrl, runtime: Runtime) -> None:
        super().__init__(target, None, runtime=runtime)
        self._url = target
        self._words_at: WordsByAddress = _CLOSED
        self._bus: MemoryBus | None = None
        self._left = TURN
        self._publishing: Polling

    # Opening and closing

    async def open(self, timeout: float) -> None:  # noqa: ARG002  (as a link's; this one does not wait)
        """Map the bus.

        Raises:
            ConnectError: if it cannot be mapped.
        """
        try:
            self._bus = bus = open_bus(self._url)
        except ConnectError as error:
            raise ConnectError(f"{name_of(self._url)}: {error}") from error
        self.gateway = bus.info
        self._words_at = bus.words
        self._publishing = Polling(self._runtime, bus, self._name)
        self._session.codec = codec = HostCodec(bus.info, None)
        self._begin(codec)
        codec.highest_address = len(bus.words) - 1

    def _ended(self, error: LinkLostError) -> None:
        self._words_at = _CLOSED
        super()._ended(error)
        if self._bus is not None:
            self._bus.close()

    @property
    def epoch(self) -> int:
        """Number of the session, always 0."""
        return 0

    @property
    def connected(self) -> bool:
        """True if the bus is mapped."""
        return self._words_at is not _CLOSED

    async def _done(self, accesses: int) -> None:
        """Count accesses, and let other tasks run after `TURN` of them."""
        counters = self._session.counters
        counters.requests += accesses
        counters.responses += accesses
        self._left -= accesses
        if self._left <= 0:
            self._left = TURN
            await self._runtime.sleep(0)

    def _require(self, feature: Feature) -> None:
        if feature not in self.gateway.features:
            raise UnsupportedError(f"mapped memory has no {feature.words}")

    async def send_immediate(self, mode: SendImmediate) -> None:
        """Check the mode; it has no effect, because no answer is delayed."""
        check_mode(mode)
        self._check_open()

    # Words

    async def read(self, address: int) -> int:
        """Read the word at `address`."""
        if type(address) is not int or not 0 <= address <= self._session.codec.highest_address:
            address = self._whole_address(address)
        word = self._words_at[address]
        await self._done(1)
        return word

    async def write(self, address: int, value: int) -> None:
        """Write `value` to `address`."""
        if type(address) is not int or not 0 <= address <= self._session.codec.highest_address:
            address = self._whole_address(address)
        if type(value) is not int or not 0 <= value <= self._session.codec.highest_word:
            value = self._whole_word(value)
        self._words_at[address] = value
        await self._done(1)

    async def write_masked(self, address: int, value: int, mask: int) -> int:
        """Replace bits of a word by a read and a write; another bus master may access the word in between."""
        where, what, bits = self._whole_address(address), self._whole_word(value), self._whole_word(mask)
        words = self._words_at
        before = words[where]
        words[where] = before & ~bits | what & bits
        await self._done(2)
        return before

    async def _post_for(
        self,
        poster: object,  # noqa: ARG002  (no post can fail later)
        address: int,
        value: int,
        *,
        of_session: bool = False,  # noqa: ARG002  (a bus has none)
    ) -> None:
        await self.write(address, value)

    async def _fence(self, *, leaving: bool) -> None:  # noqa: ARG002  (a bus has no sessions)
        self._check_open()

    async def _ping(self) -> None:
        self._check_open()

    # Many

    async def read_block(self, address: int, count: int) -> Words:
        """Read `count` consecutive words from `address` on, one by one."""
        where, size = self._whole_block(address, count)
        return await self._read_each(range(where, where + size))

    async def read_queue(self, address: int, count: int) -> Words:
        """Read the same address `count` times."""
        where, size = self._whole_address(address), self._whole_count(count)
        return await self._read_each([where] * size)

    async def read_many(self, addresses: ArrayLike) -> Words:
        """Read many words."""
        where = self._addresses(addresses)
        self._whole_count(len(where))
        return await self._read_each(where.tolist())

    async def write_block(self, address: int, values: ArrayLike) -> None:
        """Write consecutive words from `address` on, one by one."""
        words = self._words(values)
        where, size = self._whole_block(address, len(words))
        await self._write_each(range(where, where + size), words)

    async def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write all `values` to the same address."""
        words = self._words(values)
        where, size = self._whole_address(address), self._whole_count(len(words))
        await self._write_each([where] * size, words)

    async def write_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write one word to each of many addresses, in order."""
        where, what = self._write_arguments(addresses, values)
        self._whole_count(len(where))
        await self._write_each(where.tolist(), what)

    async def _post_many_for(self, poster: object, addresses: ArrayLike, values: ArrayLike) -> None:  # noqa: ARG002
        await self.write_many(addresses, values)

    async def _read_blocks(self, blocks: Sequence[range]) -> Words:
        """Read blocks of words, one word after the other."""
        return await self._read_each([address for block in blocks for address in block])

    def _begin_block(
        self, address: int, count: int, write: Sequence[int], *, to_queue: bool
    ) -> tuple[Waiter, Callable[[], None]]:
        """Read or write words within this call; return a future that is done."""
        words = self._words_at
        for index, word in enumerate(write):
            words[address if to_queue else address + index] = word
        answer = None if write else [words[address + index] for index in range(count)]
        waiter = self._runtime.create_future()
        waiter.set_result(answer)
        return waiter, lambda: None

    async def _read_each(self, addresses: range | list[int]) -> Words:
        found: list[int] = []
        for start in range(0, len(addresses), TURN):
            words = self._words_at
            part = [words[address] for address in addresses[start : start + TURN]]
            found += part
            await self._done(len(part))
        return self._publishing.array(found)

    async def _write_each(self, addresses: range | list[int], values: Words) -> None:
        given = values.tolist()
        for start in range(0, len(given), TURN):
            words = self._words_at
            part = given[start : start + TURN]
            for address, value in zip(addresses[start : start + TURN], part, strict=True):
                words[address] = value
            await self._done(len(part))

    def _check_open(self) -> None:
        if not self.connected:
            raise _closed()


def _closed() -> LinkClosedError:
    return LinkClosedError("the link was closed", Outcome.NOT_EXECUTED)


class _Closed:
    """The words of a closed link; every access raises `LinkClosedError`."""

    def __len__(self) -> int:
        return 0

    def __getitem__(self, address: int, /) -> int:
        raise _closed()

    def __setitem__(self, address: int, value: int, /) -> None:
        raise _closed()


_CLOSED = _Closed()


class Polling(Publishing):
    """The subscriptions of a mapped link, whose words the host reads by timers.

    The time of a sample is the host's clock at the instant of reading.

    Args:
        runtime: runtime of the link.
        bus: bus of the link.
        name: name of the bus, for the log.
    """

    def __init__(self, runtime: Runtime, bus: MemoryBus, name: str) -> None:
        # `Publishing.__init__` is not called: it needs a session, and this class overrides the methods that use one.
        self.name = name
        self.samples = self.samples_lost = 0
        self.runtime = runtime
        self._bus = bus
        self._words: WordsByAddress = bus.words
        self._polled: set[_PolledGroup] = set()

    @property
    def epoch(self) -> int:
        """Number of the session, always 0."""
        return 0

    @property
    def info(self) -> GatewayInfo:
        """Configuration of the bus, as far as it is known."""
        return self._bus.info

    def start(self, codec: HostCodec) -> None:
        """Do nothing, because polling needs no session."""

    def end(self, error: LinkLostError) -> None:
        """End all subscriptions."""
        self._words = _CLOSED
        for group in tuple(self._polled):
            self._polled.discard(group)
            group.end()
            group.receiver.fail(error)

    async def hold(self, receiver: SampleReceiver) -> _PolledGroup:
        """Begin to poll for a subscription."""
        if self._words is _CLOSED:
            raise _closed()
        group = _PolledGroup(self, receiver)
        self._polled.add(group)
        group.begin()
        return group

    async def release(self, group: Any) -> None:
        """Stop polling for a subscription."""
        self._polled.discard(group)
        group.end()

    async def publish(self, group: Any) -> None:
        """Take one sample now."""
        group.sample()

    def read(self, addresses: tuple[int, ...]) -> list[int]:
        """Read the words at some addresses, one by one, and return them."""
        words = self._words
        return [words[address] for address in addresses]

    def array(self, words: list[int]) -> Words:
        """Return words as an array of the smallest unsigned type for a word."""
        return wire.arrays.of_words(words, self._bus.info.data_digits)


class _PolledGroup:
    """The polled words of one subscription. Samples that the host was too late to take count as lost."""

    def __init__(self, polling: Polling, receiver: SampleReceiver) -> None:
        self.receiver = receiver
        self._polling = polling
        self._schedule = receiver.schedule
        self._period = self._schedule.divisor / polling.info.base_frequency_hz
        self._now = polling.runtime.time
        self._began = 0.0
        self._ticks = 0
        """Number of periods that have passed."""
        self._sequence = -1
        self._missed = 0
        """Number of periods without a sample since the last sample."""
        self._last: list[int] | None = None
        self._timer: Timer | None = None

    def begin(self) -> None:
        """Start the timer, if the subscription is periodic."""
        self._began = self._now()
        if GroupFlag.PERIODIC in self._schedule.flags:
            self._plan()

    def end(self) -> None:
        """Stop the timer."""
        if self._timer is not None:
            self._timer.cancel()

    def _plan(self) -> None:
        due = self._began + (self._ticks + 1) * self._period
        self._timer = self._polling.runtime.call_at(due, self._tick)

    def _tick(self) -> None:
        passed = max(self._ticks + 1, int((self._now() - self._began) / self._period + _EARLY))
        missed, self._ticks = passed - self._ticks - 1, passed
        self._plan()
        if GroupFlag.ON_CHANGE in self._schedule.flags:
            words = self._polling.read(self._schedule.addresses)
            if words != self._last:
                self._publish(words)
        else:
            self._missed += missed
            self.sample()

    def sample(self) -> None:
        """Read the words, and pass them to the receiver as a sample."""
        self._publish(self._polling.read(self._schedule.addresses))

    def _publish(self, words: list[int]) -> None:
        self._last = words
        lost, self._missed = self._missed, 0
        self._sequence += 1 + lost
        instant = self._now() if GroupFlag.TIMESTAMP in self._schedule.flags else None
        array, epoch = self._polling.array(words), self._polling.epoch
        self.receiver.keep(Sample(self._sequence, instant, time.time(), array, lost, epoch))
