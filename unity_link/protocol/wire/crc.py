"""The CRC of a frame (docs/protocol.md, "Frames"): 8, 16 or 32 bits, not reflected, without a final xor.

The CRC covers the node prefix and the body, and begins with 0. In a session, the seed (`seed_of`) is xored into the CRC
after the prefix, so a frame of another session or direction fails the check.

fastcrc computes the usual polynomials, and a table of 256 remainders every other one. `arrays` computes the CRCs of
many frames of equal length.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import fastcrc

if TYPE_CHECKING:
    from collections.abc import Callable

USUAL_POLYNOMIALS = {8: 0x07, 16: 0x1021, 32: 0x04C11DB7}
"""Usual polynomial of each width: CRC-8/CCITT, CRC-16/XMODEM, and that of Ethernet."""
_COMPILED: dict[tuple[int, int], Callable[..., int]] = {
    (8, 0x07): fastcrc.crc8.smbus,
    (16, 0x1021): fastcrc.crc16.xmodem,
    # CKSUM is this CRC with a final xor, and fastcrc complements the initial value as well.
    (32, 0x04C11DB7): lambda data, begun=0: fastcrc.crc32.cksum(data, begun ^ 0xFFFFFFFF) ^ 0xFFFFFFFF,
}
NO_SESSION = 0
"""Session number that means that there is no session."""


def seed_of(session: int, *, from_gateway: bool) -> int:
    """Return the value that is xored into the CRC of a session's frames, before the first letter of the command.

    Args:
        session: number of the session; 0 for none, which has the seed 0.
        from_gateway: True for frames of the gateway, False for frames of the host.
    """
    return 2 * session + from_gateway if session else 0


def last_session(crc_digits: int) -> int:
    """Return the highest session number: the number and a bit for the direction fit in the CRC and in 16 bits."""
    return (1 << 4 * min(crc_digits, 4) - 1) - 1


class Crc:
    """CRC of one width and polynomial.

    Args:
        bits: 8, 16 or 32.
        polynomial: without its highest term, 0 to 2**bits - 1; the default is CRC-16/XMODEM, and CRC-8/CCITT is
            ``Crc(8, 0x07)``.

    Raises:
        ValueError: for another width, or a polynomial that does not fit in it.
    """

    def __init__(self, bits: int = 16, polynomial: int = 0x1021) -> None:
        if bits not in (8, 16, 32):
            raise ValueError(f"a CRC has 8, 16 or 32 bits, not {bits}")
        if not 0 < polynomial < 1 << bits:
            raise ValueError(f"the polynomial {polynomial:#x} does not fit in a CRC of {bits} bits")
        self.bits = bits
        self.polynomial = polynomial
        self.digits = bits // 4
        self.of: Callable[..., int] = _COMPILED.get((bits, polynomial), self._by_table)
        """Returns the CRC of bytes; the second argument is the initial value, 0 by default."""
        self.text = self.text_before(b"")
        """As `of`, but returns the CRC as upper-case hex digits."""

    def text_before(self, end: bytes) -> Callable[..., bytes]:
        """Return a function that returns the CRC of bytes as upper-case hex digits, followed by `end`."""
        of, layout = self.of, b"%%0%dX" % self.digits + end
        if self.bits == 32:
            return lambda data, begun=0: layout % of(data, begun)
        # A table of digits takes half the time of formatting.
        last = [b"%02X" % value + end for value in range(256)]
        if self.bits == 8:
            return lambda data, begun=0: last[of(data, begun)]
        first = [b"%02X" % value for value in range(256)]

        def text(data: bytes, begun: int = 0) -> bytes:
            crc = of(data, begun)
            return first[crc >> 8] + last[crc & 0xFF]

        return text

    def begun(self, data: bytes, crc: int) -> int:
        """Return the initial value of the CRC of some bytes, given its final value: the CRC run backwards."""
        table, shift = byte_table(self.bits, self.polynomial), self.bits - 8
        # The polynomial has the term 1, so the lowest bytes of all entries differ and identify the last entry used.
        entries = {entry & 0xFF: place for place, entry in enumerate(table)}
        for byte in reversed(data):
            place = entries[crc & 0xFF]
            crc = (crc ^ table[place]) >> 8 | (place ^ byte) << shift
        return crc

    def _by_table(self, data: bytes, begun: int = 0) -> int:
        table, shift, mask = byte_table(self.bits, self.polynomial), self.bits - 8, (1 << self.bits) - 1
        crc = begun
        for byte in data:
            crc = (crc << 8 & mask) ^ table[crc >> shift ^ byte]
        return crc


@lru_cache
def byte_table(bits: int, polynomial: int) -> list[int]:
    """Return the CRC of each single byte from 0 to 255, with the initial value 0."""
    top, mask = 1 << bits - 1, (1 << bits) - 1
    table = []
    for byte in range(256):
        crc = byte << bits - 8
        for _ in range(8):
            crc = (crc << 1 & mask) ^ (polynomial if crc & top else 0)
        table.append(crc)
    return table
