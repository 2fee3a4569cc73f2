"""From declarations to the checked model: components are put into each other, and every signal gets its address.

`Elaborator` goes down from each public interface. A component is elaborated once for each place that it is put, with
the values it is given there. Components that nothing uses are elaborated too, with parameters that have no value, so
that their faults are found as well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import msgspec

from unity_link.spec.arguments import GATEWAY, GROUP, Binder, Bound
from unity_link.spec.diagnostics import Reporter, Source, Span, did_you_mean, listed
from unity_link.spec.expressions import CONSTANTS, Evaluator, GroupReference, Result, describe
from unity_link.spec.interface import GroupDraft, InterfaceDraft, Place, Placed
from unity_link.spec.kinds import MOST_BITS, Enumeration, EnumValue
from unity_link.spec.model import (
    Component,
    ComponentArray,
    Interface,
    Module,
    Parameter,
    ParameterReference,
    Signal,
)
from unity_link.spec.modules import COMMON, MODULES
from unity_link.spec.signals import PLAIN_KINDS, SignalReader
from unity_link.spec.syntax import (
    INDEX_NAME,
    Argument,
    ComponentDeclaration,
    EnumDeclaration,
    Node,
    Placement,
    SignalDeclaration,
)
from unity_link.spec.syntax import Parameter as ParameterNode

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from unity_link.spec.loading import Declarations, Declared

DEFAULT_ADDRESS_BITS = 8
DEFAULT_DATA_BITS = 32
MOST_PARTS = 100_000
"""Signals, components and modules of one interface: more is a mistake in an array."""
MOST_LEVELS = 24
MOST_ITEMS = 65_536
_GATEWAY = "GATEWAY"


class Address(NamedTuple):
    """An address that a component is given, and where it was written."""

    value: int | None
    place: Place


class Where(NamedTuple):
    """Where a component is being put."""

    path: str
    addresses: Mapping[str, Address]
    scope: Mapping[str, Result]
    module: int | None
    base: int
    chain: tuple[str, ...]
    """The declarations that it is inside of."""


class Elaborator:
    """Makes the model of what files declare."""

    def __init__(
        self, declarations: Declarations, reporter: Reporter, address_bits: int | None, data_bits: int | None
    ) -> None:
        self._declarations = declarations
        self._reporter = reporter
        self._given_widths = (address_bits, data_bits)
        self._spans: dict[int, Span] = {}
        self._checked: set[int] = set()
        self._globals: dict[str, Result] = CONSTANTS | {name: GroupReference(name) for name in declarations.groups}
        self._enumerations = {name: self._enumeration(declared) for name, declared in declarations.enumerations.items()}
        self._group_bounds = self._read_groups()
        self._used: set[str] = set()

    def run(self) -> tuple[Interface, ...]:
        """Build all interfaces; they are worth something only if nothing was reported."""
        interfaces = tuple(self._interface(declared) for declared in self._declarations.interfaces)
        for name, declared in self._declarations.components.items():
            if name not in self._used and not declared.node.public:
                self._check_unused(declared)
        return interfaces

    # What stands outside of components

    def _enumeration(self, declared: Declared[EnumDeclaration]) -> Enumeration:
        source, node = declared
        evaluator = Evaluator(source, self._reporter)
        if node.name in PLAIN_KINDS:
            evaluator.fault(node.name.place, "name-taken", f"'{node.name}' is a kind already")
        values: dict[str, EnumValue] = {}
        numbers: dict[int, str] = {}
        following = 0
        for item in node.members:
            number = following if item.value is None else evaluator.evaluate(item.value, CONSTANTS)
            if number is None:
                continue
            if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < 1 << MOST_BITS:
                message = f"the value of '{item.name}' is a whole number from 0 on, not {describe(number)}"
                evaluator.fault(item.place, "bad-enum", message)
                continue
            if item.name in values or item.name == "mro" or item.name.startswith("_"):
                message = (
                    f"'{item.name}' stands twice in {node.name}"
                    if item.name in values
                    else (f"'{item.name}' cannot be the name of a value")
                )
                evaluator.fault(item.name.place, "bad-enum", message)
            elif number in numbers:
                message = f"'{item.name}' and '{numbers[number]}' are both {number}"
                evaluator.fault(item.place, "bad-enum", message)
            numbers.setdefault(number, item.name)
            values.setdefault(item.name, EnumValue(str(item.name), number, "\n".join(item.doc)))
            following = number + 1
        if not node.members:
            evaluator.fault(node.name.place, "bad-enum", f"{node.name} has no values")
        return Enumeration(str(node.name), tuple(values.values()), "\n".join(node.doc), declared.span)

    def _read_groups(self) -> dict[str, Bound]:
        bounds = {}
        for name, (source, node) in self._declarations.groups.items():
            evaluator = Evaluator(source, self._reporter)
            binder = Binder(evaluator, CONSTANTS)
            bound = binder.bind(node.name, node.name.place, node.arguments, GROUP, by_place=2)
            if "DIVISOR" in bound and "RATE" in bound:
                evaluator.fault(binder.places["RATE"], "group-rate", "a group has a DIVISOR or a RATE, not both")
            bounds[name] = bound
        return bounds

    # Interfaces

    def _interface(self, declared: Declared[ComponentDeclaration]) -> Interface:
        source, node = declared
        evaluator = Evaluator(source, self._reporter)
        if node.addresses is not None:
            message = "a public interface is not put anywhere, so it has no addresses"
            evaluator.fault(node.name.place, "public-addresses", message, "leave out ': @(...)'")
        parameters = []
        for item in node.parameters:
            value = None if item.default is None else evaluator.evaluate(item.default, self._globals)
            assert not isinstance(value, GroupReference | ParameterReference) or item.default is not None
            if isinstance(value, GroupReference | ParameterReference):
                message = f"the parameter of a public interface cannot be {describe(value)}"
                evaluator.fault(item.place, "bad-argument", message)
                value = None
            parameters.append(Parameter(str(item.name), value))
        self._check_parameters(evaluator, node)
        scope: dict[str, Result] = dict(self._globals)
        for given in parameters:
            scope[given.name] = ParameterReference(given.name) if given.value is None else given.value
        address_bits, data_bits = self._widths(evaluator, node, scope)
        draft = InterfaceDraft(self._reporter, address_bits, data_bits)
        builder = _Builder(self, draft)
        module, base = builder.module_of_all(source, node, scope)
        where = Where("", {}, scope, module, base, (str(node.name),))
        root = builder.component(declared, where, str(node.name))
        groups = draft.check()
        enumerations = {
            placed.signal.kind.enumeration.name: placed.signal.kind.enumeration
            for placed in draft.signals
            if placed.signal.kind.enumeration is not None
        }
        return Interface(
            name=str(node.name),
            parameters=tuple(parameters),
            address_bits=address_bits,
            data_bits=data_bits,
            root=root,
            modules=tuple(module for module, _ in draft.modules),
            groups=groups,
            enumerations=tuple(enumerations.values()),
            doc="\n".join(node.doc),
            span=self.span(source, node),
        )

    def _widths(self, evaluator: Evaluator, node: ComponentDeclaration, scope: Mapping[str, Result]) -> tuple[int, int]:
        """Give the gateway's widths: those that the caller knows, else those that the spec tells."""
        bound: Bound = {}
        found: Placement | None = None
        for member in node.members:
            if not isinstance(member, Placement) or member.type != _GATEWAY or member.name is not None:
                continue
            if found is not None:
                evaluator.fault(member.type.place, "name-twice", "GATEWAY stands twice in this interface")
                continue
            found = member
            binder = Binder(evaluator, scope)
            bound = binder.bind(_GATEWAY, member.type.place, member.arguments, GATEWAY)
            for option, given in zip(("ADDRESS_BITS", "DATA_BITS"), self._given_widths, strict=True):
                if given is not None and bound.get(option, given) != given:
                    message = f"{option} is {bound[option]} here, and the gateway's is {given}"
                    evaluator.fault(binder.places[option], "gateway-width", message)
        given_address, given_data = self._given_widths
        return (
            given_address or bound.get("ADDRESS_BITS", DEFAULT_ADDRESS_BITS),
            given_data or bound.get("DATA_BITS", DEFAULT_DATA_BITS),
        )

    def _check_unused(self, declared: Declared[ComponentDeclaration]) -> None:
        """Check a component that nothing uses, as far as that can be done without its parameters."""
        source, node = declared
        scope = self._globals | {str(item.name): None for item in node.parameters}
        draft = InterfaceDraft(self._reporter, 32, max(self._given_widths[1] or 0, DEFAULT_DATA_BITS))
        nowhere = Place(source, node.name.place)
        addresses = {str(item.name): Address(None, nowhere) for item in node.addresses or ()}
        scope |= dict.fromkeys(addresses)
        where = Where("", addresses, scope, None, 0, (str(node.name),))
        _Builder(self, draft).component(declared, where, str(node.name))

    def _check_parameters(self, evaluator: Evaluator, node: ComponentDeclaration) -> None:
        """Check the names of the parameters of a component; once for each."""
        if id(node) in self._checked:
            return
        self._checked.add(id(node))
        seen: set[str] = set()
        for item in [*node.parameters, *(node.addresses or ())]:
            if item.name in seen:
                evaluator.fault(item.name.place, "name-twice", f"{node.name} has two parameters '{item.name}'")
            elif item.name == INDEX_NAME or item.name in CONSTANTS:
                meaning = "the index of an array" if item.name == INDEX_NAME else "a constant"
                evaluator.fault(item.name.place, "name-taken", f"'{item.name}' is {meaning}, and cannot be a parameter")
            seen.add(item.name)

    # For the builder

    def span(self, source: Source, node: Node) -> Span:
        """Give the place of a node, computed once."""
        found = self._spans.get(id(node))
        if found is None:
            found = self._spans[id(node)] = source.span(*node.place)
        return found

    def enter(self, evaluator: Evaluator, node: ComponentDeclaration) -> None:
        """Take note that a component is used."""
        self._used.add(str(node.name))
        self._check_parameters(evaluator, node)

    @property
    def declarations(self) -> Declarations:
        """What the files declare."""
        return self._declarations

    @property
    def enumerations(self) -> Mapping[str, Enumeration]:
        """The enumerations by their names."""
        return self._enumerations

    @property
    def reporter(self) -> Reporter:
        """Where faults go."""
        return self._reporter

    def new_group(self, name: str) -> GroupDraft:
        """Begin a declared group."""
        source, node = self._declarations.groups[name]
        return GroupDraft(name, Place(source, node.name.place), self._group_bounds[name], "\n".join(node.doc))

    def group_of_number(self, number: int) -> str | None:
        """Give the declared group that has a number."""
        return next((name for name, bound in self._group_bounds.items() if bound.get("NUMBER") == number), None)

    @property
    def globals(self) -> Mapping[str, Result]:
        """What has a value everywhere."""
        return self._globals


class _Builder:
    """Builds the components of one interface."""

    def __init__(self, elaborator: Elaborator, draft: InterfaceDraft) -> None:
        self._elaborator = elaborator
        self._draft = draft
        self._full = False
        self._evaluators: dict[int, tuple[Evaluator, SignalReader]] = {}

    def _tools(self, source: Source) -> tuple[Evaluator, SignalReader]:
        tools = self._evaluators.get(id(source))
        if tools is None:
            evaluator = Evaluator(source, self._elaborator.reporter)
            reader = SignalReader(evaluator, self._elaborator.enumerations, self._draft.data_bits)
            tools = self._evaluators[id(source)] = (evaluator, reader)
        return tools

    def component(
        self,
        declared: Declared[ComponentDeclaration],
        where: Where,
        name: str,
        index: int | None = None,
        arguments: Mapping[str, Result] | None = None,
    ) -> Component:
        """Build a component where it is put."""
        source, node = declared
        evaluator, _ = self._tools(source)
        self._elaborator.enter(evaluator, node)
        contents = _Contents(self, declared, where)
        contents.fill(node.members, where.module, where.base)
        given = {key: value for key, value in (arguments or {}).items() if isinstance(value, int | float | str)}
        return Component(
            name=name,
            path=where.path,
            type=str(node.name),
            index=index,
            arguments=given,
            signals=tuple(contents.signals),
            parts=tuple(contents.parts),
            modules=tuple(contents.modules),
            doc="\n".join(node.doc),
            span=self._elaborator.span(source, node),
        )

    def count(self, evaluator: Evaluator, place: tuple[int, int]) -> bool:
        """Count one more part; False where there are too many."""
        self._draft.parts += 1
        if self._draft.parts > MOST_PARTS and not self._full:
            self._full = True
            message = f"an interface of more than {MOST_PARTS:,} signals and components is too large"
            evaluator.fault(place, "too-many", message, "look at the sizes of the arrays")
        return not self._full

    # Signals

    def signal(
        self, source: Source, node: SignalDeclaration, where: Where, module: int | None, base: int
    ) -> Signal | None:
        """Build a signal; None where it has no address or no kind."""
        evaluator, reader = self._tools(source)
        address = self._address(evaluator, node, where)
        parts = reader.read(node, where.scope)
        if address.value is None or parts is None:
            return None
        bound, name = parts.arguments, str(node.name)
        path = f"{where.path}.{name}" if where.path else name
        fifo: Bound | None = bound.get("FIFO")
        groups = self._groups(evaluator, bound, parts.places)
        signal = Signal(
            name=name,
            path=path,
            id=bound.get("ID", path),
            address=base + address.value,
            word_bits=self._draft.data_bits,
            lowest_bit=parts.lowest_bit,
            kind=parts.kind,
            access=parts.access,
            fifo=fifo is not None,
            fifo_words=fifo.get("WORDS") if fifo is not None else None,
            unit=bound.get("UNIT", ""),
            minimum=bound.get("MIN"),
            maximum=bound.get("MAX"),
            group=groups[0].name if groups and parts.publishing is not None else None,
            groups=tuple(group.name for group in groups),
            poll_hz=bound["POLL"].get("RATE") if "POLL" in bound else None,
            module=module,
            doc="\n".join(node.doc),
            span=self._elaborator.span(source, node),
        )
        for group in groups:
            group.signals.append((signal, Place(source, node.name.place)))
        identity = Place(source, parts.places.get("ID", node.name.place))
        self._draft.signals.append(Placed(signal, address.place, identity))
        return signal

    def _address(self, evaluator: Evaluator, node: SignalDeclaration, where: Where) -> Address:
        place = Place(evaluator.source, node.name.place)
        if node.address is None:
            found = where.addresses.get(node.name)
            if found is not None:
                return found
            message = f"'{node.name}' has no address"
            names = where.addresses
            advice = did_you_mean(node.name, names) or (
                f"name it in the component's @(...), or write @{node.name} = 0x10"
                if where.path or names
                else f"write where it is: @{node.name} = 0x10"
            )
            evaluator.fault(node.name.place, "no-address", message, advice)
            return Address(None, place)
        place = Place(evaluator.source, node.address.place)
        value = evaluator.evaluate(node.address, where.scope)
        return Address(whole_address(evaluator, node.address.place, value), place)

    def _groups(self, evaluator: Evaluator, bound: Bound, places: Mapping[str, tuple[int, int]]) -> list[GroupDraft]:
        """Find the groups of a signal, the one that publishes it first."""
        found: list[GroupDraft] = []
        for word in ("PUBLISH", "GROUP"):
            clause: Bound = bound.get(word, {})
            reference = clause.get("GROUP")
            if reference is None:
                continue
            place = Place(evaluator.source, places[word])
            group = self._group(reference, place)
            if word == "PUBLISH":
                group.published = True
                self._set_divisor(evaluator, group, clause.get("DIVISOR"), places)
            if group not in found:
                found.append(group)
        return found

    def _group(self, reference: GroupReference | int, place: Place) -> GroupDraft:
        groups = self._draft.groups
        if isinstance(reference, GroupReference):
            name = reference.name
        else:
            name = self._elaborator.group_of_number(reference) or f"group_{reference}"
        if name not in groups:
            if name in self._elaborator.declarations.groups:
                groups[name] = self._elaborator.new_group(name)
            else:
                assert isinstance(reference, int)
                groups[name] = GroupDraft(name, place, {"NUMBER": reference})
        return groups[name]

    def _set_divisor(
        self, evaluator: Evaluator, group: GroupDraft, divisor: int | None, places: Mapping[str, tuple[int, int]]
    ) -> None:
        """Give a group the divisor that a signal tells; it has only one."""
        if divisor is None:
            return
        place = Place(evaluator.source, places["PUBLISH.DIVISOR"])
        if "RATE" in group.bound:
            message = f"the group {group.name} has a rate, and cannot have a divisor too"
            evaluator.fault(place.bounds, "group-divisor", message)
        elif group.divisor is None:
            group.divisor, group.divisor_place = divisor, place
        elif group.divisor != divisor:
            message = f"the group {group.name} is published with divisor {group.divisor}, and here with {divisor}"
            note = group.divisor_place.note("a group has one divisor, which is given here")
            advice = "put the signal into another group"
            self._elaborator.reporter.error(
                evaluator.source, place.bounds, "group-divisor", message, help=advice, notes=[note]
            )

    # Modules

    def module_of_all(
        self, source: Source, node: ComponentDeclaration, scope: Mapping[str, Result]
    ) -> tuple[int | None, int]:
        """Find the module that all members of an interface stand in: one without a name and without a block."""
        found: tuple[int | None, int] = (None, 0)
        evaluator, _ = self._tools(source)
        first: Placement | None = None
        for member in node.members:
            is_it = isinstance(member, Placement) and member.name is None and member.members is None
            if not isinstance(member, Placement) or not is_it or member.type not in MODULES:
                continue
            if first is not None:
                message = f"{first.type} is the module of this interface already"
                advice = f"give it a name, or a block: {member.type}(...) {{ ... }}"
                evaluator.fault(member.type.place, "two-modules", message, advice)
                continue
            first = member
            found = self.module(source, member, scope, None, 0, None)
        return found

    def module(
        self,
        source: Source,
        node: Placement,
        scope: Mapping[str, Result],
        parent: int | None,
        base: int,
        path: str | None,
    ) -> tuple[int, int]:
        """Build a module; give its index and its base."""
        evaluator, _ = self._tools(source)
        kind = MODULES[node.type]
        if node.addresses is not None:
            evaluator.fault(
                node.type.place, "module-address", f"the address of {node.type} is its BASE", "as in BASE=0x40"
            )
        binder = Binder(evaluator, scope)
        bound = binder.bind(node.type, node.type.place, node.arguments, (*COMMON, *kind.slots))
        start = base + bound.pop("BASE", 0) + kind.offset(bound)
        size = bound.pop("SIZE", None)
        module = Module(
            type=str(node.type),
            name=None if node.name is None else str(node.name),
            path=path,
            base=start,
            words=kind.words(bound) if size is None else size,
            parent=parent,
            arguments=bound,
            doc="\n".join(node.doc),
            span=self._elaborator.span(source, node),
        )
        self._draft.modules.append((module, Place(source, node.type.place)))
        return len(self._draft.modules) - 1, start


class _Contents:
    """The members of one component while they are built."""

    def __init__(self, builder: _Builder, declared: Declared[ComponentDeclaration], where: Where) -> None:
        self._builder = builder
        self._elaborator = builder._elaborator  # noqa: SLF001  (one machine in two classes)
        self._source, self._node = declared
        self._where = where
        self._evaluator, _ = builder._tools(self._source)  # noqa: SLF001
        self._names: dict[str, tuple[int, int]] = {}
        self.signals: list[Signal] = []
        self.parts: list[Component | ComponentArray] = []
        self.modules: list[int] = []

    def fill(self, members: Sequence[SignalDeclaration | Placement], module: int | None, base: int) -> None:
        """Build members that stand in a module."""
        for member in members:
            if member.name is not None:
                self._take_name(member)
            if not self._builder.count(self._evaluator, member.place):
                return
            if isinstance(member, SignalDeclaration):
                signal = self._builder.signal(self._source, member, self._where, module, base)
                if signal is not None:
                    self.signals.append(signal)
            elif member.type in MODULES:
                self._place_module(member, module, base)
            elif member.type == _GATEWAY and member.name is None:
                self._check_gateway(member)
            else:
                self._place_component(member, module, base)

    def _take_name(self, member: SignalDeclaration | Placement) -> None:
        assert member.name is not None
        first = self._names.setdefault(member.name.lower(), member.name.place)
        if first == member.name.place:
            return
        source = self._source
        other = source.text[slice(*first)]
        message = f"'{member.name}' stands twice in {self._node.name}"
        if other != member.name:
            message = f"'{member.name}' and '{other}' differ only in case, which VHDL does not tell apart"
        span = source.span(*first)
        note = (span, "the first one is here", source.line(span.line))
        self._elaborator.reporter.error(source, member.name.place, "name-twice", message, notes=[note])

    def _path(self, name: str, index: int | None) -> str:
        item = str(name) if index is None else f"{name}[{index}]"
        return f"{self._where.path}.{item}" if self._where.path else item

    def _count(self, member: Placement) -> range | None:
        """Give the indices of an array."""
        assert member.count is not None
        value = self._evaluator.evaluate(member.count, self._where.scope)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= MOST_ITEMS:
            message = f"the size of an array is a whole number from 1 to {MOST_ITEMS}, not {describe(value)}"
            self._evaluator.fault(member.count.place, "bad-size", message)
            return None
        return range(value)

    # Modules

    def _check_gateway(self, member: Placement) -> None:
        if not self._node.public:
            message = "GATEWAY stands in a public interface, not in a component"
            self._evaluator.fault(member.type.place, "misplaced", message)
        if member.members is not None or member.addresses is not None:
            self._evaluator.fault(member.type.place, "misplaced", "GATEWAY has neither addresses nor members")

    def _place_module(self, member: Placement, module: int | None, base: int) -> None:
        if member.name is None:
            self._place_unnamed_module(member, module, base)
            return
        if member.count is None:
            self._place_named_module(member, module, base, None)
            return
        if member.members is not None:
            self._evaluator.fault(member.type.place, "misplaced", "an array of modules has no members of its own")
            return
        for index in self._count(member) or ():
            if not self._builder.count(self._evaluator, member.place):
                return
            self._place_named_module(member, module, base, index)

    def _place_named_module(self, member: Placement, module: int | None, base: int, index: int | None) -> None:
        assert member.name is not None
        scope = self._where.scope if index is None else {**self._where.scope, INDEX_NAME: index}
        path = self._path(member.name, index)
        number, start = self._builder.module(self._source, member, scope, module, base, path)
        self.modules.append(number)
        if member.members is not None:
            self.fill(member.members, number, start)

    def _place_unnamed_module(self, member: Placement, module: int | None, base: int) -> None:
        if member.members is not None:
            number, start = self._builder.module(self._source, member, self._where.scope, module, base, None)
            self.fill(member.members, number, start)
        elif not self._node.public or member not in self._node.members:
            message = f"this {member.type} has neither a name nor members"
            advice = f"name it, as in pool: {member.type}(...);, or give it a block: {member.type}(...) {{ ... }}"
            self._evaluator.fault(member.type.place, "misplaced", message, advice)

    # Components

    def _place_component(self, member: Placement, module: int | None, base: int) -> None:
        declared = self._declared(member)
        if member.name is None and declared is not None:
            message = f"this {member.type} has no name"
            self._evaluator.fault(member.type.place, "no-name", message, f"as in first: {member.type}(...);")
            return
        if member.members is not None and (declared is not None or member.name is not None):
            message = f"only a hardware module has members here, and {member.type} is none"
            self._evaluator.fault(member.type.place, "misplaced", message, f"modules are {listed(MODULES, 'and')}")
        indices = [None] if member.count is None else list(self._count(member) or ())
        if declared is None or member.name is None:
            return
        items = []
        for index in indices:
            if index is not None and not self._builder.count(self._evaluator, member.place):
                break
            items.append(self._component(member, declared, index, module, base))
        if member.count is None:
            self.parts += items
        elif items:
            self.parts.append(
                ComponentArray(
                    name=str(member.name),
                    path=self._path(member.name, None),
                    items=tuple(items),
                    doc="\n".join(member.doc),
                    span=self._elaborator.span(self._source, member),
                )
            )

    def _declared(self, member: Placement) -> Declared[ComponentDeclaration] | None:
        components = self._elaborator.declarations.components
        declared = components.get(member.type)
        place = member.type.place
        if declared is None:
            what = "module" if member.name is None else "component"
            known = [*(name for name, one in components.items() if not one.node.public), *MODULES]
            if self._node.public:
                known.append(_GATEWAY)
            advice = did_you_mean(member.type, known) or f"declare it: {member.type}() {{ ... }}"
            self._evaluator.fault(place, "unknown-component", f"there is no {what} '{member.type}'", advice)
            return None
        if member.type in self._where.chain:
            chain = [*self._where.chain[self._where.chain.index(member.type) :], str(member.type)]
            message = f"{member.type} contains itself: {' -> '.join(chain)}"
            self._evaluator.fault(place, "recursion", message)
            return None
        if declared.node.public:
            message = f"{member.type} is a public interface, and cannot be part of another one"
            self._evaluator.fault(place, "public-part", message, "leave out 'public' where it is declared")
            return None
        if len(self._where.chain) >= MOST_LEVELS:
            message = f"components stand in each other more than {MOST_LEVELS} levels deep"
            self._evaluator.fault(place, "too-deep", message)
            return None
        return declared

    def _component(
        self,
        member: Placement,
        declared: Declared[ComponentDeclaration],
        index: int | None,
        module: int | None,
        base: int,
    ) -> Component:
        assert member.name is not None
        scope = self._where.scope if index is None else {**self._where.scope, INDEX_NAME: index}
        node = declared.node
        values = self._bind(member, node.parameters, member.arguments, scope, "argument")
        given: dict[str, Result] = {}
        for parameter in node.parameters:
            name = str(parameter.name)
            if name in values:
                given[name] = values[name][0]
            else:
                default = parameter.default
                tools = Evaluator(declared.source, self._elaborator.reporter)
                given[name] = None if default is None else tools.evaluate(default, self._elaborator.globals)
        addresses = self._addresses(member, declared, scope)
        inner = {**self._elaborator.globals, **given, **{name: one.value for name, one in addresses.items()}}
        chain = (*self._where.chain, str(node.name))
        where = Where(self._path(member.name, index), addresses, inner, module, base, chain)
        component = self._builder.component(declared, where, str(member.name), index, given)
        return component if not member.doc else _documented(component, member)

    def _addresses(
        self, member: Placement, declared: Declared[ComponentDeclaration], scope: Mapping[str, Result]
    ) -> dict[str, Address]:
        parameters = declared.node.addresses or []
        bound = self._bind(member, parameters, member.addresses or [], scope, "address")
        addresses = {}
        for parameter in parameters:
            value, place = bound.get(str(parameter.name), (None, member.type.place))
            tools = self._evaluator
            if str(parameter.name) not in bound and parameter.default is not None:
                tools = Evaluator(declared.source, self._elaborator.reporter)
                value, place = tools.evaluate(parameter.default, self._elaborator.globals), parameter.place
            whole = whole_address(tools, place, value)
            addresses[str(parameter.name)] = Address(whole, Place(tools.source, place))
        return addresses

    def _bind(
        self,
        member: Placement,
        parameters: Sequence[ParameterNode],
        arguments: Sequence[Argument],
        scope: Mapping[str, Result],
        word: str,
    ) -> dict[str, tuple[Result, tuple[int, int]]]:
        """Match what a component is given with what it takes; give values and places by the names of the parameters."""
        names = [str(parameter.name) for parameter in parameters]
        free = list(names)
        bound: dict[str, tuple[Result, tuple[int, int]]] = {}
        surplus = 0
        for argument in arguments:
            value = self._evaluator.evaluate(argument.value, scope)
            if argument.name is None:
                if not free:
                    surplus += 1
                    continue
                name = free.pop(0)
            elif argument.name not in names:
                advice = did_you_mean(argument.name, names)
                message = f"{member.type} has no {word} '{argument.name}'"
                self._evaluator.fault(argument.name.place, "unknown-argument", message, advice)
                continue
            elif argument.name in bound:
                message = f"{argument.name} is given twice"
                self._evaluator.fault(argument.place, "argument-twice", message)
                continue
            else:
                name = str(argument.name)
                free.remove(name)
            bound[name] = (value, argument.value.place)
        missing = [str(one.name) for one in parameters if str(one.name) not in bound and one.default is None]
        if surplus or (missing and not any(argument.name not in {None, *names} for argument in arguments)):
            self._report_number(member, names, arguments, missing, word)
        return bound

    def _report_number(
        self, member: Placement, names: list[str], arguments: Sequence[Argument], missing: list[str], word: str
    ) -> None:
        place = (arguments[0].start, arguments[-1].end) if arguments else member.type.place
        plural = "" if len(names) == 1 else "es" if word == "address" else "s"
        takes = f"{len(names)} {word}{plural} ({', '.join(names)})" if names else f"no {word}{plural}"
        given = f"{len(arguments)} {'is' if len(arguments) == 1 else 'are'} given"
        advice = f"{listed(missing, 'and')} {'is' if len(missing) == 1 else 'are'} missing" if missing else ""
        self._evaluator.fault(place, f"{word}-count", f"{member.type} takes {takes}, and {given}", advice)


def _documented(component: Component, member: Placement) -> Component:
    return msgspec.structs.replace(component, doc="\n".join(member.doc))


def whole_address(evaluator: Evaluator, place: tuple[int, int], value: Result) -> int | None:
    """Give a value as an address; report one that is none."""
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int):
        evaluator.fault(place, "bad-address", f"an address is a whole number, not {describe(value)}")
        return None
    return value
