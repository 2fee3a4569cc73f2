"""Media with a file descriptor, opened without an event loop.

The driver of such a medium has a function ``open_channel(url, timeout)``. With it, blocking code reads and writes in
its own thread.
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
    """Return True if an empty read means that the other side has closed.

    An empty read of a terminal can also mean that its input was discarded.
    """
    if not os.isatty(descriptor):
        return True
    poll = select.poll()
    poll.register(descriptor, select.POLLHUP)
    return bool(poll.poll(0))


class Channel(Protocol):
    """A medium with a non-blocking file descriptor."""

    shortest_timeout: float
    """Lower limit of the retransmission timeout in seconds: the time that the medium may delay an answer, and a margin.
    """

    def fileno(self) -> int:
        """Return the file descriptor."""

    def read(self) -> bytes:
        """Return the received bytes; possibly none.

        Raises:
            BlockingIOError: if no bytes were received.
            EOFError: if the other side has closed the medium.
            ConnectError: if the medium is lost.
            OSError: if the medium is lost.
        """

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Write as many bytes as the medium accepts, and return their number; raise OSError if the medium is lost."""

    def close(self) -> None:
        """Close the medium."""


class SocketChannel:
    """A connected stream socket.

    Args:
        connected: the socket; the channel closes it.
    """

    shortest_timeout = QUICK_TIMEOUT

    def __init__(self, connected: socket.socket) -> None:
        connected.settimeout(0)
        self._socket = connected
        self.fileno = connected.fileno
        self.write = connected.send
        self.close = connected.close

    def read(self) -> bytes:
        """Return the received bytes."""
        data = self._socket.recv(LARGEST_READ)
        if not data:
            raise EOFError
        return data


@contextlib.contextmanager
def refused_as(failure: str, question: str | Callable[[OSError | UnicodeError], str] = "") -> Iterator[None]:
    """Convert an OSError or UnicodeError in the block to a ConnectError.

    Args:
        failure: beginning of the message: the failed operation.
        question: end of the message, a hint for the user; or a function that returns it for an error.
    """
    try:
        yield
    except (OSError, UnicodeError) as error:
        asked = question(error) if callable(question) else question
        raise ConnectError(f"{failure} ({refusal(error)})" + (f"; {asked}" if asked else "")) from error


def refusal(error: OSError | UnicodeError) -> str:
    """Return the operating system's text of an error, even if asyncio has replaced the text by its own."""
    if isinstance(error, UnicodeError):
        # `socket` could not encode the host name by IDNA.
        return "that is not a host name"
    # After failures at several addresses, asyncio's error has the numbers of the errors only in its text.
    numbers = [error.errno or 0, *map(int, re.findall(r"\[Errno (\d+)\]", str(error)))]
    number = next((number for number in numbers if number > 0), None)
    return os.strerror(number) if number else error.strerror or str(error) or type(error).__name__
