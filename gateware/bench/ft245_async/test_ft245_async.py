"""The asynchronous FT245 layer with clock periods longer and shorter than the datasheet's intervals."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(
    "clock_hz",
    [
        12_000_000,
        25_000_000,
        pytest.param(48_000_000, marks=pytest.mark.campaign),
        50_000_000,
        pytest.param(60_000_000, marks=pytest.mark.campaign),
        100_000_000,
    ],
)
def test_ft245_async(clock_hz: int) -> None:
    run_bench("ul_ft245_async", "gateware.bench.ft245_async.bench_ft245_async", generics={"clock_hz": clock_hz})


def test_ft245_async_with_more_skew() -> None:
    run_bench(
        "ul_ft245_async",
        "gateware.bench.ft245_async.bench_ft245_async",
        generics={"clock_hz": 80_000_000, "skew_ns": 12},
        testcase=("bytes_arrive_each_once_and_in_order", "both_directions_share_the_bus"),
    )
