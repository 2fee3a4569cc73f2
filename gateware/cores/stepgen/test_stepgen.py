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


@settings(max_examples=15, deadline=None)
@given(
    speed=st.floats(0.05, 1),
    rounds=st.integers(10, 500),
    legs=st.lists(st.tuples(st.integers(-20 * 256, 20 * 256), st.integers(1, 400)), min_size=1, max_size=3),
)
def test_the_quick_model_moves_as_the_entity_does(speed: float, rounds: int, legs: list[tuple[int, int]]) -> None:
    """To 2 steps and the way of 20 rounds while it moves, and exactly at rest."""
    generics = Settings(clock_hz=20_000)
    rate = 1 << generics.rate_bits
    fastest = round(speed * generics.fastest)
    accel = fastest * rate // 256 // rounds + 1
    axis, motion = Axis(generics), Motion()
    bound = 2 + 20 * fastest / 256 / rate

    def follow(target: int) -> float:
        axis.pass_round(Commands(position_cmd=target, maxvel=fastest, maxaccel=accel), follows=True)
        motion.go_to(target / 256, fastest / 256, accel, 1 / rate)
        return abs(axis.place / (1 << 2 * generics.rate_bits) - motion.place)

    for target, length in legs:
        assert all(follow(target) < bound for _ in range(length))
    for _ in range(40 * 256 * rate // fastest + 20 * rounds + 3000):
        follow(target)
        if axis.arrived:
            break
    assert (axis.position, motion.place, motion.speed) == (target, pytest.approx(target / 256, abs=1e-6), 0)
