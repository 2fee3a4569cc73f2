"""The dual-clock FIFO between clocks of equal, similar, very different and unrelated frequencies."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize("depth", [4, 64])
@pytest.mark.parametrize(
    ("in_ps", "out_ps"),
    [(20_000, 20_000), (20_000, 16_666), (16_666, 20_000), (10_000, 73_000), (73_000, 10_000)],
)
def test_fifo_async(depth: int, in_ps: int, out_ps: int) -> None:
    run_bench(
        "ul_fifo_async",
        "gateware.bench.fifo_async.bench_fifo_async",
        generics={"width": 9, "depth": depth},
        extra_env={"IN_PERIOD_PS": str(in_ps), "OUT_PERIOD_PS": str(out_ps)},
    )


def test_fifo_async_with_more_registers_in_its_crossings() -> None:
    run_bench(
        "ul_fifo_async",
        "gateware.bench.fifo_async.bench_fifo_async",
        generics={"width": 9, "depth": 16, "stages": 3},
        extra_env={"IN_PERIOD_PS": "16666", "OUT_PERIOD_PS": "10000"},
    )
