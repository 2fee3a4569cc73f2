"""Words, addresses and features as people give and read them."""

from __future__ import annotations

import enum
import math
from numbers import Real
from operator import index
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, shown

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo


MOST_BITS = 64
"""Bits of the longest number that a gateway has: a value of 64 bits, or two words of 32."""
MOST_SECONDS = 1e9
"""Seconds of the longest time that a program can ask for, some thirty years."""

RATE = (1e-6, 1e9)
"""Lowest and highest rate of samples in Hz that a spec can say, and a host can be asked for."""


class Format(enum.StrEnum):
    """Text form of a word."""

    HEX = "hex"
    DEC = "dec"
    SIGNED = "signed"
    BIN = "bin"


def whole_number(value: int, what: str) -> int:
    """Return a whole number of whatever type as an `int`: one of numpy wraps where it is reckoned with.

    Raises:
        ArgumentError: if the value is no whole number, is a bool, or takes more than 64 bits.
    """
    try:
        whole = index(value)
    except TypeError:
        raise ArgumentError(f"{what} is a whole number, not {shown(value)}") from None
    if value is True or value is False:
        raise ArgumentError(f"{what} is a whole number, not {value}")
    if whole.bit_length() > MOST_BITS:
        raise ArgumentError(f"{what} is a whole number of up to {MOST_BITS} bits, not {shown(value)}")
    return whole


def real_number(value: float, what: str) -> float:
    """Return a number of whatever type as a finite `float`.

    Raises:
        ArgumentError: if the value is no number, is a bool, NaN or an infinity, or is beyond all floats.
    """
    given: object = value
    if not isinstance(given, bool) and isinstance(given, Real):
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isfinite(number):
            return number
    raise ArgumentError(f"{what}, not {shown(value)}")


def seconds_from(value: float, what: str, *, zero: bool = False) -> float:
    """Return a number of seconds from above 0 to `MOST_SECONDS`, or from 0 on.

    Raises:
        ArgumentError: if the value is no such number.
    """
    seconds = real_number(value, what)
    if seconds < 0 or (seconds == 0 and not zero) or seconds > MOST_SECONDS:
        more = f", {MOST_SECONDS:g} at most" if seconds > MOST_SECONDS else ""
        raise ArgumentError(f"{what}{more}, not {shown(value)}")
    return seconds


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
