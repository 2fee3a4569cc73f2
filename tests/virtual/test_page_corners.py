"""Sentences of docs/protocol.md without an example, on the model and on the compiled gateware."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from support.makers import BUS_ERROR, COMPACT, Maker, compiled, simulated, with_failing
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.messages import Codec, ErrorCode
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from unity_link.virtual import BareGateway

BOTH = pytest.mark.parametrize(
    "make", [simulated, pytest.param(compiled, marks=pytest.mark.rtl)], ids=["model", "gateware"]
)
NUMBER = 0x1234


class Person:
    """Types plain or checked frames, and stores the number of the session."""

    def __init__(self, gateway: BareGateway) -> None:
        self.gateway, self._codec = gateway, Codec(gateway.info)
        self.number = 0

    def ask(self, body: bytes) -> bytes:
        """Return the answers to a checked frame, without their CRCs."""
        answers = self.gateway.receive(self.frame(body), 0.0)
        return b" ".join(self.open(answer) for answer in answers.split(b"\n")[:-1])

    def frame(self, body: bytes) -> bytes:
        seed = seed_of(self.number, from_gateway=False) if body[:1].islower() else 0
        return self._codec.framing.checked(body, seed)

    def open(self, answer: bytes) -> bytes:
        seed = seed_of(self.number, from_gateway=True) if answer[:1].islower() or answer[:1] == b"P" else 0
        return answer.rstrip(b"\r") if answer.endswith(b"\r") else self._codec.framing.open(answer, seed)

    def begin(self, number: int = NUMBER, first: bytes = b"000") -> bytes:
        answer = self.ask(b"K%b%04X" % (first, number))
        self.number = number
        return answer


@BOTH
def test_a_plain_group_of_a_person_stays_plain_in_a_program_s_session(make: Maker) -> None:
    person = Person(make())
    gateway = person.gateway
    gateway.memory[0x0A] = 0x12
    gateway.receive(b"K0000001\r", 0.0)
    assert gateway.receive(b"GS03200001010A\r", 0.0) == b"GS03\r\n"
    person.begin()
    assert person.ask(b"gs00003200001010A") == b"x00006"
    sample, answer, _ = gateway.receive(person.frame(b"gp00103"), 0.0).split(b"\n")
    assert sample == b"P030000000012\r"
    assert person.open(answer) == b"gp001"


@BOTH
@pytest.mark.parametrize("fields", [{}, COMPACT], ids=["text", "compact"])
def test_the_number_of_the_open_session_is_refused_with_0b(make: Maker, fields: dict[str, int]) -> None:
    person = Person(make(**fields))
    person.begin()
    for number in (NUMBER, NUMBER | 0x8000):
        assert person.ask(b"K000%04X" % number) == b"X0B"
    assert person.ask(b"K0000000") == b"X06"
    assert person.ask(b"K0008000") == b"X06"


@BOTH
def test_a_number_with_the_highest_bit_is_out_of_range_without_compact(make: Maker) -> None:
    person = Person(make())
    person.begin()
    assert person.ask(b"K0009235") == b"X06"


@BOTH
def test_the_command_of_a_repetition_determines_its_answer(make: Maker) -> None:
    """Hosts retransmit the same request; a different one with its ID is answered according to the stored outcome."""
    person = Person(with_failing(make()))
    gateway = person.gateway
    person.begin()
    gateway.memory[0x0A] = 0x11
    assert person.ask(b"rq0000A02") == b"rq0000000001100000011"
    gateway.memory[0x0A] = 0x22
    assert person.ask(b"r0000A") == b"r00000000022"
    assert person.ask(b"rq0000A01") == b"rq00000000011"
    assert person.ask(b"w0000A00000033") == b"w000"
    assert gateway.memory[0x0A] == 0x22
    assert person.ask(b"w001%02X00000001" % BUS_ERROR) == b"x00104"
    assert person.ask(b"r0010A") == b"x00104"


@BOTH
def test_a_repeated_read_that_fails_keeps_the_outcome_of_the_request(make: Maker) -> None:
    person = Person(make())
    gateway = person.gateway
    person.begin()
    assert person.ask(b"r0000A") == b"r00000000000"
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [0x0A])
    assert person.ask(b"r0000A") == b"x00004"
    assert person.ask(b"h000") == b"h000000"
    gateway.detach([0x0A])
    assert person.ask(b"r0000A") == b"r00000000000"


@BOTH
def test_a_session_keeps_the_outcomes_and_words_of_earlier_requests(make: Maker) -> None:
    person = Person(with_failing(make()))
    gateway = person.gateway
    gateway.memory[0x0A] = 0x11
    person.begin()
    assert person.ask(b"w000%02X00000001" % BUS_ERROR) == b"x00004"
    assert person.ask(b"rq0010A01") == b"rq00100000011"
    person.begin(NUMBER + 1, b"002")
    assert person.ask(b"h000") == b"x00004"
    assert person.ask(b"rq0010A01") == b"rq00100000011"
