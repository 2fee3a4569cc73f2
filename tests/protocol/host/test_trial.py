"""The trial of the compact form: it has the bytes that lines change, in both directions, and executes no request."""

from __future__ import annotations

import pytest

from protocol_model.gateway_on_the_page import END, ESCAPE, START
from support.makers import BUS_ERROR, COMPACT, RTL, compiled, simulated, with_failing
from unity_link.protocol.host.handshake import NOT_CARRIED, Handshake, SessionNumbers, State
from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.host.trial import FIRST_IDS, ID_ALONE, IDS, Trial, first_id
from unity_link.protocol.window.constants import DAMAGE_PAUSE, FIRST_TRY, TRIALS
from unity_link.protocol.wire.compact import CompactForm, Packer
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.virtual import VirtualGateway

FEATURES = GatewayInfo().features | Feature.COMPACT
WIDTHS = [
    GatewayInfo(id_digits=ids, crc_bits=bits, crc_polynomial=polynomial, features=FEATURES)
    for ids in (2, 3)
    for bits, polynomial in ((8, 0x07), (16, 0x1021), (32, 0x04C11DB7))
]
CHANGED = {0x00, 0x11, 0x13, 0xFF, ESCAPE, START, END}
"""Bytes that some lines change, and the reserved bytes of the compact form (with the highest bit set)."""
SESSION = 0x35


def trial_of(info: GatewayInfo, *, takes_turns: bool = False) -> Trial:
    return Trial(HostCodec(info), SESSION, takes_turns=takes_turns)


def answers_of(info: GatewayInfo, *, fails: bool) -> bytes:
    """Return the answers to a trial; if `fails`, the gateway has an error stored for each ID."""
    codec, packer = HostCodec(info), Packer(CompactForm.of(info, from_gateway=True))
    zeros = b"0" * info.id_digits
    bodies = [
        b"x%b04" % codec.id_text[i] if fails else b"h%b%b" % (codec.id_text[i], zeros) for i in IDS[info.id_digits]
    ]
    seed = seed_of(SESSION, from_gateway=True)
    return b"".join(packer.pack_one(codec.framing.checked(body, seed)) for body in bodies)


@pytest.mark.parametrize("info", WIDTHS, ids=lambda info: f"{info.id_digits}-{info.crc_bits}")
def test_requests_and_either_kind_of_answer_have_the_bytes_that_lines_change(info: GatewayInfo) -> None:
    assert set(trial_of(info).frames()) >= CHANGED
    for fails in (False, True):
        answers = answers_of(info, fails=fails)
        assert set(answers) >= CHANGED
        trial = trial_of(info)
        trial.frames()
        for at in range(len(answers)):
            assert not trial.has_passed
            trial.receive(answers[at : at + 1])
        assert trial.has_passed


@pytest.mark.parametrize("digits", [2, 3])
def test_each_request_of_a_trial_is_before_the_first_id_of_its_session(digits: int) -> None:
    ring = 16**digits
    for first in FIRST_IDS[digits]:
        assert all((number - first) % ring >= ring // 2 for number in IDS[digits])
    chosen = {first_id(choice, GatewayInfo(id_digits=digits)) for choice in range(1 << 12)}
    assert chosen == set(FIRST_IDS[digits])


@pytest.mark.parametrize("kind", ["sim", RTL])
def test_a_gateway_executes_no_request_of_a_trial_and_keeps_its_next_id(kind: str) -> None:
    gateway = with_failing((compiled if kind == "rtl" else simulated)(**COMPACT))
    info, codec = gateway.info, HostCodec(gateway.info)
    # An earlier session has left errors for half of the IDs.
    for number, place in enumerate(IDS[3]):
        gateway.receive(codec.framing.checked(codec.opening(place, 1 + number)), 0.0)
        address = BUS_ERROR if number % 2 else 0
        frame = codec.request("W", place, codec.fields("W", address, number), seed_of(1 + number, from_gateway=False))
        gateway.receive(frame, 0.0)
    first, before = FIRST_IDS[3][7], dict(gateway.memory)
    gateway.receive(codec.framing.checked(codec.opening(first, SESSION | info.asks_compact)), 0.0)
    trial = trial_of(info)
    for _ in range(3):
        trial.receive(gateway.receive(trial.frames(), 0.0))
    assert trial.has_passed
    assert dict(gateway.memory) == before
    codec.begin(SESSION)
    answer = gateway.receive(codec.request("H", first, b"", codec.seed), 0.0)
    body = b"h%b000" % codec.id_text[first]
    packer = Packer(CompactForm.of(info, from_gateway=True))
    assert answer == packer.pack_one(codec.framing.checked(body, codec.seed_back))


@pytest.mark.parametrize(
    ("info", "takes_turns"),
    [
        (GatewayInfo(features=FEATURES | Feature.HALF_DUPLEX), False),
        (GatewayInfo(features=FEATURES), True),
        (GatewayInfo(features=FEATURES & ~Feature.FLOW_CONTROL, receive_fifo_bytes=16), False),
    ],
    ids=["half duplex", "turns", "small receive FIFO"],
)
def test_a_gateway_that_takes_one_request_at_a_time_is_tried_with_one(info: GatewayInfo, *, takes_turns: bool) -> None:
    trial = trial_of(info, takes_turns=takes_turns)
    assert trial.frames().count(START) == 1
    at = IDS[3].index(ID_ALONE[3])
    answers = answers_of(info, fails=False).replace(bytes((END,)), bytes((END, 0))).split(b"\0" + bytes((START,)))
    trial.receive(bytes((START,)) * (at > 0) + answers[at].rstrip(b"\0"))
    assert trial.has_passed


def test_unanswered_requests_of_a_trial_are_repeated_after_the_last_answer() -> None:
    info = WIDTHS[4]
    trial, all_frames = trial_of(info), trial_of(info).frames()
    assert trial.frames() == all_frames
    answers = answers_of(info, fails=False)
    trial.receive(answers[:-2] + bytes((answers[-2] ^ 1, END)))
    assert (trial.has_passed, trial.is_answered) == (False, True)
    assert all_frames.endswith(trial.frames())
    assert trial.frames().count(START) == 1


# In a handshake


class Opening:
    """A handshake with a gateway that has the compact form, up to the trial."""

    def __init__(self, *, is_transparent: bool = False) -> None:
        numbers = SessionNumbers(iter(range(0x500, 0x600)).__next__)
        self.gateway = VirtualGateway(WIDTHS[4])
        self.handshake = Handshake(None, numbers, 0.0, compact=True, is_transparent=is_transparent)
        for step in range(3):
            self.answer(0.001 * (step + 1))

    def answer(self, now: float) -> None:
        """Pass the output of the handshake to the gateway, and its answer back."""
        self.handshake.receive(self.gateway.receive(self.handshake.take_output(), now), now)


def test_a_session_in_compact_form_begins_after_the_trial() -> None:
    opening = Opening()
    assert opening.handshake.state is State.TRYING
    opening.answer(0.01)
    assert opening.handshake.complete
    assert opening.handshake.compact
    assert opening.gateway.expected == opening.handshake.first


def test_a_line_known_to_carry_all_bytes_is_not_tried() -> None:
    handshake = Opening(is_transparent=True).handshake
    assert (handshake.complete, handshake.compact) == (True, True)
    assert not handshake.asks


def test_a_session_in_text_begins_if_no_trial_passes() -> None:
    opening = Opening()
    handshake, tried = opening.handshake, opening.handshake.session
    for number in range(TRIALS):
        assert handshake.take_output().count(START) == len(IDS[3]), number
        handshake.expire(handshake.deadline - 1e-6)
        assert not handshake.asks
        handshake.expire(handshake.deadline)
    assert handshake.describe() == NOT_CARRIED
    opening.answer(1.0)
    assert handshake.complete
    assert not handshake.compact
    assert handshake.session != tried
    assert (opening.gateway.session, opening.gateway.expected) == (handshake.session, handshake.first)


def test_a_damaged_trial_is_repeated_sooner_than_an_unanswered_one() -> None:
    opening = Opening()
    handshake = opening.handshake
    assert handshake.deadline > 0.003 + FIRST_TRY
    handshake.receive(opening.gateway.receive(handshake.take_output(), 0.01).translate(None, b"\0"), 0.01)
    assert handshake.deadline == pytest.approx(0.01 + DAMAGE_PAUSE)
    handshake.expire(handshake.deadline)
    assert handshake.asks
