"""Messages to the author of a spec: the place, the fault and advice, formatted like those of a compiler.

Compilation does not stop at the first fault. `Reporter` collects the faults of every stage; the result is a model
or a `SpecError` with all faults in the order of the source. A fault inside a component is reported once, even if the
component is used several times, and a fault that only follows from another one is not reported.
"""

from __future__ import annotations

import bisect
import contextlib
import hashlib
import re
from typing import TYPE_CHECKING, Literal

import msgspec

from unity_link.errors import UnityLinkError
from unity_link.errors import did_you_mean as did_you_mean  # noqa: PLC0414  (exported for messages)

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

Severity = Literal["error", "warning"]
MOST_SHOWN = 100
"""Most diagnostics that are printed; further ones are only counted."""
_MOST_COLUMNS = 160
"""Most columns of a source line that are printed; a longer line is cut around the place."""
_CUT = "..."


class Span(msgspec.Struct, frozen=True):
    """A place in a source. Lines and columns count from 1; `end_column` follows the last character."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int

    def __str__(self) -> str:
        """Return ``file:line:column``, which editors and terminals turn into a link."""
        return f"{self.file}:{self.line}:{self.column}"


NOWHERE = Span("", 0, 0, 0, 0)
"""The place of an object that was not read from a source."""


class Note(msgspec.Struct, frozen=True):
    """A second place that a diagnostic refers to."""

    span: Span
    message: str
    text: str = ""
    """The line of the source at that place."""


class Diagnostic(msgspec.Struct, frozen=True):
    """One error or warning at one place."""

    severity: Severity
    code: str
    """Short name of the rule, stable between versions: ``unknown-name``."""
    message: str
    span: Span
    text: str = ""
    """The line of the source at that place."""
    help: str = ""
    """Advice to the author; empty if the message needs none."""
    notes: tuple[Note, ...] = ()

    def render(self) -> str:
        """Return the message, the source line with the place underlined, and the notes; without a line end."""
        # A fault of a whole file has no line to show.
        is_place = self.span.end_column > self.span.column or self.span.end_line > self.span.line
        where = str(self.span) if is_place else self.span.file
        parts = [f"{where}: {self.severity}: {self.message}"]
        if is_place:
            parts += underlined(self.text, self.span)
        if self.help:
            parts.append(f"  help: {self.help}")
        for note in self.notes:
            parts += [f"{note.span}: note: {note.message}", *underlined(note.text, note.span)]
        return "\n".join(parts)


class SpecError(UnityLinkError):
    """The faults of a spec; `diagnostics` has all of them in the order of the source."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__(self.diagnostics)

    def __str__(self) -> str:
        """Return the first `MOST_SHOWN` diagnostics and the number of all."""
        shown = [diagnostic.render() for diagnostic in self.diagnostics[:MOST_SHOWN]]
        return "\n".join([*shown, summary(self.diagnostics)])


def summary(diagnostics: Iterable[Diagnostic]) -> str:
    """Return the numbers of errors and warnings as a phrase, and how many are shown if that is not all."""
    found = list(diagnostics)
    counts = [
        f"{number} {name}{'s' * (number > 1)}"
        for name in ("error", "warning")
        if (number := sum(diagnostic.severity == name for diagnostic in found))
    ]
    rest = f", the first {MOST_SHOWN} of which are shown" if len(found) > MOST_SHOWN else ""
    return (" and ".join(counts) or "no errors") + rest


def underlined(text: str, span: Span) -> list[str]:
    """Return two lines that show a place: the source line, and carets below the characters of the place."""
    start = min(span.column - 1, len(text))
    end = span.end_column - 1 if span.end_line == span.line else len(text)
    end = max(min(end, len(text)), start + 1)
    cut = max(0, start - _MOST_COLUMNS // 2)
    shown = text[cut : cut + _MOST_COLUMNS]
    shown = f"{_CUT if cut else ''}{shown[len(_CUT) if cut else 0 :]}"
    if cut + _MOST_COLUMNS < len(text):
        shown = f"{shown[: -len(_CUT)]}{_CUT}"
    printable = "".join(
        character if character.isprintable() or character == "\t" else "\N{REPLACEMENT CHARACTER}"
        for character in shown
    )
    indent = "".join("\t" if character == "\t" else " " for character in printable[: start - cut])
    carets = "^" * max(1, min(end - start, _MOST_COLUMNS - (start - cut)))
    number = str(span.line)
    return [f"{number:>5} | {printable}", f"{'':>5} | {indent}{carets}"]


class SourceText:
    """The text of one file of a spec, with conversion of offsets to lines and columns."""

    def __init__(self, name: str, text: str) -> None:
        self.name = name
        self.text = text
        self._starts = [0, *(match.end() for match in re.finditer("\n", text))]
        self._lines: dict[int, str] = {}

    @property
    def sha256(self) -> str:
        """Hash of the text, which generated files record."""
        return hashlib.sha256(self.text.encode("utf-8", "surrogatepass")).hexdigest()

    def line_of(self, offset: int) -> int:
        """Return the number, from 1, of the line that contains the character at an offset."""
        return bisect.bisect_right(self._starts, offset)

    def line(self, number: int) -> str:
        """Return a line without its end. The string is cached: many diagnostics may refer to one very long line."""
        if number not in self._lines:
            end = self._starts[number] - 1 if number < len(self._starts) else len(self.text)
            self._lines[number] = self.text[self._starts[number - 1] : end].rstrip("\r")
        return self._lines[number]

    def span(self, start: int, end: int) -> Span:
        """Return the place of the characters from `start` up to, but without, `end`."""
        line, end_line = self.line_of(start), self.line_of(max(start, end - 1))
        return Span(self.name, line, start - self._starts[line - 1] + 1, end_line, end - self._starts[end_line - 1] + 1)


class Placing:
    """A component while it is placed in an interface.

    Args:
        source: the source of its declaration.
        bounds: start and end offset of its declaration.
        path: its path in the interface.
        given: places of the author's arguments by parameter name. An error in the declaration that mentions such a
            parameter is reported at the argument; any other error is reported in the declaration.
    """

    def __init__(
        self,
        source: SourceText,
        bounds: tuple[int, int],
        path: str,
        given: Mapping[str, tuple[SourceText, tuple[int, int]]],
    ) -> None:
        self._source = source
        self._bounds = bounds
        self._path = path
        self._given = given
        self.reported: list[tuple[str, Span]] = []
        """Errors in the declaration that were reported, also those that were reported at an argument."""
        self.is_refused = False
        """True if an argument was refused: further errors in the declaration follow from that and are dropped."""

    def has(self, source: SourceText, place: tuple[int, int]) -> bool:
        """Return whether a place is in the declaration."""
        return source is self._source and self._bounds[0] <= place[0] and place[1] <= self._bounds[1]

    def at_argument(
        self, source: SourceText, place: tuple[int, int], message: str
    ) -> tuple[SourceText, tuple[int, int], str]:
        """Return source, place and message of an error at the argument it mentions; unchanged if it mentions none."""
        for name in re.findall(r"\w+", source.text[slice(*place)]):
            if name in self._given:
                is_named = re.match(rf"{name}\b", message) is not None
                return *self._given[name], f"{self._path}: {'' if is_named else f'{name}: '}{message}"
        return source, place, message


class Reporter:
    """Collects the diagnostics of one compilation."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, Span], Diagnostic] = {}
        self._placing: Placing | None = None

    @contextlib.contextmanager
    def placing(self, placing: Placing) -> Iterator[None]:
        """Report errors inside a component by the rules of `Placing` while the component is placed."""
        around, self._placing = self._placing, placing
        try:
            yield
        finally:
            self._placing = around

    @property
    def current(self) -> Placing | None:
        """The component that is being placed; None outside of any."""
        return self._placing

    def refuse(self, placing: Placing | None = None) -> None:
        """Retract the errors in a component's declaration and drop further ones: they follow from a refused argument.

        Args:
            placing: the component; None means the one that is being placed.
        """
        placing = placing or self._placing
        if placing is not None:
            placing.is_refused = True
            for key in placing.reported:
                self._found.pop(key, None)

    def error(
        self,
        source: SourceText,
        place: tuple[int, int],
        code: str,
        message: str,
        *,
        help: str = "",  # noqa: A002  (the message prints this word)
        notes: Iterable[tuple[Span, str, str]] = (),
    ) -> None:
        """Report an error at the offsets `place` of a source; each note is a place, a message and a source line."""
        self._report("error", source, place, code, message, help, notes)

    def warning(
        self,
        source: SourceText,
        place: tuple[int, int],
        code: str,
        message: str,
        *,
        help: str = "",  # noqa: A002
    ) -> None:
        """Report a statement that is valid but may not be intended."""
        self._report("warning", source, place, code, message, help, ())

    def _report(
        self,
        severity: Severity,
        source: SourceText,
        place: tuple[int, int],
        code: str,
        message: str,
        help: str,  # noqa: A002
        notes: Iterable[tuple[Span, str, str]],
    ) -> None:
        placing = self._placing
        is_inside = placing is not None and severity == "error" and placing.has(source, place)
        if placing is not None and is_inside:
            if placing.is_refused:
                return
            source, place, message = placing.at_argument(source, place, message)
        span = source.span(*place)
        if (code, span) in self._found:
            return
        if placing is not None and is_inside:
            placing.reported.append((code, span))
        self._found[code, span] = Diagnostic(
            severity, code, message, span, source.line(span.line), help, tuple(Note(*note) for note in notes)
        )

    def spend(self, effort: int) -> None:
        """Count work that a spec causes, in units of about 1 µs. There is no limit here; see `DescriptionReporter`."""

    @property
    def failed(self) -> bool:
        """Return whether an error was reported."""
        return any(diagnostic.severity == "error" for diagnostic in self._found.values())

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """All reported diagnostics, in the order of the sources."""
        files = {span.file: index for index, (_, span) in reversed(list(enumerate(self._found)))}
        return tuple(
            sorted(
                self._found.values(),
                key=lambda found: (files[found.span.file], found.span.line, found.span.column, found.code),
            )
        )


def listed(names: Iterable[str], word: str = "or") -> str:
    """Join one or more names for a sentence: ``a, b or c``."""
    *first, last = names
    return f"{', '.join(first)} {word} {last}" if first else last
