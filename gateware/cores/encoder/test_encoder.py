"""Encoders in several configurations: in quadrature and by edges, with ticks often and never, one axis and many."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench

_BENCH = "gateware.cores.encoder.bench_encoder"
_CONFIGURATIONS = {
    "two axes": ({"axes": 2, "clock_hz": 4000, "filter": 3}, 150),
    "without ticks": ({"axes": 1, "clock_hz": 1000, "filter": 1}, 0),
    "at 50 MHz": ({"axes": 3, "clock_hz": 50_000_000, "filter": 15}, 500),
    "by edges": ({"axes": 1, "clock_hz": 3000, "filter": 2, "counter": True}, 64),
}


def _run(name: str, cycles: int, *tests: str) -> None:
    generics, tick = _CONFIGURATIONS[name]
    run_bench(
        "ul_encoder",
        _BENCH,
        generics=generics,
        testcase=tests,
        extra_env={"CYCLES": str(cycles), "TICK": str(tick)},
    )


_MODEL = "all_outputs_are_those_of_the_model_in_every_cycle"


@pytest.mark.parametrize(
    ("name", "cycles"),
    [
        ("without ticks", 15_000),
        pytest.param("two axes", 100_000, marks=pytest.mark.slow),
        pytest.param("at 50 MHz", 15_000, marks=pytest.mark.slow),
        pytest.param("by edges", 15_000, marks=pytest.mark.slow),
    ],
)
def test_an_encoder_is_its_model(name: str, cycles: int) -> None:
    _run(name, cycles, _MODEL, "the_first_levels_of_the_pins_are_no_movement")


@pytest.mark.campaign
@pytest.mark.parametrize("name", _CONFIGURATIONS)
def test_an_encoder_is_its_model_for_a_million_cycles(name: str) -> None:
    _run(name, 1_000_000, _MODEL)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["two axes", "without ticks"])
def test_a_velocity_is_that_of_the_motion(name: str) -> None:
    _run(
        name,
        20_000,
        "the_velocity_is_a_mean_of_the_real_one_between_two_edges_to_a_cycle",
        "the_velocity_of_a_stopped_axis_falls_as_one_count_by_the_time_and_then_is_zero",
    )
