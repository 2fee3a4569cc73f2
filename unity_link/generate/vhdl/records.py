"""The hardware's side of an interface as two nested records: values from hardware, and values to hardware.

A component becomes one record type for each direction; components of one declaration share a type if they have equal
elements. If the elements in an array differ (a width may depend on the index), the array becomes one element for each.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, NamedTuple

from unity_link.generate.vhdl.names import Scope
from unity_link.generate.vhdl.types import VhdlEnumeration, vhdl_type
from unity_link.spec import ComponentSpec, KindName

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from unity_link.spec import Interface, Signal


class Direction(enum.StrEnum):
    """Direction of a record; the value is the name of its port, and the end of the names of its types."""

    FROM = "from_hardware"
    TO = "to_hardware"


class Element(NamedTuple):
    """An element of a record."""

    name: str
    type: str
    comment: str = ""


class RecordType(NamedTuple):
    """A record type; with `item`, an array type."""

    name: str
    elements: tuple[Element, ...] = ()
    item: str = ""


class Pins(NamedTuple):
    """Names of a signal's elements in the two records, with the record; empty for elements that do not exist."""

    given: str = ""
    """Input: the value that is read, driven by hardware."""
    got: str = ""
    """Output: the written value, used by hardware."""
    written: str = ""
    """Output: '1' for one cycle at each write."""
    given_valid: str = ""
    given_ready: str = ""
    """FIFO port that is read: input, the word of hardware is valid; output, the word is taken."""
    got_valid: str = ""
    got_ready: str = ""
    """FIFO port that is written: output, a word is available; input, hardware takes it."""


def elements_of(signal: Signal, name: str, type_: str) -> Iterator[tuple[Direction, str, Element]]:
    """Yield the elements of a signal: direction, field of `Pins`, and element."""
    comment = str(signal.kind) if signal.kind.name in {KindName.FIXED, KindName.UFIXED, KindName.FLOAT} else ""
    value = Element(name, type_, comment)
    valid, ready = Element(f"{name}_valid", "std_logic"), Element(f"{name}_ready", "std_logic")
    if signal.fifo and signal.access.reads:
        yield Direction.FROM, "given", value
        yield Direction.FROM, "given_valid", valid
        yield Direction.TO, "given_ready", ready
    elif signal.is_given:
        yield Direction.FROM, "given", value
    if signal.fifo and signal.access.writes:
        yield Direction.TO, "got", value
        yield Direction.TO, "got_valid", valid
        yield Direction.FROM, "got_ready", ready
    elif signal.access.writes and not signal.is_given:
        yield Direction.TO, "got", value
        yield Direction.TO, "written", Element(f"{name}_written", "std_logic")


class RowElement(NamedTuple):
    """An element of a record for a signal or a row of signals."""

    direction: Direction
    pin: str
    """Name of the field of `Pins`."""
    element: Element
    places: dict[str, str]
    """Names of the element, or of its items, by signal path."""


def _endings(signals: tuple[Signal, ...]) -> list[str]:
    """Return the endings of names that a signal or a row may need."""
    ends = ("", "_valid", "_ready") if signals[0].fifo else ("", "_written")
    return [f"{place}{end}" for place in ("", *(f"_{one.index}" for one in signals)) for end in ends]


class Records:
    """The record types of an interface.

    Args:
        interface: the interface.
        signals: its signals that have elements, by path.
        enumerations: the VHDL types of its enumerations, by name.
        scope: names of the package, to which the types are added.
    """

    def __init__(
        self,
        interface: Interface,
        signals: Mapping[str, Signal],
        enumerations: Mapping[str, VhdlEnumeration],
        scope: Scope,
    ) -> None:
        self._signals = signals
        self._enumerations = enumerations
        self._scope = scope
        self._names: dict[str, dict[str, str]] = {}
        self._known: dict[tuple[str, Direction, tuple[Element, ...]], str] = {}
        self._of_component: dict[tuple[str, Direction], str | None] = {}
        self._arrays: dict[tuple[str, Direction], str | None] = {}
        self._rows: dict[str, str] = {}
        """Array types, by the type of their items."""
        self.types: list[RecordType] = []
        """All types, each after the types that it uses."""
        self.pins: dict[str, Pins] = {path: Pins() for path in signals}
        """Names of the elements, by signal path."""
        self.roots = {direction: self._record(interface.root, direction) for direction in Direction}
        """Names of the outermost types; None if the record would be empty."""
        for direction in Direction:
            self._place(interface.root, direction, direction.value)

    def _names_in(self, component: ComponentSpec) -> dict[str, str]:
        """Return the VHDL names of a component's members; both records use the same names."""
        if component.path not in self._names:
            scope = Scope()
            names = {name: scope.unique(name, *_endings(signals)) for name, signals in component.rows.items()}
            names |= {part.name: scope.unique(part.name) for part in component.parts if isinstance(part, ComponentSpec)}
            for part in component.parts:
                if not isinstance(part, ComponentSpec):
                    endings = (f"_{index}" for index in range(len(part.items)))
                    names[part.name] = scope.unique(part.name, "", *endings)
            self._names[component.path] = names
        return self._names[component.path]

    def _record(self, component: ComponentSpec, direction: Direction) -> str | None:
        elements = tuple(self._elements(component, direction))
        key = (component.type, direction, elements)
        if elements and key not in self._known:
            name = self._scope.unique(f"{component.type}_{direction}", "_t", "_array_t")
            self._known[key] = f"{name}_t"
            self.types.append(RecordType(f"{name}_t", elements))
        self._of_component[component.path, direction] = made = self._known.get(key)
        return made

    def _elements(self, component: ComponentSpec, direction: Direction) -> Iterator[Element]:
        names = self._names_in(component)
        for name, signals in component.rows.items():
            yield from (one.element for one in self._of_row(names[name], signals) if one.direction is direction)
        for part in component.parts:
            if isinstance(part, ComponentSpec):
                record = self._record(part, direction)
                if record is not None:
                    yield Element(names[part.name], record)
                continue
            records = [self._record(item, direction) for item in part.items]
            array = self._array(records)
            self._arrays[part.path, direction] = array
            if array is not None:
                yield Element(names[part.name], f"{array}(0 to {len(records) - 1})")
            else:
                yield from (
                    Element(f"{names[part.name]}_{index}", record)
                    for index, record in enumerate(records)
                    if record is not None
                )

    def _of_row(self, name: str, signals: tuple[Signal, ...]) -> Iterator[RowElement]:
        """Yield the elements of a signal or a row; if the signals of a row differ, elements for each of them."""
        types = {vhdl_type(signal.kind, self._enumerations) for signal in signals}
        own = [signal for signal in signals if signal.path in self._signals]
        if signals[0].index is None or len(types) > 1 or len(own) < len(signals):
            for signal in own:
                called = name if signal.index is None else f"{name}_{signal.index}"
                for direction, pin, one in elements_of(signal, called, vhdl_type(signal.kind, self._enumerations)):
                    yield RowElement(direction, pin, one, {signal.path: one.name})
            return
        for direction, pin, one in elements_of(signals[0], name, types.pop()):
            array = f"{self._array_of(one.type, signals[0].width)}(0 to {len(signals) - 1})"
            places = {signal.path: f"{one.name}({signal.index})" for signal in signals}
            yield RowElement(direction, pin, one._replace(type=array), places)

    def _array_of(self, item: str, width: int) -> str:
        """Return the array type for values of a type."""
        if item == "std_logic":
            return "std_logic_vector"
        if item not in self._rows:
            base = item.removesuffix("_t") if "(" not in item else f"{item.partition('(')[0]}_{width}"
            self._rows[item] = f"{self._scope.unique(base, '_array_t')}_array_t"
            self.types.append(RecordType(self._rows[item], item=item))
        return self._rows[item]

    def _array(self, records: list[str | None]) -> str | None:
        """Return the array type for records; None if they do not all have the same type."""
        first = records[0]
        if first is None or any(record != first for record in records):
            return None
        name = f"{first.removesuffix('_t')}_array_t"
        if not any(record.name == name for record in self.types):
            self.types.append(RecordType(name, item=first))
        return name

    def _place(self, component: ComponentSpec, direction: Direction, prefix: str) -> None:
        """Set the element names of all signals of a component, whose own record element is `prefix`."""
        names = self._names_in(component)
        for name, signals in component.rows.items():
            for one in self._of_row(names[name], signals):
                for path, place in one.places.items() if one.direction is direction else ():
                    self.pins[path] = self.pins[path]._replace(**{one.pin: f"{prefix}.{place}"})
        for part in component.parts:
            if isinstance(part, ComponentSpec):
                self._place(part, direction, f"{prefix}.{names[part.name]}")
                continue
            is_array = self._arrays.get((part.path, direction)) is not None
            for index, item in enumerate(part.items):
                place = f"({index})" if is_array else f"_{index}"
                self._place(item, direction, f"{prefix}.{names[part.name]}{place}")
