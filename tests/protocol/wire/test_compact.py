"""The compact form of frames carries the same content as the text; damage affects only the frames that it hits."""

from __future__ import annotations

from hypothesis import example, given
from hypothesis import strategies as st

from unity_link.protocol.wire.compact import (
    COMMANDS,
    END,
    ESCAPE,
    START,
    STUFFED,
    CompactForm,
    Packer,
    Unpacker,
)

FORMS = st.builds(
    CompactForm,
    id_digits=st.sampled_from((2, 3)),
    crc_digits=st.sampled_from((2, 4, 8)),
    address_digits=st.sampled_from((2, 3, 8)),
    from_gateway=st.booleans(),
    has_node=st.booleans(),
)
REQUESTS = CompactForm(3, 4, 2, from_gateway=False)
BYTES = st.one_of(
    st.binary(), st.lists(st.sampled_from([START, END, ESCAPE, b"\n", b"\r", b"0", b"r", b"\x07"])).map(b"".join)
)
"""Arbitrary bytes, and sequences in which reserved bytes are frequent."""


def text_of_frame(form: CompactForm, content: bytearray) -> bytes:
    """Return the text of the bytes between start and end."""
    found = content.hex().upper()
    prefix = ""
    if form.has_node and found:
        prefix, found = "Z" + found[:2], found[2:]
    if not found:
        return prefix.encode()
    command = COMMANDS[int(found[0], 16)]
    return (prefix + command + found[2 if form.is_filled(command) else 1 :]).encode()


def expanded(form: CompactForm, data: bytes) -> bytes:
    """Return the text of bytes, converted one by one as a gateway does, with the part of a frame that has not ended.

    On a shared medium a line end after the end byte belongs to the frame.
    """
    if form.has_node:
        data = data.replace(END + b"\n", END)
    text = bytearray()
    content: bytearray | None = None
    escaped = False
    for byte in data:
        ends = byte in b"\n\r"
        if byte in START:
            if content is not None:
                text += text_of_frame(form, content) + END + b"\n"
            elif text and text[-1] not in b"\n\r":
                text += END + b"\n"
            content, escaped = bytearray(), False
        elif content is None:
            text.append(byte)
            text += b"\n" * (byte in END)
        elif byte in END or ends:
            text += text_of_frame(form, content) + (END if ends or escaped else b"") + b"\n"
            content = None
        elif escaped or byte not in ESCAPE:
            content.append(byte ^ STUFFED if escaped else byte)
            escaped = False
        else:
            escaped = True
    return bytes(text)


@st.composite
def frames(draw: st.DrawFn, form: CompactForm, command: str = "") -> bytes:
    """Return a checked frame of a session, or another one."""
    prefix = f"Z{draw(st.sampled_from((0, 0xB5, 0xFE))):02X}" if form.has_node else ""
    if not command and draw(st.integers(0, 9)) == 0:
        return (prefix + draw(st.sampled_from(["K12CD", "Q4AD4", "gs00A", "R0A\r"]))).encode() + b"\n"
    command = command or draw(st.sampled_from(COMMANDS))
    # The number of digits of ID, address and CRC together is odd or even.
    odd = "" if form.is_filled(command) else "0"
    pairs = st.sampled_from(["B5", "CA", "D3", "0A", "0D", "93"]) | st.text("0123456789ABCDEF", min_size=2, max_size=2)
    digits = draw(st.lists(pairs, min_size=4, max_size=40))
    return (prefix + command + odd + "".join(digits)).encode() + b"\n"


@st.composite
def alike(draw: st.DrawFn, form: CompactForm) -> bytes:
    """Return frames of one command, most of them of one length, one after another."""
    frame = draw(frames(form, draw(st.sampled_from(COMMANDS))))
    # Small and large counts: the packer has a path for each.
    count = draw(st.integers(2, 30) | st.integers(60, 120))
    text = bytearray(frame * count)
    head = len(frame) - 1 - 8
    for at in draw(st.lists(st.integers(0, count - 1))):
        text[at * len(frame) + head : at * len(frame) + head + 8] = draw(
            st.sampled_from([b"B5CAD30A", b"00000D00", b"12345678", b"0CA0D3B5"])
        )
    return bytes(text) + draw(st.sampled_from([b"", frame[:-3] + b"\n"]))


def one_by_one(form: CompactForm, text: bytes) -> bytes:
    return b"".join(map(Packer(form).pack_one, text.splitlines(keepends=True)))


@given(st.data())
def test_frames_of_one_length_convert_together_as_they_do_one_by_one(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    text = data.draw(alike(form))
    packed = Packer(form).pack(text)
    assert packed == one_by_one(form, text)
    assert packed.count(START) == packed.count(END) == text.count(b"\n")
    assert Unpacker(form).unpack(packed) == text


@given(st.data())
def test_frames_of_any_length_are_packed_together_as_one_by_one(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    text = b"".join(data.draw(st.lists(alike(form) | frames(form), min_size=1)))
    assert Packer(form).pack(text) == one_by_one(form, text)


@given(st.data())
def test_damaged_frames_of_one_length_are_unpacked_as_byte_by_byte(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    damaged = bytearray(Packer(form).pack(data.draw(alike(form))))
    for at in data.draw(st.lists(st.integers(0, len(damaged) - 1), min_size=1, max_size=3)):
        damaged[at : at + 1] = data.draw(st.sampled_from([b"", START, END, ESCAPE, b"\n", b"\r", b"7", END + START]))
    damaged += b"\n"
    assert Unpacker(form).unpack(bytes(damaged)) == expanded(form, bytes(damaged))


@given(
    FORMS,
    st.lists(st.sampled_from([b"", b"\x00", b"\x90", b"\x04\x05", ESCAPE + b"\x93", ESCAPE]) | st.binary(max_size=4)),
)
@example(REQUESTS, [b"", b"\x00\x00"])
def test_frames_of_any_content_are_unpacked_together_as_byte_by_byte(form: CompactForm, contents: list[bytes]) -> None:
    sent = b"".join(START + content + END for content in contents)
    assert Unpacker(form).unpack(sent) == expanded(form, sent)


@given(st.data())
def test_line_ends_between_frames_are_ignored_only_on_a_shared_medium(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    groups = data.draw(st.lists(alike(form), min_size=1, max_size=4))
    sent = b"".join(Packer(form).pack(group) + b"\n" for group in groups)
    assert Unpacker(form).unpack(sent) == expanded(form, sent)


@given(st.data())
def test_frames_cut_anywhere_are_unpacked_to_the_text_that_was_packed(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    text = b"".join(data.draw(st.lists(frames(form))))
    packed = Packer(form).pack(text)
    unpacker, found, rest = Unpacker(form), b"", packed
    while rest:
        count = data.draw(st.integers(1, len(rest)))
        found, rest = found + unpacker.unpack(rest[:count]), rest[count:]
    assert found == text


@given(st.data())
def test_all_frames_of_a_session_are_compact_and_no_longer_than_text(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    text = data.draw(frames(form))
    packed = Packer(form).pack(text)
    body = text[3:] if form.has_node else text
    assert (packed == text) == body.startswith((b"K", b"Q", b"R", b"gs"))
    assert len(packed) <= len(text) + 3


@given(FORMS, st.lists(BYTES))
@example(REQUESTS, [START + ESCAPE, START])
@example(REQUESTS, [b"\xb5\x00\x00\x0b\x00\xd3\x93\xca"])
def test_arbitrary_bytes_in_pieces_are_unpacked_as_byte_by_byte(form: CompactForm, pieces: list[bytes]) -> None:
    # A line end after the pieces ends an unfinished frame.
    pieces = [*pieces, b"\n"]
    unpacker = Unpacker(form)
    assert b"".join(map(unpacker.unpack, pieces)) == expanded(form, b"".join(pieces))


@given(st.data())
def test_a_lost_or_changed_byte_damages_at_most_two_frames(data: st.DataObject) -> None:
    form = data.draw(FORMS)
    text = data.draw(st.lists(frames(form), min_size=4, max_size=8))
    packed = b"".join(map(Packer(form).pack, text))
    at = data.draw(st.integers(0, len(packed) - 1))
    instead = data.draw(st.binary(max_size=1))
    found = Unpacker(form).unpack(packed[:at] + instead + packed[at + 1 :] + b"\n").splitlines(keepends=True)
    left = list(text)
    for frame in found:
        if frame in left:
            left.remove(frame)
    assert len(left) <= 2
