"""Media that have a file descriptor, opened without an event loop.

A driver whose medium is one has a function ``open_channel(url, timeout)``, by which blocking code has its bytes without
a change of threads.
"""

from __future__ import annotations

import contextlib
import os
import re
import select
from typing import TYPE_CHECKING, Protocol

from unity_link.errors import ConnectError
from unity_link.protocol.window.constants import QUICK_TIMEOUT

if TYPE_CHECKING:
    import socket
    from collections.abc import Callable, Iterator

LARGEST_READ = 65_536


def has_ended(descriptor: int) -> bool:
    """Return whether nothing was read because the other side has closed; at a terminal, input may have been dropped."""
    if not os.isatty(descriptor):
        return True
    poll = select.poll()
    poll.register(descriptor, select.POLLHUP)
    return bool(poll.poll(0))


class Channel(Protocol):
    """A medium with a file descriptor that never blocks."""

    shortest_timeout: float
    """Seconds that the medium may hold an answer back, and some more."""

    def fileno(self) -> int:
        """Return the file descriptor."""

    def read(self) -> bytes:
        """Return what has come; what there is none of is empty, or raises BlockingIOError.

        Raises:
            EOFError: where the other side has closed it.
            OSError: where the medium is gone; or ConnectError.
        """

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Write what fits, and return how many bytes that was; raises OSError where the medium is gone."""

    def close(self) -> None:
        """Close it."""


class SocketChannel:
    """A connected stream socket.

    Args:
        connected: is the channel's from now on.
    """

    shortest_timeout = QUICK_TIMEOUT

    def __init__(self, connected: socket.socket) -> None:
        connected.settimeout(0)
        self._socket = connected
        self.fileno = connected.fileno
        self.write = connected.send
        self.close = connected.close

    def read(self) -> bytes:
        """Return what has come."""
        data = self._socket.recv(LARGEST_READ)
        if not data:
            raise EOFError
        return data


@contextlib.contextmanager
def refused_as(failure: str, question: str | Callable[[OSError | UnicodeError], str] = "") -> Iterator[None]:
    """Raise ConnectError for what the system refuses in the block.

    Args:
        failure: what could not be done.
        question: what the user might look at, or what says so of an error.
    """
    try:
        yield
    except (OSError, UnicodeError) as error:
        asked = question(error) if callable(question) else question
        raise ConnectError(f"{failure} ({refusal(error)})" + (f"; {asked}" if asked else "")) from error


def refusal(error: OSError | UnicodeError) -> str:
    """Return why the system refused something, in its own words where asyncio has others."""
    if isinstance(error, UnicodeError):
        # Of `socket`, which asks for an address by name in IDNA.
        return "that cannot be a name"
    # Of several addresses asyncio tells the numbers of the errors alone.
    numbers = [error.errno or 0, *map(int, re.findall(r"\[Errno (\d+)\]", str(error)))]
    number = next((number for number in numbers if number > 0), None)
    return os.strerror(number) if number else error.strerror or str(error) or type(error).__name__
