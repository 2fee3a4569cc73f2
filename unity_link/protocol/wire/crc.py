"""The check of a frame (docs/protocol.md, "Frames"): a CRC of 8, 16 or 32 bits, and the session in it.

It is not reflected, and there is no final xor. Its initial value is 0, or what stands in the CRC where a session's
number has been xored into it.

The usual polynomials are computed by fastcrc; every other one by a table of 256 remainders. `arrays` has the CRC of
many rows of equal length.
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
    # CKSUM is this CRC with a final xor.
    (32, 0x04C11DB7): lambda data, begun=0: fastcrc.crc32.cksum(data, begun ^ 0xFFFFFFFF) ^ 0xFFFFFFFF,
}
NO_SESSION = 0
"""Number of no session."""


def seed_of(session: int, *, from_gateway: bool) -> int:
    """Return what is xored into the CRC of a frame of a session before the first letter of its command.

    Args:
        session: number of the session, 0 for none, which leaves the CRC as it is.
        from_gateway: True for what a gateway sends, False for what a host sends.
    """
    return 2 * session + from_gateway if session else 0


def last_session(crc_digits: int) -> int:
    """Return the highest number of a session: with the direction it fits in a CRC of so many digits, and in 16 bits."""
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
        """Returns the CRC of bytes; a second argument is the CRC as what is before them left it, 0 if left out."""
        self.text = self.text_before(b"")
        """Returns the same as it stands in a frame: upper-case hex digits."""

    def text_before(self, end: bytes) -> Callable[..., bytes]:
        """Return a function that gives the CRC of bytes as it stands in a frame, and `end` behind it."""
        of, layout = self.of, b"%%0%dX" % self.digits + end
        if self.bits == 32:
            return lambda data, begun=0: layout % of(data, begun)
        # To look digits up takes half as long as to format them.
        last = [b"%02X" % value + end for value in range(256)]
        if self.bits == 8:
            return lambda data, begun=0: last[of(data, begun)]
        first = [b"%02X" % value for value in range(256)]

        def text(data: bytes, begun: int = 0) -> bytes:
            crc = of(data, begun)
            return first[crc >> 8] + last[crc & 0xFF]

        return text

    def begun(self, data: bytes, crc: int) -> int:
        """Return the value with which the CRC of bytes began, given the one with which it ended."""
        table, shift = byte_table(self.bits, self.polynomial), self.bits - 8
        # The lowest byte tells which entry went in last: each has another one, for a polynomial with the term 1.
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
    """Return the CRC of each single byte."""
    top, mask = 1 << bits - 1, (1 << bits) - 1
    table = []
    for byte in range(256):
        crc = byte << bits - 8
        for _ in range(8):
            crc = (crc << 1 & mask) ^ (polynomial if crc & top else 0)
        table.append(crc)
    return table
