"""Elaboration: components are put into each other, and every signal gets its address.

`Elaborator` begins with each public interface; `building` and `placing` go down from there. A component is elaborated
once for each place that it is put, with the values it is given there. Components that nothing uses are elaborated too,
with parameters that have no value, so that their faults are found as well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.arguments import GATEWAY, GROUP, Binder, Bound
from unity_link.spec.expressions import CONSTANTS, Evaluator, GroupReference, Result, describe
from unity_link.spec.interface import GroupDraft, InterfaceDraft, SignalPlace
from unity_link.spec.kinds import MOST_BITS, Enumeration, EnumValue
from unity_link.spec.model import (
    Interface,
    Parameter,
    ParameterReference,
)
from unity_link.spec.signals import PLAIN_KINDS
from unity_link.spec.syntax import (
    INDEX_NAME,
    ComponentDeclaration,
    EnumDeclaration,
    Node,
    Placement,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from unity_link.spec.diagnostics import Reporter, SourceText, Span
    from unity_link.spec.loading import Declarations, Declared

from unity_link.spec.building import Builder
from unity_link.spec.placing import GATEWAY_WORD, Address, Where

DEFAULT_ADDRESS_BITS = 8
DEFAULT_DATA_BITS = 32


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
        self._timed_groups: set[str] = set()
        """Those whose declaration says when they are published, if only by an argument that was refused."""
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
            if not binder.places.keys().isdisjoint(("DIVISOR", "RATE", "TRIGGER")):
                self._timed_groups.add(name)
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
        builder = Builder(self, draft)
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
        """Return the gateway's widths: those that the caller knows, else those that the spec tells."""
        bound: Bound = {}
        found: Placement | None = None
        for member in node.members:
            if not isinstance(member, Placement) or member.type != GATEWAY_WORD or member.name is not None:
                continue
            if found is not None:
                evaluator.fault(member.type.place, "name-twice", "GATEWAY stands twice in this interface")
                continue
            found = member
            binder = Binder(evaluator, scope)
            bound = binder.bind(GATEWAY_WORD, member.type.place, member.arguments, GATEWAY)
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
        nowhere = SignalPlace(source, node.name.place)
        addresses = {str(item.name): Address(None, nowhere) for item in node.addresses or ()}
        scope |= dict.fromkeys(addresses)
        where = Where("", addresses, scope, None, 0, (str(node.name),))
        Builder(self, draft).component(declared, where, str(node.name))

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

    def span(self, source: SourceText, node: Node) -> Span:
        """Return the place of a node, computed once."""
        found = self._spans.get(id(node))
        if found is None:
            found = self._spans[id(node)] = source.span(*node.place)
        return found

    def enter(self, evaluator: Evaluator, node: ComponentDeclaration) -> None:
        """Record that a component is used."""
        self._used.add(str(node.name))
        self._check_parameters(evaluator, node)

    @property
    def declarations(self) -> Declarations:
        """Declarations of the files."""
        return self._declarations

    @property
    def enumerations(self) -> Mapping[str, Enumeration]:
        """The enumerations by their names."""
        return self._enumerations

    @property
    def reporter(self) -> Reporter:
        """Receiver of faults."""
        return self._reporter

    def new_group(self, name: str) -> GroupDraft:
        """Begin a declared group."""
        source, node = self._declarations.groups[name]
        place, bound, doc = SignalPlace(source, node.name.place), self._group_bounds[name], "\n".join(node.doc)
        return GroupDraft(name, place, bound, doc, says_when=name in self._timed_groups)

    def group_of_number(self, number: int) -> str | None:
        """Return the declared group that has a number."""
        return next((name for name, bound in self._group_bounds.items() if bound.get("NUMBER") == number), None)

    @property
    def globals(self) -> Mapping[str, Result]:
        """Names that have a value everywhere."""
        return self._globals
