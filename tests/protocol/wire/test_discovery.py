"""The discovery request and its answer, byte by byte as docs/protocol.md has them."""

from hypothesis import given
from hypothesis import strategies as st

from unity_link.protocol.wire.discovery import EVERYBODY, Found, answer, ask, asked, read_answer

MAC = bytes.fromhex("02554c000001")
MACS = st.binary(min_size=6, max_size=6)
OF_GATEWAYS = MACS.map(lambda mac: bytes([mac[0] & 0xFE]) + mac[1:])
NAMES = st.text(st.characters(min_codepoint=0x20, max_codepoint=0x7E), max_size=15)
WORDS = st.integers(0, 0xFFFFFFFF)
FOUND = st.builds(Found, OF_GATEWAYS, st.binary(min_size=4, max_size=4), WORDS, st.booleans(), st.booleans(), NAMES)


def test_discovery_request_and_answer_have_the_bytes_of_the_document() -> None:
    assert ask() == b"U?" + b"\xff" * 6 + bytes(24)
    assert ask(MAC, bytes((192, 168, 1, 7))) == b"U?" + MAC + bytes((192, 168, 1, 7)) + bytes(20)
    lamp = Found(MAC, bytes((192, 168, 1, 7)), 0x1234ABCD, has_fingerprint=True, session_open=True, name="lamp")
    assert answer(lamp) == b"U?" + MAC + bytes.fromhex("c0a801071234abcd03") + b"lamp".ljust(15, b"\0")


@given(FOUND)
def test_an_answer_is_decoded_as_encoded_and_as_long_as_the_request(found: Found) -> None:
    assert read_answer(answer(found)) == found
    assert len(answer(found)) == len(ask(found.mac, found.ip))


@given(st.text(st.characters(exclude_categories=["Cc", "Cs"]), min_size=16), FOUND)
def test_a_name_that_is_too_long_is_cut(name: str, found: Found) -> None:
    told = read_answer(answer(found._replace(name=name)))
    assert told is not None
    assert name.encode("ascii", "replace").startswith(told.name.encode())


@given(st.binary(max_size=80) | st.binary(max_size=80).map(b"U?".__add__))
def test_arbitrary_bytes_are_decoded_as_an_answer_or_none(data: bytes) -> None:
    found = read_answer(data)
    # The lowest bit of the first byte marks a multicast MAC address, which no gateway has.
    assert (found is not None) == (len(data) == 32 and data.startswith(b"U?") and data[2] % 2 == 0)
    assert found is None or not found.name or found.name.isprintable()


@given(st.binary(min_size=4, max_size=4))
def test_a_broadcast_request_that_is_reflected_is_no_answer(ip: bytes) -> None:
    assert read_answer(ask(EVERYBODY, ip)) is None


@given(MACS)
def test_a_request_is_for_all_gateways_or_for_the_one_that_it_names(mac: bytes) -> None:
    assert asked(ask(mac), MAC) == (mac == MAC or mac[0] % 2 == 1)
    assert asked(ask(EVERYBODY) + b"more", MAC)
    assert not asked(ask(EVERYBODY)[:-1], MAC)
    assert not asked(b"U!" + ask(EVERYBODY)[2:], MAC)
