"""The commands of docs/tutorials/board.md that need no board."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from docs.walkthrough import files_of
from unity_link.boards.loading import load_board
from unity_link.spec import compile_text

PAGE = Path(__file__).resolve().parents[2] / "docs" / "tutorials" / "board.md"
TEXT = PAGE.read_text()
BOARD_URL = "serial:/dev/ttyUSB1?baud=3000000"
_SHELL = re.findall(r"^```shell\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
TYPED = dict.fromkeys(
    # A virtual gateway replaces the board.
    line.replace(f'"{BOARD_URL}"', "sim:lamp.ul")
    for line in "".join(_SHELL).splitlines()
    if re.match(r"unity-link (?!build)|python (?!.* rtl:)", line)
)
"""The lines to type that need neither a board nor a minute of time."""
(ON_RTL,) = re.findall(r"^python .* rtl:.*$", TEXT, re.MULTILINE)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with the files that the tutorial asks its reader to save."""
    saved = files_of(PAGE)
    assert sorted(saved) == ["blink.py", "lamp.ul"]
    for name, text in saved.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def _type(folder: Path, line: str, seconds: float = 60) -> str:
    """Run a line of the tutorial; return its output."""
    words = shlex.split(line)
    program = [] if words[0] == "python" else ["-m", "unity_link"]
    done = subprocess.run(
        [sys.executable, *program, *words[1:]],
        cwd=folder,
        check=False,
        capture_output=True,
        text=True,
        timeout=seconds,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_typed_lines_print_the_output_in_the_tutorial(folder: Path) -> None:
    printed = [_type(folder, line) for line in TYPED]
    assert all(printed)
    shown = re.findall(r"^```text\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
    # Spaces at the end of a line, empty lines and widths of columns do not matter.
    assert (printed[0] + printed[1]).split() == shown[0].split()
    assert printed[2].split() == shown[1].split()


@pytest.mark.slow
@pytest.mark.rtl
@pytest.mark.timeout(600)
def test_the_program_of_the_tutorial_runs_on_its_gateware(folder: Path) -> None:
    shown = re.findall(r"^```text\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
    assert _type(folder, ON_RTL, 500).split() == shown[1].split()


def test_board_is_as_the_tutorial_describes_it() -> None:
    (name,) = set(re.findall(r"--board (\w+)", TEXT))
    _, board = load_board(name)
    assert f"baud={board.baud}" in BOARD_URL
    assert BOARD_URL in TEXT
    pins = {signal.pin for signal in compile_text(files_of(PAGE)["lamp.ul"]).interface().signals.values()}
    assert pins == {"led0", "j2_0"}
    assert re.search(rf"`j2_0`, which the report places at the site {board.io_pins['j2_0'].site}\b", TEXT)
    assert "led0" in board.io_pins
