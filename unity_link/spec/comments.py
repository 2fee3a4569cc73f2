"""Attaches comments to statements.

The grammar ignores comments. This module attaches each comment to the syntax tree, so that `fmt` keeps all of them:

- ``///`` before a statement is its doc string;
- a comment after a statement, on the line on which the statement ends, is its trailing comment;
- any other comment before or inside a statement is its leading comment;
- a comment after the last statement of a block is a dangling comment of the block.
"""

from __future__ import annotations

import re
from itertools import zip_longest
from typing import TYPE_CHECKING

from unity_link.spec.syntax import BlockStatement, Comment, File, Statement
from unity_link.spec.tokens import SPACE, TextPlace, find_comments

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.spec.diagnostics import SourceText

_SPACE_IN_LINE = re.compile(f"[{SPACE.replace(chr(10), '')}]*+")


def attach_comments(file: File, source: SourceText) -> None:
    """Attach all comments of a source to its tree, and record empty lines before statements and comments."""
    _Attacher(source, find_comments(source.text)).fill(file.items, file.dangling, len(source.text))


class _Attacher:
    def __init__(self, source: SourceText, found: list[TextPlace]) -> None:
        self._source = source
        self._found = found
        self._next = 0

    def _take(self, end: int) -> list[TextPlace]:
        """Return the next comments that begin before the offset `end`, and advance past them."""
        first = self._next
        while self._next < len(self._found) and self._found[self._next].start < end:
            self._next += 1
        return self._found[first : self._next]

    def fill(self, statements: Sequence[Statement], dangling: list[Comment], end: int) -> None:
        """Attach the comments of one block, which ends at the offset `end`."""
        for statement, following in zip_longest(statements, statements[1:]):
            before = self._take(statement.start)
            self._lead(statement, before)
            if isinstance(statement, BlockStatement) and statement.open:
                self._lead(statement, self._take(statement.open))
                self.fill(statement.members, statement.dangling, statement.end)  # type: ignore[attr-defined]
            else:
                self._lead(statement, self._take(statement.end))
            self._trail(statement, end if following is None else following.start)
        dangling += [self._comment(found) for found in self._take(end)]

    def _lead(self, statement: Statement, before: list[TextPlace]) -> None:
        first = min([statement.start, *(found.start for found in before)])
        statement.blank_before = statement.blank_before or self._blank_before(first)
        for found in before:
            is_doc = found.text.startswith("///") and not found.text.startswith("////")
            if is_doc:
                statement.doc.append(found.text[3:].removeprefix(" "))
            else:
                statement.leading.append(self._comment(found))

    def _trail(self, statement: Statement, end: int) -> None:
        line = self._source.line_of(max(statement.start, statement.end - 1))
        while self._next < len(self._found) and self._found[self._next].start < end:
            found = self._found[self._next]
            if self._is_alone(found) or self._source.line_of(found.start) != line:
                return
            # If another statement follows on the same line, the comment between them belongs to that statement.
            is_before = _SPACE_IN_LINE.fullmatch(self._source.text, found.end, end) is not None
            if is_before and end < len(self._source.text) and self._same_line(found, end):
                return
            statement.trailing.append(self._comment(found))
            self._next += 1

    def _is_alone(self, found: TextPlace) -> bool:
        """Return whether only white space precedes a comment on its line."""
        text, place = self._source.text, found.start
        # Do not copy the text before the comment: a line may have a hundred thousand comments.
        while place and text[place - 1] != "\n" and text[place - 1] in SPACE:
            place -= 1
        return not place or text[place - 1] == "\n"

    def _same_line(self, found: TextPlace, end: int) -> bool:
        return self._source.line_of(found.end - 1) == self._source.line_of(end) and self._source.text[end] != "}"

    def _comment(self, found: TextPlace) -> Comment:
        return Comment(found.text, self._blank_before(found.start))

    def _blank_before(self, offset: int) -> bool:
        before = self._source.text[:offset] if offset < 1000 else self._source.text[offset - 1000 : offset]
        space = before[len(before.rstrip(SPACE)) :]
        return space.count("\n") > 1
