"""The compact form of frames (docs/protocol.md, "The compact form"): two digits a byte, between bytes that no text has.

It is the same frame, with the CRC of its text: what is above this module sees text, and both forms mix at any time.
Frames side by side are taken together, cut where an end and a start meet; where they are many bytes, of one command and
one length, by numpy (`unity_link.protocol.wire.compact_rows`).
"""

from __future__ import annotations

import dataclasses
import re
from itertools import groupby
from typing import TYPE_CHECKING, Final

from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.frames import (
    COMPACT_END,
    COMPACT_ESCAPE,
    COMPACT_RESERVED,
    COMPACT_START,
    COMPACT_STUFFED,
    LONGEST_FRAME,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from types import ModuleType

    from unity_link.protocol.wire.configuration import GatewayInfo

START: Final = COMPACT_START
END: Final = COMPACT_END
ESCAPE: Final = COMPACT_ESCAPE
STUFFED: Final = COMPACT_STUFFED
RESERVED: Final = COMPACT_RESERVED
COMMANDS: Final = ("r", "rm", "rq", "w", "wm", "wq", "wk", "ws", "h", "gn", "gx", "gp", "i", "n", "x", "P")
"""Commands that have this form, each at its number."""
MANY_BYTES: Final = 1024
"""Bytes in compact form that are worth a turn of numpy to be packed."""
MANY: Final = 8192
"""Bytes that are worth one to be unpacked, where each frame counts as `EACH` more."""
EACH: Final = 100
_ADDRESSED: Final = frozenset(("r", "rm", "rq", "w", "wm", "wq", "wk", "ws"))
"""Commands whose requests name an address."""
_STUFFING: Final = [(bytes((byte,)), ESCAPE + bytes((byte ^ STUFFED,))) for byte in ESCAPE + RESERVED[:-1]]
"""Bytes and what stands for them; the escape comes first, for it is in what stands for the others."""
_PLAIN: Final = [bytes((byte ^ STUFFED,)) for byte in range(256)]
"""The byte that is meant, for each that stands behind an escape."""
_SAMPLE: Final = COMMANDS.index("P")
_REST_OF_A_SAMPLE: Final = START + b"\xf0"
_FIRST_LETTER: Final = ord("g")
_ESCAPED = re.compile(rb"\xd3(.?)", re.DOTALL)
_CUT: Final = END + b"\n"
"""End of the text of a cut frame: a character that is no digit, so that no CRC fits, and the line end."""
_DIGITS: Final = b"0123456789ABCDEF"
_FRAME = re.compile(rb"\xb5[^\n\r\xb5\xca]*\xca\n?|[^\n\xb5\xca]*\n")
_PIECE = re.compile(rb"\xb5([^\n\r\xb5\xca]*)([\n\r\xb5\xca])|([\n\r])|(\xca)|[^\n\r\xb5\xca]+")


@dataclasses.dataclass(frozen=True)
class CompactForm:
    """Widths of a gateway's frames in one direction, which tell the frames with a digit to fill up.

    Words must have an even number of digits.
    """

    id_digits: int
    crc_digits: int
    address_digits: int
    from_gateway: bool
    has_node: bool = False
    """True for addressed frames: the first byte is the number of the node."""

    @classmethod
    def of(cls, info: GatewayInfo, *, from_gateway: bool) -> CompactForm:
        """Return the form of what a gateway sends, or takes."""
        has_node = Feature.ADDRESSED in info.features
        return cls(info.id_digits, info.crc_bits // 4, info.address_digits, from_gateway, has_node)

    def is_filled(self, command: str) -> bool:
        """Return whether a digit 0 stands behind the number of a command, for an even number of digits."""
        digits = 1 + self.crc_digits
        if command != "P":
            digits += self.id_digits
        if command in _ADDRESSED and not self.from_gateway:
            digits += self.address_digits
        if command == "h" and self.from_gateway:
            digits += self.id_digits
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
        self._prefix_size = 3 if form.has_node else 0
        # On a shared medium for the sake of nodes without the form, which know no other end.
        self._end = END + b"\n" if form.has_node else END

    def pack(self, frames: bytes) -> bytes:
        """Return frames, whole ones, with those that have a compact form in it, and the others as they are."""
        if frames.find(b"\n") == len(frames) - 1:
            return self.pack_one(frames)
        packed = self._pack_equal(frames)
        if packed:
            return packed
        groups = [[*group] for _, group in groupby(frames.splitlines(keepends=True), len)]
        return b"".join([self._pack_equal(b"".join(group)) or b"".join(map(self.pack_one, group)) for group in groups])

    def _pack_equal(self, frames: bytes) -> bytes:
        """Return two frames or more of one command and one length in compact form; nothing where they are not that."""
        size = frames.find(b"\n") + 1
        count = len(frames) // size if size else 0
        head, at = self._head(frames)
        begin = frames[:at]
        if (
            count < 2
            or len(frames) != size * count
            or not head
            or self._prefix_size
            or (size - 1 - at + len(head)) % 2
            or frames[size - 1 :: size] != b"\n" * count
            or frames.count(b"\n" + begin) != count - 1
            or frames.translate(None, _DIGITS) != (begin + b"\n") * count
        ):
            return b""
        if len(frames) >= 2 * MANY_BYTES:
            packed: bytes = _rows().pack(frames, count, at, head)
            return packed
        digits = head + frames[at:-1].decode().replace("\n" + begin.decode(), head)
        contents = bytes.fromhex(digits)
        width = len(contents) // count
        stuffed = [_stuffed(contents[start : start + width]) for start in range(0, len(contents), width)]
        return START + (END + START).join(stuffed) + END

    def _head(self, frame: bytes) -> tuple[str, int]:
        """Return the number of the command of a frame and what fills up, and where the digits begin; or nothing."""
        at = self._prefix_size
        size = 2 if len(frame) > at + 1 and frame[at + 1] >= _FIRST_LETTER else 1
        return self._heads.get(frame[at : at + size], ""), at + size

    def pack_one(self, frame: bytes) -> bytes:
        """Return one frame in compact form if it has one, and as it is otherwise."""
        head, at = self._head(frame)
        digits = frame[1 : self._prefix_size] + head.encode() + frame[at:-1]
        if not head or frame[-1:] != b"\n" or (self._prefix_size and frame[:1] != b"Z"):
            return frame
        if len(digits) % 2 or digits.translate(None, _DIGITS):
            return frame
        return START + _stuffed(bytes.fromhex(digits.decode())) + self._end


class Unpacker:
    """Makes text of what arrives in both forms.

    The text of a cut frame (docs/protocol.md, "Cut frames") ends in the byte of an end and LF, so its check fails.

    Args:
        form: of the frames in this direction.
    """

    def __init__(self, form: CompactForm) -> None:
        self._commands = [(command, 1 + len(fill)) for command, fill in form.heads()]
        """Letters for each number of a command, and how many digits stand for them."""
        self._has_node = form.has_node
        self.reset()

    def reset(self) -> None:
        """Forget what has begun."""
        self._begun = b""
        """A compact frame without its end, from its start on."""
        self._in_line = False
        """True behind text without its line end."""
        self._behind_end = False
        """True right behind an end."""

    @property
    def begins_answer(self) -> bool:
        """Return whether the beginning of a frame that is no sample has come, perhaps of a long one on a slow line."""
        at = 1 + self._has_node
        return len(self._begun) > at and self._begun[at] >> 4 != _SAMPLE

    def unpack_whole(self, data: bytes) -> bytes:
        """Return the text of what is one frame, nothing where it is not, or something has come before, and of nodes."""
        if self._begun or self._in_line or self._has_node:
            return b""
        if data.isascii():
            return data
        return self._text_of_few(data) if data.count(END) == 1 else b""

    def unpack(self, data: bytes) -> bytes:
        """Return the text of what has arrived; a compact frame comes with its end."""
        if self._has_node and data:
            data = self._without_line_ends(data)
        if self._begun:
            data = self._begun + data
            self._begun = b""
        elif data.isascii():
            if data:
                self._in_line = data[-1] not in b"\n\r"
            return data
        if self._in_line or not data.startswith(START):
            return b"".join(self._pieces(data))
        # A line end may stand behind frames; only whole ones are taken together.
        end = data.find(b"\n")
        whole = data[: data.rfind(END, 0, len(data) if end < 0 else end) + 1]
        text = self._text_of_frames(whole)
        return b"".join((text, *self._pieces(data[len(whole) :] if text else data)))

    def _without_line_ends(self, data: bytes) -> bytes:
        """Return what has arrived without the line ends behind ends: on a shared medium they belong to frames."""
        if self._behind_end:
            data = data.removeprefix(b"\n")
        self._behind_end = data.endswith(END)
        return data.replace(END + b"\n", END)

    def _text_of_frames(self, data: bytes) -> bytes:
        """Return the text of compact frames side by side; nothing where they are not that, or not whole."""
        size = len(data) + EACH * data.count(START)
        if size < MANY or self._has_node or b"\n" in data or b"\r" in data:
            return self._text_of_few(data)
        text, size = _rows().unpack(data, self._commands)
        if size in (0, len(data)):
            return bytes(text) or self._text_of_few(data)
        others = self._text_of_few(data[size:])
        return text + others if others else b""

    def _text_of_few(self, data: bytes) -> bytes:
        """Return the same as `_text_of_frames`, by way of their contents one by one."""
        count = data.count(START)
        if data[:1] != START or data[-1:] != END or data.count(END) != count or b"\n" in data or b"\r" in data:
            return b""
        if ESCAPE + END in data:
            # Perhaps an escape without its byte, which cuts the frame.
            return b""
        if count == 1:
            return self._text(data[1:-1]) + b"\n"
        if self._has_node or data.count(END + START) != count - 1:
            return b""
        contents = data[1:-1].split(END + START)
        if ESCAPE in data:
            contents = [_unstuffed(content) if ESCAPE in content else content for content in contents]
        return "\n".join([*map(self._line, contents), ""]).encode()

    def _line(self, content: bytes) -> str:
        """Return the text of a frame of no node without its line end, given its bytes without escapes."""
        if not content:
            return ""
        command, after = self._commands[content[0] >> 4]
        return command + content.hex().upper()[after:]

    def _pieces(self, data: bytes) -> Iterable[bytes]:
        at = 0
        while at < len(data):
            if data[at] == START[0] and self._in_line:
                yield _CUT
                self._in_line = False
            found = _PIECE.match(data, at)
            if found is None:
                # The end is still to come. Noise without an end must not grow: give its text now, which is longer than
                # any frame. Later bytes continue that text as the rest of a sample, for which no request waits.
                self._begun = data[at:]
                if len(self._begun) > LONGEST_FRAME:
                    yield self._text(self._begun[1:])
                    self._begun = _REST_OF_A_SAMPLE
                return
            at = found.end()
            if data[found.start()] == START[0]:
                is_whole = found[2] == END and not _ends_in_escape(found[1])
                yield self._text(found[1]) + (b"\n" if is_whole else _CUT)
                at -= found[2] == START
            else:
                yield found[0] + b"\n" if found[4] else found[0]
                self._in_line = not (found[3] or found[4])

    def _text(self, content: bytes) -> bytes:
        """Return the text of what stands between start and end, without its line end."""
        if ESCAPE in content:
            content = _unstuffed(content)
        prefix = ""
        if self._has_node and content:
            prefix, content = f"Z{content[0]:02X}", content[1:]
        return (prefix + self._line(content)).encode()


def text_of(info: GatewayInfo, *, from_gateway: bool) -> Callable[[bytes], bytes]:
    """Return a function that makes text of the bytes of one direction as they arrive, as a gateway's features ask."""
    if Feature.COMPACT not in info.features:
        return bytes
    return Unpacker(CompactForm.of(info, from_gateway=from_gateway)).unpack


def cut(data: bytes) -> list[bytes]:
    """Return the whole frames of both forms, each with its end."""
    return _FRAME.findall(data)


def is_sample(frame: bytes, prefix: bytes) -> bool:
    """Return whether a frame of a gateway, in either form, is a sample; `prefix` is that of its text."""
    # Behind its number a sample has a digit that fills up, whatever the widths are.
    return frame.startswith((prefix + b"P", START + _stuffed(bytes.fromhex(prefix[1:].decode())) + b"\xf0"))


def _rows() -> ModuleType:
    """Return the module that takes frames together, which needs numpy."""
    from unity_link.protocol.wire import compact_rows

    return compact_rows


def _stuffed(content: bytes) -> bytes:
    """Return bytes with their escapes."""
    if len(content.translate(None, RESERVED)) != len(content):
        for byte, stuffed in _STUFFING:
            content = content.replace(byte, stuffed)
    return content


def _ends_in_escape(content: bytes) -> bool:
    """Return whether the last byte is an escape, whose byte has not come; one that is escaped itself is none."""
    return bool((len(content) - len(content.rstrip(ESCAPE))) % 2)


def _unstuffed(content: bytes) -> bytes:
    """Return bytes without their escapes."""
    before, *others = content.split(ESCAPE)
    if b"" not in others:
        return before + b"".join([_PLAIN[part[0]] + part[1:] for part in others])
    # An escape follows another one, or nothing follows: the sender was no packer, or the line damaged the frame.
    return _ESCAPED.sub(lambda pair: bytes(byte ^ STUFFED for byte in pair[1]), content)
