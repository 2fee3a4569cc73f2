"""Perl in a SystemRDL file: where it stands, before its compiler runs it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.spec.diagnostics import Span

if TYPE_CHECKING:
    from pathlib import Path


def first_perl(environment: Any, path: Path, include: list[str]) -> tuple[Span, str] | None:
    """Return the place and the line of the first piece of Perl in a file and what it includes; None without any.

    Args:
        environment: of the compiler.
        path: the file.
        include: folders in which files that it includes are looked for.

    Raises:
        RDLCompileError: where a file that is included cannot be found, or includes itself.
        OSError: where a file cannot be read.
    """
    from systemrdl.preprocessor.perl_preprocessor import PerlPreprocessor, PPPUnalteredSegment

    file = PerlPreprocessor(environment, str(path), include)
    # The compiler's own search: it knows comments, and follows what is included.
    segments, has_perl = file.get_perl_segments(file.tokenize())
    if not has_perl:
        return None
    tag = next(segment for segment in segments if not isinstance(segment, PPPUnalteredSegment))
    text = tag.file_pp.text
    begin, line = text.rfind("\n", 0, tag.start) + 1, text.count("\n", 0, tag.start) + 1
    column = tag.start - begin + 1
    return Span(str(tag.file_pp.path), line, column, line, column + 2), text[begin:].partition("\n")[0].rstrip()
