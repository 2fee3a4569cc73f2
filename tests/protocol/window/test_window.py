"""The window: each row of the table in its docstring, and the whole against a gateway that follows docs/protocol.md.

The tests pass the time to the window, so no test waits. Requests are represented by their names.
"""

from __future__ import annotations

import itertools
from collections import deque

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from support.searching import examples
from unity_link.errors import Outcome
from unity_link.protocol.window import constants as module
from unity_link.protocol.window.sequence_space import Run
from unity_link.protocol.window.window import Unanswered, Window

RING = 256
SIZE, REPLY = 8, 14


class Named(Run):
    """A run with a name and a state, so that tests can identify it."""

    __slots__ = ("name",)

    def __init__(self, name: str, count: int = 1, reply_size: int = REPLY, size: int = SIZE) -> None:
        super().__init__(count, size, reply_size)
        self.name = name

    def __repr__(self) -> str:
        return self.name

    def question(self, offset: int, count: int) -> Named:
        return Asked(self, offset, count)


class Confirming(Named):
    """A fence (``h``)."""

    __slots__ = ()
    is_fence = True


class Asked(Named):
    """Posted writes whose outcomes the host requests one by one."""

    __slots__ = ("asked",)
    is_question = True

    def __init__(self, asked: Named, offset: int, count: int) -> None:
        super().__init__(f"{asked.name}?", count)
        self.asked = asked
        self.first, self.sending = asked.first + offset & RING - 1, asked.sending + offset


def named(name: str) -> Named:
    """Return a request; a name with ``p`` first is a posted write, one with ``h`` first a fence."""
    if name.startswith("h"):
        return Confirming(name)
    return Named(name, reply_size=0 if name.startswith("p") else REPLY)


def sent(window: Window[Named], *names: str, now: float = 0.0) -> list[Named]:
    """Send requests."""
    runs = [named(name) for name in names]
    for run in runs:
        window.send(run, now)
    return runs


def repeated(window: Window[Named]) -> str:
    """Return the names of the requests that the window retransmits now; `K` comes first if it goes back."""
    if not window.retransmission.is_due():
        return ""
    sent = []
    if window.loss.place == window.retransmission.sent:
        window.retransmission.query_sent()
        sent.append("K")
    sent += [f"{run.name}@{number}" for number, run, _, count in window.repeat() for _ in range(count)]
    return " ".join(sent)


def names(parts: list[Unanswered[Named]]) -> list[tuple[str, bool]]:
    return [(part.run.name, part.outcome is Outcome.EXECUTED) for part in parts]


def test_one_request_is_alone_at_the_end_of_the_sequence_space_too() -> None:
    window: Window[Named] = Window(RING, RING - 1)
    sent(window, "a")
    assert window.has_one_request()


def test_the_window_is_not_quiet_while_retransmissions_are_due() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b", "c")
    window.damaged(1.0)
    window.answered(0, 1, 1.0)
    assert not window.has_no_loss()
    assert repeated(window) == "K b@1 c@2"
    window.query_answered(2.0)
    assert not window.has_no_loss()
    window.answered(1, 2, 2.0)
    assert window.has_no_loss()


# The rows of the table


def test_a_response_advances_the_oldest_unanswered_id() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b")
    window.answered(0, 1, now=0.001)
    assert (window.oldest, window.executed, window.next, window.in_flight) == (1, 1, 2, 1)
    assert repeated(window) == ""


def test_a_response_that_skips_a_request_retransmits_only_that_request() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b", "c")
    room = window.room(SIZE)
    window.answered(1, 1, now=0.001)
    assert repeated(window) == "a@0"
    assert names(list(window.unanswered())) == [("a", True), ("c", False)]
    assert window.room(SIZE) == room


def test_the_answer_to_a_retransmission_reveals_earlier_losses() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abcdef")
    window.answered(1, 1, now=0.001)
    assert repeated(window) == "a@0"
    sent(window, "g")
    window.answered(3, 1, now=0.002)
    assert repeated(window) == ""
    window.answered(0, 1, now=0.003)
    assert repeated(window) == "K c@2 e@4 f@5 g@6"


def test_requests_sent_after_a_retransmission_are_not_lost_by_its_answer() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abc")
    window.answered(2, 1, now=0.001)
    assert repeated(window) == "a@0 b@1"
    sent(window, "d", "e")
    window.answered(0, 1, now=0.002)
    window.answered(1, 1, now=0.002)
    assert repeated(window) == ""
    window.answered(4, 1, now=0.002)
    assert repeated(window) == "d@3"


def test_the_answer_to_a_later_request_reveals_a_lost_retransmission() -> None:
    window: Window[Named] = Window(RING, round_trip=1.0)
    sent(window, *"abc")
    window.answered(1, 1, now=0.001)
    assert repeated(window) == "a@0"
    sent(window, "d")
    window.answered(2, 1, now=0.002)
    assert repeated(window) == ""
    window.answered(3, 1, now=0.003)
    assert repeated(window) == "a@0"


def test_each_damaged_answer_retransmits_one_request_then_goes_back() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *"abcd")
    room = window.room(SIZE)
    window.answer_damaged(now=0.001)
    assert repeated(window) == "a@0"
    window.answer_damaged(now=0.002)
    window.answer_damaged(now=0.002)
    assert repeated(window) == "b@1 c@2"
    assert window.room(SIZE) == room
    window.answer_damaged(now=0.002)
    assert repeated(window) == "d@3"
    window.answer_damaged(now=0.002)
    assert repeated(window) == "K a@0 b@1 c@2 d@3"


def test_an_answer_to_a_first_transmission_reveals_no_other_loss() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *"abc")
    window.answer_damaged(now=0.001)
    assert repeated(window) == "a@0"
    window.answered(0, 1, now=0.002)
    assert repeated(window) == ""


def test_a_damaged_request_while_an_answer_is_missing_goes_back() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *"abc")
    window.answered(1, 1, now=0.001)
    assert repeated(window) == "a@0"
    window.damaged(now=0.02)
    assert repeated(window) == "K a@0 c@2"


def test_a_damaged_request_goes_back_to_all_that_may_be_unexecuted() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *"abcd")
    window.answer_damaged(now=0.001)
    window.answered(1, 1, now=0.001)
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 c@2 d@3"


def test_a_damaged_request_after_an_answered_retransmission_goes_back() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *"abcd")
    window.answered(2, 1, now=0.001)
    assert repeated(window) == "a@0 b@1"
    window.answered(1, 1, now=0.002)
    window.damaged(now=0.002)
    assert repeated(window) == "K a@0 d@3"


def test_signs_of_loss_are_ignored_until_a_later_frame_is_answered() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abcd")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 b@1 c@2 d@3"
    for sign in (window.damaged, window.answer_damaged):
        sign(now=0.002)
    window.out_of_sequence(0, now=0.002)
    assert repeated(window) == ""
    # This may be the answer to the first transmission.
    window.answered(1, 1, now=0.003)
    window.damaged(now=0.003)
    assert repeated(window) == ""
    window.query_answered(now=0.003)
    window.damaged(now=0.003)
    assert repeated(window) == "K a@0 c@2 d@3"


def test_a_sign_of_loss_after_the_answer_to_k_goes_back_again() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"ab")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 b@1"
    window.query_answered(now=0.002)
    assert repeated(window) == ""
    window.damaged(now=0.002)
    assert repeated(window) == "K a@0 b@1"


def test_the_answer_to_k_retransmits_unanswered_requests_before_it() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"ab")
    window.retransmission.query_sent()
    sent(window, *"c")
    window.query_answered(now=0.001)
    assert repeated(window) == "K a@0 b@1 c@2"


def test_an_answer_to_k_without_a_query_is_ignored() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"ab")
    window.query_answered(now=0.001)
    assert repeated(window) == ""


def test_the_next_answer_to_k_after_a_time_out_is_for_the_last_query() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"ab")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 b@1"
    assert window.deadline is not None
    window.expire(window.deadline)
    assert repeated(window) == "K a@0 b@1"
    window.query_answered(now=1.0)
    window.damaged(now=1.0)
    assert repeated(window) == "K a@0 b@1"


def test_a_gap_after_a_retransmission_is_another_loss() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abc")
    window.out_of_sequence(0, now=0.001)
    assert repeated(window) == "K a@0 b@1 c@2"
    window.out_of_sequence(1, now=0.002)
    assert repeated(window) == "K a@0 b@1 c@2"


def test_a_damaged_answer_retransmits_posted_writes_and_the_next_request() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "a", "p", "b")
    window.answer_damaged(now=0.001)
    assert repeated(window) == "p@0 p@1 a@2"


def test_a_stale_response_matches_no_request() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a")
    window.answered(0, 1, now=0.001)
    assert window.find(0) is None
    assert window.find(77) is None
    with pytest.raises(ValueError, match="no request with ID 0"):
        window.answered(0, 1, now=0.002)


def test_out_of_sequence_goes_back_and_reveals_the_executed_requests() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b", "c")
    window.out_of_sequence(1, now=0.001)
    assert names(list(window.unanswered())) == [("a", True), ("b", False), ("c", False)]
    assert repeated(window) == "K a@0 b@1 c@2"


def test_out_of_sequence_confirms_posted_writes() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "a")
    window.out_of_sequence(2, now=0.001)
    assert (window.oldest, window.executed) == (2, 2)
    assert repeated(window) == "K a@2"


@pytest.mark.parametrize(("expected", "is_possible"), [(0, False), (1, False), (2, True), (3, True), (4, False)])
def test_only_an_id_from_executed_to_next_can_be_expected(expected: int, *, is_possible: bool) -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b", "c")
    window.answered(1, 1, now=0.001)
    assert window.out_of_sequence(expected, now=0.002) == is_possible
    assert window.next == 3
    if not is_possible:
        assert (window.oldest, window.executed) == (0, 2)


def test_a_damaged_request_goes_back() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 b@1"


def test_the_window_goes_back_once_for_a_gap_until_a_new_answer() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, "a", "b", "c")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0 b@1 c@2"
    window.out_of_sequence(0, now=0.002)
    window.damaged(now=0.002)
    window.answer_damaged(now=0.002)
    assert repeated(window) == ""
    window.answered(0, 1, now=0.003)
    window.damaged(now=0.004)
    assert repeated(window) == "K b@1 c@2"


def test_repeated_signs_of_loss_about_a_request_are_left_to_the_time_out() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a")
    taken = 0
    for _ in range(2 * module.MOST_SIGNS):
        window.damaged(now=0.0)
        taken += repeated(window) == "K a@0"
        window.query_answered(now=0.0)
    assert taken == module.MOST_SIGNS


def test_many_signs_of_loss_that_arrive_together_count_once() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abcdefghijklmnopqrstuvwxyz")
    for _ in range(100):
        window.damaged(now=0.0)
    assert len(repeated(window).split()) == 1 + 26


def test_the_window_goes_back_again_after_a_time_out() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a")
    window.damaged(now=0.001)
    assert repeated(window) == "K a@0"
    assert window.deadline is not None
    window.expire(window.deadline)
    assert repeated(window) == "K a@0"


def test_a_refusal_goes_back_and_the_last_allowed_one_gives_up() -> None:
    window: Window[Named] = Window(RING)
    a, _ = sent(window, "a", "b")
    for _ in range(module.MOST_REFUSALS - 1):
        assert window.refused(now=0.0) is None
        assert repeated(window) == "K a@0 b@1"
        window.query_answered(now=0.0)
    assert window.refused(now=0.0) is a
    assert repeated(window) == "K a@0 b@1"


def test_refusals_of_different_requests_do_not_add_up() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abcdefgh")
    for number in range(8):
        assert window.refused(now=0.0) is None
        window.answered(number, 1, now=0.0)


def test_a_refusal_while_an_answer_is_missing_is_ignored() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a", "b", "c")
    window.answered(1, 1, now=0.0)
    for _ in range(10):
        assert window.refused(now=0.0) is None


def test_a_refusal_without_a_request_is_ignored() -> None:
    window: Window[Named] = Window(RING)
    assert window.refused(now=0.0) is None
    window.damaged(now=0.0)
    assert repeated(window) == ""


def test_silence_goes_back_with_a_doubled_time_out_until_the_line_is_lost() -> None:
    window: Window[Named] = Window(RING, round_trip=0.02)
    sent(window, "a")
    now, pauses = 0.0, []
    while not window.loss.lost:
        assert window.deadline is not None
        pauses.append(window.deadline - now)
        now = window.deadline
        assert window.expire(now) is None
        assert repeated(window) == "K a@0"
    assert sum(pauses[:-1]) < module.LONGEST_SILENCE <= sum(pauses)
    for first, second in itertools.pairwise(pauses):
        assert second == pytest.approx(min(2 * first, module.LONGEST_TIMEOUT))


def test_damage_alone_gives_up_a_request_then_the_line_is_lost() -> None:
    window: Window[Named] = Window(RING, round_trip=0.02)
    a, _ = sent(window, "a", "b")
    given_up, tries = [], 0
    while not window.loss.lost:
        assert window.deadline is not None
        window.loss.heard = True
        run = window.expire(window.deadline)
        tries += 1
        if run is not None:
            given_up.append(run)
        assert tries < 1000
    assert given_up == [a, a]
    assert tries == 2 * (module.MOST_TRIES + 1)


@pytest.mark.parametrize("late", [0.001, 0.02, 3.0])
def test_a_request_with_damaged_answers_is_given_up_on_a_slow_path_too(late: float) -> None:
    window: Window[Named] = Window(RING, round_trip=0.02, byte_time=0.001)
    (a,) = sent(window, "a")
    given_up, now, tries = None, 0.0, 0
    while given_up is None:
        assert tries < 1000
        arrives = now + late
        while given_up is None and window.deadline is not None and window.deadline < arrives:
            now = window.deadline
            given_up = window.expire(now)
            repeated(window)
        window.loss.heard, now = True, max(now, arrives)
        window.answer_damaged(now)
        if given_up is None:
            given_up = window.expire(now)
        tries += bool(repeated(window))
    assert given_up is a


def test_an_answer_after_a_given_up_request_resets_the_count_of_tries() -> None:
    window: Window[Named] = Window(RING, round_trip=0.02)
    sent(window, "a", "b")
    for _ in range(2):
        given_up = None
        while given_up is None:
            assert window.deadline is not None
            window.loss.heard = True
            given_up = window.expire(window.deadline)
        assert not window.loss.lost
        window.answered(given_up.first, 1, now=window.deadline or 0.0)
    assert window.in_flight == 0


def test_a_later_request_does_not_extend_the_deadline_of_an_earlier_one() -> None:
    window: Window[Named] = Window(RING, first=RING - 1, round_trip=0.01)
    sent(window, "a")
    deadline = window.deadline
    sent(window, "b", now=0.001)
    assert window.deadline == deadline


def test_a_time_out_before_the_deadline_is_ignored() -> None:
    window: Window[Named] = Window(RING)
    assert window.deadline is None
    assert window.expire(1e9) is None
    sent(window, "a", now=5.0)
    assert window.expire(5.0) is None
    assert repeated(window) == ""


def test_time_outs_of_requests_that_are_answered_later_do_not_add_up() -> None:
    window: Window[Named] = Window(RING)
    now = 0.0
    for number in range(3 * module.MOST_TRIES):
        sent(window, "a", now=now)
        deadline = window.deadline
        assert deadline is not None
        window.loss.heard = True
        assert window.expire(deadline) is None
        assert repeated(window) == f"K a@{number}"
        now = deadline + 0.001
        window.answered(number, 1, now)
        assert not window.loss.lost


def test_refusals_before_a_retransmission_can_arrive_give_up_nothing() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, "a")
    assert [window.refused(now=0.0) for _ in range(2 * module.MOST_REFUSALS)] == [None] * 2 * module.MOST_REFUSALS


def test_a_posted_write_that_is_given_up_is_no_longer_posted() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    posted, _ = sent(window, "p", "a")
    given_up, now = None, 0.0
    while given_up is None:
        given_up = window.refused(now)
        repeated(window)
        window.query_answered(now)
        now += 1.0
    assert given_up is posted
    assert not posted.posted


def test_an_answer_resets_the_count_of_tries() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    now, tries = 0.0, []
    for number in range(3):
        sent(window, "a", "b", now=now)
        given_up = None
        tries.append(0)
        while given_up is None:
            tries[-1] += 1
            window.loss.heard = True
            assert window.deadline is not None
            now = window.deadline
            given_up = window.expire(now)
            repeated(window)
        window.answered(2 * number, 1, now)
        window.answered(2 * number + 1, 1, now)
    assert tries == [module.MOST_TRIES + 1] * 3


def test_a_damaged_answer_after_a_time_out_undoes_the_backoff() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01, shortest_timeout=0.1)
    sent(window, *"abc")
    window.expire(now=0.1)
    assert repeated(window) == "K a@0 b@1 c@2"
    window.query_answered(now=0.2)
    window.answer_damaged(now=0.2)
    assert repeated(window) == "K a@0 b@1 c@2"
    window.answered(0, 1, now=0.26)
    assert window.deadline == pytest.approx(0.26 + 0.1)


@pytest.mark.parametrize("first", [0, RING - 2])
def test_a_request_answered_before_its_retransmission_is_not_retransmitted(first: int) -> None:
    window: Window[Named] = Window(RING, first=first)
    sent(window, *"abcd")
    window.out_of_sequence(first, now=0.001)
    window.answered(first, 1, now=0.002)
    window.answered(first + 1, 1, now=0.002)
    third = (first + 2) % RING
    assert repeated(window) == f"K c@{third} d@{third + 1}"


def test_the_answer_to_a_request_sent_once_undoes_the_backoff() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01, shortest_timeout=0.1)
    sent(window, "a")
    window.expire(now=0.1)
    assert repeated(window) == "K a@0"
    # Only the round trip of the first of these is measured.
    sent(window, "b", "c", now=0.15)
    window.answered(2, 1, now=0.16)
    repeated(window)
    assert window.deadline == pytest.approx(0.16 + 0.1)


@pytest.mark.parametrize("messages", range(2, 9))
def test_posted_writes_leave_space_for_their_fence_in_a_limited_fifo(messages: int) -> None:
    window: Window[Named] = Window(RING, byte_limit=messages * SIZE)
    assert (window.room(SIZE), window.room(SIZE, posted=True)) == (messages, messages - 1)


# A reset of the gateway


def never_executed(window: Window[Named], refused: int) -> str:
    """Return the names of the requests that were certainly not executed if the gateway refused one (no session)."""
    return "".join(part.run.name for part in window.unanswered(refused) if part.outcome is Outcome.NOT_EXECUTED)


def test_a_reset_gateway_has_not_executed_the_refused_and_later_requests() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abcd")
    assert never_executed(window, 1) == "bcd"


def test_requests_sent_before_a_refused_retransmission_may_be_executed() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"abc")
    window.answered(1, 1, now=0.001)
    assert repeated(window) == "a@0"
    sent(window, *"de")
    assert never_executed(window, 0) == "de"
    assert never_executed(window, 2) == "cde"


def test_a_refusal_by_a_reset_gateway_is_matched_across_the_wrap_of_ids() -> None:
    window: Window[Named] = Window(RING, first=RING - 2)
    sent(window, *"abc")
    window.answered(RING - 1, 1, now=0.001)
    assert repeated(window) == f"a@{RING - 2}"
    sent(window, *"de")
    assert never_executed(window, RING - 2) == "de"


def test_the_longest_answer_counts_bytes_in_flight_and_of_its_response() -> None:
    window: Window[Named] = Window(RING, byte_time=0.001)
    idle = window.longest_answer
    sent(window, "a")
    assert window.longest_answer == pytest.approx(idle + 0.001 * (SIZE + REPLY))


# Runs of many


def test_the_answers_to_a_run_reveal_no_loss_of_later_requests() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a")
    window.send(Named("m", count=3), 0.0)
    sent(window, "b")
    window.answered(1, 3, now=0.001)
    assert repeated(window) == "a@0"


def test_a_run_may_be_answered_in_parts() -> None:
    window: Window[Named] = Window(RING)
    run = Named("m", count=10)
    window.send(run, 0.0)
    window.answered(0, 4, now=0.001)
    assert list(window.unanswered()) == [Unanswered(run, 4, 6, Outcome.UNKNOWN)]
    window.answered(4, 6, now=0.001)
    assert window.in_flight == 0


def test_answers_to_known_and_unknown_executed_parts_empty_the_window() -> None:
    window: Window[Named] = Window(RING, byte_limit=1000)
    window.send(Named("m", count=100), 0.0)
    window.out_of_sequence(50, now=0.001)
    window.answered(0, 100, now=0.002)
    assert (window.oldest, window.executed, window.in_flight) == (100, 100, 0)
    assert window.room(SIZE) == window.send_limit.most_room(SIZE)
    assert window.deadline is None


@pytest.mark.parametrize("first", [0, 200])
def test_the_unanswered_parts_of_a_run_are_those_without_an_answer(first: int) -> None:
    window: Window[Named] = Window(RING)
    for start in range(0, first, 100):
        window.send(Named("x", count=100), 0.0)
        window.answered(start, 100, now=0.0)
    window.send(run := Named("m", count=100), 0.0)
    window.answered(first + 60 & 255, 1, now=0.0)
    behind = first + 61 & 255
    assert [*window.parts(first, first + 100 & 255)] == [(first, run, 0, 60), (behind, run, 61, 39)]
    assert [*window.parts(first, first + 30 & 255)] == [(first, run, 0, 30)]


def test_a_run_wraps_around_the_sequence_space() -> None:
    window: Window[Named] = Window(RING)
    for start in range(0, 1000, 100):
        window.send(run := Named("m", count=100), 0.0)
        assert run.first == start % RING
        window.damaged(now=0.0)
        again = [(number, offset, count) for number, _, offset, count in window.repeat()]
        assert again == [(start % RING, 0, window.send_limit.most_room(SIZE))]
        window.answered(start % RING, 100, now=0.0)
    assert window.in_flight == 0


# Room


@pytest.mark.parametrize("ring", [256, 4096])
def test_at_most_half_the_sequence_space_is_unconfirmed(ring: int) -> None:
    window: Window[Named] = Window(ring)
    assert window.room(SIZE) == ring // 2
    window.send(Named("m", count=ring // 2), 0.0)
    assert window.room(SIZE) == 0


def test_unconfirmed_bytes_stay_below_the_receive_fifo() -> None:
    window: Window[Named] = Window(RING, byte_limit=100)
    assert window.room(SIZE) == 12
    sent(window, *"abcdefghijkl")
    assert window.room(SIZE) == 0
    window.answered(0, 1, now=0.0)
    assert window.room(SIZE) == 1


def test_a_skipped_answer_frees_the_bytes_of_its_request() -> None:
    window: Window[Named] = Window(RING, byte_limit=10 * SIZE)
    sent(window, *"abcdefghij")
    window.answered(8, 1, now=0.0)
    assert window.room(SIZE) == 0
    assert repeated(window) == "a@0 b@1 c@2 d@3 e@4 f@5 g@6 h@7"
    assert window.room(SIZE) == 9


def test_a_request_longer_than_the_receive_fifo_goes_alone() -> None:
    window: Window[Named] = Window(RING, byte_limit=16)
    assert window.room(100) == 1
    sent(window, "a")
    assert window.room(100) == 0


def test_one_id_is_left_for_the_fence_of_posted_writes() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *["p"] * 126)
    assert window.room(SIZE, posted=True) == window.room(SIZE) == 1
    sent(window, "p")
    assert window.room(SIZE, posted=True) == window.room(SIZE) == 0
    sent(window, "h")
    assert window.in_flight == RING // 2


def test_losses_reduce_the_send_limit_and_answers_raise_it() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *"ABCDEFGHIJKLMNOPQRSTUVWXYZ")
    window.damaged(now=0.0)
    assert window.room(SIZE) == 0
    repeated(window)
    assert window.room(SIZE) == RING // 4 - 26
    for number in range(26):
        window.answered(number, 1, now=0.0)
    assert window.room(SIZE) == RING // 4 + 26 // module.DONE_FOR_ONE_MORE


def test_posted_writes_confirmed_by_a_fence_raise_the_send_limit() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *["p"] * 25, "h")
    window.damaged(now=0.0)
    repeated(window)
    assert window.fence_answered(25, 0, now=0.0)
    window.answered(25, 1, now=0.0)
    assert window.room(SIZE) == RING // 4 + 26 // module.DONE_FOR_ONE_MORE


def test_retransmissions_obey_the_reduced_send_limit() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    run = Named("m", count=100)
    window.send(run, 0.0)
    window.damaged(now=0.0)
    assert [part[2:] for part in window.repeat()] == [(0, 64)]
    assert list(window.repeat()) == []
    window.answered(0, 10, now=0.02)
    assert [part[2:] for part in window.repeat()] == [(64, 12)]
    assert window.room(SIZE) == 0
    window.answered(10, 54, now=0.03)
    assert [part[2:] for part in window.repeat()] == [(76, 24)]
    assert not window.retransmission.is_due()
    assert window.room(SIZE) > 0


def test_retransmissions_continue_to_a_request_with_an_answer() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, *["p"] * 30, "a", "b")
    again = ""
    for now in (0.0, 1.0, 3.0, 7.0):
        window.damaged(now)
        again = repeated(window)
        window.query_answered(now)
    assert again == " ".join(["K", *(f"p@{number}" for number in range(30)), "a@30"])


def test_most_room_follows_the_send_limit_and_the_receive_fifo() -> None:
    window: Window[Named] = Window(RING, byte_limit=100 * SIZE, round_trip=0.01)
    assert window.send_limit.most_room(SIZE) == 100
    assert window.send_limit.most_room(200 * SIZE) == 1
    sent(window, "a")
    window.damaged(now=0.0)
    assert window.send_limit.most_room(SIZE) == 64


# Posted writes


def test_posted_writes_wait_for_a_fence_and_not_for_an_answer() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", now=1.0)
    assert window.deadline == 1.0 + module.FENCE_DELAY
    assert not window.needs_fence(1.0)
    assert window.needs_fence(1.0 + module.FENCE_DELAY)
    assert window.expire(1.0 + module.FENCE_DELAY) is None
    assert repeated(window) == ""


def test_posted_writes_are_done_when_a_fence_has_counted_the_failed_ones() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "a", now=1.0)
    window.answered(2, 1, now=1.001)
    assert (window.oldest, window.in_flight) == (3, 3)
    assert not window.is_idle()
    assert window.needs_fence(1.0 + module.FENCE_DELAY)
    sent(window, "h", now=2.0)
    assert not window.needs_fence(10.0)
    assert window.fence_answered(3, 0, now=2.001)
    window.answered(3, 1, now=2.001)
    assert window.is_idle()


def test_posted_writes_are_queried_if_the_fence_counts_unreported_failures() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "p", "h")
    window.post_failed()
    window.answered(0, 1, now=0.001)
    assert not window.fence_answered(3, 2, now=0.002)
    assert repeated(window) == "p?@1 p?@2 h@3"
    window.answered(1, 1, now=0.003)
    window.post_failed()
    window.answered(2, 1, now=0.003)
    assert window.fence_answered(3, 2, now=0.003)
    window.answered(3, 1, now=0.003)
    assert window.is_idle()


def test_queried_posted_writes_are_not_queried_again_by_the_next_count() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "h", "h", "h")
    assert not window.fence_answered(2, 1, now=0.002)
    assert repeated(window) == "p?@0 p?@1 h@2"
    assert not window.fence_answered(3, 1, now=0.002)
    assert not window.fence_answered(4, 1, now=0.002)
    assert repeated(window) == ""
    window.post_failed()
    window.answered(0, 2, now=0.003)
    assert window.fence_answered(2, 1, now=0.003)
    window.answered(2, 1, now=0.003)
    assert repeated(window) == "h@3 h@4"
    for number in (3, 4):
        assert window.fence_answered(number, 1, now=0.004)
        window.answered(number, 1, now=0.004)
    assert window.is_idle()


def test_unanswered_queries_of_posted_writes_are_repeated_after_a_loss() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "h")
    assert not window.fence_answered(2, 1, now=0.002)
    assert repeated(window) == "p?@0 p?@1 h@2"
    assert not window.fence_answered(2, 1, now=0.003)
    assert repeated(window) == "p?@0 p?@1 h@2"


def test_late_errors_complete_the_queried_posted_writes() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "p", "p", "h")
    assert not window.fence_answered(2, 1, now=0.002)
    assert repeated(window) == "p?@0 p?@1 h@2"
    window.post_failed()
    window.answered(0, 1, now=0.003)
    assert window.fence_answered(2, 1, now=0.003)
    window.answered(2, 1, now=0.003)
    assert window.is_idle()


def test_many_posted_writes_do_not_wait_for_their_fence() -> None:
    window: Window[Named] = Window(RING)
    sent(window, *["p"] * 31)
    assert not window.needs_fence(0.0)
    sent(window, "p")
    assert window.needs_fence(0.0)


def test_many_posted_bytes_do_not_wait_for_their_fence() -> None:
    window: Window[Named] = Window(RING, byte_limit=8 * SIZE)
    sent(window, "p")
    assert not window.needs_fence(0.0)
    sent(window, "p")
    assert window.needs_fence(0.0)


def test_a_time_out_may_come_before_the_fence() -> None:
    window: Window[Named] = Window(RING, round_trip=0.01)
    sent(window, "a", now=0.0)
    assert window.deadline is not None
    almost = window.deadline - module.FENCE_DELAY / 2
    sent(window, "p", now=almost)
    window.expire(window.deadline)
    assert repeated(window) == "K a@0 p@1"


# Time


def test_the_time_out_follows_rfc_6298() -> None:
    window: Window[Named] = Window(RING, round_trip=0.1)
    sent(window, "a", now=0.0)
    assert window.deadline == pytest.approx(0.1 + 4 * 0.05)
    window.answered(0, 1, now=0.2)
    assert window.round_trip.smoothed == pytest.approx(0.1 * 7 / 8 + 0.2 / 8)
    sent(window, "b", now=1.0)
    assert window.deadline == pytest.approx(1.0 + 0.1125 + 4 * (0.05 * 3 / 4 + 0.1 / 4))


def test_the_round_trip_of_a_retransmitted_request_is_not_measured() -> None:
    window: Window[Named] = Window(RING, round_trip=0.1)
    sent(window, "a", now=0.0)
    window.damaged(now=0.0)
    window.answered(0, 1, now=5.0)
    assert window.round_trip.smoothed == pytest.approx(0.1)


@pytest.mark.parametrize("seconds", [0.001, 0.025, 1.0])
def test_the_shortest_time_out_is_that_of_the_medium(seconds: float) -> None:
    window: Window[Named] = Window(RING, round_trip=0.0001, shortest_timeout=seconds)
    sent(window, "a", now=0.0)
    assert window.deadline == seconds


def test_an_answer_to_a_request_that_was_sent_once_undoes_a_longer_time_out() -> None:
    window: Window[Named] = Window(RING, round_trip=0.1)
    sent(window, "a", "b")
    assert window.deadline is not None
    window.expire(window.deadline)
    repeated(window)
    sent(window, "c", now=0.3)
    window.answered(0, 1, now=0.4)
    window.answered(1, 1, now=0.4)
    assert window.deadline == pytest.approx(0.4 + 0.6)
    sent(window, "d", now=0.4)
    window.answered(2, 1, now=0.4)
    assert window.deadline == pytest.approx(0.4 + 0.3, abs=0.1)


def test_progress_after_a_sign_of_loss_undoes_a_longer_time_out() -> None:
    window: Window[Named] = Window(RING, round_trip=0.1)
    sent(window, "a", "b")
    assert window.deadline is not None
    window.expire(window.deadline)
    repeated(window)
    window.query_answered(now=0.6)
    window.damaged(now=0.6)
    repeated(window)
    window.answered(0, 1, now=0.7)
    assert window.deadline == pytest.approx(0.7 + 0.3)


def test_a_longer_time_out_stays_until_a_round_trip_is_measured() -> None:
    window: Window[Named] = Window(RING, round_trip=0.1)
    sent(window, "a", now=0.0)
    assert window.deadline is not None
    assert window.deadline == pytest.approx(0.3)
    window.loss.heard = True
    window.expire(window.deadline)
    repeated(window)
    assert window.deadline == pytest.approx(0.3 + 0.6)
    window.answered(0, 1, now=0.5)
    sent(window, "b", now=1.0)
    assert window.deadline == pytest.approx(1.6)
    window.answered(1, 1, now=1.1)
    sent(window, "c", now=2.0)
    assert window.deadline is not None
    assert window.deadline < 2.3


def test_the_time_out_includes_the_time_on_the_wire_of_a_slow_line() -> None:
    window: Window[Named] = Window(RING, byte_time=0.001, round_trip=0.1)
    sent(window, "a", now=0.0)
    assert window.deadline == pytest.approx(0.3 + 0.001 * (SIZE + REPLY))


# The whole


class Peer:
    """A gateway as docs/protocol.md describes it; the write ``pf`` fails, and an ``h`` returns the failure count."""

    def __init__(self) -> None:
        self.expected = self.failed = 0
        self.gap_told = False
        self.fates = [False] * (RING // 2)
        self.executed: list[Named] = []

    def take(self, number: int, run: Named) -> tuple[str, int] | None:
        """Return the kind of the answer and its ID, which the count of failures follows if the request is an ``h``."""
        if run.name == "K":
            return ("K", 0)
        distance = number - self.expected & RING - 1
        if 0 < distance < RING // 2:
            if self.gap_told:
                return None
            self.gap_told = True
            return ("n", self.expected)
        if distance == 0:
            assert not run.is_question
            self.expected = number + 1 & RING - 1
            self.gap_told = False
            self.executed.append(run)
            self.fates[number % (RING // 2)] = run.name == "pf"
            self.failed += run.name == "pf"
        if self.fates[number % (RING // 2)]:
            return ("x", number)
        if run.is_fence:
            return ("h", self.failed << 8 | number)
        return None if run.posted else ("answer", number)


class LossyLine(RuleBasedStateMachine):
    """Two pipes of requests and answers, from which hypothesis delivers, loses, damages or duplicates items."""

    def __init__(self) -> None:
        super().__init__()
        self.window: Window[Named] = Window(RING, byte_limit=40 * SIZE, round_trip=0.01)
        self.peer = Peer()
        self.now = 0.0
        self.towards: deque[tuple[int, Named]] = deque()
        self.back: deque[tuple[str, int]] = deque()
        self.called: list[Named] = []
        self.answered: list[Named] = []
        self.failed = 0

    def submit(self, run: Named) -> None:
        self.window.send(run, self.now)
        self.called.append(run)
        self.towards.append((run.first, run))

    def settle(self) -> None:
        window = self.window
        if window.retransmission.is_due():
            if window.loss.place == window.retransmission.sent:
                window.retransmission.query_sent()
                self.towards.append((0, Named("K")))
            self.towards.extend(
                (number + place & RING - 1, run) for number, run, _, count in window.repeat() for place in range(count)
            )
        if window.needs_fence(self.now):
            self.submit(named("h"))

    @rule(name=st.sampled_from(["r", "w", "p", "pf"]), count=st.integers(1, 60))
    def call(self, name: str, count: int) -> None:
        for _ in range(min(count, self.window.room(SIZE, posted=name.startswith("p")))):
            self.submit(named(name))
            self.settle()

    @precondition(lambda self: self.towards)
    @rule(fates=st.lists(st.sampled_from(["deliver"] * 6 + ["lose", "damage", "double"]), min_size=1, max_size=60))
    def send_requests(self, fates: list[str]) -> None:
        for fate in fates[: len(self.towards)]:
            number, run = self.towards.popleft()
            answers = [("damaged", 0)] if fate == "damage" else []
            for _ in range({"deliver": 1, "double": 2}.get(fate, 0)):
                answer = self.peer.take(number, run)
                answers += [answer] if answer else []
            self.back.extend(answers)

    @precondition(lambda self: self.back)
    @rule(fates=st.lists(st.sampled_from(["deliver"] * 6 + ["lose", "damage", "double"]), min_size=1, max_size=60))
    def bring_answers(self, fates: list[str]) -> None:
        for fate in fates[: len(self.back)]:
            kind, number = self.back.popleft()
            if fate == "damage":
                self.hear("unreadable", 0)
            for _ in range({"deliver": 1, "double": 2}.get(fate, 0)):
                self.hear(kind, number)
        self.settle()

    def hear(self, kind: str, number: int) -> None:
        self.window.loss.heard = True
        if kind == "damaged":
            self.window.damaged(self.now)
        elif kind == "unreadable":
            self.window.answer_damaged(self.now)
        elif kind == "n":
            self.window.out_of_sequence(number, self.now)
        elif kind == "K":
            self.window.query_answered(self.now)
        else:
            self.hear_of(kind, number & RING - 1, number >> 8)

    def hear_of(self, kind: str, number: int, failed: int) -> None:
        """Take an answer as the response receiver does."""
        run = self.window.find(number)
        if run is None or (kind == "answer" and run.posted):
            return
        if kind == "x":
            self.window.post_failed()
            self.failed += 1
        elif kind == "h" and run.is_fence and not self.window.fence_answered(number, failed & RING - 1, self.now):
            return
        else:
            self.answered.append(run)
        self.window.answered(number, 1, self.now)

    @rule(seconds=st.floats(0.0, 0.1))
    def wait(self, seconds: float) -> None:
        self.now += seconds
        self.window.loss.heard = True
        self.window.expire(self.now)
        self.settle()

    @invariant()
    def what_was_executed_is_a_beginning_of_what_was_called(self) -> None:
        assert self.peer.executed == self.called[: len(self.peer.executed)]

    @invariant()
    def the_host_never_believes_more_than_the_gateway_did(self) -> None:
        answered = [run for run in self.answered if not run.is_question]
        assert self.called.index(answered[-1]) < len(self.peer.executed) if answered else True
        assert self.window.in_flight <= RING // 2

    @invariant()
    def no_failed_write_is_told_as_done(self) -> None:
        assert self.failed <= self.peer.failed
        if self.window.is_idle():
            assert self.failed == self.peer.failed

    def teardown(self) -> None:
        """On a line that has become reliable, every request is executed once and answered once."""
        for _ in range(20_000):
            if self.window.is_idle():
                break
            while self.towards:
                answer = self.peer.take(*self.towards.popleft())
                self.back.extend([answer] if answer else [])
            while self.back:
                self.hear(*self.back.popleft())
            if self.window.deadline is not None:
                self.now = max(self.now, self.window.deadline)
                assert self.window.expire(self.now) is None
            self.settle()
        assert self.window.in_flight == 0
        assert self.peer.executed == self.called
        assert self.failed == self.peer.failed == sum(run.name == "pf" for run in self.called)
        answered = [id(run) for run in self.answered if not run.is_question]
        assert sorted(answered) == sorted(id(run) for run in self.called if not run.name.startswith("p"))
        assert self.window.room(SIZE) >= min(module.FEWEST_IN_FLIGHT, 40)
        assert not self.window.loss.lost


TestLossyLine = LossyLine.TestCase
TestLossyLine.settings = settings(max_examples=examples(60), stateful_step_count=60)


def test_the_line_is_lost_if_even_the_fence_for_a_request_is_refused() -> None:
    window: Window[Named] = Window(RING)
    sent(window, "a")
    given_up = []
    for now in range(1, 7):
        assert not window.loss.lost
        given_up.append(window.refused(float(now)) is not None)
        repeated(window)
        window.query_answered(float(now))
    assert given_up == [False, False, True] * 2
    assert window.loss.lost
    deadline = window.deadline
    assert deadline is not None
    window.expire(deadline)
    assert window.loss.lost
