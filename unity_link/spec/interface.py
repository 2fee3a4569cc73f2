"""The parts of an interface while it is built, and the checks of the interface as a whole.

Components are checked where they are declared. These checks need all parts: addresses are within the gateway's, signals
and modules do not overlap, IDs are unique, and groups have valid sizes and rates.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from unity_link.spec.arguments import SENSORS
from unity_link.spec.model import Effect, GroupSpec, Joint, ModuleSpec, Sensor, Signal, gathered
from unity_link.spec.rates import base_millihertz, out_of_reach, published_hz

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from unity_link.spec.arguments import Bound
    from unity_link.spec.diagnostics import Placing, Reporter, SourceText, Span
    from unity_link.spec.model import ComponentSpec

GROUP_WORDS = 255
GROUPS = 256


class SignalPlace(NamedTuple):
    """A place in a source."""

    source: SourceText
    bounds: tuple[int, int]

    @property
    def span(self) -> Span:
        """The place with line and column."""
        return self.source.span(*self.bounds)

    def note(self, message: str) -> tuple[Span, str, str]:
        """Return a note that points to the place."""
        span = self.span
        return span, message, self.source.line(span.line)


class GroupDraft:
    """A group while its signals are collected.

    Args:
        name: of the group.
        place: place of its declaration, or of its first use.
        bound: the arguments of its declaration.
        doc: doc string of its declaration.
        says_when: whether its declaration has a rate, divisor or trigger, even an invalid one.
    """

    def __init__(self, name: str, place: SignalPlace, bound: Bound, doc: str = "", *, says_when: bool = False) -> None:
        self.name = name
        self.place = place
        self.bound = bound
        self.doc = doc
        self.says_when = says_when
        self.number: int | None = bound.get("NUMBER")
        self.divisor: int | None = bound.get("DIVISOR")
        self.divisor_place = place
        self.signals: list[tuple[Signal, SignalPlace]] = []
        self.triggers: list[SignalPlace] = []
        """Places of the triggers of cores that publish the group."""
        self.published = self.number is not None or any(
            name in bound for name in ("DIVISOR", "RATE", "TRIGGER", "ON_CHANGE", "IMMEDIATE", "TIMESTAMPS")
        )


class Placed(NamedTuple):
    """A signal of an interface, with the places of its address, ID and arguments."""

    signal: Signal
    address: SignalPlace
    id: SignalPlace
    timed: SignalPlace
    """Place of its TIMED."""
    wraps: SignalPlace
    """Place of its WRAPS."""
    core_at: SignalPlace | None
    """Place of the address that the author's spec gives to the core that contains the signal; None outside of cores."""

    def seen_from(self, other: Placed | None = None) -> SignalPlace:
        """Return the place for an error of the address: the author's line, unless both signals are in one core."""
        if self.core_at is None or (other is not None and other.core_at == self.core_at):
            return self.address
        return self.core_at


class AxesLimit(NamedTuple):
    """A limit of a parameter that depends on the number of placements that share an instance."""

    path: str
    """Path of the component."""
    place: SignalPlace
    """Place of the argument, for the error."""
    message: Callable[[int, int], str]
    """Returns why a parameter is not allowed with a number of axes and a clock in Hz; empty if it is allowed."""
    placing: Placing


DEFAULT_CLOCK_HZ = 50_000_000
"""Frequency of the gateway's clock if the spec does not state it."""


class InterfaceDraft:
    """All parts of one interface that were found so far."""

    def __init__(self, reporter: Reporter, address_bits: int, data_bits: int, clock_hz: int = DEFAULT_CLOCK_HZ) -> None:
        self.reporter = reporter
        self.address_bits = address_bits
        self.data_bits = data_bits
        self.clock_hz = clock_hz
        self.limits: list[Callable[[int], str]] = []
        """Functions as in `Interface.limits`."""
        self.limits_of_axes: list[AxesLimit] = []
        self.signals: list[Placed] = []
        self.modules: list[tuple[ModuleSpec, SignalPlace]] = []
        self.groups: dict[str, GroupDraft] = {}
        self.parts = 0
        """Number of signals, components and modules so far."""

    def check(self) -> tuple[GroupSpec, ...]:
        """Check the interface as a whole, and return its groups."""
        self._check_modules()
        self._check_addresses()
        self._check_overlaps()
        self._check_memories()
        self._check_ids()
        self._check_wraps()
        self._number_groups()
        groups = {draft.name: self._group(draft) for draft in self.groups.values() if draft.signals}
        return tuple(self._timed(group, list(groups.values())) for group in groups.values())

    def check_axes(self, cores: Iterable[ComponentSpec]) -> None:
        """Check the limits of parameters that depend on the number of placements that share an instance.

        Args:
            cores: all components with an entity.
        """
        axes = {part.path: len(placements) for placements in gathered(cores) for part in placements}
        for path, place, message, placing in self.limits_of_axes:
            limit = functools.partial(message, axes.get(path, 1))
            self.limits.append(limit)
            if refusal := limit(self.clock_hz):
                self.reporter.refuse(placing)
                self._error(place, "out-of-range", refusal)

    def check_timed(self, schedules: set[str]) -> None:
        """Check the signals that are written by schedules.

        Args:
            schedules: paths of the components whose entities have STAGE.
        """
        leases: dict[str, Placed] = {}
        for placed in self.signals:
            signal = placed.signal
            if signal.timed is None:
                continue
            if signal.timed not in schedules:
                message = f"{signal.path} is timed by {signal.timed}, whose ENTITY has no STAGE"
                self._error(placed.timed, "bad-timed", message)
            if signal.module is not None and self._is_hardware(signal.module):
                message = f"{signal.path} is a register of the module around it, which no schedule can write"
                self._error(placed.timed, "bad-timed", message, "leave it out")
            first = leases.setdefault(signal.timed, placed).signal if signal.safe is not None else signal
            if first.safe is not None and signal.safe is not None and first.safe.lease != signal.safe.lease:
                message = (
                    f"{first.path} and {signal.path} are timed by {signal.timed}, and guarded by {first.safe.lease} "
                    f"and {signal.safe.lease}: a schedule has one lease"
                )
                self._error(placed.timed, "bad-timed", message, "give each lease a SCHEDULE of its own")

    def _is_hardware(self, index: int | None) -> bool:
        """Return whether a module, or a module that contains it, is hardware of its own."""
        while index is not None:
            module = self.modules[index][0]
            if module.is_hardware:
                return True
            index = module.parent
        return False

    def _error(
        self,
        place: SignalPlace,
        code: str,
        message: str,
        advice: str = "",
        other: tuple[SignalPlace, str] | None = None,
    ) -> None:
        notes = [other[0].note(other[1])] if other is not None and other[0] != place else []
        self.reporter.error(place.source, place.bounds, code, message, help=advice, notes=notes)

    # Addresses

    def _check_modules(self) -> None:
        spans = (
            (module.base, module.base + (module.words or 0), index) for index, (module, _) in enumerate(self.modules)
        )
        known = sorted(spans, key=lambda span: (span[0], -span[1], span[2]))
        highest = 0
        owner: int | None = None
        for base, end, index in known:
            module, place = self.modules[index]
            if module.words is None:
                continue
            if end > 1 << self.address_bits:
                message = (
                    f"{module.type} takes the addresses {base:#x} to {end - 1:#x}, and the gateway has {self._space()}"
                )
                self._error(place, "address-range", message)
            if owner is not None and base < highest and not self._is_inside(index, owner):
                other, other_place = self.modules[owner]
                message = f"{module.type} at {base:#x} lies in {other.type} at {other.base:#x} to {highest - 1:#x}"
                self._error(place, "overlap", message, other=(other_place, "which is here"))
            if end > highest and not (owner is not None and self._is_inside(index, owner)):
                highest, owner = end, index

    def _is_inside(self, index: int | None, owner: int) -> bool:
        while index is not None:
            if index == owner:
                return True
            index = self.modules[index][0].parent
        return False

    def _space(self) -> str:
        return f"0x0 to {(1 << self.address_bits) - 1:#x} ({self.address_bits} address bits)"

    def _check_addresses(self) -> None:
        reported: set[SignalPlace] = set()
        for placed in self.signals:
            place = placed.seen_from()
            message, advice = self._outside(placed.signal)
            if message and place not in reported:
                reported.add(place)
                self._error(place, "address-range", message, advice)

    def _outside(self, signal: Signal) -> tuple[str, str]:
        """Return why a signal's address is outside of the gateway or its module, and advice; empty if it is inside."""
        most, last = 1 << self.address_bits, signal.address + signal.words - 1
        if signal.address < 0 or last >= most:
            wrong = last if 0 <= signal.address < most else signal.address
            message = f"the address {_hex(wrong)} of {signal.path} is not the gateway's, which has {self._space()}"
            return message, "GATEWAY(ADDRESS_BITS=...) sets its width"
        if signal.module is not None:
            module = self.modules[signal.module][0]
            relative, end = signal.address - module.base, last - module.base
            if module.words is not None and not (relative >= 0 and end < module.words):
                wrong = end if 0 <= relative < module.words else relative
                where = f"{module.type}, which has {module.words} words"
                return f"the address {_hex(wrong)} of {signal.path} is outside of {where}", ""
        return "", ""

    def _check_overlaps(self) -> None:
        words: dict[int, list[Placed]] = {}
        for placed in self.signals:
            for address in placed.signal.addresses:
                words.setdefault(address, []).append(placed)
        reported: set[tuple[SignalPlace, SignalPlace]] = set()
        for address, sharing in words.items():
            if len(sharing) > 1:
                self._check_word(address, sharing, reported)

    def _check_word(self, address: int, sharing: list[Placed], reported: set[tuple[SignalPlace, SignalPlace]]) -> None:
        """Check one address that several signals use.

        Args:
            address: of the word.
            sharing: the signals.
            reported: places of the overlaps that were reported; two overlapping cores cause only one error.
        """
        self._check_leases(address, sharing)
        written = [placed for placed in sharing if placed.signal.access.writes]
        self._check_timed_word(address, written)
        self._check_cleared_word(address, written)
        # A 0 leaves a WRITE_1_TO_CLEAR or PULSE signal unchanged: a word of these alone needs no masked write.
        is_masked = len(written) > 1 and any(placed.signal.effect is None for placed in written)
        taken: dict[str, list[Placed]] = {"reads": [], "writes": []}
        for placed in sharing:
            signal = placed.signal
            mask = _taken(signal, address)
            for way, allowed in (("reads", signal.access.reads), ("writes", signal.access.writes)):
                if not allowed:
                    continue
                clash = next((one for one in taken[way] if _taken(one.signal, address) & mask), None)
                taken[way].append(placed)
                if clash is not None:
                    places = placed.seen_from(clash), clash.seen_from(placed)
                    if places not in reported:
                        self._report_overlap(address, clash, placed)
                    reported.add(places)
                    break
            else:
                if signal.access.writes and len(written) > 1:
                    self._check_sharing(address, placed, sharing, is_masked=is_masked)
            if signal.access.writes and is_masked:
                # Only now are all signals of the word known. The model was not handed out yet, so this change is safe.
                msgspec.structs.force_setattr(signal, "is_field", True)  # noqa: FBT003

    def _check_leases(self, address: int, sharing: list[Placed]) -> None:
        """Check that the signals written at one address are guarded by one lease, or all by none."""
        written = [placed for placed in sharing if placed.signal.access.writes]
        for placed in written[1:]:
            first, other = written[0].signal, placed.signal
            if (first.safe and first.safe.lease) != (other.safe and other.safe.lease):
                by = [f"by {one.safe.lease}" if one.safe else "by none" for one in (first, other)]
                message = (
                    f"{first.path} and {other.path} are written together at address {address:#x}, and one is guarded "
                    f"{by[0]}, the other {by[1]}"
                )
                self._error(placed.address, "bad-safe", message, "give each its own address, or both one lease")
                return

    def _check_timed_word(self, address: int, written: list[Placed]) -> None:
        """Check that a timed signal is the only one written in its word: a masked write would restore old values."""
        timed = next((placed for placed in written if placed.signal.timed is not None), None)
        if timed is not None and len(written) > 1:
            other = next(one.signal for one in written if one is not timed)
            message = (
                f"{timed.signal.path} is timed, and {other.path} is written in the same word, at address {address:#x}"
            )
            self._error(timed.timed, "bad-timed", message, "give each its own address")

    def _check_cleared_word(self, address: int, written: list[Placed]) -> None:
        """Check that no masked write of another signal can clear a WRITE_1_TO_CLEAR signal by writing back its ones."""
        cleared = next((placed for placed in written if placed.signal.effect is Effect.WRITE_1_TO_CLEAR), None)
        plain = next((placed for placed in written if placed.signal.effect is None), None)
        if cleared is not None and plain is not None:
            message = (
                f"a write of {plain.signal.path} would clear {cleared.signal.path}, which is written in the same word, "
                f"at address {address:#x}"
            )
            advice = "fields of one word are written by reading it first, ones included: give each its own address"
            self._error(cleared.address, "bad-effect", message, advice)

    def _check_memories(self) -> None:
        """Check that no signal in memory of a network has an effect: the network rewrites its words cyclically."""
        for placed in self.signals:
            index = placed.signal.module
            while index is not None and placed.signal.effect is not None:
                module = self.modules[index][0]
                if module.type.startswith("TOSNET"):
                    message = (
                        f"{placed.signal.path} is in the memory of a {module.type}, where no signal can have an EFFECT"
                    )
                    self._error(placed.address, "bad-effect", message)
                    break
                index = module.parent

    def _report_overlap(self, address: int, first: Placed, second: Placed) -> None:
        message = (
            f"{second.signal.path} takes {_bits(second.signal)} at address {address:#x}, "
            f"which {first.signal.path} has ({_bits(first.signal)})"
        )
        place, other = second.seen_from(first), first.seen_from(second)
        self._error(place, "overlap", message, other=(other, f"the address of {first.signal.path} is given here"))

    def _check_sharing(self, address: int, placed: Placed, sharing: list[Placed], *, is_masked: bool) -> None:
        """Check a signal that shares its address with other signals that are written."""
        signal = placed.signal
        if signal.words > 1:
            message = f"{signal.path} has several words, so that no other signal can be written at address {address:#x}"
            self._error(placed.address, "overlap", message)
        # A masked write reads the word first, and must read back the bits of the other fields.
        masks = _taken(signal, address)
        if is_masked:
            other = next(
                (one for one in sharing if not one.signal.access.writes and _taken(one.signal, address) & masks),
                None,
            )
            if other is not None:
                name = other.signal.path
                does = f"takes a word from {name} instead" if other.signal.fifo else f"gives {name} instead"
                if other.signal.effect is not None:
                    does = f"clears {name}"
                message = (
                    f"{signal.path} is one of several fields written at address {address:#x}, where reading {does}"
                )
                takes = other.signal.read_takes
                advice = "move it to another address" if takes else "make the field READWRITE, or move it"
                advice = f"fields of one word are written by reading it first: {advice}"
                self._error(placed.address, "overlap", message, advice)

    def _check_ids(self) -> None:
        ids: dict[str, Placed] = {}
        for placed in self.signals:
            first = ids.setdefault(placed.signal.id, placed)
            if first is not placed:
                message = f"the ID '{placed.signal.id}' is that of {first.signal.path} and of {placed.signal.path}"
                self._error(placed.id, "id-twice", message, other=(first.id, f"{first.signal.path} has it here"))

    # Groups

    def _check_wraps(self) -> None:
        """Check that WRAPS(OF=...) names a signal of the component that is read, wraps, and has the same kind."""
        by_path = {placed.signal.path: placed.signal for placed in self.signals}
        for placed in self.signals:
            signal = placed.signal
            if signal.laps_of in {None, signal.path}:
                continue
            other = by_path.get(signal.laps_of or "")
            name = (signal.laps_of or "").rpartition(".")[2]
            if other is None or other.laps_of != other.path or not other.access.reads:
                message = (
                    f"{signal.path} wraps as {name} does, which is no signal of its component that is read and wraps"
                )
                self._error(placed.wraps, "bad-wraps", message, f"as in @{name}: signed READ(WRAPS);")
            elif other.kind != signal.kind:
                message = f"{signal.path} wraps as {name} does, which has other numbers"
                self._error(placed.wraps, "bad-wraps", message, "give both one kind, SCALE and OFFSET")

    def _number_groups(self) -> None:
        used: dict[int, GroupDraft] = {}
        for draft in self.groups.values():
            if draft.number is None:
                continue
            first = used.setdefault(draft.number, draft)
            if first is not draft:
                message = f"the groups {first.name} and {draft.name} both have number {draft.number}"
                self._error(draft.place, "group-number", message, other=(first.place, f"{first.name} is declared here"))
        free = (number for number in range(GROUPS) if number not in used)
        for draft in self.groups.values():
            if draft.number is None and draft.published and draft.signals:
                draft.number = next(free, None)
                if draft.number is None:
                    message = f"a gateway has {GROUPS} groups, and this interface needs more"
                    self._error(draft.place, "group-number", message)

    def _group(self, draft: GroupDraft) -> GroupSpec:
        bound = draft.bound
        addresses = list(dict.fromkeys(address for signal, _ in draft.signals for address in signal.addresses))
        if draft.published:
            if len(addresses) > GROUP_WORDS:
                message = (
                    f"the group {draft.name} has {len(addresses)} words, and a gateway publishes at most {GROUP_WORDS}"
                )
                self._error(draft.signals[0][1], "group-size", message, "divide it into several groups")
            self._check_readable(draft)
            self._check_ports(draft)
            self._check_triggers(draft)
            if not draft.says_when:
                message = f"nothing says when the group {draft.name} is published"
                self._error(draft.signals[0][1], "group-rate", message, "give a divisor, as in PUBLISH(1, 10)")
        return GroupSpec(
            name=draft.name,
            number=draft.number,
            divisor=draft.divisor,
            rate_hz=bound.get("RATE"),
            trigger=bound.get("TRIGGER", False),
            on_change=bound.get("ON_CHANGE", False),
            immediate=bound.get("IMMEDIATE", False),
            timestamps=bound.get("TIMESTAMPS", False),
            signals=tuple(signal.path for signal, _ in draft.signals),
            addresses=tuple(addresses),
            joints=self._joints(draft),
            sensors=tuple(sensor for word in SENSORS for sensor in self._sensors(draft, word)),
            doc=draft.doc,
            span=draft.place.span,
        )

    def _timed(self, group: GroupSpec, groups: list[GroupSpec]) -> GroupSpec:
        """Return a group with its published rate, which depends on all groups of the interface."""
        message = out_of_reach(group, groups)
        if message:
            advice = "a DIVISOR counts from the gateway's own base frequency; with RATE alone, that follows the rates"
            self._error(self.groups[group.name].place, "group-rate", message, advice)
            return group
        return msgspec.structs.replace(group, published_hz=published_hz(group, base_millihertz(groups)))

    def _check_readable(self, draft: GroupDraft) -> None:
        """Check that a published group contains no write-only signal; PUBLISH in signals was checked before."""
        for signal, place in draft.signals:
            if not signal.access.reads and signal.group != draft.name:
                message = f"{signal.path} can only be written, and the group {draft.name} is published"
                advice = "put it into one that is not: group NAME; and GROUP(NAME)"
                self._error(place, "not-readable", message, advice)
                return

    def _check_ports(self, draft: GroupDraft) -> None:
        """Check a published group that contains FIFO ports: each sample removes a word from the queue."""
        ports = [(signal, place) for signal, place in draft.signals if signal.fifo]
        if not ports:
            return
        signal, place = ports[0]
        bound = draft.bound
        if draft.divisor is not None or "RATE" in bound or not bound.get("TRIGGER", False):
            message = f"{signal.path} is the port of a FIFO, and the group {draft.name} is not published on its trigger"
            advice = "a sample takes a word, which must be there: group NAME(TRIGGER), and PUBLISH(NAME)"
            self._error(place, "bad-fifo", message, advice)
        elif bound.get("ON_CHANGE", False):
            message = (
                f"{signal.path} is the port of a FIFO, and the group {draft.name} leaves out words that are the same"
            )
            self._error(place, "bad-fifo", message, "leave out ON_CHANGE")

    def _check_triggers(self, draft: GroupDraft) -> None:
        """Check that a group that a core triggers has TRIGGER."""
        if draft.triggers and not draft.bound.get("TRIGGER", False):
            message = f"a core triggers the group {draft.name}, which is not published on its trigger"
            self._error(draft.triggers[0], "group-trigger", message, f"declare it so: group {draft.name}(TRIGGER);")

    def _joints(self, draft: GroupDraft) -> tuple[Joint, ...]:
        """Return the joints of a group: the components that contain a signal with a name from JOINTS."""
        clause: dict[str, str] | None = draft.bound.get("JOINTS")
        if clause is None:
            return ()
        if not clause:
            message = "JOINTS needs the name of a signal"
            self._error(draft.place, "joints", message, "as in JOINTS(POSITION=cpos, VELOCITY=spd)")
        set_points = {part.lower(): name for part, name in clause.items() if part.startswith("SET_")}
        sampled = {name: part.lower() for part, name in clause.items() if part.lower() not in set_points}
        found: dict[str, dict[str, str]] = {}
        for signal, _ in draft.signals:
            if signal.name in sampled and signal.index is not None:
                message = f"{signal.path} is in a row of signals, and each joint is a component of its own"
                advice = f"put {signal.name} into a component, as in joints[6]: joint() @(0x10 + i);"
                self._error(draft.place, "joints", message, advice)
            elif signal.name in sampled:
                component = signal.path.rpartition(".")[0]
                found.setdefault(component, {})[sampled[signal.name]] = signal.path
        writable = {placed.signal.path for placed in self.signals if placed.signal.access.writes}
        for component, joint in found.items():
            paths = {part: f"{component}.{name}".lstrip(".") for part, name in set_points.items()}
            joint.update((part, path) for part, path in paths.items() if path in writable)
        found_parts = {part for joint in found.values() for part in joint}
        for part, name in clause.items():
            if part.lower() not in found_parts:
                one = (
                    "signal of its joints that can be written"
                    if part.lower() in set_points
                    else (f"signal of the group {draft.name}")
                )
                self._error(draft.place, "joints", f"no {one} is called '{name}'")
        return tuple(Joint(name=name, **signals) for name, signals in found.items())

    def _sensors(self, draft: GroupDraft, word: str) -> Iterator[Sensor]:
        """Yield the sensors of a group for a word: the components that contain a signal with a name from its clause."""
        clause: dict[str, Any] | None = draft.bound.get(word)
        if clause is None:
            return
        sizes = SENSORS[word]
        parts = {name: part for part, name in clause.items() if part in sizes}
        if not parts:
            advice = f"as in {word}({next(iter(sizes))}=name)"
            self._error(draft.place, "sensors", f"{word} needs the name of a signal", advice)
        found: dict[str, dict[str, list[str]]] = {}
        for signal, _ in draft.signals:
            if signal.name in parts:
                signals = found.setdefault(signal.path.rpartition(".")[0], {})
                signals.setdefault(parts[signal.name], []).append(signal.path)
        for name, part in parts.items():
            if not any(part in signals for signals in found.values()):
                self._error(draft.place, "sensors", f"no signal of the group {draft.name} is called '{name}'")
        for component, signals in found.items():
            for part, paths in signals.items():
                if len(paths) != sizes[part]:
                    first = paths[0].removesuffix("[0]")
                    message = f"{first} is a row of {len(paths)}, and {part} of {word} needs {sizes[part]}"
                    advice = f"declare a row, as in @{first.rpartition('.')[2]}[{sizes[part]}] = base + i: ..."
                    self._error(draft.place, "sensors", message, advice if sizes[part] > 1 else "")
            yield Sensor(
                word=word,
                name=component,
                signals={part: tuple(paths) for part, paths in signals.items()},
                field_of_view=float(clause.get("FIELD_OF_VIEW", 0)),
                infrared=bool(clause.get("INFRARED", False)),
            )


def _hex(address: int) -> str:
    return f"{address:#x}" if address >= 0 else str(address)


def _taken(signal: Signal, address: int) -> int:
    """Return a signal's bits of the word at an address: the whole word if any access to it has an effect."""
    return (1 << signal.word_bits) - 1 if signal.access_moves else signal.mask_at(address)


def _bits(signal: Signal) -> str:
    if signal.fifo:
        return "the whole word, as a FIFO port"
    if signal.read_takes:
        return "the whole word, which each read clears"
    high = signal.lowest_bit + signal.width - 1
    return f"bit {high}" if signal.width == 1 else f"bits {high}:{signal.lowest_bit}"
