"""Words, addresses and features as people give and read them."""

from __future__ import annotations

import enum
import math
from numbers import Real
from operator import index
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.protocol.configuration import GatewayInfo


class Format(enum.StrEnum):
    """Text form of a word."""

    HEX = "hex"
    DEC = "dec"
    SIGNED = "signed"
    BIN = "bin"


def whole_number(value: int, what: str) -> int:
    """Return a whole number of whatever type as an `int`: one of numpy wraps where it is reckoned with.

    Raises:
        ArgumentError: where it is none; a bool is none, though Python counts with it.
    """
    try:
        whole = index(value)
    except TypeError:
        raise ArgumentError(f"{what} is a whole number, not {value!r:.80}") from None
    if value is True or value is False:
        raise ArgumentError(f"{what} is a whole number, not {value}")
    return whole


def real_number(value: float, what: str) -> float:
    """Return a number of whatever type as a `float`; one beyond all of them is infinite.

    Raises:
        ArgumentError: where it is none; a bool is none, though Python counts with it.
    """
    given: object = value
    if isinstance(given, bool) or not isinstance(given, Real):
        raise ArgumentError(f"{what}, not {value!r:.80}")
    try:
        return float(value)
    except OverflowError:
        return math.copysign(math.inf, 1 if value > 0 else -1)


def to_signed(word: int, bits: int) -> int:
    """Read a word in two's complement."""
    sign = 1 << bits - 1
    return (word ^ sign) - sign


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
