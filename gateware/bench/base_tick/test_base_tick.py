"""The base tick, with a clock that is a multiple of its frequency and with one that is not."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(
    ("clock_hz", "millihertz"), [(50_000_000, 1_000_000_000), (48_000_000, 1_000_000_001), (12_000_000, 44_100_000 * 9)]
)
def test_base_tick(clock_hz: int, millihertz: int) -> None:
    generics = {"clock_hz": clock_hz, "base_frequency_millihertz": millihertz}
    run_bench("ul_base_tick", "gateware.bench.base_tick.bench_base_tick", generics=generics)
