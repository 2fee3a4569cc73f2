"""Limits on the bytes that clients of a shared link have in flight."""

from __future__ import annotations

from unity_link.bridges.serve.turns import LEAST_AHEAD, LONGEST_WAIT, Pace


def carry(pace: Pace, bytes_per_second: float, seconds: float = 1.0) -> None:
    """Carry the allowed bytes over a line repeatedly; each round trip takes at least 0.1 ms."""
    now = 0.0
    while now < seconds:
        size = pace.most_ahead
        now += max(1e-4, size / bytes_per_second)
        pace.carried(size, now)


def test_quick_line_has_as_many_bytes_in_flight_as_the_longest_wait_allows() -> None:
    pace = Pace()
    carry(pace, 40e6)
    assert 0.5 * 40e6 * LONGEST_WAIT <= pace.most_ahead <= 1.5 * 40e6 * LONGEST_WAIT


def test_slow_line_has_the_fewest_bytes_in_flight() -> None:
    pace = Pace()
    carry(pace, 11_520.0, seconds=10.0)
    assert pace.most_ahead == LEAST_AHEAD


def test_line_that_becomes_slow_soon_has_fewer_bytes_in_flight() -> None:
    pace = Pace()
    carry(pace, 40e6)
    much = pace.most_ahead
    pace.carried(much, 2.0)
    pace.carried(LEAST_AHEAD, 2.1)
    assert pace.most_ahead == LEAST_AHEAD
