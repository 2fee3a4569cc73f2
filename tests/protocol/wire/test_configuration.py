"""The answer to `Q`: every configuration is decoded as it was encoded; impossible ones are refused with a reason."""

from __future__ import annotations

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.any_gateway import gateway_infos
from unity_link.errors import UnsupportedError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo

DEFAULT = b"032008031000001021FF0100FF0005F5E10002FAF08001000100007F00000000"


def test_the_default_configuration_is_that_of_the_document() -> None:
    assert GatewayInfo().to_hex() == DEFAULT


@given(info=gateway_infos())
def test_any_configuration_is_decoded_as_it_was_encoded(info: GatewayInfo) -> None:
    assert GatewayInfo.from_hex(info.to_hex()) == info


@given(info=gateway_infos(), appended=st.text("0123456789ABCDEF").map(str.encode))
def test_fields_that_a_later_version_appends_are_ignored(info: GatewayInfo, appended: bytes) -> None:
    assert GatewayInfo.from_hex(info.to_hex() + appended) == info


@given(info=gateway_infos())
def test_digits_of_a_configuration_may_be_in_lower_case(info: GatewayInfo) -> None:
    assert GatewayInfo.from_hex(info.to_hex().lower()) == info


def test_the_error_for_another_version_says_what_to_install() -> None:
    advice = (
        "the gateway speaks version 01 of the protocol and this program version 03: build the gateway anew with this "
        "version of unity-link, or install one that speaks 01"
    )
    with pytest.raises(UnsupportedError, match=advice):
        GatewayInfo.from_hex(b"01")
    with pytest.raises(UnsupportedError, match=r"version 1F .* install one that speaks 1F"):
        GatewayInfo.from_hex(b"1Fxyz")


@pytest.mark.parametrize("cut", range(len(DEFAULT)))
def test_a_cut_answer_is_refused(cut: int) -> None:
    with pytest.raises(ValueError, match="64 hex digits"):
        GatewayInfo.from_hex(DEFAULT[:cut])


@pytest.mark.parametrize("digit", [b"G", b" ", b"_", b"+", b"-", b"x", b"\xb2"], ids=repr)
def test_an_answer_with_a_character_that_is_no_hex_digit_is_refused(digit: bytes) -> None:
    for position in range(len(DEFAULT)):
        with pytest.raises(ValueError, match="64 hex digits"):
            GatewayInfo.from_hex(DEFAULT[:position] + digit + DEFAULT[position + 1 :])


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("data_bits", 7),
        ("data_bits", 65),
        ("address_bits", 7),
        ("address_bits", 33),
        ("id_digits", 1),
        ("id_digits", 4),
        ("block_words", 0),
        ("groups", 257),
        ("crc_bits", 0),
        ("crc_bits", 24),
        ("crc_polynomial", 0),
        ("crc_polynomial", 0x11021),
        ("base_frequency_millihertz", 0),
    ],
)
def test_an_impossible_width_is_refused_with_its_value(field: str, value: int) -> None:
    impossible = msgspec.structs.replace(GatewayInfo(), **{field: value})
    with pytest.raises(UnsupportedError, match=f"the gateway reports .*{value:#x}|{field} = {value}|{value} bits"):
        GatewayInfo.from_hex(impossible.to_hex())


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("base_frequency_millihertz", -1),
        ("base_frequency_millihertz", 1 << 40),
        ("features", 1 << 16),
        ("build_id", 1 << 32),
    ],
)
def test_a_number_with_too_many_digits_for_an_answer_is_refused(field: str, value: int) -> None:
    impossible = msgspec.structs.replace(GatewayInfo(), **{field: value})
    with pytest.raises(UnsupportedError, match=f"the gateway reports {field} = {value}, expected"):
        impossible.check()


@pytest.mark.parametrize(("data_bits", "is_possible"), [(8, True), (9, False), (12, False), (13, True), (36, False)])
def test_the_compact_form_needs_words_of_an_even_number_of_digits(data_bits: int, *, is_possible: bool) -> None:
    info = GatewayInfo(data_bits=data_bits, features=GatewayInfo().features | Feature.COMPACT)
    if is_possible:
        assert GatewayInfo.from_hex(info.to_hex()) == info
    else:
        with pytest.raises(UnsupportedError, match=f"data_bits = {data_bits}, expected words with an even number"):
            info.check()


def test_a_gateway_without_groups_needs_no_base_frequency() -> None:
    info = GatewayInfo(features=GatewayInfo().features & ~Feature.GROUPS, base_frequency_millihertz=0)
    assert GatewayInfo.from_hex(info.to_hex()) == info


@given(info=gateway_infos())
def test_the_number_of_digits_is_the_smallest_that_holds_the_bits(info: GatewayInfo) -> None:
    assert 4 * (info.address_digits - 1) < info.address_bits <= 4 * info.address_digits
    assert 4 * (info.data_digits - 1) < info.data_bits <= 4 * info.data_digits


def test_the_longest_request_of_the_default_build_is_a_block_write() -> None:
    assert GatewayInfo().longest_request == len("wm") + 3 + 2 + 255 * 8 + 4


def test_the_longest_request_may_be_a_group_a_mask_or_a_block_read() -> None:
    wide = GatewayInfo(address_bits=32, data_bits=8)
    assert wide.longest_request == len("gs") + 3 + 2 + 2 + 4 + 2 + 255 * 8 + 4
    narrow = msgspec.structs.replace(wide, block_words=1, features=Feature.MASKED_WRITE)
    assert narrow.longest_request == len("wk") + 3 + 8 + 2 + 2 + 4
    bare = msgspec.structs.replace(narrow, features=Feature(0))
    assert bare.longest_request == len("rm") + 3 + 8 + 2 + 4


def test_the_base_frequency_is_given_in_hertz() -> None:
    assert GatewayInfo(base_frequency_millihertz=1500).base_frequency_hz == 1.5
