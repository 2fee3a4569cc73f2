"""A command in a process of its own, for input that can ask for any amount of time and memory."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from typing import TYPE_CHECKING

import typer

from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Iterator

_MOST_BYTES = 2 << 30


class TooMuchError(UnityLinkError):
    """Input asks for more time or memory than a command gives it."""


@contextlib.contextmanager
def bounded(name: str, seconds: int) -> Iterator[None]:
    """Enter the block in a new process, which is ended at a bound; in this one, wait for it, and end as it does.

    Args:
        name: of what is read, for the message.
        seconds: processor time that the new process may take, at least 1.

    Raises:
        typer.Exit: in this process, where the new one has ended by itself, with its code.
        TooMuchError: where it took more time or memory than it may.
    """
    import resource

    too_large = TooMuchError(f"{name} takes more than {_MOST_BYTES >> 30} GiB of memory")
    sys.stdout.flush()
    sys.stderr.flush()
    if child := os.fork():
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if code == -signal.SIGXCPU:
            raise TooMuchError(f"{name} takes more than {seconds} s of processor time; `--seconds` gives it more")
        # A library in C++ that finds no memory ends the process.
        if code < 0:
            raise too_large
        raise typer.Exit(code)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (_MOST_BYTES, _MOST_BYTES))
    try:
        yield
    except MemoryError:
        raise too_large from None
