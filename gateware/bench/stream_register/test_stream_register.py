"""The register stage of a stream."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_stream_register() -> None:
    run_bench("ul_stream_register", "gateware.bench.stream_register.bench_stream_register")
