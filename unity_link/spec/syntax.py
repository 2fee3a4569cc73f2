"""The syntax tree: the statements and comments of a text, with their places.

The tree is not computed or resolved. `parser` makes it from text, `printer` makes text from it, and the checker makes a
model from it. Trees are equal if their contents are equal, whatever their places. Offsets count characters of the
source.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Self, TypeAlias

INDEX_NAME = "i"
"""Name of the index in the arguments of an array of components, and in the declaration of a row of signals."""


class Word(str):
    """A name with its place."""

    __slots__ = ("end", "start")
    start: int
    end: int

    def __new__(cls, text: str, start: int = 0, end: int = 0) -> Self:
        """Create a name; the place is 0, 0 if it was not read from a text."""
        word = super().__new__(cls, text)
        word.start = start
        word.end = end
        return word

    @property
    def place(self) -> tuple[int, int]:
        """Start and end offset."""
        return self.start, self.end


@dataclass(slots=True, kw_only=True)
class Node:
    """Base of everything that has a place."""

    start: int = field(default=0, compare=False, repr=False)
    end: int = field(default=0, compare=False, repr=False)

    @property
    def place(self) -> tuple[int, int]:
        """Start and end offset."""
        return self.start, self.end


# Expressions


@dataclass(slots=True)
class Number(Node):
    """A number as written: ``0x80``, ``1_000``, ``16.16``."""

    text: str


@dataclass(slots=True)
class Text(Node):
    """A string, with the quotes removed and the escapes resolved."""

    value: str


@dataclass(slots=True)
class Name(Node):
    """A name in an expression."""

    name: Word


@dataclass(slots=True)
class Call(Node):
    """A word with arguments: ``PUBLISH(1, 10)``."""

    name: Word
    arguments: list[Argument]


@dataclass(slots=True)
class Parenthesis(Node):
    """An expression in parentheses; the printer keeps the parentheses."""

    inner: Expression


@dataclass(slots=True)
class Prefixed(Node):
    """An operand with prefix operators: ``-x``, ``~mask``."""

    prefixes: str
    operand: Expression


@dataclass(slots=True)
class Chain(Node):
    """Operands with binary operators between them, in the order of the text."""

    operands: list[Expression]
    operators: list[str]


Expression: TypeAlias = Number | Text | Name | Call | Parenthesis | Prefixed | Chain


@dataclass(slots=True)
class Argument(Node):
    """One argument; `name` is None if it is given by position."""

    name: Word | None
    value: Expression


# Statements


@dataclass(slots=True)
class Comment:
    """A comment as written, including ``//`` or ``/*``."""

    text: str
    blank_before: bool = field(default=False, compare=False)
    """True if an empty line precedes it."""


@dataclass(slots=True, kw_only=True)
class Statement(Node):
    """Base of statements, to which comments are attached."""

    doc: list[str] = field(default_factory=list)
    """Lines of its doc string, without ``///``."""
    leading: list[Comment] = field(default_factory=list)
    """Comments on the lines before the statement, and within it."""
    trailing: list[Comment] = field(default_factory=list)
    """Comments on the line on which the statement ends."""
    blank_before: bool = field(default=False, compare=False)
    """True if an empty line precedes the statement and its comments."""


@dataclass(slots=True, kw_only=True)
class BlockStatement(Statement):
    """A statement that contains other statements."""

    open: int = field(default=0, compare=False, repr=False)
    """Offset of the first character inside the block."""
    dangling: list[Comment] = field(default_factory=list)
    """Comments after the last statement in the block."""


@dataclass(slots=True)
class Import(Statement):
    """``import "file";``."""

    path: Text


@dataclass(slots=True)
class EnumValueDeclaration(Statement):
    """One value of an enumeration; without a number, it is the previous value plus one."""

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
    """One parameter of a component, with its default value if it has one."""

    name: Word
    default: Expression | None = None


@dataclass(slots=True)
class Bits:
    """``[high:low]`` or ``[bit]``."""

    high: Expression
    low: Expression | None = None


@dataclass(slots=True)
class KindSpecifier:
    """The word for a kind and its width: a number or the name of a parameter."""

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
    """A component or a module that is placed in another one: ``name[count]: type(...) @(...);``."""

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
