"""Parses numbers that users type, and converts them from and to words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.numbers import to_signed
from unity_link.transport import is_url

if TYPE_CHECKING:
    from unity_link.protocol.wire.arrays import Words


def parse_number(text: str) -> int:
    """Parse a whole number in decimal, 0x or 0b form; it may be negative.

    Raises:
        ValueError: if the text is not such a number.
    """
    try:
        return int(text, 0)
    except ValueError:
        hint = f"; did you mean 0x{text}?" if _is_hex(text) else ""
        if is_url(text):
            hint = "; it is a URL, which goes before the addresses"
        raise ValueError(f"{text!r} is not a whole number like 10, 0x0A or 0b1010{hint}") from None


def _is_hex(text: str) -> bool:
    return bool(text) and all(character in "0123456789abcdefABCDEF" for character in text)


def to_word(value: int, bits: int) -> int:
    """Return the word for a typed value; a negative one in two's complement.

    Raises:
        ArgumentError: if it does not fit in a word of `bits` bits.
    """
    lowest, highest = -(1 << bits - 1), (1 << bits) - 1
    if not lowest <= value <= highest:
        raise ArgumentError(f"{value} does not fit in a word of {bits} bits ({lowest} to {highest:#x})")
    return value & highest


def signed_words(words: Words, bits: int) -> list[int]:
    """Return words as signed numbers, in two's complement."""
    return [to_signed(word, bits) for word in words.tolist()]
