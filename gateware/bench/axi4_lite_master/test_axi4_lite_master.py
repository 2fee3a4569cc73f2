"""The AXI4-Lite wrapper in both widths."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize("data_bits", [32, 64])
def test_axi4_lite_master(data_bits: int) -> None:
    module = "gateware.bench.axi4_lite_master.bench_axi4_lite_master"
    run_bench("ul_axi4_lite_master", module, generics={"data_bits": data_bits})


def test_a_whole_gateway_works_on_axi4_lite() -> None:
    run_bench(
        "unity_link",
        "gateware.bench.axi4_lite_master.bench_axi4_lite_gateway",
        generics={"physical": "fifo", "bus_standard": "axi4_lite", "bus_timeout": 64},
    )
