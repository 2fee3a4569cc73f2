"""Builds the signals, modules and groups of an interface.

They are added to an `InterfaceDraft`, which checks them as a whole at the end.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.spec.arguments import Binder, Bound
from unity_link.spec.diagnostics import SourceText, did_you_mean
from unity_link.spec.expressions import Evaluator, GroupReference, LeftOut, Result, describe
from unity_link.spec.interface import AxesLimit, GroupDraft, InterfaceDraft, Placed, SignalPlace
from unity_link.spec.model import ModuleSpec, Signal, Trigger
from unity_link.spec.modules import COMMON, MODULES
from unity_link.spec.signals import SignalReader
from unity_link.spec.syntax import (
    ComponentDeclaration,
    Placement,
    SignalDeclaration,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec.context import Context
    from unity_link.spec.cores import CoreFolder, Cores, FoundCore

MOST_PARTS = 100_000
"""Most signals, components and modules of one interface; a larger number is a mistake in the size of an array."""
_EFFORT_OF_A_PART = 15
"""Effort of a signal or a module without its expressions and arguments, as in `Reporter.spend`."""


class Address(NamedTuple):
    """An address argument of a component, and its place in the source."""

    value: int | None
    place: SignalPlace


class Where(NamedTuple):
    """The position of a component in the interface, and the names that are known there."""

    path: str
    addresses: Mapping[str, Address]
    scope: Mapping[str, Result]
    module: int | None
    base: int
    chain: tuple[ComponentDeclaration, ...]
    """The declarations of the components around it, and its own as the last one."""
    pins: Mapping[str, str | LeftOut] = {}
    """Pins of the board by the names of the component's pins; `none` for pins that are not connected."""
    core: CoreFolder | None = None
    """Folder of the component's core; None if it is not a core."""
    given: Mapping[str, SignalPlace] = {}
    """Places of the component's arguments, by parameter name."""
    placed: SignalPlace | None = None
    """Place of the component's word in its placement; None for the interface itself."""
    core_at: SignalPlace | None = None
    """Place of the address that the spec gives to the core that this is, or is inside of; None outside of cores."""

    def path_of(self, name: str, index: int | None) -> str:
        """Return the path of a member; with `index`, of an element of a row or an array."""
        item = str(name) if index is None else f"{name}[{index}]"
        return f"{self.path}.{item}" if self.path else item


class Builder:
    """Builds the signals and modules of one interface.

    Args:
        context: declarations of the spec.
        cores: cores that the spec can name.
        draft: receives the signals, modules and groups.
    """

    def __init__(self, context: Context, cores: Cores, draft: InterfaceDraft) -> None:
        self.context = context
        self.cores = cores
        self._draft = draft
        self._contexts: dict[int, Context] = {}
        self._full = False
        self._evaluators: dict[int, tuple[Evaluator, SignalReader]] = {}

    @property
    def data_bits(self) -> int:
        """Width of the gateway's words."""
        return self._draft.data_bits

    def tools(self, source: SourceText) -> tuple[Evaluator, SignalReader]:
        """Return the evaluator and the reader of signals for a source."""
        tools = self._evaluators.get(id(source))
        if tools is None:
            evaluator = Evaluator(source, self.context.reporter)
            reader = SignalReader(evaluator, self.context_of(source).enumerations, self._draft.data_bits)
            tools = self._evaluators[id(source)] = (evaluator, reader)
        return tools

    def context_of(self, source: SourceText) -> Context:
        """Return the context of a source: that of its core for a file of a core, otherwise that of the spec."""
        return self._contexts.get(id(source), self.context)

    def enter_core(self, core: FoundCore) -> None:
        """Use the core's own declarations for names in the files of a core."""
        for source in core.sources:
            self._contexts[id(source)] = core.context

    def limit(self, message: Callable[[int], str]) -> str:
        """Add a limit as in `Interface.limits`; return its message for the clock of the spec, empty if it holds."""
        self._draft.limits.append(message)
        return message(self._draft.clock_hz)

    def limit_axes(self, path: str, place: SignalPlace, message: Callable[[int, int], str]) -> None:
        """Add a limit that depends on the number of placements that share an instance.

        `InterfaceDraft.check_axes` checks it when all placements are known.

        Args:
            path: of the component.
            place: place of the argument, for the error.
            message: returns why a parameter is not allowed with a number of axes and a clock in Hz; empty if it is.
        """
        placing = self.context.reporter.current
        # An unused component has no instance.
        if placing is not None:
            self._draft.limits_of_axes.append(AxesLimit(path, place, message, placing))

    def count(self, evaluator: Evaluator, place: tuple[int, int], where: Where) -> bool:
        """Count one more part of a component; return False if the interface has too many. Its scope costs effort."""
        self._draft.parts += 1
        self.context.reporter.spend(_EFFORT_OF_A_PART + len(where.scope) // 8)
        if self._draft.parts > MOST_PARTS and not self._full:
            self._full = True
            message = f"an interface of more than {MOST_PARTS:,} signals and components is too large"
            evaluator.fault(place, "too-many", message, "look at the sizes of the arrays")
        return not self._full

    def path_of(self, where: Where, name: str, index: int | None) -> str:
        """Return the path of a signal or component; the model keeps it, so its length costs effort."""
        path = where.path_of(name, index)
        self.context.reporter.spend(len(path) // 32)
        return path

    # Signals

    def signal(
        self,
        source: SourceText,
        node: SignalDeclaration,
        where: Where,
        module: int | None,
        base: int,
        index: int | None = None,
    ) -> Signal | None:
        """Build a signal, or one of a row; return None if its address or kind is missing or invalid."""
        evaluator, reader = self.tools(source)
        address = self._address(evaluator, node, where)
        parts = reader.read(node, where.scope)
        if address.value is None or parts is None:
            return None
        bound, name = parts.arguments, str(node.name)
        path = self.path_of(where, name, index)
        fifo: Bound | None = bound.get("FIFO")
        groups = self._groups(evaluator, bound, parts.places)
        signal = Signal(
            name=name,
            path=path,
            id=bound.get("ID", path),
            index=index,
            address=base + address.value,
            word_bits=self._draft.data_bits,
            lowest_bit=parts.lowest_bit,
            kind=parts.kind,
            access=parts.access,
            fifo=fifo is not None,
            fifo_words=fifo.get("WORDS") if fifo is not None else None,
            effect=parts.effect,
            unit=bound.get("UNIT", ""),
            minimum=bound.get("MIN"),
            maximum=bound.get("MAX"),
            group=groups[0].name if groups and parts.publishing is not None else None,
            groups=tuple(group.name for group in groups),
            poll_hz=bound["POLL"].get("RATE") if "POLL" in bound else None,
            reset=parts.reset,
            safe=parts.safe,
            timed=parts.timed,
            laps_of=where.path_of(parts.laps_of, None) if parts.laps_of else None if parts.laps_of is None else path,
            pin=bound.get("PIN"),
            module=module,
            doc="\n".join(node.doc),
            span=self.context.span(source, node),
        )
        for group in groups:
            group.signals.append((signal, SignalPlace(source, node.name.place)))
        identity = SignalPlace(source, parts.places.get("ID", node.name.place))
        timed = SignalPlace(source, parts.places.get("TIMED", node.name.place))
        wraps = SignalPlace(source, parts.places.get("WRAPS", node.name.place))
        self._draft.signals.append(Placed(signal, address.place, identity, timed, wraps, where.core_at))
        return signal

    def _address(self, evaluator: Evaluator, node: SignalDeclaration, where: Where) -> Address:
        place = SignalPlace(evaluator.source, node.name.place)
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
        place = SignalPlace(evaluator.source, node.address.place)
        value = evaluator.evaluate(node.address, where.scope)
        return Address(whole_address(evaluator, node.address.place, value), place)

    def _groups(self, evaluator: Evaluator, bound: Bound, places: Mapping[str, tuple[int, int]]) -> list[GroupDraft]:
        """Return the groups of a signal, the one that publishes it first."""
        found: list[GroupDraft] = []
        for word in ("PUBLISH", "GROUP"):
            clause: Bound = bound.get(word, {})
            reference = clause.get("GROUP")
            if reference is None:
                continue
            place = SignalPlace(evaluator.source, places[word])
            group = self._group(reference, place)
            if word == "PUBLISH":
                group.published = True
                group.says_when |= "PUBLISH.DIVISOR" in places
                self._set_divisor(evaluator, group, clause.get("DIVISOR"), places)
            if group not in found:
                found.append(group)
        return found

    def _group(self, reference: GroupReference | int, place: SignalPlace) -> GroupDraft:
        groups = self._draft.groups
        if isinstance(reference, GroupReference):
            name = reference.name
        else:
            name = self.context.group_of_number(reference) or self._undeclared(f"group_{reference}")
        if name not in groups:
            if name in self.context.declarations.groups:
                groups[name] = self.context.new_group(name)
            else:
                assert isinstance(reference, int)
                groups[name] = GroupDraft(name, place, {"NUMBER": reference})
        return groups[name]

    def _undeclared(self, name: str) -> str:
        """Return a name for an undeclared group that differs from those of declared groups."""
        while name in self.context.declarations.groups:
            name += "_"
        return name

    def _set_divisor(
        self, evaluator: Evaluator, group: GroupDraft, divisor: int | None, places: Mapping[str, tuple[int, int]]
    ) -> None:
        """Set the divisor of a group from a signal's PUBLISH; report a second, different divisor."""
        if divisor is None:
            return
        place = SignalPlace(evaluator.source, places["PUBLISH.DIVISOR"])
        if "RATE" in group.bound:
            message = f"the group {group.name} has a rate, and cannot have a divisor too"
            evaluator.fault(place.bounds, "group-divisor", message)
        elif group.divisor is None:
            group.divisor, group.divisor_place = divisor, place
        elif group.divisor != divisor:
            message = f"the group {group.name} is published with divisor {group.divisor}, and here with {divisor}"
            note = group.divisor_place.note("a group has one divisor, which is given here")
            advice = "put the signal into another group"
            self.context.reporter.error(
                evaluator.source, place.bounds, "group-divisor", message, help=advice, notes=[note]
            )

    # Cores

    def trigger(self, source: SourceText, node: SignalDeclaration, place: tuple[int, int], bound: Bound) -> Trigger:
        """Build a trigger of a core and add it to its group."""
        reference = bound.get("GROUP")
        if reference is None:
            return Trigger(name=str(node.name))
        group = self._group(reference, SignalPlace(source, place))
        group.triggers.append(SignalPlace(source, place))
        return Trigger(name=str(node.name), group=group.name)

    # Modules

    def module_of_all(
        self, source: SourceText, node: ComponentDeclaration, scope: Mapping[str, Result]
    ) -> tuple[int | None, int]:
        """Return index and base of the module of all members, one without name and block; (None, 0) if none."""
        found: tuple[int | None, int] = (None, 0)
        evaluator, _ = self.tools(source)
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
        source: SourceText,
        node: Placement,
        scope: Mapping[str, Result],
        parent: int | None,
        base: int,
        path: str | None,
    ) -> tuple[int, int]:
        """Build a module; return its index in `Interface.modules` and its base."""
        evaluator, _ = self.tools(source)
        kind = MODULES[node.type]
        if node.addresses is not None:
            evaluator.fault(
                node.type.place, "module-address", f"the address of {node.type} is its BASE", "as in BASE=0x40"
            )
        binder = Binder(evaluator, scope)
        bound = binder.bind(node.type, node.type.place, node.arguments, (*COMMON, *kind.slots))
        start = base + bound.pop("BASE", 0) + kind.offset(bound)
        size = bound.pop("SIZE", None)
        module = ModuleSpec(
            type=str(node.type),
            name=None if node.name is None else str(node.name),
            path=path,
            base=start,
            words=kind.words(bound) if size is None else size,
            parent=parent,
            arguments=bound,
            doc="\n".join(node.doc),
            span=self.context.span(source, node),
        )
        self._draft.modules.append((module, SignalPlace(source, node.type.place)))
        return len(self._draft.modules) - 1, start


def whole_address(evaluator: Evaluator, place: tuple[int, int], value: Result) -> int | None:
    """Return a value as an address; None if it is unknown or not a whole number, which is reported."""
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int):
        evaluator.fault(place, "bad-address", f"an address is a whole number, not {describe(value)}")
        return None
    return value
