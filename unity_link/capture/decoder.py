"""The meaning of single frames, in words.

The decoder needs the frames of both directions. A response with an ID does not repeat the request, so its address and
command come from the request with the same ID. A sample does not contain its addresses; they come from the request that
set up its group.
"""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.capture.observed_session import ObservedSession
from unity_link.errors import UnsupportedError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.frames import CR, FrameError, Framing
from unity_link.protocol.wire.messages import (
    COMMANDS,
    TIMESTAMP_DIGITS,
    Codec,
    DecodedRequest,
    DecodedResponse,
    GroupFlag,
    RequestError,
    parse_numbers,
)
from unity_link.protocol.wire.numbers import Format, address_text, as_decimal, in_form, in_words

if TYPE_CHECKING:
    from collections.abc import Mapping

ERRORS = {
    1: "the CRC was wrong",
    2: "unknown command",
    3: "malformed: wrong length, or not hex",
    4: "the bus refused the access",
    5: "nothing on the bus answered",
    6: "out of range",
    7: "longer than this gateway's longest request",
    9: "bytes were lost: the gateway's receive FIFO was full",
    10: "no session has begun since the gateway's reset: begin with {session}",
    11: "the session of a program is under way, or that of this number",
}
_MODES = {0: "off", 1: "always", 2: "adaptive"}
# Texts of responses. {a} is an address, {d} a word, {n} a count, {D} several words, {g} a group, {s} a mode, {i} an ID,
# {k} a session and {b} the session before. Fields that a response lacks come from its request.
_TEXTS = {
    "R": "read of {a}: {d}",
    "RM": "block read of {n} words from {a}: {D}",
    "RQ": "queue read of {n} words at {a}: {D}",
    "W": "write to {a} done",
    "WM": "block write of {n} words from {a} done",
    "WQ": "queue write of {n} words to {a} done",
    "WK": "masked write to {a} done, it held {d}",
    "GS": "group {g} is set up",
    "GN": "group {g} publishes",
    "GX": "group {g} has stopped",
    "GP": "group {g} published once",
    "I": "send-immediate is {s}",
    "H": "nothing, done",
    "K": "{k} has begun, the next ID expected is {i}; {b} ended",
}
_CURRENT_SESSION = "{k} is under way"
# Texts of requests, with the same letters; also {m} for a mask, and {f} and {A} for the flags and addresses of a group.
_REQUESTS = {
    "R": "read {a}",
    "RM": "read {n} words from {a} on",
    "RQ": "read {n} words of the queue at {a}",
    "W": "write {d} to {a}",
    "WM": "write {n} words from {a} on: {D}",
    "WQ": "write {n} words to the queue at {a}: {D}",
    "WK": "write the bits {m} of {d} to {a}",
    "WS": "post {d} to {a}",
    "GS": "set up group {g}: {A}; {f}",
    "GN": "start group {g}",
    "GX": "stop group {g}",
    "GP": "publish group {g} once",
    "I": "send-immediate: {s}",
    "H": "do nothing, and answer",
    "Q": "what are you?",
    "K": "begin {k}, the next ID is {i}",
}
_SESSION_QUERY = "which session is under way?"
_FLAGS = {
    GroupFlag.TRIGGER: "at its trigger",
    GroupFlag.IMMEDIATE: "sent immediately",
    GroupFlag.TIMESTAMP: "with timestamps",
    GroupFlag.ON_CHANGE: "on change",
    GroupFlag.PLAIN: "in plain frames",
}
_BROADCAST = 0xFF


class FrameKind(enum.StrEnum):
    """Kind of a frame."""

    REQUEST = "request"
    ANSWER = "answer"
    ERROR = "error"
    """An error response, or an ``n`` after a lost request."""
    SAMPLE = "sample"
    DAMAGED = "damaged"
    UNKNOWN = "unknown"
    """The CRC is right, but the frame is not a message of this gateway's widths."""


class Meaning(NamedTuple):
    """Meaning of a frame."""

    kind: FrameKind
    words: str
    """The frame's content as a phrase, such as ``read of 0x88: 42 (ID 01F)``."""
    command: str = ""
    """Letters of the command in upper case; also ``X`` (error), ``N`` (next ID expected) and ``P`` (sample)."""
    id: int | None = None
    """ID of the request or response, or for ``N`` the next ID expected."""
    group: int | None = None
    """Group of a sample."""
    error: int | None = None
    """Code of an error response."""


class Decoder:
    """Decodes the frames between one gateway and its host, in the order in which they passed.

    Args:
        codec: message codec with the widths of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self._codec = codec
        self._requests: dict[int, DecodedRequest] = {}
        self._groups: dict[int, DecodedRequest] = {}
        self._unconfirmed: dict[int, DecodedRequest] = {}
        """Latest ``GS`` request of each group, until the gateway confirms or refuses it."""
        node = codec.framing.prefix
        self.session = ObservedSession(codec.framing)
        self._to_all = Framing(codec.framing.crc, _BROADCAST) if node else None

    # Requests

    def listen(self, body: bytes) -> DecodedRequest | None:
        """Decode and remember the body of a request from the host; return None if it is not a valid request."""
        try:
            request = self._codec.decode_plain_request(body)
        except RequestError:
            return None
        if request.id is not None:
            self._requests[request.id] = request
        if request.command == "GS":
            self._unconfirmed[request.values[0]] = request
        return request

    def explain_request(self, line: bytes) -> Meaning:
        """Return the meaning of a frame from the host, given without its LF."""
        to_all = self._to_all is not None and line.startswith(self._to_all.prefix)
        try:
            body = self._to_all.open(line) if to_all and self._to_all else self.session.open(line, from_gateway=False)
        except FrameError as error:
            return Meaning(FrameKind.DAMAGED, f"damaged: {error}")
        request = self.listen(body)
        if request is None:
            return Meaning(FrameKind.UNKNOWN, "not a request to this gateway")
        is_query = request.command == "K" and not request.values
        form = _SESSION_QUERY if is_query else _REQUESTS[request.command]
        text = form.format_map(self._in_words(self._fields(request)))
        return Meaning(
            FrameKind.REQUEST,
            f"to all nodes: {text}" if to_all else self._with_id(text, request.id),
            request.command,
            request.id,
        )

    def _fields(self, request: DecodedRequest) -> dict[str, Any]:
        fields = dict(zip(COMMANDS[request.command].fields, request.values, strict=bool(request.values)))
        if "D" in fields:
            fields["n"] = len(fields["D"])
        if "f" in fields:
            fields["f"] = (fields["f"], fields["v"])
        return fields

    # Frames of the gateway

    def explain(self, line: bytes) -> Meaning:
        """Return the meaning of a frame from the gateway, given without its LF."""
        try:
            body = self.session.open(line, from_gateway=True)
        except FrameError as error:
            return Meaning(FrameKind.DAMAGED, f"damaged: {error}")
        try:
            response = self._codec.decode_response(body)
            self.session.hear(response)
            return self._explain(response)
        except UnsupportedError as error:
            return Meaning(FrameKind.ANSWER, str(error), "Q")
        except ValueError:
            return Meaning(FrameKind.UNKNOWN, "not a message of this gateway")

    def body(self, line: bytes) -> bytes:
        """Return the body of a frame from the gateway, without CRC and CR; a damaged frame is returned whole."""
        try:
            return self.session.open(line, from_gateway=True)
        except FrameError:
            return line.removesuffix(CR)

    def _explain(self, response: DecodedResponse) -> Meaning:
        command, number = response.command, response.id
        match command:
            case "X":
                if number is not None:
                    self._refused(number)
                return Meaning(FrameKind.ERROR, self._error(response), command, number, error=response.fields["e"])
            case "N":
                assert number is not None
                return self._explain_gap(number)
            case "P":
                return Meaning(FrameKind.SAMPLE, self._publish(response.fields), command, group=response.fields["g"])
            case "Q":
                return Meaning(FrameKind.ANSWER, _configuration(response.fields["text"]), command)
        self._confirmed(response)
        request = None if number is None else self._requests.get(number)
        values = dict.fromkeys("adnDgsi", "?") | self._in_words(self._known(request) | response.fields)
        form = _CURRENT_SESSION if command == "K" and "i" not in response.fields else _TEXTS[command]
        text = form.format_map(values)
        if failed := response.fields.get("c"):
            text += f"; {failed} posted writes of the session have failed"
        return Meaning(FrameKind.ANSWER, self._with_id(text, number), command, number)

    def _explain_gap(self, number: int) -> Meaning:
        ids = self._codec.id_count
        # An ``h`` half the sequence space ahead asks for the next ID, so the ``n`` answers it and reports no loss.
        request = self._requests.get((number + ids // 2 - 1) % ids)
        text = f"the next ID expected is {self._id(number)}"
        if request is not None and request.command == "H":
            return Meaning(FrameKind.ANSWER, f"{text}: the session is still this one", "N", number)
        return Meaning(FrameKind.ERROR, f"out of sequence: {text}", "N", number)

    # The samples of a group have the addresses of the last settings that the gateway confirmed (docs/protocol.md,
    # "Groups").

    def _confirmed(self, response: DecodedResponse) -> None:
        """Use the settings of groups that a response confirms: its own, and those of requests with earlier IDs."""
        ids = self._codec.id_count
        for group, request in list(self._unconfirmed.items()):
            if request.id is None:
                is_confirmed = response.command == "GS" and response.fields.get("g") == group
            else:
                is_confirmed = response.id is not None and (response.id - request.id) % ids < ids // 2
            if is_confirmed:
                self._groups[group] = self._unconfirmed.pop(group)

    def _refused(self, number: int) -> None:
        """Forget the settings of the request with this ID."""
        for group, request in list(self._unconfirmed.items()):
            if request.id == number:
                del self._unconfirmed[group]

    def _known(self, request: DecodedRequest | None) -> dict[str, Any]:
        """Return the fields of a request that its response repeats or shares: all but the words."""
        if request is None:
            return {}
        known = self._fields(request)
        known.pop("d", None)
        known.pop("D", None)
        return known

    def _in_words(self, fields: Mapping[str, Any]) -> dict[str, str]:
        return {letter: self._field(letter, value) for letter, value in fields.items()}

    def _field(self, letter: str, value: Any) -> str:
        info = self._codec.info
        match letter:
            case "a":
                text = address_text(value, info)
            case "d":
                text = in_words(value, info.data_bits)
            case "D":
                text = ", ".join(in_words(word, info.data_bits) for word in value)
            case "m":
                text = in_form(value, info.data_bits, Format.HEX)
            case "A":
                text = ", ".join(address_text(address, info) for address in value)
            case "f":
                text = _when(*value)
            case "i":
                text = self._id(value)
            case "k" | "b":
                text = self._session(value)
            case "s":
                text = _MODES.get(value, f"mode {value:02X}")
            case _:
                text = str(value)
        return text

    def _session(self, asked: int) -> str:
        info = self._codec.info
        if not asked:
            return "no session"
        form = " in compact form" if asked & info.asks_compact else ""
        return f"session {asked & info.last_session:0{info.session_digits}X}{form}"

    def _id(self, number: int | None) -> str:
        return f"{number:0{self._codec.info.id_digits}X}"

    def _error(self, response: DecodedResponse) -> str:
        code = response.fields["e"]
        meaning = ERRORS.get(code, "unknown to this program").format(
            session=f"K{self._id(0)}{1:0{self._codec.info.session_digits}X}"
        )
        return self._with_id(f"error {code:02X}: {meaning}", response.id)

    def _with_id(self, text: str, number: int | None) -> str:
        return text if number is None else f"{text} (ID {self._id(number)})"

    def _publish(self, fields: Mapping[str, Any]) -> str:
        group, text = fields["g"], fields["text"]
        head = f"sample {fields['p']} of group {group}"
        if group not in self._groups:
            return head
        try:
            return head + self._words(self._groups[group], text)
        except ValueError:
            return f"{head}, which is not as long as the group's settings say"

    def _words(self, group: DecodedRequest, text: bytes) -> str:
        _, flags, _, _, addresses = group.values
        info = self._codec.info
        time = ""
        if flags & GroupFlag.TIMESTAMP:
            time = f" at {int(text[:TIMESTAMP_DIGITS], 16) / info.clock_hz:.6f} s"
            text = text[TIMESTAMP_DIGITS:]
        words = parse_numbers(text, info.data_digits)
        pairs = zip(addresses, words, strict=True)
        shown = ", ".join(
            f"{address_text(address, info)} = {as_decimal(word, info.data_bits)}" for address, word in pairs
        )
        return f"{time}: {shown}"


def _when(flags: int, divisor: int) -> str:
    """Return when a group is sampled and how its samples are sent, as a phrase.

    Args:
        flags: the group's flags, as in ``GS``.
        divisor: base ticks from one sample to the next.
    """
    parts = [f"every {divisor} ticks" if divisor > 1 else "every tick"] if flags & GroupFlag.PERIODIC else []
    parts += [text for flag, text in _FLAGS.items() if flags & flag]
    return ", ".join(parts) or "when it is asked to"


def _configuration(text: bytes) -> str:
    info = GatewayInfo.from_hex(text)
    return f"this gateway has {summary(info)}; {info.features.words or 'no features'}"


def summary(info: GatewayInfo) -> str:
    """Return the widths, the CRC and the clock of a gateway as a phrase."""
    return (
        f"words of {info.data_bits} bits, addresses of {info.address_bits}, IDs of {info.id_digits} digits, "
        f"CRC-{info.crc_bits}, a clock of {info.clock_hz / 1e6:g} MHz"
    )
