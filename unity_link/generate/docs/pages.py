"""An interface in words: what stands in the cells of the register map, whatever it is written in."""

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
"""Rows of one module that are all shown."""
_PARTS = 7
"""Digits that a number is shown with."""
_MOST_WHOLE = 10**15
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_SKIPPED = "\N{VERTICAL ELLIPSIS}"


class Row(NamedTuple):
    """A signal in the table of its component."""

    signal: Signal
    address: str
    bits: str
    """Its bits of the word; empty where it has the whole word or several."""
    kind: str
    value: str
    """Formula from the number to the value; empty where it is the number."""
    range: str
    notes: tuple[str, ...]
    """Further notes."""
    anchor: str

    @property
    def description(self) -> str:
        """Its doc string and the notes, as one text."""
        notes = "; ".join(self.notes)
        return f"{self.signal.doc} ({notes})" if self.signal.doc and notes else self.signal.doc or notes


class Field(NamedTuple):
    """Some bits of a word in a diagram: of a signal, or unused."""

    high: int
    low: int
    signal: Signal | None

    @property
    def width(self) -> int:
        """Number of bits."""
        return self.high - self.low + 1


class PageWord(NamedTuple):
    """A word of several fields, as a diagram: the highest bit first."""

    address: str
    lanes: tuple[tuple[str, tuple[Field, ...]], ...]
    """Fields that are read and fields that are written, where they differ; each with its title."""


class PortRow(NamedTuple):
    """A pin or a trigger of a component's entity."""

    name: str
    way: str
    """``IN``, ``OUT``, ``INOUT`` or ``TRIGGER``."""
    place: str
    """Pin of the board, or what is triggered."""


class ComponentSection(NamedTuple):
    """A component that has signals, or an entity behind it."""

    component: ComponentSpec
    title: str
    arguments: str
    rows: tuple[Row, ...]
    words: tuple[PageWord, ...]
    entity: str
    """The entity with its generics, and what it has of the gateway; empty without one."""
    ports: tuple[PortRow, ...]
    anchor: str


class ContentsEntry(NamedTuple):
    """A component in the contents."""

    depth: int
    label: str
    anchor: str
    """Its table; empty where it has only parts."""


class MapCell(NamedTuple):
    """An address in the map."""

    address: str
    way: str
    """Access: ``read``, ``write``, ``readwrite``, ``module`` or ``unused``."""
    title: str
    anchor: str


class Page:
    """All that the templates say of an interface."""

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
        """Pins of the board that the spec names, each with its direction and the port or signal at it."""

    # Words for things

    def hex(self, address: int) -> str:
        """Write an address with all the digits that the gateway's have."""
        return f"{address:0{self._digits}X}"

    def addresses(self, first: int, words: int) -> str:
        """Write the addresses of several words."""
        return self.hex(first) if words == 1 else f"{self.hex(first)}{ELLIPSIS}{self.hex(first + words - 1)}"

    @property
    def facts(self) -> Iterator[tuple[str, str]]:
        """Return what is said of the interface as a whole."""
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
        """Write the addresses of a module, as far as they are known."""
        return f"from {self.hex(module.base)} on" if module.words is None else self.addresses(module.base, module.words)

    def module_arguments(self, module: ModuleSpec) -> str:
        """Write what a module was declared with."""
        return ", ".join(f"{name}={_argument(value)}" for name, value in module.arguments.items())

    def group_rate(self, group: GroupSpec) -> str:
        """Write when a group is published."""
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
        """Name the place of a signal on the page."""
        return f"s-{path}"

    @property
    def contents(self) -> Iterator[ContentsEntry]:
        """Return all components that signals stand in, in the order of the spec."""
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
        """Return the rows of addresses in which something is, each with its first address.

        Of many rows of one module, the first and the last; a row without cells stands for those between.
        """
        for fill, some in itertools.groupby(self._runs(), key=lambda run: self._filled_by(run[0])):
            runs = list(some)
            if fill is not None and sum(map(len, runs)) > _MOST_FILLED:
                yield from (self._map_row(runs[0][0]), (_SKIPPED, ()), self._map_row(runs[-1][-1]))
            else:
                yield from (self._map_row(row) for run in runs for row in run)

    def _runs(self) -> Iterator[range]:
        """Return the rows in which something is; those between the ends of modules, perhaps millions, as one run."""
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
        """Return the module that a row of the map is of, if nothing else is there."""
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
    """Write a number for people: with a true minus sign, and powers of ten as such."""
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
    """Return what a signal has beside the columns."""
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
    """Return whether a bit is read as one signal and written as another."""
    return any(
        one.low <= other.high and other.low <= one.high
        for one in first
        for other in second
        if one.signal is not None and other.signal is not None and one.signal != other.signal
    )


def _has(module: ModuleSpec, address: int) -> bool:
    return module.words is not None and module.base <= address < module.base + module.words
