"""One signal of a robot, its last value and its callbacks; `signals` has those that can be read or written.

A proxy remembers the newest value that it has seen, by whatever way: a read, a write, a group, a subscription. Of
samples it keeps only the batch that they came in, and decodes when it is asked.
"""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Never, Protocol, cast

from typing_extensions import TypeVar

from unity_link.data.callbacks import Callback, Registration
from unity_link.data.laps import Laps
from unity_link.errors import ArgumentError, Sealed, missing
from unity_link.modules import link_under

if TYPE_CHECKING:
    import enum
    from collections.abc import Callable, Iterable, Sequence

    from numpy.typing import NDArray

    from unity_link.errors import BusError
    from unity_link.modules import Bus
    from unity_link.spec.kinds import Enumeration
    from unity_link.spec.model import Interface, Signal

T = TypeVar("T")
S = TypeVar("S", default=T)
"""Type of the values that a signal takes: an enumeration is written by names, too, and never read as one."""

BUFFER = 16_384
"""Samples that wait for a reader, as in `unity_link.Link.subscribe`."""


MOST_ROWS = 60
"""Signals that a notebook shows."""


class Owner(Protocol):
    """A robot, as far as its signals know it."""

    interface: ClassVar[Interface]

    def enumeration(self, enumeration: Enumeration) -> type[enum.IntEnum]:
        """Return the class of an enumeration."""

    def __getitem__(self, name: str, /) -> Proxy[Any]:
        """Return a signal by its path."""


class SampledColumns(Protocol):
    """A batch of samples."""

    def __getitem__(self, proxy: Proxy[Any], /) -> NDArray[Any]:
        """Return the values of a signal; shape (samples,)."""


class _Last(Generic[T]):
    """The last value of a signal that was seen, with each read or batch another one, and what is called for it."""

    __slots__ = ("at", "batch", "callbacks", "value", "words")

    def __init__(self) -> None:
        self.callbacks: tuple[Callback[T], ...] = ()
        """Callbacks for values that differ from the one before."""
        self.value: T | None = None
        self.at = -math.inf
        """Instant by `time.monotonic`."""
        self.batch: SampledColumns | None = None
        """Batch with the value, if the last one came in a batch."""
        self.words: Sequence[int] | None = None
        """Words of the value, if the last one was written and nothing has asked for it."""


class Proxy(Sealed, Generic[T]):
    """A signal of a robot; `Readable`, `Writable`, `ReadWrite` and the ports of queues are.

    A copy of it is itself. Out of a pickle, which links do not go through, it has its path and unit alone.
    """

    __slots__ = ("_laps", "_last", "_names", "bus", "link", "robot", "signal")

    def __init__(self, signal: Signal, robot: Owner, bus: Bus) -> None:
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
        self._laps = Laps(signal) if signal.laps_of == signal.path else None

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
        batch, words, value = last.batch, last.words, last.value
        if batch is not None:
            return self.scalars(batch[self][-1:])[0]
        return value if words is None else self.decode(words)

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
        listening = self._listen()
        self._last.callbacks = (*self._last.callbacks, made)
        return Registration(lambda: self._remove(made), *listening)

    def _remove(self, callback: Callback[T]) -> None:
        callback.cancel()
        self._last.callbacks = tuple(other for other in self._last.callbacks if other is not callback)

    def _listen(self) -> tuple[Callable[[], None], ...]:
        """Keep its samples seen, where it has some, until all that is returned is called."""
        return ()

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

    @property
    def laps(self) -> Laps | None:
        """The rounds that count for its values; None for a signal without WRAPS."""
        base = self.signal.laps_of
        if self._laps is not None or base is None or self.is_alone():
            return self._laps
        return self.robot[base].laps

    def counted(self, value: T) -> T:
        """Return a value that was just read, or was written, with the rounds of a signal with WRAPS."""
        laps = self.laps
        if laps is None:
            return value
        epoch = self.link.epoch
        near: T = laps.near(value, epoch)
        if laps is self._laps:
            laps.see(near, epoch, time.monotonic())
        return near

    def decode(self, words: int | Sequence[int]) -> T:
        """Return the value of words that were just read, or written."""
        return self.counted(self.scalar(self.signal.decode(words)))

    def encode(self, value: Any) -> tuple[int, ...]:
        """Return the words of a value, one for each address, as `Signal.encode`; with WRAPS also beyond the range.

        Raises:
            ArgumentError: for a value that its kind cannot say, outside of the limits, or, with WRAPS, too far from the
                value that was read last.
        """
        laps = self.laps
        given: object = value
        if laps is not None and isinstance(given, int | float) and not isinstance(given, bool) and math.isfinite(given):
            value = laps.register_value(value, self.link.epoch, self.path)
        return self.signal.encode(value)

    def see_written(self, words: Sequence[int]) -> None:
        """Keep the value of words that were written as the last one, unless they are not what is read then."""
        if self.signal.effect is not None:
            return
        last = self._last
        if last.callbacks or self.signal.laps_of is not None:
            self.see(self.decode(words))
        else:
            last.words, last.at, last.batch = words, time.monotonic(), None

    def see(self, value: T, at: float | None = None) -> None:
        """Keep a value as the last one, and call the handlers that wait for another one.

        Args:
            value: what was read or written.
            at: instant by `time.monotonic`; None for now.
        """
        last = self._last
        before = self.value if last.callbacks else None
        last.value, last.at = value, time.monotonic() if at is None else at
        last.words = last.batch = None
        if not last.callbacks:
            return
        if value == before or (value != value and before != before):  # noqa: PLR0124  (NaN, twice)
            return
        for callback in last.callbacks:
            callback(value)


def _alone(signal: Signal, names: dict[int, Any] | None) -> Proxy[Any]:
    """Return a signal of no robot."""
    made: Proxy[Any] = object.__new__(Proxy)
    given: dict[str, object] = {"signal": signal, "_names": names, "_laps": None, "_last": _Last(), "_is_sealed": True}
    for name, value in given.items():
        object.__setattr__(made, name, value)
    return made


def signals_table(title: str, proxies: Sequence[Proxy[Any]]) -> str:
    """Return what is known of signals as a table in HTML; none is read for that."""
    from unity_link.link import html

    head = ("signal", "value", "unit", "seen", "access", "address", "description")
    return html.long_table(title, len(proxies), lambda place: _row(proxies[place]), head, most=MOST_ROWS)


def nothing_publishes(proxies: Sequence[Proxy[Any]]) -> ArgumentError:
    """Return the error for signals of which nothing says when they are sampled."""
    names = ", ".join(proxy.path for proxy in proxies[:3]) + (", ..." if len(proxies) > 3 else "")
    return ArgumentError(
        f"nothing says when {names} is to be sampled: give PUBLISH or POLL in the spec, or a rate_hz to a group"
    )


def _row(proxy: Proxy[Any]) -> tuple[str, ...]:
    from unity_link.link import html

    signal = proxy.signal
    seen = "never" if proxy.value is None else f"{html.duration_text(proxy.age)} ago"
    value = html.value_text(proxy.value)
    return proxy.path, value, proxy.unit, seen, signal.access.name.lower(), f"{signal.address:#x}", signal.doc


async def refusal(error: BusError, proxies: Iterable[Proxy[Any]]) -> BusError:
    """Return the error for a write that the bus has refused: where a lease of these signals is not armed, that one."""
    for robot, lease in {(proxy.robot, proxy.signal.safe.lease) for proxy in proxies if proxy.signal.safe is not None}:
        from unity_link.cores.lease import refused

        error = await refused(error, robot, lease)
    return error


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
