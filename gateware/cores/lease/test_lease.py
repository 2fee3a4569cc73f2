"""ul_lease equals its model, at the limits of the time to an end, with and without an e-stop."""

from __future__ import annotations

import json

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.cores.lease.bench_lease"
VARIANTS = {
    "20 cycles": {"clock_hz": 1_000_000, "most_us": 20},
    "three axes, 1000 cycles": {"axes": 3, "most_us": 20},
    "three axes, no e-stop": {"axes": 3, "clock_hz": 3_300_000, "most_us": 33, "estop_used": False},
    "the least": {"clock_hz": 1_000_000, "most_us": 3},
    "20 cycles, and 10 more": {"clock_hz": 1_000_000, "most_us": 20, "finish_us": 10},
    "three axes, one cycle more": {"axes": 3, "clock_hz": 3_300_000, "most_us": 9, "finish_us": 1, "estop_used": False},
    "20 cycles, and 100 more": {"clock_hz": 1_000_000, "most_us": 20, "finish_us": 100},
    "nearly the most": {"most_us": 21_474_836},
}


@pytest.mark.parametrize("generics", VARIANTS.values(), ids=VARIANTS)
@pytest.mark.parametrize("cycles", [20_000, pytest.param(1_000_000, marks=pytest.mark.campaign)])
def test_it_is_as_the_model_in_every_cycle(generics: dict[str, object], cycles: int) -> None:
    env = {"CYCLES": str(cycles), "GENERICS": json.dumps(generics)}
    run_bench("ul_lease", _BENCH, generics=generics, extra_env=env)


@pytest.mark.parametrize("generics", [{"clock_hz": 1_000_000, "most_us": 2}, {"most_us": 21_474_837}], ids=str)
def test_a_lease_that_nobody_could_take_or_that_never_ends_is_refused(generics: dict[str, object]) -> None:
    env = {"CYCLES": "1", "GENERICS": json.dumps(generics)}
    with pytest.raises(BenchError, match=f"most_us is {generics['most_us']}, expected a time of 3 to"):
        run_bench("ul_lease", _BENCH, generics=generics, extra_env=env)


def test_one_that_would_go_on_for_longer_than_is_counted_is_refused() -> None:
    generics: dict[str, object] = {"finish_us": 21_474_837}
    env = {"CYCLES": "1", "GENERICS": json.dumps(generics)}
    with pytest.raises(BenchError, match="finish_us is 21474837, expected a time of at most"):
        run_bench("ul_lease", _BENCH, generics=generics, extra_env=env)
