"""The members of a component where it is put: names, arrays, arguments and addresses.

`put_component` goes through the members of one component by its `Contents`, and so through each component inside;
signals and modules are built by the `Builder`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from unity_link.spec.building import Address, Builder, Where, whole_address
from unity_link.spec.diagnostics import did_you_mean, listed
from unity_link.spec.expressions import LEFT_OUT, Evaluator, Result, describe
from unity_link.spec.interface import SignalPlace
from unity_link.spec.model import ComponentArray, ComponentSpec, Signal
from unity_link.spec.modules import MODULES
from unity_link.spec.syntax import (
    INDEX_NAME,
    Argument,
    ComponentDeclaration,
    Placement,
    SignalDeclaration,
)
from unity_link.spec.syntax import ParameterDeclaration as ParameterNode

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from unity_link.spec.loading import Declared

GATEWAY_WORD = "GATEWAY"
MOST_LEVELS = 24
MOST_ITEMS = 65_536
"""Most items of an array."""


def put_component(
    builder: Builder,
    declared: Declared[ComponentDeclaration],
    where: Where,
    name: str,
    index: int | None = None,
    arguments: Mapping[str, Result] | None = None,
) -> ComponentSpec:
    """Return a component, built where it is put."""
    source, node = declared
    evaluator, _ = builder.tools(source)
    builder.context.enter(evaluator, node)
    contents = Contents(builder, declared, where)
    contents.fill(node.members, where.module, where.base)
    given = {key: value for key, value in (arguments or {}).items() if isinstance(value, int | float | str)}
    return ComponentSpec(
        name=name,
        path=where.path,
        type=str(node.name),
        index=index,
        arguments=given,
        signals=tuple(contents.signals),
        parts=tuple(contents.parts),
        modules=tuple(contents.modules),
        doc="\n".join(node.doc),
        span=builder.context.span(source, node),
    )


class Contents:
    """The members of one component while they are built."""

    def __init__(self, builder: Builder, declared: Declared[ComponentDeclaration], where: Where) -> None:
        self._builder = builder
        self._context = builder.context
        self._source, self._node = declared
        self._where = where
        self._evaluator, _ = builder.tools(self._source)
        self._names: dict[str, tuple[int, int]] = {}
        self.signals: list[Signal] = []
        self.parts: list[ComponentSpec | ComponentArray] = []
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
            elif member.type == GATEWAY_WORD and member.name is None:
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
        self._context.reporter.error(source, member.name.place, "name-twice", message, notes=[note])

    def _path(self, name: str, index: int | None) -> str:
        item = str(name) if index is None else f"{name}[{index}]"
        return f"{self._where.path}.{item}" if self._where.path else item

    def _count(self, member: Placement) -> range | None:
        """Return the indices of an array."""
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
                    span=self._context.span(self._source, member),
                )
            )

    def _declared(self, member: Placement) -> Declared[ComponentDeclaration] | None:
        components = self._context.declarations.components
        declared = components.get(member.type)
        place = member.type.place
        if declared is None:
            what = "module" if member.name is None else "component"
            known = [*(name for name, one in components.items() if not one.node.public), *MODULES]
            if self._node.public:
                known.append(GATEWAY_WORD)
            advice = did_you_mean(member.type, known)
            if not advice and member.type.isupper():
                advice = f"modules are {listed(MODULES, 'and')}; one of your own is known where its class is imported"
            advice = advice or f"declare it: {member.type}() {{ ... }}"
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
    ) -> ComponentSpec:
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
                tools = Evaluator(declared.source, self._context.reporter)
                given[name] = None if default is None else tools.evaluate(default, self._context.globals | given)
        addresses = self._addresses(member, declared, scope, given)
        inner = {**self._context.globals, **given, **{name: one.value for name, one in addresses.items()}}
        chain = (*self._where.chain, str(node.name))
        where = Where(self._path(member.name, index), addresses, inner, module, base, chain)
        component = put_component(self._builder, declared, where, str(member.name), index, given)
        return component if not member.doc else _documented(component, member)

    def _addresses(
        self,
        member: Placement,
        declared: Declared[ComponentDeclaration],
        scope: Mapping[str, Result],
        given: Mapping[str, Result],
    ) -> dict[str, Address]:
        parameters = declared.node.addresses or []
        bound = self._bind(member, parameters, member.addresses or [], scope, "address")
        addresses: dict[str, Address] = {}
        known = {**self._context.globals, **given}
        for parameter in parameters:
            value, place = bound.get(str(parameter.name), (None, member.type.place))
            tools = self._evaluator
            if str(parameter.name) not in bound and parameter.default is not None:
                tools = Evaluator(declared.source, self._context.reporter)
                value, place = tools.evaluate(parameter.default, known), parameter.place
            whole = known[str(parameter.name)] = whole_address(tools, place, value)
            addresses[str(parameter.name)] = Address(whole, SignalPlace(tools.source, place))
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
        seen: set[str] = set()
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
            elif argument.name in seen:
                message = f"{argument.name} is given twice"
                self._evaluator.fault(argument.place, "argument-twice", message)
                continue
            else:
                name = str(argument.name)
                free.remove(name)
            seen.add(name)
            if value is not LEFT_OUT:
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


def _documented(component: ComponentSpec, member: Placement) -> ComponentSpec:
    return msgspec.structs.replace(component, doc="\n".join(member.doc), type_doc=component.doc)
