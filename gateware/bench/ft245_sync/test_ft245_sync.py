"""The synchronous FT245 layer with a core clock near CLKOUT; faster and much slower ones are for the campaign."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("clk_ns", "chip"),
    [
        pytest.param(10.0, "ft232h", marks=pytest.mark.campaign),
        (16.0, "ft2232h"),
        pytest.param(20.0, "ft232h", marks=pytest.mark.campaign),
        pytest.param(40.7, "ft232h", marks=pytest.mark.campaign),
    ],
)
def test_ft245_sync(clk_ns: float, chip: str) -> None:
    run_bench(
        "ul_ft245_sync",
        "gateware.bench.ft245_sync.bench_ft245_sync",
        extra_env={"CLK_NS": str(clk_ns), "CHIP": chip},
    )


def test_ft245_sync_with_the_smallest_fifos() -> None:
    run_bench(
        "ul_ft245_sync",
        "gateware.bench.ft245_sync.bench_ft245_sync",
        generics={"rx_depth": 16, "tx_depth": 16},
        testcase=("bytes_arrive_each_once_and_in_order", "both_directions_share_the_bus"),
        extra_env={"CLK_NS": "20.0", "CHIP": "ft2232h"},
    )
