"""Arguments: which ones a word of the language accepts, and the assignment of given arguments to them.

`ACCESS`, `GROUP` and `GATEWAY` are the tables of the language's own words; `modules` has those of hardware modules. To
add an argument, add a row.
"""

from __future__ import annotations

import enum
import math
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from unity_link.protocol.wire.numbers import RATE
from unity_link.spec.diagnostics import did_you_mean, listed
from unity_link.spec.expressions import (
    LEFT_OUT,
    Evaluator,
    GroupReference,
    LeaseReference,
    LeftOut,
    Result,
    ScheduleReference,
    describe,
)
from unity_link.spec.model import Effect, ParameterReference
from unity_link.spec.syntax import Argument, Call, Expression, Name

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


class Shape(enum.StrEnum):
    """Type of an argument; the value is the phrase for it in messages."""

    WHOLE = "a whole number"
    NUMBER = "a number"
    TEXT = "a string"
    GROUP = "a group's number or name"
    HANDLE = "a parameter of the interface, or an address"
    SIGNAL = "the name of a signal"
    FLAG = "true or false"
    CLAUSE = "a clause"
    VALUE = "a value of the signal"
    WORD = "IN, OUT or INOUT"
    EFFECT = listed(Effect)
    LEASE = "the name of a LEASE of the interface"
    SCHEDULE = "the name of a SCHEDULE of the interface"


class ArgumentSlot(NamedTuple):
    """One argument that a word accepts: name, type, and smallest and largest value."""

    name: str
    shape: Shape
    low: float | None = None
    high: float | None = None
    required: bool = False
    clause: tuple[ArgumentSlot, ...] = ()
    """Arguments of a clause; each can be given by position or by name."""


_EFFORT_OF_AN_ARGUMENT = 4
ADDRESS = (0, (1 << 32) - 1)
DIVISOR = (1, 0xFFFF)
GROUP_NUMBER = (0, 255)
ADDRESS_BITS, DATA_BITS = (8, 32), (8, 64)

ACCESS = (
    ArgumentSlot("ID", Shape.TEXT),
    ArgumentSlot(
        "PUBLISH",
        Shape.CLAUSE,
        clause=(
            ArgumentSlot("GROUP", Shape.GROUP, *GROUP_NUMBER, required=True),
            ArgumentSlot("DIVISOR", Shape.WHOLE, *DIVISOR),
        ),
    ),
    ArgumentSlot("POLL", Shape.CLAUSE, clause=(ArgumentSlot("RATE", Shape.NUMBER, *RATE, required=True),)),
    ArgumentSlot("GROUP", Shape.CLAUSE, clause=(ArgumentSlot("GROUP", Shape.GROUP, *GROUP_NUMBER, required=True),)),
    ArgumentSlot("FIFO", Shape.CLAUSE, clause=(ArgumentSlot("WORDS", Shape.WHOLE, 1, 1 << 32),)),
    ArgumentSlot("EFFECT", Shape.EFFECT),
    ArgumentSlot("WRAPS", Shape.CLAUSE, clause=(ArgumentSlot("OF", Shape.SIGNAL),)),
    ArgumentSlot("SCALE", Shape.NUMBER),
    ArgumentSlot("OFFSET", Shape.NUMBER),
    ArgumentSlot("UNIT", Shape.TEXT),
    ArgumentSlot("MIN", Shape.NUMBER),
    ArgumentSlot("MAX", Shape.NUMBER),
    ArgumentSlot("RESET", Shape.VALUE),
    ArgumentSlot(
        "SAFE",
        Shape.CLAUSE,
        clause=(
            ArgumentSlot("VALUE", Shape.VALUE, required=True),
            ArgumentSlot("LEASE", Shape.LEASE, required=True),
        ),
    ),
    ArgumentSlot("TIMED", Shape.CLAUSE, clause=(ArgumentSlot("SCHEDULE", Shape.SCHEDULE, required=True),)),
    ArgumentSlot("PIN", Shape.TEXT),
)
PIN = (ArgumentSlot("WAY", Shape.WORD, required=True), ArgumentSlot("UNWIRED", Shape.WHOLE, 0, 1))
TRIGGER = (ArgumentSlot("GROUP", Shape.GROUP, *GROUP_NUMBER),)
SENSORS = {
    "IMU": {"ORIENTATION": 4, "ANGULAR_VELOCITY": 3, "LINEAR_ACCELERATION": 3},
    "BATTERY": dict.fromkeys(("VOLTAGE", "CURRENT", "CHARGE", "CAPACITY", "PERCENTAGE", "TEMPERATURE"), 1),
    "RANGEFINDER": {"DISTANCE": 1},
}
"""Words of a group for sensors, with their parts and the number of signals of each part."""
_OF_RANGEFINDERS = (ArgumentSlot("FIELD_OF_VIEW", Shape.NUMBER, 0, 2 * math.pi), ArgumentSlot("INFRARED", Shape.FLAG))
GROUP = (
    ArgumentSlot("NUMBER", Shape.WHOLE, *GROUP_NUMBER),
    ArgumentSlot("DIVISOR", Shape.WHOLE, *DIVISOR),
    ArgumentSlot("RATE", Shape.NUMBER, *RATE),
    ArgumentSlot("TRIGGER", Shape.FLAG),
    ArgumentSlot("ON_CHANGE", Shape.FLAG),
    ArgumentSlot("IMMEDIATE", Shape.FLAG),
    ArgumentSlot("TIMESTAMPS", Shape.FLAG),
    ArgumentSlot(
        "JOINTS",
        Shape.CLAUSE,
        clause=tuple(
            ArgumentSlot(f"{prefix}{name}", Shape.SIGNAL)
            for prefix in ("", "SET_")
            for name in ("POSITION", "VELOCITY", "EFFORT")
        ),
    ),
    *(
        ArgumentSlot(
            word,
            Shape.CLAUSE,
            clause=(
                *(ArgumentSlot(part, Shape.SIGNAL) for part in parts),
                *(_OF_RANGEFINDERS if word == "RANGEFINDER" else ()),
            ),
        )
        for word, parts in SENSORS.items()
    ),
)
GATEWAY = (
    ArgumentSlot("ADDRESS_BITS", Shape.WHOLE, *ADDRESS_BITS),
    ArgumentSlot("DATA_BITS", Shape.WHOLE, *DATA_BITS),
    ArgumentSlot("CLOCK", Shape.WHOLE, 1, 1_000_000_000),
)

_NOT_NEEDED = {"CRC": "leave it out: every message of a program is checked", "INDEX": "the index of an array is 'i'"}

_TYPES: dict[Shape, tuple[type, ...]] = {
    Shape.WHOLE: (int,),
    Shape.NUMBER: (int, float),
    Shape.TEXT: (str,),
    Shape.GROUP: (int, GroupReference),
    Shape.HANDLE: (int, ParameterReference),
    Shape.FLAG: (bool,),
    Shape.VALUE: (int, float, bool, str),
    Shape.LEASE: (LeaseReference,),
    Shape.SCHEDULE: (ScheduleReference,),
}

Bound: TypeAlias = dict[str, Any]
"""Values by argument name; the value of a clause is again a `Bound`."""


class Binder:
    """Assigns and evaluates the arguments of one word."""

    def __init__(self, evaluator: Evaluator, scope: Mapping[str, Result]) -> None:
        self._evaluator = evaluator
        self._scope = scope
        self.places: dict[str, tuple[int, int]] = {}
        """Places of the given arguments, by name; those in a clause by ``CLAUSE.NAME``."""

    def bind(
        self,
        word: str,
        place: tuple[int, int],
        arguments: Sequence[Argument],
        slots: tuple[ArgumentSlot, ...],
        by_place: int = 0,
    ) -> Bound:
        """Return the values of `arguments` by name; faults are reported.

        Args:
            word: word that has the arguments.
            place: its place.
            arguments: the given arguments.
            slots: the arguments that the word accepts.
            by_place: number of slots, from the first one, that can be given without a name.
        """
        bound = self._bind(word, place, arguments, slots, by_place, "")
        for slot in slots:
            if slot.required and bound.get(slot.name) is LEFT_OUT:
                self._report_missing(word, place, slot)
        return {name: value for name, value in bound.items() if value is not LEFT_OUT}

    def _bind(
        self,
        word: str,
        place: tuple[int, int],
        arguments: Sequence[Argument],
        slots: tuple[ArgumentSlot, ...],
        by_place: int,
        prefix: str,
    ) -> Bound:
        self._evaluator.reporter.spend(_EFFORT_OF_AN_ARGUMENT * len(arguments))
        known = {slot.name: slot for slot in slots}
        bound: Bound = {}
        seen: set[str] = set()
        free = list(slots[:by_place])
        for argument in arguments:
            slot = self._slot(word, argument, known, free)
            if slot is None:
                continue
            if slot.name in seen:
                self._evaluator.fault(argument.place, "argument-twice", f"{slot.name} is given twice")
                continue
            seen.add(slot.name)
            value = self._value(argument, slot, known)
            if value is not LEFT_OUT:
                self.places[prefix + slot.name] = argument.place
            if value is not None:
                bound[slot.name] = value
        for slot in slots:
            if slot.required and slot.name not in seen:
                self._report_missing(word, place, slot)
        return bound

    def _report_missing(self, word: str, place: tuple[int, int], slot: ArgumentSlot) -> None:
        self._evaluator.fault(place, "argument-missing", f"{word} needs {slot.name}, {slot.shape.value}")

    def _slot(
        self, word: str, argument: Argument, known: Mapping[str, ArgumentSlot], free: list[ArgumentSlot]
    ) -> ArgumentSlot | None:
        """Return the slot of an argument; None if there is none, which is reported."""
        name = argument.name
        if name is None and isinstance(argument.value, Call | Name) and argument.value.name in known:
            slot = known[argument.value.name]
            if slot.shape in {Shape.CLAUSE, Shape.FLAG}:
                return slot
        if name is None and isinstance(argument.value, Call):
            name = argument.value.name
        if name is None and free:
            return free.pop(0)
        if name is None:
            self._report_unnamed(word, argument, known)
            return None
        if name not in known:
            place = name.place
            advice = did_you_mean(name, known) or _NOT_NEEDED.get(name.upper(), "")
            advice = advice or (f"it takes {listed(known, 'and')}" if known else "it takes none")
            self._evaluator.fault(place, "unknown-argument", f"{word} has no argument '{name}'", advice)
            return None
        if known[name] in free:
            free.remove(known[name])
        return known[name]

    def _report_unnamed(self, word: str, argument: Argument, known: Mapping[str, ArgumentSlot]) -> None:
        if isinstance(argument.value, Name):
            name = argument.value.name
            advice = did_you_mean(name, known) or _NOT_NEEDED.get(name.upper(), "")
            if advice:
                message = f"{word} has no argument '{name}'"
                self._evaluator.fault(argument.place, "unknown-argument", message, advice)
                return
        names = [slot.name for slot in known.values() if slot.shape not in {Shape.FLAG, Shape.CLAUSE}]
        advice = f"name it, as in {names[0]}=..." if names else ""
        self._evaluator.fault(argument.place, "too-many-arguments", f"{word} has no place for this argument", advice)

    def _value(self, argument: Argument, slot: ArgumentSlot, known: Mapping[str, ArgumentSlot]) -> Any:
        if slot.shape is Shape.CLAUSE:
            return self._clause(argument, slot)
        if slot.shape is Shape.FLAG:
            return self._flag(argument, slot, known)
        if slot.shape in {Shape.SIGNAL, Shape.WORD, Shape.EFFECT}:
            if isinstance(argument.value, Name):
                return LEFT_OUT if self._scope.get(argument.value.name) is LEFT_OUT else str(argument.value.name)
            self._evaluator.fault(argument.value.place, "bad-argument", f"{slot.name} is {slot.shape.value}")
            return None
        if slot.shape is Shape.VALUE and isinstance(argument.value, Name) and argument.value.name not in self._scope:
            # A name of the signal's enumeration; it is looked up when the signal's kind is known.
            return str(argument.value.name)
        return self._computed(argument.value, slot, known)

    def _flag(self, argument: Argument, slot: ArgumentSlot, known: Mapping[str, ArgumentSlot]) -> bool | LeftOut | None:
        """Return the value of a flag: True if it has none. A flag that is false counts as not given."""
        if argument.name is None:
            if isinstance(argument.value, Name):
                return True
            message = f"{slot.name} takes no parentheses: write it alone or as {slot.name}=true"
            self._evaluator.fault(argument.place, "bad-argument", message)
            return None
        value = self._computed(argument.value, slot, known)
        return LEFT_OUT if value is False else value  # type: ignore[return-value]  # `_checked` requires a bool

    def _computed(self, expression: Expression, slot: ArgumentSlot, known: Mapping[str, ArgumentSlot]) -> Result:
        if isinstance(expression, Name) and expression.name not in self._scope:
            self._report_unknown(expression, slot, known)
            return None
        return self._checked(slot, expression, self._evaluator.evaluate(expression, self._scope))

    def _report_unknown(self, name: Name, slot: ArgumentSlot, known: Mapping[str, ArgumentSlot]) -> None:
        """Report a name that is not in the scope; suggest a flag, or the declaration of a group."""
        flags = [other.name for other in known.values() if other.shape is Shape.FLAG]
        advice = did_you_mean(name.name, [*self._scope, *flags])
        if not advice and slot.shape is Shape.GROUP:
            advice = f"declare it: group {name.name}(RATE=100);"
        self._evaluator.report_unknown(name, advice)

    def _clause(self, argument: Argument, slot: ArgumentSlot) -> Bound | LeftOut | None:
        """Return the values of a clause; the clause is left out if a required argument of it is `none`."""
        value = argument.value
        if argument.name is not None:
            names = ", ".join(inner.name.lower() for inner in slot.clause)
            self._evaluator.fault(
                argument.place, "bad-argument", f"{slot.name} takes parentheses: {slot.name}({names})"
            )
            return None
        given = value.arguments if isinstance(value, Call) else []
        # Signals of joints and sensors cannot be given by position: only the names of their arguments distinguish them.
        by_place = 0 if slot.name == "JOINTS" or slot.name in SENSORS else len(slot.clause)
        prefix = f"{slot.name}."
        bound = self._bind(slot.name, value.place, given, slot.clause, by_place, prefix)
        # SAFE with the lease `none` is kept: the register then begins with its safe value.
        if slot.name != "SAFE" and any(inner.required and bound.get(inner.name) is LEFT_OUT for inner in slot.clause):
            self.places = {name: place for name, place in self.places.items() if not name.startswith(prefix)}
            return LEFT_OUT
        return {name: inner for name, inner in bound.items() if inner is not LEFT_OUT}

    def _checked(self, slot: ArgumentSlot, expression: Expression, value: Result) -> Result:
        if value is None or value is LEFT_OUT:
            return value
        # Compare the exact type: isinstance would accept a bool as an int.
        if type(value) not in _TYPES[slot.shape]:
            message = f"{slot.name} is {slot.shape.value}, not {describe(value)}"
            self._evaluator.fault(expression.place, "bad-argument", message)
            return None
        if isinstance(value, (int, float)) and (
            (slot.low is not None and value < slot.low) or (slot.high is not None and value > slot.high)
        ):
            message = f"{slot.name} is {value:.12g}, and {slot.low:.12g} to {slot.high:.12g} is expected"
            self._evaluator.fault(expression.place, "out-of-range", message)
            return None
        return value
