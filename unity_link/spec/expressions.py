"""Evaluates the expressions of a spec.

Results are ints, floats, strings, bools, `LEFT_OUT`, and references to objects without a value: a group, a lease, a
schedule, or a parameter that is given when an interface is opened. None means that the expression has a fault; that was
reported already, so that callers report nothing more about it.
"""

from __future__ import annotations

import enum
import functools
import math
import operator
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from unity_link.spec.diagnostics import Reporter, SourceText, did_you_mean
from unity_link.spec.model import ParameterReference
from unity_link.spec.syntax import Call, Chain, Expression, Name, Number, Parenthesis, Prefixed, Text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping


class GroupReference(NamedTuple):
    """A declared group, by its name."""

    name: str


class LeaseReference(NamedTuple):
    """A lease of the interface, by its name."""

    name: str


class ScheduleReference(NamedTuple):
    """A schedule of the interface, by its name."""

    name: str


class LeftOut(enum.Enum):
    """The constant ``none``: an argument with this value counts as not given."""

    NONE = "none"


LEFT_OUT = LeftOut.NONE
PlacedReference: TypeAlias = LeaseReference | ScheduleReference
"""A component of the interface that other statements name."""
Result: TypeAlias = int | float | str | bool | GroupReference | PlacedReference | ParameterReference | LeftOut | None
CONSTANTS: dict[str, Result] = {"true": True, "false": False, "pi": math.pi, "none": LEFT_OUT}
MOST_BITS = 128
"""Most bits of a whole number. Addresses have at most 32 bits, values 64; this stops a mistyped shift from filling the
memory."""
MOST_TEXT = 1000
_PRECEDENCE = {"|": 0, "^": 1, "&": 2, "<<": 3, ">>": 3, "+": 4, "-": 4, "*": 5, "/": 5, "%": 5}
_WHOLE_ONLY = {"|", "^", "&", "<<", ">>"}


class _FaultError(Exception):
    """An operation without a result; the message gives the reason."""


@functools.lru_cache(maxsize=65536)
def parse_number(text: str) -> int | float | None:
    """Return the number that a text represents; None if the text is not a number."""
    try:
        if text[:2] in {"0x", "0X", "0b", "0B"}:
            number: int | float = int(text, 0)
        elif text.replace("_", "").isdigit():
            number = int(text)
        else:
            number = float(text)
    except ValueError:
        return None
    return None if isinstance(number, float) and not math.isfinite(number) else number


def describe(value: Result) -> str:  # noqa: PLR0911  (one for each kind of value)
    """Return a phrase for a value, for use in a message."""
    match value:
        case bool():
            return "true" if value else "false"
        case int() | float():
            return f"the number {value:.12g}" if isinstance(value, float) else f"the number {value}"
        case str():
            return f'the string "{value[:40]}"'
        case GroupReference():
            return f"the group '{value.name}'"
        case LeaseReference():
            return f"the lease '{value.name}'"
        case ScheduleReference():
            return f"the schedule '{value.name}'"
        case ParameterReference():
            return f"the parameter '{value.name}', whose value is given only when the interface is opened"
        case LeftOut():
            return "none"
    return "nothing"


class Evaluator:
    """Evaluates the expressions of one source."""

    def __init__(self, source: SourceText, reporter: Reporter) -> None:
        self.source = source
        self.reporter = reporter

    def fault(self, place: tuple[int, int], code: str, message: str, help: str = "") -> None:  # noqa: A002
        """Report an error in this source."""
        self.reporter.error(self.source, place, code, message, help=help)

    def evaluate(self, expression: Expression, scope: Mapping[str, Result]) -> Result:  # noqa: PLR0911
        """Return the value of an expression; None if it has a fault, which is reported."""
        self.reporter.spend(1)
        match expression:
            case Number():
                return self._number(expression)
            case Text():
                return expression.value
            case Name():
                return self._name(expression, scope)
            case Chain():
                return self._chain(expression, scope)
            case Parenthesis():
                return self.evaluate(expression.inner, scope)
            case Prefixed():
                return self._prefixed(expression, scope)
            case Call():
                return self._call(expression, scope)

    def _number(self, number: Number) -> Result:
        value = parse_number(number.text)
        if value is None or (isinstance(value, int) and value.bit_length() > MOST_BITS):
            message = f"'{number.text[:40]}' is no number" if value is None else "this number is too large"
            self.fault(number.place, "bad-number", message, "numbers look like 12, 0x80, 0b101 or 1.5e-3")
            return None
        return value

    def _name(self, name: Name, scope: Mapping[str, Result]) -> Result:
        try:
            return scope[name.name]
        except KeyError:
            self.report_unknown(name, did_you_mean(name.name, scope))
            return None

    def report_unknown(self, name: Name, advice: str) -> None:
        """Report a name that is not in the scope."""
        self.fault(name.place, "unknown-name", f"nothing is called '{name.name}' here", advice)

    def _prefixed(self, expression: Prefixed, scope: Mapping[str, Result]) -> Result:
        value = self.evaluate(expression.operand, scope)
        if value is None:
            return None
        for prefix in reversed(expression.prefixes):
            whole = isinstance(value, int) and not isinstance(value, bool)
            if not whole and not (prefix == "-" and isinstance(value, float)):
                message = f"'{prefix}' before {describe(value)} has no meaning"
                self.fault(expression.place, "bad-operand", message)
                return None
            value = -value if prefix == "-" else ~value  # type: ignore[operator]
        return value

    def _call(self, call: Call, scope: Mapping[str, Result]) -> Result:
        function = _FUNCTIONS.get(call.name)
        if function is None:
            message = f"'{call.name}(...)' has no value"
            self.fault(call.name.place, "no-value", message, did_you_mean(call.name, _FUNCTIONS))
            return None
        values = [self.evaluate(argument.value, scope) for argument in call.arguments]
        if None in values:
            return None
        if any(argument.name is not None for argument in call.arguments):
            self.fault(call.place, "bad-operand", f"{call.name} takes its numbers without names")
            return None
        try:
            return _bounded(function, *_numbers(call.name, values))
        except _FaultError as fault:
            self.fault(call.place, "bad-operand", str(fault))
            return None

    def _chain(self, chain: Chain, scope: Mapping[str, Result]) -> Result:
        """Evaluate operands and operators by precedence; equal operators from the left."""
        self.reporter.spend(len(chain.operators))
        values = [self.evaluate(operand, scope) for operand in chain.operands]
        if None in values:
            return None
        try:
            return _fold(values, chain.operators)
        except _FaultError as fault:
            self.fault(chain.place, "bad-operand", str(fault))
            return None


def _fold(values: list[Result], operators: list[str]) -> Result:
    left, waiting = [values[0]], list[str]()
    for symbol, value in zip(operators, values[1:], strict=True):
        while waiting and _PRECEDENCE[waiting[-1]] >= _PRECEDENCE[symbol]:
            second = left.pop()
            left.append(_apply(waiting.pop(), left.pop(), second))
        waiting.append(symbol)
        left.append(value)
    while waiting:
        second = left.pop()
        left.append(_apply(waiting.pop(), left.pop(), second))
    return left[0]


def _apply(symbol: str, first: Result, second: Result) -> Result:
    if symbol == "+" and (isinstance(first, str) or isinstance(second, str)):
        return _joined(first, second)
    first, second = _numbers(f"'{symbol}'", (first, second))
    if symbol in _WHOLE_ONLY and not (isinstance(first, int) and isinstance(second, int)):
        raise _FaultError(f"'{symbol}' takes whole numbers, not {first:g} and {second:g}")
    if symbol in {"<<", ">>"} and not 0 <= second <= MOST_BITS:
        raise _FaultError(f"a shift by {second} was asked for, 0 to {MOST_BITS} is expected")
    if symbol in {"/", "%"} and second == 0:
        raise _FaultError("a division by 0")
    return _bounded(_OPERATIONS[symbol], first, second)


def _numbers(what: str, values: Iterable[Result]) -> list[int | float]:
    """Return the values, which must be numbers.

    Raises:
        _FaultError: if a value is not a number; `what` names the operator or function in the message.
    """
    found: list[int | float] = []
    for value in values:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise _FaultError(f"{what} takes numbers, not {describe(value)}")
        found.append(value)
    return found


def _bounded(function: Callable[..., float], *numbers: float) -> int | float:
    """Return the result of a function of numbers.

    Raises:
        _FaultError: if the result is too large.
    """
    try:
        result = function(*numbers)
    except OverflowError:
        raise _FaultError("the result is too large") from None
    too_large = result.bit_length() > MOST_BITS if isinstance(result, int) else not math.isfinite(result)
    if too_large:
        raise _FaultError("the result is too large")
    return result


def _divide(first: float, second: float) -> float:
    """Divide; the quotient of two ints that divide exactly is an int."""
    if isinstance(first, int) and isinstance(second, int) and first % second == 0:
        return first // second
    return first / second


_OPERATIONS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": _divide,
    "%": operator.mod,
    "<<": operator.lshift,
    ">>": operator.rshift,
    "&": operator.and_,
    "|": operator.or_,
    "^": operator.xor,
}


def _of_one(name: str, function: Callable[[float], float]) -> Callable[..., float]:
    """Return a function that requires exactly one number."""

    def call(*numbers: float) -> float:
        if len(numbers) != 1:
            raise _FaultError(f"{name} takes 1 number, and {len(numbers)} are given")
        return function(numbers[0])

    return call


def _of_some(name: str, function: Callable[..., float]) -> Callable[..., float]:
    """Return a function that requires at least one number."""

    def call(*numbers: float) -> float:
        if not numbers:
            raise _FaultError(f"{name} takes 1 number at least, and none is given")
        return function(numbers)

    return call


def _log2(number: float) -> float:
    if number <= 0:
        raise _FaultError(f"log2 takes a number above 0, not {number:g}")
    return math.log2(number)


_FUNCTIONS: dict[str, Callable[..., float]] = {
    "min": _of_some("min", min),
    "max": _of_some("max", max),
    "floor": _of_one("floor", math.floor),
    "ceil": _of_one("ceil", math.ceil),
    "log2": _of_one("log2", _log2),
}


def _joined(first: Result, second: Result) -> str:
    """Join two values to a string; numbers are converted."""
    parts = []
    for value in (first, second):
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise _FaultError(f"{describe(value)} cannot be joined to a string")
        parts.append(value if isinstance(value, str) else str(value))
    if sum(len(part) for part in parts) > MOST_TEXT:
        raise _FaultError(f"a string of more than {MOST_TEXT} characters")
    return "".join(parts)
