"""Finds Perl in a SystemRDL file, before the SystemRDL compiler executes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.diagnostics import Span

if TYPE_CHECKING:
    from pathlib import Path

    from systemrdl.compiler import RDLEnvironment


def first_perl(environment: RDLEnvironment, path: Path, include: list[str]) -> tuple[Span, str] | None:
    """Return place and source line of the first Perl in a file or its includes; None if there is no Perl.

    Args:
        environment: environment of the SystemRDL compiler.
        path: the file.
        include: folders that are searched for included files.

    Raises:
        RDLCompileError: if an included file cannot be found, or includes itself.
        OSError: if a file cannot be read.
    """
    from systemrdl.preprocessor.perl_preprocessor import PerlPreprocessor, PPPUnalteredSegment

    file = PerlPreprocessor(environment, str(path), include)
    # The compiler's own scanner recognizes comments and follows includes.
    segments, has_perl = file.get_perl_segments(file.tokenize())
    if not has_perl:
        return None
    tag = next(segment for segment in segments if not isinstance(segment, PPPUnalteredSegment))
    text = tag.file_pp.text
    begin, line = text.rfind("\n", 0, tag.start) + 1, text.count("\n", 0, tag.start) + 1
    column = tag.start - begin + 1
    return Span(str(tag.file_pp.path), line, column, line, column + 2), text[begin:].partition("\n")[0].rstrip()
