"""Shows a picture on the whole terminal while a command runs, and restores the terminal afterwards.

The picture is on the alternate screen, so that resizing leaves no remains of earlier ones. At the end its last state
is printed below the earlier content of the terminal.
"""

from __future__ import annotations

import asyncio
import os
import signal
import sys
from contextlib import ExitStack, asynccontextmanager, contextmanager
from typing import TYPE_CHECKING

from rich.console import ConsoleDimensions
from rich.live import Live

from unity_link.cli.output import out

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator

    from rich.console import RenderableType

_ENOUGH = b"qQ\x04"
"""Keys that end the picture: q, Q and Ctrl-D."""


@asynccontextmanager
async def full_screen(render: Callable[[ConsoleDimensions], RenderableType]) -> AsyncIterator[Callable[[], None]]:
    """Show a picture while the block runs; cancel the block if the user types q; yield a function that redraws it.

    Args:
        render: returns the picture for a terminal of a given size.
    """
    limit = asyncio.timeout(None)
    screen = _Screen(render, end=lambda: limit.reschedule(0))
    try:
        async with limit:
            screen.take()
            try:
                yield screen.draw
            finally:
                screen.give_back()
    except TimeoutError:
        if not limit.expired():
            raise


class _Screen:
    """The terminal while the picture is shown."""

    def __init__(self, render: Callable[[ConsoleDimensions], RenderableType], end: Callable[[], None]) -> None:
        self._render = render
        self._end = end
        self._console = out()
        self._taken = ExitStack()
        self._live: Live

    def draw(self) -> None:
        self._live.update(self._picture(), refresh=True)

    def take(self) -> None:
        loop = asyncio.get_running_loop()
        self._taken.enter_context(_keys_unseen(self._end))
        live = Live(self._picture(), console=self._console, screen=True, auto_refresh=False)
        self._live = self._taken.enter_context(live)
        if signal.getsignal(signal.SIGTSTP) is not signal.SIG_IGN:
            loop.add_signal_handler(signal.SIGTSTP, self._pause)
            self._taken.callback(loop.remove_signal_handler, signal.SIGTSTP)

    def give_back(self) -> None:
        self._taken.close()
        self._console.print(self._picture())

    def _picture(self) -> RenderableType:
        size = os.get_terminal_size(self._console.file.fileno())
        # Measure the size: rich prefers COLUMNS and LINES, which do not follow the window. A serial console has size 0.
        if all(size):
            self._console.size = ConsoleDimensions(*size)
        return self._render(self._console.size)

    def _pause(self) -> None:
        """Restore the terminal for the shell after Ctrl-Z, and show the picture again when the program continues."""
        self._taken.close()
        signal.raise_signal(signal.SIGTSTP)
        self.take()


@contextmanager
def _keys_unseen(end: Callable[[], None]) -> Iterator[None]:
    """Read all keys, so that they neither disturb the picture nor reach the shell later; Ctrl-C stays a signal."""
    if sys.stdin is None or not sys.stdin.isatty():
        yield
        return
    import termios
    import tty

    loop = asyncio.get_running_loop()
    keyboard = sys.stdin.fileno()

    def read() -> None:
        keys = os.read(keyboard, 1024)
        if not keys or any(key in _ENOUGH for key in keys):
            loop.remove_reader(keyboard)
            end()

    before = termios.tcgetattr(keyboard)
    tty.setcbreak(keyboard)
    loop.add_reader(keyboard, read)
    try:
        yield
    finally:
        loop.remove_reader(keyboard)
        termios.tcsetattr(keyboard, termios.TCSAFLUSH, before)
