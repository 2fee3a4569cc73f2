"""The first messages on a connection: their bytes and times."""

from __future__ import annotations

import itertools

import pytest

from unity_link.errors import ConnectError, LinkLostError, UnsupportedError
from unity_link.protocol.host.handshake import ECHO, RESET_TRIES, Handshake, SessionNumbers, State
from unity_link.protocol.window.constants import (
    CHECKED_TRIES,
    DAMAGE_PATIENCE,
    DAMAGE_PAUSE,
    ECHO_PATIENCE,
    FIRST_TRY,
    LONGEST_TRY,
    SURE,
)
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.transport import udp
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying

INFO = GatewayInfo()
PLAIN = b"Q" + INFO.to_hex() + b"\r\n"
FRAMING = Framing(Crc())
CHECKED = FRAMING.checked(b"Q" + INFO.to_hex())
ASKS_PLAIN, ASKS_CHECKED = b"\nQ\r", FRAMING.checked(b"Q")
SEED = 0x1234
ASKS_WHOSE = FRAMING.checked(b"K")
BEFORE = 0x4321


def numbers(seed: int = SEED) -> SessionNumbers:
    """Return session numbers from 1235 on; the first ID of the session is 234."""
    return SessionNumbers(itertools.count(seed).__next__)


def asks_session(place: int = 0) -> bytes:
    """Return the request that opens a session; each attempt has a number of its own."""
    return FRAMING.checked(b"K234%04X" % (0x1236 + place))


def begins(place: int = 0, ended: int = 0) -> bytes:
    """Return the gateway's answer to the same attempt."""
    return FRAMING.checked(b"K234%04X%04X" % (0x1236 + place, ended))


def asking(now: float = 0.0, *, before: int = 0, wire_time: float | None = None) -> Handshake:
    """Return a handshake that has sent its first request."""
    handshake = Handshake(None, numbers(), now, before=before, wire_time=wire_time)
    assert handshake.asks
    assert handshake.take_output() == ASKS_PLAIN
    assert handshake.take_output() == b""
    return handshake


def is_complete(handshake: Handshake) -> bool:
    return handshake.complete


def known(*, before: int = 0) -> Handshake:
    """Return a handshake that has the gateway's configuration, at time 0.02."""
    handshake = asking(before=before)
    handshake.receive(PLAIN, 0.01)
    assert handshake.take_output() == ASKS_CHECKED
    handshake.receive(CHECKED, 0.02)
    return handshake


def test_a_session_begins_after_two_equal_answers_and_the_third() -> None:
    handshake = known()
    assert (handshake.codec.info, handshake.first) == (INFO, SEED & 0xFFF)
    assert handshake.take_output() == asks_session()
    assert not is_complete(handshake)
    assert handshake.receive(begins() + b"more", 0.025) == len(begins())
    assert is_complete(handshake)
    assert handshake.session == 0x1236
    assert handshake.round_trip == pytest.approx(0.005)


def test_a_handshake_sends_one_request_in_each_of_its_states() -> None:
    handshake = asking(before=BEFORE)
    states = [handshake.state]
    for answer in (PLAIN, CHECKED, FRAMING.checked(b"K%04X" % BEFORE), begins(ended=BEFORE)):
        handshake.receive(answer, 0.01)
        states.append(handshake.state)
    # Only a session in compact form enters TRYING (see `test_trial`).
    assert states == [state for state in State if state is not State.TRYING]


def test_an_unanswered_request_is_repeated_after_twice_the_time() -> None:
    handshake, now, pauses = asking(), 0.0, []
    for _ in range(6):
        handshake.expire(handshake.deadline - 1e-6)
        assert handshake.take_output() == b""
        pauses.append(handshake.deadline - now)
        now = handshake.deadline
        handshake.expire(now)
        assert handshake.take_output() == ASKS_PLAIN
    assert pauses == pytest.approx([FIRST_TRY, 0.2, 0.4, 0.8, LONGEST_TRY, LONGEST_TRY])


def test_a_damaged_answer_shortens_the_time_to_the_next_requests() -> None:
    handshake = asking()
    handshake.receive(b"X02@\r\n", 0.004)
    assert handshake.deadline == pytest.approx(0.004 + DAMAGE_PAUSE)
    handshake.receive(b"noise\r\n", 0.005)
    assert handshake.deadline == pytest.approx(0.004 + DAMAGE_PAUSE)
    handshake.expire(0.006)
    assert handshake.take_output() == ASKS_PLAIN
    assert handshake.deadline == pytest.approx(0.006 + DAMAGE_PATIENCE * 0.004)


def test_a_damaged_answer_does_not_shorten_the_wait_if_nodes_take_turns() -> None:
    handshake = asking(wire_time=0.5)
    handshake.receive(b"noise\r\n", 0.004)
    assert handshake.deadline == pytest.approx(FIRST_TRY + 0.5)
    handshake.expire(handshake.deadline)
    assert handshake.take_turn(7.0) == ASKS_PLAIN
    assert handshake.deadline == pytest.approx(7.0 + 2 * FIRST_TRY + 0.5)


def test_a_plain_answer_without_a_valid_session_number_begins_no_session() -> None:
    handshake = Handshake(None, numbers(), 0.0, person=True)
    handshake.receive(PLAIN, 0.01)
    handshake.receive(CHECKED, 0.02)
    for number in (b"zzzz", b"0x12", b" 012", b"012"):
        handshake.receive(b"K0001235%b\r\n" % number, 0.03)
        assert not is_complete(handshake)
    handshake.receive(b"K00012350000\r\n", 0.04)
    assert is_complete(handshake)


def test_a_plain_answer_without_a_checked_one_is_requested_again() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    for _ in range(CHECKED_TRIES):
        assert handshake.take_output() == ASKS_CHECKED
        handshake.expire(handshake.deadline)
    assert handshake.take_output() == ASKS_PLAIN
    assert "nothing" not in handshake.describe()


def test_a_checked_answer_that_differs_is_accepted_the_second_time() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    handshake.take_output()
    other = FRAMING.checked(b"Q" + GatewayInfo(groups=3).to_hex())
    handshake.receive(other, 0.02)
    assert handshake.take_output() == ASKS_CHECKED
    handshake.receive(other, 0.03)
    assert handshake.describe().startswith("it answered 3 of 4 questions")
    assert handshake.codec.info.groups == 3
    assert handshake.take_output() == asks_session()


def test_an_impossible_answer_is_accepted_after_enough_repetitions() -> None:
    handshake = asking()
    wrong = b"Q" + INFO.to_hex().replace(b"03", b"09", 1) + b"\r\n"
    other = b"Q" + INFO.to_hex().replace(b"03", b"08", 1) + b"\r\n"
    for answer in [wrong] * (SURE - 1) + [other] + [wrong] * (SURE - 1):
        handshake.receive(answer, 0.01)
        assert handshake.take_output() == ASKS_PLAIN
    with pytest.raises(UnsupportedError, match="speaks version 09"):
        handshake.receive(wrong, 0.01)


def test_an_echo_is_reported_if_only_echoes_arrive_for_long() -> None:
    handshake = asking()
    for now in (0.0, 0.3, ECHO_PATIENCE):
        handshake.receive(ASKS_PLAIN + b"\n", now)
        handshake.take_output()
    assert handshake.describe() == ECHO
    with pytest.raises(ConnectError, match="what is sent comes back as it is"):
        handshake.receive(ASKS_PLAIN + b"\n", ECHO_PATIENCE + 0.01)


def test_an_expected_echo_never_ends_the_handshake() -> None:
    handshake = Handshake(None, numbers(), 0.0, compact=True, echo=True)
    for now in (0.0, 0.3, ECHO_PATIENCE + 1, 100.0):
        handshake.receive(ASKS_PLAIN + b"\n", now)
        handshake.take_output()
    assert handshake.has_echo
    assert "none of them an answer" in handshake.describe()
    handshake.receive(PLAIN, 101.0)
    assert handshake.take_output() == ASKS_CHECKED


def test_an_answer_after_echoes_is_accepted() -> None:
    handshake = asking()
    for now in (0.0, 1.0, 2.0):
        handshake.receive(ASKS_PLAIN + b"\n", now)
        handshake.receive(b"Qx\r\n", now)
        handshake.take_output()
    handshake.receive(PLAIN, 3.0)
    assert handshake.take_output() == ASKS_CHECKED


@pytest.mark.parametrize(("under_way", "was_reset"), [(0, True), (BEFORE, False)])
def test_a_reconnecting_host_asks_if_the_gateway_was_reset(under_way: int, was_reset: bool) -> None:
    handshake = known(before=BEFORE)
    assert handshake.take_output() == ASKS_WHOSE
    handshake.receive(FRAMING.checked(b"K%04X" % under_way), 0.03)
    assert handshake.found_reset == was_reset
    assert handshake.take_output() == asks_session()
    handshake.receive(begins(ended=under_way), 0.04)
    assert (is_complete(handshake), handshake.found_reset) == (True, was_reset)


def test_a_reconnecting_host_takes_no_gateway_from_another_program() -> None:
    handshake = known(before=BEFORE)
    assert handshake.take_output() == ASKS_WHOSE
    with pytest.raises(LinkLostError, match="unity-link serve"):
        handshake.receive(FRAMING.checked(b"K0077"), 0.03)


def test_a_session_that_the_host_opened_unanswered_is_its_own() -> None:
    chosen = numbers()
    lost = chosen.next(0x7FFF)
    handshake = Handshake(None, chosen, 0.0, before=BEFORE)
    handshake.receive(PLAIN, 0.01)
    handshake.receive(CHECKED, 0.02)
    handshake.receive(FRAMING.checked(b"K%04X" % lost), 0.03)
    # The gateway may have been reset before the lost opening.
    assert handshake.found_reset
    handshake.receive(FRAMING.checked(b"K%03X%04X%04X" % (handshake.first, handshake.session, lost)), 0.04)
    assert is_complete(handshake)


def test_a_gateway_that_answers_no_session_query_is_opened_all_the_same() -> None:
    handshake = known(before=BEFORE)
    for _ in range(RESET_TRIES):
        assert handshake.take_output() == ASKS_WHOSE
        handshake.expire(handshake.deadline)
    assert handshake.take_output() == asks_session()


@pytest.mark.parametrize(("ended", "was_reset"), [(BEFORE, False), (0, True), (0x0077, True)])
def test_an_opening_that_ended_another_session_reveals_a_reset(ended: int, was_reset: bool) -> None:
    handshake = known(before=BEFORE)
    handshake.take_output()
    handshake.receive(FRAMING.checked(b"K%04X" % BEFORE), 0.03)
    handshake.take_output()
    handshake.receive(begins(ended=ended), 0.04)
    assert (is_complete(handshake), handshake.found_reset) == (True, was_reset)


def test_an_opening_that_ended_an_unanswered_opening_shows_no_reset() -> None:
    handshake = known(before=BEFORE)
    handshake.take_output()
    handshake.receive(FRAMING.checked(b"K%04X" % BEFORE), 0.03)
    assert handshake.take_output() == asks_session(0)
    handshake.expire(handshake.deadline)
    assert handshake.take_output() == asks_session(1)
    handshake.receive(begins(1, ended=0x1236), 0.2)
    assert (is_complete(handshake), handshake.found_reset) == (True, False)


def test_only_the_answer_to_the_last_opening_begins_a_session() -> None:
    handshake = known()
    for place in range(2):
        assert handshake.take_output() == asks_session(place)
        handshake.expire(handshake.deadline)
    assert handshake.take_output() == asks_session(2)
    for place in range(2):
        handshake.receive(begins(place), 0.33)
        assert not is_complete(handshake)
    handshake.receive(begins(2), 0.4)
    assert is_complete(handshake)
    assert handshake.session == 0x1238


def test_a_late_answer_is_no_damage_and_lengthens_the_next_wait() -> None:
    handshake = known()
    handshake.take_output()
    handshake.expire(handshake.deadline)
    asked_at = 0.02 + FIRST_TRY
    assert handshake.take_output() == asks_session(1)
    handshake.receive(PLAIN + CHECKED, asked_at)
    assert handshake.deadline == pytest.approx(asked_at + 2 * FIRST_TRY)
    handshake.receive(begins(0), asked_at + 0.15)
    assert handshake.deadline == pytest.approx(asked_at + 2 * (FIRST_TRY + 0.15))


def test_session_numbers_are_not_0_not_recent_and_safe_from_damage() -> None:
    small = SessionNumbers(itertools.count().__next__)
    drawn = [small.next(0x7F) for _ in range(1000)]
    assert set(drawn) == {*range(1, 0x80)} - {0x10}
    stuck = SessionNumbers(lambda: 0x0FFF)
    drawn = [stuck.next(0x7FFF) for _ in range(100)]
    assert 0x1000 not in drawn
    assert all(len(set(drawn[place : place + 16])) == 16 for place in range(84))


@pytest.mark.parametrize(
    ("heard", "words"),
    [
        (b"", "nothing arrived"),
        (b"\x00\xff", "2 bytes arrived, none of them an answer"),
        (b"HTTP/1.1 400 Bad Request\r\n", "an HTTP server answers there"),
        (b"SSH-2.0-OpenSSH\r\n", "an SSH server answers there"),
    ],
)
def test_the_error_describes_the_bytes_that_arrived(heard: bytes, words: str) -> None:
    handshake = asking()
    handshake.receive(heard, 0.01)
    assert handshake.describe().startswith(words)


def test_the_error_for_a_lost_connection_quotes_the_last_line() -> None:
    handshake = asking()
    handshake.receive(b"go away\r\n", 0.01)
    assert handshake.describe_end(None) == 'the connection ended before the gateway answered: "go away"'
    assert "want a token?" in asking().describe_end(None)


def test_an_answer_in_one_line_with_an_echo_is_accepted() -> None:
    handshake = asking()
    handshake.receive(ASKS_PLAIN + PLAIN, 0.01)
    assert handshake.take_output() == ASKS_CHECKED
    assert handshake.echoes == 1


def test_an_echo_begins_no_session() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    handshake.receive(handshake.take_output() + CHECKED, 0.02)
    session = handshake.take_output()
    assert session == asks_session()
    handshake.receive(session, 0.03)
    assert not is_complete(handshake)
    assert handshake.describe() == ECHO
    handshake.receive(begins(), 0.04)
    assert is_complete(handshake)
    assert handshake.echoes == 2


def test_the_error_names_a_lossy_line_if_some_requests_were_answered() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    for _ in range(2):
        handshake.expire(handshake.deadline)
    assert handshake.describe() == (
        "it answered 1 of 4 questions: requests or answers are lost or damaged on the way, or this computer is too busy"
    )


@pytest.mark.parametrize("round_trip", [0.01, 0.3, 3.0])
def test_a_medium_that_repeats_requests_early_connects_on_a_slow_path(round_trip: float) -> None:
    handshake, now = Handshake(None, numbers(), 0.0, longest_try=0.2), 0.0
    gateway = VirtualGateway(INFO)
    arriving: list[tuple[float, bytes]] = []
    while not handshake.complete:
        arriving += [(now + round_trip, gateway.receive(handshake.take_output(), now))]
        now = min(handshake.deadline, arriving[0][0])
        assert now < 60
        if now == arriving[0][0]:
            handshake.receive(arriving.pop(0)[1], now)
        handshake.expire(now)


@pytest.mark.parametrize("seed", range(20))
def test_a_session_opens_within_5_s_over_datagrams_with_many_losses(seed: int) -> None:
    towards, back = (Straying[bytes](seed + place, loss=0.2, late=0.1, double=0.1, latest=500) for place in (0, 100))
    handshake, gateway = Handshake(None, numbers(seed), 0.0, longest_try=udp.LONGEST_TRY), VirtualGateway(INFO)
    now = 0.0
    while not handshake.complete:
        assert now < 5
        if not handshake.asks:
            now = handshake.deadline
            handshake.expire(now)
        for asked in towards.carry(handshake.take_output()):
            for answer in back.carry(gateway.receive(asked, now)):
                handshake.receive(answer, now)
