"""The compact form of frames (docs/protocol.md, "The compact form"): two hex digits in each byte.

- A compact frame is START, its content, and END. If the content has one of these bytes, ESCAPE, LF or CR, it is sent as
  ESCAPE and the byte xored with STUFFED.
- The content is the number of the command (one digit), a padding digit 0 if the number of digits would be odd, and the
  other digits of the text with its CRC. In an addressed frame, the number of the node comes first (one byte).
- Both forms may be mixed. All other modules use text, so this module converts between the two.

Consecutive frames are converted together: END and START meet between them. Many frames of one command and one length
are converted by numpy (`unity_link.protocol.wire.compact_rows`).
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
"""Commands that have a compact form; the number of a command is its index."""
MANY_BYTES: Final = 1024
"""Fewest bytes in compact form for which packing by numpy is faster."""
MANY: Final = 8192
"""Fewest bytes for which unpacking by numpy is faster; each frame counts as `EACH` additional bytes."""
EACH: Final = 100
_ADDRESSED: Final = frozenset(("r", "rm", "rq", "w", "wm", "wq", "wk", "ws"))
"""Commands whose requests contain an address."""
_STUFFING: Final = [(bytes((byte,)), ESCAPE + bytes((byte ^ STUFFED,))) for byte in ESCAPE + RESERVED[:-1]]
"""Reserved bytes and their escaped forms. ESCAPE comes first, because the escaped forms of the others contain it."""
_PLAIN: Final = [bytes((byte ^ STUFFED,)) for byte in range(256)]
"""The original byte for each byte that follows ESCAPE."""
_SAMPLE: Final = COMMANDS.index("P")
_REST_OF_A_SAMPLE: Final = START + b"\xf0"
_FIRST_LETTER: Final = ord("g")
_ESCAPED = re.compile(rb"\xd3(.?)", re.DOTALL)
_CUT: Final = END + b"\n"
"""End of the text of a cut frame: a character that is no hex digit, so that the CRC is wrong, and the line end."""
_DIGITS: Final = b"0123456789ABCDEF"
_FRAME = re.compile(rb"\xb5[^\n\r\xb5\xca]*\xca\n?|[^\n\xb5\xca]*\n")
_PIECE = re.compile(rb"\xb5([^\n\r\xb5\xca]*)([\n\r\xb5\xca])|([\n\r])|(\xca)|[^\n\r\xb5\xca]+")


@dataclasses.dataclass(frozen=True)
class CompactForm:
    """Widths of the frames of one direction, on which it depends if a command has a padding digit.

    Words have an even number of digits in each gateway with the compact form.
    """

    id_digits: int
    crc_digits: int
    address_digits: int
    from_gateway: bool
    """True for the frames that a gateway sends, False for those of a host."""
    has_node: bool = False
    """True for addressed frames: the first byte of the content is the number of the node."""

    @classmethod
    def of(cls, info: GatewayInfo, *, from_gateway: bool) -> CompactForm:
        """Return the form of the frames that a gateway sends, or receives."""
        has_node = Feature.ADDRESSED in info.features
        return cls(info.id_digits, info.crc_bits // 4, info.address_digits, from_gateway, has_node)

    def is_filled(self, command: str) -> bool:
        """Return whether a padding digit 0 follows the number of a command, so that the number of digits is even."""
        digits = 1 + self.crc_digits
        if command != "P":
            digits += self.id_digits
        if command in _ADDRESSED and not self.from_gateway:
            digits += self.address_digits
        if command == "h" and self.from_gateway:
            digits += self.id_digits
        return digits % 2 == 1

    def heads(self) -> list[tuple[str, str]]:
        """Return the letters of each command and its padding digit, "0" or "", in order of the commands' numbers."""
        return [(command, "0" if self.is_filled(command) else "") for command in COMMANDS]


class Packer:
    """Converts frames from text to the compact form.

    Args:
        form: form of the frames in this direction.
    """

    def __init__(self, form: CompactForm) -> None:
        self._heads = {command.encode(): f"{number:X}{fill}" for number, (command, fill) in enumerate(form.heads())}
        self._prefix_size = 3 if form.has_node else 0
        # On a shared medium LF follows, because nodes without the compact form find the end of a frame by LF alone.
        self._end = END + b"\n" if form.has_node else END

    def pack(self, frames: bytes) -> bytes:
        """Convert complete frames; frames of commands without a compact form stay text."""
        if frames.find(b"\n") == len(frames) - 1:
            return self.pack_one(frames)
        packed = self._pack_equal(frames)
        if packed:
            return packed
        groups = [[*group] for _, group in groupby(frames.splitlines(keepends=True), len)]
        return b"".join([self._pack_equal(b"".join(group)) or b"".join(map(self.pack_one, group)) for group in groups])

    def _pack_equal(self, frames: bytes) -> bytes:
        """Convert two or more frames of one command and one length; return nothing if they differ in these."""
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
        """Return the hex digit of a frame's command with the padding digit, and the offset of the other digits.

        The digits are empty if the command has no compact form.
        """
        at = self._prefix_size
        size = 2 if len(frame) > at + 1 and frame[at + 1] >= _FIRST_LETTER else 1
        return self._heads.get(frame[at : at + size], ""), at + size

    def pack_one(self, frame: bytes) -> bytes:
        """Convert one frame; return it unchanged if it has no compact form."""
        head, at = self._head(frame)
        digits = frame[1 : self._prefix_size] + head.encode() + frame[at:-1]
        if not head or frame[-1:] != b"\n" or (self._prefix_size and frame[:1] != b"Z"):
            return frame
        if len(digits) % 2 or digits.translate(None, _DIGITS):
            return frame
        return START + _stuffed(bytes.fromhex(digits.decode())) + self._end


class Unpacker:
    """Converts received bytes in both forms to text.

    The text of a cut frame (docs/protocol.md, "Cut frames") ends in END and LF, so that its CRC is wrong.

    Args:
        form: form of the frames in this direction.
    """

    def __init__(self, form: CompactForm) -> None:
        self._commands = [(command, 1 + len(fill)) for command, fill in form.heads()]
        """By the number of a command: its letters, and the number of hex digits that encode them."""
        self._has_node = form.has_node
        self.reset()

    def reset(self) -> None:
        """Drop incomplete frames."""
        self._begun = b""
        """The incomplete compact frame at the end of the received bytes, from its START on."""
        self._in_line = False
        """True if the received bytes end within a line of text."""
        self._after_end = False
        """True if the received bytes end with END."""

    @property
    def begins_answer(self) -> bool:
        """True if an incomplete compact frame has arrived that is not a sample: an answer on a slow line."""
        at = 1 + self._has_node
        return len(self._begun) > at and self._begun[at] >> 4 != _SAMPLE

    def unpack_whole(self, data: bytes) -> bytes:
        """Return the text of `data` if it is exactly one frame and no incomplete frame precedes it.

        Otherwise, and for addressed frames, return nothing; then `unpack` converts it.
        """
        if self._begun or self._in_line or self._has_node:
            return b""
        if data.isascii():
            return data
        return self._text_of_few(data) if data.count(END) == 1 else b""

    def unpack(self, data: bytes) -> bytes:
        """Convert received bytes; an incomplete compact frame is kept until its END arrives."""
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
        # A line end may follow the frames. Convert the complete frames together, and the rest piece by piece.
        end = data.find(b"\n")
        whole = data[: data.rfind(END, 0, len(data) if end < 0 else end) + 1]
        text = self._text_of_frames(whole)
        return b"".join((text, *self._pieces(data[len(whole) :] if text else data)))

    def _without_line_ends(self, data: bytes) -> bytes:
        """Remove the LF after each END: on a shared medium it belongs to the compact frame."""
        if self._after_end:
            data = data.removeprefix(b"\n")
        self._after_end = data.endswith(END)
        return data.replace(END + b"\n", END)

    def _text_of_frames(self, data: bytes) -> bytes:
        """Return the text of consecutive compact frames, or nothing if `data` is not a sequence of complete ones."""
        size = len(data) + EACH * data.count(START)
        if size < MANY or self._has_node or b"\n" in data or b"\r" in data:
            return self._text_of_few(data)
        text, size = _rows().unpack(data, self._commands)
        if size in (0, len(data)):
            return bytes(text) or self._text_of_few(data)
        others = self._text_of_few(data[size:])
        return text + others if others else b""

    def _text_of_few(self, data: bytes) -> bytes:
        """Return the same as `_text_of_frames`, without numpy."""
        count = data.count(START)
        if data[:1] != START or data[-1:] != END or data.count(END) != count or b"\n" in data or b"\r" in data:
            return b""
        if ESCAPE + END in data:
            # An ESCAPE without its byte cuts a frame; `_pieces` handles that.
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
        """Return the text of a frame without its line end and node, given its content without escapes."""
        if not content:
            return ""
        command, after = self._commands[content[0] >> 4]
        return command + content.hex().upper()[after:]

    def _pieces(self, data: bytes) -> Iterable[bytes]:
        """Convert received bytes piece by piece: compact frames, complete and cut, and text."""
        at = 0
        while at < len(data):
            if data[at] == START[0] and self._in_line:
                yield _CUT
                self._in_line = False
            found = _PIECE.match(data, at)
            if found is None:
                # END has not arrived. If these bytes are longer than any frame, they are noise: return their text now,
                # so that they do not fill the memory. The following bytes continue as the rest of a sample, because no
                # request waits for a sample.
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
        """Return the text of the content of a frame, without its line end."""
        if ESCAPE in content:
            content = _unstuffed(content)
        prefix = ""
        if self._has_node and content:
            prefix, content = f"Z{content[0]:02X}", content[1:]
        return (prefix + self._line(content)).encode()


def text_of(info: GatewayInfo, *, from_gateway: bool) -> Callable[[bytes], bytes]:
    """Return a function that converts the bytes of one direction to text, as they arrive.

    It returns them unchanged if the gateway has no compact form.
    """
    if Feature.COMPACT not in info.features:
        return bytes
    return Unpacker(CompactForm.of(info, from_gateway=from_gateway)).unpack


def cut(data: bytes) -> list[bytes]:
    """Return the complete frames in `data`, in both forms, each with its end."""
    return _FRAME.findall(data)


def is_sample(frame: bytes, prefix: bytes) -> bool:
    """Return whether a frame of a gateway, in either form, is a sample.

    Args:
        frame: the frame.
        prefix: prefix of the node in text frames, empty without one.
    """
    # In compact form a sample always has a padding digit: its digits without it are odd for all widths.
    return frame.startswith((prefix + b"P", START + _stuffed(bytes.fromhex(prefix[1:].decode())) + b"\xf0"))


def _rows() -> ModuleType:
    """Import and return the module that needs numpy."""
    from unity_link.protocol.wire import compact_rows

    return compact_rows


def _stuffed(content: bytes) -> bytes:
    """Return the content of a frame with its reserved bytes escaped."""
    if len(content.translate(None, RESERVED)) != len(content):
        for byte, stuffed in _STUFFING:
            content = content.replace(byte, stuffed)
    return content


def _ends_in_escape(content: bytes) -> bool:
    """Return whether the content ends in an ESCAPE without its byte; an escaped ESCAPE does not count."""
    return bool((len(content) - len(content.rstrip(ESCAPE))) % 2)


def _unstuffed(content: bytes) -> bytes:
    """Return the content of a frame with its escapes resolved."""
    before, *others = content.split(ESCAPE)
    if b"" not in others:
        return before + b"".join([_PLAIN[part[0]] + part[1:] for part in others])
    # An ESCAPE follows another one, or ends the content. No `Packer` sends that, but damage can cause it.
    return _ESCAPED.sub(lambda pair: bytes(byte ^ STUFFED for byte in pair[1]), content)
