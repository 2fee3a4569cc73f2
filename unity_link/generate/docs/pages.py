"""The texts of the register map of an interface, for both formats."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, NamedTuple

from unity_link.spec import Access, KindName, words

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec import ComponentSpec, Core, GroupSpec, Interface, ModuleSpec, Signal

MINUS = "\N{MINUS SIGN}"
ELLIPSIS = "\N{HORIZONTAL ELLIPSIS}"
TIMES = "\N{MULTIPLICATION SIGN}"
_CELLS = 16
"""Addresses in a row of the map."""
_MOST_FILLED = 3
"""Most rows of one module that are all shown."""
_PARTS = 7
"""Significant digits of a number."""
_MOST_WHOLE = 10**15
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_SKIPPED = "\N{VERTICAL ELLIPSIS}"


class Row(NamedTuple):
    """A signal in the table of its component."""

    signal: Signal
    address: str
    bits: str
    """Bits in the word; empty for a signal of one or more whole words."""
    kind: str
    value: str
    """Formula that converts the number to the value; empty if they are the same."""
    range: str
    notes: tuple[str, ...]
    """Further properties, as phrases."""
    anchor: str

    @property
    def description(self) -> str:
        """Doc string and notes as one text."""
        notes = "; ".join(self.notes)
        return f"{self.signal.doc} ({notes})" if self.signal.doc and notes else self.signal.doc or notes


class Field(NamedTuple):
    """Bits of a word in a diagram: a signal, or unused bits."""

    high: int
    low: int
    signal: Signal | None

    @property
    def width(self) -> int:
        """Number of bits."""
        return self.high - self.low + 1


class PageWord(NamedTuple):
    """The diagram of a word with several fields, the highest bit first."""

    address: str
    lanes: tuple[tuple[str, tuple[Field, ...]], ...]
    """Titles and fields: readable and writable fields separately if they overlap, otherwise all together."""


class PortRow(NamedTuple):
    """A pin or trigger of a component's entity."""

    name: str
    way: str
    """``IN``, ``OUT``, ``INOUT`` or ``TRIGGER``."""
    place: str
    """Pin of the board, or the triggered group."""


class ComponentSection(NamedTuple):
    """A component that has signals or an entity."""

    component: ComponentSpec
    title: str
    arguments: str
    rows: tuple[Row, ...]
    words: tuple[PageWord, ...]
    entity: str
    """The entity with its generics and the gateway's ports that it uses; empty without one."""
    ports: tuple[PortRow, ...]
    anchor: str


class ContentsEntry(NamedTuple):
    """A component in the table of contents."""

    depth: int
    label: str
    anchor: str
    """Anchor of its table; empty if it contains only other components."""


class MapCell(NamedTuple):
    """An address in the map."""

    address: str
    way: str
    """Access: ``read``, ``write``, ``readwrite``, ``module`` or ``unused``."""
    title: str
    anchor: str


class Page:
    """The contents of the page of an interface."""

    def __init__(self, interface: Interface) -> None:
        self.interface = interface
        self.signals = tuple(interface.signals.values())
        self._digits = -(-interface.address_bits // 4)
        self._at: dict[int, list[Signal]] = {}
        for signal in self.signals:
            for address in signal.addresses:
                self._at.setdefault(address, []).append(signal)
        self.parts = tuple(self._parts())
        self.map = tuple(self._map())
        self.wired = tuple(words.wired(interface))
        """Pins of the board that the spec names: the pin, its direction, and the port or signal."""

    # Formatting

    def hex(self, address: int) -> str:
        """Format an address with the number of digits of the gateway's addresses."""
        return f"{address:0{self._digits}X}"

    def addresses(self, first: int, words: int) -> str:
        """Format a range of addresses."""
        return self.hex(first) if words == 1 else f"{self.hex(first)}{ELLIPSIS}{self.hex(first + words - 1)}"

    @property
    def facts(self) -> Iterator[tuple[str, str]]:
        """Yield properties of the whole interface as pairs of a name and a text."""
        interface = self.interface
        yield "words", f"{interface.data_bits} bits"
        yield "addresses", f"{interface.address_bits} bits, {self.addresses(0, 1 << interface.address_bits)}"
        yield "signals", f"{len(self.signals)} at {len(self._at)} addresses"
        given = [
            parameter.name if parameter.value is None else f"{parameter.name} = {parameter.value}"
            for parameter in interface.parameters
        ]
        if given:
            yield "parameters", ", ".join(given)

    def base_and_words(self, module: ModuleSpec) -> str:
        """Format the addresses of a module; if its size is unknown, the first one."""
        return f"from {self.hex(module.base)} on" if module.words is None else self.addresses(module.base, module.words)

    def module_arguments(self, module: ModuleSpec) -> str:
        """Format the arguments of a module's declaration."""
        return ", ".join(f"{name}={_argument(value)}" for name, value in module.arguments.items())

    def group_rate(self, group: GroupSpec) -> str:
        """Return when and how a group is published, as a phrase."""
        if group.number is None:
            return "not published"
        when = [
            f"base frequency / {group.divisor}" if group.divisor is not None else "",
            f"{group.published_hz:.6g} Hz" if group.rate_hz is not None and group.published_hz is not None else "",
            "on its trigger" if group.trigger else "",
        ]
        how = [
            "only when a word has changed" if group.on_change else "",
            "sent at once" if group.immediate else "",
            "with timestamps" if group.timestamps else "",
        ]
        return ", ".join(filter(None, when + how))

    def anchor_of(self, path: str) -> str:
        """Return the HTML anchor of a signal."""
        return f"s-{path}"

    @property
    def contents(self) -> Iterator[ContentsEntry]:
        """Yield the components that contain signals, directly or in parts, in the order of the spec."""
        tables = {part.component.path: part.anchor for part in self.parts}
        for component in self.interface.root.walk():
            path = component.path
            if any(one == path or not path or one.startswith((f"{path}.", f"{path}[")) for one in tables):
                label = path.rpartition(".")[2] or component.name
                yield ContentsEntry(path.count(".") + bool(path), label, tables.get(path, ""))

    # Tables

    def _parts(self) -> Iterator[ComponentSection]:
        drawn: set[int] = set()
        for component in self.interface.root.walk():
            if not component.signals and component.core is None:
                continue
            diagrams = []
            for signal in component.signals:
                for address in signal.addresses:
                    if address not in drawn and self._has_fields(address):
                        diagrams.append(self._word(address))
                    drawn.add(address)
            arguments = ", ".join(f"{name} = {_argument(value)}" for name, value in component.arguments.items())
            yield ComponentSection(
                component,
                component.path or self.interface.name,
                arguments,
                tuple(self._row(signal) for signal in component.signals),
                tuple(diagrams),
                "" if component.core is None else _entity(component.core),
                tuple(_ports(component.core)) if component.core is not None else (),
                f"c-{component.path}",
            )

    def _row(self, signal: Signal) -> Row:
        bits = ""
        if signal.words == 1 and signal.width < signal.word_bits:
            high = signal.lowest_bit + signal.width - 1
            bits = f"{high}:{signal.lowest_bit}" if signal.width > 1 else str(high)
        return Row(
            signal,
            self.addresses(signal.address, signal.words),
            bits,
            str(signal.kind),
            _formula(signal),
            _range(signal),
            tuple(_notes(signal)),
            self.anchor_of(signal.path),
        )

    # Diagrams

    def _has_fields(self, address: int) -> bool:
        return any(signal.mask_at(address) != (1 << signal.word_bits) - 1 for signal in self._at[address])

    def _word(self, address: int) -> PageWord:
        signals = self._at[address]
        read = self._lane(address, [signal for signal in signals if signal.access is not Access.WRITE])
        written = self._lane(address, [signal for signal in signals if signal.access is not Access.READ])
        if not _overlap(read, written):
            return PageWord(self.hex(address), (("", self._lane(address, signals)),))
        return PageWord(self.hex(address), (("read", read), ("written", written)))

    def _lane(self, address: int, signals: list[Signal]) -> tuple[Field, ...]:
        fields: list[Field] = []
        next_bit = self.interface.data_bits - 1
        for signal in sorted(signals, key=lambda one: -one.mask_at(address)):
            mask = signal.mask_at(address)
            high, low = mask.bit_length() - 1, (mask & -mask).bit_length() - 1
            if high < next_bit:
                fields.append(Field(next_bit, high + 1, None))
            fields.append(Field(high, low, signal))
            next_bit = low - 1
        if next_bit >= 0:
            fields.append(Field(next_bit, 0, None))
        return tuple(fields)

    # Map

    def _map(self) -> Iterator[tuple[str, tuple[MapCell, ...]]]:
        """Yield the rows that contain signals or modules, each with its first address.

        If many rows belong to one module, only the first and the last are yielded, with an empty row between them.
        """
        for fill, some in itertools.groupby(self._runs(), key=lambda run: self._filled_by(run[0])):
            runs = list(some)
            if fill is not None and sum(map(len, runs)) > _MOST_FILLED:
                yield from (self._map_row(runs[0][0]), (_SKIPPED, ()), self._map_row(runs[-1][-1]))
            else:
                yield from (self._map_row(row) for run in runs for row in run)

    def _runs(self) -> Iterator[range]:
        """Yield the rows of the map; the rows inside a module, perhaps millions, are one range."""
        rows = {address // _CELLS for address in self._at}
        for module in self.interface.modules:
            if module.words is not None:
                rows |= {module.base // _CELLS, (module.base + module.words - 1) // _CELLS}
        ascending = sorted(rows)
        for row, following in itertools.zip_longest(ascending, ascending[1:], fillvalue=0):
            yield range(row, row + 1)
            if row + 1 < following and self._module_at((row + 1) * _CELLS) is not None:
                yield range(row + 1, following)

    def _filled_by(self, row: int) -> ModuleSpec | None:
        """Return the module that fills a row of the map; None if the row contains anything else."""
        addresses = range(row * _CELLS, (row + 1) * _CELLS)
        module = self._module_at(addresses[0])
        if module is None or any(address in self._at or self._module_at(address) != module for address in addresses):
            return None
        return module

    def _module_at(self, address: int) -> ModuleSpec | None:
        return next((one for one in reversed(self.interface.modules) if _has(one, address)), None)

    def _map_row(self, row: int) -> tuple[str, tuple[MapCell, ...]]:
        first = row * _CELLS
        return self.hex(first), tuple(self._cell(address) for address in range(first, first + _CELLS))

    def _cell(self, address: int) -> MapCell:
        signals = tuple(self._at.get(address, ()))
        module = self._module_at(address)
        reads = any(signal.access.reads for signal in signals)
        writes = any(signal.access.writes for signal in signals)
        way = "readwrite" if reads and writes else "read" if reads else "write" if writes else "unused"
        title = ", ".join(signal.path for signal in signals)
        if not signals and module is not None:
            way, title = "module", module.path or module.type
        anchor = self.anchor_of(signals[0].path) if signals else "modules" if way == "module" else ""
        return MapCell(self.hex(address), way, title, anchor)


def number(value: float) -> str:
    """Format a number for display, with a minus sign and powers of ten."""
    whole = float(value).is_integer() and abs(value) < _MOST_WHOLE
    digits, _, exponent = (str(int(value)) if whole else f"{value:.{_PARTS}g}").partition("e")
    power = f" {TIMES} 10{str(int(exponent)).translate(_SUPERSCRIPTS)}" if exponent else ""
    return digits.replace("-", MINUS) + power


def _argument(value: object) -> str:
    name = getattr(value, "name", None)
    if name is not None:
        return str(name)
    return number(value) if isinstance(value, int | float) and not isinstance(value, bool) else str(value)


def _formula(signal: Signal) -> str:
    kind = signal.kind
    scale = f"{number(kind.scale)} {TIMES} number" if kind.scale != 1 else "number"
    if kind.offset == 0:
        return "" if scale == "number" else scale
    sign = "+" if kind.offset > 0 else MINUS
    return f"{scale} {sign} {number(abs(kind.offset))}"


def _range(signal: Signal) -> str:
    if signal.kind.name in {KindName.BOOL, KindName.ENUM}:
        return ""
    low, high = signal.limits
    if math.isinf(low) and math.isinf(high):
        return ""
    return f"{number(low)} {ELLIPSIS} {number(high)}"


def _notes(signal: Signal) -> Iterator[str]:
    """Yield phrases for the properties of a signal that have no column."""
    if signal.id != signal.path:
        yield f"ID {signal.id}"
    if signal.group is not None:
        yield f"published with {signal.group}"
    others = [group for group in signal.groups if group != signal.group]
    if others:
        yield f"in {', '.join(others)}"
    if signal.poll_hz is not None:
        yield f"polled at {number(signal.poll_hz)} Hz"
    if signal.fifo:
        yield "FIFO port" if signal.fifo_words is None else f"FIFO port, {signal.fifo_words} words deep"
    if signal.is_field:
        yield "written by a masked write"
    yield from words.at_hardware(signal)


def _entity(core: Core) -> str:
    wants = ", ".join(core.wants)
    return words.entity(core) + (f" with {wants} of the gateway" if wants else "")


def _ports(core: Core) -> Iterator[PortRow]:
    yield from (PortRow(pin.name, pin.way, words.site(pin)) for pin in core.pins)
    yield from (PortRow(trigger.name, "TRIGGER", words.triggered(trigger)) for trigger in core.triggers)


def _overlap(first: tuple[Field, ...], second: tuple[Field, ...]) -> bool:
    """Return whether a bit belongs to different signals when it is read and when it is written."""
    return any(
        one.low <= other.high and other.low <= one.high
        for one in first
        for other in second
        if one.signal is not None and other.signal is not None and one.signal != other.signal
    )


def _has(module: ModuleSpec, address: int) -> bool:
    return module.words is not None and module.base <= address < module.base + module.words
