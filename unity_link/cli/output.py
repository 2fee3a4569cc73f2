"""The output of commands.

stdout has what was asked for, and under `--json` nothing but one JSON object a line. stderr has errors and summaries.
Colours and moving pictures are for terminals alone; rich sees to that, and to `NO_COLOR`. Strings of specs, gateways,
recordings and other machines are printed so that no terminal obeys them.
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
"""Characters that JSON may have as they are, and some terminals obey."""


def out() -> Console:
    """Return the console of stdout; a pipe gets whole lines, however long."""
    # It looks for stdout at each print: a prompt puts another one in its place.
    return console_on(None, soft_wrap=not sys.stdout.isatty())


def console_on(stream: TextIO | None, *, soft_wrap: bool = False) -> Console:
    """Return a console that prints strings from outside as a terminal shows and does not obey them; None for stdout."""
    return _console_class()(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=soft_wrap)


@functools.cache
def _console_class() -> type[Console]:
    from rich.console import Console

    class Quoting(Console):
        def render(self, renderable: Any, options: Any = None) -> Iterable[Segment]:
            for segment in super().render(renderable, options):
                yield segment if segment.control else segment._replace(text=terminal(segment.text))

    return Quoting


def _is_no_report_of_a_command(record: logging.LogRecord) -> bool:
    """Return whether a record is shown on stderr: warnings of links, samples and leases are not.

    Commands report lost connections and samples by themselves.
    """
    return record.levelname != "WARNING" or record.name not in {
        "unity_link.link",
        "unity_link.data",
        "unity_link.cores",
    }


def quote_logs() -> None:
    """Make the warnings and errors that are logged on stderr such that a terminal shows and does not obey them."""
    import logging

    class Quoting(logging.Formatter):
        def format(self, record: logging.LogRecord) -> str:
            return terminal(super().format(record))

    if logging.lastResort is not None:
        logging.lastResort.setFormatter(Quoting())
        logging.lastResort.addFilter(_is_no_report_of_a_command)


def is_live() -> bool:
    """Return whether stdout is a terminal that can show a moving picture."""
    console = out()
    # Colours that are forced on a pipe still want lines in it; and without Unicode there are no dots to draw with.
    return sys.stdout.isatty() and not console.is_dumb_terminal and console.encoding.startswith("utf")


def print_line(text: str) -> None:
    """Print a line on stdout at once, so that a program that reads it does not wait."""
    sys.stdout.write(terminal(text) + "\n")
    sys.stdout.flush()


def print_json(value: Any) -> None:
    """Print a JSON object as one line on stdout, at once."""
    import msgspec

    try:
        text = msgspec.json.encode(value)
    except UnicodeEncodeError:
        text = msgspec.json.encode(_in_utf_8(msgspec.to_builtins(value)))
    print_line(_LATE_CONTROL.sub(lambda found: f"\\u{ord(found[0]):04x}", text.decode()))


def _in_utf_8(value: Any) -> Any:
    """Return what JSON can say of a value with names of files that are no UTF-8: they are written as in a terminal."""
    if isinstance(value, str):
        return value.encode(errors="backslashreplace").decode()
    if isinstance(value, dict):
        return {_in_utf_8(name): _in_utf_8(item) for name, item in value.items()}
    return [_in_utf_8(item) for item in value] if isinstance(value, list | tuple) else value


def print_result(name: str, value: object, *, json: bool) -> None:
    """Print a result: its text alone, or for programs as the only field of an object."""
    if json:
        print_json({name: str(value)})
    else:
        print_line(str(value))


def print_note(text: str) -> None:
    """Print a line for people on stderr."""
    # A stderr that cannot be written, such as a pipe without a reader, ends no command.
    with contextlib.suppress(OSError):
        print(terminal(text), file=sys.stderr, flush=True)  # noqa: T201  (this is where commands print)


def print_error(text: str, hint: str = "") -> None:
    """Print what went wrong, and in a second line what may help."""
    # Without stderr, the exit code is all that tells.
    with contextlib.suppress(OSError):
        print_parts(("error: ", "bold red"), text, on=sys.stderr)
        if hint:
            print_parts((hint, "dim"), on=sys.stderr)


def print_parts(*parts: str | tuple[str, str], on: TextIO | None = None) -> None:
    """Print a line of parts, some with a style of rich, which is imported where styles may be seen.

    Args:
        parts: texts, or pairs of a text and its style.
        on: stdout or stderr.
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
    """Ask on stderr; no answer at all is a no."""
    import typer

    try:
        return typer.confirm(question, err=True)
    except typer.Abort:
        return False


def may_overwrite(overwrite: bool) -> Overwrite:
    """Return whether files may go that Unity-Link did not make: asked on a terminal, where the option was not given."""
    if overwrite or not (sys.stdin.isatty() and sys.stderr.isatty()):
        return overwrite
    from unity_link.files import in_the_way

    return lambda paths: is_confirmed(f"{in_the_way(paths)}. Replace?")


_COLOURING = ("FORCE_COLOR", "TTY_COMPATIBLE")
"""Environment variables by which rich colours output that is no terminal."""
