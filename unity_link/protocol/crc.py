"""The check of a frame (docs/protocol.md, "Frames"): a CRC of 8, 16 or 32 bits.

It is not reflected, its initial value is 0, and there is no final xor.

The usual polynomials are computed by fastcrc; every other one by a table of 256 remainders. With an initial value of 0
the CRC is linear, so the CRC of many rows of equal length is one table look-up a column and an xor over the columns.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import fastcrc
import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

_COMPILED: dict[tuple[int, int], Callable[[bytes], int]] = {
    (8, 0x07): fastcrc.crc8.smbus,
    (16, 0x1021): fastcrc.crc16.xmodem,
    # CKSUM is this CRC with a final xor.
    (32, 0x04C11DB7): lambda data: fastcrc.crc32.cksum(data) ^ 0xFFFFFFFF,
}
_DTYPES: dict[int, type[np.unsignedinteger]] = {8: np.uint8, 16: np.uint16, 32: np.uint32}
_NIBBLE_TO_ASCII = np.frombuffer(b"0123456789ABCDEF", np.uint8)


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
        if bits not in _DTYPES:
            raise ValueError(f"a CRC has 8, 16 or 32 bits, not {bits}")
        if not 0 < polynomial < 1 << bits:
            raise ValueError(f"the polynomial {polynomial:#x} does not fit in a CRC of {bits} bits")
        self.bits = bits
        self.polynomial = polynomial
        self.digits = bits // 4
        self.of: Callable[[bytes], int] = _COMPILED.get((bits, polynomial), self._by_table)
        self.text = self._text()
        """Returns the CRC of bytes as it stands in a frame: upper-case hex digits."""

    def _text(self) -> Callable[[bytes], bytes]:
        of, layout = self.of, b"%%0%dX" % self.digits
        if self.bits != 8:
            return lambda data: layout % of(data)
        texts = [layout % value for value in range(256)]
        return lambda data: texts[of(data)]

    def of_rows(self, rows: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return the CRC of each row of bytes, shape (n, length), as hex digits, shape (n, digits)."""
        table = _column_table(self.bits, self.polynomial, rows.shape[1])
        crcs = np.bitwise_xor.reduce(table[np.arange(rows.shape[1]), rows], axis=1)
        shifts = np.arange(self.bits - 4, -1, -4, dtype=crcs.dtype)
        digits: NDArray[np.uint8] = _NIBBLE_TO_ASCII[(crcs[:, None] >> shifts) & 15]
        return digits

    def _by_table(self, data: bytes) -> int:
        table, shift, mask = _byte_table(self.bits, self.polynomial), self.bits - 8, (1 << self.bits) - 1
        crc = 0
        for byte in data:
            crc = (crc << 8 & mask) ^ table[crc >> shift ^ byte]
        return crc


@lru_cache
def _byte_table(bits: int, polynomial: int) -> list[int]:
    """Return the CRC of each single byte."""
    top, mask = 1 << bits - 1, (1 << bits) - 1
    table = []
    for byte in range(256):
        crc = byte << bits - 8
        for _ in range(8):
            crc = (crc << 1 & mask) ^ (polynomial if crc & top else 0)
        table.append(crc)
    return table


@lru_cache(maxsize=64)
def _column_table(bits: int, polynomial: int, length: int) -> NDArray[np.unsignedinteger]:
    """Return what each byte at each column of a row adds to the row's CRC, shape (length, 256)."""
    step = np.array(_byte_table(bits, polynomial), _DTYPES[bits])
    columns = np.empty((length, 256), _DTYPES[bits])
    columns[-1] = step
    for column in range(length - 2, -1, -1):
        after = columns[column + 1]
        # One more zero byte behind: the remainder moves up by eight bits.
        columns[column] = (after << 8 if bits > 8 else 0) ^ step[after >> bits - 8]
    return columns
