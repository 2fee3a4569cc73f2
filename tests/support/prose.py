"""Extracts prose from files: docstrings, comments, the texts of raised errors, and Markdown outside of code blocks.

`LANGUAGES` maps the suffix of a file to the pattern of its strings and comments. Strings are matched too, so
that a comment mark inside a string does not start a comment. In templates the suffix before ``.jinja`` decides.
"""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


class Piece(NamedTuple):
    """A paragraph, list item or table cell of prose, on one line, with single spaces between its words."""

    line: int
    """Line of the file in which the docstring, comment or page begins."""
    text: str
    is_summary: bool = False
    """True for the first paragraph of a docstring."""


_DOUBLE, _SINGLE, _BACKTICK = (rf"{mark}(?:\\[\s\S]|[^{mark}\\\n])*{mark}" for mark in "\"'`")
_TRIPLE = r'"""(?:\\[\s\S]|[^\\])*?"""|' + r"'''(?:\\[\s\S]|[^\\])*?'''"
_BLOCK_COMMENT = r"(?P<block>/\*[\s\S]*?\*/)"


def _comment(mark: str) -> str:
    """Return the pattern of a comment that begins with a mark, with the comments on the lines that follow directly."""
    return rf"(?P<prose>{mark}[^\n]*(?:\n[ \t]*{mark}[^\n]*)*)"


def _language(*alternatives: str) -> re.Pattern[str]:
    return re.compile("|".join(alternatives))


_C = _language(_DOUBLE, _SINGLE, _comment("//"), _BLOCK_COMMENT)
_PYTHON = _language(_TRIPLE, _DOUBLE, _SINGLE, _comment("#"))
_VERILOG = _language(_DOUBLE, _comment("//"), _BLOCK_COMMENT)
# In shell and make, `#` begins a comment only at the beginning of a word.
_SHELL = _language(_DOUBLE, _SINGLE, _comment(r"(?<!\S)#"))
_TCL = _language(_DOUBLE, _comment("#"))
_MARKDOWN = re.compile(r"^[ >]*(```|~~~).*?^[ >]*\1[^\n]*$|<!--.*?-->", re.MULTILINE | re.DOTALL)
# A template cannot be parsed as Python; its docstrings are the strings in triple quotes at the beginning of a line.
_PYTHON_TEMPLATE = _language(
    rf"(?m:^)[ \t]*(?P<docstring>{_TRIPLE})",
    rf"\braise [\w.]+\((?P<error>(?:\s*f?(?:{_DOUBLE}))+)",
    _PYTHON.pattern,
)
LANGUAGES = {
    ".c": _C,
    ".cc": _C,
    ".h": _C,
    ".hpp": _C,
    ".js": _language(_DOUBLE, _SINGLE, _BACKTICK, _comment("//"), _BLOCK_COMMENT),
    ".lark": _language(_DOUBLE, _comment(r"(?<!\S)//")),
    ".m": _language(_DOUBLE, r"(?<![\w)\]}.'])'[^'\n]*'", _comment("%")),
    ".md": _MARKDOWN,
    ".mk": _SHELL,
    ".py": _PYTHON,
    ".sdc": _TCL,
    ".sh": _SHELL,
    ".sv": _VERILOG,
    ".tcl": _TCL,
    ".toml": _PYTHON,
    ".ul": _VERILOG,
    ".v": _VERILOG,
    ".vhd": _language(_DOUBLE, r"'.'", _comment("--")),
    ".xdc": _TCL,
    ".yaml": _SHELL,
}
_OF_NAMES = {
    "Makefile": _SHELL,
    ".ci/run": _SHELL,
    "generate/matlab/header.jinja": _language(_comment("%")),
    "generate/python/module.jinja": _PYTHON_TEMPLATE,
}
_JINJA_COMMENT = re.compile(r"\{#(?P<prose>.*?)#\}", re.DOTALL)
_JINJA = re.compile(r"\{#.*?#\}|\{%.*?%\}|\{\{.*?\}\}", re.DOTALL)
# Comment marks at the beginnings of lines, rulers, and the ends of block comments.
_MARKS = re.compile(r"^[ \t]*(?:--+|//[/!]?|/\*+|\*+/?|#+:?|%+)[ \t]*|[ \t]*\*/", re.MULTILINE)
_QUOTES = re.compile(r"^\s*[frbFRB]*(?:\"\"\"|''')|(?:\"\"\"|''')$")
_PARTS = re.compile(r"\n[ \t]*\n|\n(?=[ \t]*(?:[-*+]|\d+\.)[ \t])|\|")
_BULLET = re.compile(r"^\s*(?:[-*+#]+|\d+\.)\s+")


def pieces_of(path: Path) -> Iterator[Piece]:
    """Yield the prose of a file; none for a kind of file that is not in `LANGUAGES`."""
    language = _language_of(path)
    if language is None:
        return
    text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix == ".jinja":
        yield from _matches(_JINJA_COMMENT, text)
        text = _JINJA.sub(lambda match: "\n" * match[0].count("\n") or "x", text)
    if language is _MARKDOWN:
        text = _MARKDOWN.sub(lambda match: "\n" * match[0].count("\n"), text)
        yield from _parts(1, text)
        return
    yield from _matches(language, text)
    if path.suffix == ".py":
        yield from _of_tree(ast.parse(text).body)


def _language_of(path: Path) -> re.Pattern[str] | None:
    for name, language in _OF_NAMES.items():
        if path.match(name):
            return language
    source = path.with_suffix("") if path.suffix == ".jinja" else path
    found = LANGUAGES.get(source.suffix)
    return _PYTHON_TEMPLATE if found is _PYTHON and source is not path and source.suffix == ".py" else found


def _matches(language: re.Pattern[str], text: str) -> Iterator[Piece]:
    """Yield the comments, docstrings and error texts that a pattern finds."""
    line, end = 1, 0
    for match in language.finditer(text):
        line, end = line + text.count("\n", end, match.start()), match.start()
        kind = match.lastgroup
        if kind in {"prose", "block"}:
            yield from _parts(line, _MARKS.sub("", match[kind]))
        elif kind == "docstring":
            yield from _parts(line, _QUOTES.sub("", match[kind]), is_docstring=True)
        elif kind == "error":
            yield from _parts(line, "".join(part[1:-1] for part in re.findall(_DOUBLE, match[kind])))


def _of_tree(body: list[ast.stmt]) -> Iterator[Piece]:
    """Yield docstrings, those of attributes and constants too, and the texts of raised errors."""
    for node in body:
        match node:
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield from _parts(node.lineno, text, is_docstring=True)
            case ast.Raise(exc=ast.expr() as error):
                for text in _texts(error):
                    yield from _parts(node.lineno, text)
        for field in ("body", "orelse", "finalbody", "handlers", "cases"):
            yield from _of_tree(getattr(node, field, []))


def _texts(node: ast.AST) -> Iterator[str]:
    """Yield the strings of an expression; an f-string is one string with ``x`` for each value."""
    match node:
        case ast.Constant(value=str(text)):
            yield text
        case ast.JoinedStr(values=values):
            yield "".join(str(part.value) if isinstance(part, ast.Constant) else "x" for part in values)
        case _:
            for child in ast.iter_child_nodes(node):
                yield from _texts(child)


def _parts(line: int, text: str, *, is_docstring: bool = False) -> Iterator[Piece]:
    """Yield the paragraphs, list items and table cells of a text."""
    for number, part in enumerate(_PARTS.split(text)):
        if words := " ".join(_BULLET.sub("", part).split()):
            yield Piece(line, words, is_docstring and number == 0)
