"""The output of commands.

stdout has what was asked for, and under `--json` nothing but one JSON object a line. stderr has errors and summaries.
Colours and moving pictures are for terminals alone; rich sees to that, and to `NO_COLOR`.
"""

from __future__ import annotations

import contextlib
import functools
import os
import sys
from typing import TYPE_CHECKING, Any, TextIO

if TYPE_CHECKING:
    from rich.console import Console

    from unity_link.files import Overwrite


def out() -> Console:
    """Return the console of stdout; a pipe gets whole lines, however long."""
    from rich.console import Console

    return Console(highlight=False, soft_wrap=not sys.stdout.isatty())


def is_live() -> bool:
    """Return whether stdout is a terminal that can show a moving picture."""
    console = out()
    # Colours that are forced on a pipe still want lines in it; and without Unicode there are no dots to draw with.
    return sys.stdout.isatty() and not console.is_dumb_terminal and console.encoding.startswith("utf")


def print_line(text: str) -> None:
    """Print a line on stdout at once, so that a program that reads it does not wait."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def print_json(value: Any) -> None:
    """Print a JSON object as one line on stdout, at once."""
    import msgspec

    try:
        text = msgspec.json.encode(value)
    except UnicodeEncodeError:
        text = msgspec.json.encode(_in_utf_8(msgspec.to_builtins(value)))
    print_line(text.decode())


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
        print(text, file=sys.stderr, flush=True)  # noqa: T201  (this is where commands print)


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
        stream.write("".join(part if isinstance(part, str) else part[0] for part in parts) + "\n")
        stream.flush()
        return
    from rich.text import Text

    _console(stream).print(Text.assemble(*parts))


@functools.lru_cache(maxsize=2)
def _console(stream: TextIO) -> Console:
    from rich.console import Console

    return Console(file=stream, highlight=False, soft_wrap=stream is sys.stderr or not stream.isatty())


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
