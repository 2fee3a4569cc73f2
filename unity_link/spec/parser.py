"""The parser: text to syntax tree.

lark parses a text at once. If it finds a fault, `recovery` parses the text again, token by token, to find the other
faults too. No exception of lark leaves this module.
"""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from lark import Lark, Token, Transformer, v_args
from lark.exceptions import UnexpectedInput

from unity_link.spec.comments import attach_comments
from unity_link.spec.recovery import report_faults
from unity_link.spec.syntax import (
    Argument,
    Bits,
    Call,
    Chain,
    ComponentDeclaration,
    EnumDeclaration,
    EnumValueDeclaration,
    Expression,
    File,
    GroupDeclaration,
    Import,
    Item,
    KindSpecifier,
    Member,
    Name,
    Number,
    ParameterDeclaration,
    Parenthesis,
    Placement,
    Prefixed,
    SignalDeclaration,
    Text,
    Word,
)
from unity_link.spec.tokens import TokenLexer

if TYPE_CHECKING:
    from unity_link.spec.diagnostics import Reporter, SourceText

ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}
MOST_NESTED = 40
"""Most brackets inside each other. No robot needs more, and each level is a level of recursion in later stages."""
MOST_CHARACTERS = 16 << 20
# Tab and line ends are white space. The other control characters have no use in a comment, and terminals obey them.
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f-\x84\x86-\x9f]")
_BRACKETS = re.compile(r'"(?:\\[^\n]|[^"\\\n])*+"|//[^\n]*|/\*.*?\*/|[(\[{}\])]', re.DOTALL)


def parse(source: SourceText, reporter: Reporter) -> File | None:
    """Parse a source; return None if it has faults, which are reported."""
    if not _is_sane(source, reporter):
        return None
    try:
        items = cast("list[Item]", _parser(builds=True).parse(source.text))
    except UnexpectedInput:
        report_faults(_parser(builds=False), source, reporter)
        return None
    file = File(items)
    attach_comments(file, source)
    return file


def _is_sane(source: SourceText, reporter: Reporter) -> bool:
    """Return whether a text is neither too long nor nested too deeply; report it otherwise."""
    if len(source.text) > MOST_CHARACTERS:
        message = f"a spec of {len(source.text):,} characters is too long: {MOST_CHARACTERS:,} are the most"
        reporter.error(source, (0, 1), "too-long", message)
        return False
    control = _CONTROL.search(source.text)
    if control is not None:
        message = f"the control character U+{ord(control[0]):04X} is not allowed"
        reporter.error(source, control.span(), "control-character", message, help="leave it out")
        return False
    depth = 0
    for match in _BRACKETS.finditer(source.text):
        if match[0] in "([{":
            depth += 1
        elif match[0] in ")]}":
            depth -= 1
        if depth > MOST_NESTED:
            message = f"brackets are nested more than {MOST_NESTED} deep here"
            reporter.error(source, match.span(), "too-deep", message, help="close some, or name a part of it")
            return False
    return True


@functools.cache
def _parser(*, builds: bool) -> Lark:
    """Return the parser; with `builds` False it makes no tree, so that `recovery` can feed it incomplete text."""
    grammar = Path(__file__).with_name("grammar.lark").read_text(encoding="utf-8")
    return Lark(
        grammar, parser="lalr", lexer=TokenLexer, transformer=_Builder() if builds else None, maybe_placeholders=True
    )


def word(token: Token) -> Word:
    """Return the name in a token, with its place."""
    return Word(token, token.start_pos or 0, token.end_pos or 0)


def _unescaped(token: Token) -> str:
    inside = token[1:-1]
    if "\\" not in inside:
        return inside
    return re.sub(r"\\(.)", lambda match: ESCAPES.get(match[1], match[0]), inside)


def _bounds(first: Any, last: Any) -> dict[str, Any]:
    """Return the offsets from the start of one token or node to the end of another."""
    start = first.start_pos if isinstance(first, Token) else first.start
    end = last.end_pos if isinstance(last, Token) else last.end
    return {"start": start, "end": end}


@v_args(inline=True)
class _Builder(Transformer[Token, Any]):
    """Makes the node of each rule; the methods have the names of the rules of the grammar."""

    def start(self, *items: Item) -> list[Item]:
        return list(items)

    def number(self, token: Token) -> Number:
        return Number(str(token), start=token.start_pos or 0, end=token.end_pos or 0)

    def string(self, token: Token) -> Text:
        return Text(_unescaped(token), start=token.start_pos or 0, end=token.end_pos or 0)

    def name(self, token: Token) -> Name:
        return Name(word(token), start=token.start_pos or 0, end=token.end_pos or 0)

    def call(self, name: Token, arguments: list[Argument], close: Token) -> Call:
        return Call(word(name), arguments, **_bounds(name, close))

    def parenthesis(self, opening: Token, inner: Expression, close: Token) -> Parenthesis:
        return Parenthesis(inner, **_bounds(opening, close))

    def prefixed(self, *parts: Any) -> Prefixed:
        *prefixes, operand = parts
        return Prefixed("".join(prefixes), operand, **_bounds(prefixes[0], operand))

    def expression(self, first: Expression, *rest: Any) -> Expression:
        if not rest:
            return first
        operators = [str(operator) for operator in rest[::2]]
        return Chain([first, *rest[1::2]], operators, **_bounds(first, rest[-1]))

    def argument(self, value: Expression) -> Argument:
        return Argument(None, value, start=value.start, end=value.end)

    def named_argument(self, name: Token, value: Expression) -> Argument:
        return Argument(word(name), value, **_bounds(name, value))

    def arguments(self, *arguments: Argument) -> list[Argument]:
        return list(arguments)

    def parameter(self, name: Token, default: Expression | None) -> ParameterDeclaration:
        return ParameterDeclaration(word(name), default, **_bounds(name, default or name))

    def parameters(self, *parameters: ParameterDeclaration) -> list[ParameterDeclaration]:
        return list(parameters)

    def bits(self, high: Expression, low: Expression | None) -> Bits:
        return Bits(high, low)

    def head(self, *tokens: Token) -> tuple[KindSpecifier | None, Token]:
        *kind, access = tokens
        if not kind:
            return None, access
        width = [self.number(token) if token.type == "NUMBER" else self.name(token) for token in kind[1:]]
        return KindSpecifier(word(kind[0]), *width), access

    def label(self, name: Token, count: Expression | None) -> tuple[Token, Expression | None]:
        return name, count

    def signal(
        self,
        at: Token,
        name: Token,
        count: Expression | None,
        address: Expression | None,
        bits: Bits | None,
        head: tuple[KindSpecifier | None, Token],
        arguments: list[Argument],
        end: Token,
    ) -> SignalDeclaration:
        kind, access = head
        return SignalDeclaration(word(name), address, bits, kind, word(access), arguments, count, **_bounds(at, end))

    def placement(
        self,
        label: tuple[Token, Expression | None] | None,
        type_: Token,
        arguments: list[Argument],
        addresses: list[Argument] | None,
        end: Token,
    ) -> Placement:
        name, count = label or (None, None)
        bounds = _bounds(type_ if name is None else name, end)
        return Placement(None if name is None else word(name), count, word(type_), arguments, addresses, **bounds)

    def block(
        self,
        label: tuple[Token, Expression | None] | None,
        type_: Token,
        arguments: list[Argument],
        addresses: list[Argument] | None,
        opening: Token,
        *members: Any,
    ) -> Placement:
        *inside, close = members
        placement = self.placement(label, type_, arguments, addresses, close)
        placement.open = opening.end_pos or 0
        placement.members = inside
        return placement

    def component(
        self,
        public: Token | None,
        name: Token,
        parameters: list[ParameterDeclaration],
        addresses: list[ParameterDeclaration] | None,
        opening: Token,
        *members: Any,
    ) -> ComponentDeclaration:
        inside: list[Member]
        *inside, close = members
        bounds = _bounds(name if public is None else public, close)
        return ComponentDeclaration(
            public is not None, word(name), parameters, addresses, inside, open=opening.end_pos or 0, **bounds
        )

    def import_(self, keyword: Token, path: Token, end: Token) -> Import:
        return Import(self.string(path), **_bounds(keyword, end))

    def enum_value(self, name: Token, value: Expression | None) -> EnumValueDeclaration:
        return EnumValueDeclaration(word(name), value, **_bounds(name, value or name))

    def enum(self, keyword: Token, name: Token, opening: Token, *values: Any) -> EnumDeclaration:
        *inside, close = values
        return EnumDeclaration(word(name), inside, open=opening.end_pos or 0, **_bounds(keyword, close))

    def group(self, keyword: Token, name: Token, arguments: list[Argument] | None, end: Token) -> GroupDeclaration:
        return GroupDeclaration(word(name), arguments or [], **_bounds(keyword, end))
