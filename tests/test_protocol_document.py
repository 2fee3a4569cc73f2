"""docs/protocol.md is right: the gateway model returns the CRCs, messages and answers of its examples."""

import itertools
import re

import fastcrc
import pytest

from support.worked_examples import DOCUMENT, Example, worked_examples
from unity_link.protocol.host.handshake import NEVER_CHOSEN
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import last_session, seed_of
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.faults import Failing
from unity_link.virtual.gateway import VirtualGateway

EXAMPLES = worked_examples()


def documented_gateway(example: Example) -> VirtualGateway:
    """Return a gateway after a reset, with the configuration in the document's answer to Q."""
    text = DOCUMENT.read_text(encoding="utf-8")
    info = GatewayInfo.from_hex(re.search(r"^< Q([0-9A-F]+)␍␊", text, re.MULTILINE)[1].encode())  # type: ignore[index]
    gateway = VirtualGateway(info, node=example.node)
    gateway.memory.update(example.memory)
    gateway.attach(Failing(ErrorCode.BUS_ERROR), example.bus_errors)
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), example.bus_timeouts)
    return gateway


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: f"line {example.line}")
def test_gateway_model_answers_as_the_document_states(example: Example) -> None:
    gateway = documented_gateway(example)
    for sent, answered in example.exchange:
        assert gateway.receive(sent, now=0.0) == answered, sent


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: f"line {example.line}")
def test_checked_frames_have_the_right_crc_unless_answered_by_a_crc_error(example: Example) -> None:
    for (frame, from_gateway, session), behind in itertools.pairwise([*example.frames_in_sessions, (b"", False, 0)]):
        if frame.endswith(b"\r\n") or frame == b"\n" or not frame.endswith(b"\n"):
            continue
        body, crc = frame[:-5], frame[-5:-1]
        start = 3 if body.startswith(b"Z") else 0
        of_session = body[start : start + 1].islower() or (from_gateway and body.startswith(b"P"))
        begun = fastcrc.crc16.xmodem(body[:start]) ^ (seed_of(session, from_gateway=from_gateway) * of_session)
        right = crc.upper() == b"%04X" % fastcrc.crc16.xmodem(body[start:], begun)
        assert right != (not from_gateway and behind[0].startswith(b"X01")), frame


def test_the_examples_show_every_message() -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    documented = set(re.findall(r"^\| `([G-Z]+)\b.*` \|.*\|.*\|$", text, re.MULTILINE))
    assert len(documented) == 16
    shown = {
        re.match(rb"[G-Zg-z]*", frame)[0].decode().upper()  # type: ignore[index]
        for example in EXAMPLES
        for frame in example.frames
        if example.node is None
    }
    assert documented | {"P", "X", "N"} <= shown


def test_the_examples_show_every_error_that_a_short_example_can_show() -> None:
    shown = {
        int(match[1], 16)
        for example in EXAMPLES
        for _, answered in example.exchange
        if (match := re.match(rb"(?:X|x...)([0-9A-F]{2})", answered))
    }
    # 07 needs a frame longer than a page is wide; 09 needs lost bytes.
    assert shown == set(ErrorCode) - {ErrorCode.TOO_LONG, ErrorCode.RECEIVE_OVERFLOW}


def test_the_chances_of_a_number_that_comes_again_follow_from_the_numbers() -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    chances = [
        [int(number.replace(",", "")) for number in pair]
        for pair in re.findall(r"\| 1 in ([\d,]+); 1 in ([\d,]+) \|", text)
    ]
    numbers = [
        len(set(range(1, last_session(digits) + 1)) - {never_chosen})
        for digits, never_chosen in zip((2, 4), NEVER_CHOSEN, strict=True)
    ]
    half = [2 * number for number in numbers]
    one_id = [number * ids for number, ids in zip(numbers, (1 << 8, 1 << 12), strict=True)]
    assert chances == [half, one_id, numbers]


def test_the_answer_to_q_has_the_digits_of_the_table() -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    table = text[text.index("\n## Configuration") :]
    digits = sum(int(number) for number in re.findall(r"^\| [^|]+ \| (\d+) \|", table, re.MULTILINE))
    answers = {answered for example in EXAMPLES for sent, answered in example.exchange if sent == b"Q\r"}
    assert [len(answer.strip()) - 1 for answer in answers] == [digits]
