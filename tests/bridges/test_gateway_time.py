"""Instants of samples by this machine's clock: distances of the gateway's clock, without jumps and steps back."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.bridges.gateway_time import SET, TURN_ON, GatewayTime
from unity_link.link.freshness import MOST_DRIFT


class Clock:
    """The time of a gateway, with the samples from which it is estimated."""

    def __init__(self, **options: Any) -> None:
        self.set = 0.0
        """Seconds by which this machine's clock was changed."""
        self.statistics = SimpleNamespace(reconnections=0)
        link: Any = SimpleNamespace(statistics=self.statistics)
        self.time = GatewayTime(link, **options)

    def instants(self, group: int, time: Any, arrived: Any) -> list[float]:
        batch: Any = SimpleNamespace(
            time=None if time is None else np.array(time, np.float64),
            arrived=np.array(arrived, np.float64) + self.set,
            at=arrived[-1],
        )
        found: list[float] = self.time.instants(group, batch).tolist()
        return found


def test_samples_without_timestamps_have_the_instants_of_their_arrival() -> None:
    assert Clock().instants(0, None, [100.0, 101.5]) == [100.0, 101.5]


def test_samples_that_arrive_together_keep_the_gateways_distances() -> None:
    assert Clock().instants(0, [5.0, 5.25, 5.5], [1000.5, 1000.5, 1000.5]) == [1000.0, 1000.25, 1000.5]


@given(st.lists(st.tuples(st.floats(1e-3, 1.0), st.floats(0.0, 0.5)), min_size=1, max_size=50))
def test_late_arrivals_neither_turn_time_back_nor_make_it_jump(steps: list[tuple[float, float]]) -> None:
    clock = Clock()
    now, seen = 0.0, []
    for step, late in steps:
        now += step
        seen += clock.instants(0, [now], [1000.0 + now + late])
    taken = np.cumsum([step for step, _ in steps])
    assert np.all(np.diff(seen) >= np.diff(taken) * (1 - 2 * MOST_DRIFT) - 1e-9)
    assert np.all(np.diff(seen) <= np.diff(taken) * (1 + 2 * MOST_DRIFT) + 1e-9)


@given(st.lists(st.tuples(st.floats(1e-3, 1.0), st.floats(0.0, 5.0)), min_size=2, max_size=50))
def test_delayed_sample_gets_the_time_at_which_it_was_taken(steps: list[tuple[float, float]]) -> None:
    clock = Clock()
    clock.instants(0, [0.0], [1000.0])
    now = 0.0
    for step, late in steps:
        now += step
        (at,) = clock.instants(0, [now], [1000.0 + now + late])
        assert at == pytest.approx(1000.0 + now, abs=2 * MOST_DRIFT * now + 1e-6)


def test_later_samples_get_their_true_times_soon_after_a_late_first_sample() -> None:
    clock = Clock(most_slew=0.5)
    seen = clock.instants(0, [0.0], [1000.3])
    for step in range(1, 101):
        seen += clock.instants(0, [step / 100], [1000.0 + step / 100])
    assert np.all(np.diff(seen) >= 0)
    assert seen[-1] == pytest.approx(1001.0, abs=0.001)


@pytest.mark.parametrize("drift", [100e-6, -100e-6])
def test_a_quartz_that_is_off_is_followed(drift: float) -> None:
    clock = Clock()
    last = 0.0
    for second in range(0, 36_000, 10):
        (last,) = clock.instants(0, [second * (1 + drift)], [1000.0 + second])
    assert last == pytest.approx(1000.0 + 35_990, abs=0.01)


def test_groups_of_one_gateway_keep_their_distance_in_time() -> None:
    clock = Clock()
    (first,) = clock.instants(0, [5.0], [1000.0])
    (second,) = clock.instants(1, [5.0], [1000.3])
    assert abs(second - first) < 1e-9


def test_time_of_a_reset_gateway_starts_again() -> None:
    clock = Clock()
    clock.instants(0, [5.0], [1000.0])
    clock.statistics.reconnections += 1
    assert clock.instants(0, [7.0], [1008.0]) == [1008.0]


@pytest.mark.parametrize("step", [2 * SET, -2 * SET, 3600.0, -3600.0])
def test_a_clock_of_this_machine_that_was_set_is_followed(step: float) -> None:
    clock = Clock()
    clock.instants(0, [5.0], [1000.0])
    clock.set = step
    assert clock.instants(0, [6.0], [1001.0]) == [1001.0 + step]


@pytest.mark.parametrize("late", [11.0, 3600.0])
def test_samples_that_waited_for_this_program_get_their_true_times(late: float) -> None:
    clock = Clock()
    clock.instants(0, [5.0], [1000.0])
    seen = clock.instants(0, [6.0, 7.0, 8.0], [1001.0 + late] * 3)
    assert seen == pytest.approx([1001.0, 1002.0, 1003.0], abs=0.01)
    assert clock.instants(0, [5.0 + late], [1000.0 + late]) == pytest.approx([1000.0 + late], abs=late * 2 * MOST_DRIFT)


def test_time_of_a_gateway_starts_again_after_a_full_turn_of_its_clock() -> None:
    clock = Clock()
    clock.instants(0, [5.0], [1000.0])
    assert clock.instants(0, [6.0 + 2 * TURN_ON], [1001.0]) == [1001.0]
