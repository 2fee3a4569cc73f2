"""Values of every kind are the same after encoding and decoding, singly and as arrays."""

import json
import math
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import assume, given

from support.spec_examples import interface_of
from unity_link.errors import ArgumentError
from unity_link.spec import Enumeration, EnumValue, Kind, KindName, Signal
from unity_link.spec.columns import Columns

MODE = Enumeration("mode", (EnumValue("off", 0), EnumValue("on", 1), EnumValue("auto", 5)))
scales = st.one_of(st.just(1), st.floats(1e-9, 1e9), st.floats(-1e9, -1e-9), st.sampled_from([0.1, 2, -1, 360 / 4096]))
offsets = st.one_of(st.just(0), st.floats(-1e6, 1e6), st.integers(-1000, 1000))


@st.composite
def kinds(draw: st.DrawFn) -> Kind:
    name = draw(st.sampled_from(list(KindName)))
    width = draw(st.integers(1, 64))
    if name is KindName.BOOL:
        return Kind(name, 1)
    if name is KindName.FLOAT:
        return Kind(name, draw(st.sampled_from([16, 32, 64])))
    if name is KindName.ENUM:
        return Kind(name, max(3, width), enumeration=MODE)
    fraction = draw(st.integers(0, width)) if name in {KindName.FIXED, KindName.UFIXED} else 0
    kind = Kind(name, width, fraction, draw(scales), draw(offsets))
    assume(kind.is_exact())
    return kind


def signal_of(kind: Kind, word_bits: int, lowest_bit: int = 0) -> Signal:
    (signal,) = interface_of("@x = 0: READWRITE();", data_bits=word_bits).signals.values()
    return Signal(**{name: getattr(signal, name) for name in signal.__struct_fields__}
                  | {"kind": kind, "lowest_bit": lowest_bit, "word_bits": word_bits})  # fmt: skip


@given(kinds(), st.data())
def test_every_raw_word_is_converted_to_a_value_and_back(kind: Kind, data: st.DataObject) -> None:
    raw = data.draw(st.integers(0, (1 << kind.width) - 1))
    value = kind.decode(raw)
    if isinstance(value, float) and math.isnan(value):
        assert math.isnan(kind.decode(kind.encode(value)))
    else:
        assert kind.encode(value) == raw


@given(kinds(), st.data())
def test_a_value_between_two_raw_words_is_rounded_to_the_nearer_one(kind: Kind, data: st.DataObject) -> None:
    assume(kind.is_scaled)
    low, high = kind.range
    value = data.draw(st.floats(low, high))
    assert abs(kind.decode(kind.encode(value)) - value) <= abs(kind.step) * 0.5000001 + abs(value) * 1e-15


@given(kinds(), st.data())
def test_arrays_agree_with_single_values(kind: Kind, data: st.DataObject) -> None:
    raws = data.draw(st.lists(st.integers(0, (1 << kind.width) - 1), max_size=6))
    values = kind.decode_array(np.array(raws, np.uint64))
    assert values.dtype == kind.dtype
    np.testing.assert_array_equal(values, np.array([kind.decode(raw) for raw in raws], kind.dtype))
    if not (values.dtype.kind == "f" and np.isnan(values).any()):
        assert kind.encode_array(values).tolist() == raws


@given(kinds(), st.sampled_from([8, 16, 32, 64]), st.data())
def test_every_value_is_converted_to_the_words_of_a_signal_and_back(
    kind: Kind, word_bits: int, data: st.DataObject
) -> None:
    lowest = data.draw(st.integers(0, max(0, word_bits - kind.width)))
    signal = signal_of(kind, word_bits, lowest)
    raw = data.draw(st.integers(0, (1 << kind.width) - 1))
    value = kind.decode(raw)
    assume(value == value)  # noqa: PLR0124  (no NaN)
    encoded = signal.encode(value)
    assert len(encoded) == signal.words
    assert all(0 <= word < 1 << word_bits for word in encoded)
    other_bits = data.draw(st.integers(0, (1 << word_bits * signal.words) - 1)) & ~signal.mask
    words = [word | other_bits >> index * word_bits & (1 << word_bits) - 1 for index, word in enumerate(encoded)]
    assert signal.decode(words) == value
    columns = Columns([signal], list(signal.addresses))
    expected = kind.decode_array(np.array([raw, raw], np.uint64))
    np.testing.assert_array_equal(columns.decode([words, words])[signal.path], expected)
    received = np.array([words, words], f"u{word_bits // 8}")
    np.testing.assert_array_equal(columns.decode(received)[signal.path], expected)
    assert columns.encode({signal.path: kind.decode_array(np.array([raw], np.uint64))}).tolist() == [list(encoded)]


def test_columns_decode_a_group_of_many_kinds() -> None:
    interface = interface_of(
        "@a = 4: signed 16 READ(SCALE=0.5);",
        "@b = 4[31:31]: bool READ();",
        "@c = 5: unsigned 64 READ();",
        "@d = 7: float READ();",
        "@e = 8: mode 4 READ();",
        "@f = 9: signed 16 READ(SCALE=0.5);",
        outside="enum mode { off, on }",
    )
    signals = list(interface.signals.values())
    addresses = [9, 4, 5, 6, 7, 8]
    columns = Columns(signals, addresses)
    words = np.array([[0xFFFF, 0x8000_0002, 0xFFFF_FFFF, 1, 0x3FC0_0000, 1], [2, 3, 4, 5, 0, 0]], np.uint32)
    values = columns.decode(words)
    assert {path: column.tolist() for path, column in values.items()} == {
        "a": [1.0, 1.5],
        "f": [-0.5, 1.0],
        "b": [True, False],
        "c": [(1 << 33) - 1, (5 << 32) + 4],
        "d": [1.5, 0.0],
        "e": [1, 0],
    }
    assert columns.encode(values).tolist() == words.tolist()
    assert columns.decode(words[0])["a"] == 1.0
    assert {one.shape for one in columns.decode(words[0]).values()} == {()}
    with pytest.raises(ArgumentError, match=r"6 words a sample were expected, and the words have shape \(2, 5\)"):
        columns.decode(words[:, :5])
    with pytest.raises(ArgumentError, match="c has a word at 0x6"):
        Columns(signals, [4, 5, 7, 8, 9])


@pytest.mark.parametrize(
    ("declaration", "value", "message"),
    [
        ("unsigned 12", 4096, "x: 4096 is outside of 0 to 4095, the range of unsigned 12"),
        ("unsigned 12", -1, "x: -1 is outside of 0 to 4095, the range of unsigned 12"),
        ("signed 16", 32768, "x: 32768 is outside of -32768 to 32767, the range of signed 16"),
        ("signed 16", 1.5, "x: 1.5 is no value of signed 16: a whole number was expected"),
        ("fixed 8.8", 128.0, "x: 128.0 is outside of -128 to 127.99609375, the range of fixed 8.8"),
        ("fixed 8.8", math.nan, "x: nan is no value of fixed 8.8: a finite number was expected"),
        ("float 16", 1e6, "x: 1000000.0 is too large for float 16"),
        ("float", "1", "x: '1' is no value of float 32: a number was expected"),
        ("bool", 2, "x: 2 is outside of 0 to 1, the range of bool"),
        ("mode 4", "of", "x: 'of' is no value of mode: off, on are"),
    ],
)
def test_a_value_that_a_kind_cannot_represent_is_refused(declaration: str, value: float | str, message: str) -> None:
    signal = interface_of(f"@x = 1: {declaration} WRITE();", outside="enum mode { off, on = 5 }").signals["x"]
    with pytest.raises(ArgumentError) as caught:
        signal.encode(value)
    assert str(caught.value) == message
    with pytest.raises(ArgumentError):
        signal.kind.encode_array(np.array([value, value]))


def test_limits_apply_to_written_values_but_not_to_read_ones() -> None:
    signal = interface_of('@x = 1: signed 16 READWRITE(SCALE=0.1, UNIT="deg", MIN=-90, MAX=90);').signals["x"]
    assert signal.encode(-90) == (0xFFFF & -900,)
    assert signal.decode(1000) == 100
    with pytest.raises(ArgumentError, match=r"^x: 90\.1 is outside of its limits, -90 to 90 deg$"):
        signal.encode(90.1)


def test_an_enumeration_accepts_names_members_and_numbers() -> None:
    signal = interface_of("@x = 1: mode READWRITE();", outside="enum mode { off, on = 5 }").signals["x"]
    kind = signal.kind
    assert kind.enumeration is not None
    on = kind.enumeration.python_type["on"]
    assert signal.encode("on") == signal.encode(on) == signal.encode(5) == (5,)
    assert signal.decode(5) is on
    assert signal.decode(3) == 3
    assert type(signal.decode(3)) is int


def test_an_array_of_names_is_encoded_as_its_members() -> None:
    signal = interface_of("@x = 1: mode READWRITE();", outside="enum mode { off, on = 5 }").signals["x"]
    assert signal.kind.encode_array(np.array([["on", "off"]])).tolist() == [[5, 0]]


def test_whole_floats_and_numpy_numbers_are_accepted_as_integers() -> None:
    signal = interface_of("@x = 1: signed 16 WRITE();").signals["x"]
    numbers: list[Any] = [np.int8(-2), np.float32(-2)]
    assert signal.encode(-2.0) == signal.encode(numbers[0]) == signal.encode(numbers[1]) == (0xFFFE,)


def test_an_enumeration_always_has_the_same_class() -> None:
    made = MODE.python_type
    for number in range(200):
        assert Enumeration(f"other_{number}", MODE.values).python_type is not made
    assert MODE.python_type is made
    assert Kind(KindName.ENUM, 3, enumeration=MODE).decode(5) is made["auto"]


def test_a_value_of_an_enumeration_is_equal_to_its_name_and_to_its_number() -> None:
    kind = Kind(KindName.ENUM, 8, enumeration=MODE)
    first, second = MODE.values[0], MODE.values[1]
    value: Any = kind.decode(first.value)
    assert value == first.name
    assert first.name == value
    assert value == first.value
    assert value != second.name
    assert (value != first.name) is False
    assert hash(value) == hash(first.value)
    assert (f"{value}", f"{value:d}", json.dumps(value)) == (first.name, str(first.value), str(first.value))
    with pytest.raises(ArgumentError, match="'sleeping' is no value of"):
        assert value == "sleeping"


def test_columns_of_an_enumeration_are_equal_to_names() -> None:
    kind = Kind(KindName.ENUM, 8, enumeration=MODE)
    first, second = MODE.values[0], MODE.values[1]
    column: Any = kind.decode_array(np.array([first.value, second.value, 200], np.uint8))
    assert (column == first.name).tolist() == [True, False, False]
    assert (column[1:] != second.name).tolist() == [False, True]
    assert (column == second.value).tolist() == [False, True, False]
    assert [one == second.name for one in column[:2]] == [False, True]
    assert (column[2], column.tolist()) == (200, [first.value, second.value, 200])
    assert type(column == first.name) is np.ndarray
    with pytest.raises(ArgumentError, match="'sleeping' is no value of"):
        assert column == "sleeping"


@pytest.mark.parametrize("kind", [
    Kind(KindName.SIGNED, 12, scale=1 / 2047), Kind(KindName.UNSIGNED, 1), Kind(KindName.FLOAT, 32),
    Kind(KindName.UFIXED, 16, 8), Kind(KindName.ENUM, 8, enumeration=MODE),
], ids=str)  # fmt: skip
def test_a_bool_is_refused_as_a_number(kind: Kind) -> None:
    truths: tuple[Any, ...] = (True, np.True_)
    for truth in truths:
        with pytest.raises(ArgumentError, match=r"True is no value of .*: a number was expected"):
            kind.encode(truth)
    for several in ([True, False], [0, True], (True, 0.5), np.array([True])):
        with pytest.raises(ArgumentError, match=r"is no value of .*: a number was expected"):
            kind.encode_array(several)


def test_a_bool_accepts_the_numbers_0_and_1_too() -> None:
    kind = Kind(KindName.BOOL, 1)
    truths: tuple[Any, ...] = (True, 1, 1.0, np.True_, np.float64(1))
    for truth in truths:
        assert kind.encode(truth) == 1
    assert kind.encode_array([True, 0, 1.0]).tolist() == [1, 0, 1]
    for wrong in (2, 0.5):
        with pytest.raises(ArgumentError):
            kind.encode(wrong)
