"""The logic for SIWU#."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_send_immediate() -> None:
    run_bench("ul_send_immediate", "gateware.bench.send_immediate.bench_send_immediate")
