"""Changes of specs. Each changes one property of one item; compatible and incompatible changes are listed apart.

A compatible change leaves programs for the old spec right. Changes are made in the syntax tree, by the meaning of the
language, independently of the code that compares interfaces.
"""

from __future__ import annotations

import functools
import pickle
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from unity_link.spec import Access, Interface, SpecError, compile_text
from unity_link.spec.diagnostics import Reporter, SourceText
from unity_link.spec.parser import parse
from unity_link.spec.printer import print_file
from unity_link.spec.syntax import (
    Argument,
    Bits,
    Call,
    Chain,
    ComponentDeclaration,
    EnumDeclaration,
    Expression,
    File,
    GroupDeclaration,
    KindSpecifier,
    Name,
    Number,
    Parenthesis,
    Placement,
    SignalDeclaration,
    Word,
)

if TYPE_CHECKING:
    import random
    from collections.abc import Callable, Iterator

    Changing = Callable[[File, random.Random], tuple[str, str] | None]
    """A function that changes a tree; it returns the item and the property, or None if the tree has nothing to change.
    """

T = TypeVar("T")
ROOT = Path(__file__).parents[2]
ROVER, SCARA, WALKER = (ROOT / "examples" / f"{name}.ul" for name in ("rover", "scara", "walker"))
BALANCER, CORES = ROOT / "examples" / "balancer" / "balancer.ul", ROOT / "tests" / "generate" / "cores.ul"
_ATTEMPTS = 200


class Change(NamedTuple):
    """A spec after one change."""

    text: str
    interface: Interface
    thing: str
    """A part of the name of the changed item; empty for a compatible change."""
    what: str
    """The property that differs."""


def changed(path: Path, chance: random.Random, changes: dict[str, Changing]) -> tuple[str, Change]:
    """Return the name of a random change, and the changed spec. Draw again if the compiler refuses the changed spec."""
    for _ in range(_ATTEMPTS):
        file: File = pickle.loads(_pickled(path))
        # A change returns None if it changed nothing, or changed a part that the compiler does not read.
        name, done = next(
            (name, done)
            for name in iter(lambda: chance.choice(sorted(changes)), "")
            if (done := changes[name](file, chance)) is not None
        )
        new = print_file(file)
        try:
            interface = compile_text(new, path.name, path=path).interface()
        except SpecError:
            continue
        return name, Change(new, interface, *done)
    raise AssertionError(f"{path}: no change of {', '.join(changes)} was found")


# The tree


@functools.cache
def _pickled(path: Path) -> bytes:
    """Return the pickled tree of a file; each change gets a copy. Parsing takes most of the time of these tests."""
    return pickle.dumps(parse(SourceText("", path.read_text()), Reporter()))


@functools.cache
def _expression(text: str) -> Expression:
    file = parse(SourceText("", f"public a() {{ @b = {text}: READ(); }}"), Reporter())
    assert file is not None
    (signal,) = _of(file, SignalDeclaration)
    assert signal.address is not None
    return signal.address


def _of(file: File, kind: type[T]) -> list[T]:
    """Return all declarations of a kind."""

    def within(members: list[SignalDeclaration | Placement]) -> Iterator[object]:
        for member in members:
            yield member
            yield from within(member.members or []) if isinstance(member, Placement) else ()

    found: list[object] = list(file.items)
    for item in file.items:
        found += within(item.members) if isinstance(item, ComponentDeclaration) else ()
    return [one for one in found if isinstance(one, kind)]


def _signals(file: File) -> list[SignalDeclaration]:
    """Return all signals; pins and triggers, which have the same syntax, are left out."""
    return [one for one in _of(file, SignalDeclaration) if one.access in Access.__members__]


def _any(chance: random.Random, things: list[T]) -> T | None:
    return chance.choice(things) if things else None


def _root(file: File) -> ComponentDeclaration:
    return next(one for one in _of(file, ComponentDeclaration) if one.public)


def _argument(arguments: list[Argument], name: str) -> Argument | None:
    """Return the argument with a name: its own name, that of its clause, or that of its flag."""
    for one in arguments:
        called = one.name or (one.value.name if isinstance(one.value, Call | Name) else None)
        if called == name:
            return one
    return None


def _put(arguments: list[Argument], name: str, value: str) -> bool:
    """Set the value of an argument; return True if the value differs from the one before."""
    given, new = _argument(arguments, name), _expression(value)
    if given is None:
        arguments.append(Argument(Word(name), new))
        return True
    is_other = given.value != new
    given.value = new
    return is_other


# Incompatible changes


def _value(name: str, *values: str) -> Changing:
    def change(file: File, chance: random.Random) -> tuple[str, str] | None:
        signal = _any(chance, _signals(file))
        if signal is None or not _put(signal.arguments, name, chance.choice(values)):
            return None
        return str(signal.name), name

    return change


def _without(name: str) -> Changing:
    def change(file: File, chance: random.Random) -> tuple[str, str] | None:
        having = [one for one in _signals(file) if _argument(one.arguments, name)]
        signal = _any(chance, having)
        if signal is None:
            return None
        signal.arguments = [one for one in signal.arguments if one is not _argument(signal.arguments, name)]
        return str(signal.name), name

    return change


def _address(file: File, chance: random.Random) -> tuple[str, str] | None:
    signal = _any(chance, [one for one in _signals(file) if one.address is not None])
    if signal is None or signal.address is None:
        return None
    signal.address = Chain([Parenthesis(signal.address), Number(str(chance.randint(1, 90)))], ["+"])
    return str(signal.name), "address"


def _bit(file: File, chance: random.Random) -> tuple[str, str] | None:
    signal = _any(chance, [one for one in _signals(file) if one.bits is not None])
    if signal is None or signal.bits is None:
        return None
    up = [None if one is None else Chain([one, Number("1")], ["+"]) for one in (signal.bits.high, signal.bits.low)]
    assert up[0] is not None
    signal.bits = Bits(up[0], up[1])
    return str(signal.name), "lowest bit"


def _type(file: File, chance: random.Random) -> tuple[str, str] | None:
    other = {"unsigned": "signed", "signed": "unsigned", "fixed": "ufixed", "ufixed": "fixed"}
    signal = _any(chance, _signals(file))
    kind = KindSpecifier(Word("unsigned")) if signal is None or signal.kind is None else signal.kind
    if signal is None or kind.name not in other:
        return None
    signal.kind = KindSpecifier(Word(other[kind.name]), kind.width)
    return str(signal.name), "type"


def _width(file: File, chance: random.Random) -> tuple[str, str] | None:
    signal = _any(chance, _signals(file))
    if signal is None or signal.kind is None or signal.bits is not None:
        return None
    width = signal.kind.width
    if isinstance(width, Number) and "." not in width.text:
        signal.kind.width = Number(str(int(width.text) - 1))
    elif width is None and signal.kind.name in {"signed", "unsigned"}:
        signal.kind.width = Number(str(chance.randint(8, 31)))
    else:
        return None
    return str(signal.name), "type"


def _access(file: File, chance: random.Random) -> tuple[str, str] | None:
    signal = _any(chance, _signals(file))
    if signal is None:
        return None
    signal.access = Word(chance.choice([one for one in ("READ", "WRITE", "READWRITE") if one != signal.access]))
    return str(signal.name), "access"


def _clause(name: str, what: str, *values: str) -> Changing:
    """Return a change of the first argument of a clause."""

    def change(file: File, chance: random.Random) -> tuple[str, str] | None:
        signal = _any(chance, [one for one in _signals(file) if _argument(one.arguments, name)])
        given = None if signal is None else _argument(signal.arguments, name)
        if signal is None or given is None or not isinstance(given.value, Call):
            return None
        new = _expression(chance.choice(values))
        if given.value.arguments[0].value == new:
            return None
        given.value.arguments[0].value = new
        return str(signal.name), what

    return change


def _gone(file: File, chance: random.Random) -> tuple[str, str] | None:
    component = _any(chance, _of(file, ComponentDeclaration))
    signal = _any(
        chance, [] if component is None else [one for one in component.members if isinstance(one, SignalDeclaration)]
    )
    if component is None or signal is None or signal.access not in Access.__members__:
        return None
    component.members.remove(signal)
    return str(signal.name), "is not on the board"


def _renamed(file: File, chance: random.Random) -> tuple[str, str] | None:
    signal = _any(chance, _signals(file))
    if signal is None:
        return None
    old, signal.name = str(signal.name), Word(f"{signal.name}_new")
    return old, "is not on the board"


def _shared(file: File, _: random.Random) -> tuple[str, str] | None:
    """Put another signal into the highest bit of a word that a single signal had for itself."""
    for one in _root(file).members:
        if isinstance(one, SignalDeclaration) and one.bits is None and one.access == "READWRITE":
            _root(file).members.append(
                SignalDeclaration(
                    Word("new"), one.address, Bits(Number("31")), KindSpecifier(Word("bool")), Word("READWRITE"), []
                )
            )
            return str(one.name), "its word"
    return None


def _enumeration(file: File, chance: random.Random) -> tuple[str, str] | None:
    enumeration = _any(chance, _of(file, EnumDeclaration))
    users = (
        []
        if enumeration is None
        else [one for one in _signals(file) if one.kind is not None and one.kind.name == enumeration.name]
    )
    if enumeration is None or not users:
        return None
    if chance.random() < 0.5:
        enumeration.members[-1].value = Number("7")
    else:
        enumeration.members[0].name = Word("other")
    return str(users[0].name), "values"


def _group(file: File, chance: random.Random) -> tuple[str, str] | None:
    group = _any(chance, _of(file, GroupDeclaration))
    if group is None:
        return None
    thing, rate, flags = f"group {group.name}", _argument(group.arguments, "RATE"), ("TIMESTAMPS", "ON_CHANGE")
    positional = [one for one in group.arguments if one.name is None and isinstance(one.value, Number)]
    ways = ["RATE"] * (rate is not None) + ["divisor"] * (len(positional) > 1) + [*flags]
    ways += ["TRIGGER"] * (_argument(group.arguments, "TRIGGER") is not None and bool(positional))
    match chance.choice(ways):
        case "RATE":
            assert rate is not None
            rate.value = Chain([rate.value, Number("2")], ["*"])
            return thing, "RATE"
        case "divisor":
            positional[1].value = Number("50")
            return thing, "divisor"
        case "TRIGGER":
            positional[0].value = Number("9")
            return thing, "TRIGGER"
        case flag:
            given = _argument(group.arguments, flag)
            if given is None:
                group.arguments.append(Argument(None, Name(Word(flag))))
            else:
                group.arguments.remove(given)
            return thing, flag


_OF_CORES = {
    "PWM": {
        "FREQUENCY": ("10000", "generic frequency_hz"),
        "LIMIT": ("9", "SCALE"),
        "CENTRE": ("true", "generic centre"),
        "UNIT": ('"A"', "UNIT"),
        "WIDTH": ("11", "type"),
        "LEASE": ("none", "SAFE"),
        "SCHEDULE": ("none", "TIMED"),
    },
    "LEASE": {"TIMEOUT": ("0.3", "generic most_us")},
    "ENCODER": {
        "FILTER": ("7", "generic filter"),
        "COUNTS": ("1000", "SCALE"),
        "COUNTER": ("true", "generic counter"),
        "GROUP": ("none", "PUBLISH"),
    },
    "SCHEDULE": {"DEPTH": ("128", "generic depth")},
}


def _core(file: File, chance: random.Random) -> tuple[str, str] | None:
    place = _any(chance, [one for one in _of(file, Placement) if one.type in _OF_CORES])
    if place is None:
        return None
    name = chance.choice(sorted(_OF_CORES[place.type]))
    value, what = _OF_CORES[place.type][name]
    if (value == "none" and not _argument(place.arguments, name)) or not _put(place.arguments, name, value):
        return None
    return str(place.name), what


def _entity(file: File, chance: random.Random) -> tuple[str, str] | None:
    entity = _any(chance, [one for one in _of(file, Placement) if one.type == "ENTITY"])
    if entity is None:
        return None
    if chance.random() < 0.5:
        entity.arguments[0].value = _expression('"other_entity"')
        return "", "ENTITY"
    return ("", "generic weight") if _put(entity.arguments, "weight", "4") else None


def _place(file: File, chance: random.Random) -> tuple[str, str] | None:
    place = _any(chance, [one for one in _of(file, Placement) if one.addresses and one.name is not None])
    if place is None or not place.addresses:
        return None
    address = chance.choice([one for one in place.addresses if one.name is None])
    address.value = Chain([Parenthesis(address.value), Number(str(chance.randint(1, 90)))], ["+"])
    return str(place.name), "address"


def _fewer(file: File, chance: random.Random) -> tuple[str, str] | None:
    place = _any(chance, [one for one in _of(file, Placement) if isinstance(one.count, Number)])
    if place is None or not isinstance(place.count, Number):
        return None
    place.count = Number(str(int(place.count.text) - 1))
    return f"{place.name}[{place.count.text}]", "is not on the board"


def _interface(file: File, _: random.Random) -> tuple[str, str] | None:
    _root(file).name = Word("other")
    return "the interface", "name"


def _gateway(name: str, bits: int) -> Changing:
    def change(file: File, _: random.Random) -> tuple[str, str] | None:
        root = _root(file)
        root.members = [one for one in root.members if not (isinstance(one, Placement) and one.type == "GATEWAY")]
        given = [Argument(Word(name), Number(str(bits)))]
        root.members.append(Placement(None, None, Word("GATEWAY"), given, None))
        return "the interface", "data bits"

    return change


INCOMPATIBLE: dict[str, Changing] = {
    "SCALE": _value("SCALE", "0.003", "0.7", "-0.5"),
    "OFFSET": _value("OFFSET", "0.5", "-3"),
    "UNIT": _value("UNIT", '"furlong"', '"mm"'),
    "MIN": _value("MIN", "1", "0.25", "-0.125"),
    "MAX": _value("MAX", "1", "0.25", "2"),
    "RESET": _value("RESET", "1", "true", "3", "2"),
    "no SCALE": _without("SCALE"),
    "no UNIT": _without("UNIT"),
    "no RESET": _without("RESET"),
    "no SAFE": _without("SAFE"),
    "no TIMED": _without("TIMED"),
    "TIMED": _clause("TIMED", "TIMED", "plan", "other"),
    "no PUBLISH": _without("PUBLISH"),
    "no FIFO": _without("FIFO"),
    "SAFE": _clause("SAFE", "SAFE", "3", "1", "false", "HOLD", "off"),
    "depth": _clause("FIFO", "FIFO", "32", "2"),
    "PUBLISH": _clause("PUBLISH", "PUBLISH", "other_group", "slow", "motion", "state"),
    "address": _address,
    "bit": _bit,
    "type": _type,
    "width": _width,
    "access": _access,
    "gone": _gone,
    "renamed": _renamed,
    "shared": _shared,
    "enumeration": _enumeration,
    "group": _group,
    "core": _core,
    "entity": _entity,
    "place": _place,
    "fewer": _fewer,
    "interface": _interface,
    "data bits": _gateway("DATA_BITS", 64),
}

OF_CORES = {
    name: INCOMPATIBLE[name]
    for name in ("core", "entity", "SAFE", "no SAFE", "TIMED", "no TIMED", "enumeration", "place")
}
"""Incompatible changes of cores and of the leases and schedules of their signals."""


# Compatible changes


def _signal(file: File, chance: random.Random) -> tuple[str, str]:
    at, width = _expression(str(chance.randint(0, 0xE0))), KindSpecifier(Word("signed"), Number("9"))
    access = Word(chance.choice(["READ", "READWRITE"]))
    new = SignalDeclaration(Word("new"), at, None, width, access, [])
    _root(file).members.insert(chance.randint(0, len(_root(file).members)), new)
    return "", ""


def _sampled(file: File, chance: random.Random) -> tuple[str, str] | None:
    """Add a signal to an existing group."""
    group = _any(chance, _of(file, GroupDeclaration))
    if group is None:
        return None
    at, publish = _expression(str(chance.randint(0, 0xE0))), Call(Word("PUBLISH"), [Argument(None, Name(group.name))])
    new = SignalDeclaration(Word("new"), at, None, None, Word("READ"), [Argument(None, publish)])
    _root(file).members.append(new)
    return "", ""


def _comment(file: File, chance: random.Random) -> tuple[str, str]:
    chance.choice(_signals(file)).doc = ["Another text."]
    return "", ""


def _unused_group(file: File, chance: random.Random) -> tuple[str, str]:
    new = GroupDeclaration(Word(chance.choice(["new", "spare"])), [Argument(Word("RATE"), Number("50"))])
    file.items.insert(chance.randint(0, len(file.items)), new)
    return "", ""


def _order(file: File, chance: random.Random) -> tuple[str, str]:
    chance.shuffle(file.items)
    chance.shuffle(chance.choice(_of(file, ComponentDeclaration)).members)
    return "", ""


def _id(file: File, chance: random.Random) -> tuple[str, str]:
    signal = chance.choice(_signals(file))
    signal.arguments = [one for one in signal.arguments if one is not _argument(signal.arguments, "ID")]
    return "", ""


def _component(file: File, chance: random.Random) -> tuple[str, str] | None:
    component = _any(chance, [one for one in _of(file, ComponentDeclaration) if not one.public])
    if component is None:
        return None
    for place in _of(file, Placement):
        if place.type == component.name:
            place.type = Word("other_component")
    component.name = Word("other_component")
    return "", ""


def _pin(file: File, chance: random.Random) -> tuple[str, str] | None:
    """Connect a core to another pin."""
    place = _any(chance, [one for one in _of(file, Placement) if one.type in _OF_CORES])
    named = [] if place is None or place.addresses is None else [one for one in place.addresses if one.name]
    pin = _any(chance, named)
    if pin is None:
        return None
    pin.value = _expression('"gp27"')
    return "", ""


def _wider(file: File, chance: random.Random) -> tuple[str, str] | None:
    done: tuple[str, str] | None = _gateway("ADDRESS_BITS", chance.randint(9, 32))(file, chance)
    return done and ("", "")


COMPATIBLE: dict[str, Changing] = {
    "signal": _signal,
    "signal in a group": _sampled,
    "comment": _comment,
    "unused group": _unused_group,
    "order": _order,
    "id": _id,
    "name of a component": _component,
    "pin": _pin,
    "address bits": _wider,
}
