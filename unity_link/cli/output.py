"""Writes the output of commands.

stdout has only the results; under `--json` it has only JSON objects, one a line. stderr has errors and summaries.
Colours and live displays are only for terminals; rich decides that, also by `NO_COLOR`. Control characters in strings
of specs, gateways, recordings and other programs are quoted, so that they cannot control a terminal.
"""

from __future__ import annotations

import contextlib
import functools
import os
import re
import sys
from typing import TYPE_CHECKING, Any, TextIO

from unity_link.quoting import terminal

if TYPE_CHECKING:
    import logging
    from collections.abc import Iterable

    from rich.console import Console
    from rich.segment import Segment

    from unity_link.files import Overwrite

_LATE_CONTROL = re.compile("[\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")
"""Characters that JSON may contain unescaped, but that control some terminals."""


def out() -> Console:
    """Return the console of stdout; in a pipe it does not wrap lines."""
    # Without a file, the console uses the current sys.stdout at each print; a prompt replaces sys.stdout.
    return console_on(None, soft_wrap=not sys.stdout.isatty())


def console_on(stream: TextIO | None, *, soft_wrap: bool = False) -> Console:
    """Return a console for a stream, or for stdout, that quotes the control characters in printed strings."""
    return _console_class()(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=soft_wrap)


@functools.cache
def _console_class() -> type[Console]:
    from rich.console import Console

    class Quoting(Console):
        def render(self, renderable: Any, options: Any = None) -> Iterable[Segment]:
            for segment in super().render(renderable, options):
                yield segment if segment.control else segment._replace(text=terminal(segment.text))

    return Quoting


def _is_shown(record: logging.LogRecord) -> bool:
    """Return whether a log record is shown on stderr: warnings of links, samples and leases are not.

    Commands report lost connections and lost samples themselves.
    """
    return record.levelname != "WARNING" or record.name not in {
        "unity_link.link",
        "unity_link.data",
        "unity_link.cores",
    }


def quote_logs() -> None:
    """Quote the control characters in warnings and errors that are logged on stderr."""
    import logging

    class Quoting(logging.Formatter):
        def format(self, record: logging.LogRecord) -> str:
            return terminal(super().format(record))

    if logging.lastResort is not None:
        logging.lastResort.setFormatter(Quoting())
        logging.lastResort.addFilter(_is_shown)


def is_live() -> bool:
    """Return whether stdout is a terminal that can show a live display."""
    console = out()
    # Check isatty too: rich treats a pipe with forced colours as a terminal. Curves need Braille, and so Unicode.
    return sys.stdout.isatty() and not console.is_dumb_terminal and console.encoding.startswith("utf")


def print_line(text: str) -> None:
    """Print a line on stdout, and flush it for a program that reads the other end of a pipe."""
    sys.stdout.write(terminal(text) + "\n")
    sys.stdout.flush()


def print_json(value: Any) -> None:
    """Print a value as one line of JSON on stdout, and flush it."""
    import msgspec

    try:
        text = msgspec.json.encode(value)
    except UnicodeEncodeError:
        text = msgspec.json.encode(_in_utf_8(msgspec.to_builtins(value)))
    print_line(_LATE_CONTROL.sub(lambda found: f"\\u{ord(found[0]):04x}", text.decode()))


def _in_utf_8(value: Any) -> Any:
    """Return a value with all strings encodable as UTF-8; other bytes of file names become backslash escapes."""
    if isinstance(value, str):
        return value.encode(errors="backslashreplace").decode()
    if isinstance(value, dict):
        return {_in_utf_8(name): _in_utf_8(item) for name, item in value.items()}
    return [_in_utf_8(item) for item in value] if isinstance(value, list | tuple) else value


def print_result(name: str, value: object, *, json: bool) -> None:
    """Print a result: only its text, or under `--json` an object with it as the only field."""
    if json:
        print_json({name: str(value)})
    else:
        print_line(str(value))


def print_note(text: str) -> None:
    """Print a note on stderr."""
    # A stderr that cannot be written, such as a pipe without a reader, must not end the command.
    with contextlib.suppress(OSError):
        print(terminal(text), file=sys.stderr, flush=True)  # noqa: T201  (a command prints)


def print_error(text: str, hint: str = "") -> None:
    """Print an error on stderr, and a hint on a second line."""
    # Without stderr, the exit code is the only report.
    with contextlib.suppress(OSError):
        print_parts(("error: ", "bold red"), text, on=sys.stderr)
        if hint:
            print_parts((hint, "dim"), on=sys.stderr)


def print_parts(*parts: str | tuple[str, str], on: TextIO | None = None) -> None:
    """Print a line of parts, some of them styled. rich is imported only if styles can be visible.

    Args:
        parts: texts, or pairs of a text and its style.
        on: stdout or stderr; None for stdout.
    """
    stream = sys.stdout if on is None else on
    if not (stream.isatty() or any(name in os.environ for name in _COLOURING)):
        stream.write(terminal("".join(part if isinstance(part, str) else part[0] for part in parts)) + "\n")
        stream.flush()
        return
    from rich.text import Text

    _console(stream).print(Text.assemble(*parts))


@functools.lru_cache(maxsize=2)
def _console(stream: TextIO) -> Console:
    return console_on(stream, soft_wrap=stream is sys.stderr or not stream.isatty())


def is_confirmed(question: str) -> bool:
    """Ask a yes-or-no question on stderr; return False if there is no answer."""
    import typer

    try:
        return typer.confirm(question, err=True)
    except typer.Abort:
        return False


def may_overwrite(overwrite: bool) -> Overwrite:
    """Return which existing files may be replaced: all, none, or on a terminal those that the user confirms."""
    if overwrite or not (sys.stdin.isatty() and sys.stderr.isatty()):
        return overwrite
    from unity_link.files import in_the_way

    return lambda paths: is_confirmed(f"{in_the_way(paths)}. Replace?")


_COLOURING = ("FORCE_COLOR", "TTY_COMPATIBLE")
"""Environment variables that make rich colour output to a pipe."""
