"""The place of a gateway's description among its addresses, and its layout, as `docs/protocol.md` has them.

The 16 highest addresses are the words of a page, and the one below them is its number, which is written. The bytes of
all pages in a row, the lowest of a word first, are the length of the description (4 bytes), its CRC-32 (4, that of
RFC 1952), both with the lowest byte first, and then the description.
"""

from __future__ import annotations

import zlib

PAGE_WORDS = 16
MOST_PAGES = 256
"""Most pages: a word of 8 bits is the number of one."""
_HEADER = 8


def page_address(address_bits: int) -> int:
    """Return the address of the number of the page; behind it stand the words."""
    return (1 << address_bits) - 1 - PAGE_WORDS


def pages_of(length: int, data_bits: int) -> int:
    """Return the number of pages of a description of so many bytes."""
    return -(-(_HEADER + length) // (PAGE_WORDS * (data_bits // 8)))


def words_of(description: bytes, data_bits: int) -> list[int]:
    """Return the words of all pages of a description."""
    size = data_bits // 8
    check = zlib.crc32(description).to_bytes(4, "little")
    whole = len(description).to_bytes(4, "little") + check + description
    whole = whole.ljust(pages_of(len(description), data_bits) * PAGE_WORDS * size, b"\0")
    return [int.from_bytes(whole[at : at + size], "little") for at in range(0, len(whole), size)]


def length_of(words: list[int], data_bits: int) -> int:
    """Return the length of a description by the words of its first page, in bytes.

    Raises:
        ValueError: where no description can be that long.
    """
    length = int.from_bytes(_bytes(words, data_bits)[:4], "little")
    if not length or pages_of(length, data_bits) > MOST_PAGES:
        raise ValueError(f"its length is {length:,} bytes by its first word, and {MOST_PAGES} pages are the most")
    return length


def description_of(words: list[int], data_bits: int) -> bytes:
    """Return the description that the words of all pages hold.

    Raises:
        ValueError: where the words are damaged.
    """
    whole = _bytes(words, data_bits)
    description = whole[_HEADER : _HEADER + length_of(words, data_bits)]
    if zlib.crc32(description) != int.from_bytes(whole[4:_HEADER], "little"):
        raise ValueError("its CRC is wrong")
    return description


def _bytes(words: list[int], data_bits: int) -> bytes:
    size = data_bits // 8
    return b"".join((word & (1 << 8 * size) - 1).to_bytes(size, "little") for word in words)
