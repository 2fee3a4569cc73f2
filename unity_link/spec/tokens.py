"""The tokens of a text: the groups of one regular expression are the terminals of `grammar.lark`.

lark uses `TokenLexer` as its lexer. Invalid text becomes a token of type `BAD_STRING`, `BAD_COMMENT` or `BAD`, which no
rule of the grammar accepts, so that the parser reports it at its place like any other syntax error.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from lark import Token
from lark.lexer import Lexer

if TYPE_CHECKING:
    from collections.abc import Iterator

KEYWORDS = {word: word.upper() for word in ("import", "enum", "group", "public")}
SIGNS = {
    ";": "SEMICOLON",
    "{": "LBRACE",
    "}": "RBRACE",
    "(": "LPAR",
    ")": "RPAR",
    "[": "LSQB",
    "]": "RSQB",
    ",": "COMMA",
    ":": "COLON",
    "=": "EQUAL",
    "@": "AT",
    "-": "MINUS",
    "~": "TILDE",
}
SPACE = " \t\r\n\f\ufeff"
# A possessive `*+` in STRING uses no memory per character.
# Text that begins like a number is one token, so that the message for 0x1G or 12bit shows all of it.
_TOKEN = re.compile(
    r"""
    (?P<SPACE>[ \t\r\n\f\ufeff]+)
    |(?P<COMMENT>//[^\n]*|/\*.*?\*/)
    |(?P<NAME>[A-Za-z_][A-Za-z0-9_]*)
    |(?P<SIGN>[;{}()\[\],:=@~-])
    |(?P<NUMBER>0[xXbB][0-9A-Za-z_]*|[0-9][0-9_]*(?:\.[0-9][0-9_]*)?(?:[eE][+-]?[0-9]+)?[0-9A-Za-z_]*)
    |(?P<STRING>"(?:\\[^\n]|[^"\\\n])*+")
    |(?P<BAD_COMMENT>/\*)
    |(?P<OPERATOR><<|>>|[+*/%&|^])
    |(?P<BAD_STRING>"[^\n]*)
    |(?P<BAD>.)
    """,
    re.VERBOSE | re.DOTALL,
)


_COMMENT = re.compile(r'"(?:\\[^\n]|[^"\\\n])*+"|//[^\n]*|/\*.*?\*/', re.DOTALL)


class TextPlace(NamedTuple):
    """A comment and its offsets."""

    text: str
    start: int
    end: int


def find_comments(text: str) -> list[TextPlace]:
    """Return the comments of a text that was parsed without faults."""
    return [TextPlace(match[0].rstrip(), *match.span()) for match in _COMMENT.finditer(text) if match[0][0] == "/"]


class TokenLexer(Lexer):
    """The lexer with the interface that lark expects."""

    def __init__(self, lexer_conf: object) -> None:
        """Accept lark's configuration, which this lexer does not use."""

    def lex(self, text: str) -> Iterator[Token]:  # type: ignore[override]  # lark's own lexers receive a state instead
        """Yield the tokens of a text."""
        return tokenize(text)


def tokenize(text: str) -> Iterator[Token]:
    """Yield the tokens of a text, without white space and comments."""
    keyword, sign = KEYWORDS.get, SIGNS
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup
        if kind in {"SPACE", "COMMENT"}:
            continue
        found, (start, end) = match[0], match.span()
        if kind == "SIGN":
            kind = sign[found]
        elif kind == "NAME":
            kind = keyword(found, kind)
        assert kind is not None
        yield Token(kind, found, start, None, None, None, None, end)
