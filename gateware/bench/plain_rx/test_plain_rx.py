"""The receiver without a datalink layer."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_plain_rx() -> None:
    run_bench("ul_plain_rx", "gateware.bench.plain_rx.bench_plain_rx")
