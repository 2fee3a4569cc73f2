"""Frames of a host in text and compact form, whole and damaged, for comparison with the gateway on the page."""

from __future__ import annotations

import random
import re
from typing import TYPE_CHECKING

from protocol_model.gateway_on_the_page import CR, END, ESCAPE, LF, START, Cutter, GatewayOnThePage, Widths

if TYPE_CHECKING:
    from collections.abc import Iterator

RESERVED = bytes((START, END, ESCAPE, LF, CR))
_HARMLESS = b"\x00\x11\x13\x30\x72\x93\xff"
HOSTS = [
    Widths(),
    Widths(id_digits=2, crc_bits=8, polynomial=0x07, address_digits=3),
    Widths(crc_bits=32, polynomial=0x04C11DB7, address_digits=8, node=5),
    Widths(id_digits=2, node=0xB5),
]
"""Widths of the frames that tests send to a host."""
FRAMES = 100
"""Number of frames that `from_a_gateway` returns."""


class Mixture:
    """A host that follows the protocol, on a line that damages frames.

    Args:
        gateway: receives each piece; its state gives the next ID.
        rng: random source.
        damage: fraction of damaged pieces, from 0 to 1.
        most_words: largest number of words in a block.
    """

    def __init__(
        self, gateway: GatewayOnThePage, rng: random.Random, *, damage: float = 0.5, most_words: int = 8
    ) -> None:
        self._gateway, self._rng, self._damage, self._most_words = gateway, rng, damage, most_words

    def pieces(self, count: int) -> Iterator[tuple[bytes, bytes]]:
        """Yield frames as they arrive, each with the answers of the gateway on the page."""
        for _ in range(count):
            piece = self._frame()
            if self._rng.random() < self._damage:
                piece = self.damaged(piece)
            yield piece, b"".join(self._gateway.answers(piece))

    # Frames of a host

    def _frame(self) -> bytes:
        draw, widths = self._rng.random(), self._gateway.widths
        if draw < 0.03:
            return self._rng.choice([b"\n", b"\r", b"\r\n", bytes((START, END)), bytes((START, END, LF))])
        if draw < 0.06:
            return self._garbage()
        body = self._body()
        text = widths.prefix + body
        if self._rng.random() < 0.05 and widths.prefix:
            text = self._rng.choice(["ZFF", "Z00", ""]) + body
        if draw < 0.16:
            return text.encode("latin-1") + b"\r"
        small = "a" <= body[:1] <= "z"
        seed = self._gateway.seed if small else 0
        if self._rng.random() < 0.03:
            # The seed of another session, or of a gateway's frames.
            seed ^= self._rng.choice([1, 2, 0x1236])
        text += f"{widths.crc(text, seed & (1 << widths.crc_bits) - 1):0{widths.crc_digits}X}"
        if self._rng.random() < 0.35 or not text.startswith(widths.prefix):
            return text.encode("latin-1") + b"\n"
        return widths.pack(text, from_gateway=False)

    def _body(self) -> str:
        rng, gateway = self._rng, self._gateway
        widths = gateway.widths
        if rng.random() < (0.01 if gateway.session else 0.7):
            return self._opening()
        command = rng.choice(["r", "w", "ws", "h", "rm", "wm", "rq", "wq", "wk", "w", "r", "gp", "i", "n", "x", "P"])
        fields = self._fields(command)
        if rng.random() < 0.2:
            return rng.choice([command.upper(), command.upper(), "Q", "K", "H", "GS"]) + fields
        number = gateway.expected
        draw = rng.random()
        if draw < 0.25:
            number -= rng.choice([1, 1, 2, 3, rng.randrange(widths.ring)])
        elif draw < 0.35:
            number += rng.choice([1, 2, rng.randrange(widths.ring)])
        return f"{command}{number % widths.ring:0{widths.id_digits}X}{fields}"

    def _opening(self) -> str:
        widths = self._gateway.widths
        high = 1 << 4 * widths.session_digits - 1
        number = self._rng.choice(
            [self._rng.randrange(1, high), self._rng.randrange(1, high), 0, self._gateway.session]
        )
        asked = number | self._rng.choice([high, high, high, 0])
        return f"K{self._rng.randrange(widths.ring):0{widths.id_digits}X}{asked:0{widths.session_digits}X}"

    def _fields(self, command: str) -> str:
        rng, widths = self._rng, self._gateway.widths
        address = rng.choice([0x0A, 0x0D, 0xB5, 0xCA, 0xD3, rng.randrange(256)])
        a, d = f"{address:0{widths.address_digits}X}", widths.data_digits
        count = rng.choice([0, 1, 2, rng.randrange(1, self._most_words + 1)])
        group = f"{rng.choice([0, 1, 2, 3, 0xFF]):02X}"
        zeros = "0" * rng.choice([0, 2, d])
        return {
            "r": a,
            "rm": f"{a}{count:02X}",
            "rq": f"{a}{count:02X}",
            "w": a + self._words(1),
            "ws": a + self._words(1),
            "wk": a + self._words(2),
            "wm": a + self._words(max(count, 1)),
            "wq": a + self._words(max(count, 1)),
            "h": "",
        }.get(command, group if command in ("gn", "gx", "gp", "i") else zeros)

    def _words(self, count: int) -> str:
        digits = self._gateway.widths.data_digits
        pairs = [
            self._rng.choice(["B5", "CA", "D3", "0A", "0D", "00", "11", "93", "FF"]) for _ in range(count * digits)
        ]
        return "".join(pairs)[: count * digits]

    def _garbage(self) -> bytes:
        return bytes(self._rng.choice(RESERVED + _HARMLESS) for _ in range(self._rng.randrange(1, 12)))

    # Damage

    def damaged(self, piece: bytes) -> bytes:
        rng = self._rng
        at = rng.randrange(len(piece))
        draw = rng.random()
        if draw < 0.3:
            # Prefer the end of a frame, because most rules of cut frames are about ends.
            at = max(len(piece) - rng.randrange(1, 4), 0)
        byte, before, after = piece[at], piece[:at], piece[at + 1 :]
        reserved = rng.choice(RESERVED)
        # An unnecessary escape, or an escape before a reserved byte, which cuts the frame.
        escaped = bytes((ESCAPE, byte ^ rng.choice([0, 0x40])))
        return rng.choice(
            [
                before + after,
                before + bytes((reserved,)) + after,
                before + bytes((reserved, byte)) + after,
                before,
                piece[at:],
                before + bytes((byte ^ 1 << rng.randrange(8),)) + after,
                before + escaped + after,
                before + self._garbage() + piece[at:],
            ]
        )


def from_a_gateway(widths: Widths, seed: int) -> list[bytes]:
    """Return frames of a gateway, whole and damaged; the last one is whole."""
    rng = random.Random(seed)
    hosts = Mixture(GatewayOnThePage(widths), rng)
    pieces = []
    for piece, answer in hosts.pieces(FRAMES):
        sent = answer or piece
        pieces.append(hosts.damaged(sent) if sent and rng.random() < 0.5 else sent)
    return [*pieces, bytes((LF, START, END))]


def lines_on_the_page(widths: Widths, data: bytes) -> list[bytes]:
    """Return the text of each non-empty frame of a gateway, with its end."""
    frames = Cutter(widths, from_gateway=True).take(data)
    return lines_in(b"".join(frame.text.encode("latin-1") + (b"\r" if frame.plain else b"\n") for frame in frames))


def lines_in(text: bytes) -> list[bytes]:
    """Return the non-empty lines of a text, with their ends."""
    return [line for line in re.findall(rb"[^\r\n]*[\r\n]", text) if line.strip(b"\r\n")]
