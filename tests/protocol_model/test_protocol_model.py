"""The rules of the protocol hold in every state of a small model, and each of them is needed.

What is explored without a fault is version 03. Versions 01 and 02, and 03 without one of its rules, are the proof that
the same exploration finds what is wrong.
"""

import pytest

from protocol_model import datagrams, groups, half_duplex, sessions, stream
from protocol_model.datagrams import Naming
from protocol_model.exploration import Exploration

campaign, slow = pytest.mark.campaign, pytest.mark.slow

PROTOCOL_01 = stream.Rules(needs_session=False, names_session=False)


def assert_holds(found: Exploration) -> None:
    """Assert that nothing went wrong, and that the stories that were explored had an end."""
    assert found.fault is None, str(found)
    assert found.ends


def assert_fails(found: Exploration, fault: str, steps: int) -> None:
    """Assert that a fault was found, by a story that is as short as it can be."""
    assert (found.fault, len(found.story)) == (fault, steps), str(found)


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
def test_requests_are_executed_once_in_order_and_told_right(rules: stream.Rules) -> None:
    assert_holds(stream.explored(rules))


def test_a_gateway_that_executes_before_a_session_does_so_twice_behind_a_reset() -> None:
    assert_fails(stream.explored(PROTOCOL_01), "request 0 is executed twice", 8)


def test_a_gateway_that_executes_before_a_session_acknowledges_what_it_never_executed() -> None:
    found = stream.explored(PROTOCOL_01, "told as executed")
    assert_fails(found, "request 2 is told as executed, and was not", 12)


def test_a_session_without_a_number_in_its_frames_takes_the_answers_of_the_one_before() -> None:
    found = stream.explored(stream.Rules(names_session=False, restarts=1))
    assert_fails(found, "the answer of request 0 is taken for that of 1", 11)


@pytest.mark.slow
def test_a_window_that_posted_requests_fill_can_never_be_confirmed() -> None:
    found = stream.explored(stream.Rules(kinds="sh", leaves_room=False, resets=0))
    assert_fails(found, "there is no way to an end", 5)


def test_a_repeated_request_that_a_reset_gateway_refuses_may_have_been_executed_before() -> None:
    found = stream.explored(stream.Rules(minds_repetitions=False))
    assert_fails(found, "a request is told as not executed, and was", 10)


def test_requests_sent_before_a_refused_retransmission_may_be_executed() -> None:
    found = stream.explored(stream.Rules(minds_order=False))
    assert_fails(found, "a request is told as not executed, and was", 13)


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
        pytest.param(sessions.Rules(requests=("w", "w"), opens=(2, 1), resets=0), id="one comes back"),
        pytest.param(sessions.Rules(requests=("e", "e")), id="both fail"),
        pytest.param(sessions.Rules(requests=("ph", "w"), resets=0), id="a post and its fence"),
        pytest.param(sessions.Rules(requests=("qw", "q"), resets=0), id="destructive reads"),
        pytest.param(sessions.Rules(requests=("ww", "w"), numbers=1, resets=0), id="one number for all"),
        pytest.param(sessions.Rules(requests=("w", "w"), numbers=1), id="one number for all and a reset"),
        pytest.param(
            sessions.Rules(requests=("w", "w"), numbers=2, opens=(1, 2), resets=0),
            marks=slow,
            id="a number that comes again",
        ),
        pytest.param(ALONE._replace(requests=("phph", ""), line=3, resets=0), id="failed posts"),
        pytest.param(ALONE._replace(requests=("pwsh", ""), line=3, resets=0), id="posts and writes"),
        pytest.param(ALONE._replace(requests=("qwqq", ""), line=3, places=1), id="one place for words"),
        pytest.param(ALONE._replace(requests=("sh", ""), echo=True), id="an echo"),
        pytest.param(ALONE._replace(requests=("w", ""), datagrams=True, resets=0, sendings=3), id="datagrams"),
        pytest.param(sessions.Rules(requests=("ww", "w")), marks=campaign, id="two hosts, longer"),
        pytest.param(
            sessions.Rules(requests=("ww", "w"), opens=(2, 1), resets=0), marks=campaign, id="one comes back, longer"
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
            id="a number that comes again, longer",
        ),
        pytest.param(
            sessions.Rules(requests=("ph", "w"), numbers=2, opens=(1, 2), resets=0),
            marks=campaign,
            id="a number that comes again to posts",
        ),
        pytest.param(sessions.Rules(requests=("ww", "w"), line=3, resets=0), marks=campaign, id="a longer line"),
        pytest.param(ALONE._replace(requests=("ww", ""), datagrams=True), marks=campaign, id="datagrams and a reset"),
        pytest.param(ALONE._replace(requests=("phph", ""), line=3), marks=campaign, id="failed posts and a reset"),
    ],
)
def test_two_hosts_on_one_line_are_told_right(rules: sessions.Rules) -> None:
    assert_holds(sessions.explored(rules))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rules", "fault"),
    [
        pytest.param(sessions.PROTOCOL_02, "told as done, and not executed", id="02, two hosts"),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("ew", ""), opens=(1, 0)),
            "told as done, and failed",
            id="02, writes",
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("ph", ""), opens=(1, 0)),
            "a posted request is told as done, and failed",
            id="02, posts",
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("qq", ""), opens=(1, 0)), "a word is lost", id="02, queues"
        ),
        pytest.param(
            sessions.PROTOCOL_02._replace(requests=("sh", ""), opens=(1, 0), echo=True),
            "told as done, and not executed",
            id="02, an echo",
        ),
        pytest.param(sessions.Rules(requests=("ww", "w"), seed=False), "told as done, and not executed", id="seed"),
        pytest.param(
            WITHOUT["way"]._replace(requests=("sh", ""), echo=True, counts=False),
            "told as done, and not executed",
            id="way",
        ),
        pytest.param(sessions.Rules(numbers=1, refuse=False, resets=0), "told as done", id="refuse"),
        pytest.param(
            sessions.Rules(numbers=2, opens=(1, 2), resets=0, proves=False),
            "told as done",
            marks=slow,
            id="proves",
        ),
        pytest.param(sessions.Rules(requests=("w", "w"), numbers=1, proves=False), "told as done", id="proves, reset"),
        pytest.param(sessions.Rules(requests=("w", "www"), proof=False), "told as not executed, and was", id="proof"),
        pytest.param(WITHOUT["fate"]._replace(requests=("ew", "")), "told as done, and failed", id="fate"),
        pytest.param(
            WITHOUT["counts"]._replace(requests=("ph", "")), "a posted request is told as done, and failed", id="count"
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
def test_two_hosts_on_one_line_are_told_wrong_without(rules: sessions.Rules, fault: str) -> None:
    found = sessions.explored(rules, fault)
    assert found.fault is not None, str(found)


# The same over datagrams


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
def test_late_doubled_and_reordered_datagrams_do_no_harm(rules: datagrams.Rules) -> None:
    assert_holds(datagrams.explored(rules))


@pytest.mark.parametrize(
    ("fault", "steps"),
    [
        ("request 0 is executed twice", 10),
        ("the answer of request 0 is taken for that of 4", 11),
        ("request 2 is told as executed, and was not", 9),
    ],
)
def test_datagrams_without_session_and_count_are_taken_for_those_of_a_later_lap(fault: str, steps: int) -> None:
    assert_fails(datagrams.explored(datagrams.Rules(Naming.NOT_AT_ALL, datagrams=6), fault), fault, steps)


def test_a_late_opening_ends_the_session_where_the_host_alone_names_it() -> None:
    found = datagrams.explored(datagrams.Rules(Naming.BY_HOST, resets=0))
    assert_fails(found, "request 0 is executed twice", 12)


def test_a_session_comes_back_after_a_reset_where_the_gateway_counts_them() -> None:
    assert_fails(datagrams.explored(datagrams.Rules(Naming.COUNTED)), "request 0 is executed twice", 12)


def test_a_host_that_begins_anew_from_the_same_port_opens_the_same_session_twice() -> None:
    found = datagrams.explored(datagrams.Rules(new_ports=False))
    assert_fails(found, "the answer of request 0 is taken for that of 1", 13)


def test_a_datagram_that_is_late_by_half_of_all_counts_is_taken_for_a_new_one() -> None:
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
def test_no_sample_of_a_former_life_reaches_the_next_holder(rules: groups.Rules) -> None:
    assert_holds(groups.explored(rules))


@pytest.mark.parametrize(("stops", "steps"), [(True, 23), (False, 19)])
def test_samples_reach_the_next_holder_where_responses_may_overtake_them(*, stops: bool, steps: int) -> None:
    found = groups.explored(groups.Rules(in_order=False, stops=stops))
    assert_fails(found, "a sample for holder 0 reaches holder 1", steps)


# Half-duplex


def test_on_a_half_duplex_line_only_one_sends_at_a_time() -> None:
    assert_holds(half_duplex.explored(half_duplex.Rules()))


@pytest.mark.parametrize(
    ("rules", "steps"),
    [
        pytest.param(half_duplex.Rules(waits=False), 4, id="an answer is not waited for"),
        pytest.param(half_duplex.Rules(kinds="p"), 4, id="a posted request fails"),
        pytest.param(half_duplex.Rules(response_last=False), 6, id="a sample comes behind the response"),
        pytest.param(half_duplex.Rules(patient=False), 5, id="an answer is given up while it may come"),
    ],
)
def test_both_send_at_once_where(rules: half_duplex.Rules, steps: int) -> None:
    assert_fails(half_duplex.explored(rules), "both send at once", steps)
