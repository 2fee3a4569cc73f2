"""The transmitter without a datalink layer."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_plain_tx() -> None:
    run_bench("ul_plain_tx", "gateware.bench.plain_tx.bench_plain_tx")
