"""The hardware's side of an interface: one record of what hardware gives, one of what it gets, nested as the spec is.

A component becomes a record type of each direction, and components of one declaration share theirs as long as they look
the same. An array whose components do not (their widths may depend on the index) becomes one element for each.
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
    """Record of a port; the value is the name of the port, and the end of the names of its types."""

    FROM = "from_hardware"
    TO = "to_hardware"


class Element(NamedTuple):
    """An element of a record."""

    name: str
    type: str
    comment: str = ""


class RecordType(NamedTuple):
    """A record, or with `item` an array of one."""

    name: str
    elements: tuple[Element, ...] = ()
    item: str = ""


class Pins(NamedTuple):
    """Ports of the hardware's side of a signal: names of elements of the two records, empty where there is none."""

    given: str = ""
    """Port that hardware drives: the value that is read."""
    got: str = ""
    """Port that hardware reads: the value that is written."""
    written: str = ""
    """Pulses with each write."""
    given_valid: str = ""
    given_ready: str = ""
    """Port of a FIFO that is read: hardware's word counts; it is being taken."""
    got_valid: str = ""
    got_ready: str = ""
    """Port of a FIFO that is written: a word is there; hardware takes it."""


def elements_of(signal: Signal, name: str, type_: str) -> Iterator[tuple[Direction, str, Element]]:
    """Return the elements of a signal: the direction, which of `Pins` it is, and the element."""
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
    """An element of a record, for a signal or for a row of them."""

    direction: Direction
    pin: str
    """Name of a field of `Pins`."""
    element: Element
    places: dict[str, str]
    """Names of the element, or of its items, by the paths of the signals."""


def _endings(signals: tuple[Signal, ...]) -> list[str]:
    """Return the ends of the names of elements for a signal, or for a row of them."""
    ends = ("", "_valid", "_ready") if signals[0].fifo else ("", "_written")
    return [f"{place}{end}" for place in ("", *(f"_{one.index}" for one in signals)) for end in ends]


class Records:
    """The record types of an interface.

    Args:
        interface: whose records these are.
        signals: its signals that have a hardware's side, by their paths.
        enumerations: their types.
        scope: the names of the package, in which the types get theirs.
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
        """Types of arrays by those of the values in them."""
        self.types: list[RecordType] = []
        """Types in an order in which each uses only those before it."""
        self.pins: dict[str, Pins] = {path: Pins() for path in signals}
        """Ports by the paths of the signals."""
        self.roots = {direction: self._record(interface.root, direction) for direction in Direction}
        """Names of the outermost types; None where that record would be empty."""
        for direction in Direction:
            self._place(interface.root, direction, direction.value)

    def _names_in(self, component: ComponentSpec) -> dict[str, str]:
        """Return the VHDL names of a component's members, which are the same in both records."""
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
        """Return the elements of a signal or a row; one of which the signals are not alike has some for each signal."""
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
        """Return the type of an array of values."""
        if item == "std_logic":
            return "std_logic_vector"
        if item not in self._rows:
            base = item.removesuffix("_t") if "(" not in item else f"{item.partition('(')[0]}_{width}"
            self._rows[item] = f"{self._scope.unique(base, '_array_t')}_array_t"
            self.types.append(RecordType(self._rows[item], item=item))
        return self._rows[item]

    def _array(self, records: list[str | None]) -> str | None:
        """Return the type of an array of such records, or None where there is none that holds them all."""
        first = records[0]
        if first is None or any(record != first for record in records):
            return None
        name = f"{first.removesuffix('_t')}_array_t"
        if not any(record.name == name for record in self.types):
            self.types.append(RecordType(name, item=first))
        return name

    def _place(self, component: ComponentSpec, direction: Direction, prefix: str) -> None:
        """Find the elements of all signals of a component, which is the element `prefix` itself."""
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
