"""Follows a page from an empty folder, as its reader does: writes its files, and runs its commands.

A name in bold in the line before a block is the name of the file with this text, or of the terminal. In a block of
`console` each `$ command` is run and must print the lines below it; `...` is any text. Commands of "Terminal 2" run
beside the others until the end of the page, and are then ended by Ctrl-C.
"""

from __future__ import annotations

import contextlib
import doctest
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator

WALKTHROUGHS = [
    "docs/tutorials/rover.md",
    "docs/tutorials/spec.md",
    *(f"docs/how-to/{name}.md" for name in ("own-core", "stop-safely", "act-at-a-time", "unknown-board")),
]
"""The pages that are followed from an empty folder."""
_ROOT = Path(__file__).parents[1]
_BUILT = (_ROOT / "docs" / "_build", _ROOT / "docs" / "reference" / "cores" / "pages")
PAGES = [
    _ROOT / "README.md",
    *(page for page in sorted(_ROOT.glob("docs/**/*.md")) if not any(page.is_relative_to(built) for built in _BUILT)),
]
"""All pages in Markdown, without generated ones."""
BESIDE = "Terminal 2"
PATIENCE = 120.0
"""Seconds that a command may take."""
_BLOCK = re.compile(r"^(?:\*\*`?([^\n`]+)`?\*\*\n)?```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
_BY_CTRL_C = 128 + signal.SIGINT


class Block(NamedTuple):
    """A block of code of a page."""

    language: str
    caption: str
    """The name of a file, or of a terminal; empty without one."""
    text: str
    line: int
    """Line of the page at which the text begins, from 1 on."""


def follow(page: Path, folder: Path) -> None:
    """Follow a page in a folder.

    Raises:
        AssertionError: a command failed, or its output differs.
    """
    with contextlib.ExitStack() as beside:
        for language, caption, text, _ in blocks(page):
            if language == "console":
                for command, expected in typed(text):
                    if caption == BESIDE:
                        beside.enter_context(_running(command, expected, folder))
                    else:
                        run(command, expected, folder)
            elif caption:
                file = folder / caption
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")


def blocks(page: Path) -> Iterator[Block]:
    """Yield the blocks of code of a page."""
    text = page.read_text(encoding="utf-8")
    for found in _BLOCK.finditer(text):
        caption, language, code = found.groups()
        yield Block(language, caption or "", code, text.count("\n", 0, found.start(3)) + 1)


def files_of(page: Path) -> dict[str, str]:
    """Return the texts of the files that the reader of a page saves, by their names."""
    return {block.caption: block.text for block in blocks(page) if block.caption and block.language != "console"}


def typed(block: str) -> Iterator[tuple[str, str]]:
    """Yield each `$ command` of a block, and its expected output."""
    for session in ("\n" + block).split("\n$ ")[1:]:
        command, _, expected = session.partition("\n")
        yield command, expected


def run(command: str, expected: str, folder: Path | None = None) -> None:
    """Run a command and compare its output.

    Args:
        command: line for a shell.
        expected: its output; `...` is any text. If it is empty, the output is not compared.
        folder: directory of the command; None for the working directory.

    Raises:
        AssertionError: the command failed, or its output differs.
    """
    done = subprocess.run(  # noqa: S602  (the reader types it into a shell, too)
        command,
        shell=True,
        cwd=folder,
        env=_environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, f"`{command}` exits with {done.returncode}: {done.stdout}{done.stderr}"
    _compare(command, done.stdout, expected)


@contextlib.contextmanager
def _running(command: str, expected: str, folder: Path) -> Iterator[None]:
    """Run a command during the block, which begins when the command has printed the expected number of lines."""
    with subprocess.Popen(  # noqa: S602  (as in `run`)
        f"exec {command}",
        shell=True,
        cwd=folder,
        env=_environment(),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            _compare(command, "".join(process.stdout.readline() for _ in expected.splitlines()), expected)
            yield
            process.send_signal(signal.SIGINT)
            assert process.wait(PATIENCE) == _BY_CTRL_C, f"`{command}` exits with {process.returncode} after Ctrl-C"
        finally:
            process.kill()


def _environment() -> dict[str, str]:
    """Return an environment with the commands of this Python, and with lines as long as in the pages."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return os.environ | {"PATH": path, "COLUMNS": "120"}


def _compare(command: str, printed: str, expected: str) -> None:
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    assert not expected.strip() or doctest.OutputChecker().check_output(expected, printed, flags), (
        f"`{command}` prints\n{printed}\nwhere the page says\n{expected}"
    )
