"""Bodies are put into frames and taken out of them; anything that is no frame is rejected."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import LARGEST_DATAGRAM, FrameError, Framing, datagrams

FRAMINGS = [Framing(Crc()), Framing(Crc(16, 0x1021)), Framing(Crc(32, 0x04C11DB7)), Framing(Crc(), node=0x5A)]
bodies = st.text("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZghijklmnopqrstuvwxyz", max_size=40).map(str.encode)
framings = st.sampled_from(FRAMINGS)


@given(framing=framings, body=bodies)
def test_a_checked_frame_gives_its_body_back(framing: Framing, body: bytes) -> None:
    frame = framing.checked(body)
    assert frame.endswith(b"\n")
    assert len(frame) == len(body) + framing.overhead
    assert framing.open(frame[:-1]) == body


@given(framing=framings, body=bodies)
def test_a_plain_reply_gives_its_body_back(framing: Framing, body: bytes) -> None:
    frame = framing.plain_reply(body)
    assert frame.endswith(b"\r\n")
    assert framing.open(frame[:-1]) == body


@given(framing=framings, body=bodies, position=st.integers(0, 100), bit=st.integers(0, 7))
def test_one_inverted_bit_is_always_found(framing: Framing, body: bytes, position: int, bit: int) -> None:
    line = bytearray(framing.checked(body)[:-1])
    line[position % len(line)] ^= 1 << bit
    assume(line[-1:] != b"\r")
    with pytest.raises(FrameError):
        framing.open(bytes(line))


@pytest.mark.parametrize("line", [b"", b"1", b"R0", b"\n"], ids=repr)
def test_a_line_shorter_than_its_crc_is_damaged(line: bytes) -> None:
    with pytest.raises(FrameError, match="wrong CRC"):
        Framing(Crc(32, 0x04C11DB7)).open(line)


def test_a_plain_request_ends_as_the_enter_key_does() -> None:
    assert Framing(Crc()).plain_request(b"Q") == b"Q\r"
    assert Framing(Crc(), node=5).plain_request(b"Q") == b"Z05Q\r"


@given(body=bodies)
def test_a_frame_of_another_node_is_rejected(body: bytes) -> None:
    with pytest.raises(FrameError, match="not from node 05"):
        Framing(Crc(), node=5).open(Framing(Crc(), node=6).checked(body)[:-1])


@given(
    frames=st.lists(st.binary(max_size=900).map(lambda text: text.replace(b"\n", b".").replace(b"\r", b".") + b"\n"))
)
def test_datagrams_hold_whole_frames_in_order_and_are_as_few_as_fit(frames: list[bytes]) -> None:
    packed = datagrams(b"".join(frames))
    assert b"".join(packed) == b"".join(frames)
    assert all(datagram.endswith(b"\n") for datagram in packed)
    for first, second in itertools.pairwise(packed):
        assert len(first) + len(second[: second.index(b"\n") + 1]) > LARGEST_DATAGRAM
    assert all(len(datagram) <= LARGEST_DATAGRAM for datagram in packed)


def test_a_frame_longer_than_a_datagram_goes_alone() -> None:
    long = b"P" * 3000 + b"\n"
    assert datagrams(b"H\n" + long + b"H\n") == [b"H\n", long, b"H\n"]
