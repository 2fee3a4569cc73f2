"""The syntax tree: what the author wrote, comments included, and where.

Nothing is computed or resolved here. `parser` makes it of text, `printer` makes text of it, the checker makes a model
of it. Two trees are equal if they say the same, wherever it stands. Offsets count characters of the source.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Self, TypeAlias

INDEX_NAME = "i"
"""Name of the index in the arguments of an array of components, and in the declaration of a row of signals."""


class Word(str):
    """A name, which knows where it stands."""

    __slots__ = ("end", "start")
    start: int
    end: int

    def __new__(cls, text: str, start: int = 0, end: int = 0) -> Self:
        """Make a name; without a place if it was not read from a text."""
        word = super().__new__(cls, text)
        word.start = start
        word.end = end
        return word

    @property
    def place(self) -> tuple[int, int]:
        """Line and column."""
        return self.start, self.end


@dataclass(slots=True, kw_only=True)
class Node:
    """Anything that has a place."""

    start: int = field(default=0, compare=False, repr=False)
    end: int = field(default=0, compare=False, repr=False)

    @property
    def place(self) -> tuple[int, int]:
        """Line and column."""
        return self.start, self.end


# Expressions


@dataclass(slots=True)
class Number(Node):
    """A number as it was written: ``0x80``, ``1_000``, ``16.16``."""

    text: str


@dataclass(slots=True)
class Text(Node):
    """A string, without quotes and escapes."""

    value: str


@dataclass(slots=True)
class Name(Node):
    """A name in an expression."""

    name: Word


@dataclass(slots=True)
class Call(Node):
    """A word with arguments of its own: ``PUBLISH(1, 10)``."""

    name: Word
    arguments: list[Argument]


@dataclass(slots=True)
class Parenthesis(Node):
    """An expression in parentheses, which are kept."""

    inner: Expression


@dataclass(slots=True)
class Prefixed(Node):
    """An operand with signs before it: ``-x``, ``~mask``."""

    prefixes: str
    operand: Expression


@dataclass(slots=True)
class Chain(Node):
    """Operands with operators between them, in the order of the text."""

    operands: list[Expression]
    operators: list[str]


Expression: TypeAlias = Number | Text | Name | Call | Parenthesis | Prefixed | Chain


@dataclass(slots=True)
class Argument(Node):
    """One argument, with a name or by its place."""

    name: Word | None
    value: Expression


# Statements


@dataclass(slots=True)
class Comment:
    """A comment as it was written, with ``//`` or ``/*``."""

    text: str
    blank_before: bool = field(default=False, compare=False)
    """True if an empty line stands before it."""


@dataclass(slots=True, kw_only=True)
class Statement(Node):
    """Statement that a comment can belong to."""

    doc: list[str] = field(default_factory=list)
    """Lines of its doc string, without ``///``."""
    leading: list[Comment] = field(default_factory=list)
    """Comments on the lines before it, and within it."""
    trailing: list[Comment] = field(default_factory=list)
    """Comments on the line that it ends on."""
    blank_before: bool = field(default=False, compare=False)
    """True if an empty line stands before it and its comments."""


@dataclass(slots=True, kw_only=True)
class BlockStatement(Statement):
    """A statement with others inside."""

    open: int = field(default=0, compare=False, repr=False)
    """Offset at which the inside begins."""
    dangling: list[Comment] = field(default_factory=list)
    """Comments after the last statement inside."""


@dataclass(slots=True)
class Import(Statement):
    """``import "file";``."""

    path: Text


@dataclass(slots=True)
class EnumValueDeclaration(Statement):
    """One value of an enumeration; without a number it is one more than the one before."""

    name: Word
    value: Expression | None = None


@dataclass(slots=True)
class EnumDeclaration(BlockStatement):
    """``enum name { ... }``."""

    name: Word
    members: list[EnumValueDeclaration]


@dataclass(slots=True)
class GroupDeclaration(Statement):
    """``group name(...);``."""

    name: Word
    arguments: list[Argument]


@dataclass(slots=True)
class ParameterDeclaration(Node):
    """One parameter of a component, perhaps with the value it has where none is given."""

    name: Word
    default: Expression | None = None


@dataclass(slots=True)
class Bits:
    """``[high:low]`` or ``[bit]``."""

    high: Expression
    low: Expression | None = None


@dataclass(slots=True)
class KindSpecifier:
    """The word for a kind, and its width, which a parameter may have."""

    name: Word
    width: Number | Name | None = None


@dataclass(slots=True)
class SignalDeclaration(Statement):
    """``@name = address[bits]: kind ACCESS(...);``; several in a row: ``@name[count] = address[bits]: ...``."""

    name: Word
    address: Expression | None
    bits: Bits | None
    kind: KindSpecifier | None
    access: Word
    arguments: list[Argument]
    count: Expression | None = None


@dataclass(slots=True)
class Placement(BlockStatement):
    """A component or a module that is put into another one: ``name[count]: type(...) @(...);``."""

    name: Word | None
    count: Expression | None
    type: Word
    arguments: list[Argument]
    addresses: list[Argument] | None
    members: list[SignalDeclaration | Placement] | None = None


Member: TypeAlias = SignalDeclaration | Placement


@dataclass(slots=True)
class ComponentDeclaration(BlockStatement):
    """``public name(...): @(...) { ... }``."""

    public: bool
    name: Word
    parameters: list[ParameterDeclaration]
    addresses: list[ParameterDeclaration] | None
    members: list[Member]


Item: TypeAlias = Import | EnumDeclaration | GroupDeclaration | ComponentDeclaration


@dataclass(slots=True)
class File:
    """One file."""

    items: list[Item]
    dangling: list[Comment] = field(default_factory=list)
