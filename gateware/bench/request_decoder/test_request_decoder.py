"""The decoder of requests in the default configuration; the shared vectors cover the others."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_request_decoder() -> None:
    run_bench("request_decoder", "gateware.bench.request_decoder.bench_request_decoder")
