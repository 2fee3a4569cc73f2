"""Reads the worked examples of docs/protocol.md, so that tests check the document itself.

The top of that document explains the notation: `>` sent, `<` answered, `@` the state before.
"""

import re
from pathlib import Path

import msgspec

DOCUMENT = Path(__file__).parents[2] / "docs" / "protocol.md"
_ENDS = {"␍": "\r", "␊": "\n"}


class Example(msgspec.Struct, frozen=True):
    """One block of the document: an exchange with a gateway after a reset."""

    line: int
    """Line of the document at which the block begins."""
    memory: dict[int, int]
    bus_errors: frozenset[int]
    bus_timeouts: frozenset[int]
    node: int | None
    exchange: tuple[tuple[bytes, bytes], ...]
    """Pairs of bytes sent, and all bytes received before the next bytes are sent."""

    @property
    def frames(self) -> list[bytes]:
        """All frames in both directions, with their line ends."""
        return [frame for frame, _, _ in self.frames_in_sessions]

    @property
    def frames_in_sessions(self) -> list[tuple[bytes, bool, int]]:
        """All frames with their line ends; for each, True if the gateway sent it, and the number of its session."""
        found, session = list[tuple[bytes, bool, int]](), 0
        for pair in self.exchange:
            for text, from_gateway in zip(pair, (False, True), strict=True):
                for frame in text.splitlines(keepends=True):
                    found.append((frame, from_gateway, session))
                    # The ID, the new session, the session that it ended, and the CRC if the frame is checked.
                    if from_gateway and re.fullmatch(rb"K[0-9A-F]{11}([0-9A-F]{4}|\r)\n", frame):
                        session = int(frame[4:8], 16)
        return found


def worked_examples() -> list[Example]:
    """Return every example of the document, in order.

    Raises:
        ValueError: if a line has none of the notations.
    """
    text = DOCUMENT.read_text(encoding="utf-8")
    blocks = re.finditer(r"^```text\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    return [_example(block[1], text.count("\n", 0, block.start()) + 2) for block in blocks]


def _example(block: str, line: int) -> Example:
    memory: dict[int, int] = {}
    faults: dict[str, set[int]] = {"bus error": set(), "bus timeout": set()}
    node = None
    exchange: list[tuple[bytes, bytes]] = []
    for text in block.splitlines():
        if match := re.fullmatch(r"([<>]) ([^␍␊]*[␍␊]+)( {2}.*)?", text):
            frame = re.sub("[␍␊]", lambda end: _ENDS[end[0]], match[2]).encode("ascii")
            if match[1] == ">":
                exchange.append((frame, b""))
            else:
                sent, answered = exchange[-1]
                exchange[-1] = (sent, answered + frame)
        elif match := re.fullmatch(r"@ node: ([0-9A-F]{2})", text):
            node = int(match[1], 16)
        elif match := re.fullmatch(r"@ ([0-9A-F]{2}): ([0-9A-F]{8})", text):
            memory[int(match[1], 16)] = int(match[2], 16)
        elif match := re.fullmatch(r"@ ([0-9A-F]{2}): (bus error|bus timeout)", text):
            faults[match[2]].add(int(match[1], 16))
        else:
            raise ValueError(f"line {line} of {DOCUMENT.name} and after: {text!r} is no line of an example")
    return Example(
        line=line,
        memory=memory,
        bus_errors=frozenset(faults["bus error"]),
        bus_timeouts=frozenset(faults["bus timeout"]),
        node=node,
        exchange=tuple(exchange),
    )
