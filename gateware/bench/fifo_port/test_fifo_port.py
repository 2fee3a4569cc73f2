"""The FIFO port."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_fifo_port() -> None:
    run_bench("ul_fifo_port", "gateware.bench.fifo_port.bench_fifo_port")
