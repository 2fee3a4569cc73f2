"""Highlights UL-spec in the pages: the tokens of `unity_link.spec` as tokens of Pygments."""

from typing import ClassVar

from pygments.lexer import RegexLexer, bygroups, words
from pygments.token import (
    Comment,
    Keyword,
    Name,
    Number,
    Operator,
    Punctuation,
    String,
    Text,
)

KINDS = ("bool", "unsigned", "signed", "float", "fixed", "ufixed")
_NAME = r"[A-Za-z_][A-Za-z0-9_]*"


class UlLexer(RegexLexer):  # type: ignore[misc]  # Pygments has no types
    """UL-spec; text that begins no token of the language is an `Error`."""

    name = "UL-spec"
    aliases: ClassVar[list[str]] = ["ul"]
    filenames: ClassVar[list[str]] = ["*.ul"]

    tokens: ClassVar = {
        "root": [
            (r"[ \t\r\n\f\ufeff]+", Text),
            (r"///[^\n]*", String.Doc),
            (r"//[^\n]*", Comment.Single),
            (r"/\*(?s:.*?)\*/", Comment.Multiline),
            (words(("import", "public"), suffix=r"\b"), Keyword),
            (rf"(enum|group)([ \t]+)({_NAME})", bygroups(Keyword, Text, Name.Class)),
            (words(KINDS, suffix=r"\b"), Keyword.Type),
            # A component's declaration or placement, and its name there.
            (rf"(@)([ \t]*)({_NAME})", bygroups(Punctuation, Text, Name.Variable)),
            (rf"({_NAME})([ \t]*)(=)(?!=)", bygroups(Name.Attribute, Text, Operator)),
            (r"[A-Z][A-Z0-9_]*\b", Keyword.Reserved),
            (rf"{_NAME}(?=[ \t]*\()", Name.Function),
            (_NAME, Name),
            (r"0[xX][0-9A-Fa-f_]+\b", Number.Hex),
            (r"0[bB][01_]+\b", Number.Bin),
            (r"[0-9][0-9_]*\.[0-9][0-9_]*(?:[eE][+-]?[0-9]+)?\b|[0-9][0-9_]*[eE][+-]?[0-9]+\b", Number.Float),
            (r"[0-9][0-9_]*\b", Number.Integer),
            (r'"(?:\\[^\n]|[^"\\\n])*"', String),
            (r"<<|>>|[+*/%&|^~=-]", Operator),
            (r"[;{}()\[\],:@]", Punctuation),
        ]
    }
