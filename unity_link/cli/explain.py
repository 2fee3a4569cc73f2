"""Messages of a gateway in words, for `terminal`.

A response with an ID does not repeat what it answers, and a publish does not say which addresses its words are of, so
the interpreter also listens to the requests.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.cli.info import feature_name
from unity_link.cli.words import address_text, as_decimal, in_words
from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.frames import CR, FrameError
from unity_link.protocol.messages import (
    COMMANDS,
    Codec,
    DecodedRequest,
    DecodedResponse,
    GroupFlag,
    RequestError,
    parse_words,
)

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
    8: "already executed, and its answer is gone",
    9: "bytes were lost: the gateway's receive FIFO was full",
    10: "no session has begun since the gateway's reset: begin with {session}",
}
_MODES = {0: "off", 1: "always", 2: "adaptive"}
_TIMESTAMP_DIGITS = 8
# {a} address, {d} word, {n} count, {D} words, {g} group, {s} mode, {i} ID; what a response lacks is from its request.
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
    "K": "session started, the next ID expected is {i}",
}


class Interpreter:
    """Puts what one gateway sends into words.

    Args:
        codec: the messages of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self._codec = codec
        self._requests: dict[int, DecodedRequest] = {}
        self._groups: dict[int, DecodedRequest] = {}

    def listen(self, body: bytes) -> str | None:
        """Take a request that is sent; gives its command in upper case, None where it is no proper request."""
        try:
            request = self._codec.decode_plain_request(body)
        except RequestError:
            return None
        if request.id is not None:
            self._requests[request.id] = request
        if request.command == "GS":
            self._groups[request.values[0]] = request
        return request.command

    def explain(self, line: bytes) -> str:
        """Put a frame, given without its LF, into words."""
        try:
            body = self._codec.framing.open(line)
            return self._explain(self._codec.decode_response(body))
        except FrameError as error:
            return f"damaged: {error}"
        except ValueError:
            return "not a message of this gateway"

    def body(self, line: bytes) -> bytes:
        """Return what a frame says without its CRC or CR; for a damaged one, all of it."""
        try:
            return self._codec.framing.open(line)
        except FrameError:
            return line.removesuffix(CR)

    def _explain(self, response: DecodedResponse) -> str:
        match response.command:
            case "X":
                return self._error(response)
            case "N":
                return f"out of sequence: the next ID expected is {self._id(response.id)}"
            case "P":
                return self._publish(response.fields)
            case "Q":
                return _configuration(response.fields["text"])
        request = None if response.id is None else self._requests.get(response.id)
        values = dict.fromkeys("adnDgsi", "?") | self._in_words(self._known(request) | response.fields)
        text = _TEXTS[response.command].format_map(values)
        return text if response.id is None else f"{text} (ID {self._id(response.id)})"

    def _known(self, request: DecodedRequest | None) -> dict[str, Any]:
        """Return what a request says of its response."""
        if request is None:
            return {}
        known = dict(zip(COMMANDS[request.command].fields, request.values, strict=True))
        known.pop("d", None)
        if "D" in known:
            known["n"] = len(known.pop("D"))
        return known

    def _in_words(self, fields: Mapping[str, Any]) -> dict[str, str]:
        return {letter: self._field(letter, value) for letter, value in fields.items()}

    def _field(self, letter: str, value: Any) -> str:
        info = self._codec.info
        match letter:
            case "a":
                return address_text(value, info)
            case "d":
                return in_words(value, info.data_bits)
            case "D":
                return ", ".join(in_words(word, info.data_bits) for word in value)
            case "i":
                return self._id(value)
            case "s":
                return _MODES.get(value, f"mode {value:02X}")
        return str(value)

    def _id(self, number: int | None) -> str:
        return f"{number:0{self._codec.info.id_digits}X}"

    def _error(self, response: DecodedResponse) -> str:
        code = response.fields["e"]
        meaning = ERRORS.get(code, "unknown to this program").format(session=f"K{self._id(0)}")
        text = f"error {code:02X}: {meaning}"
        return text if response.id is None else f"{text} (ID {self._id(response.id)})"

    def _publish(self, fields: Mapping[str, Any]) -> str:
        group, text = fields["g"], fields["text"]
        head = f"sample {fields['p']} of group {group}"
        if group not in self._groups:
            return head
        _, flags, _, _, addresses = self._groups[group].values
        info = self._codec.info
        time = ""
        if flags & GroupFlag.TIMESTAMP:
            time = f" at {int(text[:_TIMESTAMP_DIGITS], 16) / info.clock_hz:.6f} s"
            text = text[_TIMESTAMP_DIGITS:]
        words = parse_words(text, info.data_digits).tolist()
        pairs = zip(addresses, words, strict=True)
        shown = ", ".join(
            f"{address_text(address, info)} = {as_decimal(word, info.data_bits)}" for address, word in pairs
        )
        return f"{head}{time}: {shown}"


def _configuration(text: bytes) -> str:
    info = GatewayInfo.from_hex(text)
    features = ", ".join(feature_name(feature.name) for feature in info.features) or "no features"
    return f"this gateway has {summary(info)}; {features}"


def summary(info: GatewayInfo) -> str:
    """Say in half a line what a gateway is."""
    return (
        f"words of {info.data_bits} bits, addresses of {info.address_bits}, IDs of {info.id_digits} digits, "
        f"CRC-{info.crc_bits}, a clock of {info.clock_hz / 1e6:g} MHz"
    )
