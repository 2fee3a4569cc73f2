"""The CRC of a frame, compared with the arithmetic of its definition."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.protocol.wire.arrays import crc_rows
from unity_link.protocol.wire.crc import Crc

USUAL = [(8, 0x07), (16, 0x1021), (32, 0x04C11DB7)]


def remainder(bits: int, polynomial: int, data: bytes) -> int:
    """Divide bit by bit, as the protocol defines the CRC: initial value 0, not reflected, no final xor."""
    value = int.from_bytes(data, "big") << bits
    divisor = 1 << bits | polynomial
    for position in range(value.bit_length() - 1, bits - 1, -1):
        if value >> position & 1:
            value ^= divisor << position - bits
    return value


@st.composite
def crcs(draw: st.DrawFn) -> Crc:
    bits = draw(st.sampled_from([8, 16, 32]))
    return Crc(bits, draw(st.integers(1, (1 << bits) - 1)))


def test_the_crcs_of_123456789_are_those_of_the_document() -> None:
    assert Crc().text(b"123456789") == b"31C3"
    assert Crc(8, 0x07).text(b"123456789") == b"F4"


@pytest.mark.parametrize(("bits", "polynomial"), USUAL)
@given(data=st.binary(max_size=100))
def test_compiled_crcs_are_the_remainder_of_the_division(bits: int, polynomial: int, data: bytes) -> None:
    assert Crc(bits, polynomial).of(data) == remainder(bits, polynomial, data)


@given(crc=crcs(), data=st.binary(max_size=60))
def test_any_polynomial_gives_the_remainder_of_the_division(crc: Crc, data: bytes) -> None:
    assert crc.of(data) == remainder(crc.bits, crc.polynomial, data)


@given(crc=crcs(), data=st.binary(max_size=20))
def test_the_text_has_all_digits_in_upper_case(crc: Crc, data: bytes) -> None:
    assert crc.text(data) == f"{crc.of(data):0{crc.bits // 4}X}".encode()


@given(crc=crcs() | st.sampled_from([Crc(*usual) for usual in USUAL]), data=st.data())
def test_the_crcs_of_rows_are_those_of_each_row_alone(crc: Crc, data: st.DataObject) -> None:
    length = data.draw(st.integers(1, 40))
    rows = data.draw(st.lists(st.binary(min_size=length, max_size=length), min_size=1, max_size=20))
    array = np.frombuffer(b"".join(rows), np.uint8).reshape(len(rows), length)
    begun = data.draw(st.integers(0, (1 << crc.bits) - 1))
    assert [row.tobytes() for row in crc_rows(crc, array, begun)] == [crc.text(row, begun) for row in rows]


@given(crc=crcs() | st.sampled_from([Crc(*usual) for usual in USUAL]), before=st.binary(), behind=st.binary())
def test_a_crc_continues_from_the_crc_of_the_bytes_before(crc: Crc, before: bytes, behind: bytes) -> None:
    assert crc.of(behind, crc.of(before)) == crc.of(before + behind)


@pytest.mark.parametrize("bits", [0, 4, 12, 24, 64])
def test_other_widths_are_refused(bits: int) -> None:
    with pytest.raises(ValueError, match="8, 16 or 32 bits"):
        Crc(bits, 1)


@pytest.mark.parametrize(("bits", "polynomial"), [(8, 0x107), (8, 0), (8, -7), (16, 0x10000), (32, 1 << 32)])
def test_a_polynomial_that_does_not_fit_is_refused(bits: int, polynomial: int) -> None:
    with pytest.raises(ValueError, match="does not fit"):
        Crc(bits, polynomial)
