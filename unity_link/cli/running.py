"""Runs the coroutine of a command until it returns or a signal arrives.

The first signal cancels the coroutine, so that its `finally` blocks close links, restore the terminal and print
summaries. A second signal after at least `PATIENCE` ends the program at once, in case that takes too long.
"""

from __future__ import annotations

import asyncio
import signal
import time
from typing import TYPE_CHECKING, TypeVar

import typer

from unity_link.cli.output import print_note

if TYPE_CHECKING:
    from collections.abc import Coroutine, Iterable

T = TypeVar("T")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
SIGNALLED = 128
"""Exit code of a program that a signal ended, minus the number of the signal."""
INTERRUPTED = SIGNALLED + signal.SIGINT
PATIENCE = 1.0
"""Seconds in which further signals are ignored: `timeout` sends two at once, and a user may press Ctrl-C twice."""


def run(command: Coroutine[None, None, T]) -> T:
    """Run `command` until it returns, and return its result.

    Raises:
        typer.Exit: if a signal ended it, with 128 plus the signal's number, as shells expect.
    """
    return asyncio.run(_until_signal(command))


async def _until_signal(command: Coroutine[None, None, T]) -> T:
    loop = asyncio.get_running_loop()
    task = asyncio.current_task()
    assert task is not None
    caught: list[signal.Signals] = []

    def stop(number: signal.Signals) -> None:
        caught.append(number)
        release()
        _end_at_next(watched)
        task.cancel()

    def release() -> None:
        for number, handler in watched.items():
            loop.remove_signal_handler(number)
            signal.signal(number, handler)

    before = {number: signal.getsignal(number) or signal.SIG_DFL for number in SIGNALS}
    # A signal that `nohup` ignores stays ignored.
    watched = {number: handler for number, handler in before.items() if handler is not signal.SIG_IGN}
    for number in watched:
        loop.add_signal_handler(number, stop, number)
    try:
        result = await command
    except asyncio.CancelledError as error:
        if not caught:
            raise
        # A lease that could not be disarmed adds a note.
        for note in getattr(error, "__notes__", []):
            print_note(note)
        raise typer.Exit(SIGNALLED + caught[0]) from None
    finally:
        if not caught:
            release()
    if caught:
        raise typer.Exit(SIGNALLED + caught[0])
    return result


def _end_at_next(watched: Iterable[signal.Signals]) -> None:
    """Let the next signal after `PATIENCE` end the program with the signal's default action."""
    earliest = time.monotonic() + PATIENCE

    def end(number: int, _: object) -> None:
        if time.monotonic() >= earliest:
            signal.signal(number, signal.SIG_DFL)
            signal.raise_signal(number)

    for number in watched:
        signal.signal(number, end)
