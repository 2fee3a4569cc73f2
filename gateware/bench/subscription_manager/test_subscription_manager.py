"""The subscription manager in the default configuration, with few groups, and in a campaign with the most."""

from __future__ import annotations

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.bench.subscription_manager.bench_subscription_manager"
_CLOCK_HZ = 50_000_000


@pytest.mark.parametrize(
    ("groups", "group_words", "data_bits", "tick"),
    [
        pytest.param(16, 32, 32, 200, id="usual"),
        # The bench of the whole gateway has the maximum of both numbers.
        pytest.param(256, 255, 13, 400, id="most", marks=pytest.mark.campaign),
        pytest.param(5, 8, 64, 125, id="few"),
    ],
)
def test_subscription_manager(groups: int, group_words: int, data_bits: int, tick: int) -> None:
    run_bench(
        "ul_subscription_manager",
        _BENCH,
        generics={
            "groups": groups,
            "group_words": group_words,
            "data_bits": data_bits,
            "base_frequency_millihertz": _CLOCK_HZ // tick * 1000,
        },
        extra_env={"TICK": str(tick)},
    )


def test_groups_that_do_not_fit_between_two_base_ticks_are_refused() -> None:
    with pytest.raises(BenchError, match="leaves less than 264 clock cycles, which 256 groups take"):
        run_bench("ul_subscription_manager", _BENCH, generics={"groups": 256, "base_frequency_millihertz": 200_000_000})
