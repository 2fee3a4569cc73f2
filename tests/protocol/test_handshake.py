"""The first words on a connection, by bytes and times."""

from __future__ import annotations

import pytest

from unity_link.errors import ConnectError, UnsupportedError
from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.constants import (
    CHECKED_TRIES,
    DAMAGE_PATIENCE,
    DAMAGE_PAUSE,
    ECHO_PATIENCE,
    FIRST_TRY,
    LONGEST_TRY,
    SURE,
)
from unity_link.protocol.crc import Crc
from unity_link.protocol.frames import Framing
from unity_link.protocol.handshake import ECHO, RESET_TRIES, Handshake
from unity_link.transport import udp
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying

INFO = GatewayInfo()
PLAIN = b"Q" + INFO.to_hex() + b"\r\n"
FRAMING = Framing(Crc())
CHECKED = FRAMING.checked(b"Q" + INFO.to_hex())
ASKS_PLAIN, ASKS_CHECKED = b"\nQ\r", FRAMING.checked(b"Q")
SEED = 0x1234


def asking(
    now: float = 0.0, *, again: bool = False, group: bytes | None = None, wire_time: float | None = None
) -> Handshake:
    """Return a handshake that has sent its first question."""
    handshake = Handshake(None, SEED, now, again=again, group=group, wire_time=wire_time)
    assert handshake.asks
    assert handshake.take_output() == ASKS_PLAIN
    assert handshake.take_output() == b""
    return handshake


def is_complete(handshake: Handshake) -> bool:
    return handshake.complete


def known(*, again: bool = False, group: bytes | None = None) -> Handshake:
    """Return one that knows the gateway, at time 0.02."""
    handshake = asking(again=again, group=group)
    handshake.receive(PLAIN, 0.01)
    assert handshake.take_output() == ASKS_CHECKED
    handshake.receive(CHECKED, 0.02)
    return handshake


def test_a_session_begins_when_both_answers_agree_and_the_third_has_come() -> None:
    handshake = known()
    assert (handshake.codec.info, handshake.first) == (INFO, SEED & 0xFFF)
    session = handshake.take_output()
    assert session == FRAMING.checked(b"K234")
    assert not is_complete(handshake)
    assert handshake.receive(session + b"more", 0.025) == len(session)
    assert is_complete(handshake)
    assert handshake.round_trip == pytest.approx(0.005)


def test_a_question_is_asked_again_when_nothing_answers_half_as_often_each_time() -> None:
    handshake, now, pauses = asking(), 0.0, []
    for _ in range(6):
        handshake.expire(handshake.deadline - 1e-6)
        assert handshake.take_output() == b""
        pauses.append(handshake.deadline - now)
        now = handshake.deadline
        handshake.expire(now)
        assert handshake.take_output() == ASKS_PLAIN
    assert pauses == pytest.approx([FIRST_TRY, 0.2, 0.4, 0.8, LONGEST_TRY, LONGEST_TRY])


def test_a_damaged_answer_has_the_question_asked_again_at_once_and_the_next_answer_waited_for_not_much_longer() -> None:
    handshake = asking()
    handshake.receive(b"X02@\r\n", 0.004)
    assert handshake.deadline == pytest.approx(0.004 + DAMAGE_PAUSE)
    handshake.receive(b"noise\r\n", 0.005)
    assert handshake.deadline == pytest.approx(0.004 + DAMAGE_PAUSE)
    handshake.expire(0.006)
    assert handshake.take_output() == ASKS_PLAIN
    assert handshake.deadline == pytest.approx(0.006 + DAMAGE_PATIENCE * 0.004)


def test_where_nodes_take_turns_a_damaged_answer_is_waited_out() -> None:
    handshake = asking(wire_time=0.5)
    handshake.receive(b"noise\r\n", 0.004)
    assert handshake.deadline == pytest.approx(FIRST_TRY + 0.5)
    handshake.expire(handshake.deadline)
    assert handshake.take_turn(7.0) == ASKS_PLAIN
    assert handshake.deadline == pytest.approx(7.0 + 2 * FIRST_TRY + 0.5)


def test_a_plain_answer_that_no_checked_one_confirms_is_doubted() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    for _ in range(CHECKED_TRIES):
        assert handshake.take_output() == ASKS_CHECKED
        handshake.expire(handshake.deadline)
    assert handshake.take_output() == ASKS_PLAIN
    assert "nothing" not in handshake.describe()


def test_a_checked_answer_that_says_something_else_must_be_said_twice() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    handshake.take_output()
    other = FRAMING.checked(b"Q" + GatewayInfo(groups=3).to_hex())
    handshake.receive(other, 0.02)
    assert handshake.take_output() == ASKS_CHECKED
    handshake.receive(other, 0.03)
    assert handshake.codec.info.groups == 3
    assert handshake.take_output() == FRAMING.checked(b"K234")


def test_an_impossible_answer_is_believed_when_it_was_said_often_enough_in_a_row() -> None:
    handshake = asking()
    wrong = b"Q" + INFO.to_hex().replace(b"02", b"09", 1) + b"\r\n"
    other = b"Q" + INFO.to_hex().replace(b"02", b"08", 1) + b"\r\n"
    for answer in [wrong] * (SURE - 1) + [other] + [wrong] * (SURE - 1):
        handshake.receive(answer, 0.01)
        assert handshake.take_output() == ASKS_PLAIN
    with pytest.raises(UnsupportedError, match="speaks version 09"):
        handshake.receive(wrong, 0.01)


def test_an_echo_is_believed_when_nothing_else_was_heard_for_long() -> None:
    handshake = asking()
    for now in (0.0, 0.3, ECHO_PATIENCE):
        handshake.receive(ASKS_PLAIN + b"\n", now)
        handshake.take_output()
    assert handshake.describe() == ECHO
    with pytest.raises(ConnectError, match="what is sent comes back as it is"):
        handshake.receive(ASKS_PLAIN + b"\n", ECHO_PATIENCE + 0.01)


def test_an_answer_behind_an_echo_is_an_answer() -> None:
    handshake = asking()
    for now in (0.0, 1.0, 2.0):
        handshake.receive(ASKS_PLAIN + b"\n", now)
        handshake.receive(b"Qx\r\n", now)
        handshake.take_output()
    handshake.receive(PLAIN, 3.0)
    assert handshake.take_output() == ASKS_CHECKED


def test_after_an_earlier_session_it_is_asked_whether_the_gateway_was_reset() -> None:
    handshake = known(again=True)
    assert handshake.take_output() == FRAMING.checked(b"h234")
    handshake.receive(FRAMING.checked(b"x2340A"), 0.03)
    assert handshake.found_reset
    assert handshake.take_output() == FRAMING.checked(b"K234")
    not_reset = known(again=True)
    not_reset.receive(FRAMING.checked(b"n100"), 0.03)
    assert not not_reset.found_reset


def test_who_does_not_say_whether_it_was_reset_is_asked_for_a_session_all_the_same() -> None:
    handshake = known(again=True)
    for _ in range(RESET_TRIES):
        assert handshake.take_output() == FRAMING.checked(b"h234")
        handshake.expire(handshake.deadline)
    assert handshake.take_output() == FRAMING.checked(b"K234")


def begun(answer: bytes) -> Handshake:
    """Return one that has set up a group before, and has asked for a session after an answer to its `h`."""
    handshake = known(again=True, group=b"0B")
    handshake.take_output()
    handshake.receive(FRAMING.checked(answer), 0.03)
    handshake.receive(handshake.take_output(), 0.035)
    return handshake


def test_a_gateway_that_has_a_group_of_an_earlier_session_was_not_reset_before_this_one_either() -> None:
    handshake = begun(b"n100")
    asks = handshake.take_output()
    assert asks == FRAMING.checked(b"GX0B")
    handshake.expire(handshake.deadline)
    assert handshake.take_output() == asks
    assert not is_complete(handshake)
    handshake.receive(asks, 0.04)
    assert (is_complete(handshake), handshake.found_reset) == (True, False)
    assert handshake.round_trip == pytest.approx(0.005)


def test_a_gateway_that_has_forgotten_a_group_was_reset_just_before_this_session_which_is_asked_for_again() -> None:
    handshake = begun(b"n100")
    handshake.take_output()
    handshake.receive(FRAMING.checked(b"X06"), 0.04)
    assert (is_complete(handshake), handshake.found_reset) == (False, True)
    session = handshake.take_output()
    assert session == FRAMING.checked(b"K234")
    handshake.receive(session, 0.05)
    assert is_complete(handshake)


def test_a_gateway_that_is_known_to_be_reset_is_asked_for_no_group() -> None:
    handshake = begun(b"x2340A")
    assert (is_complete(handshake), handshake.take_output()) == (True, b"")


def test_a_session_that_was_asked_for_twice_is_asked_for_once_more_behind_the_other_answers() -> None:
    handshake = known()
    session = handshake.take_output()
    handshake.expire(handshake.deadline)
    assert handshake.take_output() == session
    handshake.receive(session, 0.5)
    assert not is_complete(handshake)
    pause = handshake.deadline - 0.5
    assert pause == pytest.approx(0.5 - 0.02)
    handshake.receive(session, 0.6)
    assert not is_complete(handshake)
    handshake.expire(handshake.deadline)
    assert handshake.take_output() == session
    handshake.receive(session, 1.1)
    assert is_complete(handshake)


@pytest.mark.parametrize(
    ("heard", "words"),
    [
        (b"", "nothing arrived"),
        (b"\x00\xff", "2 bytes arrived, none of them an answer"),
        (b"HTTP/1.1 400 Bad Request\r\n", "an HTTP server answers there"),
        (b"SSH-2.0-OpenSSH\r\n", "an SSH server answers there"),
    ],
)
def test_what_was_heard_is_told(heard: bytes, words: str) -> None:
    handshake = asking()
    handshake.receive(heard, 0.01)
    assert handshake.describe().startswith(words)


def test_the_end_of_a_connection_is_told_with_the_last_line_that_was_said() -> None:
    handshake = asking()
    handshake.receive(b"go away\r\n", 0.01)
    assert handshake.describe_end(None) == 'the connection ended before the gateway answered: "go away"'
    assert "want a token?" in asking().describe_end(None)


def test_an_adapter_that_echoes_is_named_where_its_echo_and_the_answer_stand_in_one_line() -> None:
    handshake = asking()
    handshake.receive(ASKS_PLAIN + PLAIN, 0.01)
    assert handshake.take_output() == ASKS_PLAIN
    with pytest.raises(ConnectError, match=r"comes back before each answer.*RS-485"):
        handshake.receive(ASKS_PLAIN + PLAIN, 0.02)


def test_an_adapter_that_echoes_is_named_before_an_echo_can_begin_a_session() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    checked = handshake.take_output()
    handshake.receive(checked + FRAMING.checked(b"Q" + INFO.to_hex()), 0.02)
    sent = handshake.take_output()
    assert sent == checked + FRAMING.checked(b"K234")
    assert "comes back" in handshake.describe()
    with pytest.raises(ConnectError, match="comes back before each answer"):
        handshake.receive(sent, 0.03)


def test_a_question_that_came_back_once_only_is_no_echo() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    handshake.receive(handshake.take_output(), 0.02)
    handshake.receive(FRAMING.checked(b"Q" + INFO.to_hex()), 0.03)
    handshake.take_output()
    handshake.receive(FRAMING.checked(b"K234"), 0.04)
    handshake.expire(handshake.deadline)
    handshake.receive(FRAMING.checked(b"K234"), handshake.deadline)
    assert is_complete(handshake)


def test_a_line_that_loses_is_named_where_some_questions_were_answered() -> None:
    handshake = asking()
    handshake.receive(PLAIN, 0.01)
    for _ in range(2):
        handshake.expire(handshake.deadline)
    assert (
        handshake.describe() == "it answered 1 of 4 questions: what is sent or answered is lost or damaged on the way"
    )


@pytest.mark.parametrize("round_trip", [0.01, 0.3, 3.0])
def test_a_medium_that_asks_sooner_connects_however_long_answers_take(round_trip: float) -> None:
    handshake, now = Handshake(None, SEED, 0.0, again=False, longest_try=0.2), 0.0
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
def test_through_datagrams_of_which_many_are_lost_or_late_a_session_begins_within_five_seconds(seed: int) -> None:
    towards, back = (Straying[bytes](seed + place, loss=0.2, late=0.1, double=0.1, latest=500) for place in (0, 100))
    handshake, gateway = Handshake(None, SEED, 0.0, again=False, longest_try=udp.LONGEST_TRY), VirtualGateway(INFO)
    now = 0.0
    while not handshake.complete:
        assert now < 5
        if not handshake.asks:
            now = handshake.deadline
            handshake.expire(now)
        for asked in towards.carry(handshake.take_output()):
            for answer in back.carry(gateway.receive(asked, now)):
                handshake.receive(answer, now)
