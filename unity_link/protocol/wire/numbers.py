"""Numbers from programs, checked; and words and addresses as text for people."""

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
"""Most bits of a number in a gateway: one word of 64 bits, or two of 32."""
MOST_SECONDS = 1e9
"""Longest duration in seconds that a program can pass, about 30 years."""

RATE = (1e-6, 1e9)
"""Lowest and highest sample rate in Hz, in a spec and in a program."""


class Format(enum.StrEnum):
    """Text form of a word."""

    HEX = "hex"
    DEC = "dec"
    SIGNED = "signed"
    BIN = "bin"


def whole_number(value: int, what: str) -> int:
    """Return a whole number of any type as an `int`, because arithmetic on integers of numpy can overflow.

    Args:
        value: the number.
        what: its name, as the subject of the error.

    Raises:
        ArgumentError: if the value is no whole number, is a bool, or has more than 64 bits.
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
    """Return a real number of any type as a finite `float`.

    Args:
        value: the number.
        what: beginning of the error, with the name and the expectation: ``a rate is a number of Hz``.

    Raises:
        ArgumentError: if the value is no number, is a bool, NaN or an infinity, or is too large for a float.
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
    """Return a duration in seconds, above 0 and at most `MOST_SECONDS`.

    Args:
        value: the duration in seconds.
        what: beginning of the error, with the name and the expectation.
        zero: accept 0 too.

    Raises:
        ArgumentError: if the value is not in that range.
    """
    seconds = real_number(value, what)
    if seconds < 0 or (seconds == 0 and not zero) or seconds > MOST_SECONDS:
        more = f", {MOST_SECONDS:g} at most" if seconds > MOST_SECONDS else ""
        raise ArgumentError(f"{what}{more}, not {shown(value)}")
    return seconds


def to_signed(word: int, bits: int) -> int:
    """Return the signed value of a word of `bits` bits in two's complement."""
    sign = 1 << bits - 1
    return (word ^ sign) - sign


def in_form(word: int, bits: int, form: Format) -> str:
    """Return a word as text; hex and binary forms have all digits of the width."""
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
    """Return a word as text in hex and decimal: ``0x00000012 (18)`` or ``0xFFFFFFFF (4294967295 or -1)``."""
    return f"{in_form(word, bits, Format.HEX)} ({as_decimal(word, bits)})"


def as_decimal(word: int, bits: int) -> str:
    """Return a word as decimal text; if its highest bit is set, with its signed value: ``4294967295 or -1``."""
    negative = to_signed(word, bits)
    return f"{word} or {negative}" if negative < 0 else str(word)


def address_text(address: int, info: GatewayInfo) -> str:
    """Return an address as hex text with all digits of the gateway's width."""
    return f"0x{address:0{info.address_digits}X}"
