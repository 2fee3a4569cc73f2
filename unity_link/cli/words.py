"""Numbers as people type and read them."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.protocol.configuration import GatewayInfo
    from unity_link.protocol.messages import Words


class Format(enum.StrEnum):
    """How a word is written."""

    HEX = "hex"
    DEC = "dec"
    SIGNED = "signed"
    BIN = "bin"


def parse_number(text: str) -> int:
    """Read a whole number in decimal, 0x or 0b form, perhaps negative.

    Raises:
        ValueError: where it is none.
    """
    try:
        return int(text, 0)
    except ValueError:
        hint = f"; did you mean 0x{text}?" if _is_hex(text) else ""
        raise ValueError(f"{text!r} is not a whole number like 10, 0x0A or 0b1010{hint}") from None


def _is_hex(text: str) -> bool:
    return bool(text) and all(character in "0123456789abcdefABCDEF" for character in text)


def to_word(value: int, bits: int) -> int:
    """Return the word that a typed value stands for; a negative one in two's complement.

    Raises:
        ArgumentError: where it does not fit in a word of `bits` bits.
    """
    lowest, highest = -(1 << bits - 1), (1 << bits) - 1
    if not lowest <= value <= highest:
        raise ArgumentError(f"{value} does not fit in a word of {bits} bits ({lowest} to {highest:#x})")
    return value & highest


def to_signed(word: int, bits: int) -> int:
    """Read a word in two's complement."""
    sign = 1 << bits - 1
    return (word ^ sign) - sign


def signed_words(words: Words, bits: int) -> list[int]:
    """Read words in two's complement."""
    return [to_signed(word, bits) for word in words.tolist()]


def in_form(word: int, bits: int, form: Format) -> str:
    """Write a word; hex and binary in the width that it has."""
    match form:
        case Format.HEX:
            return f"0x{word:0{-(-bits // 4)}X}"
        case Format.BIN:
            return f"0b{word:0{bits}b}"
        case Format.DEC:
            return str(word)
        case Format.SIGNED:
            return str(to_signed(word, bits))


def in_words(word: int, bits: int) -> str:
    """Write a word for a person: ``0x00000012 (18)``, and as a negative number where it may be one."""
    return f"{in_form(word, bits, Format.HEX)} ({as_decimal(word, bits)})"


def as_decimal(word: int, bits: int) -> str:
    """Write a word in decimal, and after it the negative number that it may mean."""
    negative = to_signed(word, bits)
    return f"{word} or {negative}" if negative < 0 else str(word)


def address_text(address: int, info: GatewayInfo) -> str:
    """Write an address in hex, in the width that it has."""
    return f"0x{address:0{info.address_digits}X}"
