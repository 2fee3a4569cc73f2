"""The generics and ports of an entity, and their comments.

A comment above a generic or port describes it and all those below it up to the next comment. The comment of a generic
that is not a boolean begins with the range of values, up to a colon. The comment of a port that belongs to another
clock than `clk` ends with `Clock: NAME.`, or with `Clock: none.` if it belongs to no clock. `As of ENTITY.` gives each
the comment of the generic or port with the same name in another entity; a difference may follow after a semicolon.
"""

from __future__ import annotations

import dataclasses
import itertools
import operator
import re
from typing import TYPE_CHECKING

from gateware.tools.syntax import nodes, parse, text_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tree_sitter import Node

_CLOCK = re.compile(r"\s*Clock: (\w+)\.$")
_CLOCK_NAMES = re.compile(r"(?:^|_)(?:clk|clkout)$")
_ELSEWHERE = re.compile(r"As of (\w+)(?:; (.+))?\.$")
_WIDTH = re.compile(r"\((.+) downto 0\)$", re.DOTALL)


@dataclasses.dataclass(frozen=True)
class Declaration:
    """A generic or a port."""

    name: str
    direction: str
    """`in` or `out`; empty for a generic."""
    type: str
    default: str
    """Empty if there is none."""

    @property
    def width(self) -> str:
        """Number of bits of a port, or the name of its type if it is not a vector."""
        found = _WIDTH.search(self.type)
        if found is None:
            return "1" if self.type == "std_logic" else self.type
        high = found[1]
        if high.isdigit():
            return str(int(high) + 1)
        return high.removesuffix(" - 1") if high.endswith(" - 1") else f"{high} + 1"


@dataclasses.dataclass(frozen=True)
class Group:
    """Generics or ports with one comment."""

    comment: str
    declarations: tuple[Declaration, ...]
    difference: str = ""
    """Difference from the comment of another entity."""

    @property
    def range(self) -> str:
        """Range of the generics of the group."""
        if self.declarations[0].type == "boolean":
            return "false, true"
        return self.comment.partition(": ")[0]

    @property
    def clock(self) -> str:
        """The clock of the ports of the group; empty if they belong to no clock, or are a clock."""
        found = _CLOCK.search(self.comment)
        if found is not None:
            return "" if found[1] == "none" else found[1]
        return "" if _CLOCK_NAMES.search(self.declarations[0].name) else "clk"

    @property
    def meaning(self) -> str:
        """Meaning of the group."""
        declared = self.declarations[0]
        if declared.direction:
            return _CLOCK.sub("", self.comment)
        meaning = self.comment if declared.type == "boolean" else self.comment.partition(": ")[2]
        meanings = (meaning, f"{self.difference}." if self.difference else "")
        return " ".join(text[:1].upper() + text[1:] for text in meanings if text)


@dataclasses.dataclass(frozen=True)
class Entity:
    """Interface of an entity."""

    name: str
    generics: tuple[Group, ...]
    ports: tuple[Group, ...]

    @property
    def comments(self) -> dict[str, str]:
        """The comment of each generic and port."""
        groups = (*self.generics, *self.ports)
        return {declared.name: group.comment for group in groups for declared in group.declarations}


def read_entity(text: str, name: str, others: Callable[[str], Entity]) -> Entity:
    """Return an entity of a file of VHDL.

    Args:
        text: of the file.
        name: of the entity.
        others: returns an entity that comments refer to.

    Raises:
        ValueError: if the file has no entity of this name, or a generic or port has no comment.
    """
    for node in nodes(parse(text)):
        if node.type == "entity_declaration" and text_of(node.named_children[0]) == name:
            clauses = {below.type: below for below in nodes(node) if below.type in ("generic_clause", "port_clause")}
            generics, ports = (
                tuple(_joined(_groups(clauses[kind], name), name, others)) if kind in clauses else ()
                for kind in ("generic_clause", "port_clause")
            )
            return Entity(name, generics, ports)
    raise ValueError(f"the file has no entity {name}")


def _joined(groups: Iterator[Group], entity: str, others: Callable[[str], Entity]) -> Iterator[Group]:
    """Yield groups with the comments of the other entities to which their comments refer."""
    for group in groups:
        found = _ELSEWHERE.match(group.comment)
        if found is None:
            yield group
            continue
        comments = others(found[1]).comments
        for declared in group.declarations:
            if declared.name not in comments:
                raise ValueError(f"{declared.name} of {entity} refers to {found[1]}, which has no {declared.name}")
        described = [(comments[declared.name], declared) for declared in group.declarations]
        for comment, alike in itertools.groupby(described, operator.itemgetter(0)):
            yield Group(comment, tuple(declared for _, declared in alike), found[2] or "")


def _groups(clause: Node, entity: str) -> Iterator[Group]:
    comment: list[str] = []
    declared: list[Declaration] = []
    for node in nodes(clause):
        if node.type == "line_comment":
            if declared:
                yield Group(" ".join(comment), tuple(declared))
                comment, declared = [], []
            comment.append(text_of(node).removeprefix("--").strip())
        elif node.type == "interface_declaration":
            declaration = _declaration(node)
            if not comment:
                raise ValueError(f"{declaration.name} of {entity} has no comment that describes it")
            declared.append(declaration)
    if declared:
        yield Group(" ".join(comment), tuple(declared))


def _declaration(node: Node) -> Declaration:
    names, mode = node.named_children
    found = {below.type: text_of(below) for below in mode.named_children}
    return Declaration(
        text_of(names),
        found.get("mode", ""),
        found["subtype_indication"],
        found.get("initialiser", "").removeprefix(":=").strip(),
    )
