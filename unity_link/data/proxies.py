"""One signal of a robot, with its last value and its callbacks; `signals` has those that can be read or written.

A proxy stores the newest value that was seen in any way: by a read, a write, a group or a subscription. If that value
was in a batch of samples, the proxy stores the batch, and decodes the value when it is requested.
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
"""Type of the values that writes accept: an enumeration also accepts names, which reads never return."""

BUFFER = 16_384
"""Most samples that wait for a reader, as in `unity_link.Link.subscribe`."""


MOST_ROWS = 60
"""Most signals that a notebook shows."""


class Owner(Protocol):
    """The attributes of a robot that its signals use."""

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
    """The last value of a signal that was seen, or the batch with it, and the callbacks for new values."""

    __slots__ = ("at", "batch", "callbacks", "value", "words")

    def __init__(self) -> None:
        self.callbacks: tuple[Callback[T], ...] = ()
        """Callbacks for values that differ from the last one."""
        self.value: T | None = None
        self.at = -math.inf
        """Instant of `time.monotonic` at which the value arrived or was written."""
        self.batch: SampledColumns | None = None
        """Batch of samples that ends with the value, if the value came in a batch."""
        self.words: Sequence[int] | None = None
        """Words of the value, if it was written and has not been decoded yet."""


class Proxy(Sealed, Generic[T]):
    """A signal of a robot; the base of `Readable`, `Writable`, `ReadWrite` and the ports of queues.

    A copy of a proxy is the proxy itself. An unpickled proxy has no robot and no link, only its path, ID and unit.
    """

    __slots__ = ("_laps", "_last", "_names", "bus", "link", "robot", "signal")

    def __init__(self, signal: Signal, robot: Owner, bus: Bus) -> None:
        self.signal = signal
        """Declaration of the signal in the spec."""
        self.robot = robot
        self.bus = bus
        """Bus for its accesses: the link, or the bus of the module that contains the signal."""
        self.link = link_under(bus)
        self._names: dict[int, Any] | None = None
        if signal.kind.enumeration is not None:
            known = robot.enumeration(signal.kind.enumeration)
            self._names = {int(member): member for member in known}
        self._last: _Last[T] = _Last()
        self._laps = Laps(signal) if signal.laps_of == signal.path else None

    if not TYPE_CHECKING:  # A type checker reports such errors by itself.

        def __getattr__(self, name: str) -> Any:
            raise _no_attribute(self, name)

        def __setattr__(self, name: str, value: object) -> None:
            if name == "value":
                written = f"`await {self.path}.set({value!r})` writes it"
                raise ArgumentError(f"{self.path}.value is the value seen last: {written}")
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
        """Return whether the proxy was unpickled, and belongs to no robot."""
        return type(self) is Proxy

    @property
    def path(self) -> str:
        """Path of the signal in its robot: ``legs[2].coxa.cpos``."""
        return self.signal.path

    @property
    def id(self) -> str:
        """Name of the signal in the spec for people and other systems."""
        return self.signal.id

    @property
    def unit(self) -> str:
        """Unit of the values; empty if they have none."""
        return self.signal.unit

    def __repr__(self) -> str:
        """Return the path, and the last value with its age."""
        unit = f" {self.unit}" if self.unit else ""
        seen = "never seen" if self.value is None else f"{self.value!r}{unit}, {self.age:.3g} s ago"
        return f"<{self.path}: {seen}>"

    def _repr_html_(self) -> str:
        """Return the last value and the declaration as a table, without a read."""
        return signals_table(self.path, [self])

    # Last value

    @property
    def value(self) -> T | None:
        """The last value that was seen in any way; None before the first one."""
        last = self._last
        # Get the three once: if the link is in another thread, the next batch may replace them at any time.
        batch, words, value = last.batch, last.words, last.value
        if batch is not None:
            return self.scalars(batch[self][-1:])[0]
        return value if words is None else self.decode(words)

    @property
    def age(self) -> float:
        """Seconds since that value arrived or was written; infinite before the first one."""
        return time.monotonic() - self._last.at

    def on_change(self, callback: Callable[[T], object]) -> Registration:
        """Call a function with each value that differs from the last one seen, until `Registration.cancel`.

        If the signal is published or polled, its samples are received from now on; otherwise, values are seen only when
        the signal is read or written. An event loop must be running. Exceptions of the callback are logged under
        ``unity_link.link``, the first one of each type. The loss of the link is logged, too. If the gateway refuses a
        read of a polled signal, or is behind a server and away at the beginning, the error is logged and the read or
        subscription is tried again.

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
        """Receive the signal's samples, if there are any, until all returned functions are called."""
        return ()

    # Called by groups and subscriptions

    def scalars(self, values: NDArray[Any]) -> list[T]:
        """Return the values in an array, shape (n,), as Python's values; numbers with names as enumeration members."""
        numbers = values.tolist()
        if self._names is not None:
            names = self._names
            numbers = [names.get(number, number) for number in numbers]
        return cast("list[T]", numbers)

    def scalar(self, value: Any) -> T:
        """Return the member of the enumeration for a number that has a name; any other value unchanged."""
        if self._names is None:
            return cast("T", value)
        return cast("T", self._names.get(int(value), int(value)))

    @property
    def laps(self) -> Laps | None:
        """The counter of rounds for its values; None for a signal without WRAPS."""
        base = self.signal.laps_of
        if self._laps is not None or base is None or self.is_alone():
            return self._laps
        return self.robot[base].laps

    def counted(self, value: T) -> T:
        """Return a value that was just read or written; for a signal with WRAPS, with its rounds counted."""
        laps = self.laps
        if laps is None:
            return value
        epoch = self.link.epoch
        near: T = laps.near(value, epoch)
        if laps is self._laps:
            laps.see(near, epoch, time.monotonic())
        return near

    def decode(self, words: int | Sequence[int]) -> T:
        """Return the value of words that were just read or written."""
        return self.counted(self.scalar(self.signal.decode(words)))

    def encode(self, value: Any) -> tuple[int, ...]:
        """Return the words of a value, one for each address, as `Signal.encode`; with WRAPS also beyond the range.

        Raises:
            ArgumentError: for a value that the kind cannot represent, outside of the limits, or, with WRAPS, too far
                from the value that was read last.
        """
        laps = self.laps
        given: object = value
        if laps is not None and isinstance(given, int | float) and not isinstance(given, bool) and math.isfinite(given):
            value = laps.register_value(value, self.link.epoch, self.path)
        return self.signal.encode(value)

    def see_written(self, words: Sequence[int]) -> None:
        """Store the value of written words as the last one, unless a read returns something else than was written."""
        if self.signal.effect is not None:
            return
        last = self._last
        if last.callbacks or self.signal.laps_of is not None:
            self.see(self.decode(words))
        else:
            last.words, last.at, last.batch = words, time.monotonic(), None

    def see(self, value: T, at: float | None = None) -> None:
        """Store a value as the last one, and call the change handlers if it differs from the previous one.

        Args:
            value: the value read or written.
            at: instant of `time.monotonic`; None for now.
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
    """Return an unpickled signal, which belongs to no robot."""
    made: Proxy[Any] = object.__new__(Proxy)
    given: dict[str, object] = {"signal": signal, "_names": names, "_laps": None, "_last": _Last(), "_is_sealed": True}
    for name, value in given.items():
        object.__setattr__(made, name, value)
    return made


def signals_table(title: str, proxies: Sequence[Proxy[Any]]) -> str:
    """Return the last values and declarations of signals as an HTML table, without a read."""
    from unity_link.link import html

    head = ("signal", "value", "unit", "seen", "access", "address", "description")
    return html.long_table(title, len(proxies), lambda place: _row(proxies[place]), head, most=MOST_ROWS)


def nothing_publishes(proxies: Sequence[Proxy[Any]]) -> ArgumentError:
    """Return the error for signals that the spec does not have sampled."""
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
    """Return the error for a refused write: a `NotArmedError` if a lease of its signals is not armed, else `error`."""
    for robot, lease in {(proxy.robot, proxy.signal.safe.lease) for proxy in proxies if proxy.signal.safe is not None}:
        from unity_link.cores.lease import refused

        error = await refused(error, robot, lease)
    return error


def _refuse_as_value(proxy: Proxy[Any], *_: object) -> Never:
    raise ArgumentError(f"{proxy.path} is a signal and no value: `get` reads it, `{proxy.path}.value` was seen last")


_NAMES = "bool int float index lt le gt ge add radd sub rsub mul rmul truediv rtruediv neg abs round"
OPERATORS = tuple(f"__{name}__" for name in _NAMES.split())
"""Operators of values. On a signal they raise an error, because the program has forgotten to read the signal."""
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
