"""The declarations of a spec that all of its components see: constants, groups and enumerations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.arguments import GROUP, Binder, Bound
from unity_link.spec.expressions import CONSTANTS, Evaluator, GroupReference, Result, describe
from unity_link.spec.interface import GroupDraft, SignalPlace
from unity_link.spec.kinds import MOST_BITS, Enumeration, EnumValue
from unity_link.spec.signals import PLAIN_KINDS
from unity_link.spec.syntax import INDEX_NAME, ComponentDeclaration, EnumDeclaration, Node

if TYPE_CHECKING:
    from unity_link.spec.diagnostics import Reporter, SourceText, Span
    from unity_link.spec.loading import Declarations, Declared


class Context:
    """The declarations of a spec, and the names that are known in all components.

    Args:
        declarations: declarations of all files.
        reporter: receives the faults.
    """

    def __init__(self, declarations: Declarations, reporter: Reporter) -> None:
        self.declarations = declarations
        self.reporter = reporter
        self.globals: dict[str, Result] = CONSTANTS | {name: GroupReference(name) for name in declarations.groups}
        """Names that are known everywhere, with their values."""
        self.enumerations = {name: self._enumeration(declared) for name, declared in declarations.enumerations.items()}
        self.used: set[str] = set()
        """Names of the components that were elaborated, in an interface or by themselves."""
        self._spans: dict[int, Span] = {}
        self._checked: set[int] = set()
        self._timed_groups: set[str] = set()
        """Names of the groups whose declaration has a rate, divisor or trigger, even an invalid one."""
        self._group_bounds = self._read_groups()

    def span(self, source: SourceText, node: Node) -> Span:
        """Return the place of a node; places are cached."""
        found = self._spans.get(id(node))
        if found is None:
            found = self._spans[id(node)] = source.span(*node.place)
        return found

    def enter(self, evaluator: Evaluator, node: ComponentDeclaration) -> None:
        """Record that a component is used."""
        self.used.add(str(node.name))
        self.check_parameters(evaluator, node)

    def check_parameters(self, evaluator: Evaluator, node: ComponentDeclaration) -> None:
        """Check the names of a component's parameters; each component is checked only once."""
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

    def new_group(self, name: str) -> GroupDraft:
        """Return a draft of a declared group."""
        source, node = self.declarations.groups[name]
        place, bound, doc = SignalPlace(source, node.name.place), self._group_bounds[name], "\n".join(node.doc)
        return GroupDraft(name, place, bound, doc, says_when=name in self._timed_groups)

    def group_of_number(self, number: int) -> str | None:
        """Return the name of the declared group that has a number; None if there is none."""
        return next((name for name, bound in self._group_bounds.items() if bound.get("NUMBER") == number), None)

    def _enumeration(self, declared: Declared[EnumDeclaration]) -> Enumeration:
        source, node = declared
        evaluator = Evaluator(source, self.reporter)
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
                    f"'{item.name}' is declared twice in {node.name}"
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
        for name, (source, node) in self.declarations.groups.items():
            evaluator = Evaluator(source, self.reporter)
            binder = Binder(evaluator, CONSTANTS)
            bound = binder.bind(node.name, node.name.place, node.arguments, GROUP, by_place=2)
            if "DIVISOR" in bound and "RATE" in bound:
                evaluator.fault(binder.places["RATE"], "group-rate", "a group has a DIVISOR or a RATE, not both")
            bounds[name] = bound
            if not binder.places.keys().isdisjoint(("DIVISOR", "RATE", "TRIGGER")):
                self._timed_groups.add(name)
        return bounds
