"""Strings from outside are printed in a form that neither terminals nor `rich` interpret."""

from __future__ import annotations

import ast
import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from rich.table import Table
from rich.text import Text

from unity_link import cli
from unity_link.cli.output import console_on, print_error, print_json, print_line, print_note, print_parts, print_result

if TYPE_CHECKING:
    from collections.abc import Callable

HOSTILE = "a\x1b]0;title\x07\x1b[31mb\x9b2J\x7f\u202ec\r d"
OBEYED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e]")


class Terminal(io.StringIO):
    """A stream that claims to be a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize("show", [print_line, print_note, print_error, print_parts, lambda text: print_error("", text)])
def test_printed_line_has_no_control_sequences(show: Callable[[str], None], capsys: pytest.CaptureFixture[str]) -> None:
    show(f"{HOSTILE}\n\tsecond")
    printed = "".join(capsys.readouterr())
    assert not OBEYED.search(printed)
    assert "\n\tsecond\n" in printed


@pytest.mark.parametrize(
    "thing", [HOSTILE, Text(HOSTILE), Table(HOSTILE, title=HOSTILE)], ids=["text", "Text", "table"]
)
def test_output_of_rich_has_no_control_sequences_from_outside(thing: object) -> None:
    stream = io.StringIO()
    console_on(stream).print(thing)
    assert not OBEYED.search(stream.getvalue())
    assert "b" in stream.getvalue()


def test_colours_are_kept_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.delenv("NO_COLOR", raising=False)
    stream = Terminal()
    console_on(stream).print(Text("good", "bold red"))
    assert "\x1b[1;31mgood" in stream.getvalue()


def test_brackets_and_colons_in_strings_are_letters() -> None:
    stream = io.StringIO()
    console_on(stream).print("[/red] [bold]x[/bold] :smile:")
    assert stream.getvalue() == "[/red] [bold]x[/bold] :smile:\n"


def test_json_has_the_same_data_without_control_sequences(capsys: pytest.CaptureFixture[str]) -> None:
    print_json({"name": HOSTILE})
    print_result("name", HOSTILE, json=True)
    printed = capsys.readouterr().out
    assert [json.loads(line) for line in printed.splitlines()] == [{"name": HOSTILE}] * 2
    assert not OBEYED.search(printed)


def test_no_command_makes_its_own_console() -> None:
    for path in Path(cli.__file__).parent.glob("*.py"):
        nodes = list(ast.walk(ast.parse(path.read_text())))
        own = {node.name for node in nodes if isinstance(node, ast.ClassDef)}
        made = {node.func.id for node in nodes if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
        assert "Console" not in made - own, (
            f"{path.name}: use console_on of output.py, which escapes control characters"
        )


def test_log_on_stderr_has_no_control_sequences() -> None:
    program = [
        "import logging, sys",
        "from unity_link import cli",
        f"run = lambda **_: logging.getLogger('unity_link.virtual').warning('%s', {HOSTILE!r})",
        "sys.exit(cli._run(run))",
    ]
    done = subprocess.run([sys.executable, "-c", "\n".join(program)], capture_output=True, check=False, timeout=60)
    said = done.stderr.decode()
    assert ("title" in said, OBEYED.search(said)) == (True, None)
    assert done.returncode == 0
