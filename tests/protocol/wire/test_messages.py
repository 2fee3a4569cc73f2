"""Each side decodes the messages of the other in every width; arrays give the results of single calls."""

from __future__ import annotations

import re
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.any_gateway import gateway_infos
from support.worked_examples import Example, worked_examples
from unity_link.protocol.wire.arrays import parse_words, request_rows, response_rows
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.messages import (
    COMMANDS,
    LISTS,
    WITHOUT_ID,
    Codec,
    DecodedRequest,
    DecodedResponse,
    ErrorCode,
    RequestError,
    hex_text,
    parse_numbers,
)

ALL_FEATURES = st.builds(lambda info: Codec(with_all(info)), gateway_infos())
DEFAULT = Codec(GatewayInfo())


def with_all(info: GatewayInfo) -> GatewayInfo:
    return msgspec.structs.replace(info, features=GatewayInfo().features)


def field(codec: Codec, letter: str) -> st.SearchStrategy[Any]:
    if letter in LISTS:
        return st.lists(field(codec, LISTS[letter]), min_size=1, max_size=255 if letter == "D" else 20)
    return st.integers(0, 16 ** codec.digits[letter] - 1)


@st.composite
def requests(draw: st.DrawFn, codec: Codec) -> DecodedRequest:
    """Return any request, with or without an ID."""
    command = draw(st.sampled_from(sorted(COMMANDS)))
    values = [draw(field(codec, letter)) for letter in COMMANDS[command].fields]
    if command == "GS":
        values[3] = len(values[4])
    number = None if command in WITHOUT_ID else draw(st.none() | st.integers(0, codec.id_count - 1))
    return DecodedRequest(command, number, tuple(values))


def body_of(codec: Codec, request: DecodedRequest) -> bytes:
    fields = codec.fields(
        request.command, *(np.array(v, np.uint64) if isinstance(v, list) else v for v in request.values)
    )
    if request.id is None:
        return request.command.encode() + fields
    return codec.framing.open(codec.request(request.command, request.id, fields)[:-1])


@given(codec=ALL_FEATURES, data=st.data())
def test_write_fields_returns_the_fields_of_a_write(codec: Codec, data: st.DataObject) -> None:
    address, word = (data.draw(field(codec, letter)) for letter in "ad")
    assert codec.write_fields(address, word) == codec.fields("W", address, word) == codec.fields("WS", address, word)


@given(codec=ALL_FEATURES, data=st.data())
def test_every_request_is_decoded_as_it_was_encoded(codec: Codec, data: st.DataObject) -> None:
    request = data.draw(requests(codec))
    assert codec.decode_request(body_of(codec, request)) == request
    assert codec.decode_plain_request(body_of(codec, request)) == request


@given(codec=ALL_FEATURES, data=st.data())
def test_digits_of_a_request_may_be_in_lower_case(codec: Codec, data: st.DataObject) -> None:
    request = data.draw(requests(codec))
    body = body_of(codec, request)
    letters = len(request.command)
    assert codec.decode_request(body[:letters] + body[letters:].lower()) == request


@given(codec=ALL_FEATURES, data=st.data())
def test_a_digit_more_or_less_is_malformed(codec: Codec, data: st.DataObject) -> None:
    request = data.draw(requests(codec))
    body = body_of(codec, request)
    with pytest.raises(RequestError) as longer:
        codec.decode_request(body + b"0")
    assert longer.value.code == ErrorCode.MALFORMED
    if len(body) > len(request.command):
        with pytest.raises(RequestError) as shorter:
            codec.decode_request(body[:-1])
        assert shorter.value.code == ErrorCode.MALFORMED


@given(codec=ALL_FEATURES, data=st.data())
def test_every_response_is_decoded_as_it_was_encoded(codec: Codec, data: st.DataObject) -> None:
    request = data.draw(requests(codec).filter(lambda request: request.command not in ("Q", "WS")))
    row = COMMANDS[request.command]
    told = row.reads or (row.reports if request.id is not None else "")
    reads = data.draw(field(codec, told)) if told else None
    response = codec.decode_response(codec.response(request, reads))
    assert (response.command, response.id) == (request.command, request.id)
    if told:
        assert response.fields[told] == reads
    echoed = dict(zip(row.fields, request.values, strict=True))
    if "D" in echoed:
        echoed["n"] = len(echoed["D"])
    assert {letter: response.fields.get(letter) for letter in row.echo if request.id is None} == {
        letter: echoed[letter] for letter in row.echo if request.id is None
    }


@given(codec=ALL_FEATURES, data=st.data())
def test_errors_and_samples_are_decoded_as_they_were_encoded(codec: Codec, data: st.DataObject) -> None:
    number = data.draw(st.integers(0, codec.id_count - 1))
    code = data.draw(st.sampled_from(ErrorCode))
    assert codec.decode_response(codec.error(code)) == DecodedResponse("X", None, {"e": code})
    assert codec.decode_response(codec.error(code, number)) == DecodedResponse("X", number, {"e": code})
    assert codec.decode_response(codec.out_of_sequence(number)) == DecodedResponse("N", number, {})
    words = data.draw(field(codec, "D"))
    stamp = data.draw(st.none() | st.integers(0, 0xFFFFFFFF))
    sample = codec.decode_response(codec.publish(7, 0xFE, stamp, np.array(words, np.uint64)))
    text = ("" if stamp is None else f"{stamp:08X}") + "".join(f"{word:0{codec.info.data_digits}X}" for word in words)
    assert sample == DecodedResponse("P", None, {"g": 7, "p": 0xFE, "text": text.encode()})


@pytest.mark.parametrize("body", b" 0 J r r0 r00 w0G Rr00 X1 n0 Q! P00 q000 k00000 WS ws000".split(b" "))
def test_a_body_that_is_no_message_of_a_gateway_is_refused(body: bytes) -> None:
    with pytest.raises(ValueError, match=r"no message|hex digits|MALFORMED"):
        DEFAULT.decode_response(body)


@pytest.mark.parametrize(
    "body", [b"", b"0A", b"J0A", b"Rm0A01", b"q", b"k00", b"qQ", b"ZZ", b"\xff", b" R0A"], ids=repr
)
def test_a_body_without_a_known_command_is_an_unknown_command(body: bytes) -> None:
    with pytest.raises(RequestError) as refusal:
        DEFAULT.decode_request(body)
    assert refusal.value.code == ErrorCode.UNKNOWN_COMMAND


@pytest.mark.parametrize(("digits", "plain"), [(1, True), (7, True), (8, True), (8, False)])
def test_only_a_plain_word_may_be_short(digits: int, plain: bool) -> None:
    body = b"W0A" + b"1" * digits
    read = DEFAULT.decode_plain_request if plain else DEFAULT.decode_request
    assert read(body).values == (0x0A, int("1" * digits, 16))


@pytest.mark.parametrize("body", [b"W0A", b"W0A123456789", b"WM0A1234", b"WK0A0000000F1", b"W0", b"w0"])
def test_a_plain_word_without_digits_or_with_too_many_is_malformed(body: bytes) -> None:
    with pytest.raises(RequestError) as refusal:
        DEFAULT.decode_plain_request(body)
    assert refusal.value.code == ErrorCode.MALFORMED


@pytest.mark.parametrize("body", [b"w000A1", b"ws000A1234567"])
def test_the_word_of_a_numbered_write_is_never_short(body: bytes) -> None:
    with pytest.raises(RequestError) as refusal:
        DEFAULT.decode_plain_request(body)
    assert refusal.value.code == ErrorCode.MALFORMED


def test_a_block_has_at_most_as_many_words_as_two_digits_count() -> None:
    assert len(DEFAULT.decode_request(b"wm00010" + b"0000002A" * 255).values[1]) == 255
    for count in (0, 256):
        with pytest.raises(RequestError) as refusal:
            DEFAULT.decode_request(b"wm00010" + b"0000002A" * count)
        assert refusal.value.code == ErrorCode.MALFORMED


# Many messages at once


@given(digits=st.integers(1, 16), data=st.data())
def test_numbers_in_a_list_are_converted_as_those_of_an_array(digits: int, data: st.DataObject) -> None:
    numbers = data.draw(st.lists(st.integers(0, 16**digits - 1), max_size=20))
    text = b"".join(b"%0*X" % (digits, number) for number in numbers)
    assert hex_text(numbers, digits) == hex_text(tuple(numbers), digits) == text
    assert hex_text(np.array(numbers, np.uint64), digits) == text
    assert parse_numbers(text, digits) == parse_words(text, digits).tolist() == numbers


@given(digits=st.integers(1, 16), text=st.binary(max_size=20) | st.text("0123456789_ +-", max_size=20).map(str.encode))
def test_text_that_is_no_row_of_numbers_is_refused_by_both_parsers(digits: int, text: bytes) -> None:
    try:
        expected = parse_words(text, digits).tolist()
    except ValueError:
        with pytest.raises(ValueError, match="digit"):
            parse_numbers(text, digits)
    else:
        assert parse_numbers(text, digits) == expected


SEEDS = st.integers(0, 0xFF)
"""Seeds that are valid for a CRC of any width."""


@given(codec=ALL_FEATURES, data=st.data(), node=st.sampled_from([None, 0x5A]))
def test_many_requests_are_encoded_as_each_alone(codec: Codec, data: st.DataObject, node: int | None) -> None:
    codec = Codec(codec.info, node)
    count = data.draw(st.integers(1, 40))
    first = data.draw(st.integers(0, codec.id_count - 1) | st.just(codec.id_count - 1))
    width = data.draw(st.integers(1, 12))
    rows = np.frombuffer(
        data.draw(st.text("0123456789ABCDEF", min_size=count * width, max_size=count * width)).encode(), np.uint8
    ).reshape(count, width)
    seed = data.draw(SEEDS)
    alone = [
        codec.request("W", (first + index) % codec.id_count, row.tobytes(), seed) for index, row in enumerate(rows)
    ]
    assert request_rows(codec, "W", first, rows, seed) == b"".join(alone)


def answers(codec: Codec, command: str, first: int, words: list[int], seed: int) -> list[bytes]:
    reads = words if command == "R" else [None] * len(words)
    return [
        codec.framing.checked(
            codec.response(
                DecodedRequest(command, (first + index) % codec.id_count, (0,) if command == "R" else (0, 0)), word
            ),
            seed,
        )
        for index, word in enumerate(reads)
    ]


@given(codec=ALL_FEATURES, data=st.data(), command=st.sampled_from(["R", "W"]), node=st.sampled_from([None, 0x5A]))
def test_many_responses_are_decoded_as_each_alone_until_one_is_unexpected(
    codec: Codec, data: st.DataObject, command: str, node: int | None
) -> None:
    codec = Codec(codec.info, node)
    words = data.draw(st.lists(field(codec, "d"), min_size=1, max_size=20))
    first = data.draw(st.integers(0, codec.id_count - 1) | st.just(codec.id_count - 1))
    seed = data.draw(SEEDS)
    frames = answers(codec, command, first, words, seed)
    digits = codec.info.data_digits if command == "R" else 0
    wrong = data.draw(st.integers(0, len(words)))
    if wrong < len(words):
        frame = bytearray(frames[wrong])
        frame[data.draw(st.integers(0, len(frame) - 1))] ^= 1 << data.draw(st.integers(0, 7))
        frames[wrong] = bytes(frame)
    taken = response_rows(codec, command, first, b"".join(frames), digits, seed)
    expected = words[:wrong] if command == "R" else [0] * wrong
    assert ([] if taken is None else taken.tolist()) == expected


def test_a_response_with_a_valid_crc_but_no_word_is_not_decoded_in_rows() -> None:
    assert response_rows(DEFAULT, "R", 0, DEFAULT.framing.checked(b"r0000000G000"), 8) is None


# The document


@pytest.mark.parametrize("example", worked_examples(), ids=lambda example: f"line {example.line}")
def test_the_host_decodes_every_answer_of_the_document(example: Example) -> None:
    codec = Codec(GatewayInfo(), example.node)
    for frame, from_gateway, session in example.frames_in_sessions:
        if from_gateway:
            codec.decode_response(codec.framing.open(frame[:-1], seed_of(session, from_gateway=True)))


def test_the_host_encodes_every_checked_request_of_the_document() -> None:
    written = 0
    for example in worked_examples():
        codec = Codec(GatewayInfo(), example.node)
        for frame, from_gateway, session in example.frames_in_sessions:
            body = re.fullmatch(rb"%b([G-Zg-z][^\r\n]*)....\n" % codec.framing.prefix, frame)
            if from_gateway or body is None:
                continue
            try:
                request = codec.decode_request(body[1])
            except RequestError:
                continue
            seed = seed_of(session, from_gateway=False) if body[1].islower() else 0
            if codec.framing.checked(body[1], seed) == frame:
                seed = seed_of(session, from_gateway=False) if request.id is not None else 0
                assert codec.framing.checked(body_of(codec, request), seed) == frame
                written += 1
    assert written > 40
