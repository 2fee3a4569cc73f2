"""Lines that change some of the bytes that they carry, because of settings of ports, adapters and servers."""

from __future__ import annotations

import contextlib
import functools
import os
import re
import select
import socket
import threading
import time
import tty
from typing import TYPE_CHECKING, NamedTuple

from support.valve import Valve

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.virtual.gateway import Gateway

XON, XOFF = 0x11, 0x13
DIRECTIONS = ("to the gateway", "from the gateway", "both ways")


class FlowControl:
    """A line with software flow control: XOFF stops it, XON restarts it, and neither byte reaches the other end."""

    def __init__(self) -> None:
        self._held: bytes | None = None
        """Bytes held back while the line is stopped; None while the line runs."""

    def __call__(self, data: bytes) -> bytes:
        """Return the bytes that the line lets through."""
        passed = bytearray()
        for byte in data:
            if byte == XOFF:
                self._held = self._held or b""
            elif byte == XON:
                passed += self._held or b""
                self._held = None
            elif self._held is None:
                passed.append(byte)
            else:
                self._held += bytes((byte,))
        return bytes(passed)


class Line(NamedTuple):
    """A kind of line, defined by the change that it makes to bytes."""

    change: Callable[[], Callable[[bytes], bytes]]
    """Returns a new function that changes the bytes of one direction."""
    carries_text: bool
    """True if the line leaves all bytes of text frames unchanged."""
    stops: bool = False
    """True if some byte may stop the line."""


def _without(pattern: bytes, instead: bytes = b"") -> Callable[[], Callable[[bytes], bytes]]:
    return lambda: functools.partial(re.compile(pattern, re.DOTALL).sub, instead)


LINES = {
    "XON and XOFF taken out": Line(_without(rb"[\x11\x13]"), carries_text=True),
    "XOFF stops and XON starts": Line(FlowControl, carries_text=True, stops=True),
    "seven bits": Line(lambda: lambda data: bytes(byte & 0x7F for byte in data), carries_text=True),
    "FF doubled": Line(_without(rb"\xff", b"\xff\xff"), carries_text=True),
    "FF taken out with what follows": Line(_without(rb"\xff.?"), carries_text=True),
    "NUL taken out": Line(_without(rb"\x00"), carries_text=True),
    "CR to LF": Line(_without(rb"\r", b"\n"), carries_text=False),
    "LF to CR LF": Line(_without(rb"\n", b"\r\n"), carries_text=False),
}
OF_LINE_ENDS = {
    "CR to LF": LINES["CR to LF"],
    "LF to CR LF": LINES["LF to CR LF"],
    "LF to CR": Line(_without(rb"\n", b"\r"), carries_text=False),
    "CR taken out": Line(_without(rb"\r"), carries_text=False),
    "LF taken out": Line(_without(rb"\n"), carries_text=False),
}
"""Lines that change line ends."""
CHANGED_ENDS = [
    (name, direction)
    for name in OF_LINE_ENDS
    for direction in DIRECTIONS
    if (name, direction) != ("LF taken out", DIRECTIONS[0])
]
"""Pairs of a line and a direction whose change the host can detect. If LF is removed from requests, the gateway does
not answer checked requests at all."""
CR_LF_FOR_CR = Line(_without(rb"\r", b"\r\n"), carries_text=True)


class ChangedLine(Valve):
    """A line that changes the bytes to a gateway, from it, or both.

    Args:
        gateway: the gateway at the end of the line.
        line: the kind of line.
        direction: which bytes are changed, one of `DIRECTIONS`.
    """

    def __init__(self, gateway: Gateway, line: Line, direction: str = DIRECTIONS[2]) -> None:
        super().__init__(gateway)
        self._to = bytes if direction == DIRECTIONS[1] else line.change()
        self._from = bytes if direction == DIRECTIONS[0] else line.change()
        self.sent = b""
        """All bytes that the host has sent, before any change."""

    def receive(self, data: bytes, now: float) -> bytes:
        """Pass bytes to the gateway; return its answers as the host receives them."""
        self.sent += data
        return self._from(super().receive(self._to(data), now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance the gateway's time; return its samples as the host receives them."""
        return self._from(super().advance(now, room))


@contextlib.contextmanager
def on_a_port(gateway: Gateway, kind: str) -> Iterator[str]:
    """Serve a gateway on a socket or a pseudo-terminal in a thread; yield its URL."""
    with contextlib.ExitStack() as open_now:
        if kind == "tcp":
            server = open_now.enter_context(socket.create_server(("127.0.0.1", 0)))
            url = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        else:
            master, slave = os.openpty()
            open_now.callback(os.close, slave)
            tty.setraw(slave)
            url = f"serial:{os.ttyname(slave)}"
        ended = threading.Event()

        def answer() -> None:
            if kind == "tcp":
                with contextlib.suppress(OSError), server.accept()[0] as connection:
                    while data := connection.recv(4096):
                        connection.sendall(gateway.receive(data, time.monotonic()))
                return
            while not ended.is_set():
                if select.select([master], [], [], 0.05)[0]:
                    os.write(master, gateway.receive(os.read(master, 4096), time.monotonic()))
            os.close(master)

        thread = threading.Thread(target=answer)
        thread.start()
        try:
            yield url
        finally:
            ended.set()
            thread.join()
