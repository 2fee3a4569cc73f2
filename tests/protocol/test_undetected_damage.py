"""The damages that the check of a frame finds for sure, and those that it cannot: the figures of docs/protocol.md.

With an initial value of 0 the CRC is linear: damage passes if the CRC of the difference of the texts is the difference
of the CRCs. So it is enough to look at differences. The CRC stands in the frame as hexadecimal digits, whose characters
differ in other bits than the numbers do: a single flipped bit can change three bits of a number.
"""

import functools

import numpy as np
import pytest

from unity_link.protocol.arrays import crc_rows
from unity_link.protocol.crc import Crc

CRC_8, CRC_16 = Crc(8, 0x07), Crc(16, 0x1021)
SENT, READ = b"0123456789ABCDEF", b"0123456789ABCDEFabcdef"


def flips(difference: int) -> int:
    """Return the fewest bits to flip in the character of a digit so that its number differs by `difference`."""
    return min(
        (sent ^ read).bit_count()
        for sent in SENT
        for read in READ
        if int(chr(sent), 16) ^ int(chr(read), 16) == difference
    )


FLIPS = [flips(difference) for difference in range(16)]


@functools.cache
def flips_in_digits(difference: int, digits: int) -> int:
    """Return the fewest bits to flip in the digits of a CRC so that it differs by `difference`."""
    return sum(FLIPS[difference >> 4 * place & 15] for place in range(digits))


def fewest_flips_that_pass(crc: Crc, length: int) -> int:
    """Return the fewest flipped bits by which a frame with so many characters before its CRC can pass as another."""
    singles = [crc.of(bytes([1 << bit]) + bytes(behind)) for behind in range(length) for bit in range(8)]
    fewest = 1 + min(flips_in_digits(single, crc.digits) for single in singles)
    known = set(singles)
    if len(known) < len(singles):
        return min(fewest, 2)
    one_digit = [value for value in range(1 << crc.bits) if flips_in_digits(value, crc.digits) == 1]
    if any(single ^ value in known for single in singles for value in one_digit):
        return min(fewest, 3)
    # Both polynomials are multiples of x + 1, so three flips in the text alone are found.
    return min(fewest, 4)


@pytest.mark.parametrize(("crc", "characters"), [(CRC_8, 1), (CRC_16, 2)], ids=["CRC-8", "CRC-16"])
def test_damage_to_as_many_adjacent_characters_as_the_crc_has_bytes_is_found(crc: Crc, characters: int) -> None:
    differences = np.arange(1 << crc.bits, dtype=f">u{characters}").view(np.uint8).reshape(-1, characters)
    # No two have the same CRC, wherever they stand: what follows multiplies all by the same.
    assert len(np.unique(crc_rows(crc, differences), axis=0)) == 1 << crc.bits


def test_damage_to_the_last_character_and_the_first_digit_of_a_crc_16_is_found() -> None:
    # It changes other digits, too.
    assert all(CRC_16.of(bytes([last])) & 0xFFF for last in range(1, 256))


@pytest.mark.parametrize("crc", [CRC_8, CRC_16], ids=["CRC-8", "CRC-16"])
def test_one_of_all_values_of_the_crc_passes_of_the_damages_to_a_text(crc: Crc) -> None:
    patterns = np.arange(1 << 24, step=1 << 8, dtype=">u4").view(np.uint8).reshape(-1, 4)
    _, counts = np.unique(crc_rows(crc, patterns), axis=0, return_counts=True)
    assert set(counts) == {len(patterns) >> crc.bits}


@pytest.mark.parametrize(
    ("crc", "length", "fewest"),
    [(CRC_8, 1, 2), (CRC_16, 10, 4), (CRC_16, 11, 3), (CRC_16, 1560, 3), (CRC_16, 1561, 2)],
)
def test_fewer_flipped_bits_than_the_distance_never_pass(crc: Crc, length: int, fewest: int) -> None:
    assert fewest_flips_that_pass(crc, length) == fewest


def test_more_characters_never_raise_the_distance_so_its_steps_tell_it_for_every_length() -> None:
    assert fewest_flips_that_pass(CRC_16, 1) == 4
    assert fewest_flips_that_pass(CRC_16, 2040) == 2
