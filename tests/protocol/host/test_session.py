"""The host's side of a link as a whole, and the outcome of its requests when it ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from support.floods import FLOODS
from support.valve import as_gateway
from unity_link.errors import ConnectError, LinkLostError, Outcome, UnansweredError, UnsupportedError
from unity_link.protocol.host.batches import WordBatch, common_outcome
from unity_link.protocol.host.events import Interrupted, Opened, Unusable
from unity_link.protocol.host.requests import Confirmation, Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.window.constants import LONGEST_SILENCE, MOST_REFUSALS
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.group_table import HeldGroup


def opened(*, resumes: bool) -> tuple[Session, VirtualGateway]:
    """Return an open session and its gateway."""
    session, gateway = Session(None, lambda: 0, resumes=resumes), VirtualGateway()
    session.connect(0.0, 0.003)
    while not session.is_open:
        session.receive(gateway.receive(session.take_output(), 0.0), 0.0)
    return session, gateway


def hold(session: Session, flags: GroupFlag = GroupFlag.PERIODIC) -> HeldGroup:
    """Hold a group of one word."""
    return session.groups.hold(session.codec.fields("GS", 0, int(flags), 1000, 1, [0x10])[2:], 12, None)


def outcome_of(request: Request) -> Outcome:
    assert isinstance(request.error, LinkLostError)
    return request.error.outcome


@pytest.mark.parametrize("resumes", [False, True])
def test_the_outcome_of_a_read_in_flight_at_the_close_is_unknown(*, resumes: bool) -> None:
    session, _ = opened(resumes=resumes)
    read = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    session.submit(read, 0.0)
    session.take_output()
    session.close(LinkLostError("the link was closed"))
    assert outcome_of(read) is Outcome.UNKNOWN


def test_a_resuming_session_answers_a_read_that_was_in_flight() -> None:
    session, gateway = opened(resumes=True)
    gateway.memory[0x10] = 42
    read = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    session.submit(read, 0.0)
    session.take_output()
    session.disconnect("the line was lost")
    assert (read.answer, read.error) == (None, None)
    session.connect(1.0, 0.003)
    for _ in range(8):
        session.receive(gateway.receive(session.take_output(), 1.0), 1.0)
    assert read.answer == 42


def test_a_refusal_of_a_damaged_request_does_not_cover_the_id_in_it() -> None:
    session, gateway = opened(resumes=False)
    first, second = (Request(session.codec, "W", session.codec.fields("W", 0x10, word), 0) for word in (1, 2))
    session.submit(first, 0.0)
    gateway.receive(session.take_output(), 0.0)
    session.submit(second, 0.0)
    gateway.reset()
    damaged = session.take_output().replace(b"w001", b"w000")
    answer = gateway.receive(damaged, 0.0)
    assert answer.startswith(b"x0000A")
    while answer:
        session.receive(answer, 0.0)
        answer = gateway.receive(session.take_output(), 0.0)
    assert gateway.memory[0x10] == 1
    assert outcome_of(first) is Outcome.UNKNOWN


@pytest.mark.parametrize("lost_after", range(7))
@pytest.mark.parametrize("reset_after", [*range(12), None])
def test_a_reset_during_a_reconnection_is_reported_before_the_session(reset_after: int | None, lost_after: int) -> None:
    session, gateway = opened(resumes=False)
    flags = GroupFlag.PERIODIC | GroupFlag.TIMESTAMP
    session.start(hold(session, flags), 0.0)
    changes: list[type] = []
    for turn in range(-4, 24):
        now = 0.1 * turn
        if turn in (0, lost_after):
            session.disconnect("the line was lost")
            session.connect(now, 0.003)
        if turn == reset_after:
            gateway.reset()
        if turn == 12:
            # An open session finds a reset only by an answer, so submit a request.
            session.submit(Confirmation(session.codec), now)
        events = session.receive(gateway.receive(session.take_output(), now), now)
        changes += [type(event) for event in events if isinstance(event, Interrupted | Opened)]
    assert session.is_open
    assert changes[-1] is Opened
    assert (Interrupted in changes) == (reset_after is not None)
    if reset_after is not None and reset_after >= lost_after:
        assert changes[-2] is Interrupted


def test_a_reset_between_connections_is_reported_without_groups_too() -> None:
    session, gateway = opened(resumes=False)
    gateway.reset()
    session.disconnect("the line was lost")
    session.connect(1.0, 0.003)
    events: list[object] = []
    while not session.is_open:
        events += session.receive(gateway.receive(session.take_output(), 1.0), 1.0)
    assert [type(event) for event in events if isinstance(event, Interrupted | Opened)] == [Interrupted, Opened]


@pytest.mark.parametrize(
    "answer", [b"\nQ\r\n", b"Q" + GatewayInfo(groups=1).to_hex().replace(b"03", b"09", 1) + b"\r\n"]
)
def test_an_answer_that_no_gateway_sends_makes_the_connection_unusable(answer: bytes) -> None:
    session = Session(None, lambda: 0)
    session.connect(0.0, 0.003)
    events = [event for number in range(8) for event in session.receive(answer, 0.2 * number)]
    assert [type(event) for event in events] == [Unusable]
    assert isinstance(events[0], Unusable)
    assert isinstance(events[0].error, ConnectError | UnsupportedError)
    assert not session.is_open


def test_an_answer_without_a_request_is_counted_once() -> None:
    session, _ = opened(resumes=False)
    session.receive(as_gateway(session.codec, b"r12300000000"), 0.0)
    assert session.counters.stray == 1
    session.receive(as_gateway(session.codec, b"rXYZ00000000"), 0.0)
    assert session.counters.stray == 2
    session.receive(as_gateway(session.codec, b"h"), 0.0)
    assert session.counters.stray == 3


@pytest.mark.parametrize("body", [b"r%03X00000099", b"x%03X04", b"x%03X0A", b"n%03X", b"h%03X"])
def test_a_plain_frame_is_no_answer_to_a_checked_request(body: bytes) -> None:
    session, gateway = opened(resumes=False)
    gateway.memory[0x10] = 42
    read = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    session.submit(read, 0.0)
    frame = session.codec.framing.plain_reply(body % read.first if b"%" in body else body)
    assert not session.receive(frame, 0.0)
    assert session.is_open
    assert not session.output[1:]
    session.receive(gateway.receive(session.take_output(), 0.0), 0.0)
    assert (read.answer, read.error) == (42, None)
    assert session.counters.stray == 1


def test_a_plain_sample_of_a_checked_group_is_ignored() -> None:
    session, _ = opened(resumes=False)
    held = hold(session)
    session.start(held, 0.0)
    sample = b"P" + held.text + b"0000000012"
    assert not session.receive(session.codec.framing.plain_reply(sample), 0.0)
    assert session.counters.stray == 1


def test_the_longest_turn_on_an_unknown_line_is_below_a_second() -> None:
    session = Session(0, lambda: 0)
    session.connect(0.0, 0.003)
    assert 0.1 < session.longest_turn < 1


def test_the_longest_turn_on_a_slow_line_includes_the_time_of_bytes() -> None:
    session = Session(0, lambda: 0)
    session.connect(0.0, 0.003, byte_time=0.01)
    assert session.longest_turn == pytest.approx(2.66)


def test_a_session_that_was_never_connected_is_idle() -> None:
    session = Session(0, lambda: 0)
    assert not session.is_owed_an_answer
    assert session.window.in_flight == 0
    assert session.window.send_limit.loses is False
    assert not session.wants_turn
    assert session.deadline is None
    assert session.window.round_trip.smoothed is None


def test_answers_measure_the_round_trip() -> None:
    session, gateway = opened(resumes=False)
    session.submit(Confirmation(session.codec), 1.0)
    session.receive(gateway.receive(session.take_output(), 1.0), 1.25)
    assert session.window.round_trip.smoothed is not None
    assert 0 < session.window.round_trip.smoothed <= 0.25


def test_silence_after_a_reset_makes_the_connection_unusable() -> None:
    session, gateway = opened(resumes=False)
    gateway.reset()
    session.submit(Confirmation(session.codec), 0.0)
    events = session.receive(gateway.receive(session.take_output(), 0.0), 0.0)
    assert [type(event) for event in events] == [Confirmation, Interrupted]
    now = 0.0
    while not any(isinstance(event, Unusable) for event in events):
        assert session.deadline is not None
        now = max(now, session.deadline)
        assert now < 2 * LONGEST_SILENCE
        events = session.expire(now)
        session.take_output()
    assert now >= LONGEST_SILENCE


def test_a_checked_answer_made_plain_by_a_damaged_line_end_is_damaged() -> None:
    session, gateway = opened(resumes=False)
    session.submit(Confirmation(session.codec), 0.0)
    answer = gateway.receive(session.take_output(), 0.0)
    session.receive(answer[:-1] + b"\r\n", 0.0)
    assert (session.counters.damaged, session.counters.stray) == (1, 0)


def test_a_probe_is_not_kept_for_the_next_session() -> None:
    session, gateway = opened(resumes=True)
    session.start(hold(session), 0.0)
    for _ in range(4):
        session.receive(gateway.receive(session.take_output(), 0.0), 0.0)
    assert session.deadline is not None
    session.expire(session.deadline)
    assert b"\nh" in session.take_output()
    session.disconnect("the line was lost")
    session.connect(3.0, 0.003)
    while not session.is_open:
        session.receive(gateway.receive(session.take_output(), 3.0), 3.0)
    assert b"h" not in session.take_output()


def test_the_error_of_a_refused_batch_names_the_refused_request() -> None:
    session, gateway = opened(resumes=False)
    codec, now = session.codec, 0.5
    batch = WordBatch(codec, "R", [(np.arange(0x10, 0x18), codec.info.address_digits)])
    session.submit(batch, now)
    answers = gateway.receive(session.take_output(), now)
    session.receive(answers[: 3 * len(answers) // 8], now)
    while not batch.done:
        assert now < 100.0
        session.receive(codec.framing.checked(b"X03"), now)
        session.receive(gateway.receive(codec.framing.checked(b"K"), now), now)
        session.take_output()
        now += 10.0
    assert "read at 0x13:" in str(batch.error)


@pytest.mark.parametrize("answer", [b"X02\r\n", b"X03\r\n"])
def test_a_plain_refusal_gives_up_no_request(answer: bytes) -> None:
    session, gateway = opened(resumes=False)
    now = 1.0
    request = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    session.submit(request, now)
    for _ in range(2 * MOST_REFUSALS):
        session.take_output()
        session.receive(answer + gateway.receive(session.codec.framing.checked(b"K"), now), now)
    assert request.error is None
    while now < 10.0:
        session.receive(gateway.receive(session.take_output(), now), now)
        now += 0.1
        session.expire(now)
    assert request.answer == 0


def test_one_fence_confirms_several_posted_writes() -> None:
    session, _ = opened(resumes=False)
    codec = session.codec
    for value in range(8):
        session.submit(Request(codec, "WS", codec.fields("WS", 0x10, value), None), 0.0)
    assert [frame[:2] for frame in session.take_output().splitlines()] == [b"ws"] * 8
    assert session.deadline is not None
    session.expire(session.deadline)
    assert session.take_output()[:1] == b"h"


def test_the_longest_turn_of_an_open_session_is_its_longest_answer() -> None:
    session, _ = opened(resumes=False)
    assert session.longest_turn == session.window.longest_answer


@pytest.mark.parametrize(
    ("ends", "outcome"),
    [
        ([None, None], Outcome.EXECUTED),
        ([UnansweredError("lost", Outcome.NOT_EXECUTED)] * 2, Outcome.NOT_EXECUTED),
        ([None, UnansweredError("lost", Outcome.NOT_EXECUTED)], Outcome.UNKNOWN),
    ],
)
def test_requests_submitted_together_have_a_common_outcome(
    ends: list[UnansweredError | None], outcome: Outcome
) -> None:
    session, _ = opened(resumes=False)
    requests = [Confirmation(session.codec) for _ in ends]
    assert common_outcome(requests) is Outcome.UNKNOWN
    for request, error in zip(requests, ends, strict=True):
        request.done, request.error = True, error
    assert common_outcome(requests) is outcome


def test_the_error_for_a_lost_connection_says_if_the_gateway_answered() -> None:
    session, _ = opened(resumes=False)
    assert "just answered" in str(session.connection_error(None))
    session.disconnect("the line was lost")
    session.connect(1.0, 0.003)
    assert "before the gateway answered: no carrier" in str(session.connection_error(OSError("no carrier")))


@pytest.mark.parametrize(("answer", "is_heard"), [(b"r00000000007????\n", True), (b"", False)])
def test_a_gateway_with_only_damaged_answers_is_not_silent(answer: bytes, *, is_heard: bool) -> None:
    session, _ = opened(resumes=False)
    session.submit(Confirmation(session.codec), 0.0)
    told: Events = []
    while not told and (now := session.deadline) is not None and now < 2 * LONGEST_SILENCE:
        session.receive(answer, now)
        told = session.expire(now)
        session.take_output()
    assert [type(event) for event in told] == ([] if is_heard else [Unusable])


def read_until_unusable(session: Session, heard: bytes, pause: float = 0.01) -> tuple[float, Events]:
    """Submit a read, and receive other bytes again and again; return the time of the first events, and the events."""
    read = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    now = 0.0
    events = session.submit(read, now)
    while not events and now < 100:
        events = session.receive(heard, now)
        while session.is_behind:
            events += session.receive(b"", now)
        deadline = session.deadline
        assert deadline is not None
        now = min(now + pause, max(now, deadline))
        if deadline <= now:
            events += session.expire(now)
        session.take_output()
    return now, events


@pytest.mark.parametrize("kind", FLOODS)
def test_a_flood_of_unintelligible_lines_is_reported_within_two_seconds(kind: str) -> None:
    session, _ = opened(resumes=False)
    now, events = read_until_unusable(session, FLOODS[kind])
    assert now < 2
    (event,) = events
    assert isinstance(event, Unusable)
    assert "only lines that are no answer arrive" in str(event.error)


def test_only_the_request_with_damaged_answers_is_given_up() -> None:
    session, _ = opened(resumes=False)
    read = Request(session.codec, "R", session.codec.fields("R", 0x10), session.codec.data_digits)
    now, events = 0.0, session.submit(read, 0.0)
    while not events:
        if session.take_output():
            events = session.receive(b"r000000000000000\n", now)
        else:
            assert session.deadline is not None
            now = max(now, session.deadline)
            events = session.expire(now)
    assert isinstance(read.error, UnansweredError)
    assert not any(isinstance(event, Unusable) for event in events)


def test_noise_without_a_pending_request_ends_no_session() -> None:
    session, _ = opened(resumes=False)
    for second in range(10):
        assert not session.receive(b"a\n" * 100, float(second))
        assert not session.expire(float(second))
    assert session.is_open


def next_frames(session: Session, now: float) -> list[bytes]:
    """Let the deadline expire, and return the frames that are sent then."""
    assert session.deadline is not None
    session.expire(max(now, session.deadline))
    if session.wants_turn:
        session.take_turn(max(now, session.deadline or now))
    return session.take_output().splitlines()


@pytest.mark.parametrize("takes_turns", [False, True])
@pytest.mark.parametrize("is_answered", [False, True])
def test_a_session_query_is_sent_alone_on_a_half_duplex_line(*, is_answered: bool, takes_turns: bool) -> None:
    features = GatewayInfo().features | Feature.HALF_DUPLEX
    session, gateway = Session(None, lambda: 0), VirtualGateway(GatewayInfo(features=features))
    session.connect(0.0, 0.003, takes_turns=takes_turns)
    while not session.is_open:
        if session.wants_turn:
            session.take_turn(0.0)
        session.receive(gateway.receive(session.take_output(), 0.0), 0.0)
    session.submit(Confirmation(session.codec), 0.0)
    if takes_turns:
        session.take_turn(0.0)
    (frame,) = session.take_output().splitlines()
    question = session.codec.framing.checked(b"K")
    assert next_frames(session, 0.0) == [frame]
    assert next_frames(session, 0.0) == [question[:-1]]
    assert (session.is_owed_an_answer, session.wants_turn) == (True, False)
    if not is_answered:
        assert next_frames(session, 0.0) == [frame]
        return
    session.receive(gateway.receive(question, 1.0), 1.0)
    if takes_turns:
        assert (session.is_owed_an_answer, session.wants_turn) == (False, True)
        session.take_turn(1.0)
    assert session.take_output().splitlines() == [frame]
