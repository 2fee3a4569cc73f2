"""The example design of the iCE40 board works as its header describes."""

from __future__ import annotations

from gateware.bench.runner import GATEWARE, run_bench


def test_ice40_hx8k() -> None:
    boards = GATEWARE / "boards"
    run_bench(
        "ice40_hx8k",
        "gateware.bench.ice40_hx8k.bench_ice40_hx8k",
        extra_sources=[boards / "board_reset.vhd", boards / "demo_slave.vhd", boards / "ice40_hx8k" / "ice40_hx8k.vhd"],
    )
