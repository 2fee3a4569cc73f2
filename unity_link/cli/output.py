"""What a command prints where.

stdout has what was asked for, and under `--json` nothing but one JSON object a line. stderr has errors and summaries.
Colours and moving pictures are for terminals alone; rich sees to that, and to `NO_COLOR`.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console


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

    print_line(msgspec.json.encode(value).decode())


def print_note(text: str) -> None:
    """Print a line for people on stderr."""
    print(text, file=sys.stderr, flush=True)  # noqa: T201  (this is where commands print)


def print_error(text: str, hint: str = "") -> None:
    """Print what went wrong, and in a second line what may help."""
    from rich.console import Console
    from rich.text import Text

    console = Console(stderr=True, highlight=False, soft_wrap=True)
    console.print(Text.assemble(("error: ", "bold red"), text))
    if hint:
        console.print(Text(hint, "dim"))
