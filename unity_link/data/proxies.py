"""One signal as a typed value: `Readable`, `Writable`, or both.

A proxy remembers the newest value that it has seen, by whatever way: a read, a write, a group, a subscription. Of
samples it keeps only the batch that they came in, and decodes when it is asked.
"""

from __future__ import annotations

import contextlib
import math
import time
from typing import TYPE_CHECKING, Any, Generic, Never, cast

from typing_extensions import TypeVar

from unity_link.data.callbacks import Callback
from unity_link.data.feed import Registration
from unity_link.errors import AnswerLostError, ArgumentError, Sealed, missing, refusing
from unity_link.hardware import link_under
from unity_link.link.subscription import check_buffer

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Sequence

    from numpy.typing import NDArray

    from unity_link.data.batch import Batch
    from unity_link.data.feed import Feed
    from unity_link.data.robot import Robot
    from unity_link.hardware import Bus
    from unity_link.link.subscription import Overflow
    from unity_link.spec.model import Signal

T = TypeVar("T")
S = TypeVar("S", default=T)
"""Type of the values that a signal takes: an enumeration is written by names, too, and never read as one."""

BUFFER = 16_384
"""Samples that wait for a reader, as in `unity_link.Link.subscribe`."""


MOST_ROWS = 60
"""Signals that a notebook shows."""


class _Last(Generic[T]):
    """The last value of a signal that was seen, with each read or batch another one, and what is called for it."""

    __slots__ = ("at", "batch", "callbacks", "value")

    def __init__(self) -> None:
        self.callbacks: tuple[Callback[T], ...] = ()
        """Callbacks for values that differ from the one before."""
        self.value: T | None = None
        self.at = -math.inf
        """Instant by `time.monotonic`."""
        self.batch: Batch | None = None
        """Batch with the value, if the last one came in a batch."""


class Proxy(Sealed, Generic[T]):
    """A signal of a robot; `Readable`, `Writable`, `ReadWrite` and the ports of queues are.

    A copy of it is itself. Out of a pickle, which links do not go through, it has its path and unit alone.
    """

    __slots__ = ("_last", "_names", "bus", "link", "robot", "signal")

    def __init__(self, signal: Signal, robot: Robot, bus: Bus) -> None:
        self.signal = signal
        """Declaration of the signal in the spec."""
        self.robot = robot
        self.bus = bus
        """Bus that it is reached over: the link, or what a module puts before it."""
        self.link = link_under(bus)
        self._names: dict[int, Any] | None = None
        if signal.kind.enumeration is not None:
            known = robot.enumeration(signal.kind.enumeration)
            self._names = {int(member): member for member in known}
        self._last: _Last[T] = _Last()

    if not TYPE_CHECKING:  # A type checker refuses them by itself.

        def __getattr__(self, name: str) -> Any:
            raise _no_attribute(self, name)

        def __setattr__(self, name: str, value: object) -> None:
            if name == "value":
                written = f"`await {self.path}.set({value!r})` writes it"
                raise ArgumentError(f"{self.path}.value is what was seen last: {written}")
            super().__setattr__(name, value)

        def __eq__(self, other: object) -> Any:
            if isinstance(other, (bool, int, float, str)):
                _refuse_as_value(self)
            return True if self is other else NotImplemented

        __hash__ = object.__hash__

    def _called(self) -> str:
        return self.path

    def __reduce__(self) -> Any:
        return _alone, (self.signal, self._names)

    def is_alone(self) -> bool:
        """Return whether it comes out of a pickle and belongs to no robot."""
        return type(self) is Proxy

    @property
    def path(self) -> str:
        """Path from its robot: ``legs[2].coxa.cpos``."""
        return self.signal.path

    @property
    def id(self) -> str:
        """The name that the spec gives it for people and other systems."""
        return self.signal.id

    @property
    def unit(self) -> str:
        """The unit of its values; empty where they have none."""
        return self.signal.unit

    def __repr__(self) -> str:
        """Return the path, and the last value with its age."""
        unit = f" {self.unit}" if self.unit else ""
        seen = "never seen" if self.value is None else f"{self.value!r}{unit}, {self.age:.3g} s ago"
        return f"<{self.path}: {seen}>"

    def _repr_html_(self) -> str:
        """Return what is known of it as a table; it is not read for that."""
        return signals_table(self.path, [self])

    # What was seen

    @property
    def value(self) -> T | None:
        """The last value that was seen, by whatever way; None where there was none yet."""
        last = self._last
        # Read once: the link may live in another thread, and bring the next batch meanwhile.
        batch = last.batch
        return last.value if batch is None else self.scalars(batch[self][-1:])[0]

    @property
    def age(self) -> float:
        """Seconds since that value arrived, or was written; infinite where there was none yet."""
        return time.monotonic() - self._last.at

    def on_change(self, callback: Callable[[T], object]) -> Registration:
        """Call a function with the value whenever another one is seen than before.

        A signal that is published or polled is from now on, until `Registration.cancel`; any other one is seen when it
        is read or written. To be called where an event loop runs. What a callback raises is logged under
        ``unity_link.link``, the first exception of each type; that the link was lost, too, and that the gateway refused
        a read of one that is polled, which goes on at its next turn, or that one behind a server is away at the
        beginning, which is waited for.

        Raises:
            ArgumentError: for an asynchronous function.
        """
        made = Callback(callback, f"a callback of {self.path}")
        feed = self.feed()
        listening = feed.listen() if feed is not None else None
        self._last.callbacks = (*self._last.callbacks, made)
        return Registration(lambda: self._remove(made), listening)

    def _remove(self, callback: Callback[T]) -> None:
        callback.cancel()
        self._last.callbacks = tuple(other for other in self._last.callbacks if other is not callback)

    def feed(self) -> Feed | None:
        """Return the samples of the group that publishes or polls it; None where nothing does."""
        return None

    # Called by groups and subscriptions

    def scalars(self, values: NDArray[Any]) -> list[T]:
        """Make Python's values of an array of this signal's; shape (n,)."""
        numbers = values.tolist()
        if self._names is not None:
            names = self._names
            numbers = [names.get(number, number) for number in numbers]
        return cast("list[T]", numbers)

    def scalar(self, value: Any) -> T:
        """Return the member of its enumeration for a number that has a name; any other value as it is."""
        if self._names is None:
            return cast("T", value)
        return cast("T", self._names.get(int(value), int(value)))

    def see(self, value: T, at: float | None = None) -> None:
        """Keep a value as the last one, and call the handlers that wait for another one.

        Args:
            value: what was read or written.
            at: instant by `time.monotonic`; None for now.
        """
        last = self._last
        before = self.value if last.callbacks else None
        last.value, last.at, last.batch = value, time.monotonic() if at is None else at, None
        if not last.callbacks:
            return
        if value == before or (value != value and before != before):  # noqa: PLR0124  (NaN, twice)
            return
        for callback in last.callbacks:
            callback(value)


def _alone(signal: Signal, names: dict[int, Any] | None) -> Proxy[Any]:
    """Return a signal of no robot."""
    made: Proxy[Any] = object.__new__(Proxy)
    given: dict[str, Any] = {"signal": signal, "_names": names, "_last": _Last(), "_is_sealed": True}
    for name, value in given.items():
        object.__setattr__(made, name, value)
    return made


def signals_table(title: str, proxies: Sequence[Proxy[Any]]) -> str:
    """Return what is known of signals as a table in HTML; none is read for that."""
    from unity_link.link import html

    head = ("signal", "value", "unit", "seen", "access", "address", "description")
    return html.long_table(title, len(proxies), lambda place: _row(proxies[place]), head, most=MOST_ROWS)


def _row(proxy: Proxy[Any]) -> tuple[str, ...]:
    from unity_link.link import html

    signal = proxy.signal
    seen = "never" if proxy.value is None else f"{html.duration_text(proxy.age)} ago"
    value = html.value_text(proxy.value)
    return proxy.path, value, proxy.unit, seen, signal.access.name.lower(), f"{signal.address:#x}", signal.doc


def _refuse_as_value(proxy: Proxy[Any], *_: object) -> Never:
    raise ArgumentError(f"{proxy.path} is a signal and no value: `get` reads it, `{proxy.path}.value` was seen last")


_NAMES = "bool int float index lt le gt ge add radd sub rsub mul rmul truediv rtruediv neg abs round"
OPERATORS = tuple(f"__{name}__" for name in _NAMES.split())
"""Operators of values: who uses one on a signal has forgotten to read it."""
for _name in OPERATORS:
    setattr(Proxy, _name, _refuse_as_value)


def _no_attribute(proxy: Proxy[Any], name: str) -> AttributeError:
    """Return the error for an attribute that a signal does not have."""
    if name.startswith("_") or name == "signal":
        return AttributeError(name)
    if proxy.is_alone():
        return AttributeError(f"{proxy.path} is out of a pickle, without a link: it has no {name!r}")
    access = proxy.signal.access
    if name in ("set", "post", "append", "write") and not access.writes:
        return AttributeError(f"{proxy.path} can only be read: its spec says {access.name}")
    if name in ("get", "take", "samples", "read") and not access.reads:
        return AttributeError(f"{proxy.path} can only be written: its spec says {access.name}")
    return missing(proxy, name, proxy.path, read="`get` reads a signal", write="`set` writes a signal")


class SampledSignal(Proxy[T]):
    """A signal of which there are samples, where a group publishes or polls it."""

    __slots__ = ()

    if not TYPE_CHECKING:  # A type checker refuses it by itself.
        __iter__ = refusing("write `async for` over the samples of a signal, or make a blocking robot by `put`")

    def feed(self) -> Feed | None:
        """Return the samples of the group that publishes or polls it; None where nothing does."""
        group = self.robot.publishing_group(self)
        return None if group is None else group.feed

    def __aiter__(self) -> AsyncIterator[T]:
        """Iterate over its samples, as `samples` does."""
        return self.samples()

    async def samples(self, *, buffer: int = BUFFER, overflow: Overflow = "fail") -> AsyncIterator[T]:
        """Iterate over the values that its group publishes, or that the host polls.

        Args:
            buffer: most samples that wait for the loop's body.
            overflow: what happens when they are more: ``"fail"``, or ``"drop_oldest"``. Values alone do not show
                losses, so the default is not that of `Group.subscribe`.

        Raises:
            ArgumentError: where nothing publishes or polls it.
            SamplesLostError: where the loop's body is too slow.
            GatewayError: where the gateway refused a read of one that is polled, or one behind a server is away at the
                beginning; another loop begins anew.
            LinkLostError: when the link ends.
        """
        from unity_link.data.groups import nothing_publishes

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
        """Read it from the gateway; one of several words in one bus transaction."""
        signal = self.signal
        words = signal.words
        if words == 1:
            value = self.scalar(signal.decode(await self.bus.read(signal.address)))
        else:
            block = await self.bus.read_block(signal.address, words)
            value = self.scalar(signal.decode(block.tolist()))
        self.see(value)
        return value


class Writable(Proxy[T], Generic[T, S]):
    """A signal that can be written, of values `T`; it takes `S`, which is the same without a second argument."""

    __slots__ = ()

    async def set(self, value: S) -> None:
        """Write it; when this returns it is on the bus.

        One of several words is written in one bus transaction, and a field leaves the other bits of its word alone.

        Args:
            value: in the signal's unit, it goes to the nearest one that there is; an enumeration takes names too.

        Raises:
            ArgumentError: for a value outside of the limits, or that the kind cannot say. Nothing was sent.
            UnsupportedError: for a field, where the gateway was built without masked writes.
        """
        signal = self.signal
        words = signal.encode(cast("Any", value))
        if signal.is_field:
            for index, word in enumerate(words):
                mask = signal.mask >> (index * signal.word_bits) & ((1 << signal.word_bits) - 1)
                # It was executed then; only the old word was lost, which is not needed.
                with contextlib.suppress(AnswerLostError):
                    await self.bus.write_masked(signal.address + index, word, mask)
        elif len(words) == 1:
            await self.bus.write(signal.address, words[0])
        else:
            await self.bus.write_block(signal.address, words)
        self.see(self.scalar(signal.decode(words)))

    async def post(self, value: S) -> None:
        """Write it without waiting for the execution; errors are raised by the link's next `fence`.

        A field, and a value of several words, need an answer and are written as by `set`.

        Raises:
            ArgumentError: as by `set`.
        """
        signal = self.signal
        if signal.is_field or signal.words > 1:
            await self.set(value)
            return
        (word,) = signal.encode(cast("Any", value))
        await self.bus.post(signal.address, word)
        self.see(self.scalar(signal.decode(word)))

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest value that it takes, in its unit."""
        return self.signal.limits


class ReadWrite(Readable[T], Writable[T, S]):
    """A signal that can be read and written."""

    __slots__ = ()
