"""Both sides of datagrams: the datagrams that they send, accept and refuse."""

from __future__ import annotations

import itertools
from collections import deque

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.errors import ConnectError
from unity_link.protocol.gateway.datagrams import GatewayDatagrams
from unity_link.protocol.host.datagrams import HostDatagrams
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.datagrams import NO_SESSION, Counts
from unity_link.protocol.wire.frames import LARGEST_DATAGRAM
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway

OFFER = 0x4F1C0A32
CODEC = Codec(GatewayInfo())
CHECKED = CODEC.framing.checked
ANSWER = b"Q" + GatewayInfo().to_hex() + b"\r\n"
SESSION = CHECKED(b"U4F1C0A3200000001") + CHECKED(b"K5A00001")


MOST_CARRIED = 200
"""More datagrams than a few forged ones can cause."""


class Gateway:
    """The gateway's side, with the frames that it executes and the datagrams that it sends."""

    def __init__(self, codec: Codec = CODEC) -> None:
        self.executed: list[bytes] = []
        self.sent: list[tuple[bytes, str]] = []
        offers = itertools.count(OFFER)
        self.side: GatewayDatagrams[str] = GatewayDatagrams(
            codec, self.executed.append, lambda *answer: self.sent.append(answer), lambda: next(offers)
        )

    def opened(self) -> Gateway:
        """Open the first offered session as A, and clear the list of sent datagrams."""
        self.side.take(b"Q\r", "A")
        self.side.put(ANSWER)
        self.side.take(SESSION, "A")
        self.side.put(CHECKED(b"K5A000010000"))
        self.executed.clear()
        self.sent.clear()
        return self


def opened_host(offer: int = OFFER) -> HostDatagrams:
    host = HostDatagrams()
    host.take(b"U%08X00000000\r\n" % offer + ANSWER)
    host.put(CHECKED(b"K5A00001"))
    return host


# Counts


@given(start=st.integers(1, 0xFFFFFFFF), ahead=st.integers(0, 0xFFFFFFFF))
def test_a_count_is_newer_by_less_than_half_of_all(start: int, ahead: int) -> None:
    counts, count = Counts(), (start + ahead) % (1 << 32)
    counts.taken = start
    assert counts.takes(count) == (0 < ahead < 1 << 31 and count != 0)
    assert counts.taken == (count if 0 < ahead < 1 << 31 and count else start)


def test_counts_wrap_around_without_zero() -> None:
    counts = Counts()
    assert [counts.next(), counts.next()] == [1, 2]
    counts.sent = 0xFFFFFFFE
    assert [counts.next(), counts.next()] == [0xFFFFFFFF, 1]
    counts.taken = 0xFFFFFFFF
    assert counts.takes(1)
    assert not counts.takes(0xFFFFFFFF)


# The exchange of docs/protocol.md, "Datagrams"


def test_a_host_opens_the_offered_session_and_counts_its_datagrams() -> None:
    host = HostDatagrams()
    assert host.put(b"\nQ\r") == [b"\nQ\r"]
    assert host.take(b"U4F1C0A3200000000\r\n" + ANSWER) == ANSWER
    assert host.put(CHECKED(b"Q")) == [CHECKED(b"Q")]
    assert host.put(CHECKED(b"K5A00001")) == [b"U4F1C0A32000000018428\nK5A00001E9A0\n"]
    assert host.take(b"U4F1C0A32000000018428\nK5A000010000108B\n") == b"K5A000010000108B\n"
    assert host.put(b"r5A00A251B\nr5A10B2248\n") == [b"U4F1C0A3200000002B44B\nr5A00A251B\nr5A10B2248\n"]
    assert host.take(b"U4F1C0A3200000002B44B\nr5A000000012907E\n") == b"r5A000000012907E\n"
    assert host.take(b"U4F1C0A3200000002B44B\nr5A000000012907E\n") == b""


def test_a_gateway_offers_a_session_and_executes_each_datagram_of_it_once() -> None:
    gateway = Gateway()
    gateway.side.take(b"Q\r", "A")
    assert gateway.executed == [b"Q\r\n"]
    gateway.side.put(ANSWER)
    gateway.side.take(SESSION, "A")
    gateway.side.take(SESSION, "A")
    assert gateway.executed[1:] == [b"K5A00001E9A0\n"]
    gateway.side.put(b"K5A000010000108B\n")
    gateway.side.take(b"U4F1C0A3200000002B44B\nr5A00A251B\n", "A")
    gateway.side.take(SESSION, "A")
    assert gateway.executed[2:] == [b"r5A00A251B\n"]
    gateway.side.put(b"r5A000000012907E\n")
    assert gateway.sent == [
        (b"U4F1C0A3200000000\r\n" + ANSWER, "A"),
        (b"U4F1C0A32000000018428\nK5A000010000108B\n", "A"),
        (b"U4F1C0A3200000002B44B\nr5A000000012907E\n", "A"),
    ]


# The gateway


@pytest.mark.parametrize(
    ("datagram", "source"),
    [
        pytest.param(b"U4F1C0A32000000018428\nW0A\n", "A", id="one that was offered, and no K"),
        pytest.param(SESSION, "B", id="another's"),
        pytest.param(CHECKED(b"U0000000100000009") + CHECKED(b"K000"), "A", id="a former one"),
        pytest.param(CHECKED(b"U0000000000000001") + CHECKED(b"K000"), "A", id="no session"),
    ],
)
def test_a_datagram_of_another_session_is_refused_and_not_executed(datagram: bytes, source: str) -> None:
    gateway = Gateway() if b"W0A" in datagram else Gateway().opened()
    gateway.side.take(datagram, source)
    assert not gateway.executed
    assert gateway.sent == [(CHECKED(datagram[:9] + b"00000000") + CHECKED(b"X0A"), source)]


def test_a_request_under_a_header_with_count_0_is_dropped() -> None:
    gateway = Gateway()
    gateway.side.take(b"Q\r", "A")
    gateway.side.put(ANSWER)
    gateway.executed.clear()
    gateway.sent.clear()
    for session in (b"4F1C0A32", b"00000001", b"00000000"):
        gateway.side.take(CHECKED(b"U" + session + b"00000000") + CHECKED(b"K000"), "A")
        gateway.side.take(b"U" + session + b"00000000\r\nX0A\r\n", "B")
    assert not gateway.executed
    assert not gateway.sent
    assert gateway.side.session == NO_SESSION


def test_the_refusal_of_a_plain_datagram_is_plain() -> None:
    gateway = Gateway()
    gateway.side.take(b"U0000000100000001\rr0000A\r", "A")
    assert gateway.sent == [(b"U0000000100000000\r\nX0A\r\n", "A")]


@pytest.mark.parametrize(
    "header",
    [b"U4F1C0A320000000584A8\n", b"U4F1C0A32000005\r", b"U4F1C0A320000000X\r", b"U4F1C0A32", b"U\r"],
    ids=["its CRC", "its length", "its digits", "its end", "all of it"],
)
def test_a_datagram_with_a_damaged_header_is_dropped(header: bytes) -> None:
    gateway = Gateway().opened()
    gateway.side.take(header + CHECKED(b"W0A00000001"), "A")
    assert not gateway.executed
    assert not gateway.sent


def test_a_header_may_be_in_lower_case_and_plain() -> None:
    gateway = Gateway().opened()
    covered = b"U4f1c0a320000000b"
    gateway.side.take(covered + CODEC.framing.crc.text(covered).lower() + b"\nH\r", "A")
    gateway.side.take(b"U4f1c0a320000000c\rH\r", "A")
    assert gateway.executed == [b"H\r\n"] * 2


def test_the_header_has_the_form_of_the_first_frame_of_the_datagram() -> None:
    gateway = VirtualGateway()
    framing, sent = Codec(gateway.info).framing, list[bytes]()
    side: GatewayDatagrams[int] = GatewayDatagrams(
        Codec(gateway.info), lambda frames: side.put(gateway.receive(frames, 0.0)), lambda data, _: sent.append(data)
    )
    side.take(framing.checked(b"H")[:-1], 1)
    side.take(b"H\r" + framing.checked(b"H"), 1)
    offer = b"U%08X00000000" % side.offer
    assert sent == [
        framing.checked(offer) + framing.checked(b"H"),
        framing.plain_reply(offer) + b"H\r\n" + framing.checked(b"H"),
    ]


def test_empty_lines_before_a_header_are_ignored() -> None:
    gateway = Gateway().opened()
    covered = b"U4F1C0A320000000B"
    gateway.side.take(b"\r\n\n" + CHECKED(covered) + b"H\r", "A")
    assert gateway.executed == [b"H\r\n"]


def test_requests_without_a_header_are_executed_if_they_need_no_session() -> None:
    gateway = Gateway()
    gateway.side.take(b"\nH\rK0000001\rR0A\rw0000A1\rK\r" + CHECKED(b"r0000A") + b"zzz\n", "A")
    assert gateway.executed == [b"H\r", b"R0A\rw0000A1\rK\r", b"zzz\n"]
    assert gateway.sent == [
        (b"U4F1C0A3200000000\r\nX0A\r\n", "A"),
        (b"U4F1C0A3200000000\r\n" + CHECKED(b"x0000A0000"), "A"),
    ]


@pytest.mark.parametrize("end", [b"\n\r", b"\n\n\r", b"\n"])
def test_a_datagram_without_a_header_opens_no_session(end: bytes) -> None:
    gateway = Gateway()
    gateway.side.take(b"\r" + CODEC.framing.checked(b"K0000001")[:-1] + end, "A")
    assert not gateway.executed
    assert gateway.sent == [(CHECKED(b"U4F1C0A3200000000") + CHECKED(b"X0A"), "A")]


def test_an_offer_is_repeated_until_a_host_takes_it() -> None:
    gateway = Gateway()
    for asker in "AB":
        gateway.side.take(b"Q\r", asker)
        gateway.side.put(ANSWER)
    gateway.side.take(SESSION, "A")
    gateway.side.take(b"Q\r", "B")
    gateway.side.put(ANSWER)
    offers = [(datagram[1:9], address) for datagram, address in gateway.sent]
    assert offers == [(b"4F1C0A32", "A"), (b"4F1C0A32", "B"), (b"4F1C0A33", "B")]


def test_answers_to_queries_go_to_the_asker_and_the_rest_to_the_opener() -> None:
    gateway = Gateway().opened()
    gateway.side.take(CHECKED(b"Q"), "B")
    gateway.side.put(b"P0000\nr000\nQ02\nK00000010000\r\nK0001\r\nX01\n")
    assert [(datagram.partition(b"\n")[2], address) for datagram, address in gateway.sent] == [
        (b"P0000\nr000\n", "A"),
        (b"Q02\n", "B"),
        (b"K00000010000\r\n", "A"),
        (b"K0001\r\nX01\n", "B"),
    ]
    gateway.side.take(b"U4F1C0A3200000002\rQ\r", "A")
    gateway.side.put(ANSWER)
    assert gateway.sent[-1] == (CHECKED(b"U4F1C0A3200000004") + ANSWER, "A")


def test_a_host_that_loses_its_session_to_another_receives_a_refusal() -> None:
    gateway = Gateway().opened()
    gateway.side.take(b"Q\r", "B")
    gateway.side.put(ANSWER)
    gateway.side.take(CHECKED(b"U4F1C0A3300000001") + CHECKED(b"K1110002"), "B")
    refusal = CHECKED(b"U4F1C0A3200000000") + CHECKED(b"X0A")
    assert gateway.executed == [b"Q\r\n", CHECKED(b"K1110002")]
    assert gateway.sent[1:] == [(refusal, "A")]
    gateway.side.take(b"U4F1C0A3200000002B44B\nr5A00A251B\n", "A")
    assert gateway.sent[2:] == [(refusal, "A")]


BARE = [CHECKED(b"K"), b"K\r", b"K\r\n", b"K", b"\r\nK\r", b"Kf9af\n", b"KF9", b"K\rW0A01\r"]
"""Frames of a bare `K`, whole or without the end of its check; others may follow."""
WITH_FIELDS = [CHECKED(b"K1110002"), b"K1110002\r", CHECKED(b"K1110000"), b"K1110002AAAA\n"]
WITH_FIELDS += [b"K0000", b"KF9AF0\n", b"KF\x00", b"K9"]


@pytest.mark.parametrize("frames", BARE)
def test_a_bare_k_opens_no_session_and_is_answered_as_a_query(frames: bytes) -> None:
    gateway = Gateway().opened()
    gateway.side.take(b"Q\r", "B")
    gateway.side.put(ANSWER)
    gateway.sent.clear()
    gateway.executed.clear()
    gateway.side.take(CHECKED(b"U4F1C0A3300000001") + frames, "B")
    assert b"".join(gateway.executed).startswith(b"K")
    gateway.side.put(CHECKED(b"K0001") + CHECKED(b"P0000"))
    is_plain = b"\r" in frames.lstrip(b"\r\n")
    offer = b"U4F1C0A3300000000\r\n" if is_plain else CHECKED(b"U4F1C0A3300000000")
    assert gateway.sent[0] == (offer + CHECKED(b"K0001"), "B")
    assert gateway.sent[1][1] == "A"
    assert (gateway.side.session, gateway.side.opener, gateway.side.offer) == (OFFER, "A", OFFER + 1)


@pytest.mark.parametrize("frames", WITH_FIELDS)
def test_a_k_with_fields_takes_the_offer_even_if_they_are_invalid(frames: bytes) -> None:
    gateway = Gateway().opened()
    gateway.side.take(b"Q\r", "B")
    gateway.side.put(ANSWER)
    gateway.side.take(CHECKED(b"U4F1C0A3300000001") + frames, "B")
    assert (gateway.side.session, gateway.side.opener, gateway.side.offer) == (OFFER + 1, "B", NO_SESSION)


def test_a_session_continues_if_another_host_sends_a_bare_k() -> None:
    """The gateway samples a group for A while B sends frames that only A may send."""
    model, sent = VirtualGateway(), list[tuple[bytes, str]]()
    now = 0.0
    side: GatewayDatagrams[str] = GatewayDatagrams(
        Codec(model.info), lambda frames: side.put(model.receive(frames, now)), lambda *answer: sent.append(answer)
    )

    def send(address: str, session: int, count: int, *frames: bytes) -> list[tuple[bytes, str]]:
        sent.clear()
        side.take(b"".join([CHECKED(b"U%08X%08X" % (session, count)), *frames]), address)
        return [(datagram.partition(b"\n")[2], destination) for datagram, destination in sent]

    seed = 2 * 0x1111
    write = CHECKED(b"w0020300000007", seed)
    side.take(b"Q\r", "A")
    session = side.offer
    group = CHECKED(b"gs0000001000101" + b"0A", seed), CHECKED(b"gn00100", seed)
    ((answers, _),) = send("A", session, 1, CHECKED(b"K0001111"), *group)
    assert [answer[:2] for answer in answers.splitlines()] == [b"K0", b"gs", b"gn"]
    side.take(b"Q\r", "B")
    assert send("B", side.offer, 1, CHECKED(b"K")) == [(CHECKED(b"K1111"), "B")]
    assert send("B", side.offer, 2, write) == [(CHECKED(b"X0A"), "B")]
    assert model.memory[3] == 0
    now = 1.0
    sent.clear()
    side.put(model.advance(now))
    assert {address for _, address in sent} == {"A"}
    assert send("A", session, 2, write) == [(CHECKED(b"w002", seed | 1), "A")]
    assert model.memory[3] == 7
    (told, begun) = send("B", side.offer, 3, CHECKED(b"K0002222"))
    assert (told, begun[0]) == ((CHECKED(b"X0A"), "A"), CHECKED(b"K00022221111"))


def test_no_datagram_is_sent_for_requests_without_a_response() -> None:
    model, sent = VirtualGateway(), list[tuple[bytes, str]]()
    side: GatewayDatagrams[str] = GatewayDatagrams(
        Codec(model.info), lambda frames: side.put(model.receive(frames, 0.0)), lambda *answer: sent.append(answer)
    )
    side.take(b"WS0400000001\r\n\r", "B")
    assert (sent, model.memory[4]) == ([], 1)


def test_frames_without_a_receiver_are_dropped() -> None:
    gateway = Gateway()
    gateway.side.put(b"P0000\n")
    gateway.side.take(b"\n", "A")
    gateway.side.put(b"P0000\n")
    assert not gateway.sent


def test_frames_and_their_header_fit_into_the_largest_datagram() -> None:
    for codec in (CODEC, Codec(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7), node=5)):
        gateway = Gateway(codec)
        gateway.side.take(codec.framing.checked(b"Q"), "A")
        for asks in (True, False):
            if not asks:
                session = codec.framing.checked(b"U4F1C0A3200000001") + codec.framing.checked(b"K0000001")
                gateway.side.take(session, "A")
            gateway.sent.clear()
            gateway.side.put(codec.framing.checked(b"H") * 1000)
            sizes = [len(datagram) for datagram, _ in gateway.sent]
            frame = codec.framing.overhead + 1
            assert all(LARGEST_DATAGRAM - frame < size <= LARGEST_DATAGRAM for size in sizes[:-1])


# Two gateways that are made to hear each other

FRAMES = st.sampled_from([b"K000\r", b"R0A\r", b"r0000A\r", b"X0A\r", b"Q\r"])
FORGED = st.one_of(
    st.binary(max_size=40),
    FRAMES,
    st.builds(
        lambda session, count, frames: b"U%08X%08X\r" % (session, count) + frames,
        st.sampled_from([1, OFFER, OFFER + 1]),
        st.integers(0, 3),
        FRAMES,
    ),
)


@given(forged=st.lists(st.tuples(st.integers(0, 1), FORGED), max_size=6))
def test_gateways_connected_to_each_other_fall_silent(forged: list[tuple[int, bytes]]) -> None:
    under_way = deque(forged)
    sides = [_gateway_that_answers(1 - number, under_way, OFFER + number) for number in range(2)]
    carried = 0
    while under_way:
        receiver, datagram = under_way.popleft()
        sides[receiver].take(datagram, 1 - receiver)
        carried += 1
        assert carried < MOST_CARRIED, "the gateways answer each other without end"


def _gateway_that_answers(other: int, under_way: deque[tuple[int, bytes]], offer: int) -> GatewayDatagrams[int]:
    gateway = VirtualGateway()
    side: GatewayDatagrams[int] = GatewayDatagrams(
        CODEC,
        lambda frames: side.put(gateway.receive(frames, 0.0)),
        lambda datagram, _: under_way.append((other, datagram)),
        itertools.count(offer, 2).__next__,
    )
    return side


# A node on a shared medium


def test_headers_of_a_node_have_its_prefix() -> None:
    codec = Codec(GatewayInfo(), node=5)
    gateway, host, checked = Gateway(codec), HostDatagrams(node=5), codec.framing.checked
    gateway.side.take(b"Z05Q\r", "A")
    gateway.side.put(b"Z05" + ANSWER)
    assert host.take(gateway.sent[0][0]) == b"Z05" + ANSWER
    (opening,) = host.put(checked(b"K0000001"))
    assert opening == checked(b"U4F1C0A3200000001") + checked(b"K0000001")
    gateway.side.take(opening, "A")
    assert gateway.executed == [b"Z05Q\r\n", checked(b"K0000001")]


def test_a_session_cannot_be_opened_for_all_nodes_without_a_header() -> None:
    gateway = Gateway(Codec(GatewayInfo(), node=5))
    gateway.side.take(b"ZFFK0000001\rZFFW0A1\r", "A")
    assert gateway.executed == [b"ZFFW0A1\r\n"]
    assert not any(b"X" in datagram for datagram, _ in gateway.sent)


# The host


@pytest.mark.parametrize(
    "datagram",
    [
        CHECKED(b"U4F1C0A3300000001") + CHECKED(b"r000"),
        CHECKED(b"U4F1C0A3200000001") + CHECKED(b"r000"),
        b"U4F1C0A3200000000\r\n" + ANSWER,
        CHECKED(b"U4F1C0A3300000000") + CHECKED(b"X0A"),
        CHECKED(b"U4F1C0A3200000000") + b"X0A0000\n",
        CHECKED(b"r000"),
        b"U4F1C0A32000000020000\n" + CHECKED(b"r000"),
        b"",
    ],
    ids=[
        "another session",
        "late",
        "a late offer",
        "another's refusal",
        "a damaged refusal",
        "no header",
        "a damaged header",
        "nothing",
    ],
)
def test_a_host_accepts_only_newer_datagrams_of_its_session(datagram: bytes) -> None:
    host = opened_host()
    assert host.take(CHECKED(b"U4F1C0A3200000001") + CHECKED(b"K5A0")) == CHECKED(b"K5A0")
    assert host.take(datagram) == b""
    assert host.take(CHECKED(b"U4F1C0A3200000002") + CHECKED(b"r000")) == CHECKED(b"r000")


@pytest.mark.parametrize(
    ("sent", "taken"),
    [(b"\xb5\x01\xca", b"\xb5\x01\xca"), (b"\xb5\x01\xca\n", b"\xb5\x01\xca"), (b"r00", b"r00\n")],
)
def test_a_host_adds_a_line_end_to_text_but_not_to_compact_frames(sent: bytes, taken: bytes) -> None:
    assert opened_host().take(CHECKED(b"U4F1C0A3200000001") + sent) == taken


@pytest.mark.parametrize("refusal", [CHECKED(b"U4F1C0A3200000000") + CHECKED(b"X0A"), b"U4F1C0A3200000000\r\nX0A\r\n"])
def test_a_refusal_ends_the_session_of_a_host_with_an_error(refusal: bytes) -> None:
    with pytest.raises(ConnectError, match="the gateway was reset, or another program has opened a session with it"):
        opened_host().take(refusal)


def test_a_host_opens_the_session_of_the_last_offer() -> None:
    host = HostDatagrams()
    assert host.put(CHECKED(b"K000")) == []
    for offer in (b"00000001", b"00000002", b"00000000"):
        host.take(b"U" + offer + b"00000000\r\n" + ANSWER)
    assert host.take(b"U0000000300000000\r\nX0A\r\n") == b""
    assert host.take(CHECKED(b"U0000000300000001") + CHECKED(b"r000")) == b""
    (opening,) = host.put(CHECKED(b"K000"))
    assert opening.startswith(b"U0000000200000001")


@pytest.mark.parametrize("question", [CHECKED(b"K"), b"K\r", b"\n" + CHECKED(b"K")])
def test_a_session_query_of_a_host_opens_no_session(question: bytes) -> None:
    host = HostDatagrams()
    host.take(b"U4F1C0A3200000000\r\n" + ANSWER)
    assert host.put(question) == [question]
    assert host.take(b"U4F1C0A32000000009409\n" + CHECKED(b"K1234")) == CHECKED(b"K1234")
    assert host.put(CHECKED(b"K5A00001")) == [b"U4F1C0A32000000018428\nK5A00001E9A0\n"]


def test_a_host_takes_the_crc_of_headers_from_the_configuration() -> None:
    codec = Codec(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7))
    host = HostDatagrams()
    host.take(b"U4F1C0A3200000000\r\nQ" + codec.info.to_hex() + b"\r\n")
    for damaged in (b"Q02\r\n", b"Q" + b"F" * 64 + b"\r\n", b"Q\xff\r\n"):
        assert host.take(b"U4F1C0A3200000000\r\n" + damaged) == damaged
    assert host.put(codec.framing.checked(b"K0000001")) == [
        codec.framing.checked(b"U4F1C0A3200000001") + codec.framing.checked(b"K0000001")
    ]


def test_a_host_accepts_the_answer_of_a_gateway_without_headers() -> None:
    assert HostDatagrams().take(b"Q0120\r\n") == b"Q0120\r\n"


@given(data=st.binary(max_size=60))
def test_arbitrary_datagrams_raise_no_error_on_either_side(data: bytes) -> None:
    for datagram in (data, b"U" + data, b"U4F1C0A3200000002\r" + data):
        assert isinstance(HostDatagrams().take(datagram), bytes)
        assert isinstance(opened_host().take(datagram), bytes)
        Gateway().side.take(datagram, "A")
        gateway = Gateway().opened()
        gateway.side.take(datagram, "A")
        gateway.side.put(data)
