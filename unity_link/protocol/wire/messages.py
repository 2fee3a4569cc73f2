"""The messages of the protocol: requests and responses, for any widths that `Q` can report.

`COMMANDS` is the table of docs/protocol.md, "Requests and responses". A `Codec` encodes and decodes these messages with
the widths of one gateway, in both directions: the host and the simulated gateway use it.

Letters of fields, as in docs/protocol.md:

    =====  ===================================  =====  ===================================================
    ``a``  address                              ``s``  mode
    ``d``  data word                            ``i``  ID
    ``m``  mask                                 ``k``  session
    ``n``  count                                ``b``  session that ended
    ``g``  group                                ``c``  number of posted writes that failed
    ``f``  flags of a group                     ``e``  error code
    ``v``  divisor of a group                   ``r``  residue of the CRC, after error 0A
    ``D``  all words to the end of the message  ``A``  all addresses to the end of the message
    =====  ===================================  =====  ===================================================
"""

from __future__ import annotations

import enum
import functools
import re
import struct
from binascii import hexlify, unhexlify
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.protocol import wire
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray


class Repeat(enum.Enum):
    """A gateway's answer to a request that it has executed before (docs/protocol.md, "Exactly once, in order")."""

    READ_AGAIN = enum.auto()
    """Read the bus again, and answer with the new words."""
    KEPT = enum.auto()
    """Answer with the words of the first execution, which the gateway stores."""
    ACKNOWLEDGE = enum.auto()
    """Answer without a bus access."""
    SILENCE = enum.auto()
    """Send no answer."""


class Command(NamedTuple):
    """One row of the table of messages. Fields are given by their letters."""

    fields: str
    """Fields of the request."""
    echo: str = ""
    """Fields of the request that a response without an ID repeats."""
    reads: str = ""
    """Fields that the gateway adds to the response."""
    repetition: Repeat = Repeat.ACKNOWLEDGE
    feature: Feature = Feature(0)
    """Feature that the gateway must have for this command; 0 for none."""
    reports: str = ""
    """Fields that the gateway adds to a response with an ID only."""

    def response(self, *, with_id: bool) -> str:
        """Return the letters of the fields of a response."""
        return self.reads + self.reports if with_id else self.echo + self.reads


COMMANDS: dict[str, Command] = {
    "R": Command("a", "a", "d", Repeat.READ_AGAIN),
    "RM": Command("an", "an", "D", Repeat.READ_AGAIN),
    "RQ": Command("an", "an", "D", Repeat.KEPT, Feature.QUEUE_COMMANDS),
    "W": Command("ad", "a"),
    "WM": Command("aD", "an"),
    "WQ": Command("aD", "an", feature=Feature.QUEUE_COMMANDS),
    "WK": Command("amd", "a", "d", Repeat.KEPT, Feature.MASKED_WRITE),
    "WS": Command("ad", repetition=Repeat.SILENCE),
    "GS": Command("gfvnA", "g", feature=Feature.GROUPS),
    "GN": Command("g", "g", feature=Feature.GROUPS),
    "GX": Command("g", "g", feature=Feature.GROUPS),
    "GP": Command("g", "g", feature=Feature.GROUPS),
    "I": Command("s", "s", feature=Feature.SEND_IMMEDIATE),
    "H": Command("", reports="c"),
    "Q": Command(""),
    "K": Command("ik", "ik", "b"),
}
SAMPLE_HEAD = 5
"""Characters of the body of a sample before its timestamp and words: letter, group and sequence."""
TIMESTAMP_DIGITS = 8
"""Hex digits of the timestamp in a sample."""
WITHOUT_ID = frozenset({"Q", "K"})
"""Commands that never have an ID."""
LOOKING = frozenset({"R", "RM", "H", "Q", "K"})
"""Commands that a gateway executes without an ID while a session is open; `K` begins a session or queries it."""
LISTS = {"D": "d", "A": "a"}
"""Letters of lists, and of their items."""


class ErrorCode(enum.IntEnum):
    """Codes of error responses (docs/protocol.md, "Errors")."""

    CRC = 1
    UNKNOWN_COMMAND = 2
    MALFORMED = 3
    BUS_ERROR = 4
    BUS_TIMEOUT = 5
    OUT_OF_RANGE = 6
    TOO_LONG = 7
    RECEIVE_OVERFLOW = 9
    NO_SESSION = 10
    SESSION_UNDER_WAY = 11


class GroupFlag(enum.IntFlag):
    """Flags of a group: when it is sampled, and how its samples are sent (docs/protocol.md, "Groups")."""

    PERIODIC = 1
    TRIGGER = 2
    IMMEDIATE = 4
    TIMESTAMP = 8
    ON_CHANGE = 16
    PLAIN = 32


class RequestError(ValueError):
    """A request that a gateway refuses because of its form; `code` is the code of its error response."""

    def __init__(self, code: ErrorCode) -> None:
        super().__init__(code.name)
        self.code = code


class DecodedRequest(NamedTuple):
    """A decoded request."""

    command: str
    """Letters of the command, in upper case."""
    id: int | None
    values: tuple[Any, ...]
    """Values of the fields in order; a list of words or addresses is one value. Empty for a session query."""
    residue: int = 0
    """The received CRC xored with the CRC of a frame without a session; 0 for a plain frame."""
    repeated: bool = False
    """True for a read that was executed before, whose outcome is not stored again."""


class DecodedResponse(NamedTuple):
    """A decoded message of a gateway."""

    command: str
    """In upper case: one of `COMMANDS`, ``X`` (error), ``N`` (next ID expected) or ``P`` (sample)."""
    id: int | None
    fields: dict[str, Any]
    """Values of the fields by letter. A sample has ``g``, ``p`` (its sequence number) and ``text``: its timestamp and
    words as hex digits, which the settings of its group divide."""


_PACKED = {2: "B", 4: "H", 8: "I", 16: "Q"}
"""Format characters of `struct`, by the number of hex digits."""
_LETTERS = re.compile(rb"([G-Z]+|[g-z]+)(?![G-Zg-z])")
_HEX = re.compile(rb"[0-9A-Fa-f]*")


class Codec:
    """Encodes and decodes the messages of one gateway.

    Args:
        info: the gateway's configuration.
        node: its number on a shared medium, or None.
    """

    def __init__(self, info: GatewayInfo, node: int | None = None) -> None:
        self.info = info
        self.data_digits = info.data_digits
        self.highest_address: int = (1 << info.address_bits) - 1
        self.highest_word: int = (1 << info.data_bits) - 1
        self.framing = Framing(Crc(info.crc_bits, info.crc_polynomial), node)
        self.id_count: int = 16**info.id_digits
        """Number of IDs."""
        self.digits = {
            "a": info.address_digits,
            "d": info.data_digits,
            "m": info.data_digits,
            "n": 2,
            "g": 2,
            "f": 2,
            "v": 4,
            "s": 2,
            "i": info.id_digits,
            "c": info.id_digits,
            "k": info.session_digits,
            "b": info.session_digits,
            "e": 2,
            "r": self.framing.crc.digits,
        }
        self.id_text, self.id_number = _id_tables(info.id_digits)
        self.lower = {name: name.lower().encode() for name in COMMANDS}
        """Letters of each command before an ID, in lower case."""
        self.openings = {name: self.framing.prefix + letters for name, letters in self.lower.items()}
        """Characters of each frame before its ID: the prefix of the node, and the letters of the command."""
        overhead = self.framing.overhead + info.id_digits
        self.head_sizes = {name: overhead + len(name) for name in COMMANDS}
        """Characters of a checked frame with an ID, without its fields or data, by command."""
        self.commands = {name: row for name, row in COMMANDS.items() if row.feature in info.features}
        """The commands that this gateway has."""
        self._layouts = {name: self._layout(row.fields) for name, row in COMMANDS.items()}
        self.names: dict[int, str] = {}
        """Names of addresses for error texts, from the program's spec."""
        self.refusal: Callable[[], str] = lambda: ""
        """Returns the reason why the bus refuses accesses; empty if the medium does not report one."""
        self.write_fields = self._write_fields()
        """Returns the fields of `W` and `WS`; faster than `fields`, because every write calls it."""

    # Requests from host to gateway, encoded

    def fields(self, command: str, *values: Any) -> bytes:
        """Return the fields of a request as hex digits; a list of words or addresses is one sequence or array."""
        layout, digits = self._layouts[command]
        if digits:
            return layout % (*values[:-1], hex_text(values[-1], digits))
        return layout % values if values else b""

    def _write_fields(self) -> Callable[[int, int], bytes]:
        digits = self.info.address_digits, self.info.data_digits
        if not _PACKED.keys() >= {*digits}:
            return functools.partial(self.fields, "W")
        pack = struct.Struct(">" + "".join(_PACKED[count] for count in digits)).pack
        return lambda address, word: hexlify(pack(address, word)).upper()

    def request(self, command: str, number: int, fields: bytes, seed: int = 0) -> bytes:
        """Return the checked frame of a request.

        Args:
            command: letters of the command, in upper case.
            number: its ID.
            fields: its fields as hex digits.
            seed: seed of the session.
        """
        return self.framing.checked(self.lower[command] + self.id_text[number] + fields, seed)

    def opening(self, number: int, session: int) -> bytes:
        """Return the body of the request that begins a session; `number` is the first ID."""
        return b"K%b%0*X" % (self.id_text[number], self.info.session_digits, session)

    # Requests from host to gateway, decoded

    def decode_request(self, body: bytes) -> DecodedRequest:
        """Decode the body of a checked frame; the caller has checked its CRC and its length.

        Raises:
            RequestError: if the command is unknown, or its fields are malformed.
        """
        return self._decode_request(body, short_data=False)

    def decode_plain_request(self, body: bytes) -> DecodedRequest:
        """Decode the body of a plain frame, in which the data of `W` and `WS` may have fewer digits."""
        return self._decode_request(body, short_data=True)

    def _decode_request(self, body: bytes, *, short_data: bool) -> DecodedRequest:
        letters = _LETTERS.match(body)
        command = letters[0].upper().decode() if letters else ""
        with_id = letters is not None and letters[0][0] >= ord("g")
        if letters is None or command not in self.commands or (with_id and command in WITHOUT_ID):
            raise RequestError(ErrorCode.UNKNOWN_COMMAND)
        text = body[letters.end() :]
        if not _HEX.fullmatch(text):
            raise RequestError(ErrorCode.MALFORMED)
        number = None
        if with_id:
            digits = self.info.id_digits
            if len(text) < digits:
                raise RequestError(ErrorCode.MALFORMED)
            number, text = int(text[:digits], 16), text[digits:]
        elif short_data and command in ("W", "WS"):
            text = self._lengthen(text)
        if command == "K" and not text:
            return DecodedRequest("K", None, ())
        return DecodedRequest(command, number, self._split(self.commands[command].fields, text))

    def _lengthen(self, text: bytes) -> bytes:
        """Extend a short data field with leading zeros; a missing data field stays missing."""
        address = text[: self.info.address_digits]
        data = text[self.info.address_digits :]
        return address + data.rjust(self.info.data_digits, b"0") if data else text

    def _split(self, letters: str, text: bytes) -> tuple[Any, ...]:
        values: list[Any] = []
        position = 0
        for letter in letters:
            if letter in LISTS:
                values.append(self._split_list(letter, text[position:], values[-1] if letter == "A" else None))
                return tuple(values)
            field = text[position : position + self.digits[letter]]
            if len(field) != self.digits[letter]:
                raise RequestError(ErrorCode.MALFORMED)
            values.append(int(field, 16))
            position += len(field)
        if position != len(text):
            raise RequestError(ErrorCode.MALFORMED)
        return tuple(values)

    def _split_list(self, letter: str, text: bytes, count: int | None) -> list[int]:
        """Decode a list at the end of a message: 1 to 255 words, or exactly `count` addresses."""
        digits = self.digits[LISTS[letter]]
        found, rest = divmod(len(text), digits)
        if rest or (found != count if count is not None else not 1 <= found <= 255):
            raise RequestError(ErrorCode.MALFORMED)
        return parse_numbers(text, digits)

    # Responses

    def response(self, request: DecodedRequest, reads: int | Sequence[int] | NDArray[Any] | None = None) -> bytes:
        """Return the body of a gateway's response.

        Args:
            request: the request.
            reads: value of the fields that the gateway adds: the words read; for `K`, the session that ended, or the
                current session; for `h`, the number of posted writes that failed. None if there is none.
        """
        row = COMMANDS[request.command]
        if request.id is not None:
            head = request.command.lower().encode() + self.id_text[request.id]
        else:
            head = request.command.encode() + self._echo(row, request.values)
        added = row.reads or (row.reports if request.id is not None else "")
        if reads is None or not added:
            return head
        if isinstance(reads, int):
            return head + b"%0*X" % (self.digits[LISTS.get(added, added)], reads)
        return head + hex_text(reads, self.info.data_digits)

    def _echo(self, row: Command, values: tuple[Any, ...]) -> bytes:
        if not values:
            # The answer to a session query, a `K` without fields, repeats no field.
            return b""
        by_letter = dict(zip(row.fields, values, strict=True))
        if "D" in by_letter:
            by_letter["n"] = len(by_letter["D"])
        return b"".join(b"%0*X" % (self.digits[letter], by_letter[letter]) for letter in row.echo)

    def error(self, code: ErrorCode, number: int | None = None) -> bytes:
        """Return the body of an error response; `number` is the ID of the request, None for a request without one."""
        return b"X%02X" % code if number is None else b"x%b%02X" % (self.id_text[number], code)

    def no_session(self, number: int, residue: int) -> bytes:
        """Return the body of error 0A for a request with an ID, with the residue of its CRC."""
        return b"%b%0*X" % (self.error(ErrorCode.NO_SESSION, number), self.framing.crc.digits, residue)

    def out_of_sequence(self, expected: int) -> bytes:
        """Return the body of the message ``n i``, with the next ID that the gateway expects."""
        return b"n" + self.id_text[expected]

    def publish(self, group: int, sequence: int, timestamp: int | None, words: Sequence[int] | NDArray[Any]) -> bytes:
        """Return the body of a sample; `timestamp` is in clock ticks modulo 2**32, or None."""
        time = b"" if timestamp is None else b"%0*X" % (TIMESTAMP_DIGITS, timestamp)
        return b"P%02X%02X%b%b" % (group, sequence, time, hex_text(words, self.info.data_digits))

    def decode_response(self, body: bytes) -> DecodedResponse:
        """Decode any message of a gateway. A link decodes frequent messages by faster methods.

        Raises:
            ValueError: if `body` is not a message of a gateway.
        """
        letters = _LETTERS.match(body)
        if letters is None or not _HEX.fullmatch(body, letters.end()):
            raise ValueError(f"no message of a gateway: {body[:80]!r}")
        command, text = letters[0].upper().decode(), body[letters.end() :]
        with_id = letters[0].islower()
        if command == "P" and not with_id and len(text) >= 4:
            return DecodedResponse("P", None, {"g": int(text[:2], 16), "p": int(text[2:4], 16), "text": text[4:]})
        number = None
        if with_id:
            number, text = self.id_number.get(text[: self.info.id_digits].upper()), text[self.info.id_digits :]
            if number is None:
                raise ValueError(f"an ID of {self.info.id_digits} hex digits was expected in {body[:80]!r}")
        if command == "Q" and not with_id:
            return DecodedResponse("Q", None, {"text": text})
        letters_expected = self._letters_expected(command, text, with_id=with_id)
        if letters_expected is None:
            raise ValueError(f"no message of a gateway: {body[:80]!r}")
        return DecodedResponse(
            command, number, dict(zip(letters_expected, self._split(letters_expected, text), strict=True))
        )

    def _letters_expected(self, command: str, text: bytes, *, with_id: bool) -> str | None:
        """Return the letters of a message's fields, None for an unknown one; the length decides for `K` and `X`."""
        if command == "X":
            return "er" if with_id and len(text) > self.digits["e"] else "e"
        if command == "N" and with_id:
            return ""
        if command == "K" and not with_id:
            return "k" if len(text) == self.digits["k"] else "ikb"
        row = COMMANDS.get(command)
        if row is None or row.repetition is Repeat.SILENCE or (with_id and command in WITHOUT_ID):
            return None
        return row.response(with_id=with_id)

    def _layout(self, letters: str) -> tuple[bytes, int]:
        """Return the %-format of a request's fields, and the digits of each item of its list; 0 without a list."""
        layout = b"".join(b"%b" if letter in LISTS else b"%%0%dX" % self.digits[letter] for letter in letters)
        return layout, self.digits[LISTS[letters[-1]]] if letters[-1:] in LISTS else 0


@functools.cache
def _id_tables(digits: int) -> tuple[list[bytes], dict[bytes, int]]:
    """Return the texts of all IDs by number, and their numbers by text.

    Cached, because three digits give thousands of IDs, and each connection needs the tables.
    """
    texts = [b"%0*X" % (digits, number) for number in range(16**digits)]
    return texts, {text: number for number, text in enumerate(texts)}


def hex_text(numbers: Sequence[int] | NDArray[Any], digits: int) -> bytes:
    """Return numbers as upper-case hex digits, `digits` for each, without separators."""
    if not isinstance(numbers, (list, tuple)):
        return wire.arrays.hex_rows(numbers, digits).tobytes()
    if digits in _PACKED:
        return hexlify(struct.pack(f">{len(numbers)}{_PACKED[digits]}", *numbers)).upper()
    return b"%%0%dX" % digits * len(numbers) % tuple(numbers)


def parse_numbers(text: bytes, digits: int) -> list[int]:
    """Return the numbers in `text`, each of `digits` hex digits, without separators.

    Raises:
        ValueError: if a character is no hex digit, or the last number is cut.
    """
    if len(text) % digits or (digits not in _PACKED and not _HEX.fullmatch(text)):
        raise ValueError(f"numbers of {digits} hex digits were expected, not {text[:80]!r}")
    if digits in _PACKED:
        return list(struct.unpack(f">{len(text) // digits}{_PACKED[digits]}", unhexlify(text)))
    return [int(text[start : start + digits], 16) for start in range(0, len(text), digits)]
