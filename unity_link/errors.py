"""The errors of the package, sorted by what a caller can do about them.

Every error that Unity-Link raises is a `UnityLinkError`. An error's class says what to do: mend the call
(`ArgumentError`), look at the cable and the URL (`ConnectError`, `LinkLostError`), look at the gateware
(`GatewayError`, `UnsupportedError`), or read faster (`SamplesLostError`).
"""

from __future__ import annotations

import contextlib
import enum
from asyncio import CancelledError
from numbers import Number
from typing import TYPE_CHECKING, Any, Never, Self, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator


T = TypeVar("T")
ANY_ERROR = (Exception, CancelledError)
"""Errors that a user's function may raise and that must stop nothing else; the latter comes of asking a task that was
cancelled for its result."""


class UnityLinkError(Exception):
    """Base of all errors of this package."""


class ArgumentError(UnityLinkError, ValueError):
    """A value that no gateway, or not this one, can take. Nothing was sent."""


class UnknownNameError(ArgumentError, KeyError):
    """A name that a mapping of signals or groups does not have."""

    __str__ = Exception.__str__


class ConnectError(UnityLinkError):
    """No link could be opened; the message says what was tried."""


class UnsupportedError(UnityLinkError):
    """The gateway was built without the feature that the call needs, or speaks another protocol version."""


class SpecMismatchError(UnsupportedError):
    """The gateway was generated from another spec than the program's. Nothing was written to a signal."""

    def __init__(self, message: str, differences: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.differences = differences
        """All differences in words, such as ``"tilt: SCALE is 0.1 in robot.ul and 0.2 on the board"``; empty where they
        are not known: the gateway carries no description, or it was not read."""

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.differences)


class SamplesLostError(UnityLinkError):
    """A subscription with ``overflow="fail"`` was read too slowly, and its buffer is full."""


class Outcome(enum.Enum):
    """Fate of a request whose answer did not come."""

    EXECUTED = "executed"
    """The gateway executed it, and the answer was lost."""
    NOT_EXECUTED = "not executed"
    """It never reached the bus, and can be sent again."""
    UNKNOWN = "unknown"
    """It may have reached the bus, or not."""
    NO_REQUEST = "no request"
    """The error is not about a request: samples are published without one."""


class UnansweredError(UnityLinkError):
    """The call was not answered, and never will be.

    `outcome` says what is known of the request: a write that is ``NOT_EXECUTED`` can be sent again, one that is
    ``UNKNOWN`` may or may not have reached the bus.
    """

    def __init__(self, reason: str, outcome: Outcome = Outcome.UNKNOWN) -> None:
        super().__init__(reason, outcome)
        self.reason = reason
        """Cause, as a sentence without the outcome."""
        self.outcome = outcome
        """Fate of the request."""

    def about(self, outcome: Outcome) -> Self:
        """Return the same error about a request of which something else is known."""
        return type(self)(self.reason, outcome)

    def __str__(self) -> str:
        """Return the reason, and what is known of the request if there was one."""
        known = _OUTCOME_TEXT.get(self.outcome)
        return f"{self.reason}; the request is {known}" if known else self.reason


_OUTCOME_TEXT = {
    Outcome.EXECUTED: "known to be executed",
    Outcome.NOT_EXECUTED: "known not to be executed",
    Outcome.UNKNOWN: "perhaps executed",
}


def reason_of(error: UnityLinkError) -> str:
    """Return what an error says, without what it says of a request."""
    return error.reason if isinstance(error, UnansweredError) else str(error)


class LinkLostError(UnansweredError):
    """The link ended before the call was answered."""


class GatewayResetError(LinkLostError):
    """The gateway was reset before it answered the call: it has forgotten its groups.

    The link goes on by itself: it sets its subscriptions up again.
    """


class LinkClosedError(LinkLostError):
    """The link was closed by this program."""


class GatewayError(UnityLinkError):
    """The gateway answered with an error (docs/protocol.md, "Errors")."""

    code = 0
    """Number of the error."""
    address: int | None = None
    """Address of the access, of a block the first one; None if it is not known."""

    def __init__(self, message: str, code: int | None = None) -> None:
        super().__init__(message)
        if code is not None:
            self.code = code


class BusError(GatewayError):
    """A module on the bus refused the access (error 04). What a block did before it stays done."""

    code = 4


class NotArmedError(BusError):
    """A lease is not armed: it could not be, it ended, or a write to what it guards was refused and not stored.

    Nothing that the lease guards moves until a program arms it anew and writes to it afresh.
    """

    def __init__(self, message: str, reason: str, instant: float | None = None) -> None:
        super().__init__(message)
        self.reason = reason
        """Cause: ``"none_yet"`` (it was not armed since the reset), ``"disarmed"``, ``"silence"`` (its end came before
        a kick), ``"estop"``, ``"taken"`` (another program has it), ``"late"`` (its end came before it was armed), or
        ``"reset"`` (the gateway was reset, or the link or the server has begun another session with it since)."""
        self.instant = instant
        """Instant of the fault in seconds of the gateway's clock; None where it was none, or is not known."""

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.reason, self.instant)


class LateError(UnityLinkError):
    """A write at an instant has not happened, nor will it: it came too late, or was refused."""

    def __init__(self, message: str, ticks: int) -> None:
        super().__init__(message)
        self.ticks = ticks
        """Its instant, in ticks of the gateway's clock."""

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.ticks)


class BusTimeoutError(GatewayError):
    """No module on the bus answered at the address (error 05)."""

    code = 5


class OutOfRangeError(GatewayError):
    """The gateway refused a group, count, divisor, mode or width (error 06)."""

    code = 6


@contextlib.contextmanager
def first_error() -> Iterator[None]:
    """Raise what failed first in a group of tasks as itself: a caller knows nothing of the tasks."""
    try:
        yield
    except BaseExceptionGroup as group:
        first = group.exceptions[0]
        raise first from first.__cause__


def shown(value: object) -> str:
    """Return what a program has given, for a message: a number as text, else its `repr`; cut to 80 characters."""
    try:
        return f"{value!s:.80}" if isinstance(value, Number) else f"{value!r:.80}"
    except ValueError:
        # Python writes no whole number of more than 4,300 digits.
        return f"a number of {value.bit_length()} bits" if isinstance(value, int) else f"a {type(value).__name__}"


def did_you_mean(name: object, known: Iterable[str]) -> str:
    """Suggest the known names that look like `name`; empty where none does."""
    import difflib

    names = sorted(set(known))
    folded = [other for other in names if isinstance(name, str) and other.lower() == name.lower()]
    close = folded or difflib.get_close_matches(str(name)[:100], names, n=2, cutoff=0.6)
    return f"did you mean {' or '.join(repr(other) for other in close)}?" if close else ""


def refusing(sentence: str) -> Callable[..., Never]:
    """Return a method that raises ArgumentError: for a use of an object that cannot be, but is often tried."""

    def refuse(*_: object) -> Never:
        raise ArgumentError(sentence)

    return refuse


def missing(thing: object, name: str, what: str, **instead: str) -> AttributeError:
    """Return the error for an attribute that a thing does not have.

    Args:
        thing: the thing.
        name: of the attribute.
        what: how messages call the thing.
        instead: by names that are often tried, what to write.
    """
    hint = instead.get(name, "") or did_you_mean(name, [known for known in dir(thing) if not known.startswith("_")])
    return AttributeError(f"{what} has no {name!r}" + (f": {hint}" if hint else ""), name=name, obj=thing)


def missing_attribute(what: str, **instead: str) -> Callable[[object, str], Never]:
    """Return a `__getattr__` that raises `missing` for names that there are not."""

    def refuse(thing: object, name: str) -> Never:
        raise AttributeError(name) if name.startswith("_") else missing(thing, name, what, **instead)

    return refuse


def unassignable_attribute(what: str) -> Callable[[object, str, object], Never]:
    """Return a `__setattr__` that refuses each assignment."""

    def refuse(thing: object, name: str, _: object) -> Never:
        raise unassignable(thing, name, what)

    return refuse


def unassignable(thing: object, name: str, what: str) -> ArgumentError:
    """Return the error for an assignment to an attribute: one that is not for programs to set, or that there is not."""
    if name in dir(thing):
        return ArgumentError(f"{name!r} of {what} cannot be assigned to")
    return ArgumentError(str(missing(thing, name, what)))


class OfLink:
    """Something of a link, of which there is one: a copy of it is itself, and it goes through no pickle."""

    __slots__ = ()

    def _called(self) -> str:
        """Return what messages call it."""
        return repr(self)[1:-1]

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, _: dict[int, Any], /) -> Self:
        return self

    def __reduce__(self) -> Any:
        raise ArgumentError(f"{self._called()} cannot be pickled: it is of no use without its link")


class _Sealing(type):
    """Makes objects, and seals each when it is made."""

    def __call__(cls: type[T], *arguments: Any, **options: Any) -> T:
        made: T = cls.__new__(cls, *arguments, **options)
        seal = object.__setattr__
        seal(made, "_is_sealed", False)  # noqa: FBT003  (it has no name)
        made.__init__(*arguments, **options)  # type: ignore[misc]  # that of its class
        seal(made, "_is_sealed", True)  # noqa: FBT003
        return made


class Sealed(OfLink, metaclass=_Sealing):
    """Something whose attributes a program does not set, once it is made: that would hide them, and do nothing else."""

    __slots__ = ("_is_sealed",)

    if not TYPE_CHECKING:  # A type checker refuses them by itself.

        def __setattr__(self, name: str, value: object) -> None:
            if self._is_sealed and not name.startswith("_"):
                raise unassignable(self, name, self._called())
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(name) if name.startswith("_") else missing(self, name, self._called())

    def _data(self) -> tuple[Any, ...] | None:
        """Return what its class makes another one of; None where it is of a link, of which there is one."""
        return None

    def __deepcopy__(self, memo: dict[int, Any], /) -> Self:
        import copy

        data = self._data()
        return self if data is None else type(self)(*copy.deepcopy(data, memo))

    def __reduce__(self) -> Any:
        data = self._data()
        return super().__reduce__() if data is None else (type(self), data)
