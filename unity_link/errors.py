"""The errors of the package, sorted by cause.

Every error that Unity-Link raises is a `UnityLinkError`. Its class shows where the cause is: in the call
(`ArgumentError`), in the cable or the URL (`ConnectError`, `LinkLostError`), in the gateware (`GatewayError`,
`UnsupportedError`), or in a program that reads too slowly (`SamplesLostError`).
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
"""Errors that a user's function may raise and that must not stop other work; CancelledError is raised by the result of
a cancelled task."""


class UnityLinkError(Exception):
    """Base of all errors of this package."""


class ArgumentError(UnityLinkError, ValueError):
    """A value that no gateway, or not this one, accepts. Nothing was sent."""


class UnknownNameError(ArgumentError, KeyError):
    """A name that is missing in a mapping of signals or groups."""

    __str__ = Exception.__str__


class ConnectError(UnityLinkError):
    """No link could be opened; the message names the URL and the reason."""


class UnsupportedError(UnityLinkError):
    """The gateway was built without a feature that the call needs, or has another protocol version."""


class SpecMismatchError(UnsupportedError):
    """The gateway was generated from another spec than the program uses. No signal was written."""

    def __init__(self, message: str, differences: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.differences = differences
        """All differences as sentences, such as ``"tilt: SCALE is 0.1 in robot.ul and 0.2 on the board"``; empty if
        they are unknown: the gateway carries no description, or the description was not read."""

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.differences)


class SamplesLostError(UnityLinkError):
    """A subscription with ``overflow="fail"`` was read too slowly, so that its buffer is full."""


class Outcome(enum.Enum):
    """Outcome of a request whose answer did not arrive."""

    EXECUTED = "executed"
    """The gateway executed it, and the answer was lost."""
    NOT_EXECUTED = "not executed"
    """It did not reach the bus, and can be sent again."""
    UNKNOWN = "unknown"
    """It may have reached the bus."""
    NO_REQUEST = "no request"
    """The error does not concern a request: samples are published without one."""


class UnansweredError(UnityLinkError):
    """The call was not answered, and no answer can arrive any more.

    `outcome` is the outcome of the request as far as it is known: a write that is ``NOT_EXECUTED`` can be sent again,
    one that is ``UNKNOWN`` may have reached the bus.
    """

    def __init__(self, reason: str, outcome: Outcome = Outcome.UNKNOWN) -> None:
        super().__init__(reason, outcome)
        self.reason = reason
        """Cause, as a sentence without the outcome."""
        self.outcome = outcome
        """Outcome of the request."""

    def about(self, outcome: Outcome) -> Self:
        """Return the same error for a request with another outcome."""
        return type(self)(self.reason, outcome)

    def __str__(self) -> str:
        """Return the reason, and the outcome if there was a request."""
        known = _OUTCOME_TEXT.get(self.outcome)
        return f"{self.reason}; the request is {known}" if known else self.reason


_OUTCOME_TEXT = {
    Outcome.EXECUTED: "known to be executed",
    Outcome.NOT_EXECUTED: "known not to be executed",
    Outcome.UNKNOWN: "perhaps executed",
}


def reason_of(error: UnityLinkError) -> str:
    """Return the message of an error without the outcome of its request."""
    return error.reason if isinstance(error, UnansweredError) else str(error)


class LinkLostError(UnansweredError):
    """The link ended before the call was answered."""


class GatewayResetError(LinkLostError):
    """The gateway was reset before it answered the call, and has lost its groups.

    The link continues and sets up its subscriptions again.
    """


class LinkClosedError(LinkLostError):
    """The program closed the link."""


class GatewayError(UnityLinkError):
    """The gateway answered with an error (docs/protocol.md, "Errors")."""

    code = 0
    """Number of the error in the protocol."""
    address: int | None = None
    """Address of the access, for a block the first one; None if it is unknown."""

    def __init__(self, message: str, code: int | None = None) -> None:
        super().__init__(message)
        if code is not None:
            self.code = code


class BusError(GatewayError):
    """A module on the bus refused the access (error 04). Earlier accesses of a block remain executed."""

    code = 4


class NotArmedError(BusError):
    """A lease is not armed: arming failed, the lease ended, or a write to a guarded signal was refused.

    Guarded outputs stay safe until a program arms the lease again and writes new values.
    """

    def __init__(self, message: str, reason: str, instant: float | None = None) -> None:
        super().__init__(message)
        self.reason = reason
        """Cause: ``"none_yet"`` (not armed since the reset), ``"disarmed"``, ``"silence"`` (it expired without a kick),
        ``"estop"``, ``"taken"`` (another program holds it), ``"late"`` (its end had passed when it was to be armed), or
        ``"reset"`` (the gateway was reset, or the link or server has begun a new session)."""
        self.instant = instant
        """Time of the fault in seconds of the gateway's clock; None if there was no fault or its time is unknown."""

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.reason, self.instant)


class LateError(UnityLinkError):
    """A scheduled write was not executed and will not be: it arrived too late, or was refused."""

    def __init__(self, message: str, ticks: int) -> None:
        super().__init__(message)
        self.ticks = ticks
        """Scheduled time of the write in ticks of the gateway's clock."""

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
    """Raise the first error of a task group by itself: callers do not know about the tasks."""
    try:
        yield
    except BaseExceptionGroup as group:
        first = group.exceptions[0]
        raise first from first.__cause__


def shown(value: object) -> str:
    """Format a value from a program for a message: a number as text, otherwise its `repr`; at most 80 characters."""
    try:
        return f"{value!s:.80}" if isinstance(value, Number) else f"{value!r:.80}"
    except ValueError:
        # Python refuses to convert integers of more than 4,300 digits to text.
        return f"a number of {value.bit_length()} bits" if isinstance(value, int) else f"a {type(value).__name__}"


def did_you_mean(name: object, known: Iterable[str]) -> str:
    """Return a question with the known names that are similar to `name`; empty if there is none."""
    import difflib

    names = sorted(set(known))
    folded = [other for other in names if isinstance(name, str) and other.lower() == name.lower()]
    close = folded or difflib.get_close_matches(str(name)[:100], names, n=2, cutoff=0.6)
    return f"did you mean {' or '.join(repr(other) for other in close)}?" if close else ""


def refusing(sentence: str) -> Callable[..., Never]:
    """Return a method that raises ArgumentError: for a use of an object that is impossible but likely to be tried."""

    def refuse(*_: object) -> Never:
        raise ArgumentError(sentence)

    return refuse


def missing(thing: object, name: str, what: str, **instead: str) -> AttributeError:
    """Return the error for a missing attribute.

    Args:
        thing: the object.
        name: name of the attribute.
        what: name of the object in messages.
        instead: advice, by names that users are likely to try.
    """
    hint = instead.get(name, "") or did_you_mean(name, [known for known in dir(thing) if not known.startswith("_")])
    return AttributeError(f"{what} has no {name!r}" + (f": {hint}" if hint else ""), name=name, obj=thing)


def missing_attribute(what: str, **instead: str) -> Callable[[object, str], Never]:
    """Return a `__getattr__` that raises `missing` for unknown names."""

    def refuse(thing: object, name: str) -> Never:
        raise AttributeError(name) if name.startswith("_") else missing(thing, name, what, **instead)

    return refuse


def unassignable_attribute(what: str) -> Callable[[object, str, object], Never]:
    """Return a `__setattr__` that rejects every assignment."""

    def refuse(thing: object, name: str, _: object) -> Never:
        raise unassignable(thing, name, what)

    return refuse


def unassignable(thing: object, name: str, what: str) -> ArgumentError:
    """Return the error for an assignment to an attribute that programs must not set, or that does not exist."""
    if name in dir(thing):
        return ArgumentError(f"{name!r} of {what} cannot be assigned to")
    return ArgumentError(str(missing(thing, name, what)))


class OfLink:
    """Base of objects that belong to one link: copying returns the same object, and pickling is an error."""

    __slots__ = ()

    def _called(self) -> str:
        """Return the name of the object in messages."""
        return repr(self)[1:-1]

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, _: dict[int, Any], /) -> Self:
        return self

    def __reduce__(self) -> Any:
        raise ArgumentError(f"{self._called()} cannot be pickled: it is of no use without its link")


class _Sealing(type):
    """Metaclass that seals each object after `__init__`."""

    def __call__(cls: type[T], *arguments: Any, **options: Any) -> T:
        made: T = cls.__new__(cls, *arguments, **options)
        seal = object.__setattr__
        seal(made, "_is_sealed", False)  # noqa: FBT003  (positional only)
        made.__init__(*arguments, **options)  # type: ignore[misc]  # the method of the object's class
        seal(made, "_is_sealed", True)  # noqa: FBT003
        return made


class Sealed(OfLink, metaclass=_Sealing):
    """Base of objects whose public attributes cannot be set after `__init__`: an assignment would have no effect."""

    __slots__ = ("_is_sealed",)

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.

        def __setattr__(self, name: str, value: object) -> None:
            if self._is_sealed and not name.startswith("_"):
                raise unassignable(self, name, self._called())
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(name) if name.startswith("_") else missing(self, name, self._called())

    def _data(self) -> tuple[object, ...] | None:
        """Return the arguments that make a copy; None if the object belongs to a link and cannot be copied."""
        return None

    def __deepcopy__(self, memo: dict[int, Any], /) -> Self:
        import copy

        data = self._data()
        return self if data is None else type(self)(*copy.deepcopy(data, memo))

    def __reduce__(self) -> Any:
        data = self._data()
        return super().__reduce__() if data is None else (type(self), data)
