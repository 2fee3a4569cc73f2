"""The claims of docs/safety.md on outputs when a program ends, checked with the programs of the tutorials."""

from __future__ import annotations

import contextlib
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from docs.walkthrough import files_of
from unity_link import blocking

if TYPE_CHECKING:
    from collections.abc import Iterator

DOCS = Path(__file__).parents[1] / "docs"
PROGRAM = str(Path(sys.executable).parent / "unity-link")
PATIENCE = 60.0


def save(page: str, folder: Path) -> None:
    """Write the files that a tutorial asks its reader to save."""
    for name, text in files_of(DOCS / "tutorials" / page).items():
        (folder / name).write_text(text, encoding="utf-8")


@contextlib.contextmanager
def simulated(folder: Path, robot: str) -> Iterator[str]:
    """Share a robot on a socket for the program and an observer; yield the URL."""
    command = [PROGRAM, "serve", f"sim:{robot}", "--unix", "robot.sock"]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline().startswith("unix:")
            yield f"unix:{folder / 'robot.sock'}"
        finally:
            process.kill()


def ended_by(number: signal.Signals, program: list[str], folder: Path, url: str, moving: int) -> None:
    """Run a program until the word at `moving` is not 0; end it by a signal."""
    with subprocess.Popen(program, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            deadline = time.monotonic() + PATIENCE
            with blocking.connect(url) as link:
                while link.read(moving) == 0:
                    assert process.poll() is None
                    assert time.monotonic() < deadline
            process.send_signal(number)
            process.wait(PATIENCE)
        finally:
            process.kill()


@pytest.mark.slow
def test_the_lamp_is_off_at_ctrl_c(tmp_path: Path) -> None:
    save("board.md", tmp_path)
    with simulated(tmp_path, "lamp.ul") as url:
        ended_by(signal.SIGINT, [sys.executable, "blink.py", url], tmp_path, url, 0x00)
        with blocking.connect(url) as link:
            assert link.read(0x00) == 0


@pytest.mark.parametrize("page", ["rover.md", "board.md"])
def test_a_tutorials_program_that_moves_something_ends_with_it_at_rest(page: str) -> None:
    programs = [text for name, text in files_of(DOCS / "tutorials" / page).items() if ".set(" in text]
    moving = [text for text in programs if "import asyncio" in text]
    assert moving
    for text in moving:
        ending = text.partition("finally:")[2]
        assert ".armed(" in text or ".set(0)" in ending or ".set(False)" in ending
