"""The check of a frame (docs/protocol.md, "Frames"): a CRC of 8, 16 or 32 bits.

It is not reflected, its initial value is 0, and there is no final xor.

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
_COMPILED: dict[tuple[int, int], Callable[[bytes], int]] = {
    (8, 0x07): fastcrc.crc8.smbus,
    (16, 0x1021): fastcrc.crc16.xmodem,
    # CKSUM is this CRC with a final xor.
    (32, 0x04C11DB7): lambda data: fastcrc.crc32.cksum(data) ^ 0xFFFFFFFF,
}


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
        self.of: Callable[[bytes], int] = _COMPILED.get((bits, polynomial), self._by_table)
        self.text = self.text_before(b"")
        """Returns the CRC of bytes as it stands in a frame: upper-case hex digits."""

    def text_before(self, end: bytes) -> Callable[[bytes], bytes]:
        """Return a function that gives the CRC of bytes as it stands in a frame, and `end` behind it."""
        of, layout = self.of, b"%%0%dX" % self.digits + end
        if self.bits == 32:
            return lambda data: layout % of(data)
        # To look digits up takes half as long as to format them.
        last = [b"%02X" % value + end for value in range(256)]
        if self.bits == 8:
            return lambda data: last[of(data)]
        first = [b"%02X" % value for value in range(256)]

        def text(data: bytes) -> bytes:
            crc = of(data)
            return first[crc >> 8] + last[crc & 0xFF]

        return text

    def _by_table(self, data: bytes) -> int:
        table, shift, mask = byte_table(self.bits, self.polynomial), self.bits - 8, (1 << self.bits) - 1
        crc = 0
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
