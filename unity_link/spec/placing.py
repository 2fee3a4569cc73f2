"""Places a component in another one: names, arrays, arguments and addresses of its members.

`put_component` builds one component from its members, by `Contents`, and recursively each component inside it. The
`Builder` builds signals and modules.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from unity_link.spec.building import Address, Builder, Where, whole_address
from unity_link.spec.cores import is_word
from unity_link.spec.diagnostics import Placing, did_you_mean, listed
from unity_link.spec.entity import ENTITY_WORD, LIMIT_WORDS, PORT_WORDS, Hardware, pins_of
from unity_link.spec.expressions import LEFT_OUT, Evaluator, LeftOut, Result, describe
from unity_link.spec.interface import SignalPlace
from unity_link.spec.model import STAGE_BITS, ComponentArray, ComponentSpec, Core, Signal, Way
from unity_link.spec.modules import MODULES
from unity_link.spec.syntax import (
    INDEX_NAME,
    Argument,
    ComponentDeclaration,
    Name,
    Placement,
    SignalDeclaration,
    Word,
)
from unity_link.spec.syntax import ParameterDeclaration as ParameterNode

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from unity_link.spec.cores import FoundCore
    from unity_link.spec.loading import Declared

GATEWAY_WORD = "GATEWAY"
_NO_PIN = Name(name=Word("none"))
"""Default value of the address parameters that are pins."""
_FORMER = {
    "QUADRATURE": "it is the core ENCODER now, one for each channel",
    "COUNTER": "it is the core ENCODER now, with COUNTER=true, one for each channel",
}
"""Words of removed modules, with the core that replaces each."""
_EFFORT_OF_A_COMPONENT = 60
_EFFORT_OF_A_PARAMETER = 3
MOST_LEVELS = 24
MOST_ITEMS = 65_536
"""Most elements of an array."""


def put_component(
    builder: Builder,
    declared: Declared[ComponentDeclaration],
    where: Where,
    name: str,
    index: int | None = None,
    arguments: Mapping[str, Result] | None = None,
) -> ComponentSpec:
    """Return the model of a component at the place where it is put."""
    source, node = declared
    evaluator, _ = builder.tools(source)
    builder.context.enter(evaluator, node)
    contents = Contents(builder, declared, where)
    contents.fill(node.members, where.module, where.base)
    core = contents.core()
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
        core=core,
        doc="\n".join(node.doc),
        span=builder.context.span(source, node),
    )


class Contents:
    """Members of one component while it is built."""

    def __init__(self, builder: Builder, declared: Declared[ComponentDeclaration], where: Where) -> None:
        self._builder = builder
        self._source, self._node = declared
        self._context = builder.context_of(self._source)
        self._where = where
        self._evaluator, _ = builder.tools(self._source)
        self._names: dict[str, tuple[int, int]] = {}
        self.signals: list[Signal] = []
        self.parts: list[ComponentSpec | ComponentArray] = []
        self.modules: list[int] = []
        self._hardware = Hardware(self._evaluator, where, is_interface=self._node.public)

    def core(self) -> Core | None:
        """Return the hardware of the component, after its members were built; None if it has none."""
        if self.parts or self.modules or any(signal.fifo for signal in self.signals):
            self._hardware.refuse_parts()
        guarded = {signal.name: signal.safe for signal in self.signals if signal.safe is not None}
        self._hardware.check_leases({safe.lease for safe in guarded.values()})
        holds = {name: self._names[name.lower()] for name, safe in guarded.items() if safe.bits is None}
        self._hardware.check_holds(holds)
        widths: dict[str, set[int]] = {}
        for signal in self.signals:
            widths.setdefault(signal.name, set()).add(signal.width)
        return self._hardware.core(self._node.name, widths)

    def fill(self, members: Sequence[SignalDeclaration | Placement], module: int | None, base: int) -> None:
        """Build members that are addressed relative to `base`, the base of a module."""
        for member in members:
            if member.name is not None:
                self._take_name(member)
            if not self._builder.count(self._evaluator, member.place, self._where):
                return
            if isinstance(member, SignalDeclaration) and member.access in PORT_WORDS:
                self._hardware.add_port(self._builder, self._source, member)
            elif isinstance(member, SignalDeclaration):
                self.signals += self._signals(member, module, base)
            elif member.type in MODULES:
                self._place_module(member, module, base)
            elif member.type == GATEWAY_WORD and member.name is None:
                self._check_gateway(member)
            elif member.type == ENTITY_WORD and member.name is None:
                self._hardware.set_entity(member)
            elif member.type in LIMIT_WORDS and member.name is None:
                self._hardware.check_limit(self._builder, self._node, member)
            else:
                self._place_component(member, module, base)

    def _take_name(self, member: SignalDeclaration | Placement) -> None:
        assert member.name is not None
        first = self._names.setdefault(member.name.lower(), member.name.place)
        if first == member.name.place:
            return
        source = self._source
        other = source.text[slice(*first)]
        message = f"'{member.name}' is declared twice in {self._node.name}"
        if other != member.name:
            message = f"'{member.name}' and '{other}' differ only in case, which VHDL ignores"
        span = source.span(*first)
        note = (span, "the first one is here", source.line(span.line))
        self._context.reporter.error(source, member.name.place, "name-twice", message, notes=[note])

    def _signals(self, member: SignalDeclaration, module: int | None, base: int) -> Iterator[Signal]:
        """Yield a signal, or all signals of a row."""
        if member.count is None:
            alone = self._builder.signal(self._source, member, self._where, module, base)
            yield from () if alone is None else (alone,)
            return
        # If the length of a row is unknown, check one signal, as far as that is possible without its index.
        for index in self._count(member) or (None,):
            if not self._builder.count(self._evaluator, member.place, self._where):
                return
            where = self._where._replace(scope={**self._where.scope, INDEX_NAME: index})
            signal = self._builder.signal(self._source, member, where, module, base, index or 0)
            if signal is not None:
                yield signal

    def _count(self, member: Placement | SignalDeclaration) -> range | None:
        """Return the indices of an array or row; None if its size is unknown."""
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
            message = "GATEWAY belongs in a public interface, not in a component"
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
            if not self._builder.count(self._evaluator, member.place, self._where):
                return
            self._place_named_module(member, module, base, index)

    def _place_named_module(self, member: Placement, module: int | None, base: int, index: int | None) -> None:
        assert member.name is not None
        scope = self._where.scope if index is None else {**self._where.scope, INDEX_NAME: index}
        path = self._where.path_of(member.name, index)
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
        core = self._core(member)
        declared = core.declared if core is not None else self._declared(member)
        if declared is not None and not self._can_stand_here(member, declared):
            declared = None
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
            if index is not None and not self._builder.count(self._evaluator, member.place, self._where):
                break
            items.append(self._component(member, declared, index, module, base, core))
        if member.count is None:
            self.parts += items
        elif items:
            self.parts.append(
                ComponentArray(
                    name=str(member.name),
                    path=self._where.path_of(member.name, None),
                    items=tuple(items),
                    doc="\n".join(member.doc),
                    span=self._context.span(self._source, member),
                )
            )

    def _core(self, member: Placement) -> FoundCore | None:
        """Return the core that a placement names, or None. A component of the spec hides a core of the same word."""
        if member.type in self._context.declarations.components or not is_word(member.type):
            return None
        core = self._builder.cores.find(self._source, member)
        if core is not None:
            self._builder.enter_core(core)
        return core

    def _declared(self, member: Placement) -> Declared[ComponentDeclaration] | None:
        components = self._context.declarations.components
        declared = components.get(member.type)
        place = member.type.place
        if declared is None:
            cores = self._builder.cores
            if is_word(member.type) and cores.has(member.type):
                return None
            what = "module" if member.name is None else "component"
            known = [*(name for name, one in components.items() if not one.node.public), *MODULES, *cores.words]
            if self._node.public:
                known.append(GATEWAY_WORD)
            advice = _FORMER.get(member.type, "") or did_you_mean(member.type, known)
            if not advice and member.type.isupper() and cores.words:
                advice = (
                    f"modules are {listed(MODULES, 'and')}, and cores {listed(cores.words, 'and')}; one of your own is "
                    f"cores/{member.type.lower()}/{member.type.lower()}.ul beside the spec"
                )
            advice = advice or f"declare it: {member.type}() {{ ... }}"
            self._evaluator.fault(place, "unknown-component", f"there is no {what} '{member.type}'", advice)
            return None
        return declared

    def _can_stand_here(self, member: Placement, declared: Declared[ComponentDeclaration]) -> bool:
        """Return whether a component or core may be part of this one; otherwise report the reason."""
        chain, place = self._where.chain, member.type.place
        # Compare declarations, not names: a core may have the same word as a component of the spec.
        around = next((chain[depth:] for depth, node in enumerate(chain) if node is declared.node), None)
        if around is not None:
            names = " -> ".join(str(node.name) for node in (*around, declared.node))
            self._evaluator.fault(place, "recursion", f"{member.type} contains itself: {names}")
        elif declared.node.public:
            message = f"{member.type} is a public interface, and cannot be part of another one"
            self._evaluator.fault(place, "public-part", message, "leave out 'public' where it is declared")
        elif len(chain) >= MOST_LEVELS:
            message = f"components are nested more than {MOST_LEVELS} levels deep"
            self._evaluator.fault(place, "too-deep", message)
        else:
            return True
        return False

    def _component(
        self,
        member: Placement,
        declared: Declared[ComponentDeclaration],
        index: int | None,
        module: int | None,
        base: int,
        core: FoundCore | None,
    ) -> ComponentSpec:
        assert member.name is not None
        scope = self._where.scope if index is None else {**self._where.scope, INDEX_NAME: index}
        node = declared.node
        arguments, places = _with_base(member, node) if core is not None else (member.arguments, member.addresses or [])
        values = self._bind(member, node.parameters, arguments, scope, "argument")
        path = self._builder.path_of(self._where, member.name, index)
        arguments_at = {name: SignalPlace(self._source, place) for name, (_, place) in values.items()}
        known = dict(self._builder.context_of(declared.source).globals)
        self._context.reporter.spend(_EFFORT_OF_A_COMPONENT + len(known) // 8)
        given: dict[str, Result] = {}
        # Report errors inside a core at the author's arguments, because the author did not write the core.
        placing = Placing(declared.source, node.place, path, {} if core is None else arguments_at)
        with self._context.reporter.placing(placing):
            for parameter in node.parameters:
                name = str(parameter.name)
                if name in values:
                    given[name] = values[name][0]
                else:
                    default = parameter.default
                    tools = Evaluator(declared.source, self._context.reporter)
                    given[name] = None if default is None else tools.evaluate(default, known)
                known[name] = given[name]
            addresses, pins = self._addresses(member, declared, places, scope, known)
            inner = known | {name: one.value for name, one in addresses.items()}
            chain = (*self._where.chain, node)
            folder = None if core is None else core.folder
            put = SignalPlace(self._source, member.type.place)
            base_at = next((one.place for one in addresses.values()), put)
            core_at = self._where.core_at or (None if core is None else base_at)
            where = Where(path, addresses, inner, module, base, chain, pins, folder, arguments_at, put, core_at)
            component = put_component(self._builder, declared, where, str(member.name), index, given)
        if not index:
            self._warn_of_no_lease(member, component)
            self._check_stage(member, component)
        return component if not member.doc else _documented(component, member)

    def _warn_of_no_lease(self, member: Placement, component: ComponentSpec) -> None:
        """Warn of an output without a lease: it stays on if its program dies."""
        core = component.core
        if core is None or "armed" not in core.wants or any(signal.safe is not None for signal in component.signals):
            return
        if not any(pin.way is Way.OUT and pin.is_used for pin in core.pins):
            return
        message = f"no lease guards {member.name}: it goes on when the program that writes to it has died"
        advice = "name a LEASE of the interface, as in LEASE=drive"
        self._context.reporter.warning(self._source, member.type.place, "no-lease", message, help=advice)

    def _check_stage(self, member: Placement, component: ComponentSpec) -> None:
        """Report a schedule in a gateway whose words are narrower than those of a schedule."""
        bits = self._builder.data_bits
        if component.core is not None and component.core.stages and bits < STAGE_BITS:
            message = f"{member.name} takes words of {STAGE_BITS} bits, and the gateway has {bits}"
            self._evaluator.fault(member.type.place, "bad-timed", message, f"as in GATEWAY(DATA_BITS={STAGE_BITS});")

    def _addresses(
        self,
        member: Placement,
        declared: Declared[ComponentDeclaration],
        arguments: Sequence[Argument],
        scope: Mapping[str, Result],
        given: Mapping[str, Result],
    ) -> tuple[dict[str, Address], dict[str, str | LeftOut]]:
        """Return the addresses of a component, and the board's pins that are connected to its own."""
        parameters = declared.node.addresses or []
        pins = [ParameterNode(name=name, default=_NO_PIN) for name in pins_of(declared.node)]
        bound = self._bind(member, [*parameters, *pins], arguments, scope, "address")
        sites: dict[str, str | LeftOut] = {}
        for pin in pins:
            site, place = bound.pop(str(pin.name), (None, member.type.place))
            if isinstance(site, str | LeftOut):
                sites[str(pin.name)] = site
            elif site is not None:
                message = f"{pin.name} is a pin of {member.type}, and takes the name of a pin of the board"
                self._evaluator.fault(place, "bad-pin", f"{message}, not {describe(site)}", 'as in pwm="led0"')
        addresses: dict[str, Address] = {}
        known = dict(given)
        for parameter in parameters:
            value, place = bound.get(str(parameter.name), (None, member.type.place))
            tools = self._evaluator
            if str(parameter.name) not in bound and parameter.default is not None:
                tools = Evaluator(declared.source, self._context.reporter)
                value, place = tools.evaluate(parameter.default, known), parameter.place
            whole = known[str(parameter.name)] = whole_address(tools, place, value)
            addresses[str(parameter.name)] = Address(whole, SignalPlace(tools.source, place))
        return addresses, sites

    def _bind(
        self,
        member: Placement,
        parameters: Sequence[ParameterNode],
        arguments: Sequence[Argument],
        scope: Mapping[str, Result],
        word: str,
    ) -> dict[str, tuple[Result, tuple[int, int]]]:
        """Match arguments to parameters; return values and places by the names of the parameters."""
        self._context.reporter.spend(_EFFORT_OF_A_PARAMETER * (len(parameters) + len(arguments)))
        names = {str(parameter.name): parameter for parameter in parameters}
        # Pins are given only by name.
        pins = {name for name, parameter in names.items() if parameter.default is _NO_PIN}
        seen: set[str] = set()
        free = (name for name in names if name not in pins and name not in seen)
        bound: dict[str, tuple[Result, tuple[int, int]]] = {}
        surplus = 0
        for argument in arguments:
            value = self._evaluator.evaluate(argument.value, scope)
            if argument.name is None:
                if not (name := next(free, "")):
                    surplus += 1
                    continue
            elif argument.name not in names:
                nouns = f"{word} or pin" if pins else word
                advice = did_you_mean(argument.name, names)
                advice = advice or (f"it takes {listed(names, 'and')}" if names else "it takes none")
                message = f"{member.type} has no {nouns} '{argument.name}'"
                self._evaluator.fault(argument.name.place, "unknown-argument", message, advice)
                continue
            elif argument.name in seen:
                message = f"{argument.name} is given twice"
                self._evaluator.fault(argument.place, "argument-twice", message)
                continue
            else:
                name = str(argument.name)
            seen.add(name)
            if value is not LEFT_OUT or name in pins:
                bound[name] = (value, argument.value.place)
        named = [name for name in names if name not in pins]
        missing = [str(one.name) for one in parameters if str(one.name) not in bound and one.default is None]
        if surplus or (missing and all(argument.name is None or argument.name in names for argument in arguments)):
            self._report_number(member, named, arguments, missing, word)
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


def _with_base(member: Placement, node: ComponentDeclaration) -> tuple[Sequence[Argument], Sequence[Argument]]:
    """Return arguments and addresses of a core; its addresses may also be named arguments."""
    names = {str(parameter.name) for parameter in node.addresses or ()}
    addresses = [argument for argument in member.arguments if argument.name in names]
    others = [argument for argument in member.arguments if argument.name not in names]
    return others, [*addresses, *(member.addresses or ())]


def _documented(component: ComponentSpec, member: Placement) -> ComponentSpec:
    return msgspec.structs.replace(component, doc="\n".join(member.doc), type_doc=component.doc)
