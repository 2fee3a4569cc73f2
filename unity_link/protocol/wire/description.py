"""Addresses and layout of the description in a gateway's memory (docs/protocol.md, "Configuration").

The description is read in pages of 16 words. The 16 highest addresses of the bus contain the words of one page; a write
to the address below them selects the page. The bytes of all pages, in order and little-endian within each word, are:

- the length of the description in bytes: 4 bytes, little-endian
- the CRC-32 of the description (RFC 1952): 4 bytes, little-endian
- the description
"""

from __future__ import annotations

import zlib

PAGE_WORDS = 16
MOST_PAGES = 256
"""Most pages of a description: the page number fits in a word of 8 bits."""
_HEADER = 8
"""Bytes of the length and the CRC-32."""


def page_address(address_bits: int) -> int:
    """Return the address that selects the page; the words of the page follow it."""
    return (1 << address_bits) - 1 - PAGE_WORDS


def pages_of(length: int, data_bits: int) -> int:
    """Return the number of pages of a description of `length` bytes."""
    return -(-(_HEADER + length) // (PAGE_WORDS * (data_bits // 8)))


def words_of(description: bytes, data_bits: int) -> list[int]:
    """Return the words of all pages of a description."""
    size = data_bits // 8
    check = zlib.crc32(description).to_bytes(4, "little")
    whole = len(description).to_bytes(4, "little") + check + description
    whole = whole.ljust(pages_of(len(description), data_bits) * PAGE_WORDS * size, b"\0")
    return [int.from_bytes(whole[at : at + size], "little") for at in range(0, len(whole), size)]


def length_of(words: list[int], data_bits: int) -> int:
    """Return the length of a description in bytes, from the words of its first page.

    Raises:
        ValueError: if the length is 0, or more than `MOST_PAGES` pages.
    """
    length = int.from_bytes(_bytes(words, data_bits)[:4], "little")
    if not length or pages_of(length, data_bits) > MOST_PAGES:
        raise ValueError(f"its length is {length:,} bytes by its first word, and {MOST_PAGES} pages are the most")
    return length


def description_of(words: list[int], data_bits: int) -> bytes:
    """Return the description, from the words of all its pages.

    Raises:
        ValueError: if the CRC-32 is wrong.
    """
    whole = _bytes(words, data_bits)
    description = whole[_HEADER : _HEADER + length_of(words, data_bits)]
    if zlib.crc32(description) != int.from_bytes(whole[4:_HEADER], "little"):
        raise ValueError("its CRC is wrong")
    return description


def _bytes(words: list[int], data_bits: int) -> bytes:
    size = data_bits // 8
    return b"".join((word & (1 << 8 * size) - 1).to_bytes(size, "little") for word in words)
