"""A terminal as a user has it: tests type keys, read the screen, resize it, and wait for text.

The terminal is tmux. Keys go to a shell, so that a test also sees the state in which a program leaves the terminal.
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
"""Modes of a terminal without a full-screen program: the cursor is visible, and the normal screen is shown."""
PATIENCE = 60
"""Seconds after which a test stops waiting for text on the screen."""
NOT_INHERITED = ("COLUMNS", "LINES", "TMUX", "XDG_CONFIG_HOME")
"""Variables of the calling terminal and home that must not reach the window; workers of pytest-xdist set 80 columns."""
AGAIN_EVERY = 3
"""Seconds after which a line is typed again."""


class Window:
    """A terminal that runs a shell.

    Args:
        home: home and working folder of the shell.
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
        # Set the prompt by a command: shells may ignore the inherited one.
        self.enter("PS1='$ '")

    def enter(self, line: str) -> None:
        """Type a line, and press Enter."""
        self._tmux("send-keys", "-l", line)
        self.press("Enter")

    def clear(self) -> None:
        """Clear the screen, so that output of an earlier program is not mistaken for that of the next one."""
        self.enter("clear")
        self.wait_for(r"\A\$ *$")

    def press(self, *keys: str) -> None:
        """Press keys, by their names in tmux: C-c, Up."""
        self._tmux("send-keys", *keys)

    def resize(self, width: int, height: int) -> None:
        self._tmux("resize-window", "-x", str(width), "-y", str(height))

    def screen(self) -> str:
        """Return the text on the screen."""
        return self._tmux("capture-pane", "-p")

    def all(self) -> str:
        """Return the text on the screen, after the lines that were scrolled off."""
        return self._tmux("capture-pane", "-p", "-S", "-")

    @property
    def state(self) -> str:
        """Return the visibility of the cursor, and whether the alternate screen is shown."""
        return self._tmux("display-message", "-p", "cursor #{cursor_flag}, alternate #{alternate_on}").strip()

    def wait_until(self, condition: Callable[[str], object]) -> str:
        """Wait until the condition is true of the screen; return the screen."""
        end = time.monotonic() + PATIENCE
        while not condition(screen := self.screen()):
            if time.monotonic() > end:
                pytest.fail(f"this stays on the screen:\n{screen}")
            time.sleep(0.05)
        return screen

    def enter_until(self, line: str, pattern: str) -> None:
        """Type a line repeatedly until a pattern is on the screen."""
        again = 0.0

        def is_there(screen: str) -> object:
            nonlocal again
            if time.monotonic() >= again:
                self.enter(line)
                again = time.monotonic() + AGAIN_EVERY
            return re.search(pattern, screen, re.MULTILINE)

        self.wait_until(is_there)

    def wait_for(self, *patterns: str) -> str:
        """Wait until all patterns are on the screen; ^ and $ match at the ends of lines. Return the screen."""
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
