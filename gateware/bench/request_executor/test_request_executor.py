"""The executor of requests in the default configuration; the shared vectors cover the others."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_request_executor() -> None:
    run_bench("ul_request_executor", "gateware.bench.request_executor.bench_request_executor")
