"""A terminal as a user has it before them: keys go into it, and a screen is looked at, resized, and waited for.

tmux is the terminal. What is typed goes to a shell, so that a test sees as well what a program leaves behind.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

needs_tmux = pytest.mark.skipif(shutil.which("tmux") is None, reason="needs tmux: apt install tmux")
GIVEN_BACK = "cursor 1, alternate 0"
"""Modes of a terminal that no program has for itself: its cursor is shown, and what stood on its screen is there."""
PATIENCE = 60
"""Seconds after which a test gives up to wait for something on the screen."""
NOT_INHERITED = ("COLUMNS", "LINES", "TMUX", "XDG_CONFIG_HOME")
"""Variables of the terminal and the home that the tests are run from; pytest-xdist has workers of 80 columns."""
AGAIN_EVERY = 3
"""Seconds after which a line is typed again."""


class Window:
    """A terminal with a shell in it.

    Args:
        home: the user's home, and the folder that the shell is in.
    """

    def __init__(self, home: Path) -> None:
        self._socket = str(home / "tmux")
        environment = {name: value for name, value in os.environ.items() if name not in NOT_INHERITED} | {
            "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]),
            "HOME": str(home),
            "LC_ALL": "C.UTF-8",
        }
        self._tmux(
            "-f", os.devnull, "new-session", "-d", "-x", "100", "-y", "30", "-c", str(home), "sh", env=environment
        )
        self._tmux("set-option", "-g", "window-size", "manual")
        # A shell has its own mind of the prompt that it inherits.
        self.enter("PS1='$ '")

    def enter(self, line: str) -> None:
        """Type a line."""
        self._tmux("send-keys", "-l", line)
        self.press("Enter")

    def clear(self) -> None:
        """Clear the screen, so that what an earlier program left is not taken for what the next one shows."""
        self.enter("clear")
        self.wait_for(r"\A\$ *$")

    def press(self, *keys: str) -> None:
        """Press keys, under tmux's names: C-c, Up."""
        self._tmux("send-keys", *keys)

    def resize(self, width: int, height: int) -> None:
        self._tmux("resize-window", "-x", str(width), "-y", str(height))

    def screen(self) -> str:
        """Return what is on the screen."""
        return self._tmux("capture-pane", "-p")

    def all(self) -> str:
        """Return what is on the screen, and above it what has left it."""
        return self._tmux("capture-pane", "-p", "-S", "-")

    @property
    def state(self) -> str:
        """Return the visibility of the cursor, and whether the screen is the alternate one."""
        return self._tmux("display-message", "-p", "cursor #{cursor_flag}, alternate #{alternate_on}").strip()

    def wait_until(self, condition: Callable[[str], object]) -> str:
        """Wait until the screen is as it should be, and give it."""
        end = time.monotonic() + PATIENCE
        while not condition(screen := self.screen()):
            if time.monotonic() > end:
                pytest.fail(f"this stays on the screen:\n{screen}")
            time.sleep(0.05)
        return screen

    def enter_until(self, line: str, pattern: str) -> None:
        """Type a line, again and again, until a pattern is on the screen."""
        again = 0.0

        def is_there(screen: str) -> object:
            nonlocal again
            if time.monotonic() >= again:
                self.enter(line)
                again = time.monotonic() + AGAIN_EVERY
            return re.search(pattern, screen, re.MULTILINE)

        self.wait_until(is_there)

    def wait_for(self, *patterns: str) -> str:
        """Wait until each of some patterns is on the screen, ^ and $ being ends of lines; return the screen."""
        return self.wait_until(lambda screen: all(re.search(pattern, screen, re.MULTILINE) for pattern in patterns))

    def _tmux(self, *arguments: str, env: dict[str, str] | None = None) -> str:
        command = ["tmux", "-u", "-S", self._socket, *arguments]
        return subprocess.run(command, env=env, capture_output=True, text=True, check=True).stdout

    def close(self) -> None:
        self._tmux("kill-server")


@contextmanager
def window(home: Path) -> Iterator[Window]:
    terminal = Window(home)
    try:
        terminal.clear()
        yield terminal
    finally:
        terminal.close()
