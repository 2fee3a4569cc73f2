"""Faults of a bad network for datagrams, counted in datagrams."""

from __future__ import annotations

import re
from typing import Any

import pytest

from unity_link.errors import ArgumentError
from unity_link.virtual.faults import Straying


def arrivals(straying: Straying[int], count: int = 10_000) -> list[tuple[int, int]]:
    """Return the arriving datagrams' numbers, each with the number of the last datagram sent by then."""
    return [(arrived, sent) for sent in range(count) for arrived in straying.carry(sent)]


def test_each_datagram_arrives_at_once_without_faults() -> None:
    assert arrivals(Straying()) == [(number, number) for number in range(10_000)]


def test_equal_seeds_have_equal_faults_and_others_do_not() -> None:
    first, again, other = (arrivals(Straying(seed, loss=0.1, late=0.1, double=0.1)) for seed in (1, 1, 2))
    assert first == again != other


def test_lost_datagrams_never_arrive_and_all_others_arrive_once() -> None:
    arrived = [number for number, _ in arrivals(Straying(loss=0.1))]
    assert arrived == sorted(set(arrived))
    assert len(arrived) == pytest.approx(9000, rel=0.02)


def test_a_duplicated_datagram_arrives_at_once_and_again_later() -> None:
    arrived = arrivals(Straying(double=0.1, latest=50))
    at_once = [number for number, sent in arrived if number == sent]
    late = [number for number, sent in arrived if number != sent]
    assert at_once == list(range(10_000))
    assert len(set(late)) == len(late) == pytest.approx(1000, rel=0.1)


def test_a_late_datagram_arrives_after_a_limited_number_of_others() -> None:
    lateness = [sent - number for number, sent in arrivals(Straying(late=0.3, latest=1000)) if number != sent]
    assert min(lateness) == 1
    assert 900 < max(lateness) <= 1000
    for low in (1, 8, 64, 512):
        # Short and long delays are equally frequent: each of ten powers of two has about a tenth of all.
        assert sum(low <= late < 2 * low for late in lateness) > len(lateness) / 20


@pytest.mark.parametrize(
    ("chances", "message"),
    [
        ({"loss": 1.5}, "loss=1.5 is no probability"),
        ({"late": 0.6, "double": 0.6}, "loss, late, double are 1.2 together"),
    ],
)
def test_impossible_probabilities_are_refused(chances: dict[str, Any], message: str) -> None:
    with pytest.raises(ArgumentError, match=re.escape(message)):
        Straying(**chances)
