"""ul_gpio equals its model, with and without debouncing."""

from __future__ import annotations

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.cores.gpio.bench_gpio"
VARIANTS = {
    "only synchronised": {"axes": 3},
    "two cycles": {"axes": 2, "clock_hz": 2_000_000, "debounce_us": 1},
    "a part of a cycle more": {"axes": 3, "clock_hz": 3_300_000, "debounce_us": 3},
    "three axes, a long time": {"axes": 3, "debounce_us": 2},
}


@pytest.mark.parametrize("generics", VARIANTS.values(), ids=VARIANTS)
@pytest.mark.parametrize("cycles", [25_000, pytest.param(250_000, marks=pytest.mark.campaign)])
def test_it_is_as_the_model_in_every_cycle(generics: dict[str, object], cycles: int) -> None:
    run_bench("ul_gpio", _BENCH, generics=generics, extra_env={"CYCLES": str(cycles)})


def test_a_debouncing_that_no_counter_holds_is_refused_when_it_is_elaborated() -> None:
    with pytest.raises(BenchError, match=r"assertion failure.*: ul_gpio: debounce_us is 2000000000: at most 2 \*\* 30"):
        run_bench("ul_gpio", _BENCH, generics={"debounce_us": 2_000_000_000})
