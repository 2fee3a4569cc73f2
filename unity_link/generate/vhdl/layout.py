"""Aligns the columns of VHDL, so that templates need no padding.

In consecutive lines of the same depth, ``:``, ``:=``, ``=>`` and ``<=`` are each aligned, as vsg requires and as in the
sources of the gateware; calls between them are ignored. A blank line, a comment or a line of another depth ends a
block. Comments are wrapped at the length of a line.
"""

from __future__ import annotations

import re
import textwrap
from itertools import groupby
from typing import NamedTuple

from unity_link.quoting import hdl_comment

LINE = 120
_DECLARATION = re.compile(
    r"(?P<head> *(?:(?:constant|signal|variable) )?\w+) *:(?!=) *(?P<type>[^:]*?)(?: *:= *(?P<value>.*))?$"
)
_PORT_MODE = re.compile(r"(in|out|inout) +(?=\S)")
_PAIR = re.compile(r"(?P<head> *[\w.()]+(?: downto [\w]+\))?) *(?P<sign><=|=>|:=) *(?P<rest>.*)$")
_CALL = re.compile(r" *\w+(\(.*\))?;$")
_NO_COLUMNS = ("when ", "if ", "elsif ", "type ", "subtype ", "function ", "report ", "assert ", "end ", "null;", "--")
_NO_TYPES = ("process", "entity", "if", "for")


class _Line(NamedTuple):
    text: str
    depth: int
    sign: str
    """Kind of the line for alignment: the sign itself, ":" for a declaration, "()" for a call, or empty."""


def align(text: str) -> str:
    """Return a file with aligned columns, wrapped comments, and no trailing blanks."""
    lines = [_classify(line.rstrip()) for line in _filled(text.splitlines())]
    aligned: list[str] = []
    start = 0
    while start < len(lines):
        end = start + 1
        while end < len(lines) and _goes_on(lines[start], lines[end]):
            end += 1
        aligned += _aligned(lines[start:end])
        start = end
    return re.sub(r"\n{3,}", "\n\n", "\n".join(aligned)) + "\n"


def _filled(lines: list[str]) -> list[str]:
    """Wrap paragraphs of comments: always at the top of the file, elsewhere only if a line is too long."""
    filled: list[str] = []
    at_top = True
    for is_prose, some in groupby(lines, key=lambda line: re.match(r" *-- \S", line) is not None):
        paragraph = list(some)
        at_top = at_top and all(line.startswith("--") for line in paragraph)
        if is_prose and (at_top or max(map(len, paragraph)) > LINE):
            prefix = paragraph[0][: paragraph[0].index("--")] + "-- "
            words = " ".join(line.strip().removeprefix("-- ") for line in paragraph)
            # Quote each new line: tools obey some words at the beginning of a comment, but not within it.
            paragraph = [prefix + hdl_comment(line) for line in textwrap.wrap(words, LINE - len(prefix))]
        filled += paragraph
    return filled


def _classify(line: str) -> _Line:
    code = line.lstrip()
    depth = len(line) - len(code)
    if not code or code.startswith(_NO_COLUMNS):
        return _Line(line, depth, "")
    pair = _PAIR.match(line)
    if pair is not None:
        return _Line(line, depth, pair["sign"])
    declaration = _DECLARATION.match(line)
    if declaration is not None and not declaration["type"].startswith(_NO_TYPES):
        return _Line(line, depth, ":")
    return _Line(line, depth, "()" if _CALL.match(line) else "")


def _goes_on(first: _Line, line: _Line) -> bool:
    return first.sign not in {"", "()"} and line.depth == first.depth and line.sign in {first.sign, "()"}


def _aligned(block: list[_Line]) -> list[str]:
    sign = block[0].sign
    if sign == ":":
        return _align_declarations([line.text for line in block])
    if sign in {"", "()"}:
        return [line.text for line in block]
    matches = [_PAIR.match(line.text) if line.sign == sign else None for line in block]
    width = max(len(match["head"]) for match in matches if match is not None)
    return [
        line.text if match is None else f"{match['head']:{width}} {sign} {match['rest']}"
        for line, match in zip(block, matches, strict=True)
    ]


def _align_declarations(lines: list[str]) -> list[str]:
    matches = [match for line in lines if (match := _DECLARATION.match(line)) is not None]
    types = [_PORT_MODE.sub(lambda mode: f"{mode[1]:6}", match["type"], count=1) for match in matches]
    width = max(len(match["head"]) for match in matches)
    longest = max(len(one.rstrip(";")) for one in types)
    aligned = []
    for match, one in zip(matches, types, strict=True):
        value = f" := {match['value']}" if match["value"] is not None else ""
        aligned.append(f"{match['head']:{width}} : " + (f"{one:{longest}}{value}" if value else one))
    return aligned
