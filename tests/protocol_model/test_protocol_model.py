"""The rules of the protocol hold in every state of a small model, and each of them is necessary.

The explorations of version 03 find no fault. Those of versions 01 and 02, and of 03 without one of its rules, find the
expected faults: the exploration is able to find them.
"""

import pytest

from protocol_model import datagrams, groups, half_duplex, sessions, stream
from protocol_model.datagrams import Naming
from protocol_model.exploration import Exploration

campaign, slow = pytest.mark.campaign, pytest.mark.slow

PROTOCOL_01 = stream.Rules(needs_session=False, names_session=False)


def assert_holds(found: Exploration) -> None:
    """Assert that no fault was found, and that the exploration reached a final state."""
    assert found.fault is None, str(found)
    assert found.ends


def assert_fails(found: Exploration, fault: str, steps: int) -> None:
    """Assert that a fault was found, and that the shortest trace to it has `steps` steps."""
    assert (found.fault, len(found.trace)) == (fault, steps), str(found)


# Requests with IDs over a line that keeps the order


@pytest.mark.slow
@pytest.mark.parametrize(
    "rules",
    [
        stream.Rules(),
        stream.Rules(restarts=1, resets=0),
        stream.Rules(kinds="wsh", requests=3, resets=0),
        stream.Rules(kinds="ws", requests=3),
        stream.Rules(kinds="eqp", requests=3, resets=0),
        stream.Rules(kinds="eqp", requests=2),
        stream.Rules(damages=True, requests=3),
        stream.Rules(cancels=True, requests=3, resets=0),
        stream.Rules(cancels=True, requests=2),
        pytest.param(stream.Rules(requests=6, resets=2), marks=campaign),
        pytest.param(stream.Rules(requests=6, resets=0, in_line=4), marks=campaign),
        pytest.param(stream.Rules(restarts=1), marks=campaign),
        pytest.param(stream.Rules(restarts=2, resets=0), marks=campaign),
        pytest.param(stream.Rules(kinds="wsqeph", requests=3), marks=campaign),
        pytest.param(stream.Rules(kinds="ws", damages=True, requests=3), marks=campaign),
        pytest.param(stream.Rules(kinds="ws", cancels=True, requests=3), marks=campaign),
    ],
)
def test_requests_are_executed_once_in_order_and_reported_correctly(rules: stream.Rules) -> None:
    assert_holds(stream.explored(rules))


def test_executing_before_a_session_repeats_a_request_after_a_reset() -> None:
    assert_fails(stream.explored(PROTOCOL_01), "request 0 is executed twice", 8)


def test_executing_before_a_session_acknowledges_unexecuted_requests() -> None:
    found = stream.explored(PROTOCOL_01, "reported as executed")
    assert_fails(found, "request 2 is reported as executed, but was not", 12)


def test_a_session_without_a_number_takes_answers_of_the_one_before() -> None:
    found = stream.explored(stream.Rules(names_session=False, restarts=1))
    assert_fails(found, "the answer of request 0 is taken for that of 1", 11)


@pytest.mark.slow
def test_a_window_full_of_posted_requests_can_never_be_confirmed() -> None:
    found = stream.explored(stream.Rules(kinds="sh", leaves_room=False, resets=0))
    assert_fails(found, "there is no way to an end", 5)


def test_a_refused_retransmission_may_have_been_executed() -> None:
    found = stream.explored(stream.Rules(minds_repetitions=False))
    assert_fails(found, "a request is reported as not executed, but was executed", 10)


def test_requests_sent_before_a_refused_retransmission_may_be_executed() -> None:
    found = stream.explored(stream.Rules(minds_order=False))
    assert_fails(found, "a request is reported as not executed, but was executed", 13)


# Two hosts on one line

ALONE = sessions.Rules(requests=("www", ""), opens=(1, 0))
WITHOUT = {
    "way": ALONE._replace(way=False),
    "fate": ALONE._replace(fate=False),
    "counts": ALONE._replace(counts=False),
    "kept": ALONE._replace(kept=False),
    "spaced": ALONE._replace(spaced=False),
    "newer": ALONE._replace(newer=False),
}


@pytest.mark.slow
@pytest.mark.parametrize(
    "rules",
    [
        pytest.param(sessions.Rules(requests=("w", "w")), id="two hosts"),
        pytest.param(sessions.Rules(requests=("w", "w"), opens=(2, 1), resets=0), id="one returns"),
        pytest.param(sessions.Rules(requests=("e", "e")), id="both fail"),
        pytest.param(sessions.Rules(requests=("ph", "w"), resets=0), id="a post and its fence"),
        pytest.param(sessions.Rules(requests=("qw", "q"), resets=0), id="destructive reads"),
        pytest.param(sessions.Rules(requests=("ww", "w"), numbers=1, resets=0), id="one number for all"),
        pytest.param(sessions.Rules(requests=("w", "w"), numbers=1), id="one number for all and a reset"),
        pytest.param(
            sessions.Rules(requests=("w", "w"), numbers=2, opens=(1, 2), resets=0),
            marks=slow,
            id="a repeated number",
        ),
        pytest.param(ALONE._replace(requests=("phph", ""), line=3, resets=0), id="failed posts"),
        pytest.param(ALONE._replace(requests=("pwsh", ""), line=3, resets=0), id="posts and writes"),
        pytest.param(ALONE._replace(requests=("qwqq", ""), line=3, places=1), id="one place for words"),
        pytest.param(ALONE._replace(requests=("sh", ""), echo=True), id="an echo"),
        pytest.param(ALONE._replace(requests=("w", ""), datagrams=True, resets=0, sendings=3), id="datagrams"),
        pytest.param(sessions.Rules(requests=("ww", "w")), marks=campaign, id="two hosts, longer"),
        pytest.param(
            sessions.Rules(requests=("ww", "w"), opens=(2, 1), resets=0), marks=campaign, id="one returns, longer"
        ),
        pytest.param(sessions.Rules(requests=("ew", "e")), marks=campaign, id="both fail, longer"),
        pytest.param(sessions.Rules(requests=("ph", "w")), marks=campaign, id="a post and its fence and a reset"),
        pytest.param(sessions.Rules(requests=("qw", "q")), marks=campaign, id="destructive reads and a reset"),
        pytest.param(
            ALONE._replace(requests=("ww", ""), datagrams=True, resets=0), marks=campaign, id="datagrams, longer"
        ),
        pytest.param(
            sessions.Rules(requests=("w", "w"), datagrams=True, resets=0, sendings=3),
            marks=campaign,
            id="datagrams of two hosts",
        ),
        pytest.param(
            sessions.Rules(requests=("ww", "w"), numbers=2, opens=(1, 2), resets=0),
            marks=campaign,
            id="a repeated number, longer",
        ),
        pytest.param(
            sessions.Rules(requests=("ph", "w"), numbers=2, opens=(1, 2), resets=0),
            marks=campaign,
            id="a repeated number and posts",
        ),
        pytest.param(sessions.Rules(requests=("ww", "w"), line=3, resets=0), marks=campaign, id="a longer line"),
        pytest.param(ALONE._replace(requests=("ww", ""), datagrams=True), marks=campaign, id="datagrams and a reset"),
        pytest.param(ALONE._replace(requests=("phph", ""), line=3), marks=campaign, id="failed posts and a reset"),
    ],
)
def test_two_hosts_on_one_line_get_correct_outcomes(rules: sessions.Rules) -> None:
    assert_holds(sessions.explored(rules))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rules", "fault"),
    [
        pytest.param(sessions.PROTOCOL_02, "reported as done, but not executed", id="02, two hosts"),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("ew", ""), opens=(1, 0)),
            "reported as done, but failed",
            id="02, writes",
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("ph", ""), opens=(1, 0)),
            "a posted request is reported as done, but failed",
            id="02, posts",
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("qq", ""), opens=(1, 0)), "a word is lost", id="02, queues"
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("sh", ""), opens=(1, 0), echo=True),
            "reported as done, but not executed",
            id="02, an echo",
        ),
        pytest.param(sessions.Rules(requests=("ww", "w"), seed=False), "reported as done, but not executed", id="seed"),
        pytest.param(
            WITHOUT["way"]._replace(requests=("sh", ""), echo=True, counts=False),
            "reported as done, but not executed",
            id="way",
        ),
        pytest.param(sessions.Rules(numbers=1, refuse=False, resets=0), "reported as done", id="refuse"),
        pytest.param(
            sessions.Rules(numbers=2, opens=(1, 2), resets=0, proves=False),
            "reported as done",
            marks=slow,
            id="proves",
        ),
        pytest.param(
            sessions.Rules(requests=("w", "w"), numbers=1, proves=False), "reported as done", id="proves, reset"
        ),
        pytest.param(
            sessions.Rules(requests=("w", "www"), proof=False), "reported as not executed, but executed", id="proof"
        ),
        pytest.param(WITHOUT["fate"]._replace(requests=("ew", "")), "reported as done, but failed", id="fate"),
        pytest.param(
            WITHOUT["counts"]._replace(requests=("ph", "")),
            "a posted request is reported as done, but failed",
            id="count",
        ),
        pytest.param(WITHOUT["kept"]._replace(requests=("qq", "")), "a word is lost", id="kept"),
        pytest.param(WITHOUT["spaced"]._replace(requests=("qq", ""), places=1), "a word is lost", id="spaced"),
        pytest.param(
            WITHOUT["newer"]._replace(requests=("wwww", ""), datagrams=True, resets=0, ask=False, sendings=6),
            "executed twice",
            marks=campaign,
            id="newer",
        ),
    ],
)
def test_two_hosts_on_one_line_get_wrong_outcomes_without_a_rule(rules: sessions.Rules, fault: str) -> None:
    found = sessions.explored(rules, fault)
    assert found.fault is not None, str(found)


# Two hosts over datagrams


@pytest.mark.slow
@pytest.mark.parametrize(
    "rules",
    [
        datagrams.Rules(sessions=1, beginnings=1, datagrams=7, resets=0),
        datagrams.Rules(sessions=1, beginnings=1, datagrams=7, resets=0, counts=16, first_count=13),
        datagrams.Rules(beginnings=2, datagrams=3, requests=2),
        pytest.param(datagrams.Rules(beginnings=2, requests=3), marks=campaign),
        pytest.param(datagrams.Rules(sessions=3, datagrams=2, requests=2), marks=campaign),
        pytest.param(datagrams.Rules(sessions=1, beginnings=1, datagrams=8), marks=campaign),
    ],
)
def test_late_duplicated_and_reordered_datagrams_do_no_harm(rules: datagrams.Rules) -> None:
    assert_holds(datagrams.explored(rules))


@pytest.mark.parametrize(
    ("fault", "steps"),
    [
        ("request 0 is executed twice", 10),
        ("the answer of request 0 is taken for that of 4", 11),
        ("request 2 is reported as executed, but was not", 9),
    ],
)
def test_datagrams_without_a_header_are_taken_for_later_ones(fault: str, steps: int) -> None:
    assert_fails(datagrams.explored(datagrams.Rules(Naming.NOT_AT_ALL, datagrams=6), fault), fault, steps)


def test_a_late_opening_ends_the_session_if_hosts_choose_its_number() -> None:
    found = datagrams.explored(datagrams.Rules(Naming.BY_HOST, resets=0))
    assert_fails(found, "request 0 is executed twice", 12)


def test_a_session_number_repeats_after_a_reset_if_the_gateway_counts() -> None:
    assert_fails(datagrams.explored(datagrams.Rules(Naming.COUNTED)), "request 0 is executed twice", 12)


def test_a_host_that_begins_again_from_one_port_opens_a_session_twice() -> None:
    found = datagrams.explored(datagrams.Rules(new_ports=False))
    assert_fails(found, "the answer of request 0 is taken for that of 1", 13)


def test_a_datagram_late_by_half_of_the_counts_is_taken_for_a_new_one() -> None:
    rules = datagrams.Rules(sessions=1, datagrams=7, resets=0, counts=8, first_count=6)
    assert_fails(datagrams.explored(rules), "request 0 is executed twice", 14)


# Groups


@pytest.mark.parametrize(
    "rules",
    [
        groups.Rules(),
        groups.Rules(stops=False),
        pytest.param(groups.Rules(holders=5, buffered=4, in_line=4, resets=2), marks=campaign),
    ],
)
def test_no_sample_of_an_earlier_holder_reaches_the_next_one(rules: groups.Rules) -> None:
    assert_holds(groups.explored(rules))


@pytest.mark.parametrize(("stops", "steps"), [(True, 23), (False, 19)])
def test_samples_reach_the_next_holder_if_responses_overtake_them(*, stops: bool, steps: int) -> None:
    found = groups.explored(groups.Rules(in_order=False, stops=stops))
    assert_fails(found, "a sample for holder 0 reaches holder 1", steps)


# Half-duplex


def test_only_one_side_sends_at_a_time_on_a_half_duplex_line() -> None:
    assert_holds(half_duplex.explored(half_duplex.Rules()))


@pytest.mark.parametrize(
    ("rules", "steps"),
    [
        pytest.param(half_duplex.Rules(waits=False), 4, id="the host does not wait"),
        pytest.param(half_duplex.Rules(kinds="p"), 4, id="a posted request fails"),
        pytest.param(half_duplex.Rules(response_last=False), 6, id="a sample after the response"),
        pytest.param(half_duplex.Rules(patient=False), 5, id="an answer is given up while it may come"),
    ],
)
def test_both_sides_send_at_once_without_a_rule(rules: half_duplex.Rules, steps: int) -> None:
    assert_fails(half_duplex.explored(rules), "both send at once", steps)
