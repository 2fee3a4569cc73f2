"""The arbiter between requests and samples."""

from __future__ import annotations

from gateware.bench.runner import run_bench


def test_bus_master() -> None:
    run_bench("ul_bus_master", "gateware.bench.bus_master.bench_bus_master", generics={"timeout": 20})
