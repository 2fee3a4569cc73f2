"""ul_stepgen against its model: at slow clocks and fast ones, one axis and many."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gateware.bench.runner import BenchError, run_bench
from gateware.cores.stepgen.bench_stepgen import Axis, Commands, Settings
from unity_link.cores.stepgen import Motion

_BENCH = "gateware.cores.stepgen.bench_stepgen"
VARIANTS = {
    "one axis": {"clock_hz": 1792, "steplen_ns": 0, "stepspace_ns": 0, "dirsetup_ns": 0, "dirhold_ns": 0},
    "two axes": {"axes": 2, "clock_hz": 5000, "steplen_ns": 9_000_000, "stepspace_ns": 5_000_000, "reverse": True},
    "three axes": {"axes": 3, "clock_hz": 1_000_000, "dirsetup_ns": 400_000, "dirhold_ns": 900_000},
    "16 axes": {"axes": 16, "clock_hz": 130_000},
    "at 50 MHz": {"axes": 3, "steplen_ns": 1000, "stepspace_ns": 1500, "dirsetup_ns": 20_000, "dirhold_ns": 10_000},
}


def _run(generics: dict[str, object], cycles: int) -> None:
    env = {"CYCLES": str(cycles), "GENERICS": json.dumps(generics)}
    run_bench("ul_stepgen", _BENCH, generics=generics, extra_env=env)


@pytest.mark.parametrize(
    "name", [name if name == min(VARIANTS) else pytest.param(name, marks=pytest.mark.slow) for name in VARIANTS]
)
def test_all_outputs_are_those_of_the_model(name: str) -> None:
    _run(VARIANTS[name], 20_000 if name == "at 50 MHz" else 10_000)


@pytest.mark.campaign
@pytest.mark.parametrize("name", VARIANTS)
def test_all_outputs_are_those_of_the_model_for_200_000_cycles(name: str) -> None:
    _run(VARIANTS[name], 200_000)


def test_a_clock_that_is_too_slow_is_refused() -> None:
    says = "clock_hz is 3583: at least 1792 for each of the 2 axes was expected"
    with pytest.raises(BenchError, match=f"assertion failure.*: ul_stepgen: {says}"):
        _run({"axes": 2, "clock_hz": 3583}, 10)


ROUND = 1 << 24
"""Steps of a round of positions."""


class Pair:
    """An axis of the entity and that of the quick model, which pass each round together.

    Args:
        start: steps at which both stand.
        speed: part of the highest speed.
        rounds: in which that is reached.
    """

    def __init__(self, start: int, speed: float, rounds: int) -> None:
        generics = Settings(clock_hz=20_000)
        self._rate, self._fraction = 1 << generics.rate_bits, 2 * generics.rate_bits
        self._most = round(speed * generics.fastest)
        self._accels = [self._most * self._rate // 256 // rounds + 1] * 2
        self._wanted = self._accels[0]
        self.axis, self.motion = Axis(generics), Motion(ROUND)
        self.axis.place, self.motion.place = start << self._fraction, float(start)
        self._bound = 2 + 20 * self._most / 256 / self._rate
        self.longest = 40 * 256 * self._rate // self._most + 20 * rounds + 3000
        """Rounds in which a way of 20 steps ends."""

    def accelerate(self, factor: float) -> None:
        """Write another acceleration, unless one of both stands and the other one does not yet."""
        if (not self.axis.speed) == (not self.motion.speed):
            self._wanted = max(1, round(self._accels[0] * factor))

    def pass_round(self, mode: int, value: int, *, follows: bool = True) -> None:
        """Pass a round, and compare.

        Args:
            mode: 0 for a position, 1 for a velocity.
            value: of either, in units of the register.
            follows: whether the axis obeys.
        """
        command = Commands(value, value, mode, self._most, self._wanted)
        self.axis.pass_round(command, follows=follows)
        if not follows:
            self.motion.stop(self._wanted, 1 / self._rate)
        elif mode:
            self.motion.go_at(value / 256, self._wanted, 1 / self._rate)
        else:
            self.motion.go_to(value / 256, self._most / 256, self._wanted, 1 / self._rate)
        away = self.axis.place / (1 << self._fraction) - self.motion.place
        assert abs((away + ROUND / 2) % ROUND - ROUND / 2) < self._bound


STARTS = st.sampled_from([0, ROUND // 2 - 5, ROUND // 2 - 1, -ROUND // 2, -ROUND // 2 + 3])
FACTORS = st.sampled_from([0.2, 0.5, 1.0, 1.0, 3.0])


@settings(max_examples=15, deadline=None)
@given(
    start=STARTS,
    speed=st.floats(0.05, 1),
    rounds=st.integers(10, 300),
    legs=st.lists(st.tuples(st.integers(-20 * 256, 20 * 256), FACTORS, st.integers(1, 400)), min_size=1, max_size=4),
)
def test_quick_model_turns_and_accelerates_as_the_entity_does(
    start: int, speed: float, rounds: int, legs: list[tuple[int, float, int]]
) -> None:
    pair, target = Pair(start, speed, rounds), start * 256
    for way, factor, length in legs:
        target = (target + way + 2**31) % 2**32 - 2**31
        pair.accelerate(factor)
        for _ in range(length):
            pair.pass_round(0, target)
    for _ in range(8 * pair.longest):
        pair.pass_round(0, target)
        if pair.axis.arrived and not pair.motion.speed:
            break
    assert pair.axis.position == target
    assert pair.motion.stands_at(target / 256)


@settings(max_examples=15, deadline=None)
@given(
    start=STARTS,
    speed=st.floats(0.05, 1),
    rounds=st.integers(10, 300),
    legs=st.lists(st.tuples(st.floats(-1.2, 1.2), FACTORS, st.booleans(), st.integers(1, 400)), max_size=4),
)
def test_the_quick_model_has_velocities_and_stops_as_the_entity_does(
    start: int, speed: float, rounds: int, legs: list[tuple[float, float, bool, int]]
) -> None:
    pair = Pair(start, speed, rounds)
    most = round(speed * Settings(clock_hz=20_000).fastest)
    for part, factor, follows, length in legs:
        pair.accelerate(factor)
        value = max(-most, min(most, round(part * most)))
        for _ in range(length):
            pair.pass_round(1, value, follows=follows)


@pytest.mark.parametrize("target", [-(2**31), 2**31 - 1])
def test_to_a_place_exactly_opposite_neither_goes(target: int) -> None:
    pair = Pair(0, 1, 50)
    for _ in range(200):
        pair.pass_round(0, target)
    assert bool(pair.axis.place) == bool(pair.motion.place) == (target != -(2**31))
