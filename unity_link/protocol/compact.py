"""The compact form of frames (docs/protocol.md, "The compact form"): two digits a byte, between bytes that no text has.

It is the same frame, with the CRC of its text: what is above this module sees text, and both forms mix at any time.
"""

from __future__ import annotations

import dataclasses
import re
from typing import TYPE_CHECKING, Final

from unity_link.protocol.frames import LONGEST_FRAME

if TYPE_CHECKING:
    from collections.abc import Iterable

START: Final = b"\xb5"
END: Final = b"\xca"
ESCAPE: Final = b"\xd3"
STUFFED: Final = 0x40
"""Value that is xored into a byte behind `ESCAPE`."""
COMMANDS: Final = ("r", "rm", "rq", "w", "wm", "wq", "wk", "ws", "h", "gn", "gx", "gp", "i", "n", "x", "P")
"""Commands that have this form, each at its number."""
_ADDRESSED: Final = frozenset(("r", "rm", "rq", "w", "wm", "wq", "wk", "ws"))
"""Commands whose requests name an address."""
_WITHOUT_ID: Final = "P"
_RESERVED = re.compile(rb"[\n\r\xb5\xca\xd3]")
_ESCAPED = re.compile(rb"\xd3(.?)", re.DOTALL)
_FRAME = re.compile(rb"(?:(?<=\n)|\A)(Z[0-9A-F]{2})?([g-z]{1,2}|P)([0-9A-F]+)\n")
_RUN = re.compile(rb"\xb5([^\n\r\xb5\xca]*)([\n\r\xb5\xca])|([\n\r])|(\xca)|[^\n\r\xb5\xca]+")


def _stuffed(found: re.Match[bytes]) -> bytes:
    return ESCAPE + bytes((found[0][0] ^ STUFFED,))


def _unstuffed(found: re.Match[bytes]) -> bytes:
    return bytes(byte ^ STUFFED for byte in found[1])


@dataclasses.dataclass(frozen=True)
class CompactForm:
    """Widths of a gateway's frames in one direction, which tell the frames with a digit to fill up.

    Words must have an even number of digits.
    """

    id_digits: int
    crc_digits: int
    address_digits: int
    """Those of a request's address; 0 for what a gateway sends."""
    has_node: bool = False
    """True for addressed frames: the first byte is the number of the node."""

    def is_filled(self, command: str) -> bool:
        """Return whether a digit 0 stands behind the number of a command, for an even number of digits."""
        digits = 1 + self.crc_digits
        if command != _WITHOUT_ID:
            digits += self.id_digits
        if command in _ADDRESSED:
            digits += self.address_digits
        return digits % 2 == 1

    def heads(self) -> list[tuple[str, str]]:
        """Return, for each number of a command, its letters and the digit that fills up, "0" or ""."""
        return [(command, "0" if self.is_filled(command) else "") for command in COMMANDS]


class Packer:
    """Puts frames into the compact form.

    Args:
        form: of the frames in this direction.
    """

    def __init__(self, form: CompactForm) -> None:
        self._heads = {command.encode(): f"{number:X}{fill}" for number, (command, fill) in enumerate(form.heads())}
        self._has_node = form.has_node

    def pack(self, frames: bytes) -> bytes:
        """Return frames, whole ones, with those that have a compact form in it, and the others as they are."""
        return _FRAME.sub(self._packed, frames)

    def _packed(self, found: re.Match[bytes]) -> bytes:
        prefix, command, digits = found.groups()
        head = self._heads.get(command)
        if head is None or (prefix is not None) != self._has_node:
            return found[0]
        node = "" if prefix is None else prefix[1:].decode()
        text = node + head + digits.decode()
        if len(text) % 2:
            return found[0]
        return START + _RESERVED.sub(_stuffed, bytes.fromhex(text)) + END


class Unpacker:
    """Makes text of what arrives in both forms.

    A line end or a start in a compact frame cuts it, and an end that nothing began ends a line: what is before is
    damaged, and the check above finds it.

    Args:
        form: of the frames in this direction.
    """

    def __init__(self, form: CompactForm) -> None:
        self._heads = form.heads()
        self._has_node = form.has_node
        self._begun = b""
        """A compact frame without its end, from its start on."""
        self._in_line = False
        """True behind text without its line end."""

    def unpack(self, data: bytes) -> bytes:
        """Return the text of what has arrived; a compact frame comes with its end."""
        if not self._begun and data.isascii():
            if data:
                self._in_line = data[-1] not in b"\n\r"
            return data
        return b"".join(self._pieces(self._begun + data))

    def _pieces(self, data: bytes) -> Iterable[bytes]:
        at = 0
        self._begun = b""
        while at < len(data):
            if data[at] == START[0]:
                if self._in_line:
                    yield b"\n"
                    self._in_line = False
                found = _RUN.match(data, at)
                if found is None:
                    # Its end is still to come, or it is none: then it can't be longer than a frame.
                    self._begun = data[at:]
                    if len(self._begun) > LONGEST_FRAME:
                        yield self._text(self._begun[1:])
                        self._begun, self._in_line = b"", True
                    return
                yield self._text(found[1])
                ends_by = found[2]
                at = found.end()
                if ends_by == START:
                    at -= 1
                yield b"\n" if ends_by in (START, END) else ends_by
                continue
            found = _RUN.match(data, at)
            assert found is not None
            at = found.end()
            yield found[0] + b"\n" if found[4] else found[0]
            self._in_line = not (found[3] or found[4])

    def _text(self, content: bytes) -> bytes:
        """Return the text of what stands between start and end, without its line end."""
        if ESCAPE in content:
            content = _ESCAPED.sub(_unstuffed, content)
        text = content.hex().upper()
        prefix = ""
        if self._has_node and text:
            prefix, text = "Z" + text[:2], text[2:]
        if not text:
            return prefix.encode()
        command, fill = self._heads[int(text[0], 16)]
        return (prefix + command + text[1 + len(fill) :]).encode()
