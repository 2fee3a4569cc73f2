"""The C types of an interface: structures of signals that mirror its components, so that paths stay the same.

The path ``legs[2].coxa.cpos`` of a spec is ``walker.legs[2].coxa.cpos`` in C and ``robot.legs[2].coxa.cpos`` in C++.
Each declaration of a component becomes a type, and each of its signals has a type by its value. Properties that may
differ between placements (addresses, scales, units, limits) are data.

If arrays in a component have different lengths in its placements, its declaration becomes several numbered types.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import UnsupportedError
from unity_link.generate.c.names import Names
from unity_link.generate.c.reserved import is_global, is_interface
from unity_link.network.memories import given_parameters, networks, shared_addresses
from unity_link.spec.kinds import KindName
from unity_link.spec.model import ComponentArray, ComponentSpec

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from unity_link.spec.kinds import Enumeration
    from unity_link.spec.model import GroupSpec, Interface, ModuleSpec, Signal

MOST_GROUP_WORDS = 255
_OF_ENUMERATIONS = ("", "_signal", "_name", "_get", "_set", "_post")
_OF_GROUPS = ("", "_subscription", "_read", "_write", "_subscribe", "_next", "_decode")
"""Suffixes of names that are derived from enumerations and from groups."""
_OF_USE = ("link", "networks", "words", "status", "network", "ADDRESSES", "index")
"""Parameters and variables of the function that sets the addresses of networks."""
GUARD_REGISTERS = ("clock", "state", "reason", "estop_open", "arms", "fault_time")
"""Registers of a lease that contain the reason of a refused write, in the order of a `ul_guard`."""
_INT_MAX = 0x7FFF_FFFF


class Constant(NamedTuple):
    """A value of an enumeration."""

    name: str
    """Name in C."""
    short: str
    """Name in C++."""
    text: str
    """Name in the spec."""
    value: int
    doc: str

    @property
    def is_int(self) -> bool:
        """Return whether a C enumerator can have the value."""
        return self.value <= _INT_MAX


class EnumerationType(NamedTuple):
    """The type of an enumeration."""

    name: str
    """Name of the type of its values."""
    short: str
    signal: str
    """Name of the type of its signals."""
    bits: int
    constants: tuple[Constant, ...]
    doc: str


class ValueType(NamedTuple):
    """The types for a signal's value."""

    value: str
    """C type of the value."""
    signal: str
    """C structure that contains the `ul_signal`."""
    coding: str
    """Ending of the runtime's functions for this type."""
    cpp: str

    @property
    def is_enumeration(self) -> bool:
        """Return whether it is an enumeration of the spec."""
        return not self.signal.startswith("ul_")


class SignalMember(NamedTuple):
    """A signal of a component, or a row of signals."""

    name: str
    type: ValueType
    signal: Signal
    """The signal in the first placement of the component."""
    size: int | None
    """Length of the row; None for a single signal."""
    varies: bool
    """True if unit or limits differ between placements."""

    @property
    def declaration(self) -> str:
        """Declaration as a member of a structure."""
        return f"{self.type.signal} {self.name}{brackets(self.size)};"


class PartMember(NamedTuple):
    """A component, an array of components, or modules."""

    name: str
    type: str
    short: str
    size: int | None
    doc: str

    @property
    def declaration(self) -> str:
        """Declaration as a member of a structure."""
        return f"{self.type} {self.name}{brackets(self.size)};"


class PartType(NamedTuple):
    """The type of a component."""

    name: str
    short: str
    doc: str
    signals: tuple[SignalMember, ...]
    parts: tuple[PartMember, ...]
    modules: tuple[PartMember, ...]

    @property
    def column(self) -> int:
        """Column at which the comments begin."""
        return _column([*self.signals, *self.parts, *self.modules])


class GroupMember(NamedTuple):
    """A signal of a group."""

    name: str
    type: ValueType
    signal: Signal
    expression: str
    """C expression for its structure."""
    words: str
    """C expression for its words in a sample."""

    @property
    def declaration(self) -> str:
        """Declaration as a member of the structure of values."""
        return f"{self.type.value} {self.name};"


class GroupType(NamedTuple):
    """The types and members of a group."""

    name: str
    short: str
    class_name: str
    """Name of the C++ class that reads and writes the group."""
    group: GroupSpec
    members: tuple[GroupMember, ...]
    addresses: tuple[int, ...]
    """Addresses of the words of a sample."""
    reads: tuple[str, ...]
    """C expressions for the signals whose words, joined in order, are those of a sample."""

    @property
    def column(self) -> int:
        """Column at which the comments begin."""
        return _column(self.members)

    @property
    def reads_all(self) -> bool:
        """Return whether all signals can be read."""
        return all(member.signal.access.reads for member in self.members)

    @property
    def has_read(self) -> bool:
        """Return whether the group has a read function; a queue is read by itself, or in samples."""
        return self.reads_all and not any(member.signal.fifo for member in self.members)

    @property
    def is_published(self) -> bool:
        """Return whether the gateway publishes the group."""
        return self.group.number is not None and self.reads_all

    @property
    def writes_all(self) -> bool:
        """Return whether all signals can be written."""
        return all(member.signal.access.writes for member in self.members)


def brackets(number: int | None) -> str:
    """Return an index or a size in brackets; empty for None."""
    return "" if number is None else f"[{number}]"


BOOL = ValueType("bool", "ul_bool", "unsigned", "bool")
UNSIGNED = ValueType("uint64_t", "ul_unsigned", "unsigned", "std::uint64_t")
SIGNED = ValueType("int64_t", "ul_signed", "signed", "std::int64_t")
REAL = ValueType("double", "ul_real", "real", "double")


class Layout:
    """The types and names of an interface.

    Raises:
        UnsupportedError: for an array that no C type can represent.
    """

    def __init__(self, interface: Interface) -> None:
        self.interface = interface
        self.prefix = Names(is_reserved=is_interface).take(interface.name)
        self._guards = (f"{self.prefix}_H".upper(), f"{self.prefix}_HPP".upper())
        named = [group for group in interface.groups if group.signals]
        self._member_names = {component.path: self._names_in(component) for component in interface.root.walk()}
        self._group_members = {group.name: self._names_of(group) for group in named}
        # A group is a member of the robot class in C++.
        in_root = Names([*self._guards, *self._member_names[interface.root.path].values()])
        self.group_names = {group.name: in_root.take(group.name) for group in named}
        self.networks_member = in_root.take("networks")
        """Name of the C++ member with the networks."""
        # In C++, a type must not have the name of a member.
        scopes = (*self._member_names.values(), *self._group_members.values(), self.group_names)
        members = {name for names in scopes for name in names.values()} | {self.networks_member}
        self.class_name = Names([self.prefix, *members], is_global).take(_capitalized(self.prefix))
        self._shorts = Names([self.class_name, *members], is_global)
        self._globals = Names([self.prefix, *self._guards, *members], is_global)
        self.root_type = self._global("signals")
        self.check_map = self._global("check_map")
        self.networks = networks(interface)
        self.network_type = self._globals.take(f"{self.prefix}_networks", ("", "_use")) if self.networks else ""
        parameters = Names([*self._guards, self.prefix, *_OF_USE])
        self.given = {name: parameters.take(name) for name in given_parameters(interface)}
        """Identifiers of the parameters that its networks need, by name."""
        self.shared = shared_addresses(interface)
        self.enumerations = {one.name: self._enumeration(one) for one in interface.enumerations}
        self.value_types: dict[str, ValueType] = {}
        """Types of values, by the paths of the signals."""
        self._places: dict[tuple[str, str], list[Signal]] = {}
        self._look_around()
        self.types: dict[str, PartType] = {}
        """Types of components by their C names, each after the types of its members."""
        self._types_by_form: dict[tuple[object, ...], PartType] = {}
        self.expressions: dict[str, str] = {}
        """C expressions by path."""
        self.root = self._part_type(interface.root)
        self._express(interface.root, self.prefix)
        self.groups = tuple(self._group(group) for group in named)
        self.leases = {
            lease: [self.expressions[f"{lease}.{register}"] for register in GUARD_REGISTERS]
            for lease in interface.leases
        }
        """C expressions for the registers of each lease, for its `ul_guard`."""
        self.leases_name = self._global("leases") if self.leases else ""
        self.guards = {
            signal.path: f"&{self.leases_name}[{number}]"
            for number, lease in enumerate(self.leases)
            for signal in interface.refused_by(lease)
        }
        """C expressions for the `ul_guard` of signals that a lease guards, or that belong to a lease."""

    def _global(self, name: str) -> str:
        return self._globals.take(f"{self.prefix}_{name}")

    def _short(self, name: str) -> str:
        """Return a unique name for a C++ type."""
        return self._shorts.take(_capitalized(name))

    # Names of members

    def _names_in(self, component: ComponentSpec) -> dict[str, str]:
        names = Names(self._guards)
        members = [*component.rows, *(part.name for part in component.parts)]
        return {name: names.take(name) for name in [*members, *self.modules_of(component)]}

    def _names_of(self, group: GroupSpec) -> dict[str, str]:
        # The C++ structure of a group has functions of these names.
        names = Names([*self._guards, "decode", "of"])
        return {path: names.take(path) for path in group.signals}

    # Types of values

    def _enumeration(self, enumeration: Enumeration) -> EnumerationType:
        widths = [one.width for one in self.interface.signals.values() if one.kind.enumeration == enumeration]
        # An enumerator of this name would hide the constant of the interface.
        shorts = Names([*self._guards, self.prefix])
        name = self._globals.take(f"{self.prefix}_{enumeration.name}", _OF_ENUMERATIONS)
        return EnumerationType(
            name,
            self._short(enumeration.name),
            f"{name}_signal",
            32 if max(widths) <= 32 else 64,
            tuple(
                Constant(
                    self._globals.take(f"{name}_{one.name}".upper()),
                    shorts.take(one.name),
                    one.name,
                    one.value,
                    one.doc,
                )
                for one in enumeration.values
            ),
            enumeration.doc,
        )

    def _look_around(self) -> None:
        """Collect all placements of each signal, and determine its value type."""
        for component in self.interface.root.walk():
            for signal in component.signals:
                self._places.setdefault((component.type, signal.name), []).append(signal)
        for signals in self._places.values():
            # The value type is the same in every placement of the component.
            made = self._value_type(signals)
            self.value_types.update((signal.path, made) for signal in signals)

    def _value_type(self, signals: list[Signal]) -> ValueType:
        kind, width = signals[0].kind, max(signal.width for signal in signals)
        if any(signal.kind.is_float for signal in signals):
            return REAL
        if kind.name is KindName.BOOL:
            return BOOL
        if kind.enumeration is not None:
            enumeration = self.enumerations[kind.enumeration.name]
            return ValueType(enumeration.name, enumeration.signal, "unsigned", enumeration.short)
        cpp_bits = 32 if width <= 32 else 64
        plain = SIGNED if kind.is_signed else UNSIGNED
        return plain._replace(cpp=f"std::{'int' if kind.is_signed else 'uint'}{cpp_bits}_t")

    # Types of components

    def modules_of(self, component: ComponentSpec) -> dict[str, list[ModuleSpec]]:
        """Return the named modules of a component by name; an array of modules has several."""
        modules: dict[str, list[ModuleSpec]] = {}
        for number in component.modules:
            module = self.interface.modules[number]
            modules.setdefault(str(module.name), []).append(module)
        return modules

    def member_names(self, component: ComponentSpec) -> dict[str, str]:
        """Return the identifiers of a component's members, by name."""
        return self._member_names[component.path]

    def _part_type(self, component: ComponentSpec) -> PartType:
        names = self.member_names(component)
        parts = tuple(self._part(names[part.name], part) for part in component.parts)
        modules = tuple(
            PartMember(names[name], "ul_module", "", len(some) if "[" in str(some[0].path) else None, some[0].doc)
            for name, some in self.modules_of(component).items()
        )
        rows = tuple(map(len, component.rows.values()))
        form = (component.type, rows, tuple((part.type, part.size) for part in (*parts, *modules)))
        if form not in self._types_by_form:
            self._types_by_form[form] = self._new_type(component, parts, modules)
            self.types[self._types_by_form[form].name] = self._types_by_form[form]
        return self._types_by_form[form]

    def _new_type(
        self, component: ComponentSpec, parts: tuple[PartMember, ...], modules: tuple[PartMember, ...]
    ) -> PartType:
        is_root = component is self.interface.root
        names = self.member_names(component)
        signals = tuple(
            SignalMember(
                names[name],
                self.value_types[first.path],
                first,
                None if first.index is None else 1 + len(others),
                varies=self._varies(component.type, name),
            )
            for name, (first, *others) in component.rows.items()
        )
        name = self.root_type if is_root else self._global(component.type)
        short = self.class_name if is_root else self._short(component.type)
        return PartType(name, short, component.type_doc or component.doc, signals, parts, modules)

    def _varies(self, component_type: str, name: str) -> bool:
        places = self._places[component_type, name]
        return len({(signal.unit, signal.minimum, signal.maximum) for signal in places}) > 1

    def _part(self, name: str, part: ComponentSpec | ComponentArray) -> PartMember:
        if isinstance(part, ComponentSpec):
            made = self._part_type(part)
            return PartMember(name, made.name, made.short, None, part.doc if part.doc != made.doc else "")
        types = {self._part_type(item).name: self._part_type(item) for item in part.items}
        if len(types) > 1:
            raise UnsupportedError(
                f"{part.path}: its items have arrays of different lengths, of which C can make no array: "
                "declare one component for each length"
            )
        made = next(iter(types.values()))
        return PartMember(name, made.name, made.short, len(part.items), part.doc if part.doc != made.doc else "")

    def _express(self, component: ComponentSpec, expression: str) -> None:
        names = self.member_names(component)
        for signal in component.signals:
            self.expressions[signal.path] = f"{expression}.{names[signal.name]}{brackets(signal.index)}"
        for part in component.parts:
            for item in part.items if isinstance(part, ComponentArray) else (part,):
                self._express(item, f"{expression}.{names[part.name]}{brackets(item.index)}")

    # Groups

    def _group(self, group: GroupSpec) -> GroupType:
        names = self._group_members[group.name]
        addresses: list[int] = []
        members, reads = [], []
        for path in group.signals:
            signal = self.interface.signals[path]
            place = _find(addresses, signal.addresses)
            if place is None:
                place = len(addresses)
                addresses += signal.addresses
                reads.append(self.expressions[path])
            where = f"words + {place}" if place else "words"
            members.append(GroupMember(names[path], self.value_types[path], signal, self.expressions[path], where))
        if len(addresses) > MOST_GROUP_WORDS:
            raise UnsupportedError(f"group {group.name} needs {len(addresses)} words, at most {MOST_GROUP_WORDS} fit")
        name = self._globals.take(f"{self.prefix}_{group.name}", _OF_GROUPS)
        short = self._short(group.name)
        return GroupType(
            name, short, self._short(f"{short}_group"), group, tuple(members), tuple(addresses), tuple(reads)
        )


def _capitalized(name: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in name.split("_")) or "_"


def _column(members: Sequence[SignalMember | PartMember | GroupMember]) -> int:
    return max((len(member.declaration) for member in members), default=0) + 2


def _find(addresses: list[int], wanted: range) -> int | None:
    """Return the first index at which the wanted addresses are consecutive; None if there is none."""
    size = len(wanted)
    places: Iterator[int] = (
        start for start in range(len(addresses) - size + 1) if addresses[start : start + size] == list(wanted)
    )
    return next(places, None)
