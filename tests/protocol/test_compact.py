"""The compact form of frames: it carries what the text carries, and damage costs the frames that it hits."""

from __future__ import annotations

from hypothesis import example, given
from hypothesis import strategies as st

from unity_link.protocol.compact import COMMANDS, END, ESCAPE, START, STUFFED, CompactForm, Packer, Unpacker

FORMS = st.builds(
    CompactForm,
    id_digits=st.sampled_from((2, 3)),
    crc_digits=st.sampled_from((2, 4, 8)),
    address_digits=st.sampled_from((0, 2, 3, 8)),
    has_node=st.booleans(),
)
REQUESTS = CompactForm(3, 4, 2)
BYTES = st.one_of(
    st.binary(), st.lists(st.sampled_from([START, END, ESCAPE, b"\n", b"\r", b"0", b"r", b"\x07"])).map(b"".join)
)
"""Arbitrary bytes, and those among which what is reserved is frequent."""


def expanded(form: CompactForm, data: bytes) -> bytes:
    """Return the text of bytes, one by one, as a gateway has it; a frame without its end as far as it came."""
    text = bytearray()
    content: bytearray | None = None
    escaped = False

    def digits(content: bytes) -> bytes:
        found = content.hex().upper()
        prefix = ""
        if form.has_node and found:
            prefix, found = "Z" + found[:2], found[2:]
        if not found:
            return prefix.encode()
        command = COMMANDS[int(found[0], 16)]
        return (prefix + command + found[2 if form.is_filled(command) else 1 :]).encode()

    for byte in data:
        if byte in START:
            if content is not None:
                text += digits(content) + b"\n"
            elif text and text[-1] not in b"\n\r":
                text += b"\n"
            content, escaped = bytearray(), False
        elif content is None:
            text.append(byte)
            text += b"\n" * (byte in END)
        elif byte in END or byte in b"\n\r":
            text += digits(content) + (b"\n" if byte in END else bytes((byte,)))
            content = None
        elif escaped or byte not in ESCAPE:
            content.append(byte ^ STUFFED if escaped else byte)
            escaped = False
        else:
            escaped = True
    return bytes(text)


@st.composite
def frames(draw: st.DrawFn, form: CompactForm) -> bytes:
    """Return a checked frame of a session, or another one."""
    prefix = "Z%02X" % draw(st.integers(0, 254)) if form.has_node else ""
    if draw(st.integers(0, 9)) == 0:
        return (prefix + draw(st.sampled_from(["K12CD", "Q4AD4", "R0A␍"]))).replace("␍", "\r").encode() + b"\n"
    command = draw(st.sampled_from(COMMANDS))
    fixed = form.crc_digits
    if command != "P":
        fixed += form.id_digits
    if command[0] in "rw":
        fixed += form.address_digits
    digits = fixed + 2 * draw(st.integers(0, 40))
    pairs = st.sampled_from(["B5", "CA", "D3", "0A", "0D", "93"])
    text = "".join(
        draw(
            st.lists(
                pairs | st.text("0123456789ABCDEF", min_size=2, max_size=2),
                min_size=digits // 2 + 1,
                max_size=digits // 2 + 1,
            )
        )
    )
    text = text[:digits]
    return (prefix + command + text).encode() + b"\n"


@given(st.data())
def test_frames_come_out_as_they_went_in_whatever_pieces_they_arrive_in(data: st.DataObject) -> None:
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
    assert (packed == text) == (text.removeprefix(b"Z" if form.has_node else b"")[2 * form.has_node :][:1] in b"KQR")
    assert len(packed) <= len(text) + 2


@given(FORMS, st.lists(BYTES))
@example(REQUESTS, [START + ESCAPE, START])
@example(REQUESTS, [b"\xb5\x00\x00\x0b\x00\xd3\x93\xca"])
def test_bytes_of_any_kind_and_in_any_pieces_make_the_text_that_they_make_one_by_one(
    form: CompactForm, pieces: list[bytes]
) -> None:
    # A line end behind them ends a frame that has not ended.
    pieces = [*pieces, b"\n"]
    unpacker = Unpacker(form)
    assert b"".join(map(unpacker.unpack, pieces)) == expanded(form, b"".join(pieces))


@given(st.data())
def test_a_lost_or_changed_byte_leaves_all_but_two_frames_as_they_were(data: st.DataObject) -> None:
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
