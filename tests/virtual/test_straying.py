"""Faults of a bad network for datagrams, counted in datagrams."""

from __future__ import annotations

import re
from typing import Any

import pytest

from unity_link.errors import ArgumentError
from unity_link.virtual.faults import Straying


def arrivals(straying: Straying[int], count: int = 10_000) -> list[tuple[int, int]]:
    """Return what arrives as numbers of datagrams, each with the number of the last that was sent by then."""
    return [(arrived, sent) for sent in range(count) for arrived in straying.carry(sent)]


def test_without_faults_each_arrives_at_once() -> None:
    assert arrivals(Straying()) == [(number, number) for number in range(10_000)]


def test_the_same_seed_does_the_same_and_another_does_not() -> None:
    first, again, other = (arrivals(Straying(seed, loss=0.1, late=0.1, double=0.1)) for seed in (1, 1, 2))
    assert first == again != other


def test_what_is_lost_never_arrives_and_all_else_does_once() -> None:
    arrived = [number for number, _ in arrivals(Straying(loss=0.1))]
    assert arrived == sorted(set(arrived))
    assert len(arrived) == pytest.approx(9000, rel=0.02)


def test_what_is_doubled_arrives_at_once_and_once_more() -> None:
    arrived = arrivals(Straying(double=0.1, latest=50))
    at_once = [number for number, sent in arrived if number == sent]
    late = [number for number, sent in arrived if number != sent]
    assert at_once == list(range(10_000))
    assert len(set(late)) == len(late) == pytest.approx(1000, rel=0.1)


def test_what_is_late_arrives_behind_one_to_the_most_others() -> None:
    lateness = [sent - number for number, sent in arrivals(Straying(late=0.3, latest=1000)) if number != sent]
    assert min(lateness) == 1
    assert 900 < max(lateness) <= 1000
    for low in (1, 8, 64, 512):
        # Near and far alike: of ten powers of two each has its tenth, and the last one nearly.
        assert sum(low <= late < 2 * low for late in lateness) > len(lateness) / 20


@pytest.mark.parametrize(
    ("chances", "message"),
    [
        ({"loss": 1.5}, "loss=1.5 is no probability"),
        ({"late": 0.6, "double": 0.6}, "loss, late, double are 1.2 together"),
    ],
)
def test_chances_that_cannot_be_are_refused(chances: dict[str, Any], message: str) -> None:
    with pytest.raises(ArgumentError, match=re.escape(message)):
        Straying(**chances)
