"""Decoded capture: both directions, cut anywhere; samples follow the settings that the gateway has confirmed."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.capture.decoder import FrameKind
from unity_link.capture.transcript import TimedFrame, Transcript
from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.host.trial import FIRST_IDS, IDS, Trial
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.virtual import VirtualGateway


def checked(body: bytes) -> bytes:
    return body + Crc().text(body) + b"\n"


def frames_of(*lines: bytes) -> list[TimedFrame]:
    """Decode whole lines, each with its direction as first character; return their frames."""
    transcript = Transcript()
    return [
        frame
        for second, line in enumerate(lines)
        for frame in transcript.take(line[1:], float(second), sent=line[:1] == b">")
    ]


def words(*lines: bytes) -> list[str]:
    return [frame.meaning.words for frame in frames_of(*lines)]


@pytest.mark.parametrize(
    ("body", "text"),
    [
        (b"R0A", "read 0x0A"),
        (b"RM0A04", "read 4 words from 0x0A on"),
        (b"RQ0A04", "read 4 words of the queue at 0x0A"),
        (b"W0A0000002A", "write 0x0000002A (42) to 0x0A"),
        (b"WM0A0000002A00000001", "write 2 words from 0x0A on: 0x0000002A (42), 0x00000001 (1)"),
        (b"WQ0A0000002A", "write 1 words to the queue at 0x0A: 0x0000002A (42)"),
        (b"WK0A000000FF0000002A", "write the bits 0x000000FF of 0x0000002A (42) to 0x0A"),
        (b"WS0A0000002A", "post 0x0000002A (42) to 0x0A"),
        (b"GS0309000A020A0B", "set up group 3: 0x0A, 0x0B; every 10 ticks, with timestamps"),
        (b"GS030200010110", "set up group 3: 0x10; at its trigger"),
        (b"GS033400010110", "set up group 3: 0x10; sent immediately, on change, in plain frames"),
        (b"GS030000010110", "set up group 3: 0x10; when it is asked to"),
        (b"GN03", "start group 3"),
        (b"GX03", "stop group 3"),
        (b"GP03", "publish group 3 once"),
        (b"I00", "send-immediate: off"),
        (b"I01", "send-immediate: always"),
        (b"I02", "send-immediate: adaptive"),
        (b"H", "do nothing, and answer"),
        (b"Q", "what are you?"),
        (b"K0AB1234", "begin session 1234, the next ID is 0AB"),
        (b"K", "which session is under way?"),
        (b"r0FF0A", "read 0x0A (ID 0FF)"),
    ],
)
def test_each_request_has_words(body: bytes, text: str) -> None:
    assert words(b">" + checked(body)) == [text]
    assert words(b">" + body + b"\r") == [text]


def test_each_command_has_words_for_its_answer() -> None:
    lines = [
        (b"RQ0A02", b"RQ0A020000000100000002", "queue read of 2 words at 0x0A: 0x00000001 (1), 0x00000002 (2)"),
        (
            b"rm0010A02",
            b"rm0010000000100000002",
            "block read of 2 words from 0x0A: 0x00000001 (1), 0x00000002 (2) (ID 001)",
        ),
        (b"wm0020A00000001", b"wm002", "block write of 1 words from 0x0A done (ID 002)"),
        (b"wk0030AFFFFFFFF00000001", b"wk00300000007", "masked write to 0x0A done, it held 0x00000007 (7) (ID 003)"),
        (b"gs00403010001010A", b"gs004", "group 3 is set up (ID 004)"),
        (b"i00502", b"i005", "send-immediate is adaptive (ID 005)"),
        (
            b"h006",
            b"x0060A0000",
            "error 0A: no session has begun since the gateway's reset: begin with K0000001 (ID 006)",
        ),
        (b"h008", b"h008000", "nothing, done (ID 008)"),
        (b"h009", b"h009002", "nothing, done; 2 posted writes of the session have failed (ID 009)"),
        (b"K0001234", b"K00012340000", "session 1234 has begun, the next ID expected is 000; no session ended"),
        (b"K0001234", b"K00012344321", "session 1234 has begun, the next ID expected is 000; session 4321 ended"),
        (b"K", b"K1234", "session 1234 is under way"),
        (b"K", b"K0000", "no session is under way"),
        (b"h007", b"n006", "out of sequence: the next ID expected is 006"),
        (b"h80A", b"n00B", "the next ID expected is 00B: the session is still this one"),
    ]
    for request, answer, text in lines:
        assert words(b">" + checked(request), b"<" + checked(answer))[1] == text


@pytest.mark.parametrize(
    ("code", "text"),
    [
        (b"01", "the CRC was wrong"),
        (b"02", "unknown command"),
        (b"03", "malformed"),
        (b"04", "the bus refused"),
        (b"05", "nothing on the bus answered"),
        (b"06", "out of range"),
        (b"07", "longer than"),
        (b"09", "the gateway's receive FIFO was full"),
        (b"0A", "no session has begun"),
        (b"0B", "the session of a program"),
        (b"0C", "error 0C"),
    ],
)
def test_each_error_has_the_words_of_its_own_code(code: bytes, text: str) -> None:
    (said,) = words(b"<" + checked(b"X" + code))
    assert text in said


def test_damaged_frames_are_distinguished_from_noise() -> None:
    damaged = checked(b"R0A").replace(b"A", b"B", 1)
    kinds = [
        frame.meaning.kind for frame in frames_of(b">" + damaged, b"<" + damaged, b">" + checked(b"J"), b"<hello\r\n")
    ]
    assert kinds == [FrameKind.DAMAGED, FrameKind.DAMAGED, FrameKind.UNKNOWN, FrameKind.UNKNOWN]


def test_samples_follow_the_settings_that_an_answer_has_confirmed() -> None:
    first, second = checked(b"gs0000301000A010A"), checked(b"gs0010309000A020A0B")
    said = words(
        b">" + first,
        b"<" + checked(b"gs000"),
        b">" + second,
        b"<" + checked(b"P030000000007"),
        b"<" + checked(b"P0301000000070"),
        b"<" + checked(b"P03010000000700000008"),
        b"<" + checked(b"h001000"),
        b"<" + checked(b"P030002FAF0800000000100000002"),
    )
    assert said[3] == "sample 0 of group 3: 0x0A = 7"
    assert said[4] == said[5] == "sample 1 of group 3, which is not as long as the group's settings say"
    assert said[7] == "sample 0 of group 3 at 1.000000 s: 0x0A = 1, 0x0B = 2"


def test_settings_without_an_id_are_confirmed_only_by_their_answer() -> None:
    said = words(
        b">" + checked(b"GS0301000A010A"),
        b"<" + checked(b"GX03"),
        b"<" + checked(b"P030000000007"),
        b"<" + checked(b"GS03"),
        b"<" + checked(b"P030000000007"),
    )
    assert "0x0A" not in said[2]
    assert said[4] == "sample 0 of group 3: 0x0A = 7"


def test_refused_settings_do_not_change_how_samples_are_decoded() -> None:
    said = words(
        b">" + checked(b"gs0000301000A010A"),
        b"<" + checked(b"gs000"),
        b">" + checked(b"gs0010301000A020A0B"),
        b"<" + checked(b"x00106"),
        b"<" + checked(b"h002000"),
        b"<" + checked(b"P030000000007"),
    )
    assert said[-1] == "sample 0 of group 3: 0x0A = 7"


def test_a_retransmission_is_recognised_by_its_id_and_has_no_round_trip() -> None:
    frames = frames_of(
        b">" + checked(b"KFFF1234"),
        b">" + checked(b"rFFF0A"),
        b">" + checked(b"r0000B"),
        b"<" + checked(b"rFFF00000001"),
        b">" + checked(b"r0000B"),
        b"<" + checked(b"r00000000002"),
    )
    assert [frame.again for frame in frames] == [False, False, False, False, True, False]
    assert [frame.round_trip for frame in frames if not frame.sent] == [2.0, None]


@pytest.mark.parametrize(
    "info", [GatewayInfo(data_bits=16, id_digits=2, crc_bits=8, crc_polynomial=7), GatewayInfo(data_bits=64)]
)
def test_the_widths_are_those_of_the_gateways_answer(info: GatewayInfo) -> None:
    transcript = Transcript()
    list(transcript.take(b"Q" + info.to_hex() + b"\r\n", 0.0, sent=False))
    assert transcript.codec.info == info
    frame = transcript.codec.framing.checked(transcript.codec.fields("R", 0x0A).join((b"R", b"")))
    (said,) = transcript.take(frame, 0.0, sent=True)
    assert said.meaning.words == "read 0x0A"


def test_frames_of_a_shared_medium_are_decoded_without_their_prefix() -> None:
    info = GatewayInfo(features=GatewayInfo().features | Feature.ADDRESSED)
    said = words(
        b">Z1AQ\r",
        b"<Z1AQ" + info.to_hex() + b"\r\n",
        b">" + checked(b"Z1AR0A"),
        b">" + checked(b"ZFFWS0A00000001"),
        b"<" + checked(b"Z06R0A00000001"),
    )
    assert said[0] == "what are you?"
    assert said[2:4] == ["read 0x0A", "to all nodes: post 0x00000001 (1) to 0x0A"]
    assert said[4].startswith("damaged: not from node 1A")


WHOLE = b"".join((b"\nQ\r", checked(b"K0001234"), checked(b"r0000A"), b"R0A\r\n", checked(b"h001000")))


@given(st.lists(st.integers(0, len(WHOLE))), st.booleans())
def test_the_decoded_frames_do_not_depend_on_the_cuts(cuts: list[int], sent: bool) -> None:
    def frames(*pieces: bytes) -> list[bytes]:
        transcript = Transcript()
        return [frame.frame for piece in pieces for frame in transcript.take(piece, 0.0, sent=sent)]

    places = [0, *sorted(cuts), len(WHOLE)]
    assert frames(*(WHOLE[start:end] for start, end in pairwise(places))) == frames(WHOLE)


@given(st.lists(st.tuples(st.binary(max_size=60), st.booleans()), max_size=6))
def test_any_bytes_have_words(passed: list[tuple[bytes, bool]]) -> None:
    transcript = Transcript()
    for data, sent in passed:
        for frame in transcript.take(data, 0.0, sent=sent):
            assert frame.meaning.words
    for frame in transcript.end(1.0):
        assert frame.meaning.kind is FrameKind.DAMAGED


def test_a_sample_without_a_timestamp_has_only_the_words_of_its_group() -> None:
    said = words(
        b">" + checked(b"gs000033100010110"),
        b"<" + checked(b"gs000"),
        b"<" + checked(b"P030100000007"),
    )
    assert said[2] == "sample 1 of group 3: 0x10 = 7"


COMPACT = GatewayInfo(features=GatewayInfo().features | Feature.COMPACT)


@pytest.mark.parametrize(
    "cut",
    [b"\xb5\x00\x00\xd3J^V\r", b"\xb5\x00\x00\xd3J^V\n", b"\xb5\x00\x00\xd3J^V\xd3\xca", b"r0000A5E56\xca", b"\xca"],
)
def test_a_cut_compact_frame_is_damaged(cut: bytes) -> None:
    whole = b"\xb5\x00\x00\xd3J^V\xca"
    opening = b">" + checked(b"K0009234"), b"<" + checked(b"K00092340000")
    kinds = [frame.meaning.kind for frame in frames_of(*opening, b">" + whole, b">" + cut, b">" + whole)][2:]
    assert kinds == [FrameKind.REQUEST, FrameKind.DAMAGED, FrameKind.REQUEST]


def test_requests_of_a_trial_are_not_counted_as_retransmissions() -> None:
    gateway, transcript, number = VirtualGateway(COMPACT), Transcript(), 0x1234
    codec = HostCodec(COMPACT)
    trial = Trial(codec, number, takes_turns=False)
    opening = codec.framing.checked(codec.opening(FIRST_IDS[3][0], number | COMPACT.asks_compact))
    codec.begin(number)
    write = codec.request("W", FIRST_IDS[3][0], codec.fields("W", 1, 2), codec.seed)
    again = []
    for sent in (b"Q\r", opening, trial.frames(), write, write):
        again += [frame.again for frame in transcript.take(sent, 0.0, sent=True)]
        assert not any(frame.again for frame in transcript.take(gateway.receive(sent, 0.0), 0.0, sent=False))
    assert again == [False] * (3 + len(IDS[3])) + [True]
