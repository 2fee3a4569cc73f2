"""Writes the shared vectors, `*.ndjson` beside this file: requests, and the exact answers of a gateway.

The virtual gateway computes the answers. After a change of it, run `python tests/vectors/generate.py` and read the
difference: it is a change of the protocol. README.md describes the files.
"""

from __future__ import annotations

import json
import random
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from unity_link.protocol.wire.compact import END, ESCAPE, START, STUFFED, CompactForm, Packer, cut, is_sample
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.messages import COMMANDS, Codec, ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from collections.abc import Iterator

FOLDER = Path(__file__).resolve().parent
BUS_ERROR_AT, BUS_TIMEOUT_AT = 0xE0, 0xE8
RANDOM_FRAMES = 300
COMPACT = GatewayInfo().features | Feature.COMPACT

CONFIGURATIONS: dict[str, tuple[GatewayInfo, int | None]] = {
    "default": (GatewayInfo(), None),
    # The gateway of the paper.
    "short": (
        GatewayInfo(id_digits=2, crc_bits=8, crc_polynomial=0x07, block_words=32, group_words=16, groups=8),
        None,
    ),
    "words_of_16": (GatewayInfo(address_bits=16, data_bits=16), None),
    "words_of_64": (GatewayInfo(address_bits=32, data_bits=64, crc_bits=32, crc_polynomial=0x04C11DB7), None),
    "odd_widths": (
        GatewayInfo(
            address_bits=10,
            data_bits=13,
            id_digits=2,
            crc_bits=8,
            crc_polynomial=0x31,
            block_words=16,
            groups=5,
            group_words=6,
            build_id=0xBEEF,
        ),
        None,
    ),
    "bare": (GatewayInfo(features=Feature(0), groups=0, group_words=0, block_words=8), None),
    "compact": (GatewayInfo(block_words=16, groups=4, group_words=8, features=COMPACT), None),
    # With widths of ID, CRC and address that need other spare digits.
    "compact_addressed": (
        GatewayInfo(
            id_digits=2,
            crc_bits=8,
            crc_polynomial=0x07,
            address_bits=10,
            data_bits=16,
            block_words=16,
            groups=4,
            group_words=8,
            features=COMPACT,
        ),
        0xB5,
    ),
    "addressed": (GatewayInfo(block_words=16, groups=4, group_words=8), 0x1A),
}


class Script:
    """Sends bytes to a gateway and records the steps."""

    def __init__(self, info: GatewayInfo, node: int | None) -> None:
        self.gateway = VirtualGateway(info, node=node)
        self.gateway.attach(Failing(ErrorCode.BUS_ERROR), [BUS_ERROR_AT])
        self.gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [BUS_TIMEOUT_AT])
        self.info = self.gateway.info
        self.codec = Codec(self.info, node)
        self.node = node
        self.sessions = 0
        """Number of the last opened session."""
        self.records: list[dict[str, Any]] = []
        self.asks_compact = self.info.asks_compact if Feature.COMPACT in self.info.features else 0
        """Bit beside the number of a session that requests the compact form."""
        self.packer = Packer(CompactForm.of(self.info, from_gateway=False))
        self._forms = random.Random(1)

    def header(self) -> dict[str, Any]:
        """Return the first line of the file."""
        configuration = msgspec.structs.asdict(self.info) | {"features": int(self.info.features)}
        return {
            "configuration": configuration,
            "node": self.node,
            "bus_error": [BUS_ERROR_AT],
            "bus_timeout": [BUS_TIMEOUT_AT],
        }

    def send(self, about: str, data: bytes) -> None:
        """Send bytes, with some frames in compact form if the gateway has it."""
        self.send_as_it_is(about, self.formed(data))

    def send_as_it_is(self, about: str, data: bytes) -> None:
        """Send bytes unchanged."""
        frames = cut(self.gateway.receive(data, 0.0))
        publishes = b"".join(frame for frame in frames if is_sample(frame, self.codec.framing.prefix))
        answers = b"".join(frame for frame in frames if not is_sample(frame, self.codec.framing.prefix))
        texts = {"send": data, "answers": answers, "publishes": publishes}
        record = {name: text.decode("latin-1") for name, text in texts.items()}
        if not publishes:
            del record["publishes"]
        self.records.append({"about": about, **record})

    def formed(self, data: bytes) -> bytes:
        """Return bytes in which about half of the suitable frames are in compact form, if the gateway has it."""
        if self.asks_compact:
            lines = data.splitlines(keepends=True)
            data = b"".join(line if self._forms.random() < 0.4 else self.packer.pack_one(line) for line in lines)
        return data

    def checked(self, about: str, *bodies: bytes) -> None:
        """Send bodies in checked frames, one after another."""
        for body in bodies:
            self.send(about, self.frame(body))

    def frame(self, body: bytes) -> bytes:
        """Return a checked frame; if it has an ID, its CRC depends on the open session."""
        seed = seed_of(self.gateway.session, from_gateway=False) if body[:1].islower() else 0
        return self.codec.framing.checked(body, seed)

    def begin(self, first: int, *, program: bool = False, about: str = "session") -> None:
        """Open another session: of a program if `program` is true, otherwise of a person."""
        self.sessions = self.sessions * 5 % self.info.last_session + 1
        # Every fourth session does not request the compact form.
        asked = self.sessions | self.asks_compact * (self.sessions % 4 > 0)
        (self.checked if program else self.plain)(about, self.codec.opening(first % self.codec.id_count, asked))

    def plain(self, about: str, *bodies: bytes) -> None:
        """Send bodies in plain frames, one after another."""
        for body in bodies:
            self.send(about, self.codec.framing.plain_request(body))

    def both(self, about: str, *bodies: bytes) -> None:
        """Send bodies in both forms of frames."""
        self.checked(about, *bodies)
        self.plain(about + ", plain", *bodies)

    def body(self, command: str, *values: Any, number: int | None = None) -> bytes:
        """Return the body of a request."""
        fields = self.codec.fields(command, *values)
        if number is None:
            return b"%b%b" % (command.encode(), fields)
        return b"%b%b%b" % (command.lower().encode(), self.codec.id_text[number % self.codec.id_count], fields)


def examples(info: GatewayInfo) -> dict[str, tuple[Any, ...]]:
    """Return valid fields for each command."""
    words = [(0x123456789ABCDEF0 >> 4 * index) % (1 << info.data_bits) for index in range(3)]
    return {
        "W": (0x0A, words[0]),
        "R": (0x0A,),
        "WM": (0x20, words),
        "RM": (0x20, 3),
        "WQ": (0x30, words),
        "RQ": (0x30, 2),
        "WK": (0x0A, 0x5A, 0xFF),
        "WS": (0x0B, words[1]),
        "GS": (1, 0, 1, 2, [0x0A, 0x0B]),
        "GN": (1,),
        "GX": (1,),
        "GP": (1,),
        "I": (1,),
        "H": (),
    }


def no_session(script: Script) -> None:
    """Send requests with an ID before the first session, which are not executed, and errors that take precedence."""
    middle = script.codec.id_count // 2
    for command, values in examples(script.info).items():
        for number in (0, middle):
            script.both(f"{command} with ID and no session", script.body(command, *values, number=number))
    for number in (1, middle + 1):
        script.both("no gap is reported", script.body("H", number=number))
    script.checked(
        "neither range nor bus is checked",
        script.body("RM", 0, 0, number=0),
        script.body("R", BUS_ERROR_AT, number=0),
        script.body("WS", BUS_TIMEOUT_AT, 1, number=0),
    )
    if Feature.GROUPS in script.info.features:
        script.checked("no group is looked up", script.body("GP", 0xFF, number=0))
    digits = script.codec.id_text[0]
    script.both("malformed, and no session", b"r" + digits, b"h" + digits[1:], b"ws" + digits + b"0")
    script.both("unknown, and no session", b"q" + digits, b"k" + digits, b"g" + digits, b"Rm" + digits)
    frame = script.frame(script.body("H", number=0))
    script.send("a CRC of an ended session", frame[:-2] + (b"0" if frame[-2:-1] != b"0" else b"1") + b"\n")
    script.send("a CRC that is not hexadecimal", frame[:-2] + b"G\n")
    script.both("session query without a session", b"K")
    script.both("without ID", script.body("R", 0x0A), script.body("H"))


def every_command(script: Script) -> None:
    """Send each command in each form, with and without an ID."""
    script.both("configuration", b"Q")
    number = 0
    for command, values in examples(script.info).items():
        script.both(f"{command} without ID", script.body(command, *values))
        script.checked(f"{command} with ID", script.body(command, *values, number=number))
        if command in script.codec.commands:
            number += 1
        script.plain(f"{command} with ID, plain", script.body(command, *values, number=number))
        if command in script.codec.commands:
            number += 1


def frames(script: Script) -> None:
    """Send frames with faults between their two ends."""
    framing, read = script.codec.framing, script.body("R", 0x0A)
    good = framing.checked(read)
    script.send(
        "hex digits of the CRC in lower case", good[: -1 - framing.crc.digits] + good[-1 - framing.crc.digits :].lower()
    )
    script.both("hex digits in lower case", b"R" + read[1:].lower())
    script.send("wrong CRC", good[:-2] + (b"0" if good[-2:-1] != b"0" else b"1") + b"\n")
    script.send("CRC too short", framing.prefix + b"0\n")
    script.send("CRC that is not hex", good[:-2] + b"G\n")
    script.send("only a CRC", framing.checked(b""))
    script.send("empty frames", b"\n\r\r\n\n")
    script.send("several frames at once", good + framing.plain_request(read) + b"\n" + good)
    script.send("half a frame", good[:3])
    script.send("the other half", good[3:])
    script.send("null and high bytes", framing.checked(b"R\x00\xff") + framing.plain_request(b"\x80R0A"))
    longest = script.info.longest_request
    script.send("a plain frame of the longest length", framing.prefix + b"G" * longest + b"\r")
    for end in (b"\n", b"\r"):
        script.send("a frame longer than the longest", framing.prefix + b"R" + b"0" * longest + end)
    script.send("a much longer frame, in pieces", framing.prefix + b"0" * 3 * longest)
    script.send("its last piece, and a valid frame", b"0\n" + good)


def forms(script: Script) -> None:
    """Send unknown commands and fields of a wrong width."""
    script.both("unknown command", b"Z", b"G", b"GG00", b"RR0A", b"0A", b"HH", b"N00", b"X01", b"P0000", b"RMM0A01")
    script.both("mixed case", b"Rm0A01", b"rM000A01", b"wM", b"Hh")
    digits = script.codec.id_text[0]
    script.both("lower case in commands without an ID", b"q", b"k" + digits, b"q" + digits, b"k")
    script.both("numbers that are not hex", b"R0_", b"R 0", b"R+1", b"R0x", b"H\xff", b"r000G")
    for command, values in examples(script.info).items():
        body = script.body(command, *values)
        script.both(f"{command} with a digit too many", body + b"0")
        if values:
            script.both(f"{command} with a digit too few", body[:-1])
            script.both(f"{command} without fields", command.encode())
        script.both(f"{command} with half an ID", command.lower().encode() + b"0")
        script.both(f"{command} with only an ID", command.lower().encode() + script.codec.id_text[0])
    address = script.body("R", 0x0A)[1:]
    script.both("short data", b"W" + address + b"5", b"WS" + address + b"7", b"W" + address)
    numbered = script.codec.id_text[0] + address + b"5"
    script.both("short data after an ID", b"w" + numbered, b"ws" + numbered)
    script.both("short data in a block", b"WM" + address + b"5")
    script.both("first ID and session of a wrong width", b"K" + digits, b"K" + digits[1:], b"K" + digits + b"0")
    script.both("number of addresses unlike the count", script.body("GS", 1, 0, 1, 3, [1, 2]))
    most = b"0" * script.info.data_digits
    if script.info.block_words == 255:
        script.plain("255 words", b"WM" + address + most * 255)


def ranges(script: Script) -> None:
    """Send values that are out of range."""
    info = script.info
    script.both("count 0", script.body("RM", 0, 0), script.body("RQ", 0, 0))
    if info.block_words < 255:
        words = [0] * (info.block_words + 1)
        script.checked("count too large", script.body("RM", 0, info.block_words + 1))
        script.checked("too many words", script.body("WM", 0, words), script.body("WQ", 0, words))
    script.checked(
        "most words",
        script.body("WM", 0x40, list(range(info.block_words % 97))),
        script.body("RM", 0x40, info.block_words),
    )
    top = 16**info.address_digits - 1
    script.checked(
        "the highest address in the digits",
        script.body("R", top),
        script.body("W", top, 1),
        script.body("RM", top, 2),
    )
    top = 16**info.data_digits - 1
    script.checked(
        "the highest word",
        script.body("W", 0x50, top),
        script.body("WK", 0x50, top, 1),
        script.body("WK", 0x50, 1, top),
        script.body("WM", 0x50, [1, top]),
    )
    script.checked("mode beyond the last", script.body("I", 3), script.body("I", 255))
    script.checked("a group never set", script.body("GN", 2), script.body("GX", 2), script.body("GP", 2))
    if info.groups < 256:
        script.checked("a group too many", script.body("GS", info.groups, 0, 1, 1, [0]), script.body("GP", info.groups))
    for flags in (0x40, 0x80, 0xC0, 0x3E):
        script.checked(f"flags {flags:02X}", script.body("GS", 0, flags, 1, 1, [0]))
    script.checked("divisor 0", script.body("GS", 0, 0, 0, 1, [0]))
    script.checked("no addresses", script.body("GS", 0, 0, 1, 0, []))
    if 0 < info.group_words < 255:
        script.checked(
            "too many addresses", script.body("GS", 0, 0, 1, info.group_words + 1, [0] * (info.group_words + 1))
        )
    script.checked("a group with an address too high", script.body("GS", 0, 0, 1, 2, [0, 16**info.address_digits - 1]))


def bus(script: Script) -> None:
    """Send blocks that wrap, and accesses to failing addresses."""
    last = (1 << script.info.address_bits) - 1
    script.checked(
        "a block that wraps",
        script.body("WM", last - 1, [1, 2, 3, 4]),
        script.body("RM", last - 1, 4),
        script.body("R", 0),
    )
    for number, place in enumerate((BUS_ERROR_AT, BUS_TIMEOUT_AT)):
        script.begin(16 * number)
        requests: list[tuple[Any, ...]] = [
            ("R", place),
            ("W", place, 1),
            ("RM", place - 2, 4),
            ("WM", place - 2, [5, 6, 7, 8]),
            ("RM", place - 2, 2),
            ("R", place + 1),
            ("RQ", place, 2),
            ("WQ", place, [1, 2]),
            ("WK", place, 1, 1),
            ("WS", place, 1),
        ]
        expected = 16 * number
        for command, *values in requests:
            script.both(f"bus failure in {command}", script.body(command, *values))
            script.checked(f"bus failure in {command} with ID", script.body(command, *values, number=expected))
            if command in script.codec.commands:
                script.checked(f"{command} again", script.body(command, *values, number=expected))
                expected += 1


def sequence(script: Script) -> None:
    """Send repetitions and gaps, and wrap around the sequence space."""
    ring = script.codec.id_count
    script.begin(ring - 3)
    number = ring - 3
    for command, values in examples(script.info).items():
        if command not in script.codec.commands:
            continue
        script.checked(f"{command} in sequence", script.body(command, *values, number=number))
        script.both(f"{command} repeated", script.body(command, *values, number=number))
        number += 1
    script.checked("a gap", script.body("W", 1, 2, number=number + 1))
    script.checked(
        "reported once", script.body("R", 1, number=number + 2), script.body("H", number=number + ring // 2 - 1)
    )
    script.checked("the far half of the sequence space is past", script.body("W", 1, 5, number=number + ring // 2))
    script.checked("a range error in sequence ends the gap", script.body("RM", 1, 0, number=number))
    script.checked("a gap again", script.body("R", 1, number=number + 2))
    script.begin(number, about="a session ends the gap")
    script.checked("so it is reported again", script.body("R", 1, number=number + 1))
    script.checked(
        "malformed frames do not count", b"r" + script.codec.id_text[number % ring], script.body("R", 1, number=number)
    )
    script.checked("a repeated read out of range", script.body("RM", 1, 0, number=number))
    script.checked("a repeated group command out of range", script.body("GN", 0xFF, number=number))


def groups(script: Script) -> None:
    """Publish samples on request."""
    if Feature.GROUPS not in script.info.features:
        return
    script.checked("words to publish", script.body("W", 0x0A, 0x12), script.body("W", 0x0B, 0x34))
    script.checked("a group", script.body("GS", 0, 0, 1, 3, [0x0B, 0x0A, 0x0B]))
    script.both("published on request", script.body("GP", 0), script.body("GP", 0))
    script.begin(0, about="a session keeps settings and sequence")
    script.checked("and its samples have it", script.body("GP", 0))
    script.checked("as starting and stopping does", script.body("GN", 0), script.body("GX", 0), script.body("GP", 0))
    script.checked("settings restart the group", script.body("GS", 0, 0x20, 1, 1, [0x0A]), script.body("GP", 0))
    script.checked("a refused setting changes nothing", script.body("GS", 0, 0, 0, 1, [0x0B]), script.body("GP", 0))
    script.checked(
        "on request, changed or unchanged",
        script.body("GS", 1, 0x10, 1, 1, [0x0A]),
        script.body("GP", 1),
        script.body("GP", 1),
    )
    script.checked(
        "a sample that fails counts", script.body("GS", 1, 0, 1, 2, [0x0A, BUS_ERROR_AT]), script.body("GP", 1)
    )
    script.begin(0)
    script.checked("with an ID, once", script.body("GP", 0, number=0), script.body("GP", 0, number=0))
    script.send("the sequence of a group wraps", script.codec.framing.checked(script.body("GP", 0)) * 256)


def nodes(script: Script) -> None:
    """Send frames for other nodes, and for all nodes."""
    if script.node is None:
        return
    crc = script.codec.framing.crc
    for prefix in (b"", b"Z1B", b"Z", b"Z1", b"z1A", b"Z1G", b"ZZ1A"):
        covered = prefix + b"R0A"
        script.send("not for this node", covered + crc.text(covered) + b"\n" + covered + b"\r")
        script.send("not for this node and wrong", covered + b"\n")
    script.send("no body after the prefix", b"Z1A\nZ1A\r")
    for body in (b"WS0C00000077", b"W0C00000078", b"R0C", b"R0", b"Q", b"K0011234", b"ws0000C00000079"):
        covered = b"ZFF" + body
        script.send("for all nodes", covered + crc.text(covered) + b"\n" + covered + b"\r")
    script.checked("one of them was executed", b"R0C", b"K")
    lower = b"Z1a" + b"R0C"
    script.send("the number in lower case", lower + crc.text(lower) + b"\n")


def programs(script: Script) -> None:
    """Send requests that a program's session refuses, and frames of another session."""
    codec = script.codec
    script.begin(0, program=True)
    for command, values in examples(script.info).items():
        script.both(f"{command} without ID in a program's session", script.body(command, *values))
        script.plain(f"{command} with ID, plain, in a program's session", script.body(command, *values, number=0))
    script.both("queries", script.body("Q"), b"K", script.body("H"), script.body("R", BUS_ERROR_AT))
    number = 0
    for command, values in examples(script.info).items():
        script.checked(f"{command} of the session", script.body(command, *values, number=number))
        number += command in codec.commands
    read = script.body("R", 0x0A, number=number)
    for session in (0, script.sessions + 1):
        seed = seed_of(session, from_gateway=False)
        script.send("of another session", codec.framing.checked(read, seed))
    script.send("an echo", codec.framing.checked(read, seed_of(script.sessions, from_gateway=True)))
    script.both("the open session again", codec.opening(0, script.sessions))
    last = script.info.last_session
    beyond = [] if script.asks_compact else [codec.opening(0, 2 * last + 1)]
    script.both("a session out of range", codec.opening(0, 0), codec.opening(0, last + 1), *beyond)
    if Feature.GROUPS in script.info.features:
        body = script.body("GS", 0, 0x20, 1, 1, [0x0A], number=number)
        script.checked("plain samples", body, body)
        number += 1
    if script.node is not None:
        covered = b"WS0C00000078"
        everybody = b"ZFF" + covered
        script.send("for all nodes, plain", everybody + b"\r")
        script.checked("was not executed", b"R0C")
        script.send("for all nodes", everybody + codec.framing.crc.text(everybody) + b"\n")
        script.checked("was executed", b"R0C")
    script.checked("still in sequence", script.body("H", number=number))
    script.both("session query", b"K")
    script.begin(7, program=True, about="a session that ends another")
    script.begin(8, about="a person's session, which accepts all requests")
    script.both("without ID", script.body("W", 0x0A, 1), script.body("R", 0x0A))


def fates(script: Script) -> None:
    """Repeat failed and destructive requests, and query the outcomes of posted writes."""
    script.begin(script.codec.id_count - 2, program=True)
    number = script.codec.id_count - 2
    failing: list[tuple[Any, ...]] = [
        ("W", BUS_ERROR_AT, 1),
        ("WM", BUS_TIMEOUT_AT - 1, [1, 2]),
        ("R", BUS_TIMEOUT_AT),
        ("RM", 0, 0),
        ("WS", BUS_ERROR_AT, 1),
        ("WS", 0x0B, 5),
        ("WS", BUS_TIMEOUT_AT, 1),
    ]
    first = number
    for command, *values in failing:
        script.checked(f"{command}, possibly failing", script.body(command, *values, number=number))
        number += 1
    script.checked("count of failed posted writes", script.body("H", number=number))
    number += 1
    for place, (command, *values) in enumerate(failing):
        script.checked(f"{command} again", script.body(command, *values, number=first + place))
        script.checked("query of the outcome", script.body("H", number=first + place))
    script.checked("count of failures, again", script.body("H", number=number - 1))
    number = _destructive(script, number)
    half = script.codec.id_count // 2
    if half <= 128:
        for _ in range(half):
            script.checked("until the stored outcomes wrap", script.body("H", number=number))
            number += 1
        script.checked("the first stored outcome", script.body("H", number=number - half))
    script.begin(3, program=True)
    script.checked("none of the posted writes of this session failed", script.body("H", number=3))


def _destructive(script: Script, number: int) -> int:
    """Add destructive reads and their repetitions; return the next ID."""
    taken: list[tuple[Any, ...]] = [
        ("WK", 0x0A, 0x5A, 0xFF),
        ("WK", 0x0A, 0xFF, 0),
        ("RQ", 0x0A, 3),
        ("WK", 0x0B, 1, 1),
    ]
    for command, *values in taken:
        if command not in script.codec.commands:
            continue
        body = script.body(command, *values, number=number)
        script.checked(f"{command}", body)
        script.checked(f"{command} again, with stored words", body)
        number += 1
    return number


def compact_form(script: Script) -> None:
    """Send compact frames that are cut, damaged, and mixed with text and noise."""
    script.both("query of the session and its form", b"K")
    expected = script.gateway.expected
    frame = script.frame(script.body("R", 0x0A, number=expected))
    packed = script.packer.pack_one(frame)
    other = script.packer.pack_one(script.frame(script.body("H", number=expected)))
    pieces: dict[str, bytes] = {
        "without its end": packed[:-1] + other,
        "without its end, then text": packed[:-1] + frame,
        "without its start": packed[1:] + other,
        "cut by a line end": packed[:4] + b"\n" + other,
        "cut by a CR": packed[:4] + b"\r" + other,
        "whole, with a CR in place of its end": packed[:-1] + b"\r\n" + other,
        "whole, with an LF in place of its end": packed[:-1] + b"\n" + other,
        "an end in place of the LF of a text frame": frame[:-1] + END + other,
        "a start that an LF cuts": START + b"\n" + other,
        "a start that a start cuts": START + other,
        "a second end after it": packed + END + other,
        "a start after it": packed + START + b"\n" + other,
        "a start in a line": frame[:5] + packed + other,
        "nothing between start and end": START + END + other,
        "an escape at its end": packed[:-1] + ESCAPE + END + other,
        "unnecessary escapes": START + ESCAPE + bytes((packed[1] ^ STUFFED,)) + packed[2:],
        "an escape of an escape": packed[:4] + ESCAPE + ESCAPE + packed[5:] + other,
        "line ends around it": b"\n\r\n" + packed + b"\r\n" + other,
        "longer than any": START + packed[1:-1] * (script.info.longest_request // 4) + END + other,
    }
    for about, data in pieces.items():
        script.send_as_it_is(f"a compact frame: {about}", data)
    source = random.Random(2)
    for _ in range(RANDOM_FRAMES):
        number = script.gateway.expected + source.choice((0, 0, 0, -1, 1))
        command = source.choice([name for name in COMMANDS if name not in {"GN", "K", "Q", "GS"}])
        body = script.body(command, *_random_values(script, command, source), number=number)
        damaged = bytearray(script.packer.pack_one(script.frame(body)))
        at = source.randrange(len(damaged))
        flipped = bytes((damaged[at] ^ 1 << source.randrange(8),))
        damaged[at : at + 1] = source.choice([b"", START, END, ESCAPE, b"\n", b"\r", flipped])
        script.send_as_it_is("a damaged compact frame", bytes(damaged))
    script.send_as_it_is("the end of the cut frame", b"\n")


def random_frames(script: Script) -> None:
    """Send a seeded random sequence of requests, valid and damaged, near the next ID."""
    source = random.Random(script.info.data_bits)
    for _ in range(RANDOM_FRAMES):
        command = source.choice([name for name in COMMANDS if name not in {"GN", "K"}])
        number = script.gateway.expected + source.choice((0, 0, 0, 0, -1, 1, 2)) if source.random() < 0.8 else None
        if command == "Q":
            number = None
        body = script.body(command, *_random_values(script, command, source), number=number)
        frame = bytearray(script.frame(body) if source.random() < 0.8 else script.codec.framing.plain_request(body))
        if source.random() < 0.15:
            frame[source.randrange(len(frame))] ^= 1 << source.randrange(7)
        if b"N" not in frame.upper():
            script.send("random", bytes(frame))


def _random_values(script: Script, command: str, source: random.Random) -> Iterator[Any]:
    info = script.info
    addresses = [source.randrange(0xDC, 0xEC) for _ in range(source.randint(1, 6))]
    values = {
        "a": addresses[0],
        "d": source.randrange(1 << info.data_bits),
        "m": source.randrange(1 << info.data_bits),
        "n": len(addresses),
        "g": source.randrange(4),
        "f": source.choice((0, 0x10, 0x20, 0x30)),
        "v": 1,
        "s": source.randrange(4),
        "D": [source.randrange(1 << info.data_bits) for _ in range(source.randint(1, 6))],
        "A": addresses,
    }
    return (values[letter] for letter in COMMANDS[command].fields)


def generate(name: str) -> str:
    """Return the text of one file."""
    info, node = CONFIGURATIONS[name]
    script = Script(info, node)
    no_session(script)
    for part in (every_command, frames, forms, ranges, bus, sequence, groups, nodes, random_frames):
        script.begin(0)
        part(script)
    for part in (programs, fates):
        part(script)
    script.begin(0, program=True)
    random_frames(script)
    for program in (True, False) if script.asks_compact else ():
        script.begin(5, program=program)
        compact_form(script)
    return "".join(json.dumps(record) + "\n" for record in [script.header(), *script.records])


if __name__ == "__main__":
    for name in CONFIGURATIONS:
        (FOLDER / f"{name}.ndjson").write_text(generate(name))
