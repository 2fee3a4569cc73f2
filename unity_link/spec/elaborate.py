"""Elaboration: places components in each other, and assigns an address to every signal.

`Elaborator` starts with each public interface; `placing` and `building` elaborate the components inside it, once for
each placement, with the arguments of that placement. Unused components are elaborated too, with parameters that have no
value, to find their faults.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.arguments import GATEWAY, Binder, Bound
from unity_link.spec.building import Address, Builder, Where
from unity_link.spec.context import Context
from unity_link.spec.expressions import (
    Evaluator,
    GroupReference,
    LeaseReference,
    LeftOut,
    PlacedReference,
    Result,
    ScheduleReference,
    describe,
)
from unity_link.spec.interface import DEFAULT_CLOCK_HZ, InterfaceDraft, SignalPlace
from unity_link.spec.model import Interface, Parameter, ParameterReference
from unity_link.spec.placing import GATEWAY_WORD, put_component
from unity_link.spec.syntax import ComponentDeclaration, Placement

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec.cores import Cores
    from unity_link.spec.diagnostics import Reporter
    from unity_link.spec.loading import Declarations, Declared

DEFAULT_ADDRESS_BITS = 8
DEFAULT_DATA_BITS = 32
_REFERENCES: dict[str, Callable[[str], PlacedReference]] = {"LEASE": LeaseReference, "SCHEDULE": ScheduleReference}
"""Words of cores whose names other signals use as arguments, as in SAFE(0, drive) and TIMED(plan)."""


def _references(node: ComponentDeclaration) -> dict[str, PlacedReference]:
    """Return the leases and schedules of an interface by name; its members can refer to them."""
    return {
        str(member.name): _REFERENCES[member.type](str(member.name))
        for member in node.members
        if isinstance(member, Placement)
        and member.type in _REFERENCES
        and member.name is not None
        and member.count is None
    }


class Elaborator:
    """Makes the model from the declarations of a spec's files."""

    def __init__(
        self,
        declarations: Declarations,
        reporter: Reporter,
        cores: Cores,
        address_bits: int | None,
        data_bits: int | None,
    ) -> None:
        self._context = Context(declarations, reporter)
        self._cores = cores
        self._given_widths = (address_bits, data_bits)

    def run(self) -> tuple[Interface, ...]:
        """Build and return all interfaces; they are valid only if no error was reported."""
        interfaces = tuple(self._interface(declared) for declared in self._context.declarations.interfaces)
        for name, declared in self._context.declarations.components.items():
            if name not in self._context.used and not declared.node.public:
                self._check_unused(declared)
        return interfaces

    def _interface(self, declared: Declared[ComponentDeclaration]) -> Interface:
        source, node = declared
        evaluator = Evaluator(source, self._context.reporter)
        if node.addresses is not None:
            message = "a public interface is not put anywhere, so it has no addresses"
            evaluator.fault(node.name.place, "public-addresses", message, "leave out ': @(...)'")
        parameters = []
        scope: dict[str, Result] = dict(self._context.globals)
        for item in node.parameters:
            value = None if item.default is None else evaluator.evaluate(item.default, scope)
            if isinstance(value, GroupReference | PlacedReference | ParameterReference | LeftOut):
                message = f"the parameter of a public interface cannot be {describe(value)}"
                evaluator.fault(item.place, "bad-argument", message)
                value = None
            parameters.append(Parameter(str(item.name), value))
            scope[str(item.name)] = ParameterReference(str(item.name)) if value is None else value
        scope |= _references(node)
        self._context.check_parameters(evaluator, node)
        address_bits, data_bits, clock_hz = self._gateway(evaluator, node, scope)
        draft = InterfaceDraft(self._context.reporter, address_bits, data_bits, clock_hz)
        builder = Builder(self._context, self._cores, draft)
        module, base = builder.module_of_all(source, node, scope)
        where = Where("", {}, scope, module, base, (node,))
        root = put_component(builder, declared, where, str(node.name))
        cores = [part for part in root.walk() if part.core is not None]
        draft.check_timed({part.path for part in cores if part.core is not None and part.core.stages})
        draft.check_axes(cores)
        groups = draft.check()
        enumerations = {
            placed.signal.kind.enumeration.name: placed.signal.kind.enumeration
            for placed in draft.signals
            if placed.signal.kind.enumeration is not None
        }
        interface = Interface(
            name=str(node.name),
            parameters=tuple(parameters),
            address_bits=address_bits,
            data_bits=data_bits,
            root=root,
            modules=tuple(module for module, _ in draft.modules),
            groups=groups,
            enumerations=tuple(enumerations.values()),
            doc="\n".join(node.doc),
            span=self._context.span(source, node),
        )
        vars(interface)["limits"] = tuple(draft.limits)
        return interface

    def _gateway(
        self, evaluator: Evaluator, node: ComponentDeclaration, scope: Mapping[str, Result]
    ) -> tuple[int, int, int]:
        """Return address bits, data bits and clock in Hz of the gateway; widths given by the caller come first."""
        bound: Bound = {}
        found: Placement | None = None
        for member in node.members:
            if not isinstance(member, Placement) or member.type != GATEWAY_WORD or member.name is not None:
                continue
            if found is not None:
                evaluator.fault(member.type.place, "name-twice", "this interface has two GATEWAY statements")
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
            bound.get("CLOCK", DEFAULT_CLOCK_HZ),
        )

    def _check_unused(self, declared: Declared[ComponentDeclaration]) -> None:
        """Check an unused component, as far as that is possible without values of its parameters."""
        source, node = declared
        scope = self._context.globals | {str(item.name): None for item in node.parameters}
        draft = InterfaceDraft(self._context.reporter, 32, max(self._given_widths[1] or 0, DEFAULT_DATA_BITS))
        nowhere = SignalPlace(source, node.name.place)
        addresses = {str(item.name): Address(None, nowhere) for item in node.addresses or ()}
        scope |= dict.fromkeys(addresses)
        where = Where("", addresses, scope, None, 0, (node,))
        put_component(Builder(self._context, self._cores, draft), declared, where, str(node.name))
