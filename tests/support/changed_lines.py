"""Lines that do not carry every byte as it is, as settings of ports, adapters and servers make them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from support.valve import Valve

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual.gateway import Gateway

XON, XOFF = 0x11, 0x13
DIRECTIONS = ("to the gateway", "from the gateway", "both ways")


class Line(NamedTuple):
    """What becomes of bytes on their way."""

    change: Callable[[bytes], bytes]
    carries_text: bool
    """True if no frame of text has a byte that is changed."""


LINES = {
    "XON and XOFF taken out": Line(lambda data: data.translate(None, bytes((XON, XOFF))), carries_text=True),
    "seven bits": Line(lambda data: bytes(byte & 0x7F for byte in data), carries_text=True),
    "FF doubled": Line(lambda data: data.replace(b"\xff", b"\xff\xff"), carries_text=True),
    "FF and what follows taken out": Line(lambda data: re.sub(rb"\xff.?", b"", data, flags=re.DOTALL), carries_text=True),
    "NUL taken out": Line(lambda data: data.replace(b"\x00", b""), carries_text=True),
    "CR to LF": Line(lambda data: data.replace(b"\r", b"\n"), carries_text=False),
    "LF to CR LF": Line(lambda data: data.replace(b"\n", b"\r\n"), carries_text=False),
}


class FlowControl:
    """A line that XOFF stops and XON starts again; it carries neither."""

    def __init__(self) -> None:
        self._stopped = False
        self._held = b""

    def __call__(self, data: bytes) -> bytes:
        passed = b""
        for byte in data:
            if byte in (XON, XOFF):
                self._stopped = byte == XOFF
                passed, self._held = passed + (b"" if self._stopped else self._held), self._held * self._stopped
            elif self._stopped:
                self._held += bytes((byte,))
            else:
                passed += bytes((byte,))
        return passed


class ChangedLine(Valve):
    """A line in front of a gateway.

    Args:
        gateway: what is behind.
        change: what becomes of bytes.
        direction: of the bytes that are changed, one of `DIRECTIONS`.
    """

    def __init__(self, gateway: Gateway, change: Callable[[bytes], bytes], direction: str = DIRECTIONS[2]) -> None:
        super().__init__(gateway)
        self._to = bytes if direction == DIRECTIONS[1] else change
        self._from = bytes if direction == DIRECTIONS[0] else change

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes, and return what arrives of the answers."""
        return self._from(super().receive(self._to(data), now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass, and return what arrives of samples."""
        return self._from(super().advance(now, room))
