"""A gateway as docs/protocol.md describes it, written from the page alone: text, compact and cut frames.

This module imports no product code, so that tests can compare the two. It models plain memory, sessions and
repetitions. Groups are not supported: a valid `GS` raises `NotImplementedError`.
"""

from __future__ import annotations

import re
from typing import NamedTuple

START, END, ESCAPE, LF, CR = 0xB5, 0xCA, 0xD3, 0x0A, 0x0D
NUMBERED = ["r", "rm", "rq", "w", "wm", "wq", "wk", "ws", "h", "gn", "gx", "gp", "i", "n", "x", "P"]
"""Commands that have a compact form; the index of each is its number in that form."""
WITH_ADDRESS = ("r", "rm", "rq", "w", "wm", "wq", "wk", "ws")
LOOKING = ("R", "RM", "H", "Q", "K")
CRC, UNKNOWN, MALFORMED, RANGE, LONG, NO_SESSION, UNDER_WAY = 1, 2, 3, 6, 7, 0x0A, 0x0B
HEX = re.compile(r"[0-9A-Fa-f]*")


class Frame(NamedTuple):
    """The text between two ends."""

    text: str
    plain: bool


class Widths(NamedTuple):
    """The fields of `Q` that determine the form of frames."""

    id_digits: int = 3
    crc_bits: int = 16
    polynomial: int = 0x1021
    address_digits: int = 2
    data_digits: int = 8
    block_words: int = 255
    group_words: int = 32
    groups: int = 16
    node: int | None = None
    compact: bool = True

    @property
    def crc_digits(self) -> int:
        """Digits of a CRC."""
        return self.crc_bits // 4

    @property
    def session_digits(self) -> int:
        """Digits of the number of a session."""
        return 2 if self.crc_bits == 8 else 4

    @property
    def ring(self) -> int:
        """Number of IDs."""
        return 1 << 4 * self.id_digits

    @property
    def prefix(self) -> str:
        """Beginning of an addressed frame."""
        return "" if self.node is None else f"Z{self.node:02X}"

    @property
    def longest(self) -> int:
        """Characters of the longest checked request, CRC included."""
        head = 2 + self.id_digits + self.address_digits
        fields = [2, self.data_digits * self.block_words, 2 * self.data_digits]
        group = 2 + self.id_digits + 10 + self.address_digits * self.group_words if self.groups else 0
        return max(head + max(fields), group) + self.crc_digits

    def crc(self, text: str, seed: int = 0) -> int:
        """Return the CRC of a text; the seed is xored in before the first character after the prefix."""
        top, mask = 1 << self.crc_bits - 1, (1 << self.crc_bits) - 1
        rest = 0
        for place, character in enumerate(text):
            if place == len(self.prefix):
                rest ^= seed
            rest ^= ord(character) << self.crc_bits - 8
            for _ in range(8):
                rest = (rest << 1 ^ (self.polynomial if rest & top else 0)) & mask
        return rest

    def spare(self, command: str, *, from_gateway: bool) -> bool:
        """Return true if a frame of a command has a spare digit after the command's number."""
        digits = 1 + self.crc_digits + (0 if command == "P" else self.id_digits)
        if command in WITH_ADDRESS and not from_gateway:
            digits += self.address_digits
        if command == "h" and from_gateway:
            digits += self.id_digits
        return digits % 2 == 1

    def pack(self, text: str, *, from_gateway: bool) -> bytes:
        """Return a checked frame, given without LF, in compact form if its command has one, otherwise as text."""
        body = text[len(self.prefix) :]
        command = next((body[:size] for size in (2, 1) if body[:size] in NUMBERED), "")
        digits = ""
        if command:
            digits = text[1 : len(self.prefix)] + f"{NUMBERED.index(command):X}"
            digits += "0" * self.spare(command, from_gateway=from_gateway) + body[len(command) :]
        if not command or len(digits) % 2 or not HEX.fullmatch(digits):
            return text.encode("latin-1") + b"\n"
        packed = bytearray((START,))
        for byte in bytes.fromhex(digits):
            if byte in (START, END, ESCAPE, LF, CR):
                packed += bytes((ESCAPE, byte ^ 0x40))
            else:
                packed.append(byte)
        packed.append(END)
        return bytes(packed) + b"\n" * (self.node is not None)


class Cutter:
    """Cuts the bytes of one direction into frames."""

    def __init__(self, widths: Widths, *, from_gateway: bool) -> None:
        self._widths, self._from_gateway = widths, from_gateway
        self._text = ""
        self._content: bytearray | None = None
        self._escaped = False

    def take(self, data: bytes) -> list[Frame]:
        """Return the frames that the given bytes end, including empty ones."""
        return [frame for byte in data for frame in self._take(byte)]

    def _take(self, byte: int) -> list[Frame]:
        if byte == START and self._widths.compact:
            frames = [self._cut()] if self._content is not None or self._text else []
            self._content = bytearray()
            return frames
        return self._take_text(byte) if self._content is None else self._take_content(self._content, byte)

    def _take_text(self, byte: int) -> list[Frame]:
        if byte in (LF, CR):
            return [self._ended(plain=byte == CR)]
        if byte == END and self._widths.compact:
            return [self._cut()]
        self._text += chr(byte)
        return []

    def _take_content(self, content: bytearray, byte: int) -> list[Frame]:
        if byte in (LF, CR) or (byte == END and self._escaped):
            return [self._cut()]
        if byte == END:
            return [self._ended(plain=False)]
        if byte == ESCAPE and not self._escaped:
            self._escaped = True
            return []
        content.append(byte ^ 0x40 if self._escaped else byte)
        self._escaped = False
        return []

    def _cut(self) -> Frame:
        return self._ended(plain=False, more=chr(END))

    def _ended(self, *, plain: bool, more: str = "") -> Frame:
        text = self._text if self._content is None else self._expanded(bytes(self._content))
        self._text, self._content, self._escaped = "", None, False
        return Frame(text + more, plain)

    def _expanded(self, content: bytes) -> str:
        prefix = ""
        if self._widths.node is not None and content:
            prefix, content = f"Z{content[0]:02X}", content[1:]
        if not content:
            return prefix
        command = NUMBERED[content[0] >> 4]
        spare = self._widths.spare(command, from_gateway=self._from_gateway)
        return prefix + command + content.hex().upper()[1 + spare :]


class RefusalError(Exception):
    """An error that the gateway sends instead of an answer."""

    def __init__(self, code: int, id_: str = "", rest: str = "") -> None:
        super().__init__(code)
        self.body = f"x{id_}{code:02X}{rest}" if id_ else f"X{code:02X}"


class GatewayOnThePage:
    """The gateway.

    Args:
        widths: widths of its frames.
        configuration: the answer to `Q`, without its letter.
    """

    def __init__(self, widths: Widths = Widths(), configuration: str = "") -> None:  # noqa: B008  (it cannot change)
        self.widths = widths
        self._configuration = configuration
        self._cutter = Cutter(widths, from_gateway=False)
        self.memory: dict[int, int] = {}
        self.session = self.asked = 0
        self.expected = 0
        self.for_program = False
        self._gap_told = False
        self._outcomes: dict[int, int] = {}
        self._kept: dict[int, int] = {}

    @property
    def seed(self) -> int:
        """Seed of the CRC in the host's frames of the session."""
        return 2 * self.session

    def answers(self, data: bytes) -> list[bytes]:
        """Return the answers to some bytes, each with its line end."""
        return [answer for frame in self._cutter.take(data) for answer in self._answer(frame)]

    # Frames

    def _answer(self, frame: Frame) -> list[bytes]:
        widths = self.widths
        text, prefix = frame.text, widths.prefix
        to_all = False
        if prefix:
            if text[:3].upper() not in (prefix, "ZFF") or text[:1] != "Z":
                return []
            to_all = text[:3].upper() == "ZFF"
            prefix, text = text[:3], text[3:]
        if not text:
            return []
        try:
            body = self._read(prefix, text, plain=frame.plain, to_all=to_all)
        except RefusalError as refusal:
            body = refusal.body
        return [self._framed(body, plain=frame.plain)] if body and not to_all else []

    def _framed(self, body: str, *, plain: bool) -> bytes:
        prefix = self.widths.prefix
        if plain:
            return f"{prefix}{body}\r\n".encode()
        seed = 2 * self.session + 1 if self.session and (body[0].islower() or body[0] == "P") else 0
        if body[0] == "x" and len(body) > 3 + self.widths.id_digits:
            # An error for lack of a session has no seed.
            seed = 0
        check = self.widths.crc(prefix + body, seed)
        text = f"{prefix}{body}{check:0{self.widths.crc_digits}X}"
        if self.asked != self.session:
            return self.widths.pack(text, from_gateway=True)
        return text.encode() + b"\n"

    def _opened(self, prefix: str, text: str, *, plain: bool) -> tuple[str, int]:
        """Apply checks 2 and 3; return the text without its CRC, and the difference of the CRC."""
        widths = self.widths
        if len(text) > widths.longest:
            raise RefusalError(LONG)
        if plain:
            return text, 0
        body, check = text[: -widths.crc_digits], text[-widths.crc_digits :]
        if len(check) < widths.crc_digits or not HEX.fullmatch(check):
            raise RefusalError(CRC)
        small = "a" <= body[:1] <= "z"
        residue = widths.crc(prefix + body, self.seed if small else 0) ^ int(check, 16)
        if residue and not (small and not self.session):
            raise RefusalError(CRC)
        return body, residue

    def _parted(self, body: str, *, plain: bool) -> tuple[str, str, list[int]]:
        """Apply checks 4 and 5; return the command in upper case, the ID (empty without one) and the fields."""
        letters = re.match("[G-Zg-z]*", body)
        command = letters[0] if letters else ""
        has_id = command.islower()
        name = command.upper()
        if name not in FORMS or (has_id and name in "QK") or command not in (name, name.lower()):
            raise RefusalError(UNKNOWN)
        rest = body[len(command) :]
        id_ = rest[: self.widths.id_digits].upper() if has_id else ""
        if not HEX.fullmatch(rest) or len(id_) < self.widths.id_digits * has_id:
            raise RefusalError(MALFORMED)
        return name, id_, self._fields(name, rest[len(id_) :], short=plain and not has_id)

    def _read(self, prefix: str, text: str, *, plain: bool, to_all: bool) -> str:
        """Apply the checks in the order of the page; return the body of the answer."""
        body, residue = self._opened(prefix, text, plain=plain)
        name, id_, fields = self._parted(body, plain=plain)
        if to_all:
            if name == "WS" and not id_ and not (plain and self.for_program):
                self._execute(name, fields)
            return ""
        if self.for_program and (plain if id_ else name not in LOOKING):
            raise RefusalError(UNDER_WAY, id_)
        if id_:
            return self._in_order(name, id_, fields, residue)
        if name == "K":
            return self._k(fields, body[1:], plain=plain)
        answer = self._execute(name, fields)
        return "" if name == "WS" else self._head(name, fields) + answer

    def _head(self, name: str, fields: list[int]) -> str:
        """Return the beginning of the answer to a request without an ID."""
        said = name + "".join(self._written(name, fields)[: {"R": 1, "RM": 2, "RQ": 2}.get(name, name[0] == "W")])
        if name in ("WM", "WQ"):
            said += f"{len(fields) - 1:02X}"
        if name[0] in "GI":
            said += f"{fields[0]:02X}"
        return said

    def _written(self, name: str, fields: list[int]) -> list[str]:
        widths = [self.widths.address_digits, *([2] if name[:2] in ("RM", "RQ") else [])]
        return [f"{field:0{width}X}" for field, width in zip(fields, widths, strict=False)]

    def _fields(self, name: str, digits: str, *, short: bool) -> list[int]:
        widths = self.widths
        a, d = widths.address_digits, widths.data_digits
        sizes: list[int]
        match name:
            case "WM" | "WQ":
                words, odd = divmod(len(digits) - a, d)
                if odd or not 1 <= words <= 255:
                    raise RefusalError(MALFORMED)
                sizes = [a, *[d] * words]
            case "W" | "WS" if short:
                if not a < len(digits) <= a + d:
                    raise RefusalError(MALFORMED)
                sizes = [a, len(digits) - a]
            case "K":
                sizes = [widths.id_digits, widths.session_digits] if digits else []
            case "GS":
                count = int(digits[8:10], 16) if len(digits) >= 10 else 0
                sizes = [2, 2, 4, 2, *[a] * count]
            case _:
                sizes = [{"a": a, "d": d, "2": 2}[letter] for letter in FORMS[name]]
        if sum(sizes) != len(digits):
            raise RefusalError(MALFORMED)
        fields, at = [], 0
        for size in sizes:
            fields.append(int(digits[at : at + size], 16))
            at += size
        return fields

    # Sessions

    def _k(self, fields: list[int], digits: str, *, plain: bool) -> str:
        size = self.widths.session_digits
        if not fields:
            return f"K{self.asked:0{size}X}"
        first, asked = fields
        high = 1 << 4 * size - 1
        number = asked & high - 1
        if self.session and number == self.session:
            raise RefusalError(UNDER_WAY)
        if number == 0 or (asked & high and not self.widths.compact):
            raise RefusalError(RANGE)
        ended, self.asked, self.session, self.expected = self.asked, asked, number, first
        self.for_program, self._gap_told = not plain, False
        return f"K{digits.upper()}{ended:0{size}X}"

    def _in_order(self, name: str, id_: str, fields: list[int], residue: int) -> str:
        widths = self.widths
        if not self.session:
            raise RefusalError(NO_SESSION, id_, f"{residue:0{widths.crc_digits}X}")
        number = int(id_, 16)
        ahead = (number - self.expected) % widths.ring
        if 0 < ahead < widths.ring // 2:
            told, self._gap_told = self._gap_told, True
            return "" if told else f"n{self.expected:0{widths.id_digits}X}"
        said = name.lower() + id_
        place = number % (widths.ring // 2)
        if ahead:
            if outcome := self._outcomes.get(place, 0):
                raise RefusalError(outcome, id_)
            return self._again(name, said, fields, number)
        self.expected, self._gap_told = (number + 1) % widths.ring, False
        self._outcomes[place] = 0
        try:
            answer = self._execute(name, fields)
        except RefusalError as refusal:
            self._outcomes[place] = int(refusal.body[1:3], 16)
            raise RefusalError(self._outcomes[place], id_) from None
        if name in ("RQ", "WK"):
            for at in range(0, len(answer), widths.data_digits):
                kept = int(answer[at : at + widths.data_digits], 16)
                self._kept[(number + at // widths.data_digits) % 256] = kept
        if name == "H":
            answer = "0" * widths.id_digits
        return "" if name == "WS" else said + answer

    def _again(self, name: str, said: str, fields: list[int], number: int) -> str:
        """Return the answer to a repetition of a request that succeeded."""
        widths = self.widths
        if name in ("R", "RM"):
            try:
                return said + self._execute(name, fields)
            except RefusalError as refusal:
                raise RefusalError(int(refusal.body[1:3], 16), said[len(name) :]) from None
        if name == "WS":
            return ""
        if name == "H":
            return said + "0" * widths.id_digits
        count = 1 if name == "WK" else fields[1] if name == "RQ" else 0
        if name == "RQ" and not 1 <= count <= widths.block_words:
            raise RefusalError(RANGE, said[len(name) :])
        places = [(number + place) % 256 for place in range(count)]
        return said + "".join(f"{self._kept.get(place, 0):0{widths.data_digits}X}" for place in places)

    # Execution: addresses and words use all bits of their digits.

    def _execute(self, name: str, fields: list[int]) -> str:
        widths, memory = self.widths, self.memory
        wrap = 16**widths.address_digits
        words: list[int] = []
        match name, fields:
            case "R", [address]:
                words = [memory.get(address, 0)]
            case (("RM" | "RQ"), [address, count]):
                self._check(1 <= count <= widths.block_words)
                step = name == "RM"
                words = [memory.get((address + step * place) % wrap, 0) for place in range(count)]
            case (("W" | "WS"), [address, word]):
                memory[address] = word
            case (("WM" | "WQ"), [address, *written]):
                self._check(len(written) <= widths.block_words)
                for place, word in enumerate(written):
                    memory[(address + (name == "WM") * place) % wrap] = word
            case "WK", [address, mask, word]:
                words = [memory.get(address, 0)]
                memory[address] = words[0] & ~mask | word & mask
            case "GS", _:
                self._set_up(*fields[:4])
            case "I", [mode]:
                self._check(mode <= 2)
            case _:
                # `GN`, `GX` and `GP` fail because the group was never set up.
                self._check(name[0] != "G")
        return self._configuration if name == "Q" else "".join(f"{word:0{widths.data_digits}X}" for word in words)

    def _set_up(self, group: int, flags: int, divisor: int, count: int) -> None:
        known = 0x1F if self.for_program else 0x3F
        fits = group < self.widths.groups and not flags & ~known and divisor and 1 <= count <= self.widths.group_words
        if fits:
            raise NotImplementedError("a group is set up")
        raise RefusalError(RANGE)

    def _check(self, is_within: bool) -> None:
        """Apply check 7."""
        if not is_within:
            raise RefusalError(RANGE)


FORMS = {
    "R": "a",
    "RM": "a2",
    "RQ": "a2",
    "W": "ad",
    "WM": "",
    "WQ": "",
    "WK": "add",
    "WS": "ad",
    "GS": "",
    "GN": "2",
    "GX": "2",
    "GP": "2",
    "I": "2",
    "H": "",
    "Q": "",
    "K": "",
}
"""Fields of each command after its ID: an address, a word, or two digits; some commands have variable fields."""
