"""The hardware of a component: its VHDL entity with generics, pins and triggers."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple, TypeGuard

from unity_link.spec.arguments import PIN, TRIGGER, Binder, Bound
from unity_link.spec.diagnostics import did_you_mean, listed
from unity_link.spec.expressions import LEFT_OUT, Result, describe
from unity_link.spec.interface import SignalPlace
from unity_link.spec.model import Core, Pin, Trigger, Way
from unity_link.spec.syntax import Argument, ComponentDeclaration, Name, Placement, SignalDeclaration, Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from unity_link.spec.building import Builder, Where
    from unity_link.spec.diagnostics import SourceText
    from unity_link.spec.expressions import Evaluator
    from unity_link.spec.syntax import Expression, Node, Word

ENTITY_WORD = "ENTITY"
LIMIT_WORDS = ("RANGE", "ONE_OF")
"""Words that limit the values of a parameter."""
CLOCK = "CLOCK"
"""Name of the clock frequency in Hz, in an expression of a limit."""
AXES = "AXES"
"""Name of the number of placements that share one instance of the entity, in an expression of a limit."""
_SLOTS = {"PIN": PIN, "TRIGGER": TRIGGER}
PORT_WORDS = tuple(_SLOTS)
"""Words in the position of an access that declare a port without an address."""
WANTS = {
    "TICK": ("tick",),
    "TIME": ("now",),
    "ARMED": ("armed",),
    "STAGE": ("stage", "armed", "finishing"),
    "EMPTY": ("empty",),
}
"""Words of ENTITY for additional ports, and the entries that each adds to `Core.wants`."""
_IDENTIFIER = re.compile(r"[a-z](_?[a-z0-9])*", re.IGNORECASE)
_PRINTABLE = re.compile(r"[ -~]*")
_GIVEN = ("axes", "clock_hz")
"""Generics that the generated design sets."""
_LARGEST = (1 << 31) - 1


_EDGES = (-math.inf, math.inf)
"""Bounds of a RANGE whose bound is `none`."""


class Limit(NamedTuple):
    """A RANGE or ONE_OF of a component."""

    member: Placement
    """The statement."""
    name: str
    bounds: list[Expression]
    held: dict[str, Expression]
    """Values of other parameters under which the limit applies."""


def pins_of(node: ComponentDeclaration) -> list[Word]:
    """Return the names of the pins of a component."""
    return [member.name for member in node.members if isinstance(member, SignalDeclaration) and member.access == "PIN"]


class Hardware:
    """The hardware of a component while its members are read.

    Args:
        evaluator: of the component's source.
        where: place of the component.
        is_interface: whether the component is a public interface, which cannot have an ENTITY.
    """

    def __init__(self, evaluator: Evaluator, where: Where, *, is_interface: bool) -> None:
        self._evaluator = evaluator
        self._where = where
        self._is_interface = is_interface
        self._entity: tuple[str, list[str], dict[str, int | bool | str]] | None = None
        self._placed: Placement | None = None
        self._refused: set[str] = set()
        """Names of parameters that violate a limit."""
        self._ports: dict[str, tuple[int, int]] = {}
        self._pins: list[Pin] = []
        self._triggers: list[Trigger] = []

    def set_entity(self, member: Placement) -> None:
        """Read an ENTITY; a second one is reported."""
        place = member.type.place
        if self._placed is not None:
            self._fault(place, "name-twice", "this component has two ENTITY statements")
            return
        self._placed = member
        if member.addresses is not None or member.members is not None:
            self._fault(place, "misplaced", "ENTITY has neither addresses nor members")
        if self._is_interface:
            message = "an interface is the whole design, and ENTITY belongs in a component of it"
            self._fault(place, "misplaced", message)
            return
        first, rest = member.arguments[:1], member.arguments[1:]
        name = first[0].value.value if first and isinstance(first[0].value, Text) and first[0].name is None else None
        if name is None or not _IDENTIFIER.fullmatch(name):
            place = first[0].place if first else place
            message = "ENTITY begins with the name of an entity in VHDL"
            self._fault(place, "bad-entity", message, 'as in ENTITY("ul_pwm", width=WIDTH);')
            return
        wants: list[str] = []
        generics: dict[str, int | bool | str] = {}
        for argument in rest:
            if argument.name is None:
                wants += self._want(argument)
            elif argument.name.lower() in {*map(str.lower, generics), *_GIVEN}:
                what = "is given by the design" if argument.name.lower() in _GIVEN else "is given twice"
                self._fault(argument.place, "argument-twice", f"{argument.name} {what}")
            else:
                generics |= self._generic(argument)
        self._entity = name.lower(), list(dict.fromkeys(wants)), generics

    def check_limit(self, builder: Builder, node: ComponentDeclaration, member: Placement) -> None:
        """Check a parameter against a RANGE or a ONE_OF."""
        known = {str(one.name) for one in node.parameters}
        first, others = member.arguments[:1], member.arguments[1:]
        name = next((str(one.value.name) for one in first if one.name is None and isinstance(one.value, Name)), "")
        bounds = [one.value for one in others if one.name is None]
        held = {str(one.name): one.value for one in others if one.name is not None}
        is_whole = len(bounds) == 2 if member.type == "RANGE" else bool(bounds)
        if not is_whole or not {name, *held} <= known or member.addresses is not None or member.members is not None:
            message = f"{member.type} takes a parameter of {node.name}, and then its allowed values"
            advice = 'as in RANGE(WIDTH, 2, 24); or ONE_OF(MODE, "a", "b");'
            self._fault(member.type.place, "bad-limit", message, advice)
            return
        limit = Limit(member, name, bounds, held)
        if not self._refused.isdisjoint(words := self._words(member)):
            return
        own = self._evaluator.source, member.place
        place = SignalPlace(*(self._given(name) or self._where.placed or own))
        if AXES in words:
            builder.limit_axes(self._where.path, place, lambda axes, clock_hz: self._beyond(limit, clock_hz, axes))
        elif message := builder.limit(lambda clock_hz: self._beyond(limit, clock_hz)):
            builder.context.reporter.error(*place, "out-of-range", message)
            self._refused.add(name)
            builder.context.reporter.refuse()

    def _beyond(self, limit: Limit, clock_hz: int, axes: int = 1) -> str:
        """Return why a parameter violates a limit; empty if it does not, or if a value is unknown."""
        scope = {**self._where.scope, CLOCK: clock_hz, AXES: axes}
        value = scope.get(limit.name)
        bounds = [self._evaluator.evaluate(one, scope) for one in limit.bounds]
        held = {name: self._evaluator.evaluate(one, scope) for name, one in limit.held.items()}
        if value is None or value is LEFT_OUT or None in bounds or any(scope.get(name) != held[name] for name in held):
            return ""
        if limit.member.type == "RANGE":
            low, high = (edge if one is LEFT_OUT else one for one, edge in zip(bounds, _EDGES, strict=True))
            if not (_is_number(low) and _is_number(high)):
                self._fault(limit.member.place, "bad-limit", "RANGE takes two numbers after the parameter")
                return ""
            is_allowed = _is_number(value) and low <= value <= high
            expected = _span(low, high)
        else:
            is_allowed = any(value == one and isinstance(value, bool) is isinstance(one, bool) for one in bounds)
            expected = listed([_plain(one) for one in bounds])
        expected += "".join(f" with {name}={_plain(one)}" for name, one in held.items())
        words = self._words(limit.member)
        expected += f" at a clock of {clock_hz:,} Hz" * (CLOCK in words)
        expected += f" with {axes} {'axis' if axes == 1 else 'axes'} in one instance" * (AXES in words)
        return "" if is_allowed else f"{self._where.path}: {limit.name} is {_plain(value)}, expected {expected}"

    def _words(self, node: Node) -> set[str]:
        """Return the words in the source text of a node."""
        return set(re.findall(r"\w+", self._evaluator.source.text[slice(*node.place)]))

    def _given(self, *names: str) -> tuple[SourceText, tuple[int, int]] | None:
        """Return the place of the argument for the first of these parameters that has one."""
        found = next((self._where.given[name] for name in names if name in self._where.given), None)
        return None if found is None else (found.source, found.bounds)

    def _want(self, argument: Argument) -> Iterator[str]:
        word = argument.value.name if isinstance(argument.value, Name) else None
        if word in WANTS:
            yield from WANTS[word]
            return
        message = f"ENTITY takes the words {listed(WANTS, 'and')}, and generics by their names"
        advice = did_you_mean(word, WANTS) if word is not None else ""
        self._fault(argument.place, "unknown-argument", message, advice)

    def _generic(self, argument: Argument) -> dict[str, int | bool | str]:
        assert argument.name is not None
        name, value = argument.name, self._evaluator.evaluate(argument.value, self._where.scope)
        if value is None or value is LEFT_OUT or self._refused & self._words(argument):
            return {}
        # Round 1.001 * 1000000: the float is not a whole number.
        if isinstance(value, float) and math.isclose(value, round(value), rel_tol=1e-12):
            value = round(value)
        if not _IDENTIFIER.fullmatch(name):
            self._fault(name.place, "bad-entity", f"'{name}' cannot be the name of a generic in VHDL")
        elif isinstance(value, int | str) and _fits(value):
            return {name.lower(): value}
        else:
            message = f"{name} is {_described(value)}, and a generic is a whole number of 32 bits, a truth or a string"
            given = self._given(*sorted(self._words(argument)))
            source, place = given or (self._evaluator.source, argument.value.place)
            self._evaluator.reporter.error(source, place, "bad-entity", f"{self._where.path}: {message}")
        return {}

    def add_port(self, builder: Builder, source: SourceText, member: SignalDeclaration) -> None:
        """Read the declaration of a pin or a trigger."""
        word = str(member.access)
        if member.address is not None or member.bits is not None or member.kind is not None:
            message = f"{member.name} is a {word.lower()}, which has neither an address nor a kind"
            self._fault(member.name.place, "misplaced", message, f"as in @{member.name}: {word}(...);")
        if not _IDENTIFIER.fullmatch(member.name):
            self._fault(member.name.place, "bad-pin", f"'{member.name}' cannot be the name of a port in VHDL")
            return
        self._ports[str(member.name)] = member.name.place
        binder = Binder(self._evaluator, self._where.scope)
        bound = binder.bind(member.access, member.access.place, member.arguments, _SLOTS[word], by_place=2)
        if word == "TRIGGER":
            self._triggers.append(builder.trigger(source, member, binder.places.get("GROUP", member.place), bound))
        else:
            self._pins += self._pin(member, bound)

    def _pin(self, member: SignalDeclaration, bound: Bound) -> Iterator[Pin]:
        way = bound.get("WAY")
        if way is None:
            return
        if way not in Way.__members__:
            message = f"a pin is {listed(Way.__members__)}, not {way}"
            self._fault(member.access.place, "bad-pin", message, did_you_mean(way, Way.__members__))
            return
        name = str(member.name)
        path = f"{self._where.path}.{name}" if self._where.path else name
        at = self._where.pins.get(name)
        yield Pin(
            name=name,
            path=path,
            way=Way[way],
            at=None if at is LEFT_OUT else at,
            is_used=at is not LEFT_OUT,
            unwired=bound.get("UNWIRED", 0),
        )

    def refuse_parts(self) -> None:
        """Report that a component with an ENTITY contains parts, modules or FIFO ports."""
        if self._placed is not None:
            message = "a component with an ENTITY has signals, pins and triggers, and no FIFO port, part or module"
            self._fault(self._placed.type.place, "bad-entity", message)

    def check_leases(self, leases: set[str]) -> None:
        """Report signals of an entity that are guarded by different leases: it has one input ARMED."""
        if self._placed is not None and len(leases) > 1:
            message = f"the signals of an entity are guarded by one lease, not by {listed(sorted(leases), 'and')}"
            self._fault(self._placed.type.place, "bad-safe", message)

    def check_holds(self, signals: Mapping[str, tuple[int, int]]) -> None:
        """Report signals with HOLD if the entity has no input ARMED, so that it cannot stop when the lease ends."""
        if self._entity is not None and "armed" in self._entity[1]:
            return
        for name, place in signals.items():
            message = f"{name} keeps its value when the lease ends, and no core stops then"
            advice = "HOLD needs a component whose ENTITY has the input ARMED; elsewhere name a safe value"
            self._fault(place, "bad-safe", message, advice)

    def core(self, component: Word, widths: Mapping[str, set[int]]) -> Core | None:
        """Return the hardware of a component; None if it has no ENTITY.

        Args:
            component: name of the component.
            widths: widths of its signals, by name; the signals of a row may differ.

        Ports of a component without ENTITY are reported.
        """
        if self._placed is None:
            for name, place in self._ports.items():
                message = f"{name} is a port of no entity: {component} has no ENTITY"
                self._fault(place, "bad-entity", message, 'as in ENTITY("ul_pwm", width=WIDTH);')
            return None
        for name in widths:
            if not _IDENTIFIER.fullmatch(name):
                message = f"'{name}' cannot be the name of a port in VHDL"
                self._fault(self._placed.type.place, "bad-entity", message)
            elif len(widths[name]) > 1:
                message = f"the signals in the row {name} have {listed(sorted(map(str, widths[name])), 'and')} bits"
                advice = "those of a component with an ENTITY have one width, because one port has all of them"
                self._fault(self._placed.type.place, "bad-entity", message, advice)
        if self._entity is None:
            return None
        entity, wants, generics = self._entity
        folder = self._where.core
        return Core(
            word="" if folder is None else folder.word,
            entity=entity,
            library="unity_link" if folder is not None and folder.is_installed else "work",
            vhdl=() if folder is None or folder.is_installed else tuple(map(str, folder.vhdl)),
            wants=tuple(wants),
            generics=generics,
            per_axis=self._per_axis(generics),
            pins=tuple(self._pins),
            triggers=tuple(self._triggers),
            python="" if folder is None else folder.python,
        )

    def _per_axis(self, generics: Mapping[str, int | bool | str]) -> tuple[str, ...]:
        """Return the names of the generics that have a value for each placement; each must be a whole number."""
        folder = self._where.core
        assert self._placed is not None
        try:
            names = () if folder is None else folder.per_axis
        except ValueError as error:
            self._fault(self._placed.type.place, "core", str(error))
            return ()
        for name in names:
            if type(generics.get(name)) is not int:
                what = "no generic of it" if name not in generics else f"{_plain(generics[name])}, no whole number"
                message = f"core.toml has {name} per axis, and that is {what}"
                self._fault(self._placed.type.place, "bad-entity", message)
        return names

    def _fault(self, place: tuple[int, int], code: str, message: str, advice: str = "") -> None:
        self._evaluator.fault(place, code, message, advice)


def _fits(value: int | str) -> bool:
    """Return whether a value can be that of a generic."""
    return bool(_PRINTABLE.fullmatch(value)) if isinstance(value, str) else -_LARGEST <= value <= _LARGEST


def _described(value: Result) -> str:
    return f"the number {value:.12g}" if isinstance(value, float) else describe(value)


def _is_number(value: Result) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _plain(value: Result) -> str:
    """Format a value in the syntax of a spec."""
    if isinstance(value, str):
        return f'"{value[:40]}"'
    return f"{value:.12g}" if _is_number(value) else describe(value)


def _span(low: float, high: float) -> str:
    """Format a range of numbers."""
    if low == high:
        return _plain(low)
    least, most = _plain(low), _plain(high)
    # Both bounds are allowed values, so rounding must not print one outside of the range.
    least = least if float(least) >= low else repr(low)
    most = most if float(most) <= high else repr(high)
    if high == math.inf:
        return f"at least {least}"
    return f"at most {most}" if low == -math.inf else f"{least} to {most}"
