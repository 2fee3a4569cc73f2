"""Instants of samples by this machine's clock: distances as the gateway tells them, no jumps, no way back."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from unity_link.bridges.gateway_time import MOST_SLEW, GatewayTime


class Samples:
    """What of a batch tells the time."""

    def __init__(self, time: Any, arrived: Any) -> None:
        self.time = None if time is None else np.array(time, np.float64)
        self.arrived = np.array(arrived, np.float64)


def instants(clock: GatewayTime, group: int, time: Any, arrived: Any) -> list[float]:
    batch: Any = Samples(time, arrived)
    found: list[float] = clock.instants(group, batch).tolist()
    return found


def test_samples_without_timestamps_have_the_instants_of_their_arrival() -> None:
    assert instants(GatewayTime(), 0, None, [100.0, 101.5]) == [100.0, 101.5]


def test_samples_that_arrive_together_stand_apart_as_the_gateway_took_them() -> None:
    clock = GatewayTime()
    assert instants(clock, 0, [5.0, 5.25, 5.5], [1000.5, 1000.5, 1000.5]) == [1000.0, 1000.25, 1000.5]


@given(st.lists(st.tuples(st.floats(1e-3, 1.0), st.floats(0.0, 0.5)), min_size=1, max_size=50))
def test_late_arrivals_neither_turn_time_back_nor_make_it_jump(steps: list[tuple[float, float]]) -> None:
    clock = GatewayTime()
    now, seen = 0.0, []
    for step, late in steps:
        now += step
        seen += instants(clock, 0, [now], [1000.0 + now + late])
    taken = np.cumsum([step for step, _ in steps])
    assert np.all(np.diff(seen) >= np.diff(taken) * (1 - 2 * MOST_SLEW) - 1e-9)
    assert np.all(np.diff(seen) <= np.diff(taken) * (1 + 2 * MOST_SLEW) + 1e-9)


def test_a_quartz_that_is_off_is_followed() -> None:
    clock = GatewayTime()
    last = 0.0
    for second in range(10_000):
        (last,) = instants(clock, 0, [second * (1 + 50e-6)], [1000.0 + second])
    assert abs(last - (1000.0 + 9_999)) < 0.01


def test_groups_of_one_gateway_stay_side_by_side() -> None:
    clock = GatewayTime()
    (first,) = instants(clock, 0, [5.0], [1000.0])
    (second,) = instants(clock, 1, [5.0], [1000.3])
    assert abs(second - first) < 1e-9


def test_a_gateway_that_was_reset_begins_anew() -> None:
    clock = GatewayTime()
    instants(clock, 0, [500.0], [1000.0])
    assert instants(clock, 0, [0.5], [1001.0]) == [1001.0]
